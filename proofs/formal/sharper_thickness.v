(** Sharper than lem:intrinsic.thick.distortion: every altitude, of every vertex, shrinks by √(1 − η²) at most, and no
    factor 1/√k is lost. For weights x that add up to 0, |Σ x_i p_i|² is linear in the squares of the edges; the way in
    which it changes is compared with itself, so no norm of a matrix occurs. *)

Require Import Reals Lra Lia Psatz.
From Delcert Require Import vectors simplices distortion weights.
Open Scope R_scope.

(** (1 + 1/k)/2: 1 for an edge, towards 1/2 for many vertices. *)
Definition vertex_share (k : nat) : R := (INR k + 1) / (2 * INR k).

(** By which part of itself |Σ x_i p_i|² changes at most: (1 + 1/k)/2 · (2 + ξ) ξ/Υ². *)
Definition relative_change (k : nat) (xi t : R) : R := vertex_share k * ((2 + xi) * xi) / (t * t).

Lemma dimension_positive k : (1 <= k)%nat -> 1 <= INR k.
Proof. intros H; change 1 with (INR 1); now apply le_INR. Qed.

Lemma vertex_share_range k : (1 <= k)%nat -> 1 / 2 <= vertex_share k <= 1.
Proof.
  intros H; apply dimension_positive in H; unfold vertex_share; split.
  - apply at_most_quotient; lra.
  - apply quotient_at_most; lra.
Qed.

Lemma relative_change_nonneg k xi t : (1 <= k)%nat -> 0 <= xi -> 0 < t -> 0 <= relative_change k xi t.
Proof.
  intros Hk Hx Ht; pose proof (vertex_share_range k Hk); unfold relative_change.
  apply quotient_nonneg; [apply Rmult_le_pos; [lra | nra] | nra].
Qed.

(** How the squares of the edges change. *)
Lemma squared_edges_under_distortion m n k p q d xi i j :
  0 <= xi -> edges_at_most m k p d -> edges_differ_at_most m n k p q (xi * d) -> (i <= k)%nat -> (j <= k)%nat ->
  Rabs (distance n (q i) (q j) * distance n (q i) (q j) - distance m (p i) (p j) * distance m (p i) (p j))
  <= (2 + xi) * xi * (d * d).
Proof.
  intros Hx He Hd Hi Hj; apply difference_of_squares; trivial; try apply norm_nonneg; [|now apply Hd].
  split; [apply norm_nonneg | now apply He].
Qed.

(** The spread of weights of which none is greater than l/(kΥΔ) changes by at most the relative change of l². *)
Lemma spread_under_distortion m n k p q c d t xi l :
  (1 <= k)%nat -> 0 < d -> 0 < t -> 0 <= xi -> edges_at_most m k p d -> edges_differ_at_most m n k p q (xi * d) ->
  (forall i, (i <= k)%nat -> Rabs (c i) <= l / (INR k * t * d)) ->
  Rabs (spread n k c q - spread m k c p) <= relative_change k xi t * (l * l).
Proof.
  intros Hk Hd Ht Hx He Hdiffer Hc; pose proof (dimension_positive k Hk).
  eapply Rle_trans;
    [apply (spread_difference m n k p q c (l / (INR k * t * d)) ((2 + xi) * xi * (d * d))); trivial;
     intros; now apply (squared_edges_under_distortion m n k p q d xi) |].
  right; unfold relative_change, vertex_share; field; lra.
Qed.

(** For all weights that add up to 0: | |Σ x_i p̃_i|² − |Σ x_i p_i|² | ≤ (1 + 1/k)/2 · (2 + ξ) ξ/Υ² · |Σ x_i p_i|². *)
Theorem differences_under_distortion m n k p q d t xi x :
  (1 <= k)%nat -> 0 < d -> 0 < t -> 0 <= xi ->
  edges_at_most m k p d -> is_thick m k p d t -> edges_differ_at_most m n k p q (xi * d) -> sum (S k) x = 0 ->
  Rabs (norm n (combination k x q) * norm n (combination k x q)
        - norm m (combination k x p) * norm m (combination k x p))
  <= relative_change k xi t * (norm m (combination k x p) * norm m (combination k x p)).
Proof.
  intros Hk Hd Ht Hx He Hthick Hdiffer x0; pose proof (dimension_positive k Hk).
  set (l := norm m (combination k x p)).
  assert (A : 0 < INR k * t * d) by (repeat apply Rmult_lt_0_compat; lra).
  assert (G : forall i, (i <= k)%nat -> Rabs (x i) <= l / (INR k * t * d)).
  { intros i Hi; apply at_most_quotient; trivial; now apply difference_weight; auto. }
  pose proof (spread_under_distortion m n k p q x d t xi l Hk Hd Ht Hx He Hdiffer G) as S.
  unfold l in *; rewrite !spread_of_differences by trivial; rewrite spread_of_differences in S by trivial.
  rewrite Rabs_minus_sym; replace (- spread m k x p - - spread n k x q) with (spread n k x q - spread m k x p) by ring.
  exact S.
Qed.

(** D̃_i ≥ √(1 − a) D_i for each vertex, a the relative change. *)
Theorem altitude_under_small_distortion m n k p q d t xi i h :
  (1 <= k)%nat -> (i <= k)%nat -> 0 < d -> 0 < t -> 0 <= xi ->
  edges_at_most m k p d -> is_thick m k p d t -> edges_differ_at_most m n k p q (xi * d) ->
  relative_change k xi t <= 1 -> 0 <= h -> altitude_at_least m k p i h ->
  altitude_at_least n k q i (sqrt (1 - relative_change k xi t) * h).
Proof.
  intros Hk Hi Hd Ht Hx He Hthick Hdiffer Ha Hh H c c0 c1.
  set (x := fun j => unit_at i j - c j).
  assert (x0 : sum (S k) x = 0) by (unfold x; rewrite sum_minus, sum_of_unit, c1 by lia; ring).
  assert (E : forall dim s, norm dim (combination k x s) = distance dim (s i) (combination k c s)).
  { intros dim s; apply norm_ext; intros a _; unfold combination, minus, x.
    rewrite (sum_ext (S k) _ (fun j => unit_at i j * s j a - c j * s j a)) by (intros; ring).
    now rewrite sum_minus, (sum_unit_at (S k) i (fun j => s j a)) by lia. }
  pose proof (differences_under_distortion m n k p q d t xi x Hk Hd Ht Hx He Hthick Hdiffer x0) as D.
  rewrite !E in D; specialize (H c c0 c1).
  set (a := relative_change k xi t) in *; set (u := distance m _ _) in *.
  apply le_of_squares; [apply norm_nonneg |]; set (v := distance n _ _) in *.
  replace (sqrt (1 - a) * h * (sqrt (1 - a) * h)) with (sqrt (1 - a) * sqrt (1 - a) * (h * h)) by ring.
  rewrite sqrt_sqrt by lra.
  assert (h * h <= u * u) by (apply Rmult_le_compat; trivial).
  assert ((1 - a) * (h * h) <= (1 - a) * (u * u)) by (apply Rmult_le_compat_l; lra).
  unfold Rabs in D; destruct Rcase_abs; lra.
Qed.

(** The other simplex is thick too, measured by the longest edge of the first. *)
Theorem thickness_under_small_distortion m n k p q d t xi :
  (1 <= k)%nat -> 0 < d -> 0 < t -> 0 <= xi ->
  edges_at_most m k p d -> is_thick m k p d t -> edges_differ_at_most m n k p q (xi * d) ->
  relative_change k xi t <= 1 -> is_thick n k q d (sqrt (1 - relative_change k xi t) * t).
Proof.
  intros Hk Hd Ht Hx He Hthick Hdiffer Ha i Hi; pose proof (dimension_positive k Hk).
  replace (INR k * (sqrt (1 - relative_change k xi t) * t) * d)
    with (sqrt (1 - relative_change k xi t) * (INR k * t * d)) by ring.
  apply (altitude_under_small_distortion m n k p q d t); auto; repeat apply Rmult_le_pos; lra.
Qed.

(** Under the hypothesis that the paper makes, ξ ≤ (ηΥ/2)², the relative change is at most 9/16 η². *)
Lemma relative_change_at_most k xi t eta :
  (1 <= k)%nat -> 0 < t <= 1 -> 0 <= eta <= 1 -> 0 <= xi <= (eta * t / 2) * (eta * t / 2) ->
  relative_change k xi t <= 9 / 16 * (eta * eta).
Proof.
  intros Hk Ht Heta Hx; destruct (vertex_share_range k Hk) as [_ V]; unfold relative_change.
  assert (T : 0 < t * t) by nra.
  apply quotient_at_most; trivial.
  assert (E : 0 <= eta * t <= 1) by nra.
  assert (X : xi <= 1 / 4) by nra.
  apply Rle_trans with (1 * ((2 + xi) * xi)); [apply Rmult_le_compat_r; nra |].
  apply Rle_trans with (9 / 4 * ((eta * t / 2) * (eta * t / 2))); [|right; field].
  rewrite Rmult_1_l; apply Rmult_le_compat; lra.
Qed.

(** Sharper lem:intrinsic.thick.distortion: if ξ ≤ (ηΥ/2)², all altitudes shrink by √(1 − η²) at most. *)
Theorem altitudes_shrink_little m n k p q d t eta xi i h :
  (1 <= k)%nat -> (i <= k)%nat -> 0 < d -> 0 < t -> 0 <= eta <= 1 ->
  edges_at_most m k p d -> is_thick m k p d t ->
  0 <= xi <= (eta * t / 2) * (eta * t / 2) -> edges_differ_at_most m n k p q (xi * d) ->
  0 <= h -> altitude_at_least m k p i h -> altitude_at_least n k q i (sqrt (1 - eta * eta) * h).
Proof.
  intros Hk Hi Hd Ht Heta He Hthick Hx Hdiffer Hh H c c0 c1.
  pose proof (thickness_at_most_one m k p d t Hk Hd He Hthick) as T.
  pose proof (relative_change_at_most k xi t eta Hk (conj Ht T) Heta Hx) as A.
  assert (0 <= eta * eta <= 1) by nra.
  eapply Rle_trans; [|apply (altitude_under_small_distortion m n k p q d t xi i h); trivial; lra].
  apply Rmult_le_compat_r; trivial; apply sqrt_le_1_alt; lra.
Qed.
