(** Sharper than lem:bound.cc: |φ(C) − C̃|² ≤ 9/4 (1 + 1/k) ξR²/Υ², where the paper has 42 k² ξR²/Υ³. *)

Require Import Reals Lra Lia Psatz.
From Delcert Require Import vectors simplices distortion circumradius weights projections circumcentres
  sharper_thickness sharper_circumradius sharper_balls.
Open Scope R_scope.

Lemma root_of_the_quotient a : 0 <= a <= 33 / 256 -> 1 <= (1 - 2 * a) * ((1 + 5 / 4 * a) * (1 + 5 / 4 * a)).
Proof. intros; nra. Qed.

Lemma sum_of_the_changes v xi s a :
  1 / 2 <= v <= 1 -> 0 <= xi <= 1 / 16 -> v * xi <= s -> 0 <= a -> a <= 33 / 16 * s -> a <= 33 / 256 * v ->
  xi * xi + a + 2 * s * (1 + 5 / 4 * a) <= 9 / 2 * s.
Proof.
  intros Hv Hx Hs Ha Ha' Ha''.
  assert (S : 0 <= s) by nra.
  apply Rmult_le_reg_l with v; [lra |].
  assert (v * (xi * xi) <= s / 16) by nra.
  assert (v * a <= v * (33 / 16 * s)) by (apply Rmult_le_compat_l; lra).
  assert (v * (s * a) <= v * (s * (33 / 256 * v))) by (apply Rmult_le_compat_l; [lra | apply Rmult_le_compat_l; lra]).
  assert (0 <= s * (7 / 16 * v - 1 / 16 - 165 / 512 * (v * v))) by (apply Rmult_le_pos; nra).
  nra.
Qed.

(** Sharper lem:bound.cc. y stands for φ(C); it is used by its distances from the vertices only. *)
Theorem circumcentre_under_small_distortion m n k p q d t xi c r y e u :
  (1 <= k)%nat -> 0 < d -> 0 < t -> 0 <= xi <= t / 4 * (t / 4) ->
  edges_at_most m k p d -> is_thick m k p d t -> edges_differ_at_most m n k p q (xi * d) ->
  is_circumcentre m k p c r -> nearly_at_distance n k q y r xi -> is_circumcentre n k q e u ->
  distance n (combination k e q) y * distance n (combination k e q) y
  <= 9 / 2 * vertex_share k * xi / (t * t) * (r * r).
Proof.
  intros Hk Hd Ht Hx He Hthick Hdiffer Hc Hy Hu.
  pose proof (thickness_at_most_one m k p d t Hk Hd He Hthick) as T.
  pose proof (dimension_positive k Hk) as K; pose proof (vertex_share_range k Hk) as V.
  destruct (strain_range k xi t Hk (conj Ht T) Hx) as (X & Hs & Ha).
  pose proof (relative_change_nonneg k xi t Hk (proj1 Hx) Ht) as A0.
  pose proof (circumscribed_radius_nonneg m k p _ r (proj2 Hc)) as r0.
  pose proof (circumscribed_radius_nonneg n k q _ u (proj2 Hu)) as u0.
  pose proof (squared_circumradius_from_below m n k p q d t xi c r _ u Hk Hd Ht (proj1 Hx) He Hthick Hdiffer Hc
                (proj2 Hu)) as L.
  pose proof (squared_circumradius_from_above m n k p q d t xi _ r e u Hk Hd Ht (proj1 Hx) He Hthick Hdiffer
                ltac:(lra) (proj2 Hc) Hu) as U.
  pose proof (crude_circumradius_bound m k p d t r Hk Hd Ht He Hthick (ex_intro _ c Hc)) as B0.
  pose proof (thickness_under_small_distortion m n k p q d t xi Hk Hd Ht (proj1 Hx) He Hthick Hdiffer ltac:(lra)) as Q.
  pose proof (root_at_least (relative_change k xi t) ltac:(lra)) as P.
  assert (RR : sqrt (1 - relative_change k xi t) * sqrt (1 - relative_change k xi t) = 1 - relative_change k xi t)
    by (apply sqrt_sqrt; lra).
  assert (S' : vertex_share k * xi <= strain k xi t).
  { unfold strain; apply at_most_quotient; [nra |].
    assert (0 <= vertex_share k * xi) by (apply Rmult_le_pos; lra).
    rewrite <- (Rmult_1_r (vertex_share k * xi)) at 2; apply Rmult_le_compat_l; nra. }
  assert (VX : 0 <= vertex_share k * xi) by (apply Rmult_le_pos; lra).
  replace (9 / 2 * vertex_share k * xi / (t * t)) with (9 / 2 * strain k xi t) by (unfold strain; field; lra).
  pose proof (sum_of_the_changes (vertex_share k) xi (strain k xi t) (relative_change k xi t) V ltac:(lra) S' A0
                ltac:(lra) ltac:(lra)) as N.
  pose proof (root_of_the_quotient (relative_change k xi t) ltac:(lra)) as N'.
  set (a := relative_change k xi t) in *; set (root := sqrt (1 - a)) in *.
  (* the radius of q over the root *)
  assert (G : u / root <= (1 + 5 / 4 * a) * r).
  { apply le_of_squares; [apply Rmult_le_pos; lra |].
    replace (u / root * (u / root)) with (u * u / (1 - a)) by (rewrite <- RR; field; lra).
    apply quotient_at_most; [lra |].
    apply Rmult_le_reg_l with (1 - 2 * a); [lra |]; eapply Rle_trans; [exact U |].
    replace ((1 - 2 * a) * ((1 + 5 / 4 * a) * r * ((1 + 5 / 4 * a) * r) * (1 - a)))
      with ((1 - 2 * a) * ((1 + 5 / 4 * a) * (1 + 5 / 4 * a)) * ((1 - a) * (r * r))) by ring.
    rewrite <- (Rmult_1_l ((1 - a) * (r * r))) at 1; apply Rmult_le_compat_r; trivial.
    apply Rmult_le_pos; nra. }
  assert (A : 0 < INR k * (root * t) * d) by (repeat apply Rmult_lt_0_compat; lra).
  pose proof (weighted_sum_near k e (fun i => distance n (q i) y * distance n (q i) y) ((1 + xi * xi) * (r * r))
                (u / (INR k * (root * t) * d)) (2 * xi * (r * r))
                (weights_of_the_circumcentre n k q e u _ Hk A Hu Q)
                (squares_nearly_at_distance n k q y r xi r0 ltac:(lra) Hy)) as W.
  cbv beta in W; rewrite (lagrange n k e q y (proj1 Hu)), (proj1 Hu), (spread_at_the_circumcentre n k q e u Hu) in W.
  set (D := distance n (combination k e q) y * distance n (combination k e q) y) in *; clearbody D.
  assert (B : (INR k + 1) * (u / (INR k * (root * t) * d) * (2 * xi * (r * r)))
              <= 2 * strain k xi t * (1 + 5 / 4 * a) * (r * r)).
  { replace ((INR k + 1) * (u / (INR k * (root * t) * d) * (2 * xi * (r * r))))
      with (4 * (vertex_share k * xi) * r / (t * d) * (u / root * r)) by (unfold vertex_share; field; lra).
    apply Rle_trans with (4 * (vertex_share k * xi) * r / (t * d) * ((1 + 5 / 4 * a) * r * r)).
    - apply Rmult_le_compat_l; [|now apply Rmult_le_compat_r].
      apply quotient_nonneg; [apply Rmult_le_pos; lra | now apply Rmult_lt_0_compat].
    - replace (4 * (vertex_share k * xi) * r / (t * d) * ((1 + 5 / 4 * a) * r * r))
        with (r * (4 * (vertex_share k * xi) / (t * d) * ((1 + 5 / 4 * a) * (r * r)))) by (field; lra).
      replace (2 * strain k xi t * (1 + 5 / 4 * a) * (r * r))
        with (d / (2 * t) * (4 * (vertex_share k * xi) / (t * d) * ((1 + 5 / 4 * a) * (r * r))))
        by (unfold strain; field; lra).
      apply Rmult_le_compat_r; trivial.
      apply Rmult_le_pos; [|apply Rmult_le_pos; [lra | apply Rle_0_sqr]].
      apply quotient_nonneg; [lra | now apply Rmult_lt_0_compat]. }
  assert (F : D <= (xi * xi + a + 2 * strain k xi t * (1 + 5 / 4 * a)) * (r * r)).
  { unfold Rabs in W; destruct Rcase_abs; lra. }
  eapply Rle_trans; [exact F |]; apply Rmult_le_compat_r; [nra | trivial].
Qed.
