(** Sums and vectors of any dimension over Coq's real numbers, with what the lemmas on simplices need of them. *)

Require Import Reals Lra Lia Psatz.
Open Scope R_scope.

(** f 0 + … + f (n − 1) *)
Fixpoint sum (n : nat) (f : nat -> R) : R :=
  match n with
  | O => 0
  | S n => sum n f + f n
  end.

Lemma sum_ext n f g : (forall i, (i < n)%nat -> f i = g i) -> sum n f = sum n g.
Proof.
  induction n as [|n IH]; intros H; simpl; trivial.
  rewrite IH, H; auto.
Qed.

Lemma sum_zero n : sum n (fun _ => 0) = 0.
Proof. induction n; simpl; lra. Qed.

Lemma sum_const n a : sum n (fun _ => a) = INR n * a.
Proof. induction n as [|n IH]; [simpl; lra | simpl sum; rewrite IH, S_INR; lra]. Qed.

Lemma sum_plus n f g : sum n (fun i => f i + g i) = sum n f + sum n g.
Proof. induction n; simpl; lra. Qed.

Lemma sum_minus n f g : sum n (fun i => f i - g i) = sum n f - sum n g.
Proof. induction n; simpl; lra. Qed.

Lemma sum_scal n a f : sum n (fun i => a * f i) = a * sum n f.
Proof. induction n as [|n IH]; simpl; [lra | rewrite IH; lra]. Qed.

Lemma sum_scal_right n a f : sum n (fun i => f i * a) = sum n f * a.
Proof. induction n as [|n IH]; simpl; [lra | rewrite IH; lra]. Qed.

Lemma sum_le n f g : (forall i, (i < n)%nat -> f i <= g i) -> sum n f <= sum n g.
Proof.
  induction n as [|n IH]; intros H; simpl; [lra |].
  apply Rplus_le_compat; auto.
Qed.

Lemma sum_nonneg n f : (forall i, (i < n)%nat -> 0 <= f i) -> 0 <= sum n f.
Proof. intros H; rewrite <- (sum_zero n); apply sum_le; auto. Qed.

Lemma sum_swap n m (f : nat -> nat -> R) :
  sum n (fun i => sum m (fun j => f i j)) = sum m (fun j => sum n (fun i => f i j)).
Proof.
  induction n as [|n IH]; simpl.
  - now rewrite sum_zero.
  - now rewrite IH, <- sum_plus.
Qed.

(** A sum with only one term. *)
Lemma sum_single n i a : (i < n)%nat -> sum n (fun j => if Nat.eqb j i then a else 0) = a.
Proof.
  induction n as [|n IH]; intros H; [inversion H |]; simpl.
  destruct (Nat.eqb_spec n i) as [E|D].
  - rewrite (sum_ext n _ (fun _ => 0)).
    + rewrite sum_zero; lra.
    + intros j Hj; destruct (Nat.eqb_spec j i); trivial; lia.
  - rewrite IH; [lra |].
    lia.
Qed.

(** One term of a sum of terms that are not negative is at most the sum. *)
Lemma term_le_sum n f i : (forall j, (j < n)%nat -> 0 <= f j) -> (i < n)%nat -> f i <= sum n f.
Proof.
  intros Hf Hi.
  rewrite <- (sum_single n i (f i) Hi).
  apply sum_le; intros j Hj; destruct (Nat.eqb_spec j i) as [->|]; [lra | auto].
Qed.

(** Vectors of ℝⁿ are functions on 0 … n − 1; what they are beyond does not count. *)
Definition vector := nat -> R.
Definition dot (n : nat) (u v : vector) : R := sum n (fun i => u i * v i).
Definition norm (n : nat) (u : vector) : R := sqrt (dot n u u).
Definition minus (u v : vector) : vector := fun i => u i - v i.
Definition distance (n : nat) (u v : vector) : R := norm n (minus u v).

Lemma dot_comm n u v : dot n u v = dot n v u.
Proof. apply sum_ext; intros; ring. Qed.

Lemma dot_nonneg n u : 0 <= dot n u u.
Proof. apply sum_nonneg; intros; nra. Qed.

Lemma norm_nonneg n u : 0 <= norm n u.
Proof. apply sqrt_pos. Qed.

Lemma norm_squared n u : norm n u * norm n u = dot n u u.
Proof. apply sqrt_sqrt, dot_nonneg. Qed.

Lemma norm_ext n u v : (forall i, (i < n)%nat -> u i = v i) -> norm n u = norm n v.
Proof. intros H; unfold norm, dot; f_equal; apply sum_ext; intros; now rewrite H. Qed.

Lemma le_of_squares a b : 0 <= b -> a * a <= b * b -> a <= b.
Proof. intros; nra. Qed.

Lemma abs_le_of_squares a b : 0 <= b -> a * a <= b * b -> Rabs a <= b.
Proof. intros; apply Rabs_le; split; nra. Qed.

Lemma at_most_quotient a b x : 0 < b -> x * b <= a -> x <= a / b.
Proof. intros Hb H; apply Rmult_le_reg_r with b; trivial; now replace (a / b * b) with a by (field; lra). Qed.

Lemma quotient_at_most a b x : 0 < b -> a <= x * b -> a / b <= x.
Proof. intros Hb H; apply Rmult_le_reg_r with b; trivial; now replace (a / b * b) with a by (field; lra). Qed.

Lemma quotient_nonneg a b : 0 <= a -> 0 < b -> 0 <= a / b.
Proof. intros Ha Hb; apply at_most_quotient; lra. Qed.

(** Cauchy and Schwarz, squared. *)
Lemma cauchy_schwarz_squared n u v : dot n u v * dot n u v <= dot n u u * dot n v v.
Proof.
  induction n as [|n IH]; [unfold dot; simpl; lra |].
  pose proof (dot_nonneg n u) as Ha; pose proof (dot_nonneg n v) as Hb.
  unfold dot in *; simpl.
  set (a := sum n (fun i => u i * u i)) in *; set (b := sum n (fun i => v i * v i)) in *.
  set (c := sum n (fun i => u i * v i)) in *; set (x := u n); set (y := v n).
  clearbody a b c x y.
  assert (2 * (c * (x * y)) <= a * (y * y) + b * (x * x)).
  { apply le_of_squares.
    - pose proof (Rle_0_sqr x); pose proof (Rle_0_sqr y); unfold Rsqr in *; nra.
    - apply Rle_trans with (4 * (a * b) * (x * y * (x * y))).
      + pose proof (Rle_0_sqr (x * y)); unfold Rsqr in *; nra.
      + pose proof (Rle_0_sqr (a * (y * y) - b * (x * x))); unfold Rsqr in *; nra. }
  nra.
Qed.

Lemma cauchy_schwarz n u v : Rabs (dot n u v) <= norm n u * norm n v.
Proof.
  pose proof (norm_nonneg n u); pose proof (norm_nonneg n v).
  apply abs_le_of_squares; [now apply Rmult_le_pos |].
  replace (norm n u * norm n v * (norm n u * norm n v)) with (norm n u * norm n u * (norm n v * norm n v)) by ring.
  rewrite !norm_squared; apply cauchy_schwarz_squared.
Qed.

Lemma norm_le n u a : 0 <= a -> dot n u u <= a * a -> norm n u <= a.
Proof. intros Ha H; apply le_of_squares; trivial; now rewrite norm_squared. Qed.

Lemma norm_scal n a u : 0 <= a -> norm n (fun i => a * u i) = a * norm n u.
Proof.
  intros Ha; unfold norm.
  replace (dot n (fun i => a * u i) (fun i => a * u i)) with (a * a * dot n u u).
  - rewrite sqrt_mult_alt, sqrt_square; trivial; nra.
  - unfold dot; rewrite <- sum_scal; apply sum_ext; intros; ring.
Qed.

(** The law of cosines: scalar products from lengths. *)
Lemma dot_from_norms n u v :
  dot n u v = (norm n u * norm n u + norm n v * norm n v - norm n (minus u v) * norm n (minus u v)) / 2.
Proof.
  rewrite !norm_squared; unfold dot, minus.
  rewrite <- sum_plus, <- sum_minus.
  unfold Rdiv; rewrite <- sum_scal_right; apply sum_ext; intros; field.
Qed.

Lemma norm_triangle n u v : norm n (fun i => u i + v i) <= norm n u + norm n v.
Proof.
  apply norm_le; [pose proof (norm_nonneg n u); pose proof (norm_nonneg n v); lra |].
  replace (dot n (fun i => u i + v i) (fun i => u i + v i)) with (dot n u u + dot n v v + 2 * dot n u v).
  - rewrite <- !norm_squared.
    pose proof (cauchy_schwarz n u v); pose proof (Rle_abs (dot n u v)); nra.
  - unfold dot; rewrite <- sum_scal, <- !sum_plus; apply sum_ext; intros; ring.
Qed.

Lemma distance_sym n u v : distance n u v = distance n v u.
Proof. unfold distance, norm; f_equal; apply sum_ext; intros; unfold minus; ring. Qed.

Lemma distance_triangle n u v w : distance n u w <= distance n u v + distance n v w.
Proof.
  unfold distance; eapply Rle_trans; [|apply norm_triangle].
  right; apply norm_ext; intros; unfold minus; ring.
Qed.

Lemma distance_zero n u : distance n u u = 0.
Proof.
  unfold distance, norm; rewrite <- sqrt_0; f_equal.
  rewrite <- (sum_zero n); apply sum_ext; intros; unfold minus; ring.
Qed.
