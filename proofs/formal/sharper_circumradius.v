(** Sharper than lem:circ.rad.distort: |R̃ − R| ≤ 3/4 (1 + 1/k) ξR/Υ², where the paper has 16 k^(3/2) ξR/Υ³. R² is the
    greatest spread of weights that add up to 1, and the spread of the weights of either circumcentre changes little. *)

Require Import Reals Lra Lia Psatz.
From Delcert Require Import vectors simplices distortion circumradius weights projections circumcentres sharper_thickness.
Open Scope R_scope.

(** What the proofs of this file and the next ones use of ξ ≤ (Υ/4)². The relative strain is s = (1 + 1/k)/2 · ξ/Υ². *)
Definition strain (k : nat) (xi t : R) : R := vertex_share k * xi / (t * t).

Lemma strain_range k xi t :
  (1 <= k)%nat -> 0 < t <= 1 -> 0 <= xi <= t / 4 * (t / 4) ->
  xi <= 1 / 16 /\ 0 <= strain k xi t <= vertex_share k / 16 /\
  2 * strain k xi t <= relative_change k xi t <= 33 / 16 * strain k xi t.
Proof.
  intros Hk Ht Hx; pose proof (vertex_share_range k Hk) as V; set (v := vertex_share k) in *.
  assert (X : xi <= 1 / 16) by nra.
  assert (T : 0 < t * t) by nra.
  assert (I : 0 <= xi / (t * t) <= 1 / 16).
  { split; [apply quotient_nonneg; lra | apply quotient_at_most; trivial; lra]. }
  assert (E : strain k xi t = v * (xi / (t * t))) by (unfold strain, v; field; lra).
  assert (F : relative_change k xi t = (2 + xi) * strain k xi t)
    by (unfold relative_change, strain; fold v; field; lra).
  rewrite F, E; split; [trivial |]; set (s := xi / (t * t)) in *; clearbody s.
  assert (0 <= v * s) by (apply Rmult_le_pos; lra).
  repeat split; nra.
Qed.

(** Both directions, squared: (1 − a) R² ≤ R̃² and (1 − 2a) R̃² ≤ (1 − a) R², a the relative change. *)
Lemma squared_circumradius_from_below m n k p q d t xi c r x u :
  (1 <= k)%nat -> 0 < d -> 0 < t -> 0 <= xi ->
  edges_at_most m k p d -> is_thick m k p d t -> edges_differ_at_most m n k p q (xi * d) ->
  is_circumcentre m k p c r -> circumscribes n k q x u ->
  (1 - relative_change k xi t) * (r * r) <= u * u.
Proof.
  intros Hk Hd Ht Hx He Hthick Hdiffer Hc Hq; pose proof (dimension_positive k Hk).
  assert (A : 0 < INR k * t * d) by (repeat apply Rmult_lt_0_compat; lra).
  pose proof (spread_under_distortion m n k p q c d t xi r Hk Hd Ht Hx He Hdiffer
                (weights_of_the_circumcentre m k p c r _ Hk A Hc Hthick)) as S.
  pose proof (spread_at_most_squared_radius n k q x u c (proj1 Hc) Hq) as U.
  rewrite (spread_at_the_circumcentre m k p c r Hc) in S.
  unfold Rabs in S; destruct Rcase_abs; lra.
Qed.

Lemma squared_circumradius_from_above m n k p q d t xi x r c u :
  (1 <= k)%nat -> 0 < d -> 0 < t -> 0 <= xi ->
  edges_at_most m k p d -> is_thick m k p d t -> edges_differ_at_most m n k p q (xi * d) ->
  relative_change k xi t < 1 -> circumscribes m k p x r -> is_circumcentre n k q c u ->
  (1 - 2 * relative_change k xi t) * (u * u) <= (1 - relative_change k xi t) * (r * r).
Proof.
  intros Hk Hd Ht Hx He Hthick Hdiffer Ha Hp Hc; pose proof (dimension_positive k Hk).
  pose proof (thickness_under_small_distortion m n k p q d t xi Hk Hd Ht Hx He Hthick Hdiffer ltac:(lra)) as Q.
  set (a := relative_change k xi t) in *.
  assert (R0 : 0 < sqrt (1 - a)) by (apply sqrt_lt_R0; lra).
  assert (RR : sqrt (1 - a) * sqrt (1 - a) = 1 - a) by (apply sqrt_sqrt; lra).
  assert (A : 0 < INR k * (sqrt (1 - a) * t) * d) by (repeat apply Rmult_lt_0_compat; lra).
  assert (G : forall i, (i <= k)%nat -> Rabs (c i) <= u / sqrt (1 - a) / (INR k * t * d)).
  { intros i Hi; eapply Rle_trans; [now apply (weights_of_the_circumcentre n k q c u _ Hk A Hc Q) |].
    right; field; lra. }
  pose proof (spread_under_distortion m n k p q c d t xi _ Hk Hd Ht Hx He Hdiffer G) as S; fold a in S.
  pose proof (spread_at_most_squared_radius m k p x r c (proj1 Hc) Hp) as U.
  rewrite (spread_at_the_circumcentre n k q c u Hc) in S.
  replace (u / sqrt (1 - a) * (u / sqrt (1 - a))) with (u * u / (1 - a)) in S by (rewrite <- RR at 1; field; lra).
  assert (B : u * u - r * r <= a * (u * u / (1 - a))) by (unfold Rabs in S; destruct Rcase_abs; lra).
  apply Rmult_le_compat_l with (r := 1 - a) in B; [|lra].
  replace ((1 - a) * (a * (u * u / (1 - a)))) with (a * (u * u)) in B by (field; lra); lra.
Qed.

(** What is left is about numbers. *)
Lemma root_from_below a s : 0 <= s <= 1 / 16 -> a <= 33 / 16 * s -> (1 - 3 / 2 * s) * (1 - 3 / 2 * s) <= 1 - a.
Proof. intros; nra. Qed.

Lemma root_from_above a s :
  0 <= s <= 1 / 16 -> 0 <= a <= 33 / 16 * s -> 1 - a <= (1 - 2 * a) * ((1 + 3 / 2 * s) * (1 + 3 / 2 * s)).
Proof.
  intros Hs Ha.
  assert (1 - 33 / 16 * s <= (1 - 33 / 8 * s) * ((1 + 3 / 2 * s) * (1 + 3 / 2 * s))).
  { replace ((1 - 33 / 8 * s) * ((1 + 3 / 2 * s) * (1 + 3 / 2 * s)))
      with (1 - 33 / 16 * s + s * (15 / 16 - 81 / 8 * s - 297 / 32 * (s * s))) by field.
    assert (0 <= s * (15 / 16 - 81 / 8 * s - 297 / 32 * (s * s))) by (apply Rmult_le_pos; nra); lra. }
  assert (0 <= (33 / 16 * s - a) * (2 * ((1 + 3 / 2 * s) * (1 + 3 / 2 * s)) - 1)) by (apply Rmult_le_pos; nra).
  nra.
Qed.

(** Sharper lem:circ.rad.distort. The simplex q has a circumradius, and |R̃ − R| ≤ 3/2 · (1 + 1/k)/2 · ξR/Υ². *)
Theorem circumradius_under_small_distortion m n k p q d t xi r :
  (1 <= k)%nat -> 0 < d -> 0 < t -> 0 <= xi <= t / 4 * (t / 4) ->
  edges_at_most m k p d -> is_thick m k p d t -> edges_differ_at_most m n k p q (xi * d) -> is_circumradius m k p r ->
  (exists u, is_circumradius n k q u) /\
  forall u, is_circumradius n k q u -> Rabs (u - r) <= 3 / 2 * vertex_share k * r * xi / (t * t).
Proof.
  intros Hk Hd Ht Hx He Hthick Hdiffer (c & Hc).
  pose proof (thickness_at_most_one m k p d t Hk Hd He Hthick) as T.
  destruct (strain_range k xi t Hk (conj Ht T) Hx) as (_ & Hs & Ha).
  pose proof (vertex_share_range k Hk) as V.
  pose proof (relative_change_nonneg k xi t Hk (proj1 Hx) Ht) as A0.
  assert (x0 : 0 <= xi) by lra.
  split.
  - assert (P : 0 < sqrt (1 - relative_change k xi t) * t).
    { apply Rmult_lt_0_compat; trivial; apply sqrt_lt_R0; lra. }
    destruct (circumcentre_exists n k q) as (e & u & He'); [|now exists u, e].
    apply (thick_simplices_are_independent n k q d (sqrt (1 - relative_change k xi t) * t)); trivial.
    apply (thickness_under_small_distortion m n k p q d t xi); trivial; lra.
  - intros u (e & Hu).
    pose proof (squared_circumradius_from_below m n k p q d t xi c r _ u Hk Hd Ht x0 He Hthick Hdiffer Hc (proj2 Hu))
      as L.
    pose proof (squared_circumradius_from_above m n k p q d t xi _ r e u Hk Hd Ht x0 He Hthick Hdiffer ltac:(lra)
                  (proj2 Hc) Hu) as U.
    pose proof (circumscribed_radius_nonneg m k p _ r (proj2 Hc)) as r0.
    pose proof (circumscribed_radius_nonneg n k q _ u (proj2 Hu)) as u0.
    replace (3 / 2 * vertex_share k * r * xi / (t * t)) with (3 / 2 * strain k xi t * r)
      by (unfold strain; field; lra).
    set (s := strain k xi t) in *; set (a := relative_change k xi t) in *; clearbody s a.
    assert (s1 : 0 <= s <= 1 / 16) by lra.
    assert (F : (1 - 3 / 2 * s) * r <= u).
    { apply le_of_squares; trivial.
      pose proof (root_from_below a s s1 ltac:(lra)).
      apply Rle_trans with ((1 - a) * (r * r)); trivial.
      replace ((1 - 3 / 2 * s) * r * ((1 - 3 / 2 * s) * r)) with ((1 - 3 / 2 * s) * (1 - 3 / 2 * s) * (r * r)) by ring.
      apply Rmult_le_compat_r; nra. }
    assert (G : u <= (1 + 3 / 2 * s) * r).
    { apply le_of_squares; [apply Rmult_le_pos; lra |].
      pose proof (root_from_above a s s1 ltac:(lra)).
      apply Rmult_le_reg_l with (1 - 2 * a); [lra |].
      apply Rle_trans with ((1 - a) * (r * r)); trivial.
      replace ((1 - 2 * a) * ((1 + 3 / 2 * s) * r * ((1 + 3 / 2 * s) * r)))
        with ((1 - 2 * a) * ((1 + 3 / 2 * s) * (1 + 3 / 2 * s)) * (r * r)) by ring.
      apply Rmult_le_compat_r; nra. }
    apply Rabs_le; lra.
Qed.
