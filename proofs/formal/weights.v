(** Lagrange's identity: what weights on the vertices of a simplex say of its edges. All that is proved of simplices whose
    edges change by little rests on it. *)

Require Import Reals Lra Lia Psatz.
From Delcert Require Import vectors simplices.
Open Scope R_scope.

(** Σ_{i<j} c_i c_j |p_i − p_j|²: half the sum over all i, j. *)
Definition spread (m k : nat) (c : vector) (p : simplex) : R :=
  sum (S k) (fun i => sum (S k) (fun j => c i * c j * (distance m (p i) (p j) * distance m (p i) (p j)))) / 2.

Lemma distance_squared m u v : distance m u v * distance m u v = sum m (fun a => (u a - v a) * (u a - v a)).
Proof. apply norm_squared. Qed.

(** Lagrange's identity for numbers. *)
Lemma pairs_of_differences n c u :
  sum n (fun i => sum n (fun j => c i * c j * ((u i - u j) * (u i - u j)))) =
  2 * (sum n c * sum n (fun i => c i * (u i * u i)) - sum n (fun i => c i * u i) * sum n (fun i => c i * u i)).
Proof.
  set (w := sum n c); set (one := sum n (fun i => c i * u i)); set (two := sum n (fun i => c i * (u i * u i))).
  rewrite (sum_ext n _ (fun i => w * (c i * (u i * u i)) - 2 * one * (c i * u i) + two * c i)).
  - rewrite sum_plus, sum_minus, !sum_scal; fold w one two; ring.
  - intros i _; rewrite (sum_ext n _ (fun j => c i * (u i * u i) * c j - 2 * (c i * u i) * (c j * u j)
                                               + c i * (c j * (u j * u j)))) by (intros; ring).
    rewrite sum_plus, sum_minus, !sum_scal; fold w one two; ring.
Qed.

Lemma spread_by_coordinates m k c p :
  spread m k c p = sum m (fun a => sum (S k) c * sum (S k) (fun i => c i * (p i a * p i a))
                                   - combination k c p a * combination k c p a).
Proof.
  unfold spread.
  rewrite (sum_ext (S k) _ (fun i => sum m (fun a => sum (S k) (fun j =>
    c i * c j * ((p i a - p j a) * (p i a - p j a)))))).
  - rewrite sum_swap; unfold Rdiv; rewrite <- sum_scal_right; apply sum_ext; intros a _.
    rewrite (pairs_of_differences (S k) c (fun i => p i a)); unfold combination; field.
  - intros i _; rewrite sum_swap; apply sum_ext; intros j _; rewrite distance_squared, <- sum_scal; trivial.
Qed.

(** For weights that add up to 1: Σ c_i |p_i − x|² = |Σ c_i p_i − x|² + Σ_{i<j} c_i c_j |p_i − p_j|², whatever x is. *)
Theorem lagrange m k c p x :
  sum (S k) c = 1 ->
  sum (S k) (fun i => c i * (distance m (p i) x * distance m (p i) x)) =
  distance m (combination k c p) x * distance m (combination k c p) x + spread m k c p.
Proof.
  intros W; rewrite spread_by_coordinates, W, distance_squared, <- sum_plus.
  rewrite (sum_ext (S k) _ (fun i => sum m (fun a => c i * ((p i a - x a) * (p i a - x a)))))
    by (intros; rewrite distance_squared, <- sum_scal; trivial).
  rewrite sum_swap; apply sum_ext; intros a _.
  rewrite (sum_ext (S k) _ (fun i => c i * (p i a * p i a) - 2 * x a * (c i * p i a) + x a * x a * c i))
    by (intros; ring).
  rewrite sum_plus, sum_minus, !sum_scal, W; unfold combination; ring.
Qed.

(** For weights that add up to 0: |Σ x_i p_i|² = −Σ_{i<j} x_i x_j |p_i − p_j|². *)
Theorem spread_of_differences m k x p :
  sum (S k) x = 0 -> norm m (combination k x p) * norm m (combination k x p) = - spread m k x p.
Proof.
  intros W; rewrite spread_by_coordinates, W, norm_squared; unfold dot.
  rewrite (sum_ext m (fun a => 0 * _ - _) (fun a => -1 * (combination k x p a * combination k x p a)))
    by (intros; ring).
  rewrite sum_scal; ring.
Qed.

(** P·x from the vertex b is Σ x_i p_i for weights that add up to 0, the way from p_b to Σ c_i p_i for those that add up
    to 1. *)
Lemma edge_map_of_differences m k p b x :
  sum (S k) x = 0 -> norm m (edge_map k p b x) = norm m (combination k x p).
Proof.
  intros W; apply norm_ext; intros a _; unfold edge_map, combination.
  rewrite (sum_ext (S k) _ (fun j => x j * p j a - x j * p b a)) by (intros; ring).
  rewrite sum_minus, sum_scal_right, W; ring.
Qed.

Lemma edge_map_of_weights m k p b c :
  sum (S k) c = 1 -> norm m (edge_map k p b c) = distance m (combination k c p) (p b).
Proof.
  intros W; apply norm_ext; intros a _; unfold edge_map, combination, minus.
  rewrite (sum_ext (S k) _ (fun j => c j * p j a - c j * p b a)) by (intros; ring).
  rewrite sum_minus, sum_scal_right, W; ring.
Qed.

Lemma another_vertex k i : (1 <= k)%nat -> exists b, (b <= k)%nat /\ i <> b.
Proof. intros Hk; destruct i; [exists 1%nat | exists O]; lia. Qed.

(** |x_i| is at most |Σ x_j p_j| over the altitude, for weights that add up to 0. *)
Lemma difference_weight m k p x i a :
  (1 <= k)%nat -> (i <= k)%nat -> sum (S k) x = 0 -> altitude_at_least m k p i a ->
  Rabs (x i) * a <= norm m (combination k x p).
Proof.
  intros Hk Hi W Ha; destruct (another_vertex k i Hk) as (b & Hb & D).
  rewrite <- (edge_map_of_differences m k p b x W); now apply altitude_times_coordinate.
Qed.

(** A weight of a point of the affine hull that is at most r from every vertex: at most r over the altitude. *)
Lemma weight_within m k p c i a r :
  (1 <= k)%nat -> (i <= k)%nat -> sum (S k) c = 1 -> altitude_at_least m k p i a ->
  (forall j, (j <= k)%nat -> distance m (combination k c p) (p j) <= r) -> Rabs (c i) * a <= r.
Proof.
  intros Hk Hi W Ha Hr; destruct (another_vertex k i Hk) as (b & Hb & D).
  eapply Rle_trans; [|exact (Hr b Hb)].
  rewrite <- (edge_map_of_weights m k p b c W); now apply altitude_times_coordinate.
Qed.

(** Σ c_i f_i for weights that add up to w differs from w·v by at most (k + 1) g e, if no weight is greater than g and no
    f_i farther than e from v. *)
Lemma weighted_sum_near k c f v g e :
  (forall i, (i <= k)%nat -> Rabs (c i) <= g) -> (forall i, (i <= k)%nat -> Rabs (f i - v) <= e) ->
  Rabs (sum (S k) (fun i => c i * f i) - sum (S k) c * v) <= (INR k + 1) * (g * e).
Proof.
  intros Hc Hf; rewrite <- sum_scal_right, <- sum_minus.
  assert (B : forall i, (i < S k)%nat -> - (g * e) <= c i * f i - c i * v <= g * e).
  { intros i Hi; replace (c i * f i - c i * v) with (c i * (f i - v)) by ring.
    assert (Rabs (c i * (f i - v)) <= g * e).
    { rewrite Rabs_mult; apply Rmult_le_compat; try apply Rabs_pos; [apply Hc | apply Hf]; lia. }
    unfold Rabs in H; destruct Rcase_abs; lra. }
  apply Rabs_le; split.
  - replace (- ((INR k + 1) * (g * e))) with (sum (S k) (fun _ => - (g * e))) by (rewrite sum_const, S_INR; ring).
    apply sum_le; intros i Hi; apply B; trivial.
  - replace ((INR k + 1) * (g * e)) with (sum (S k) (fun _ => g * e)) by (rewrite sum_const, S_INR; ring).
    apply sum_le; intros i Hi; apply B; trivial.
Qed.

(** If no weight is greater than g and the squares of the edges change by at most e, the spread changes by at most
    k (k + 1)/2 · e g². *)
Lemma spread_difference m n k p q c g e :
  (forall i, (i <= k)%nat -> Rabs (c i) <= g) ->
  (forall i j, (i <= k)%nat -> (j <= k)%nat ->
     Rabs (distance n (q i) (q j) * distance n (q i) (q j) - distance m (p i) (p j) * distance m (p i) (p j)) <= e) ->
  Rabs (spread n k c q - spread m k c p) <= INR k * (INR k + 1) / 2 * (e * (g * g)).
Proof.
  intros Hc He.
  set (f := fun i j => c i * c j * (distance n (q i) (q j) * distance n (q i) (q j)
                                    - distance m (p i) (p j) * distance m (p i) (p j))).
  assert (E : spread n k c q - spread m k c p = sum (S k) (fun i => sum (S k) (f i)) / 2).
  { unfold spread; rewrite <- Rdiv_minus_distr, <- sum_minus; f_equal; apply sum_ext; intros i _.
    rewrite <- sum_minus; apply sum_ext; intros j _; unfold f; ring. }
  assert (B : forall i j, (i <= k)%nat -> (j <= k)%nat -> - (e * (g * g)) <= f i j <= e * (g * g)).
  { intros i j Hi Hj.
    assert (H : Rabs (f i j) <= e * (g * g)).
    { unfold f; rewrite !Rabs_mult, Rmult_comm; apply Rmult_le_compat; auto using Rabs_pos.
      - apply Rmult_le_pos; apply Rabs_pos.
      - apply Rmult_le_compat; auto using Rabs_pos. }
    unfold Rabs in H; destruct Rcase_abs; lra. }
  assert (D : forall i, f i i = 0) by (intros; unfold f; rewrite !distance_zero; ring).
  assert (U : forall i, (i <= k)%nat -> sum (S k) (f i) <= INR k * (e * (g * g))).
  { intros i Hi; apply (sum_without_le k i); auto; intros j Hj _; now apply B. }
  assert (L : forall i, (i <= k)%nat -> - (INR k * (e * (g * g))) <= sum (S k) (f i)).
  { intros i Hi.
    assert (sum (S k) (fun j => -1 * f i j) <= INR k * (e * (g * g))).
    { apply (sum_without_le k i); trivial; [rewrite D; ring |].
      intros j Hj _; destruct (B i j Hi Hj); lra. }
    rewrite sum_scal in H; lra. }
  rewrite E; apply Rabs_le; split.
  - assert (H : sum (S k) (fun _ => - (INR k * (e * (g * g)))) <= sum (S k) (fun i => sum (S k) (f i)))
      by (apply sum_le; intros; apply L; lia).
    rewrite sum_const, S_INR in H; lra.
  - assert (H : sum (S k) (fun i => sum (S k) (f i)) <= sum (S k) (fun _ => INR k * (e * (g * g))))
      by (apply sum_le; intros; apply U; lia).
    rewrite sum_const, S_INR in H; lra.
Qed.
