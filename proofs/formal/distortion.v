(** Simplices whose edge lengths differ by little: lem:splx.gram and lem:intrinsic.thick.distortion, in all dimensions. *)

Require Import Reals Lra Lia Psatz.
From Delcert Require Import vectors simplices.
Open Scope R_scope.

(** The edge lengths of p in ℝᵐ and q in ℝⁿ, simplices of the same dimension k, differ by at most a. *)
Definition edges_differ_at_most (m n k : nat) (p q : simplex) (a : R) : Prop :=
  forall i j, (i <= k)%nat -> (j <= k)%nat -> Rabs (distance m (p i) (p j) - distance n (q i) (q j)) <= a.

(** An entry of the Gram matrix of the edges from the vertex b. *)
Definition gram (m : nat) (p : simplex) (b i j : nat) : R := dot m (minus (p i) (p b)) (minus (p j) (p b)).

(** An entry of the difference E of two Gram matrices. *)
Definition gram_error (m n : nat) (p q : simplex) (b i j : nat) : R := gram n q b i j - gram m p b i j.

Lemma gram_from_distances m p b i j :
  gram m p b i j = (distance m (p i) (p b) * distance m (p i) (p b) + distance m (p j) (p b) * distance m (p j) (p b)
                    - distance m (p i) (p j) * distance m (p i) (p j)) / 2.
Proof.
  unfold gram; rewrite dot_from_norms.
  replace (norm m (minus (minus (p i) (p b)) (minus (p j) (p b)))) with (distance m (p i) (p j)); [reflexivity |].
  apply norm_ext; intros; unfold minus; ring.
Qed.

Lemma difference_of_squares a b d xi :
  0 <= a <= d -> 0 <= b -> 0 <= xi -> Rabs (a - b) <= xi * d -> Rabs (b * b - a * a) <= (2 + xi) * xi * (d * d).
Proof.
  intros Ha Hb Hx H; unfold Rabs in H |- *; destruct Rcase_abs, Rcase_abs; nra.
Qed.

(** lem:splx.gram, the entries: |E_ij| ≤ 4 ξ Δ². *)
Theorem gram_entry m n k p q b d xi i j :
  (b <= k)%nat -> (i <= k)%nat -> (j <= k)%nat -> 0 <= xi <= 2 / 3 ->
  edges_at_most m k p d -> edges_differ_at_most m n k p q (xi * d) ->
  Rabs (gram_error m n p q b i j) <= 4 * xi * (d * d).
Proof.
  intros Hb Hi Hj Hx He Hd.
  assert (S : forall u v, (u <= k)%nat -> (v <= k)%nat ->
              Rabs (distance n (q u) (q v) * distance n (q u) (q v) - distance m (p u) (p v) * distance m (p u) (p v))
              <= (2 + xi) * xi * (d * d)).
  { intros u v Hu Hv; apply difference_of_squares; try lra; auto.
    - split; [apply norm_nonneg | auto].
    - apply norm_nonneg. }
  pose proof (S i b Hi Hb) as A; pose proof (S j b Hj Hb) as B; pose proof (S i j Hi Hj) as C; clear S.
  unfold gram_error; rewrite !gram_from_distances.
  assert (3 / 2 * ((2 + xi) * xi * (d * d)) <= 4 * xi * (d * d)).
  { assert (0 <= xi * (d * d)) by (apply Rmult_le_pos; [lra | apply Rle_0_sqr]); nra. }
  unfold Rabs in *; repeat destruct Rcase_abs; lra.
Qed.

(** E·x for a matrix E. *)
Definition apply_matrix (k : nat) (E : nat -> nat -> R) (x : vector) : vector := fun i => sum (S k) (fun j => E i j * x j).

(** A matrix with k rows and columns besides the row and column b of zeros, and entries of size at most a: its norm is at
    most k·a. *)
Lemma norm_from_entries k E b a x :
  (b <= k)%nat -> 0 <= a -> (forall j, E b j = 0) -> (forall i, E i b = 0) ->
  (forall i j, (i <= k)%nat -> (j <= k)%nat -> Rabs (E i j) <= a) ->
  norm (S k) (apply_matrix k E x) <= INR k * a * norm_without k b x.
Proof.
  intros Hb Ha Hrow Hcolumn H.
  pose proof (pos_INR k) as K; pose proof (norm_without_nonneg k b x) as X.
  apply norm_le; [now repeat apply Rmult_le_pos |].
  apply Rle_trans with (INR k * (INR k * (a * a) * (norm_without k b x * norm_without k b x))); [|right; ring].
  apply (sum_without_le k b); trivial.
  - unfold apply_matrix; rewrite (sum_ext _ _ (fun _ => 0)), sum_zero; [ring |].
    intros; rewrite Hrow; ring.
  - intros i Hi _.
    replace (apply_matrix k E x i) with (dot (S k) (E i) (without b x)).
    + eapply Rle_trans; [apply cauchy_schwarz_squared |].
      rewrite norm_without_squared; apply Rmult_le_compat_r; [apply sum_nonneg; intros; apply Rle_0_sqr |].
      apply (sum_without_le k b); trivial; [rewrite Hcolumn; ring |].
      intros j Hj _; specialize (H i j Hi Hj); unfold Rabs in H; destruct Rcase_abs; nra.
    + apply sum_ext; intros j Hj; unfold without; destruct (Nat.eqb_spec j b) as [->|]; [rewrite Hcolumn |]; ring.
Qed.

Lemma gram_base_row m p b j : gram m p b b j = 0.
Proof.
  unfold gram, dot; rewrite (sum_ext _ _ (fun _ => 0)); [apply sum_zero |]; intros; unfold minus; ring.
Qed.

Lemma gram_base_column m p b i : gram m p b i b = 0.
Proof. unfold gram; rewrite dot_comm; apply gram_base_row. Qed.

(** eq:gram.err.bnd: ‖E‖ ≤ 4 k ξ Δ². *)
Theorem gram_norm m n k p q b d xi x :
  (b <= k)%nat -> 0 <= xi <= 2 / 3 -> edges_at_most m k p d -> edges_differ_at_most m n k p q (xi * d) ->
  norm (S k) (apply_matrix k (gram_error m n p q b) x) <= 4 * INR k * xi * (d * d) * norm_without k b x.
Proof.
  intros Hb Hx He Hd.
  replace (4 * INR k * xi * (d * d)) with (INR k * (4 * xi * (d * d))) by ring.
  apply norm_from_entries; trivial.
  - pose proof (Rle_0_sqr d); unfold Rsqr in *; nra.
  - intros; unfold gram_error; rewrite !gram_base_row; ring.
  - intros; unfold gram_error; rewrite !gram_base_column; ring.
  - intros; now apply (gram_entry m n k).
Qed.

(** |P·x|² = xᵀ (PᵀP) x. *)
Lemma edge_map_squared m k p b x :
  norm m (edge_map k p b x) * norm m (edge_map k p b x) =
  sum (S k) (fun i => x i * sum (S k) (fun j => gram m p b i j * x j)).
Proof.
  rewrite norm_squared; unfold dot, edge_map.
  rewrite (sum_ext m _ (fun a => sum (S k) (fun i => sum (S k) (fun j =>
    x i * (p i a - p b a) * (x j * (p j a - p b a)))))).
  - rewrite sum_swap; apply sum_ext; intros i _.
    rewrite sum_swap, <- sum_scal; apply sum_ext; intros j _.
    unfold gram, dot, minus; rewrite <- sum_scal_right, <- sum_scal; apply sum_ext; intros; ring.
  - intros a _; rewrite <- sum_scal_right; apply sum_ext; intros i _; rewrite <- sum_scal; now apply sum_ext.
Qed.

(** lem:intrinsic.thick.distortion, the smallest singular value: s_k(P̃) ≥ (1 − η²) s_k(P). For s all lower bounds of |P·x|
    for unit vectors x are allowed that are at least √k Υ Δ, such as s_k(P) itself. *)
Theorem singular_value_under_distortion m n k p q b d t eta xi s :
  (1 <= k)%nat -> (b <= k)%nat -> 0 < d -> 0 < t -> 0 <= eta <= 1 ->
  edges_at_most m k p d -> is_thick m k p d t ->
  0 <= xi <= (eta * t / 2) * (eta * t / 2) -> edges_differ_at_most m n k p q (xi * d) ->
  sqrt (INR k) * t * d <= s -> singular_values_at_least m k p b s ->
  singular_values_at_least n k q b ((1 - eta * eta) * s).
Proof.
  intros Hk Hb Hd Ht Heta He Hthick Hxi Hdiffer Hs H x.
  pose proof (thickness_at_most_one m k p d t Hk Hd He Hthick) as T.
  assert (X : xi <= 1 / 4).
  { assert (0 <= eta * t <= 1) by nra; nra. }
  assert (X' : 0 <= xi <= 2 / 3) by lra.
  pose proof (gram_norm m n k p q b d xi (without b x) Hb X' He Hdiffer) as G.
  assert (W : norm_without k b (without b x) = norm_without k b x).
  { apply norm_ext; intros j _; unfold without; destruct (Nat.eqb j b); trivial. }
  rewrite W in G; clear W.
  pose proof (H x) as P.
  pose proof (norm_without_nonneg k b x) as N.
  set (r := norm_without k b x) in *; set (l := norm m (edge_map k p b x)) in *.
  assert (K : 1 <= INR k) by (change 1 with (INR 1); now apply le_INR).
  assert (K' : 0 < sqrt (INR k)) by (apply sqrt_lt_R0; lra).
  assert (Sk : sqrt (INR k) * sqrt (INR k) = INR k) by (apply sqrt_sqrt; lra).
  assert (s0 : 0 < s).
  { eapply Rlt_le_trans; [|exact Hs]; now repeat apply Rmult_lt_0_compat. }
  (* |P̃·x|² − |P·x|² = xᵀ E x *)
  assert (D : norm n (edge_map k q b x) * norm n (edge_map k q b x) - l * l
              = dot (S k) (without b x) (apply_matrix k (gram_error m n p q b) (without b x))).
  { unfold l; rewrite !edge_map_squared, <- sum_minus; apply sum_ext; intros i _.
    rewrite <- Rmult_minus_distr_l, <- sum_minus; unfold apply_matrix.
    unfold without at 1; destruct (Nat.eqb_spec i b) as [->|].
    - rewrite (sum_ext _ _ (fun _ => 0)), sum_zero; [ring |]; intros; rewrite !gram_base_row; ring.
    - f_equal; apply sum_ext; intros j _; unfold gram_error, without; destruct (Nat.eqb_spec j b) as [->|]; [|ring].
      rewrite !gram_base_column; ring. }
  pose proof (cauchy_schwarz (S k) (without b x) (apply_matrix k (gram_error m n p q b) (without b x))) as C.
  fold (norm_without k b x) in C; fold r in C; rewrite <- D in C.
  set (e := norm (S k) (apply_matrix _ _ _)) in *.
  (* ‖E‖ ≤ η² k Υ² Δ² ≤ η² s² *)
  assert (B : 4 * INR k * xi * (d * d) <= eta * eta * (s * s)).
  { apply Rle_trans with (eta * eta * (sqrt (INR k) * t * d * (sqrt (INR k) * t * d))).
    - replace (sqrt (INR k) * t * d * (sqrt (INR k) * t * d)) with (sqrt (INR k) * sqrt (INR k) * (t * t) * (d * d))
        by ring.
      rewrite Sk.
      assert (0 <= INR k * (d * d)) by (apply Rmult_le_pos; nra); nra.
    - assert (0 <= sqrt (INR k) * t * d) by (now repeat apply Rmult_le_pos; lra).
      apply Rmult_le_compat_l; nra. }
  clear H He Hthick Hdiffer D; clearbody l r e.
  pose proof (norm_nonneg n (edge_map k q b x)) as Q; set (z := norm n (edge_map k q b x)) in *; clearbody z.
  assert (L : s * r * (s * r) <= l * l) by (assert (0 <= s * r) by (apply Rmult_le_pos; lra); nra).
  assert (Z : l * l - eta * eta * (s * s) * (r * r) <= z * z).
  { assert (r * e <= r * (eta * eta * (s * s) * r)).
    { apply Rmult_le_compat_l; trivial; eapply Rle_trans; [exact G |]; now apply Rmult_le_compat_r. }
    unfold Rabs in C; destruct Rcase_abs; nra. }
  apply le_of_squares; trivial.
  assert (E : 0 <= 1 - eta * eta <= 1) by nra.
  assert (M : (1 - eta * eta) * (s * r * (s * r)) <= z * z) by nra.
  assert (0 <= s * r * (s * r)) by (apply Rle_0_sqr).
  replace ((1 - eta * eta) * s * r * ((1 - eta * eta) * s * r))
    with ((1 - eta * eta) * ((1 - eta * eta) * (s * r * (s * r)))) by ring.
  nra.
Qed.

(** The second bound: the altitudes of the other simplex are at least (1 − η²) √k Υ Δ, which says
    Υ̃ Δ̃ ≥ (1 − η²) Υ Δ / √k. *)
Theorem altitudes_under_distortion m n k p q d t eta xi i :
  (1 <= k)%nat -> (i <= k)%nat -> 0 < d -> 0 < t -> 0 <= eta <= 1 ->
  edges_at_most m k p d -> is_thick m k p d t ->
  0 <= xi <= (eta * t / 2) * (eta * t / 2) -> edges_differ_at_most m n k p q (xi * d) ->
  altitude_at_least n k q i ((1 - eta * eta) * (sqrt (INR k) * t * d)).
Proof.
  intros Hk Hi Hd Ht Heta He Hthick Hxi Hdiffer.
  (* Edges from another vertex than i: the paper's "without loss of generality". *)
  set (b := if Nat.eqb i 0 then 1%nat else O).
  assert (Hb : (b <= k)%nat) by (unfold b; destruct (Nat.eqb i 0); lia).
  assert (D : i <> b) by (unfold b; destruct (Nat.eqb_spec i 0); lia).
  assert (0 <= sqrt (INR k) * t * d).
  { pose proof (sqrt_pos (INR k)); repeat apply Rmult_le_pos; lra. }
  apply (singular_value_from_above n k q b); trivial.
  - apply Rmult_le_pos; nra.
  - apply (singular_value_under_distortion m n k p q b d t eta xi); trivial; [lra |].
    apply thickness_and_singular_value; trivial; lra.
Qed.

(** The third bound, Υ̃ ≥ 4/(5√k) (1 − η²) Υ, of the thicknesses themselves. *)
Theorem thickness_under_distortion m n k p q d e t u eta xi :
  (1 <= k)%nat -> 0 < d -> 0 < t -> 0 <= eta <= 1 ->
  is_longest_edge m k p d -> is_longest_edge n k q e -> is_thickness m k p d t -> is_thickness n k q e u ->
  0 <= xi <= (eta * t / 2) * (eta * t / 2) -> edges_differ_at_most m n k p q (xi * d) ->
  4 / (5 * sqrt (INR k)) * (1 - eta * eta) * t <= u.
Proof.
  intros Hk Hd Ht Heta [He _] [_ (v & w & Hv & Hw & Ev)] [Hthick _] [_ Hu] Hxi Hdiffer.
  apply Hu; intros i Hi c c0 c1.
  eapply Rle_trans;
    [|now apply (altitudes_under_distortion m n k p q d t eta xi i Hk Hi Hd Ht Heta He Hthick Hxi Hdiffer)].
  pose proof (thickness_at_most_one m k p d t Hk Hd He Hthick) as T.
  assert (X : xi <= 1 / 4).
  { assert (0 <= eta * t <= 1) by nra; nra. }
  assert (E : e <= 5 / 4 * d).
  { specialize (He v w Hv Hw); specialize (Hdiffer v w Hv Hw); rewrite Ev in Hdiffer.
    unfold Rabs in Hdiffer; destruct Rcase_abs; nra. }
  assert (K : 1 <= INR k) by (change 1 with (INR 1); now apply le_INR).
  assert (K' : 0 < sqrt (INR k)) by (apply sqrt_lt_R0; lra).
  assert (Sk : sqrt (INR k) * sqrt (INR k) = INR k) by (apply sqrt_sqrt; lra).
  rewrite <- Sk at 1.
  replace (sqrt (INR k) * sqrt (INR k) * (4 / (5 * sqrt (INR k)) * (1 - eta * eta) * t) * e)
    with (4 / 5 * e * ((1 - eta * eta) * (sqrt (INR k) * t))) by (field; lra).
  replace ((1 - eta * eta) * (sqrt (INR k) * t * d)) with (d * ((1 - eta * eta) * (sqrt (INR k) * t))) by ring.
  apply Rmult_le_compat_r; [|lra].
  apply Rmult_le_pos; [nra |]; apply Rmult_le_pos; lra.
Qed.
