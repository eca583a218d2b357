(** Sharper than lem:raw.hoop.distort and lem:hoop.distort: the distance from the diametric sphere of the image is at most
    (α (1 + ξ) + 11/4 √ξ/Υ) R, where the paper has 12 k^(3/2) √ξ/Γ₀^(2k). Hence ξ₀ ≤ (Γ₀^(m + 1)/4)² suffices, where it
    has Γ₀^(2m + 1), and 17410 Γ₀/μ₀³, where it has 2¹⁶ m^(3/2) Γ₀/μ₀³. *)

Require Import Reals Lra Lia Psatz.
From Delcert Require Import vectors simplices distortion circumradius weights projections circumcentres
  sharper_thickness sharper_circumradius sharper_balls sharper_circumcentre.
Open Scope R_scope.

(** The distance of z from the diametric sphere, about x with radius r, is at most a. *)
Definition near_sphere (m : nat) (z x : vector) (r a : R) : Prop := Rabs (distance m z x - r) <= a.

(** s = √ξ/Υ in what follows. *)
Lemma hoop_terms v xi s :
  1 / 2 <= v <= 1 -> 0 <= s <= 1 / 4 -> 0 <= xi <= s * s -> xi + 17 / 8 * s + 3 / 2 * v * (s * s) <= 11 / 4 * s.
Proof. intros; assert (s * s <= s / 4) by nra; nra. Qed.

(** Sharper lem:raw.hoop.distort. x stands for C(σ), y for its image, z for the vertex p′_i opposite σ, w for its image. *)
Theorem sphere_under_small_distortion m n k p q d t xi c r y e u z w alpha :
  (1 <= k)%nat -> 0 < d -> 0 < t -> 0 <= xi <= t / 4 * (t / 4) -> 0 <= alpha ->
  edges_at_most m k p d -> is_thick m k p d t -> edges_differ_at_most m n k p q (xi * d) ->
  is_circumcentre m k p c r -> nearly_at_distance n k q y r xi -> is_circumcentre n k q e u ->
  near_sphere m z (combination k c p) r (alpha * r) ->
  Rabs (distance n w y - distance m z (combination k c p)) <= xi * distance m z (combination k c p) ->
  near_sphere n w (combination k e q) u ((alpha * (1 + xi) + 11 / 4 * (sqrt xi / t)) * r).
Proof.
  intros Hk Hd Ht Hx Hal He Hthick Hdiffer Hc Hy Hu Hz Hw.
  pose proof (thickness_at_most_one m k p d t Hk Hd He Hthick) as T.
  pose proof (vertex_share_range k Hk) as V.
  pose proof (circumscribed_radius_nonneg m k p _ r (proj2 Hc)) as r0.
  pose proof (circumcentre_under_small_distortion m n k p q d t xi c r y e u Hk Hd Ht Hx He Hthick Hdiffer Hc Hy Hu) as W.
  destruct (circumradius_under_small_distortion m n k p q d t xi r Hk Hd Ht Hx He Hthick Hdiffer (ex_intro _ c Hc))
    as (_ & F); specialize (F u (ex_intro _ e Hu)).
  set (s := sqrt xi / t); set (v := vertex_share k) in *.
  assert (q0 : 0 <= sqrt xi <= t / 4).
  { split; [apply sqrt_pos |]; rewrite <- (sqrt_square (t / 4)) by lra; apply sqrt_le_1_alt; lra. }
  assert (s0 : 0 <= s <= 1 / 4).
  { unfold s; split; [apply quotient_nonneg; lra | apply quotient_at_most; lra]. }
  assert (ss : s * s = xi / (t * t)).
  { unfold s; rewrite <- (sqrt_sqrt xi) at 3 by lra; field; lra. }
  assert (X : 0 <= xi <= s * s).
  { split; [lra |]; rewrite ss; apply at_most_quotient; [nra |].
    rewrite <- (Rmult_1_r xi) at 2; apply Rmult_le_compat_l; nra. }
  replace (9 / 2 * v * xi / (t * t)) with (9 / 2 * v * (xi / (t * t))) in W by (field; lra).
  replace (3 / 2 * v * r * xi / (t * t)) with (3 / 2 * v * r * (xi / (t * t))) in F by (field; lra).
  rewrite <- ss in W, F.
  pose proof (hoop_terms v xi s V s0 X) as H.
  assert (C : distance n (combination k e q) y <= 17 / 8 * s * r).
  { apply le_of_squares; [apply Rmult_le_pos; lra |].
    eapply Rle_trans; [exact W |].
    replace (17 / 8 * s * r * (17 / 8 * s * r)) with (289 / 64 * (s * s) * (r * r)) by field.
    apply Rmult_le_compat_r; nra. }
  unfold near_sphere in *.
  set (a := distance m z _) in *; assert (a0 : 0 <= a) by apply norm_nonneg; clearbody a.
  pose proof (distance_triangle n w y (combination k e q)) as T1.
  pose proof (distance_triangle n w (combination k e q) y) as T2.
  rewrite (distance_sym n y (combination k e q)) in T1.
  set (f := distance n w (combination k e q)) in *; set (g := distance n w y) in *;
    set (b := distance n (combination k e q) y) in *; clearbody f g b s v.
  assert (M : (xi + 17 / 8 * s + 3 / 2 * v * (s * s)) * r <= 11 / 4 * s * r) by (apply Rmult_le_compat_r; trivial).
  assert (Z : - (alpha * r) <= a - r <= alpha * r) by (unfold Rabs in Hz; destruct Rcase_abs; lra).
  assert (Y : - (xi * a) <= g - a <= xi * a) by (unfold Rabs in Hw; destruct Rcase_abs; lra).
  assert (U : - (3 / 2 * v * r * (s * s)) <= u - r <= 3 / 2 * v * r * (s * s))
    by (unfold Rabs in F; destruct Rcase_abs; lra).
  assert (xi * a <= xi * (r + alpha * r)) by (apply Rmult_le_compat_l; lra).
  apply Rabs_le; lra.
Qed.

(** With the sampling radii: R < 2ε and ε ≤ (1 + ε₀) ε̃, ε and ε̃ those of the two patches. *)
Corollary hoop_under_small_distortion m n k p q d g xi c r y e u z w alpha eps eps0 eps' :
  (1 <= k)%nat -> 0 < d -> 0 < g -> 0 <= xi <= g / 4 * (g / 4) -> 0 <= alpha ->
  edges_at_most m k p d -> is_thick m k p d g -> edges_differ_at_most m n k p q (xi * d) ->
  is_circumcentre m k p c r -> nearly_at_distance n k q y r xi -> is_circumcentre n k q e u ->
  near_sphere m z (combination k c p) r (alpha * r) ->
  Rabs (distance n w y - distance m z (combination k c p)) <= xi * distance m z (combination k c p) ->
  r <= 2 * eps -> eps <= (1 + eps0) * eps' ->
  near_sphere n w (combination k e q) u (2 * ((alpha * (1 + xi) + 11 / 4 * (sqrt xi / g)) * (1 + eps0)) * eps').
Proof.
  intros Hk Hd Hg Hx Hal He Hthick Hdiffer Hc Hy Hu Hz Hw Hr Heps.
  eapply Rle_trans;
    [now apply (sphere_under_small_distortion m n k p q d g xi c r y e u z w alpha) |].
  replace (2 * ((alpha * (1 + xi) + 11 / 4 * (sqrt xi / g)) * (1 + eps0)) * eps')
    with ((alpha * (1 + xi) + 11 / 4 * (sqrt xi / g)) * (2 * ((1 + eps0) * eps'))) by ring.
  apply Rmult_le_compat_l; [|lra].
  apply Rplus_le_le_0_compat; [apply Rmult_le_pos; lra |].
  apply Rmult_le_pos; [lra | apply quotient_nonneg; [apply sqrt_pos | trivial]].
Qed.

Lemma power_in_unit g j : 0 < g <= 1 -> 0 < g ^ j <= 1.
Proof.
  intros Hg; induction j as [|j IH]; simpl; [lra |]; split; [now apply Rmult_lt_0_compat |].
  rewrite <- (Rmult_1_r 1); apply Rmult_le_compat; lra.
Qed.

(** If ξ₀ ≤ (Γ₀^(m + 1)/4)², the distortion term is at most 11/16 Γ₀, and ξ₀ ≤ (Γ₀^k/4)². *)
Lemma distortion_for_good_facets m k g xi :
  (k <= m)%nat -> 0 < g <= 1 -> 0 <= xi <= g ^ (m + 1) / 4 * (g ^ (m + 1) / 4) ->
  xi <= g ^ k / 4 * (g ^ k / 4) /\ xi <= 1 / 16 /\ sqrt xi / g ^ k <= g / 4.
Proof.
  intros Hk Hg Hx.
  pose proof (power_in_unit g k Hg) as K; pose proof (power_in_unit g (m - k) Hg) as D.
  assert (E : g ^ (m + 1) = g ^ k * (g ^ (m - k) * g)).
  { replace (m + 1)%nat with (k + ((m - k) + 1))%nat by lia; rewrite !pow_add; ring. }
  assert (F : 0 < g ^ (m - k) * g <= g).
  { split; [now apply Rmult_lt_0_compat |].
    assert (g ^ (m - k) * g <= 1 * g) by (apply Rmult_le_compat_r; lra); lra. }
  assert (G : 0 <= g ^ (m + 1) <= g ^ k * g).
  { rewrite E; split; [apply Rmult_le_pos; lra | apply Rmult_le_compat_l; lra]. }
  assert (Q : sqrt xi <= g ^ k * g / 4).
  { rewrite <- (sqrt_square (g ^ k * g / 4)) by (assert (0 <= g ^ k * g) by lra; lra).
    apply sqrt_le_1_alt; eapply Rle_trans; [apply Hx |]; apply Rmult_le_compat; lra. }
  assert (L : g ^ k * g <= g ^ k) by (rewrite <- (Rmult_1_r (g ^ k)) at 2; apply Rmult_le_compat_l; lra).
  repeat split.
  - eapply Rle_trans; [apply Hx |]; apply Rmult_le_compat; lra.
  - eapply Rle_trans; [apply Hx |]; apply Rle_trans with (1 / 4 * (1 / 4)); [apply Rmult_le_compat; lra | lra].
  - apply quotient_at_most; lra.
Qed.

(** The bound that the extended algorithm tests with. *)
Lemma hoop_constant g mu xi eps0 s :
  0 < g <= 1 -> 0 < mu <= 1 -> 0 <= xi <= 1 / 16 -> 0 <= eps0 <= 1 -> 0 <= s <= g / 4 ->
  (8192 * g / (mu * mu * mu) * (1 + xi) + 11 / 4 * s) * (1 + eps0) <= 17410 * g / (mu * mu * mu).
Proof.
  intros Hg Hmu Hx He Hs.
  assert (M : 0 < mu * mu * mu <= 1).
  { assert (0 < mu * mu <= 1) by nra; nra. }
  set (h := g / (mu * mu * mu)).
  assert (H : g <= h).
  { unfold h; apply at_most_quotient; nra. }
  replace (8192 * g / (mu * mu * mu)) with (8192 * h) by (unfold h; field; lra).
  replace (17410 * g / (mu * mu * mu)) with (17410 * h) by (unfold h; field; lra).
  clearbody h.
  assert (8192 * h * (1 + xi) + 11 / 4 * s <= 8705 * h) by nra.
  assert (0 <= 8192 * h * (1 + xi) + 11 / 4 * s) by (apply Rplus_le_le_0_compat; [apply Rmult_le_pos; lra | lra]).
  nra.
Qed.

(** Sharper lem:hoop.distort: for ξ₀ ≤ (Γ₀^(m + 1)/4)², a facet of dimension k ≤ m that is Γ₀^k-thick and hoop bound
    2¹³Γ₀/μ₀³, the distance is at most 2 · 17410 Γ₀/μ₀³ · ε̃. *)
Theorem hoop_under_the_sharper_distortion dim m n k p q d g mu xi c r y e u z w eps eps0 eps' :
  (1 <= k <= dim)%nat -> 0 < d -> 0 < g <= 1 -> 0 < mu <= 1 -> 0 <= eps0 <= 1 -> 0 <= eps' ->
  0 <= xi <= g ^ (dim + 1) / 4 * (g ^ (dim + 1) / 4) ->
  edges_at_most m k p d -> is_thick m k p d (g ^ k) -> edges_differ_at_most m n k p q (xi * d) ->
  is_circumcentre m k p c r -> nearly_at_distance n k q y r xi -> is_circumcentre n k q e u ->
  near_sphere m z (combination k c p) r (8192 * g / (mu * mu * mu) * r) ->
  Rabs (distance n w y - distance m z (combination k c p)) <= xi * distance m z (combination k c p) ->
  r <= 2 * eps -> eps <= (1 + eps0) * eps' ->
  near_sphere n w (combination k e q) u (2 * (17410 * g / (mu * mu * mu)) * eps').
Proof.
  intros Hk Hd Hg Hmu He0 He' Hx He Hthick Hdiffer Hc Hy Hu Hz Hw Hr Heps.
  destruct (distortion_for_good_facets dim k g xi (proj2 Hk) Hg Hx) as (X & X' & S).
  pose proof (power_in_unit g k Hg) as G.
  assert (M : 0 < mu * mu * mu) by (repeat apply Rmult_lt_0_compat; lra).
  assert (A : 0 <= 8192 * g / (mu * mu * mu)).
  { apply quotient_nonneg; lra. }
  eapply Rle_trans;
    [apply (hoop_under_small_distortion m n k p q d (g ^ k) xi c r y e u z w (8192 * g / (mu * mu * mu)) eps eps0 eps');
     trivial; try lra; apply Hk |].
  apply Rmult_le_compat_r; trivial; apply Rmult_le_compat_l; [lra |].
  apply hoop_constant; trivial; [lra |].
  split; trivial; apply quotient_nonneg; [apply sqrt_pos | lra].
Qed.
