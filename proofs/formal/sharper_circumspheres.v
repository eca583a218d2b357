(** The hoop property for circumspheres S(σ), the spheres in the affine hulls, as the printed algorithm needs it where it
    tests m-simplices only: a point within αR of S(σ) has its image within (α + 9 √ξ/Υ) R of S(σ̃). The circumcentre
    need not be in the domain of the map. *)

Require Import Reals Lra Lia Psatz.
From Delcert Require Import vectors simplices distortion circumradius weights projections circumcentres
  sharper_thickness sharper_circumradius sharper_balls sharper_hoops.
Open Scope R_scope.

(** Some point of the circumsphere, of centre Σ c_j p_j and radius r, is at most a from z. *)
Definition near_circumsphere (m k : nat) (z : vector) (p : simplex) (c : vector) (r a : R) : Prop :=
  exists b, sum (S k) b = 1 /\ distance m (combination k b p) (combination k c p) = r /\
            distance m z (combination k b p) <= a.

(** The point of the circumsphere next to a point of the affine hull that is not the centre. *)
Lemma circumsphere_near_a_point n k q e u b w g :
  sum (S k) e = 1 -> sum (S k) b = 1 -> 0 <= u -> 0 < distance n (combination k b q) (combination k e q) ->
  distance n w (combination k b q) <= g ->
  near_circumsphere n k w q e u (g + Rabs (distance n (combination k b q) (combination k e q) - u)).
Proof.
  intros e1 b1 Hu Hf Hg; set (f := distance n (combination k b q) (combination k e q)) in *; set (l := u / f).
  assert (L : l * f = u) by (unfold l; field; lra).
  assert (L0 : 0 <= l) by (now apply quotient_nonneg).
  exists (fun j => e j + l * (b j - e j)).
  assert (C : forall a, combination k (fun j => e j + l * (b j - e j)) q a
                        = combination k e q a + l * (combination k b q a - combination k e q a)).
  { intros a; unfold combination.
    rewrite (sum_ext (S k) _ (fun j => e j * q j a + (l * (b j * q j a) - l * (e j * q j a)))) by (intros; ring).
    rewrite sum_plus, sum_minus, !sum_scal; ring. }
  repeat split.
  - rewrite sum_plus, sum_scal, sum_minus, e1, b1; ring.
  - rewrite <- L; unfold f, distance; rewrite <- norm_scal by trivial.
    apply norm_ext; intros a _; unfold minus; rewrite C; ring.
  - eapply Rle_trans; [apply (distance_triangle n w (combination k b q)) |]; apply Rplus_le_compat; trivial.
    apply le_of_squares; [apply Rabs_pos |].
    replace (Rabs (f - u) * Rabs (f - u)) with ((1 - l) * (1 - l) * (f * f)).
    + unfold f; rewrite !distance_squared, <- sum_scal; right; apply sum_ext; intros a _; rewrite C; ring.
    + replace ((1 - l) * (1 - l) * (f * f)) with ((f - l * f) * (f - l * f)) by ring.
      rewrite L; unfold Rabs; destruct Rcase_abs; ring.
Qed.

Lemma circumsphere_terms alpha a s :
  0 <= alpha -> 0 <= s -> 0 <= a <= 33 / 16 * (s * s) ->
  alpha * alpha + 33 / 2 * a <= (alpha + 6 * s) * (alpha + 6 * s).
Proof. intros; assert (0 <= alpha * s) by (apply Rmult_le_pos; lra); nra. Qed.

(** z is the point, w its image; of the map only the distances between these and the vertices are used. *)
Theorem circumsphere_under_small_distortion m n k p q d t xi c r e u z w alpha :
  (1 <= k)%nat -> 0 < d -> 0 < t -> 0 <= xi <= t / 4 * (t / 4) -> 0 <= alpha <= 1 / 2 ->
  edges_at_most m k p d -> is_thick m k p d t -> edges_differ_at_most m n k p q (xi * d) ->
  is_circumcentre m k p c r -> is_circumcentre n k q e u ->
  near_circumsphere m k z p c r (alpha * r) ->
  (forall i, (i <= k)%nat -> Rabs (distance m (p i) z - distance n (q i) w) <= xi * distance m (p i) z) ->
  near_circumsphere n k w q e u ((alpha + 9 * (sqrt xi / t)) * r).
Proof.
  intros Hk Hd Ht Hx Hal He Hthick Hdiffer Hc Hu (b & b1 & Hb & Hz) Hw.
  pose proof (thickness_at_most_one m k p d t Hk Hd He Hthick) as T.
  pose proof (dimension_positive k Hk) as K; pose proof (vertex_share_range k Hk) as V.
  destruct (strain_range k xi t Hk (conj Ht T) Hx) as (X & Hs & Ha).
  pose proof (relative_change_nonneg k xi t Hk (proj1 Hx) Ht) as A0.
  pose proof (circumscribed_radius_nonneg n k q _ u (proj2 Hu)) as u0.
  pose proof (edges_of_thick_simplices m k p d t _ r Hk ltac:(nra) Hthick (proj2 Hc)) as r0.
  assert (TD : 0 < t * d) by (now apply Rmult_lt_0_compat).
  pose proof (crude_circumradius_bound m k p d t r Hk Hd Ht He Hthick (ex_intro _ c Hc)) as R0.
  pose proof (squared_circumradius_from_below m n k p q d t xi c r _ u Hk Hd Ht (proj1 Hx) He Hthick Hdiffer Hc
                (proj2 Hu)) as L.
  (* the point of the circumsphere: within 2R of every vertex *)
  assert (B2 : forall i, (i <= k)%nat -> distance m (combination k b p) (p i) <= 2 * r).
  { intros i Hi; pose proof (distance_triangle m (combination k b p) (combination k c p) (p i)) as D.
    rewrite Hb, (distance_sym m (combination k c p) (p i)), (proj2 Hc i Hi) in D; lra. }
  assert (A : 0 < INR k * t * d) by (rewrite Rmult_assoc; apply Rmult_lt_0_compat; lra).
  assert (G : forall i, (i <= k)%nat -> Rabs (b i) <= 2 * r / (INR k * t * d)).
  { intros i Hi; apply at_most_quotient; trivial; now apply (weight_within m k p b i); auto. }
  pose proof (spread_under_distortion m n k p q b d t xi (2 * r) Hk Hd Ht (proj1 Hx) He Hdiffer G) as S1.
  rewrite (spread_in_a_ball m k p _ r b b1 (proj2 Hc)), Hb in S1.
  pose proof (spread_in_a_ball n k q _ u b b1 (proj2 Hu)) as S2.
  (* the image of the point *)
  pose proof (lagrange m k b p z b1) as L1; rewrite (spread_in_a_ball m k p _ r b b1 (proj2 Hc)), Hb in L1.
  pose proof (lagrange n k b q w b1) as L2.
  assert (F : forall i, (i <= k)%nat ->
    Rabs ((distance n (q i) w * distance n (q i) w - distance m (p i) z * distance m (p i) z) - 0)
    <= (2 + xi) * xi * (5 / 2 * r * (5 / 2 * r))).
  { intros i Hi; rewrite Rminus_0_r.
    assert (D : distance m (p i) z <= 5 / 2 * r).
    { pose proof (distance_triangle m (p i) (combination k b p) z) as D.
      rewrite (distance_sym m (p i) (combination k b p)), (distance_sym m (combination k b p) z) in D.
      specialize (B2 i Hi); assert (alpha * r <= 1 / 2 * r) by (apply Rmult_le_compat_r; lra); lra. }
    apply difference_of_squares; try apply norm_nonneg; [|lra |].
    - split; [apply norm_nonneg | trivial].
    - eapply Rle_trans; [now apply Hw |]; apply Rmult_le_compat_l; lra. }
  pose proof (weighted_sum_near k b _ 0 _ _ G F) as W; cbv beta in W.
  rewrite (sum_ext (S k) _ (fun i => b i * (distance n (q i) w * distance n (q i) w)
                                     - b i * (distance m (p i) z * distance m (p i) z))) in W by (intros; ring).
  rewrite sum_minus, L1, L2, b1, S2 in W; rewrite S2 in S1; clear L1 L2 F G B2 Hw.
  assert (W2 : (INR k + 1) * (2 * r / (INR k * t * d) * ((2 + xi) * xi * (5 / 2 * r * (5 / 2 * r))))
               <= 25 / 2 * relative_change k xi t * (r * r)).
  { replace ((INR k + 1) * (2 * r / (INR k * t * d) * ((2 + xi) * xi * (5 / 2 * r * (5 / 2 * r)))))
      with (r * (25 * t / d * relative_change k xi t * (r * r)))
      by (unfold relative_change, vertex_share; field; lra).
    replace (25 / 2 * relative_change k xi t * (r * r)) with (d / (2 * t) * (25 * t / d * relative_change k xi t * (r * r)))
      by (field; lra).
    apply Rmult_le_compat_r; trivial; apply Rmult_le_pos; [|apply Rle_0_sqr].
    apply Rmult_le_pos; [apply quotient_nonneg; lra | trivial]. }
  set (s := sqrt xi / t).
  assert (q0 : 0 <= sqrt xi <= t / 4).
  { split; [apply sqrt_pos |]; rewrite <- (sqrt_square (t / 4)) by lra; apply sqrt_le_1_alt; lra. }
  assert (s0 : 0 <= s <= 1 / 4) by (unfold s; split; [apply quotient_nonneg | apply quotient_at_most]; lra).
  assert (ss : strain k xi t <= s * s).
  { replace (s * s) with (1 * xi / (t * t)) by (unfold s; rewrite <- (sqrt_sqrt xi) at 1 by lra; field; lra).
    unfold strain; apply quotient_at_most; [nra |].
    replace (1 * xi / (t * t) * (t * t)) with (1 * xi) by (field; lra); apply Rmult_le_compat_r; lra. }
  set (a := relative_change k xi t) in *.
  set (f := distance n (combination k b q) (combination k e q)) in *.
  assert (f0 : 0 <= f) by apply norm_nonneg.
  assert (Z0 : 0 <= distance m (combination k b p) z) by apply norm_nonneg.
  rewrite (distance_sym m z) in Hz.
  assert (ff : distance n (combination k b q) w <= (alpha + 6 * s) * r).
  { apply le_of_squares; [apply Rmult_le_pos; lra |].
    apply Rle_trans with ((alpha * alpha + 33 / 2 * a) * (r * r)).
    - assert (distance m (combination k b p) z * distance m (combination k b p) z <= alpha * r * (alpha * r))
        by (apply Rmult_le_compat; lra).
      unfold Rabs in W, S1; destruct Rcase_abs, Rcase_abs; lra.
    - pose proof (circumsphere_terms alpha a s (proj1 Hal) (proj1 s0) ltac:(lra)) as C.
      replace ((alpha + 6 * s) * r * ((alpha + 6 * s) * r)) with ((alpha + 6 * s) * (alpha + 6 * s) * (r * r)) by ring.
      apply Rmult_le_compat_r; [apply Rle_0_sqr | trivial]. }
  assert (U : 12 / 13 * r <= u).
  { apply le_of_squares; trivial; eapply Rle_trans; [|exact L].
    replace (12 / 13 * r * (12 / 13 * r)) with (144 / 169 * (r * r)) by field.
    apply Rmult_le_compat_r; [apply Rle_0_sqr | lra]. }
  assert (E : Rabs (f - u) <= 9 / 4 * s * r).
  { assert (P : Rabs (f - u) * u <= Rabs (f - u) * (f + u)) by (apply Rmult_le_compat_l; [apply Rabs_pos | lra]).
    assert (Q : Rabs (f - u) * (f + u) <= 4 * a * (r * r)).
    { rewrite <- (Rabs_pos_eq (f + u)) by lra; rewrite <- Rabs_mult.
      replace ((f - u) * (f + u)) with (- (u * u - f * f - (r * r - r * r))) by ring; rewrite Rabs_Ropp; lra. }
    assert (N : 4 * a * (r * r) <= 27 / 13 * s * r * r).
    { assert (a <= 33 / 64 * s) by nra.
      replace (27 / 13 * s * r * r) with (27 / 13 * s * (r * r)) by ring.
      apply Rmult_le_compat_r; [apply Rle_0_sqr | lra]. }
    apply Rmult_le_reg_r with (12 / 13 * r); [lra |].
    apply Rle_trans with (Rabs (f - u) * u); [apply Rmult_le_compat_l; [apply Rabs_pos | trivial] | lra]. }
  assert (f1 : 0 < f).
  { assert (s * r <= 1 / 4 * r) by (apply Rmult_le_compat_r; lra).
    unfold Rabs in E; destruct Rcase_abs; lra. }
  rewrite distance_sym in ff.
  destruct (circumsphere_near_a_point n k q e u b w _ (proj1 Hu) b1 u0 f1 ff) as (b' & B1 & B2 & B3).
  exists b'; repeat split; trivial; eapply Rle_trans; [exact B3 |]; fold f.
  assert (0 <= s * r) by (apply Rmult_le_pos; lra); lra.
Qed.

(** For ξ₀ ≤ (Γ₀^(m + 1)/4)² and a hoop bound α₀ = 2¹³Γ₀/μ₀³ ≤ 1/2: at most 2 · 17410 Γ₀/μ₀³ · ε̃ from the circumsphere. *)
Theorem circumsphere_under_the_sharper_distortion dim m n k p q d g mu xi c r e u z w eps eps0 eps' :
  (1 <= k <= dim)%nat -> 0 < d -> 0 < g <= 1 -> 0 < mu <= 1 -> 0 <= eps0 <= 1 -> 0 <= eps' ->
  0 <= xi <= g ^ (dim + 1) / 4 * (g ^ (dim + 1) / 4) -> 8192 * g / (mu * mu * mu) <= 1 / 2 ->
  edges_at_most m k p d -> is_thick m k p d (g ^ k) -> edges_differ_at_most m n k p q (xi * d) ->
  is_circumcentre m k p c r -> is_circumcentre n k q e u ->
  near_circumsphere m k z p c r (8192 * g / (mu * mu * mu) * r) ->
  (forall i, (i <= k)%nat -> Rabs (distance m (p i) z - distance n (q i) w) <= xi * distance m (p i) z) ->
  r <= 2 * eps -> eps <= (1 + eps0) * eps' ->
  near_circumsphere n k w q e u (2 * (17410 * g / (mu * mu * mu)) * eps').
Proof.
  intros Hk Hd Hg Hmu He0 He' Hx Hal He Hthick Hdiffer Hc Hu Hz Hw Hr Heps.
  destruct (distortion_for_good_facets dim k g xi (proj2 Hk) Hg Hx) as (X & _ & S1).
  pose proof (power_in_unit g k Hg) as G.
  assert (M : 0 < mu * mu * mu <= 1).
  { assert (0 < mu * mu <= 1) by nra; nra. }
  assert (A : 0 <= 8192 * g / (mu * mu * mu)) by (apply quotient_nonneg; lra).
  destruct (circumsphere_under_small_distortion m n k p q d (g ^ k) xi c r e u z w (8192 * g / (mu * mu * mu))
              (proj1 Hk) Hd (proj1 G) (conj (proj1 Hx) X) (conj A Hal) He Hthick Hdiffer Hc Hu Hz Hw) as (b & b1 & B & D).
  exists b; repeat split; trivial; eapply Rle_trans; [exact D |].
  set (h := g / (mu * mu * mu)).
  assert (H : g <= h) by (unfold h; apply at_most_quotient; nra).
  replace (8192 * g / (mu * mu * mu)) with (8192 * h) in * by (unfold h; field; lra).
  replace (17410 * g / (mu * mu * mu)) with (17410 * h) by (unfold h; field; lra).
  set (s := sqrt xi / g ^ k) in *; clearbody h.
  assert (s0 : 0 <= s) by (apply quotient_nonneg; [apply sqrt_pos | lra]); clearbody s.
  apply Rle_trans with ((8192 * h + 9 * s) * (2 * ((1 + eps0) * eps'))); [apply Rmult_le_compat_l; lra |].
  replace ((8192 * h + 9 * s) * (2 * ((1 + eps0) * eps'))) with ((8192 * h + 9 * s) * (1 + eps0) * (2 * eps')) by ring.
  replace (2 * (17410 * h) * eps') with (17410 * h * (2 * eps')) by ring.
  apply Rmult_le_compat_r; [lra |].
  apply Rle_trans with (8705 * h * 2); [|lra].
  apply Rmult_le_compat; lra.
Qed.
