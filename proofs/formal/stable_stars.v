(** lem:stable.stars: without forbidden configurations in Q′_i the star of p′_i is the same in the chart of each of its
    neighbours. The constant 2¹² is printed; 2⁶ is enough. Neither lem:del.metric.stability, which the paper quotes, nor a
    fixed point theorem is used: the transition function pulls a Euclidean metric back, so that the stable circumscribing
    balls of thick simplices (sharper_balls.v) lead to the other chart, and balls that grow (growing_balls.v) back. *)

Require Import Reals Lra Lia Psatz Classical List.
From Delcert Require Import vectors simplices distortion circumcentres sharper_thickness sharper_balls sharper_hoops
  forbidden_configurations protected_stars stars growing_balls open_images.
Open Scope R_scope.

Lemma good_simplices_are_thick m k p g : (1 <= k)%nat -> is_good m k p g -> thickness_at_least m k p (g ^ k).
Proof. destruct k; [lia | intros _ (T & _); exact T]. Qed.

Lemma power_of_a_half g m : 0 < g <= 1 / 2 -> (1 <= m)%nat -> 0 < g ^ m <= 1 / 2.
Proof.
  intros Hg Hm; destruct m as [|n]; [lia |]; simpl; pose proof (power_in_unit g n ltac:(lra)); split; [|nra].
  apply Rmult_lt_0_compat; lra.
Qed.

Lemma few_points_of_a_flat_simplex g m : 0 < g <= 1 / 2 -> (1 <= m)%nat -> (INR m + 2) * g ^ m <= 3 / 2.
Proof.
  intros Hg Hm; pose proof (power_times_dimension g m ltac:(lra) Hm) as A.
  pose proof (power_of_a_half g m Hg Hm); lra.
Qed.

(** The printed bounds imply those of this file. *)
Lemma printed_bounds_of_stable_stars m g mu xi :
  0 < g <= 2 * mu ^ 2 / 75 -> 0 < mu <= 1 -> 0 <= xi <= g ^ (2 * m + 1) * mu ^ 2 / 2 ^ 12 ->
  0 < g <= 1 / 2 /\ 0 <= xi <= g ^ (2 * m + 1) * mu ^ 2 / 2 ^ 6.
Proof.
  intros Hg Hmu Hxi; assert (0 < mu ^ 2 <= 1) by (simpl; nra).
  assert (0 < g ^ (2 * m + 1)) by (apply pow_lt; lra).
  assert (0 < g ^ (2 * m + 1) * mu ^ 2) by (apply Rmult_lt_0_compat; lra).
  replace (2 ^ 12) with 4096 in Hxi by ring; replace (2 ^ 6) with 64 by ring; lra.
Qed.

(** What the stars of a chart depend on: the positions of the points in its region of interest, and these in another
    chart. ε′ = (1 + ρ̃₀)ε, μ₀′ε′ = (μ₀ − 2ρ̃₀)ε, δ = Γ₀^(m + 1)μ₀′ε′. *)
Section Region.
Variable label : Type.
Variables q q' : label -> vector.
Variable region : label -> Prop.
Variable m : nat.
Variables g mu rho eps xi : R.
Variable center : vector.
Variable D : vector -> Prop.
Variable phi : vector -> vector.
Let e := (1 + rho) * eps.
Let s := (mu - 2 * rho) * eps.
Let delta := g ^ (m + 1) * s.
Hypothesis dimension : (1 <= m)%nat.
Hypothesis goodness : 0 < g <= 1 / 2.
Hypothesis separation : 0 < mu <= 1.
Hypothesis perturbation : 0 <= rho <= mu / 4.
Hypothesis radius : 0 < eps.
Hypothesis small_distortion : 0 <= xi <= g ^ (2 * m + 1) * mu ^ 2 / 2 ^ 6.
Hypothesis finite : exists L : list label, forall l, region l -> In l L.
Hypothesis separated : forall a b, region a -> region b -> a <> b -> s <= distance m (q a) (q b).
Hypothesis dense : forall y, distance m y center <= 19 / 4 * eps -> exists l, region l /\ distance m y (q l) < e.
Hypothesis domain : forall x, distance m x center < 6 * eps -> D x.
Hypothesis in_domain : forall l, region l -> D (q l).
Hypothesis distortion : forall x y, D x -> D y -> Rabs (distance m x y - distance m (phi x) (phi y)) <= xi * distance m x y.
Hypothesis positions : forall l, region l -> agree m (q' l) (phi (q l)).
Hypothesis no_forbidden_configuration : forall k t,
  (1 <= k <= m)%nat -> is_simplex_of label region (S k) t -> ~ is_forbidden_configuration m k (fun i => q (t i)) g delta e.

Lemma radius_of_the_net : 0 < e <= 5 / 4 * eps /\ 0 < s <= e /\ 2 / 5 * (mu * e) <= s.
Proof.
  assert (A : 2 / 5 * (mu * (1 + rho)) <= mu - 2 * rho) by nra.
  unfold e, s; repeat split.
  - apply Rmult_lt_0_compat; lra.
  - apply Rmult_le_compat_r; lra.
  - apply Rmult_lt_0_compat; lra.
  - apply Rmult_le_compat_r; lra.
  - replace (2 / 5 * (mu * ((1 + rho) * eps))) with (2 / 5 * (mu * (1 + rho)) * eps) by ring; apply Rmult_le_compat_r; lra.
Qed.

Lemma protection_is_positive : 0 < delta.
Proof.
  pose proof radius_of_the_net; unfold delta; apply Rmult_lt_0_compat; [apply pow_lt; lra | lra].
Qed.

Lemma thickness_is_positive : 0 < g ^ m <= 1 / 2.
Proof. now apply power_of_a_half. Qed.

Lemma distortion_in_units : xi <= 1 / 512 /\ xi * (e * e) <= 25 / 256 * (g ^ m * (delta * s)) /\ xi <= g ^ m / 4 * (g ^ m / 4).
Proof.
  pose proof radius_of_the_net as (E & Es & ES); pose proof thickness_is_positive as G.
  assert (P : g ^ (2 * m + 1) = g ^ m * (g * g ^ m)).
  { replace (2 * m + 1)%nat with (m + S m)%nat by lia; rewrite pow_add; reflexivity. }
  assert (P1 : g ^ (m + 1) = g * g ^ m) by (replace (m + 1)%nat with (S m) by lia; reflexivity).
  unfold delta; rewrite P1; rewrite P in small_distortion; set (h := g ^ m) in *; clearbody h.
  replace (mu ^ 2) with (mu * mu) in small_distortion by ring; replace (2 ^ 6) with 64 in small_distortion by ring.
  assert (A : 0 < h * (g * h)) by (repeat apply Rmult_lt_0_compat; lra).
  assert (B : h * (g * h) <= 1 / 2 * (h * h)) by (assert (0 < h * h) by nra; nra).
  assert (M : 0 < mu * mu <= 1) by nra.
  assert (X : xi <= h * (g * h) / 64).
  { assert (h * (g * h) * (mu * mu) <= h * (g * h) * 1) by (apply Rmult_le_compat_l; lra); lra. }
  assert (H : h * h <= 1 / 4) by nra.
  split; [lra | split; [|lra]].
  assert (Q : mu * e * (mu * e) <= 25 / 4 * (s * s)).
  { assert (0 < mu * e) by (apply Rmult_lt_0_compat; lra).
    assert (2 / 5 * (mu * e) * (2 / 5 * (mu * e)) <= s * s) by (apply Rmult_le_compat; lra); lra. }
  apply Rle_trans with (h * (g * h) * (mu * mu) / 64 * (e * e)); [apply Rmult_le_compat_r; nra |].
  replace (h * (g * h) * (mu * mu) / 64 * (e * e)) with (h * (g * h) / 64 * (mu * e * (mu * e))) by field.
  replace (25 / 256 * (h * (g * h * s * s))) with (h * (g * h) / 64 * (25 / 4 * (s * s))) by field.
  apply Rmult_le_compat_l; lra.
Qed.

Lemma dense_about l : distance m (q l) center <= 3 * eps -> is_dense_about label q region m e l.
Proof.
  intros H y Hy; pose proof radius_of_the_net; apply dense; pose proof (distance_triangle m y (q l) center); lra.
Qed.

Lemma distance_in_the_other_chart x y l :
  region l -> D x -> agree m (phi x) y ->
  (1 - xi) * distance m (q l) x <= distance m (q' l) y <= (1 + xi) * distance m (q l) x.
Proof.
  intros Hl Dx Y; specialize (distortion (q l) x (in_domain l Hl) Dx).
  rewrite (distance_agree m (phi (q l)) (q' l) (phi x) y) in distortion; trivial.
  - unfold Rabs in distortion; destruct Rcase_abs in distortion; lra.
  - intros a Ha; symmetry; now apply positions.
Qed.

(** Simplices with empty balls are good and protected. *)
Lemma protected_simplex t x r :
  distance m (q (t O)) center <= 3 * eps -> is_simplex_of label region m t -> is_empty_ball label q region m m t x r ->
  r < e /\ is_good m m (fun i => q (t i)) g /\
  forall l, region l -> (forall i, (i <= m)%nat -> t i <> l) -> r + delta < distance m (q l) x.
Proof.
  intros Near T (On & Empty); pose proof radius_of_the_net as (E & Es & _).
  assert (R : r < e).
  { apply (radius_of_a_star label q region m (t O) e x r); try lra; [apply (On O); lia | now apply dense_about |].
    intros l Hl _; now apply Empty. }
  split; [exact R |].
  apply (simplices_of_empty_balls_are_protected label q region m g delta e s); trivial; try lra.
  pose proof protection_is_positive; lra.
Qed.

(** To the other chart: an m-simplex with an empty ball has one there. *)
Lemma empty_ball_in_the_other_chart t x r :
  distance m (q (t O)) center <= 3 * eps -> is_simplex_of label region m t -> is_empty_ball label q region m m t x r ->
  exists y u, is_empty_ball label q' region m m t y u.
Proof.
  intros Near T B; pose proof (protected_simplex t x r Near T B) as (R & Good & Protected).
  destruct T as (T1 & T2); destruct B as (On & Empty).
  pose proof radius_of_the_net as (E & Es & _); pose proof thickness_is_positive as G; pose proof protection_is_positive as Pd.
  destruct distortion_in_units as (X & XE & XT).
  assert (r0 : 0 <= r) by (apply (circumscribed_radius_nonneg m m _ x r On)).
  assert (Dx : D x).
  { apply domain; pose proof (distance_triangle m x (q (t O)) center) as Tr.
    pose proof (On O ltac:(lia)) as O0; cbv beta in O0; rewrite (distance_sym m x (q (t O))), O0 in Tr; lra. }
  destruct (longest_edge_exists m m (fun i => q (t i))) as (d & Long).
  assert (Sd : s <= d).
  { apply Rle_trans with (distance m (q (t O)) (q (t 1%nat))); [|apply (proj1 Long O 1%nat); lia].
    apply separated; [apply T1; lia | apply T1; lia | intros F; apply T2 in F; lia]. }
  pose proof (good_simplices_are_thick m m _ g dimension Good d Long) as Thick.
  assert (Image : forall i, (i <= m)%nat -> agree m (q' (t i)) (phi (q (t i)))) by (intros; apply positions; auto).
  destruct (ball_under_small_distortion m m m (fun i => q (t i)) (fun i => q' (t i)) d (g ^ m) xi x (phi x) r)
    as (z & u & Hz & Cz & Cu); trivial; try lra; [exact (proj1 Long) | | |].
  { intros i j Hi Hj; cbv beta.
    rewrite (distance_agree m (q' (t i)) (phi (q (t i))) (q' (t j)) (phi (q (t j))) (Image i Hi) (Image j Hj)).
    eapply Rle_trans; [apply distortion; apply in_domain; auto |].
    apply Rmult_le_compat_l; [lra |]; now apply (proj1 Long). }
  { intros i Hi; pose proof (distance_in_the_other_chart x (phi x) (t i) (T1 i Hi) Dx ltac:(intros a _; trivial)) as K.
    pose proof (On i Hi) as Oi; cbv beta in Oi; rewrite Oi in K; apply Rabs_le; lra. }
  pose proof (vertex_share_range m dimension) as V.
  assert (GD : 0 < g ^ m * d) by (apply Rmult_lt_0_compat; lra).
  assert (Y : 0 <= r * r * xi <= 25 / 256 * delta * (g ^ m * d)).
  { split; [apply Rmult_le_pos; nra |].
    apply Rle_trans with (xi * (e * e)); [rewrite Rmult_comm; apply Rmult_le_compat_l; nra |].
    eapply Rle_trans; [exact XE |].
    replace (25 / 256 * delta * (g ^ m * d)) with (25 / 256 * (g ^ m * (delta * d))) by ring.
    apply Rmult_le_compat_l; [lra |]; apply Rmult_le_compat_l; [lra |]; apply Rmult_le_compat_l; lra. }
  assert (Bound : forall c, 0 <= c -> c * (r * r) * xi / (g ^ m * d) <= c * (25 / 256 * delta)).
  { intros c Hc; apply quotient_at_most; trivial.
    replace (c * (r * r) * xi) with (c * (r * r * xi)) by ring.
    replace (c * (25 / 256 * delta) * (g ^ m * d)) with (c * (25 / 256 * delta * (g ^ m * d))) by ring.
    apply Rmult_le_compat_l; lra. }
  assert (Cz' : distance m (phi x) z <= 13 / 6 * (25 / 256 * delta)).
  { eapply Rle_trans; [exact Cz |]; eapply Rle_trans; [apply Bound; lra |]; apply Rmult_le_compat_r; lra. }
  assert (Cu' : u <= r + 25 / 6 * (25 / 256 * delta)).
  { assert (A : Rabs (u - r) <= 25 / 6 * (25 / 256 * delta)).
    { eapply Rle_trans; [exact Cu |]; eapply Rle_trans; [apply Bound; lra |]; apply Rmult_le_compat_r; lra. }
    unfold Rabs in A; destruct Rcase_abs in A; lra. }
  exists z, u; split; [exact Hz |]; intros l Hl.
  destruct (classic (exists i, (i <= m)%nat /\ t i = l)) as [(i & Hi & <-)|N].
  { right; symmetry; exact (Hz i Hi). }
  specialize (Protected l Hl ltac:(intros i Hi F; apply N; now exists i)).
  destruct (distance_in_the_other_chart x (phi x) l Hl Dx ltac:(intros a _; trivial)) as (K & _).
  pose proof (distance_triangle m (q' l) z (phi x)) as Tr; rewrite (distance_sym m z) in Tr.
  (* ξ r is small against δ *)
  assert (XR : xi * e <= 25 / 256 * delta).
  { apply Rmult_le_reg_r with e; [lra |]; replace (xi * e * e) with (xi * (e * e)) by ring.
    eapply Rle_trans; [exact XE |].
    assert (g ^ m * (delta * s) <= 1 * (delta * e)); [|lra].
    apply Rmult_le_compat; try lra; [apply Rmult_le_pos; lra | apply Rmult_le_compat_l; lra]. }
  assert (XR' : xi * r <= xi * e) by (apply Rmult_le_compat_l; lra).
  assert (XD : xi * delta <= 1 / 512 * delta) by (apply Rmult_le_compat_r; lra).
  assert (L : (1 - xi) * (r + delta) <= (1 - xi) * distance m (q l) x) by (apply Rmult_le_compat_l; lra).
  lra.
Qed.

(** And back: points with an empty ball in the other chart have one, and are at most m + 1. *)
Lemma empty_ball_from_the_other_chart n t x y u i :
  (n <= S m)%nat -> is_simplex_of label region n t -> is_empty_ball label q' region m n t y u -> u <= 5 / 2 * eps ->
  D x -> agree m (phi x) y -> (i <= n)%nat -> distance m (q (t i)) center <= 1 / 4 * eps ->
  (n <= m)%nat /\ exists v w, is_empty_ball label q region m n t v w.
Proof.
  intros Hn (T1 & T2) (On & Empty) Hu Dx Y Hi Near.
  pose proof radius_of_the_net as (E & Es & _); pose proof thickness_is_positive as G; pose proof protection_is_positive as Pd.
  destruct distortion_in_units as (X & XE & _).
  pose proof (norm_nonneg m (minus (q (t i)) x)) as Ni; fold (distance m (q (t i)) x) in Ni.
  assert (Xi : (1 - xi) * distance m (q (t i)) x <= u).
  { pose proof (On i Hi) as Oi; cbv beta in Oi; rewrite <- Oi; apply (distance_in_the_other_chart x y (t i)); auto. }
  assert (Xi' : distance m (q (t i)) x <= 512 / 511 * u) by nra.
  (* the nearest point *)
  destruct (dense x) as (l1 & R1 & N1).
  { pose proof (distance_triangle m x (q (t i)) center) as Tr.
    rewrite (distance_sym m x (q (t i))) in Tr; lra. }
  destruct finite as (L & HL).
  destruct (least_of_finitely_many label region (fun l => distance m (q l) x) L) as (l0 & _ & R0 & Least).
  { exists l1; auto. }
  set (r := distance m (q l0) x) in *.
  assert (r0 : 0 <= r) by apply norm_nonneg.
  assert (Hr : r < e).
  { apply Rle_lt_trans with (distance m (q l1) x); [now apply Least; [apply HL |] | now rewrite distance_sym]. }
  assert (Hur : u <= (1 + xi) * r).
  { eapply Rle_trans; [now apply (Empty l0) | apply (distance_in_the_other_chart x y l0); auto]. }
  assert (Hu2 : u <= 513 / 512 * e) by nra.
  assert (Near0 : distance m (q l0) center <= 3 * eps).
  { pose proof (distance_triangle m (q l0) x (q (t i))) as Tr1.
    pose proof (distance_triangle m (q l0) (q (t i)) center) as Tr2.
    rewrite (distance_sym m x) in Tr1; fold r in Tr1; lra. }
  (* it grows *)
  destruct (empty_ball_with_a_simplex label q region m e ltac:(lra) ltac:(now exists L) 0 (fun _ => l0) x r n t)
    as (t' & v & w & Z & T' & B' & F); [lia | | | now apply dense_about |].
  { split; [auto | intros; lia]. }
  { split; [intros j _; reflexivity |]; intros l Hl; apply Least; auto. }
  assert (Z0 : t' O = l0) by (apply Z; lia).
  destruct (protected_simplex t' v w ltac:(rewrite Z0; trivial) T' B') as (Hw & _ & Protected).
  destruct T' as (T1' & T2'); destruct B' as (On' & Empty').
  assert (W0 : distance m (q l0) v = w) by (rewrite <- Z0; apply (On' O); lia).
  assert (W : s <= 2 * w).
  { pose proof (distance_triangle m (q (t' O)) v (q (t' 1%nat))) as Tr.
    pose proof (On' O ltac:(lia)) as O0; pose proof (On' 1%nat dimension) as O1; cbv beta in O0, O1.
    rewrite (distance_sym m v), O0, O1 in Tr.
    assert (s <= distance m (q (t' O)) (q (t' 1%nat))); [|lra].
    apply separated; [apply T1'; lia | now apply T1' | intros Q; apply T2' in Q; lia]. }
  (* the sum is small at x *)
  assert (Few : (INR m + 2) * g ^ m <= 3 / 2) by (now apply few_points_of_a_flat_simplex).
  assert (Fx : total_excess label q m n t l0 x < delta * s).
  { apply Rle_lt_trans with (INR (S n) * (41 / 10 * (xi * (e * e)))).
    - rewrite <- sum_const; apply sum_le; intros a Ha; unfold excess; fold r.
      assert (A : (1 - xi) * distance m (q (t a)) x <= (1 + xi) * r).
      { apply Rle_trans with u; trivial; pose proof (On a ltac:(lia)) as Oa; cbv beta in Oa; rewrite <- Oa.
        apply (distance_in_the_other_chart x y (t a)); auto; apply T1; lia. }
      pose proof (norm_nonneg m (minus (q (t a)) x)) as A0; fold (distance m (q (t a)) x) in A0.
      set (b := distance m (q (t a)) x) in *; clearbody b r.
      assert (B2 : (1 - xi) * b * ((1 - xi) * b) <= (1 + xi) * r * ((1 + xi) * r)).
      { apply Rmult_le_compat; trivial; apply Rmult_le_pos; lra. }
      assert (C : (1 - xi) * (1 - xi) * (b * b - r * r) <= 4 * (xi * (r * r))) by lra.
      assert (D1 : 511 / 512 * (511 / 512) <= (1 - xi) * (1 - xi)) by (apply Rmult_le_compat; lra).
      assert (RE : xi * (r * r) <= xi * (e * e)) by (apply Rmult_le_compat_l; [lra | apply Rmult_le_compat; lra]).
      assert (R2 : 0 <= xi * (r * r)) by (apply Rmult_le_pos; nra).
      destruct (Rle_dec (b * b - r * r) 0) as [|P]; [lra |].
      assert (511 / 512 * (511 / 512) * (b * b - r * r) <= (1 - xi) * (1 - xi) * (b * b - r * r))
        by (apply Rmult_le_compat_r; lra); lra.
    - assert (K : INR (S n) <= INR m + 2).
      { apply le_INR in Hn; rewrite S_INR in *; lra. }
      assert (K0 : 0 <= INR (S n)) by apply pos_INR.
      assert (Q : 0 < delta * s) by (apply Rmult_lt_0_compat; lra).
      apply Rle_lt_trans with ((INR m + 2) * (41 / 10 * (25 / 256 * (g ^ m * (delta * s))))).
      + apply Rmult_le_compat; trivial; [|lra]; apply Rmult_le_pos; [lra |]; apply Rmult_le_pos; [lra | nra].
      + replace ((INR m + 2) * (41 / 10 * (25 / 256 * (g ^ m * (delta * s)))))
          with (41 / 10 * (25 / 256) * ((INR m + 2) * g ^ m * (delta * s))) by ring.
        assert ((INR m + 2) * g ^ m * (delta * s) <= 3 / 2 * (delta * s)) by (apply Rmult_le_compat_r; lra); lra. }
  (* so all points are on the ball *)
  assert (All : forall a, (a <= n)%nat -> distance m (q (t a)) v = w).
  { intros a Ha; destruct (classic (exists j, (j <= m)%nat /\ t' j = t a)) as [(j & Hj & <-)|N]; [now apply (On' j) |].
    exfalso; specialize (Protected (t a) (T1 a Ha) ltac:(intros j Hj Q; apply N; now exists j)).
    assert (Term : excess m (q l0) v (q (t a)) <= total_excess label q m n t l0 v).
    { unfold total_excess; apply (term_le_sum (S n) (fun a => excess m (q l0) v (q (t a)))); [|lia].
      intros b Hb; apply excess_nonneg; rewrite W0; apply Empty', T1; lia. }
    cbv beta in F; unfold excess in Term; rewrite W0 in Term.
    set (b := distance m (q (t a)) v) in *; clearbody b.
    assert (w0 : 0 <= w) by lra.
    assert ((w + delta) * (w + delta) <= b * b) by (apply Rmult_le_compat; lra).
    assert (s * delta <= 2 * w * delta) by (apply Rmult_le_compat_r; lra).
    assert (0 <= delta * delta) by nra; lra. }
  assert (Final : (n <= m)%nat).
  { apply Nat.nlt_ge; intros Q; assert (Hnm : n = S m) by lia.
    assert (Small : w + delta < distance m (q (t n)) v).
    { apply (simplices_of_empty_balls_are_protected label q region m g delta e s) with (t := t) (r := w); trivial; try lra.
      - split; [intros j Hj; apply T1; lia | intros a b Ha Hb; apply T2; lia].
      - intros j Hj; apply All; lia.
      - apply T1; lia.
      - intros j Hj Q2; apply T2 in Q2; lia. }
    rewrite All in Small by lia; lra. }
  split; [exact Final |]; exists v, w; split; [exact All | exact Empty'].
Qed.

(** Both, for any points among which is one near the centre. *)
Theorem empty_balls_in_two_charts n t a :
  (n <= S m)%nat -> is_simplex_of label region n t -> (a <= n)%nat -> distance m (q (t a)) center <= 1 / 4 * eps ->
  (forall x r, is_empty_ball label q region m n t x r -> (n <= m)%nat /\ exists y u, is_empty_ball label q' region m n t y u) /\
  (forall y u, is_empty_ball label q' region m n t y u -> u <= 5 / 2 * eps -> (exists x, D x /\ agree m (phi x) y) ->
     (n <= m)%nat /\ exists x r, is_empty_ball label q region m n t x r).
Proof.
  intros Hn (T1 & T2) Ha Near; pose proof radius_of_the_net as (E & Es & _); split.
  - intros x r (On & Empty).
    assert (R : r < e).
    { apply (radius_of_a_star label q region m (t a) e x r); try lra; [exact (On a Ha) | apply dense_about; lra |].
      intros l Hl _; now apply Empty. }
    assert (First : distance m (q (t O)) center <= 3 * eps).
    { pose proof (distance_triangle m (q (t O)) (q (t a)) center) as Tr1.
      pose proof (distance_triangle m (q (t O)) x (q (t a))) as Tr2.
      pose proof (On O ltac:(lia)) as O0; pose proof (On a Ha) as Oa; cbv beta in O0, Oa.
      rewrite (distance_sym m x), O0, Oa in Tr2; lra. }
    assert (Final : (n <= m)%nat).
    { apply Nat.nlt_ge; intros Q.
      destruct (protected_simplex t x r First) as (_ & _ & P).
      - split; [intros j Hj; apply T1; lia | intros b c Hb Hc; apply T2; lia].
      - split; [intros j Hj; apply On; lia | exact Empty].
      - specialize (P (t n) (T1 n ltac:(lia)) ltac:(intros j Hj F; apply T2 in F; lia)).
        pose proof (On n ltac:(lia)) as Oi; cbv beta in Oi; rewrite Oi in P; pose proof protection_is_positive; lra. }
    split; [exact Final |].
    destruct (empty_ball_with_a_simplex label q region m e ltac:(lra) finite n t x r O t Final (conj T1 T2)
                (conj On Empty) (dense_about _ First)) as (t' & x' & r' & K & T' & B' & _).
    destruct (empty_ball_in_the_other_chart t' x' r' ltac:(rewrite K by lia; trivial) T' B') as (y & u & On' & Empty').
    exists y, u; split; [|exact Empty']; intros j Hj; rewrite <- (K j Hj); apply (On' j); lia.
  - intros y u B Hu (x & Dx & Y); now apply (empty_ball_from_the_other_chart n t x y u a).
Qed.
End Region.

(** lem:stable.stars. Charts i and j are given by the labels and positions of their points, P′_i = q and P′_j = q'. P′_i
    is finite, μ₀′ε′_i-separated, and ε′_i-dense in B(p_i, 8ε_i); P′_j is ε′_j-dense in B(p_j, 8ε_j); p′_i and p′_j are
    within ρ̃₀ε of where they were. The transition function φ = φ_ji is defined on B(p_i, 6ε_i), its image V is open, ψ is
    its inverse. The charts agree: a point of Q′_i is one of P′_j, at its image, and a point of P′_j with an inverse image
    in B(p_i, 6ε_i) is one of P′_i, there. There is no forbidden configuration in Q′_i, and p′_j is in the star of p′_i.
    Then labels, i among them, are a simplex of Del(P′_i) if and only if they are one of Del(P′_j). (n ≤ m + 1 is no
    restriction: they are at most m + 1 labels, as the theorem says too.) *)
Theorem stars_of_neighbours (label : Type) (q q' : label -> vector) (points points' : label -> Prop)
    m g mu rho epsi epsj eps0 xi pi pj (V : vector -> Prop) phi psi i j :
  (1 <= m)%nat -> 0 < g <= 1 / 2 -> 0 < mu <= 1 -> 0 <= rho <= mu / 4 -> 0 < epsi -> 0 < epsj ->
  0 <= xi <= g ^ (2 * m + 1) * mu ^ 2 / 2 ^ 6 -> 0 <= eps0 -> (1 + eps0) * (1 + xi) <= 2 ->
  epsj <= (1 + eps0) * epsi -> epsi <= (1 + eps0) * epsj ->
  let near := fun x => distance m x pi < 6 * epsi in
  let region := fun l => points l /\ near (q l) in
  (exists L : list label, forall l, points l -> In l L) ->
  (forall a b, points a -> points b -> a <> b -> (mu - 2 * rho) * epsi <= distance m (q a) (q b)) ->
  (forall y, distance m y pi <= 8 * epsi -> exists l, points l /\ distance m y (q l) < (1 + rho) * epsi) ->
  (forall y, distance m y pj <= 8 * epsj -> exists l, points' l /\ distance m y (q' l) < (1 + rho) * epsj) ->
  distance m (q i) pi <= rho * epsi -> distance m (q' j) pj <= rho * epsj ->
  is_transition m near V phi psi xi ->
  (forall l, region l -> points' l /\ agree m (q' l) (phi (q l))) ->
  (forall l x, points' l -> near x -> agree m (q' l) (phi x) -> points l /\ agree m (q l) x) ->
  (forall k u, (1 <= k <= m)%nat -> is_simplex_of label region (S k) u ->
     ~ is_forbidden_configuration m k (fun a => q (u a)) g (g ^ (m + 1) * ((mu - 2 * rho) * epsi)) ((1 + rho) * epsi)) ->
  (exists n t x r, is_delaunay label q m points n t x r /\
     (exists a, (a <= n)%nat /\ t a = i) /\ exists b, (b <= n)%nat /\ t b = j) ->
  forall n t, (n <= S m)%nat -> (forall a b, (a <= n)%nat -> (b <= n)%nat -> t a = t b -> a = b) ->
  (exists a, (a <= n)%nat /\ t a = i) ->
  ((exists x r, is_delaunay label q m points n t x r) <-> (exists y u, is_delaunay label q' m points' n t y u)) /\
  ((exists x r, is_delaunay label q m points n t x r) -> (n <= m)%nat).
Proof.
  intros Hm Hg Hmu Hrho Hi Hj Hxi He0 Hc Rij Rji near region Finite Separated Dense Dense' Ni Nj Transition Seen Back No
    (n0 & t0 & x0 & r0 & D0 & (a0 & A0 & Ta0) & (b0 & B0 & Tb0)) n t Hn Inj (a & Ha & Ta).
  pose proof Transition as (_ & Inverse & _ & Forth & Backward).
  assert (Hr : 0 <= rho <= 1 / 4) by lra.
  assert (Ei : 0 < (1 + rho) * epsi <= 5 / 4 * epsi) by (split; [apply Rmult_lt_0_compat | apply Rmult_le_compat_r]; lra).
  assert (Ej : 0 < (1 + rho) * epsj <= 5 / 4 * epsj) by (split; [apply Rmult_lt_0_compat | apply Rmult_le_compat_r]; lra).
  assert (Ni4 : distance m (q i) pi <= 1 / 4 * epsi).
  { apply Rle_trans with (1 := Ni); apply Rmult_le_compat_r; lra. }
  assert (Nj4 : distance m (q' j) pj <= 1 / 4 * epsj).
  { apply Rle_trans with (1 := Nj); apply Rmult_le_compat_r; lra. }
  assert (Xi : xi <= 1 / 512).
  { pose proof (power_of_a_half g m Hg Hm) as G.
    replace (2 * m + 1)%nat with (m + S m)%nat in Hxi by lia; rewrite pow_add in Hxi.
    change (g ^ S m) with (g * g ^ m) in Hxi; replace (mu ^ 2) with (mu * mu) in Hxi by ring.
    replace (2 ^ 6) with 64 in Hxi by ring; set (h := g ^ m) in *; clearbody h.
    assert (g * h <= 1 / 2 * (1 / 2)) by (apply Rmult_le_compat; lra).
    assert (0 < g * h) by (apply Rmult_lt_0_compat; lra).
    assert (h * (g * h) <= 1 / 2 * (1 / 4)) by (apply Rmult_le_compat; lra).
    assert (mu * mu <= 1 * 1) by (apply Rmult_le_compat; lra).
    assert (0 < h * (g * h)) by (apply Rmult_lt_0_compat; lra).
    assert (h * (g * h) * (mu * mu) <= 1 / 8 * 1) by (apply Rmult_le_compat; nra); lra. }
  assert (Rij2 : (1 + xi) * epsj <= 2 * epsi).
  { apply Rle_trans with ((1 + xi) * ((1 + eps0) * epsi)); [apply Rmult_le_compat_l; lra |].
    replace ((1 + xi) * ((1 + eps0) * epsi)) with ((1 + eps0) * (1 + xi) * epsi) by ring; apply Rmult_le_compat_r; lra. }
  assert (Rji2 : (1 + xi) * epsi <= 2 * epsj).
  { apply Rle_trans with ((1 + xi) * ((1 + eps0) * epsj)); [apply Rmult_le_compat_l; lra |].
    replace ((1 + xi) * ((1 + eps0) * epsj)) with ((1 + eps0) * (1 + xi) * epsj) by ring; apply Rmult_le_compat_r; lra. }
  assert (Ej2 : 2 * ((1 + rho) * epsj) <= 5 * epsi) by nra.
  (* density about p′_i *)
  assert (Local : forall y, distance m y (q i) <= (1 + rho) * epsi -> exists l, points l /\ distance m y (q l) < (1 + rho) * epsi).
  { intros y Hy; apply Dense; pose proof (distance_triangle m y (q i) pi); lra. }
  (* p′_j in chart i *)
  assert (Pj : points j /\ distance m (q j) (q i) < 2 * ((1 + rho) * epsi)).
  { split; [rewrite <- Tb0; now apply D0 |].
    destruct (star_of_near_points label q points points m i ((1 + rho) * epsi) n0 t0 x0 r0 (proj1 Ei)
                ltac:(auto) ltac:(auto) Local ltac:(now exists a0)) as (_ & W).
    rewrite <- Tb0; now apply W. }
  assert (Pi : points i) by (rewrite <- Ta0; now apply D0).
  assert (Ri : region i) by (split; [trivial | unfold near; lra]).
  assert (Rj : region j).
  { split; [apply Pj |]; unfold near; pose proof (distance_triangle m (q j) (q i) pi); lra. }
  destruct (Seen i Ri) as (Pi' & Ai); destruct (Seen j Rj) as (Pj' & Aj).
  assert (Same : forall u, agree m u u) by (intros u b _; trivial).
  (* what is near in chart j is seen in chart i *)
  assert (Onto : forall y, distance m y (q' i) < 5 * epsi -> V y).
  { intros y Hy; apply (image_contains_a_ball m near V phi psi xi (q i) (23 / 4 * epsi) y); trivial; try lra.
    - intros x Hx; unfold near; pose proof (distance_triangle m x (q i) pi); lra.
    - rewrite <- (distance_agree m y y (q' i) (phi (q i)) (Same y) Ai); nra. }
  assert (Labels : forall l, points' l -> distance m (q' l) (q' i) < 5 * epsi ->
                     points l /\ distance m (q l) (q i) <= (1 + xi) * distance m (q' l) (q' i)).
  { intros l Pl Hl; pose proof (Onto (q' l) Hl) as Vl.
    assert (Vi : V (q' i)) by (apply Onto; rewrite distance_zero; lra).
    destruct (Inverse _ Vl) as (Dl & Il), (Inverse _ Vi) as (Di & Ii).
    destruct (Back l (psi (q' l)) Pl Dl) as (Q & Al); [intros b Hb; now rewrite Il |].
    destruct (Back i (psi (q' i)) Pi' Di) as (_ & Bi); [intros b Hb; now rewrite Ii |].
    split; [exact Q |]; rewrite (distance_agree m _ _ _ _ Al Bi).
    specialize (Backward _ _ Vl Vi); unfold Rabs in Backward; destruct Rcase_abs in Backward; lra. }
  assert (Image : distance m (q' i) (q' j) <= (1 + xi) * distance m (q i) (q j)).
  { rewrite (distance_agree m _ _ _ _ Ai Aj); specialize (Forth (q i) (q j) (proj2 Ri) (proj2 Rj)).
    unfold Rabs in Forth; destruct Rcase_abs in Forth; lra. }
  (* stars in the two regions *)
  assert (InI : forall x r, is_delaunay label q m region n t x r <-> is_delaunay label q m points n t x r).
  { intros x r; apply (star_in_the_region label q points m pi epsi rho i n t x r); trivial; now exists a. }
  assert (InJ : forall y u, is_delaunay label q' m region n t y u <-> is_delaunay label q' m points' n t y u).
  { intros y u; apply (star_in_another_chart label q' q points' points m pi pj epsi epsj rho rho xi eps0 i j n t y u);
      trivial; try lra.
    - intros l Rl; apply Seen, Rl.
    - intros l Pl Hl; apply Labels; trivial; lra.
    - rewrite distance_sym; apply Pj.
    - now exists a. }
  assert (Radius : forall y u, is_delaunay label q' m points' n t y u -> u < (1 + rho) * epsj).
  { intros y u Dy.
    apply (star_of_near_points label q' points' points' m i ((1 + rho) * epsj) n t y u (proj1 Ej)); auto;
      [|now exists a].
    intros z Hz; apply Dense'.
    pose proof (distance_triangle m z (q' i) pj); pose proof (distance_triangle m (q' i) (q' j) pj).
    rewrite (distance_sym m (q i)) in Image.
    assert (distance m (q' i) (q' j) <= 5 * epsj); [|lra].
    eapply Rle_trans; [exact Image |].
    apply Rle_trans with ((1 + xi) * (2 * (5 / 4 * epsi))); [apply Rmult_le_compat_l; lra | lra]. }
  assert (Core : is_simplex_of label region n t ->
    (forall x r, is_empty_ball label q region m n t x r -> (n <= m)%nat /\ exists y u, is_empty_ball label q' region m n t y u) /\
    (forall y u, is_empty_ball label q' region m n t y u -> u <= 5 / 2 * epsi -> (exists x, near x /\ agree m (phi x) y) ->
       (n <= m)%nat /\ exists x r, is_empty_ball label q region m n t x r)).
  { intros T; apply (empty_balls_in_two_charts label q q' region m g mu rho epsi xi pi near phi) with (a := a); trivial.
    - destruct Finite as (L & HL); exists L; intros l (Pl & _); now apply HL.
    - intros b c (Pb & _) (Pc & _); now apply Separated.
    - intros y Hy; destruct (Dense y) as (l & Pl & Hl); [lra |]; exists l; repeat split; trivial; unfold near.
      pose proof (distance_triangle m (q l) y pi) as Tr; rewrite (distance_sym m (q l) y) in Tr; lra.
    - intros l Rl; apply Rl.
    - intros l Rl; apply Seen, Rl.
    - now rewrite Ta. }
  split; [split |].
  - intros (x & r & Dx); apply InI in Dx; destruct Dx as (T1 & B).
    destruct (Core (conj T1 Inj)) as (F & _); destruct (F x r B) as (_ & y & u & B').
    exists y, u; apply InJ; split; trivial.
  - intros (y & u & Dy); pose proof (Radius y u Dy) as Hu; pose proof Dy as Dy'; apply InJ in Dy; destruct Dy as (T1 & B).
    destruct (Core (conj T1 Inj)) as (_ & F).
    assert (Vy : V y).
    { apply Onto; rewrite distance_sym; destruct B as (On & _); specialize (On a Ha); cbv beta in On; rewrite Ta in On.
      rewrite On; lra. }
    destruct (F y u B ltac:(lra)) as (_ & x & r & B').
    { exists (psi y); apply Inverse, Vy. }
    exists x, r; apply InI; split; trivial.
  - intros (x & r & Dx); apply InI in Dx; destruct Dx as (T1 & B).
    destruct (Core (conj T1 Inj)) as (F & _); now destruct (F x r B).
Qed.
