(** What thm:riem.del.tri asks for, with the sharper lemmas: docs/claims/riemannian-constants.md. Its charts are exponential maps, and the
    separation in them is (1 − d)μ₀, so that Γ₀ is a little less than Γ = ρ₀/C at μ₀; x stands for Λε². *)

Require Import Reals Lra Lia Psatz.
From Delcert Require Import vectors sharper_constraints.
Open Scope R_scope.

(** Bernoulli's inequality. *)
Lemma power_of_nearly_one d n : 0 <= d <= 1 -> 1 - INR n * d <= (1 - d) ^ n.
Proof.
  intros Hd; induction n as [|n IH]; [simpl; lra |].
  rewrite S_INR, <- tech_pow_Rmult; pose proof (pos_INR n).
  assert (0 <= (1 - d) ^ n) by (apply pow_le; lra).
  destruct (Rle_dec 0 (1 - INR n * d)) as [P|N].
  - assert ((1 - d) * (1 - INR n * d) <= (1 - d) * (1 - d) ^ n) by (apply Rmult_le_compat_l; lra).
    assert (0 <= INR n * (d * d)) by (apply Rmult_le_pos; nra); nra.
  - assert (0 <= (1 - d) * (1 - d) ^ n) by (apply Rmult_le_pos; lra); lra.
Qed.

Lemma below_power_of_two n : INR n <= 2 ^ n.
Proof.
  induction n as [|n IH]; [simpl; lra |]; rewrite S_INR, <- tech_pow_Rmult.
  assert (1 <= 2 ^ n) by (apply pow_R1_Rle; lra); lra.
Qed.

(** A factor that is polynomial in m is nothing against a power of Γ. *)
Lemma small_against_powers m g : (1 <= m)%nat -> 0 < g <= / 2 ^ 32 ->
  INR (flake_exponent m * (2 * m + 2)) * g ^ (2 * m + 2) <= 1 / 1000.
Proof.
  intros Hm Hg; set (n := (2 * m + 2)%nat); replace (2 ^ 32) with 4294967296 in Hg by ring.
  assert (Poly : (flake_exponent m * n <= 6 * (n * n * n))%nat) by (unfold flake_exponent, n; nia).
  apply le_INR in Poly; rewrite (mult_INR 6), !mult_INR in Poly; simpl (INR 6) in Poly.
  pose proof (below_power_of_two n) as B; pose proof (pos_INR n) as N.
  assert (P : 0 < g ^ n) by (apply pow_lt; lra).
  assert (C : INR n * INR n * INR n * g ^ n <= (8 * g) ^ n).
  { rewrite Rpow_mult_distr; apply Rmult_le_compat_r; [lra |].
    replace 8 with (2 * 2 * 2) by ring; rewrite !Rpow_mult_distr.
    apply Rmult_le_compat; try lra; [nra | apply Rmult_le_compat; lra]. }
  assert (D : (8 * g) ^ n <= (8 * g) ^ 2).
  { replace n with (2 + (n - 2))%nat by (unfold n; lia); rewrite pow_add.
    assert (H0 : 0 <= (8 * g) ^ 2) by (apply pow_le; lra).
    rewrite <- (Rmult_1_r ((8 * g) ^ 2)) at 2; apply Rmult_le_compat_l; [exact H0 |].
    rewrite <- (pow1 (n - 2)); apply pow_incr; lra. }
  assert (E : (8 * g) ^ 2 <= 1 / 12000).
  { replace ((8 * g) ^ 2) with (8 * g * (8 * g)) by ring.
    assert (8 * g * (8 * g) <= 1 / 120 * (1 / 120)) by (apply Rmult_le_compat; lra); lra. }
  rewrite mult_INR; apply Rle_trans with (6 * (INR n * INR n * INR n) * g ^ n); [apply Rmult_le_compat_r; lra | lra].
Qed.

Section Exponential_charts.
Variables (m : nat) (mu rho d x : R).
Hypothesis dimension : (1 <= m)%nat.
Hypothesis separation : 0 < mu <= 1.
Hypothesis perturbation : 0 < rho <= mu / 5.
Let g : R := rho * (mu / 2) ^ flake_exponent m.
(** Γ₀ of the charts. *)
Let g0 : R := rho * ((1 - d) * mu / 2) ^ flake_exponent m.
(** ε ≤ Γ^(m + 1)/(2⁵ √Λ). *)
Hypothesis radius : 0 <= x <= g ^ (2 * m + 2) / 2 ^ 10.
(** 1 − d is the separation in the charts, relative to μ₀. *)
Hypothesis loss : 0 <= d <= 60 * x.

Lemma flake_parameter_in_charts : 0 < g <= mu * mu / 2 ^ 32.
Proof. apply flake_parameter_is_small; trivial; lra. Qed.

Lemma little_is_lost : g0 = g * (1 - d) ^ flake_exponent m.
Proof.
  unfold g0, g; replace ((1 - d) * mu / 2) with ((1 - d) * (mu / 2)) by field; rewrite Rpow_mult_distr; ring.
Qed.

Lemma loss_of_powers k : (k <= flake_exponent m * (2 * m + 2))%nat -> 999 / 1000 <= (1 - d) ^ k.
Proof.
  intros Hk; pose proof flake_parameter_in_charts as G.
  assert (G1 : 0 < g <= / 2 ^ 32) by (split; [lra |]; assert (mu * mu <= 1) by nra; simpl in *; lra).
  pose proof (small_against_powers m g dimension G1) as S.
  set (n := (flake_exponent m * (2 * m + 2))%nat) in *; set (h := g ^ (2 * m + 2)) in *.
  assert (H0 : 0 < h) by (apply pow_lt; lra).
  replace (2 ^ 10) with 1024 in radius by ring.
  assert (D : 0 <= d <= h) by lra.
  assert (N1 : 1 <= INR n) by (change 1 with (INR 1); apply le_INR; unfold n, flake_exponent; nia).
  assert (D1 : 0 <= d <= 1) by nra.
  assert (K : INR k * d <= INR n * h) by (apply Rmult_le_compat; [apply pos_INR | lra | now apply le_INR | lra]).
  pose proof (power_of_nearly_one d k D1); lra.
Qed.

(** Hypotheses 2♯ in the charts: their distortion is at most ½Λr², r = 10ε_i, ε_i ≤ 101/100 ε. *)
Theorem distortion_of_exponential_charts : 1 / 2 * (10 * (101 / 100)) ^ 2 * x <= g0 ^ (2 * m + 2) / 2 ^ 4.
Proof.
  replace ((10 * (101 / 100)) ^ 2) with (10201 / 100) by field.
  rewrite little_is_lost, Rpow_mult_distr, <- pow_mult.
  pose proof (loss_of_powers (flake_exponent m * (2 * m + 2)) (Nat.le_refl _)) as L.
  pose proof flake_parameter_in_charts as G.
  set (h := g ^ (2 * m + 2)) in *; assert (0 < h) by (apply pow_lt; lra).
  assert (h * (999 / 1000) <= h * (1 - d) ^ (flake_exponent m * (2 * m + 2))) by (apply Rmult_le_compat_l; lra).
  replace (2 ^ 10) with 1024 in radius by ring; replace (2 ^ 4) with 16 by ring; lra.
Qed.

(** The stars are 99/100 Γ^m-thick in tangent spaces, and their radius 5/2 ε is small enough for the triangulation theorem. *)
Theorem thickness_in_tangent_spaces : 999 / 1000 * g ^ m <= g0 ^ m.
Proof.
  rewrite little_is_lost, Rpow_mult_distr, <- pow_mult, Rmult_comm.
  apply Rmult_le_compat_l; [apply pow_le; pose proof flake_parameter_in_charts; lra |].
  apply loss_of_powers; apply Nat.mul_le_mono_l; lia.
Qed.

Theorem radius_of_stars_on_the_manifold : (5 / 2) ^ 2 * x <= (99 / 100 * g ^ m / 6) ^ 2.
Proof.
  pose proof flake_parameter_in_charts as G; assert (M : mu * mu <= 1) by nra.
  assert (P : g ^ (2 * m + 2) = g ^ m * g ^ m * (g * g)).
  { replace (2 * m + 2)%nat with (m + m + 2)%nat by lia; rewrite !pow_add; simpl; ring. }
  rewrite P in radius; set (h := g ^ m) in *; assert (0 < h) by (apply pow_lt; lra).
  assert (0 < h * h) by nra; assert (G2 : g * g <= 1) by (simpl in *; nra).
  assert (h * h * (g * g) <= h * h * 1) by (apply Rmult_le_compat_l; lra).
  replace (2 ^ 10) with 1024 in radius by ring.
  replace ((5 / 2) ^ 2) with (25 / 4) by field; replace ((99 / 100 * h / 6) ^ 2) with (9801 / 360000 * (h * h)) by field; lra.
Qed.

(** The piecewise flat metric, 50Λh²/t₀² with h = 12/5 · 1001/1000 ε. *)
Theorem metric_of_the_triangulation :
  50 * (12 / 5 * (1001 / 1000)) ^ 2 * x / (99 / 100 * g ^ m) ^ 2 <= 320 * x / g ^ (2 * m).
Proof.
  pose proof flake_parameter_in_charts as G; assert (P : 0 < g ^ m) by (apply pow_lt; lra).
  replace (2 * m)%nat with (m + m)%nat by lia; rewrite pow_add; set (h := g ^ m) in *.
  assert (Q : 0 < h * h) by nra.
  replace (50 * (12 / 5 * (1001 / 1000)) ^ 2 * x / (99 / 100 * h) ^ 2)
    with (50 * (12 / 5 * (1001 / 1000)) ^ 2 / (99 / 100) ^ 2 * x / (h * h)) by (field; lra).
  unfold Rdiv at 1 5; apply Rmult_le_compat_r; [left; now apply Rinv_0_lt_compat |].
  apply Rmult_le_compat_r; [lra |]; simpl; lra.
Qed.

(** Self-Delaunay, for ε ≤ Γ^(2m + 1)/(2⁵ √Λ): both metrics together are within the bound of η in thm:output.del.cplx. *)
Theorem self_delaunay_metric : x <= (g ^ (2 * m + 1)) ^ 2 / 2 ^ 10 ->
  320 * x / g ^ (2 * m) + 1 / 5 * (10 * (101 / 100)) ^ 2 * x <= g0 ^ (2 * m + 1) * ((1 - d) * mu) ^ 2 / 2 ^ 12 / 2.
Proof.
  intros X; pose proof flake_parameter_in_charts as G; assert (M : 0 < mu * mu <= 1) by nra.
  replace ((10 * (101 / 100)) ^ 2) with (10201 / 100) by field.
  rewrite little_is_lost, (Rpow_mult_distr g), <- pow_mult.
  pose proof (loss_of_powers (flake_exponent m * (2 * m + 1)) ltac:(apply Nat.mul_le_mono_l; lia)) as L.
  pose proof (loss_of_powers 2 ltac:(unfold flake_exponent; nia)) as L2.
  assert (P : g ^ (2 * m + 1) = g ^ (2 * m) * g) by (rewrite pow_add; simpl; ring).
  set (k := g ^ (2 * m)) in *; set (l := (1 - d) ^ (flake_exponent m * (2 * m + 1))) in *.
  assert (K : 0 < k <= 1).
  { split; [apply pow_lt; lra |]; unfold k; rewrite <- (pow1 (2 * m)); apply pow_incr; simpl in *; lra. }
  rewrite (Rpow_mult_distr (1 - d)); set (l2 := (1 - d) ^ 2) in *; clearbody k l l2.
  rewrite P in *; replace (2 ^ 10) with 1024 in X by ring; replace ((k * g) ^ 2) with (k * k * (g * g)) in X by ring.
  assert (K1 : 320 * x / k <= 320 / 1024 * (k * (g * g))).
  { apply quotient_at_most; [lra |]; lra. }
  assert (K2 : 1 / 5 * (10201 / 100) * x <= 21 / 1024 * (k * (g * g))).
  { assert (k * k * (g * g) <= 1 * k * (g * g)) by (apply Rmult_le_compat_r; nra).
    lra. }
  assert (KG : 0 < k * g) by (apply Rmult_lt_0_compat; lra).
  assert (F : k * (g * g) <= k * g * (mu * mu / 2 ^ 32)).
  { replace (k * (g * g)) with (k * g * g) by ring; apply Rmult_le_compat_l; lra. }
  assert (LL : 99 / 100 <= l * l2).
  { apply Rle_trans with (999 / 1000 * (999 / 1000)); [lra | apply Rmult_le_compat; lra]. }
  replace (k * g * l * (l2 * mu ^ 2) / 2 ^ 12 / 2) with (k * g * (mu * mu) * (l * l2) / 8192) by (simpl; field).
  assert (Q : 0 < k * g * (mu * mu)) by (apply Rmult_lt_0_compat; lra).
  assert (k * g * (mu * mu) * (99 / 100) <= k * g * (mu * mu) * (l * l2)) by (apply Rmult_le_compat_l; lra).
  simpl in F; lra.
Qed.
End Exponential_charts.
