(** Sharper than lem:circ.ball.distort: the bounds 13/12 (1 + 1/k) ξr²/(ΥΔ) and (2 + 13/12 (1 + 1/k)) ξr²/(ΥΔ), where the
    paper has 3√k and 5√k. Of the map only the distances between the centre and the vertices are used. *)

Require Import Reals Lra Lia Psatz.
From Delcert Require Import vectors simplices distortion weights projections circumcentres sharper_thickness
  sharper_circumradius.
Open Scope R_scope.

(** y lies as far from the vertices of q as the centre of a ball of radius r from those of p, to the factor 1 ± ξ. *)
Definition nearly_at_distance (n k : nat) (q : simplex) (y : vector) (r xi : R) : Prop :=
  forall i, (i <= k)%nat -> Rabs (distance n (q i) y - r) <= xi * r.

Lemma squares_nearly_at_distance n k q y r xi :
  0 <= r -> 0 <= xi <= 1 -> nearly_at_distance n k q y r xi -> forall i, (i <= k)%nat ->
  Rabs (distance n (q i) y * distance n (q i) y - (1 + xi * xi) * (r * r)) <= 2 * xi * (r * r).
Proof.
  intros Hr Hx H i Hi; specialize (H i Hi).
  pose proof (norm_nonneg n (minus (q i) y)) as N; fold (distance n (q i) y) in N.
  set (b := distance n (q i) y) in *; clearbody b.
  assert (B : - (xi * r) <= b - r <= xi * r) by (unfold Rabs in H; destruct Rcase_abs; lra).
  assert (b * b <= (1 + xi) * r * ((1 + xi) * r)) by (apply Rmult_le_compat; lra).
  assert ((1 - xi) * r * ((1 - xi) * r) <= b * b).
  { apply Rmult_le_compat; try lra; apply Rmult_le_pos; lra. }
  apply Rabs_le; nra.
Qed.

(** Every edge of a thick simplex is at least as long as an altitude. *)
Lemma edges_of_thick_simplices m k p d t x r :
  (1 <= k)%nat -> 0 <= t * d -> is_thick m k p d t -> circumscribes m k p x r -> t * d <= 2 * r.
Proof.
  intros Hk Htd H Hp; pose proof (dimension_positive k Hk).
  assert (E : INR k * t * d <= distance m (p O) (combination k (unit_at 1) p)).
  { apply H; [lia | reflexivity | apply sum_of_unit; lia]. }
  replace (distance m (p O) (combination k (unit_at 1) p)) with (distance m (p O) (p 1%nat)) in E.
  - pose proof (distance_triangle m (p O) x (p 1%nat)) as T.
    rewrite (distance_sym m x (p 1%nat)), (Hp O), (Hp 1%nat) in T by lia; nra.
  - apply norm_ext; intros a _; unfold minus, combination.
    now rewrite (sum_unit_at (S k) 1 (fun j => p j a)) by lia.
Qed.

(** √(1 − a) ≥ 12/13 for the relative change a that ξ ≤ (Υ/4)² allows. *)
Lemma root_at_least a : a <= 33 / 256 -> 12 / 13 <= sqrt (1 - a).
Proof.
  intros H; rewrite <- (sqrt_square (12 / 13)) by lra; apply sqrt_le_1_alt; lra.
Qed.

(** Sharper lem:circ.ball.distort; that there is a circumscribing ball of q is a conclusion. *)
Theorem ball_under_small_distortion m n k p q d t xi x y r :
  (1 <= k)%nat -> 0 < d -> 0 < t -> 0 <= xi <= t / 4 * (t / 4) ->
  edges_at_most m k p d -> is_thick m k p d t -> edges_differ_at_most m n k p q (xi * d) ->
  circumscribes m k p x r -> nearly_at_distance n k q y r xi ->
  exists z u, circumscribes n k q z u /\
    distance n y z <= 13 / 6 * vertex_share k * (r * r) * xi / (t * d) /\
    Rabs (u - r) <= (2 + 13 / 6 * vertex_share k) * (r * r) * xi / (t * d).
Proof.
  intros Hk Hd Ht Hx He Hthick Hdiffer Hp Hy.
  pose proof (thickness_at_most_one m k p d t Hk Hd He Hthick) as T.
  pose proof (dimension_positive k Hk) as K; pose proof (vertex_share_range k Hk) as V.
  destruct (strain_range k xi t Hk (conj Ht T) Hx) as (X & Hs & Ha).
  pose proof (root_at_least (relative_change k xi t) ltac:(lra)) as P.
  pose proof (thickness_under_small_distortion m n k p q d t xi Hk Hd Ht (proj1 Hx) He Hthick Hdiffer ltac:(lra)) as Q.
  set (root := sqrt (1 - relative_change k xi t)) in *; clearbody root.
  pose proof (circumscribed_radius_nonneg m k p x r Hp) as r0.
  assert (A : 0 < INR k * (root * t) * d) by (repeat apply Rmult_lt_0_compat; lra).
  assert (TD : 0 < t * d) by (now apply Rmult_lt_0_compat).
  assert (E : 0 <= 2 * xi * (r * r)) by (apply Rmult_le_pos; [lra | nra]).
  assert (I : independent n k q).
  { apply (thick_simplices_are_independent n k q d (root * t)); trivial; apply Rmult_lt_0_compat; lra. }
  destruct (ball_near_a_point n k q y ((1 + xi * xi) * (r * r)) (2 * xi * (r * r)) (INR k * (root * t) * d) Hk A E I Q
              (squares_nearly_at_distance n k q y r xi r0 ltac:(lra) Hy)) as (z & u & Hz & D).
  assert (C : distance n y z <= 13 / 6 * vertex_share k * (r * r) * xi / (t * d)).
  { eapply Rle_trans; [exact D |].
    replace ((INR k + 1) * (2 * xi * (r * r)) / (2 * (INR k * (root * t) * d)))
      with (/ root * (2 * vertex_share k * (r * r) * xi / (t * d))) by (unfold vertex_share; field; lra).
    replace (13 / 6 * vertex_share k * (r * r) * xi / (t * d))
      with (13 / 12 * (2 * vertex_share k * (r * r) * xi / (t * d))) by (field; lra).
    apply Rmult_le_compat_r.
    - apply quotient_nonneg; trivial.
      apply Rmult_le_pos; [apply Rmult_le_pos; [lra | apply Rle_0_sqr] | lra].
    - replace (13 / 12) with (/ (12 / 13)) by field; apply Rinv_le_contravar; lra. }
  exists z, u; repeat split; trivial.
  assert (B : xi * r <= 2 * (r * r) * xi / (t * d)).
  { pose proof (edges_of_thick_simplices m k p d t x r Hk ltac:(lra) Hthick Hp) as L.
    apply at_most_quotient; trivial.
    replace (2 * (r * r) * xi) with (xi * r * (2 * r)) by ring.
    apply Rmult_le_compat_l; trivial; apply Rmult_le_pos; lra. }
  replace ((2 + 13 / 6 * vertex_share k) * (r * r) * xi / (t * d))
    with (2 * (r * r) * xi / (t * d) + 13 / 6 * vertex_share k * (r * r) * xi / (t * d)) by (field; lra).
  pose proof (Hy O ltac:(lia)) as Y; rewrite <- (Hz O) by lia.
  pose proof (distance_triangle n (q O) y z); pose proof (distance_triangle n (q O) z y).
  rewrite (distance_sym n z y) in *.
  unfold Rabs in Y |- *; repeat destruct Rcase_abs; lra.
Qed.
