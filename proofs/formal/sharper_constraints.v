(** Hypotheses 2 with the exponent 2m + 2, and C without m^(3/2): what Theorems 1 and 2 ask of the distortion ξ₀ follows
    from ξ₀ ≤ 2⁻⁴ Γ₀^(2m + 2), Γ₀ = ρ₀/C, C = (2/μ₀)^(4m² + 5m + 21). *)

Require Import Reals Lra Lia Psatz.
Open Scope R_scope.

Definition flake_exponent (m : nat) : nat := (4 * m * m + 5 * m + 21)%nat.

Section Constraints.
Variables (m : nat) (mu rho xi : R).
Hypothesis dimension : (1 <= m)%nat.
Hypothesis separation : 0 < mu <= 1.
Hypothesis perturbation : 0 < rho <= mu / 4.

(** Γ₀ = ρ₀/C. *)
Let g : R := rho * (mu / 2) ^ flake_exponent m.
Hypothesis distortion : 0 <= xi <= g ^ (2 * m + 2) / 2 ^ 4.

Lemma power_of_half : 0 < (mu / 2) ^ flake_exponent m <= mu / 2 ^ 30.
Proof.
  assert (E : exists n, flake_exponent m = (S n + 29)%nat).
  { exists (flake_exponent m - 30)%nat; unfold flake_exponent; nia. }
  destruct E as (n & ->); rewrite pow_add, <- tech_pow_Rmult.
  assert (H : 0 < (mu / 2) ^ n <= 1).
  { split; [apply pow_lt; lra |]; rewrite <- (pow1 n); apply pow_incr; lra. }
  assert (K : 0 < (mu / 2) ^ 29 <= / 2 ^ 29).
  { split; [apply pow_lt; lra |].
    replace (/ 2 ^ 29) with ((/ 2) ^ 29) by (rewrite pow_inv by lra; reflexivity); apply pow_incr; lra. }
  split; [repeat apply Rmult_lt_0_compat; lra |].
  apply Rle_trans with (mu / 2 * 1 * / 2 ^ 29).
  - apply Rmult_le_compat; try lra; [apply Rmult_le_pos; lra | apply Rmult_le_compat_l; lra].
  - simpl; lra.
Qed.

Theorem flake_parameter_is_small : 0 < g <= mu * mu / 2 ^ 32.
Proof.
  pose proof power_of_half as H; unfold g; split; [apply Rmult_lt_0_compat; lra |].
  apply Rle_trans with (mu / 4 * (mu / 2 ^ 30)); [apply Rmult_le_compat; lra | simpl; lra].
Qed.

(** The hypotheses of lem:prop.forbid.cfg. *)
Theorem flake_parameter_of_forbidden_configurations : g <= 2 * mu ^ 2 / 75.
Proof. pose proof flake_parameter_is_small as H; simpl in *; nra. Qed.

(** That of the sharper lem:hoop.distort, for diametric spheres and for circumspheres. *)
Theorem distortion_of_hoops : xi <= g ^ (m + 1) / 4 * (g ^ (m + 1) / 4).
Proof.
  replace (g ^ (m + 1) / 4 * (g ^ (m + 1) / 4)) with (g ^ (2 * m + 2) / 2 ^ 4); [lra |].
  replace (2 * m + 2)%nat with ((m + 1) + (m + 1))%nat by lia; rewrite pow_add; simpl; field.
Qed.

(** Those of lem:stable.stars and, for η in the place of ξ₀, of thm:output.del.cplx. *)
Theorem distortion_of_stable_stars : xi <= g ^ (2 * m + 1) * mu ^ 2 / 2 ^ 12.
Proof.
  pose proof flake_parameter_is_small as (G0 & G).
  apply Rle_trans with (g ^ (2 * m + 2) / 2 ^ 4); [lra |].
  replace (2 * m + 2)%nat with (S (2 * m + 1)) by lia; rewrite <- tech_pow_Rmult.
  assert (P : 0 < g ^ (2 * m + 1)) by (now apply pow_lt).
  assert (Q : g * g ^ (2 * m + 1) <= mu * mu / 2 ^ 32 * g ^ (2 * m + 1)) by (apply Rmult_le_compat_r; lra).
  assert (0 < mu * mu * g ^ (2 * m + 1)) by (apply Rmult_lt_0_compat; nra).
  simpl in *; nra.
Qed.

(** The tolerance 2α̃₀, relative to ρ₀, is below the printed one, 2¹⁷ (μ₀/2)^E/μ₀³: what is proved of termination holds. *)
Theorem tolerance_is_smaller : 2 * (17410 * g / mu ^ 3) <= 2 ^ 17 * (mu / 2) ^ flake_exponent m / mu ^ 3 * rho.
Proof.
  pose proof power_of_half as (H & _); set (c := (mu / 2) ^ flake_exponent m) in *.
  assert (M : 0 < mu ^ 3) by (apply pow_lt; lra).
  unfold g; fold c.
  replace (2 * (17410 * (rho * c) / mu ^ 3)) with (34820 * (c / mu ^ 3 * rho)) by (field; lra).
  replace (2 ^ 17 * c / mu ^ 3 * rho) with (131072 * (c / mu ^ 3 * rho)) by (simpl; field; lra).
  assert (0 < c / mu ^ 3 * rho) by (apply Rmult_lt_0_compat; [now apply Rdiv_lt_0_compat | lra]); lra.
Qed.
End Constraints.
