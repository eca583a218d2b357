(** Nets in any metric space: what a perturbation leaves of density and separation, sampling radii that are Lipschitz
    functions, and the bookkeeping of lem:loc.eucl.protect and lem:inclusion.star.equivalences. *)

Require Import Reals Lra Psatz.
Open Scope R_scope.

Section MetricSpace.
Variable X : Type.
Variable dist : X -> X -> R.
Hypothesis dist_sym : forall x y, dist x y = dist y x.
Hypothesis dist_triangle : forall x y z, dist x z <= dist x y + dist y z.

(** A family of points, indexed by their labels. *)
Variable label : Type.
Definition dense (domain : X -> Prop) (p : label -> X) (e : R) : Prop :=
  forall x, domain x -> exists i, dist x (p i) < e.
Definition separated (p : label -> X) (s : R) : Prop := forall i j, i <> j -> s <= dist (p i) (p j).
Definition perturbation (p q : label -> X) (r : R) : Prop := forall i, dist (q i) (p i) <= r.

(** A (μ₀, ε)-net that is perturbed by at most ρ̃₀ε is a (μ₀′, ε′)-net: ε′ = (1 + ρ̃₀) ε and μ₀′ = (μ₀ − 2ρ̃₀)/(1 + ρ̃₀),
    and ε′ ≤ 5/4 ε, μ₀′ ≥ 2/5 μ₀ (section 2, lem:loc.eucl.protect). *)
Theorem perturbed_net domain p q e mu rho :
  0 < e -> 0 < mu <= 1 -> 0 <= rho <= mu / 4 ->
  dense domain p e -> separated p (mu * e) -> perturbation p q (rho * e) ->
  let e' := (1 + rho) * e in
  let mu' := (mu - 2 * rho) / (1 + rho) in
  dense domain q e' /\ separated q (mu' * e') /\ e' <= 5 / 4 * e /\ 2 / 5 * mu <= mu'.
Proof.
  intros He Hmu Hrho Hdense Hseparated Hq e' mu'; unfold e', mu'; repeat split.
  - intros x Hx; destruct (Hdense x Hx) as [i Hi]; exists i.
    pose proof (dist_triangle x (p i) (q i)); pose proof (Hq i) as P; rewrite dist_sym in P; lra.
  - intros i j D.
    replace ((mu - 2 * rho) / (1 + rho) * ((1 + rho) * e)) with (mu * e - 2 * (rho * e)) by (field; lra).
    pose proof (Hseparated i j D); pose proof (Hq i) as P; pose proof (Hq j).
    pose proof (dist_triangle (p i) (q i) (p j)); pose proof (dist_triangle (q i) (q j) (p j)).
    rewrite dist_sym in P; lra.
  - apply Rmult_le_compat_r; lra.
  - apply Rmult_le_reg_r with (1 + rho); [lra |].
    replace ((mu - 2 * rho) / (1 + rho) * (1 + rho)) with (mu - 2 * rho) by (field; lra); nra.
Qed.

(** Adaptive sampling: for a ν-Lipschitz sampling radius ε the points are ε̃-dense in the ball of radius cε̃ about x₀,
    with ε̃ = ε(x₀)/(1 − cν); there ε̃ changes by at most ε₀ε̃ with ε₀ = cν/(1 − cν) (eq:geom.lipsam). *)
Section Adaptive.
Variable radius : X -> R.
Variables nu c : R.
Hypothesis nu_nonneg : 0 <= nu.
Hypothesis lipschitz : forall x y, Rabs (radius x - radius y) <= nu * dist x y.
Hypothesis small : 0 < c /\ c * nu < 1.
Definition local_radius (x : X) : R := radius x / (1 - c * nu).

Theorem density_in_a_ball p x0 :
  (forall x, exists i : label, dist x (p i) < radius x) -> dense (fun x => dist x x0 <= c * local_radius x0) p (local_radius x0).
Proof.
  intros H x Hx; destruct (H x) as [i Hi]; exists i; eapply Rlt_le_trans; [exact Hi |].
  pose proof (lipschitz x x0) as L; pose proof (Rle_abs (radius x - radius x0)).
  assert (nu * dist x x0 <= nu * (c * local_radius x0)) by (apply Rmult_le_compat_l; trivial).
  assert (E : radius x0 = (1 - c * nu) * local_radius x0) by (unfold local_radius; field; lra); nra.
Qed.

Theorem radius_variation x y :
  dist x y <= c * local_radius x -> Rabs (local_radius x - local_radius y) <= c * nu / (1 - c * nu) * local_radius x.
Proof.
  intros H; pose proof (lipschitz x y) as L; unfold local_radius at 1 2.
  replace (radius x / (1 - c * nu) - radius y / (1 - c * nu)) with ((radius x - radius y) * / (1 - c * nu)) by (field; lra).
  assert (I : 0 < / (1 - c * nu)) by (apply Rinv_0_lt_compat; lra).
  rewrite Rabs_mult, (Rabs_pos_eq (/ _)) by lra.
  replace (c * nu / (1 - c * nu) * local_radius x) with (nu * (c * local_radius x) * / (1 - c * nu)) by (field; lra).
  apply Rmult_le_compat_r; [lra |]; eapply Rle_trans; [exact L |]; now apply Rmult_le_compat_l.
Qed.
End Adaptive.
End MetricSpace.

(** Distortion in both directions: |d − d̃| ≤ ξ min(d, d̃) if it is so for the map and for its inverse. *)
Theorem symmetric_distortion xi d d' :
  Rabs (d - d') <= xi * d -> Rabs (d' - d) <= xi * d' -> Rabs (d - d') <= xi * Rmin d d'.
Proof. intros A B; rewrite Rabs_minus_sym in B; unfold Rmin; destruct Rle_dec; trivial. Qed.

(** eq:chart.change.bnd: (1 + ε₀)(1 + ξ₀) ≤ 2 by eq:lipsambnd, so ρ̃₀ ≤ 2ρ₀, and a perturbation by ρ₀ε_i in the chart i is
    one by ρ̃₀ε_j in the chart j. *)
Theorem chart_change e0 xi rho ei ej di dj :
  0 <= xi -> 0 <= rho -> 0 < ei -> 0 < ej -> 0 <= di -> 0 <= e0 -> e0 <= (1 - xi) / (1 + xi) ->
  di <= rho * ei ->
  Rabs (di - dj) <= xi * di -> Rabs (ei - ej) <= e0 * Rmin ei ej ->
  (1 + e0) * (1 + xi) <= 2 /\ dj <= (1 + e0) * (1 + xi) * rho * ej.
Proof.
  intros Hxi Hrho Hei Hej Hdi Hpos He0 Hi Hd He.
  assert (e1 : 0 <= 1 + xi) by lra.
  assert (e2 : e0 * (1 + xi) <= 1 - xi).
  { replace (1 - xi) with ((1 - xi) / (1 + xi) * (1 + xi)) by (field; lra); now apply Rmult_le_compat_r. }
  split; [lra |].
  assert (e3 : ei <= (1 + e0) * ej).
  { unfold Rmin in He; destruct Rle_dec in He; unfold Rabs in He; destruct Rcase_abs in He; nra. }
  assert (e4 : dj <= (1 + xi) * di) by (unfold Rabs in Hd; destruct Rcase_abs in Hd; lra).
  apply Rle_trans with ((1 + xi) * (rho * ei)); [nra |].
  replace ((1 + e0) * (1 + xi) * rho * ej) with ((1 + xi) * (rho * ((1 + e0) * ej))) by ring.
  apply Rmult_le_compat_l; trivial; now apply Rmult_le_compat_l.
Qed.
