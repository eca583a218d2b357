(** The paper's lemmas as it prints them, whole: lem:circ.rad.distort, lem:circ.ball.distort, lem:bound.cc,
    lem:raw.hoop.distort and lem:hoop.distort, each a corollary of the sharper one. A map is any function between sets of
    vectors that changes no distance by more than the factor 1 ± ξ; that it is a homeomorphism is not used. Thicknesses,
    longest edges and circumradii are those of simplices.v and circumradius.v: t is a lower bound of Υ, d an upper bound
    of Δ, so the lemmas hold for Υ and Δ themselves, and a circumradius is the radius about the point of the affine hull
    that is as far from all vertices. k^(3/2) is written k √k. *)

Require Import Reals Lra Lia Psatz.
From Delcert Require Import vectors simplices distortion circumradius weights projections circumcentres
  sharper_thickness sharper_circumradius sharper_balls sharper_circumcentre sharper_hoops.
Open Scope R_scope.

(** The map of the paper: | |x − y| − |φ(x) − φ(y)| | ≤ ξ |x − y| on its domain U. *)
Definition is_distortion_map (m n : nat) (U : vector -> Prop) (phi : vector -> vector) (xi : R) : Prop :=
  forall x y, U x -> U y -> Rabs (distance m x y - distance n (phi x) (phi y)) <= xi * distance m x y.

Definition vertices_in (k : nat) (p : simplex) (U : vector -> Prop) : Prop := forall i, (i <= k)%nat -> U (p i).

(** The image of a simplex is that of its vertices. *)
Definition image (phi : vector -> vector) (p : simplex) : simplex := fun i => phi (p i).

Lemma edges_of_the_image m n k U phi xi p d :
  0 <= xi -> is_distortion_map m n U phi xi -> vertices_in k p U -> edges_at_most m k p d ->
  edges_differ_at_most m n k p (image phi p) (xi * d).
Proof.
  intros Hx H HU He i j Hi Hj; eapply Rle_trans; [apply H; now apply HU |].
  apply Rmult_le_compat_l; trivial; now apply He.
Qed.

Lemma distances_of_the_image m n k U phi xi p x r :
  is_distortion_map m n U phi xi -> vertices_in k p U -> U x -> circumscribes m k p x r ->
  nearly_at_distance n k (image phi p) (phi x) r xi.
Proof.
  intros H HU Hx Hp i Hi; rewrite Rabs_minus_sym, <- (Hp i Hi); apply H; trivial; now apply HU.
Qed.

Lemma root_of_the_dimension k : (1 <= k)%nat -> 1 <= sqrt (INR k) /\ sqrt (INR k) * sqrt (INR k) = INR k.
Proof.
  intros Hk; pose proof (dimension_positive k Hk); split; [|apply sqrt_sqrt; lra].
  rewrite <- sqrt_1 at 1; apply sqrt_le_1_alt; lra.
Qed.

(** A greater constant over a smaller denominator. *)
Lemma bound_relaxed a b x u v : 0 <= x -> 0 <= a <= b -> 0 < v <= u -> a * x / u <= b * x / v.
Proof.
  intros Hx Ha Hv; apply quotient_at_most; [lra |].
  apply Rle_trans with (b * x); [apply Rmult_le_compat_r; lra |].
  assert (0 <= b * x) by (apply Rmult_le_pos; lra).
  replace (b * x / v * u) with (b * x * (u / v)) by (field; lra).
  assert (1 <= u / v) by (apply at_most_quotient; lra).
  rewrite <- (Rmult_1_r (b * x)) at 1; now apply Rmult_le_compat_l.
Qed.

Lemma powers_of_a_thickness t : 0 < t <= 1 -> 0 < t ^ 3 <= t * t /\ 0 < t * t <= 1.
Proof.
  intros H; assert (0 < t * t <= 1) by nra; split; trivial; simpl; rewrite Rmult_1_r.
  split; [now repeat apply Rmult_lt_0_compat |].
  assert (t * (t * t) <= 1 * (t * t)) by (apply Rmult_le_compat_r; lra); lra.
Qed.

(** lem:circ.rad.distort: if ξ ≤ (Υ/4)², then |R̃ − R| ≤ 16 k^(3/2) R ξ/Υ³. *)
Theorem circumradii_under_distortion m k p q d t xi r u :
  (1 <= k)%nat -> 0 < d -> 0 < t -> edges_at_most m k p d -> is_thick m k p d t ->
  0 <= xi <= (t / 4) ^ 2 -> edges_differ_at_most m m k p q (xi * d) ->
  is_circumradius m k p r -> is_circumradius m k q u ->
  Rabs (u - r) <= 16 * (INR k * sqrt (INR k)) * r * xi / t ^ 3.
Proof.
  intros Hk Hd Ht He Hthick Hx Hdiffer Hr Hu.
  replace ((t / 4) ^ 2) with (t / 4 * (t / 4)) in Hx by field.
  destruct (circumradius_under_small_distortion m m k p q d t xi r Hk Hd Ht Hx He Hthick Hdiffer Hr) as (_ & H).
  eapply Rle_trans; [exact (H u Hu) |].
  pose proof (thickness_at_most_one m k p d t Hk Hd He Hthick) as T.
  destruct (powers_of_a_thickness t (conj Ht T)) as (T3 & T2).
  pose proof (vertex_share_range k Hk); pose proof (dimension_positive k Hk).
  destruct (root_of_the_dimension k Hk) as (S1 & _).
  assert (r0 : 0 <= r) by (destruct Hr as (c & _ & Hc); now apply (circumscribed_radius_nonneg m k p _ r Hc)).
  replace (3 / 2 * vertex_share k * r * xi / (t * t)) with (3 / 2 * vertex_share k * (r * xi) / (t * t))
    by (field; lra).
  replace (16 * (INR k * sqrt (INR k)) * r * xi / t ^ 3) with (16 * (INR k * sqrt (INR k)) * (r * xi) / t ^ 3)
    by (field; lra).
  apply bound_relaxed; trivial; [apply Rmult_le_pos; lra | split; [lra |]].
  assert (1 * 1 <= INR k * sqrt (INR k)) by (apply Rmult_le_compat; lra); lra.
Qed.

(** lem:circ.ball.distort: for a circumscribing ball of σ with its centre c in U there is one of σ̃ with
    |φ(c) − c̃| ≤ 3 √k r²ξ/(ΥΔ) and |r̃ − r| ≤ 5 √k r²ξ/(ΥΔ). *)
Theorem circumscribing_balls_under_distortion m k U phi p d t xi c r :
  (1 <= k)%nat -> 0 < d -> 0 < t -> edges_at_most m k p d -> is_thick m k p d t ->
  0 <= xi <= (t / 4) ^ 2 -> is_distortion_map m m U phi xi -> vertices_in k p U -> U c -> circumscribes m k p c r ->
  exists c' r', circumscribes m k (image phi p) c' r' /\
    distance m (phi c) c' <= 3 * sqrt (INR k) * (r * r) * xi / (t * d) /\
    Rabs (r' - r) <= 5 * sqrt (INR k) * (r * r) * xi / (t * d).
Proof.
  intros Hk Hd Ht He Hthick Hx Hphi HU Hc Hp.
  replace ((t / 4) ^ 2) with (t / 4 * (t / 4)) in Hx by field.
  destruct (ball_under_small_distortion m m k p (image phi p) d t xi c (phi c) r Hk Hd Ht Hx He Hthick) as
    (z & u & Hz & C & R); trivial.
  { now apply (edges_of_the_image m m k U). }
  { now apply (distances_of_the_image m m k U). }
  pose proof (vertex_share_range k Hk).
  destruct (root_of_the_dimension k Hk) as (S1 & _).
  assert (TD : 0 < t * d) by (now apply Rmult_lt_0_compat).
  assert (X : 0 <= r * r * xi) by (apply Rmult_le_pos; [apply Rle_0_sqr | lra]).
  exists z, u; repeat split; trivial.
  - eapply Rle_trans; [exact C |]; rewrite !(Rmult_assoc _ (r * r) xi); apply bound_relaxed; trivial; lra.
  - eapply Rle_trans; [exact R |]; rewrite !(Rmult_assoc _ (r * r) xi); apply bound_relaxed; trivial; lra.
Qed.

(** lem:bound.cc: |φ(C(σ)) − C(σ̃)| ≤ (42 k²/Υ³ · ξ)^(1/2) R, for C(σ) in U, which the paper takes for granted. *)
Theorem circumcentres_under_distortion m k U phi p d t xi c r e u :
  (1 <= k)%nat -> 0 < d -> 0 < t -> edges_at_most m k p d -> is_thick m k p d t ->
  0 <= xi <= (t / 4) ^ 2 -> is_distortion_map m m U phi xi -> vertices_in k p U ->
  is_circumcentre m k p c r -> U (combination k c p) -> is_circumcentre m k (image phi p) e u ->
  distance m (phi (combination k c p)) (combination k e (image phi p)) <= sqrt (42 * (INR k) ^ 2 / t ^ 3 * xi) * r.
Proof.
  intros Hk Hd Ht He Hthick Hx Hphi HU Hc HC Hu.
  replace ((t / 4) ^ 2) with (t / 4 * (t / 4)) in Hx by field.
  pose proof (circumcentre_under_small_distortion m m k p (image phi p) d t xi c r (phi (combination k c p)) e u
                Hk Hd Ht Hx He Hthick (edges_of_the_image m m k U phi xi p d (proj1 Hx) Hphi HU He) Hc
                (distances_of_the_image m m k U phi xi p _ r Hphi HU HC (proj2 Hc)) Hu) as D.
  pose proof (thickness_at_most_one m k p d t Hk Hd He Hthick) as T.
  destruct (powers_of_a_thickness t (conj Ht T)) as (T3 & T2).
  pose proof (vertex_share_range k Hk); pose proof (dimension_positive k Hk).
  pose proof (circumscribed_radius_nonneg m k p _ r (proj2 Hc)).
  assert (K : 1 <= INR k ^ 2) by nra.
  assert (Q : 9 / 2 * vertex_share k * xi / (t * t) <= 42 * (INR k) ^ 2 / t ^ 3 * xi).
  { replace (42 * (INR k) ^ 2 / t ^ 3 * xi) with (42 * (INR k) ^ 2 * xi / t ^ 3) by (field; lra).
    apply bound_relaxed; trivial; lra. }
  assert (P : 0 <= 42 * (INR k) ^ 2 / t ^ 3 * xi).
  { apply Rmult_le_pos; [apply quotient_nonneg |]; lra. }
  rewrite distance_sym; apply le_of_squares; [apply Rmult_le_pos; [apply sqrt_pos | trivial] |].
  replace (sqrt (42 * (INR k) ^ 2 / t ^ 3 * xi) * r * (sqrt (42 * (INR k) ^ 2 / t ^ 3 * xi) * r))
    with (sqrt (42 * (INR k) ^ 2 / t ^ 3 * xi) * sqrt (42 * (INR k) ^ 2 / t ^ 3 * xi) * (r * r)) by ring.
  rewrite sqrt_sqrt by trivial; eapply Rle_trans; [exact D |]; apply Rmult_le_compat_r; [apply Rle_0_sqr | trivial].
Qed.

(** The vertex p′_i and the opposite facet σ of a forbidden configuration, by the properties 𝒫1, 𝒫2 and 𝒫4 of
    lem:prop.forbid.cfg that the paper's proofs use: within α₀R of the circumsphere, R < 2ε, Γ₀^k-thick. *)
Definition has_facet_properties (m k : nat) (z : vector) (p : simplex) (d g alpha eps : R) (c : vector) (r : R) : Prop :=
  edges_at_most m k p d /\ is_thick m k p d (g ^ k) /\ is_circumcentre m k p c r /\ r < 2 * eps /\
  exists b, sum (S k) b = 1 /\ distance m (combination k b p) (combination k c p) = r /\
            distance m z (combination k b p) <= alpha * r.

Lemma near_the_diametric_sphere m k z p d g alpha eps c r :
  has_facet_properties m k z p d g alpha eps c r -> near_sphere m z (combination k c p) r (alpha * r).
Proof.
  intros (_ & _ & _ & _ & b & _ & Hb & Hz); unfold near_sphere.
  pose proof (distance_triangle m z (combination k b p) (combination k c p)) as A.
  pose proof (distance_triangle m (combination k b p) z (combination k c p)) as B.
  rewrite (distance_sym m (combination k b p) z) in B; apply Rabs_le; lra.
Qed.

(** lem:raw.hoop.distort: if ξ₀ ≤ (Γ₀^k/4)², the image of σ is 2/(5√k) Γ₀^k-thick (by its own longest edge d′),
    its radius is at most 2 (1 + 16 k^(3/2) ξ₀/Γ₀^(3k)) (1 + ε₀) ε_i, and the image of p′_i is within 2α̃₀ε_i of its
    diametric sphere, α̃₀ = (α₀ (1 + ξ₀) + 12 k^(3/2)/Γ₀^(2k) · ξ₀^(1/2)) (1 + ε₀). As in lem:bound.cc the circumcentre
    is in the domain. *)
Theorem facet_of_a_forbidden_configuration m k U phi z p d d' g xi alpha eps eps0 eps' c r :
  (1 <= k)%nat -> 0 < d -> 0 < g <= 1 -> 0 <= alpha -> 0 <= xi <= (g ^ k / 4) ^ 2 -> eps <= (1 + eps0) * eps' ->
  is_distortion_map m m U phi xi -> vertices_in k p U -> U z -> U (combination k c p) ->
  has_facet_properties m k z p d g alpha eps c r -> is_longest_edge m k (image phi p) d' ->
  is_thick m k (image phi p) d' (2 / (5 * sqrt (INR k)) * g ^ k) /\
  exists e u, is_circumcentre m k (image phi p) e u /\
    u <= 2 * (1 + 16 * (INR k * sqrt (INR k)) * xi / g ^ (3 * k)) * (1 + eps0) * eps' /\
    near_sphere m (phi z) (combination k e (image phi p)) u
      (2 * ((alpha * (1 + xi) + 12 * (INR k * sqrt (INR k)) / g ^ (2 * k) * sqrt xi) * (1 + eps0)) * eps').
Proof.
  intros Hk Hd Hg Ha Hx Heps Hphi HU Hz HC H Hlong.
  pose proof (near_the_diametric_sphere m k z p d g alpha eps c r H) as N.
  destruct H as (He & Hthick & Hc & Hr & _).
  replace ((g ^ k / 4) ^ 2) with (g ^ k / 4 * (g ^ k / 4)) in Hx by field.
  pose proof (power_in_unit g k Hg) as G.
  pose proof (edges_of_the_image m m k U phi xi p d (proj1 Hx) Hphi HU He) as Hdiffer.
  destruct (root_of_the_dimension k Hk) as (S1 & _); pose proof (dimension_positive k Hk) as K.
  pose proof (vertex_share_range k Hk) as V.
  pose proof (circumscribed_radius_nonneg m k p _ r (proj2 Hc)) as r0.
  assert (KS : 1 * 1 <= INR k * sqrt (INR k)) by (apply Rmult_le_compat; lra).
  destruct (strain_range k xi (g ^ k) Hk G Hx) as (X & Hs & Hrel).
  split.
  - pose proof (thickness_under_small_distortion m m k p (image phi p) d (g ^ k) xi Hk Hd (proj1 G) (proj1 Hx) He Hthick
                  Hdiffer ltac:(lra)) as Q.
    pose proof (root_at_least (relative_change k xi (g ^ k)) ltac:(lra)) as P.
    intros i Hi b b0 b1; eapply Rle_trans; [|now apply (Q i Hi b)].
    assert (D : d' <= 17 / 16 * d).
    { destruct Hlong as (_ & v & w & Hv & Hw & E).
      specialize (He v w Hv Hw); specialize (Hdiffer v w Hv Hw); rewrite E in Hdiffer.
      assert (xi * d <= 1 / 16 * d) by (apply Rmult_le_compat_r; lra).
      unfold Rabs in Hdiffer; destruct Rcase_abs; lra. }
    assert (D0 : 0 <= d').
    { destruct Hlong as (_ & v & w & _ & _ & <-); apply norm_nonneg. }
    assert (F : 2 / (5 * sqrt (INR k)) <= 2 / 5) by (apply quotient_at_most; [lra | nra]).
    assert (F0 : 0 <= 2 / (5 * sqrt (INR k))) by (apply quotient_nonneg; lra).
    rewrite !Rmult_assoc; apply Rmult_le_compat_l; [lra |].
    apply Rle_trans with (2 / 5 * (g ^ k * (17 / 16 * d))).
    + apply Rmult_le_compat; trivial; [apply Rmult_le_pos; lra | apply Rmult_le_compat_l; lra].
    + assert (0 <= g ^ k * d) by (apply Rmult_le_pos; lra); nra.
  - destruct (circumradius_under_small_distortion m m k p (image phi p) d (g ^ k) xi r Hk Hd (proj1 G) Hx He Hthick
                Hdiffer (ex_intro _ c Hc)) as ((u & e & Hu) & R).
    exists e, u; split; [exact Hu |].
    specialize (R u (ex_intro _ e Hu)).
    assert (G3 : g ^ (3 * k) = g ^ k * (g ^ k * g ^ k))
      by (replace (3 * k)%nat with (k + (k + k))%nat by lia; now rewrite !pow_add).
    assert (G2 : g ^ (2 * k) = g ^ k * g ^ k)
      by (replace (2 * k)%nat with (k + k)%nat by lia; now rewrite !pow_add).
    destruct (powers_of_a_thickness (g ^ k) G) as (T3 & T2); simpl in T3; rewrite Rmult_1_r, <- G3 in T3.
    split.
    + assert (B : 3 / 2 * vertex_share k * xi / (g ^ k * g ^ k)
                  <= 16 * (INR k * sqrt (INR k)) * xi / g ^ (3 * k)) by (apply bound_relaxed; lra).
      set (b := 16 * (INR k * sqrt (INR k)) * xi / g ^ (3 * k)) in *; clearbody b.
      replace (3 / 2 * vertex_share k * r * xi / (g ^ k * g ^ k))
        with (3 / 2 * vertex_share k * xi / (g ^ k * g ^ k) * r) in R by (field; lra).
      assert (A0 : 0 <= 3 / 2 * vertex_share k * xi / (g ^ k * g ^ k)).
      { apply quotient_nonneg; [apply Rmult_le_pos; lra | lra]. }
      apply Rle_trans with ((1 + b) * r).
      * assert (3 / 2 * vertex_share k * xi / (g ^ k * g ^ k) * r <= b * r) by (apply Rmult_le_compat_r; trivial).
        unfold Rabs in R; destruct Rcase_abs; lra.
      * replace (2 * (1 + b) * (1 + eps0) * eps') with ((1 + b) * (2 * ((1 + eps0) * eps'))) by ring.
        apply Rmult_le_compat_l; lra.
    + eapply Rle_trans.
      * apply (hoop_under_small_distortion m m k p (image phi p) d (g ^ k) xi c r (phi (combination k c p)) e u z (phi z)
                 alpha eps eps0 eps'); trivial; try lra.
        -- exact (distances_of_the_image m m k U phi xi p _ r Hphi HU HC (proj2 Hc)).
        -- rewrite Rabs_minus_sym; now apply Hphi.
      * assert (B : 11 / 4 * (sqrt xi / g ^ k) <= 12 * (INR k * sqrt (INR k)) / g ^ (2 * k) * sqrt xi).
        { replace (11 / 4 * (sqrt xi / g ^ k)) with (11 / 4 * sqrt xi / g ^ k) by (field; lra).
          replace (12 * (INR k * sqrt (INR k)) / g ^ (2 * k) * sqrt xi)
            with (12 * (INR k * sqrt (INR k)) * sqrt xi / g ^ (2 * k)) by (field; lra).
          apply bound_relaxed; [apply sqrt_pos | lra |]; rewrite G2; split; [lra |].
          rewrite <- (Rmult_1_r (g ^ k)) at 3; apply Rmult_le_compat_l; lra. }
        set (x := 11 / 4 * (sqrt xi / g ^ k)) in *;
          set (y := 12 * (INR k * sqrt (INR k)) / g ^ (2 * k) * sqrt xi) in *; clearbody x y.
        replace (2 * ((alpha * (1 + xi) + x) * (1 + eps0)) * eps')
          with ((alpha * (1 + xi) + x) * (2 * ((1 + eps0) * eps'))) by ring.
        replace (2 * ((alpha * (1 + xi) + y) * (1 + eps0)) * eps')
          with ((alpha * (1 + xi) + y) * (2 * ((1 + eps0) * eps'))) by ring.
        apply Rmult_le_compat_r; lra.
Qed.

(** lem:hoop.distort: if ξ₀ ≤ (Γ₀^(2m + 1)/4)², the image of p′_j is within 2α̃₀ε_j of the diametric sphere of the image
    of σ, α̃₀ = 2¹⁶ m^(3/2) Γ₀/μ₀³; μ₀ ≤ 1, ε₀ ≤ 1 (as ε₀ ≤ (1 − ξ₀)/(1 + ξ₀) says), the circumcentre in the domain. *)
Theorem hoop_distortion m k U phi z p d g mu xi eps eps0 eps' c r :
  (1 <= k <= m)%nat -> 0 < d -> 0 < g <= 1 -> 0 < mu <= 1 -> 0 <= eps0 <= 1 -> 0 <= eps' -> eps <= (1 + eps0) * eps' ->
  0 <= xi <= (g ^ (2 * m + 1) / 4) ^ 2 -> is_distortion_map m m U phi xi ->
  vertices_in k p U -> U z -> U (combination k c p) ->
  has_facet_properties m k z p d g (2 ^ 13 * g / mu ^ 3) eps c r ->
  exists e u, is_circumcentre m k (image phi p) e u /\
    near_sphere m (phi z) (combination k e (image phi p)) u (2 * (2 ^ 16 * (INR m * sqrt (INR m)) * g / mu ^ 3) * eps').
Proof.
  intros Hk Hd Hg Hmu He0 He' Heps Hx Hphi HU Hz HC H.
  pose proof (near_the_diametric_sphere m k z p d g _ eps c r H) as N.
  destruct H as (He & Hthick & Hc & Hr & _).
  assert (M : mu ^ 3 = mu * mu * mu) by ring.
  replace (2 ^ 13) with 8192 in N by ring; rewrite M in N.
  assert (M0 : 0 < mu * mu * mu) by (repeat apply Rmult_lt_0_compat; lra).
  assert (X : 0 <= xi <= g ^ (m + 1) / 4 * (g ^ (m + 1) / 4)).
  { split; [lra |]; eapply Rle_trans; [apply Hx |].
    replace (2 * m + 1)%nat with (m + (m + 1))%nat by lia; rewrite pow_add.
    pose proof (power_in_unit g m Hg); pose proof (power_in_unit g (m + 1) Hg).
    set (a := g ^ m) in *; set (b := g ^ (m + 1)) in *; clearbody a b.
    assert (0 <= a * b <= b) by (split; [apply Rmult_le_pos |]; nra).
    replace ((a * b / 4) ^ 2) with (a * b / 4 * (a * b / 4)) by field; apply Rmult_le_compat; lra. }
  destruct (distortion_for_good_facets m k g xi (proj2 Hk) Hg X) as (Xk & _ & _).
  pose proof (edges_of_the_image m m k U phi xi p d (proj1 X) Hphi HU He) as Hdiffer.
  pose proof (power_in_unit g k Hg) as G.
  destruct (circumradius_under_small_distortion m m k p (image phi p) d (g ^ k) xi r (proj1 Hk) Hd (proj1 G)
              (conj (proj1 X) Xk) He Hthick Hdiffer (ex_intro _ c Hc)) as ((u & e & Hu) & _).
  exists e, u; split; [exact Hu |].
  eapply Rle_trans;
    [apply (hoop_under_the_sharper_distortion m m m k p (image phi p) d g mu xi c r (phi (combination k c p)) e u z (phi z)
              eps eps0 eps'); trivial; try lra |].
  - exact (distances_of_the_image m m k U phi xi p _ r Hphi HU HC (proj2 Hc)).
  - rewrite Rabs_minus_sym; now apply Hphi.
  - apply Rmult_le_compat_r; trivial; apply Rmult_le_compat_l; [lra |]; rewrite M.
    destruct (root_of_the_dimension m ltac:(lia)) as (S1 & _); pose proof (dimension_positive m ltac:(lia)).
    assert (1 * 1 <= INR m * sqrt (INR m)) by (apply Rmult_le_compat; lra).
    replace (2 ^ 16) with 65536 by ring; apply bound_relaxed; lra.
Qed.
