(** What the proofs of the steps, which delcert writes, are made of. *)

Require Import Reals Lra Lia Psatz.
Open Scope R_scope.

(** An inequality from its difference, a quotient whose signs are known. *)
Lemma le_by a b n d : 0 <= n -> 0 < d -> b - a = n / d -> a <= b.
Proof.
  intros Hn Hd E; assert (0 <= n / d); [|lra].
  apply Rmult_le_pos; [trivial |]; left; now apply Rinv_0_lt_compat.
Qed.

Lemma lt_by a b n d : 0 < n -> 0 < d -> b - a = n / d -> a < b.
Proof. intros Hn Hd E; assert (0 < n / d); [|lra]; now apply Rdiv_lt_0_compat. Qed.

(** Powers that are compared: of a base between 0 and 1 the higher one is the smaller, of a base from 1 on the greater. *)
Lemma pow_falls x a b : 0 <= x -> x <= 1 -> (b <= a)%nat -> x ^ a <= x ^ b.
Proof.
  intros H0 H1 H; replace a with (b + (a - b))%nat by lia; rewrite pow_add.
  rewrite <- (Rmult_1_r (x ^ b)) at 2; apply Rmult_le_compat_l; [now apply pow_le |].
  rewrite <- (pow1 (a - b)); apply pow_incr; lra.
Qed.

Lemma pow_grows x a b : 1 <= x -> (a <= b)%nat -> x ^ a <= x ^ b.
Proof. apply Rle_pow. Qed.

Lemma minus_nonneg a b : b <= a -> 0 <= a - b.
Proof. lra. Qed.

Lemma square_nonneg x : 0 <= x ^ 2.
Proof. simpl; rewrite Rmult_1_r; apply Rle_0_sqr. Qed.

Lemma even_power_nonneg x n : 0 <= (x ^ 2) ^ n.
Proof. apply pow_le, square_nonneg. Qed.

(** Every number that is not negative is a square, and its root is where it should be. *)
Lemma root_of x : 0 <= x -> exists s, 0 <= s /\ x = s * s.
Proof. intros H; exists (sqrt x); split; [apply sqrt_pos | symmetry; now apply sqrt_sqrt]. Qed.

Lemma root_at_least s a b : 0 <= s -> 0 <= a -> b <= s * s -> a * a <= b -> a <= s.
Proof. nra. Qed.
Lemma root_above s a b : 0 <= s -> 0 <= a -> b < s * s -> a * a <= b -> a < s.
Proof. nra. Qed.
Lemma root_at_most s a b : 0 <= s -> 0 <= a -> s * s <= b -> b <= a * a -> s <= a.
Proof. nra. Qed.
Lemma root_below s a b : 0 <= s -> 0 <= a -> s * s < b -> b <= a * a -> s < a.
Proof. nra. Qed.

Lemma sqrt_is x y : 0 <= y -> x = y * y -> sqrt x = y.
Proof. intros H ->; now apply sqrt_square. Qed.

(** Powers with real exponents of positive bases. *)
Lemma power_positive x y : 0 < Rpower x y.
Proof. apply exp_pos. Qed.

Lemma power_at_most_one x y : 0 < x <= 1 -> 0 <= y -> Rpower x y <= 1.
Proof.
  intros Hx Hy; rewrite <- exp_0; unfold Rpower.
  assert (ln x <= 0) by (rewrite <- ln_1; destruct (Rle_lt_or_eq_dec x 1 ltac:(lra)) as [L| ->]; [|lra];
    left; now apply ln_increasing).
  destruct (Rle_lt_or_eq_dec (y * ln x) 0) as [L| ->]; [nra | left; now apply exp_increasing | lra].
Qed.

Lemma power_at_least_one x y : 1 <= x -> 0 <= y -> 1 <= Rpower x y.
Proof. intros Hx Hy; rewrite <- (Rpower_O x) by lra; now apply Rle_Rpower. Qed.

Lemma quotient_nonneg a b : 0 <= a -> 0 < b -> 0 <= a / b.
Proof. intros; apply Rmult_le_pos; [trivial |]; left; now apply Rinv_0_lt_compat. Qed.

Lemma abs_at_most a b : - b <= a -> a <= b -> Rabs a <= b.
Proof. intros; now apply Rabs_le. Qed.

Lemma abs_below a b : - b < a -> a < b -> Rabs a < b.
Proof. intros; now apply Rabs_def1. Qed.

(** A power is known by its logarithm. *)
Lemma power_is x y r : 0 < r -> ln r = y * ln x -> Rpower x y = r.
Proof. intros H E; unfold Rpower; rewrite <- E; now apply exp_ln. Qed.

Lemma ln_of_power x y : ln (Rpower x y) = y * ln x.
Proof. apply ln_exp. Qed.

Lemma ln_of_pow x n : 0 < x -> ln (x ^ n) = IZR (Z.of_nat n) * ln x.
Proof. intros H; rewrite <- Rpower_pow, ln_of_power, INR_IZR_INZ by trivial; reflexivity. Qed.

Lemma ln_of_quotient x y : 0 < x -> 0 < y -> ln (x / y) = ln x - ln y.
Proof.
  intros Hx Hy; pose proof (Rinv_0_lt_compat y Hy); unfold Rdiv.
  rewrite ln_mult, (ln_Rinv y Hy) by trivial; ring.
Qed.

(** Signs of what is written as sums, products and powers of parts whose signs are known or can be seen. *)
Ltac nonneg :=
  first
    [ assumption
    | apply Rlt_le; assumption
    | lazymatch goal with
      | |- 0 <= ?a + ?b => apply Rplus_le_le_0_compat; nonneg
      | |- 0 <= ?a * ?b => apply Rmult_le_pos; nonneg
      | |- 0 <= (?a ^ 2) ^ ?n => apply even_power_nonneg
      | |- 0 <= ?a ^ ?n => first [apply pow_le; nonneg | apply square_nonneg]
      | |- 0 <= ?a - ?b => first [lra | apply minus_nonneg; dominated]
      | |- _ => lra
      end ]
(** x^4 * y^1 <= x^2 * y^3: factor by factor. *)
with dominated :=
  lazymatch goal with
  | |- ?a * ?b <= ?c * ?d => apply Rmult_le_compat; [nonneg | nonneg | dominated | dominated]
  | |- ?x ^ ?n <= ?x ^ ?n => apply Rle_refl
  | |- ?x ^ _ <= ?x ^ _ => first [apply pow_falls; [nonneg | first [assumption | lra] | lia]
                                 | apply pow_grows; [first [assumption | lra] | lia]]
  | |- _ => first [assumption | apply Rle_refl | lra]
  end.

Ltac positive :=
  first
    [ assumption
    | lazymatch goal with
      | |- 0 < ?a + ?b => first [apply Rplus_lt_le_0_compat; [positive | nonneg]
                                | apply Rplus_le_lt_0_compat; [nonneg | positive]]
      | |- 0 < ?a * ?b => apply Rmult_lt_0_compat; positive
      | |- 0 < ?a ^ ?n => apply pow_lt; positive
      | |- 0 < ?a / ?b => first [lra | apply Rdiv_lt_0_compat; positive]
      | |- 0 < / ?a => apply Rinv_0_lt_compat; positive
      | |- 0 < Rpower _ _ => apply power_positive
      | |- _ => lra
      end ].

(** What `field` asks for. *)
Ltac nonzero :=
  repeat split;
  first [lra | apply Rgt_not_eq; positive | apply Rlt_not_eq; lra | intro; nra].

(** An equation between logarithms of products, quotients and powers of positive numbers. *)
Ltac logarithms :=
  repeat first
    [ rewrite ln_of_power
    | rewrite ln_of_pow by positive
    | rewrite ln_mult by positive
    | rewrite ln_of_quotient by positive
    | rewrite ln_Rinv by positive
    | rewrite ln_1 ];
  cbn [Z.of_nat Pos.of_succ_nat Pos.succ];
  field.
