(** Sharper than the first bound of lem:intrinsic.thick.distortion: s_k(P̃) ≥ √(1 − η²) s_k(P), and no singular value grows
    by more than √(1 + η²), whichever vertex the edges begin at. *)

Require Import Reals Lra Lia Psatz.
From Delcert Require Import vectors simplices distortion weights sharper_thickness.
Open Scope R_scope.

(** P·x is Σ y_j p_j for the weights y that are x but at b, and add up to 0. *)
Definition balanced (k b : nat) (x : vector) : vector := fun j => x j - sum (S k) x * unit_at b j.

Lemma sum_of_balanced k b x : (b <= k)%nat -> sum (S k) (balanced k b x) = 0.
Proof. intros Hb; unfold balanced; rewrite sum_minus, sum_scal, sum_of_unit by lia; ring. Qed.

Lemma edge_map_by_balanced m k p b x :
  (b <= k)%nat -> norm m (edge_map k p b x) = norm m (combination k (balanced k b x) p).
Proof.
  intros Hb; apply norm_ext; intros a _; unfold edge_map, combination, balanced.
  rewrite (sum_ext (S k) (fun j => x j * (p j a - p b a)) (fun j => x j * p j a - x j * p b a)) by (intros; ring).
  rewrite (sum_ext (S k) (fun j => (x j - sum (S k) x * unit_at b j) * p j a)
                         (fun j => x j * p j a - sum (S k) x * (unit_at b j * p j a))) by (intros; ring).
  rewrite !sum_minus, sum_scal, sum_scal_right, (sum_unit_at (S k) b (fun j => p j a)) by lia; trivial.
Qed.

(** (1 − a) |P·x|² ≤ |P̃·x|² ≤ (1 + a) |P·x|² for all x, a the relative change. *)
Theorem edge_maps_under_small_distortion m n k p q b d t xi x :
  (1 <= k)%nat -> (b <= k)%nat -> 0 < d -> 0 < t -> 0 <= xi ->
  edges_at_most m k p d -> is_thick m k p d t -> edges_differ_at_most m n k p q (xi * d) ->
  (1 - relative_change k xi t) * (norm m (edge_map k p b x) * norm m (edge_map k p b x))
  <= norm n (edge_map k q b x) * norm n (edge_map k q b x)
  <= (1 + relative_change k xi t) * (norm m (edge_map k p b x) * norm m (edge_map k p b x)).
Proof.
  intros Hk Hb Hd Ht Hx He Hthick Hdiffer; rewrite !edge_map_by_balanced by trivial.
  pose proof (differences_under_distortion m n k p q d t xi (balanced k b x) Hk Hd Ht Hx He Hthick Hdiffer
                (sum_of_balanced k b x Hb)) as D.
  unfold Rabs in D; destruct Rcase_abs; lra.
Qed.

(** If ξ ≤ (ηΥ/2)², then s_k(P̃) ≥ √(1 − η²) s_k(P), where the paper has 1 − η². *)
Theorem singular_values_shrink_little m n k p q b d t eta xi s :
  (1 <= k)%nat -> (b <= k)%nat -> 0 < d -> 0 < t -> 0 <= eta <= 1 ->
  edges_at_most m k p d -> is_thick m k p d t ->
  0 <= xi <= (eta * t / 2) * (eta * t / 2) -> edges_differ_at_most m n k p q (xi * d) ->
  0 <= s -> singular_values_at_least m k p b s -> singular_values_at_least n k q b (sqrt (1 - eta * eta) * s).
Proof.
  intros Hk Hb Hd Ht Heta He Hthick Hx Hdiffer Hs H x.
  pose proof (thickness_at_most_one m k p d t Hk Hd He Hthick) as T.
  pose proof (relative_change_at_most k xi t eta Hk (conj Ht T) Heta Hx) as A.
  destruct (edge_maps_under_small_distortion m n k p q b d t xi x Hk Hb Hd Ht (proj1 Hx) He Hthick Hdiffer) as [L _].
  pose proof (H x) as P; pose proof (norm_without_nonneg k b x) as W.
  assert (E : 0 <= eta * eta <= 1) by nra.
  set (r := norm_without k b x) in *; set (l := norm m (edge_map k p b x)) in *; clearbody r l.
  assert (SR : 0 <= s * r) by (now apply Rmult_le_pos).
  assert (Q : s * r * (s * r) <= l * l) by (apply Rmult_le_compat; trivial).
  apply le_of_squares; [apply norm_nonneg |]; eapply Rle_trans; [|exact L].
  replace (sqrt (1 - eta * eta) * s * r * (sqrt (1 - eta * eta) * s * r))
    with (sqrt (1 - eta * eta) * sqrt (1 - eta * eta) * (s * r * (s * r))) by ring.
  rewrite sqrt_sqrt by lra.
  apply Rle_trans with ((1 - eta * eta) * (l * l)); [apply Rmult_le_compat_l; lra |].
  apply Rmult_le_compat_r; [apply Rle_0_sqr | lra].
Qed.
