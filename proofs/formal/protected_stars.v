(** lem:protected.stars: without forbidden configurations, simplices with empty balls are good and protected. *)

Require Import Reals Lra Lia Psatz Classical FunctionalExtensionality.
From Delcert Require Import vectors simplices circumradius weights projections circumcentres forbidden_configurations stars.
Open Scope R_scope.

(** * Points of ℝᵐ are dependent if they are more than m + 1 *)

Lemma dependent_vectors m : forall u : nat -> vector, exists x, (exists j, (j <= m)%nat /\ x j <> 0) /\
  forall a, (a < m)%nat -> sum (S m) (fun j => x j * u j a) = 0.
Proof.
  induction m as [|m IH]; intros u.
  { exists (fun _ => 1); split; [exists O; split; [lia | lra] | intros; lia]. }
  destruct (classic (exists i, (i <= S m)%nat /\ u i m <> 0)) as [(i & Hi & Ui)|N].
  - destruct (IH (fun j a => u (skip i j) a - u (skip i j) m / u i m * u i a)) as (x & (j0 & Hj0 & X0) & X).
    pose (t := sum (S m) (fun j => x j * u (skip i j) m)).
    assert (Inv : forall j, exists l, skip i j = j \/ skip i j = S l) by (intros j; exists j; unfold skip; destruct Nat.ltb; auto).
    (* the weights of the others are those of x, that of i is what makes the last coordinate 0 *)
    pose (back := fun j => if Nat.ltb j i then j else pred j).
    assert (B : forall j, back (skip i j) = j).
    { intros j; unfold back, skip; destruct (Nat.ltb_spec j i) as [L|L].
      - destruct (Nat.ltb_spec j i); [trivial | lia].
      - destruct (Nat.ltb_spec (S j) i); [lia | trivial]. }
    assert (D : forall j, skip i j <> i) by (intros j; unfold skip; destruct (Nat.ltb_spec j i); lia).
    exists (fun j => if Nat.eqb j i then - (t / u i m) else x (back j)); split.
    + exists (skip i j0); split; [apply skip_range; lia |].
      destruct (Nat.eqb_spec (skip i j0) i) as [E|_]; [now apply D in E | now rewrite B].
    + intros a Ha; rewrite (sum_skip (S m) i) by lia; rewrite Nat.eqb_refl.
      rewrite (sum_ext (S m) _ (fun j => x j * u (skip i j) a)).
      2: { intros j _; destruct (Nat.eqb_spec (skip i j) i) as [E|_]; [now apply D in E | now rewrite B]. }
      destruct (Nat.eq_dec a m) as [->|Da]; [fold t; field; trivial |].
      specialize (X a ltac:(lia)).
      rewrite (sum_ext (S m) _ (fun j => x j * u (skip i j) a - u i a / u i m * (x j * u (skip i j) m))) in X
        by (intros; field; trivial).
      rewrite sum_minus, sum_scal in X; fold t in X.
      replace (- (t / u i m) * u i a) with (- (u i a / u i m * t)) by (field; trivial); lra.
  - destruct (IH u) as (x & (j0 & Hj0 & X0) & X).
    exists (fun j => if Nat.leb j m then x j else 0); split.
    + exists j0; split; [lia |]; destruct (Nat.leb_spec j0 m); [trivial | lia].
    + intros a Ha; change (sum (S (S m)) ?f) with (sum (S m) f + f (S m)); cbv beta.
      destruct (Nat.leb_spec (S m) m); [lia |].
      rewrite (sum_ext (S m) _ (fun j => x j * u j a)).
      2: { intros j Hj; destruct (Nat.leb_spec j m); [trivial | lia]. }
      destruct (Nat.eq_dec a m) as [->|Da]; [|rewrite X by lia; ring].
      rewrite (sum_ext (S m) _ (fun _ => 0)), sum_zero; [ring |].
      intros j Hj; destruct (Req_dec (u j m) 0) as [Z|NZ]; [rewrite Z; ring |].
      exfalso; apply N; exists j; split; [lia | trivial].
Qed.

Lemma dependent_points m (p : simplex) : exists x i, (i <= S m)%nat /\ x i <> 0 /\ sum (S (S m)) x = 0 /\
  forall a, (a < m)%nat -> combination (S m) x p a = 0.
Proof.
  destruct (dependent_vectors (S m) (fun j a => if Nat.ltb a m then p j a else 1)) as (x & (i & Hi & X0) & X).
  exists x, i; repeat split; trivial.
  - rewrite <- (X m) by lia; apply sum_ext; intros j _; destruct (Nat.ltb_spec m m); [lia | ring].
  - intros a Ha; rewrite <- (X a) by lia; apply sum_ext; intros j _; destruct (Nat.ltb_spec a m); [trivial | lia].
Qed.

(** An (m + 1)-simplex in ℝᵐ is not good: one of its altitudes is 0. *)
Lemma too_many_points m p g s :
  0 < g -> 0 < s -> separated_vertices m (S m) p s -> ~ is_good m (S m) p g.
Proof.
  intros Hg Hs Sep (T & _).
  destruct (longest_edge_exists m (S m) p) as (d & Hd); specialize (T d Hd).
  destruct (dependent_points m p) as (x & i & Hi & Xi & x0 & X).
  specialize (T i Hi); pose proof (difference_weight m (S m) p x i _ ltac:(lia) Hi x0 T) as W.
  assert (Z : norm m (combination (S m) x p) = 0).
  { unfold norm, dot; rewrite (sum_ext m _ (fun _ => 0)); [rewrite sum_zero; apply sqrt_0 | intros; rewrite X by trivial; ring]. }
  rewrite Z in W.
  assert (P : 0 < INR (S m) * g ^ S m * d).
  { apply Rmult_lt_0_compat; [apply Rmult_lt_0_compat; [apply lt_0_INR; lia | now apply pow_lt] |].
    eapply Rlt_le_trans; [exact Hs |]; eapply Rle_trans; [|apply (proj1 Hd O 1%nat); lia]; apply Sep; lia. }
  pose proof (Rabs_pos_lt _ Xi); assert (0 < Rabs (x i) * (INR (S m) * g ^ S m * d)) by (now apply Rmult_lt_0_compat); lra.
Qed.

(** * Flakes in simplices that are not good *)

Lemma edges_are_good m p g : 0 <= g <= 1 -> is_good m 1 p g.
Proof.
  intros Hg; split; [|intros; exact I].
  intros d (_ & i & j & Hi & Hj & <-) l Hl c c0 c1.
  assert (E : distance m (p l) (combination 1 c p) = distance m (p O) (p 1%nat)).
  { destruct l as [|[|l]]; [| |lia]; simpl in c1.
    - apply norm_ext; intros a _; unfold minus, combination; simpl; rewrite c0; replace (c 1%nat) with 1 by lra; ring.
    - rewrite (distance_sym m (p O)); apply norm_ext; intros a _; unfold minus, combination; simpl; rewrite c0.
      replace (c O) with 1 by lra; ring. }
  rewrite E; pose proof (norm_nonneg m (minus (p O) (p 1%nat))) as N; fold (distance m (p O) (p 1%nat)) in N.
  simpl; set (d := distance m (p O) (p 1%nat)) in *.
  assert (L : 0 <= distance m (p i) (p j) <= d).
  { split; [apply norm_nonneg |].
    destruct i as [|[|i]], j as [|[|j]]; try lia; rewrite ?distance_zero; try (rewrite (distance_sym m (p 1%nat) (p O))); fold d; lra. }
  nra.
Qed.

(** Places of different vertices. *)
Definition is_selection (k n : nat) (s : nat -> nat) : Prop :=
  (forall i, (i <= k)%nat -> (s i <= n)%nat) /\ (forall i j, (i <= k)%nat -> (j <= k)%nat -> s i = s j -> i = j).

Lemma selection_skip k n v s : is_selection k n s -> is_selection k (S n) (fun i => skip v (s i)).
Proof.
  intros (A & B); split.
  - intros i Hi; apply skip_range; auto.
  - intros i j Hi Hj E; apply skip_injective in E; auto.
Qed.

Lemma flake_in_a_simplex m g : forall n p, ~ is_good m n p g ->
  exists k s, (S k <= n)%nat /\ is_selection (S k) n s /\ is_flake m k (fun i => p (s i)) g.
Proof.
  induction n as [|n IH]; intros p N; [exfalso; apply N; exact I |].
  destruct (classic (forall v, (v <= S n)%nat -> is_good m n (facet v p) g)) as [A|A].
  - exists n, (fun i => i); split; [lia |]; split; [split; auto | split; trivial].
  - apply not_all_ex_not in A as (v & A); apply imply_to_and in A as (Hv & A).
    destruct (IH (facet v p) A) as (k & s & Hk & Hs & F).
    exists k, (fun i => skip v (s i)); split; [lia |]; split; [now apply selection_skip | exact F].
Qed.

Definition join (q : vector) (p : simplex) : simplex := fun j => match j with O => q | S j => p j end.

Lemma facet_of_join q p : facet 0 (join q p) = p.
Proof. apply functional_extensionality; intros j; reflexivity. Qed.

Lemma other_facet_of_join v q p : facet (S v) (join q p) = join q (facet v p).
Proof.
  apply functional_extensionality; intros [|j]; [reflexivity |].
  change (join q p (skip (S v) (S j)) = p (skip v j)).
  unfold skip; change (Nat.ltb (S j) (S v)) with (Nat.ltb j v); destruct (Nat.ltb j v); reflexivity.
Qed.

(** If p is good and q ∗ p is not, a flake has the vertex q. *)
Lemma flake_in_a_join m g q : forall n p, is_good m n p g -> ~ is_good m (S n) (join q p) g ->
  exists k s, (k <= n)%nat /\ is_selection k n s /\ is_flake m k (join q (fun i => p (s i))) g.
Proof.
  induction n as [|n IH]; intros p G N.
  - exists O, (fun i => i); split; [lia |]; split; [split; auto | split; [exact N | intros; exact I]].
  - destruct (classic (forall v, (v <= S (S n))%nat -> is_good m (S n) (facet v (join q p)) g)) as [A|A].
    + exists (S n), (fun i => i); split; [lia |]; split; [split; auto | split; [exact N | exact A]].
    + apply not_all_ex_not in A as (v & A); apply imply_to_and in A as (Hv & A).
      destruct v as [|v]; [rewrite facet_of_join in A; contradiction |].
      rewrite other_facet_of_join in A.
      destruct (IH (facet v p) (proj2 G v ltac:(lia)) A) as (k & s & Hk & Hs & F).
      exists k, (fun i => skip v (s i)); split; [lia |]; split; [now apply selection_skip | exact F].
Qed.

(** * Protection *)

Section Points.
Variable label : Type.
Variable q : label -> vector.
(** The labels of the points that are looked at. *)
Variable region : label -> Prop.
Variables (m : nat) (g delta e s : R).
Hypothesis goodness : 0 < g <= 1.
Hypothesis protection : 0 <= delta.
Hypothesis separation : 0 < s.
Hypothesis separated : forall i j, region i -> region j -> i <> j -> s <= distance m (q i) (q j).

Definition is_simplex_of (n : nat) (t : nat -> label) : Prop :=
  (forall i, (i <= n)%nat -> region (t i)) /\ (forall i j, (i <= n)%nat -> (j <= n)%nat -> t i = t j -> i = j).

Hypothesis no_forbidden_configuration : forall k t,
  (1 <= k <= m)%nat -> is_simplex_of (S k) t -> ~ is_forbidden_configuration m k (fun i => q (t i)) g delta e.

(** The simplices that an empty ball of radius below e circumscribes are good, and no other point is within r + δ. *)
Theorem simplices_of_empty_balls_are_protected t x r :
  is_simplex_of m t -> circumscribes m m (fun i => q (t i)) x r -> r < e ->
  (forall l, region l -> r <= distance m (q l) x) ->
  is_good m m (fun i => q (t i)) g /\
  forall l, region l -> (forall i, (i <= m)%nat -> t i <> l) -> r + delta < distance m (q l) x.
Proof.
  intros (T1 & T2) On Hr Empty.
  assert (G : is_good m m (fun i => q (t i)) g).
  { apply NNPP; intros N; destruct (flake_in_a_simplex m g m _ N) as (k & c & Hk & (C1 & C2) & F).
    destruct k as [|k]; [apply (proj1 F), edges_are_good; lra |].
    apply (no_forbidden_configuration (S k) (fun i => t (c i)) ltac:(lia)).
    - split; [intros i Hi; now apply T1, C1 |]; intros i j Hi Hj E; apply C2; trivial; apply T2; auto.
    - split; [exact F |]; exists O, x, r; repeat split; try lia; trivial.
      + intros i Hi; apply (On (c (skip 0 i))), C1, skip_range; lia.
      + rewrite (On (c O)) by (apply C1; lia); lra.
      + rewrite (On (c O)) by (apply C1; lia); lra. }
  split; [exact G |]; intros l Hl Other.
  apply Rnot_le_lt; intros Near.
  assert (N : ~ is_good m (S m) (join (q l) (fun i => q (t i))) g).
  { apply (too_many_points m _ g s); try lra.
    intros [|i] [|j] Hi Hj D; simpl; try congruence; apply separated; auto; try (apply T1; lia).
    - intros E; apply (Other j); [lia | auto].
    - apply Other; lia.
    - intros E; apply D; f_equal; apply T2; auto; lia. }
  destruct (flake_in_a_join m g (q l) m _ G N) as (k & c & Hk & (C1 & C2) & F).
  destruct k as [|k]; [apply (proj1 F), edges_are_good; lra |].
  apply (no_forbidden_configuration (S k) (fun i => match i with O => l | S i => t (c i) end) ltac:(lia)).
  - split.
    + intros [|i] Hi; [trivial | apply T1, C1; lia].
    + intros [|i] [|j] Hi Hj E; trivial.
      * exfalso; apply (Other (c j)); [apply C1; lia | auto].
      * exfalso; apply (Other (c i)); [apply C1; lia | auto].
      * f_equal; apply C2; try lia; apply T2; auto; apply C1; lia.
  - assert (J : (fun i => q (match i with O => l | S i => t (c i) end)) = join (q l) (fun i => q (t (c i))))
      by (apply functional_extensionality; intros [|i]; reflexivity).
    rewrite J; split; [exact F |]; exists O, x, r; repeat split; try lia; trivial.
    + intros i Hi; rewrite facet_of_join; apply (On (c i)), C1; lia.
    + simpl; specialize (Empty l Hl); lra.
Qed.
End Points.

(** lem:protected.stars. P′_i = q is ε′-dense in B(p_i, 8ε), ε′ = (1 + ρ) ε, and p′_i within ρε of p_i; the region is
    B(p_i, 6ε), open or closed. The m-simplices of the star of p′_i with an empty circumscribing ball are Γ₀-good and
    δ-protected. That the radius of the ball is below ε′ is part of the proof. *)
Theorem protected_stars (label : Type) (q : label -> vector) (region : label -> Prop) m g delta s pi eps rho i0 t x r :
  (1 <= m)%nat -> 0 < g <= 1 -> 0 <= delta -> 0 < s -> 0 < eps -> 0 <= rho <= 1 / 4 ->
  let eps' := (1 + rho) * eps in
  (forall i j, region i -> region j -> i <> j -> s <= distance m (q i) (q j)) ->
  (forall y, distance m y pi <= 8 * eps -> exists l, distance m y (q l) < eps') ->
  (forall l, distance m (q l) pi < 6 * eps -> region l) ->
  distance m (q i0) pi <= rho * eps ->
  (forall k u, (1 <= k <= m)%nat -> is_simplex_of label region (S k) u ->
     ~ is_forbidden_configuration m k (fun i => q (u i)) g delta eps') ->
  is_simplex_of label region m t -> (exists i, (i <= m)%nat /\ t i = i0) ->
  circumscribes m m (fun i => q (t i)) x r -> (forall l, region l -> r <= distance m (q l) x) ->
  r < eps' /\ is_good m m (fun i => q (t i)) g /\
  forall l, region l -> (forall i, (i <= m)%nat -> t i <> l) -> r + delta < distance m (q l) x.
Proof.
  intros Hm Hg Hd Hs He Hrho eps' Sep Dense Region Near No T (i & Hi & Ti) On Empty.
  assert (E1 : 0 < eps' <= 5 / 4 * eps) by (unfold eps'; split; nra).
  assert (R : r < eps').
  { apply (radius_of_a_star label q (fun _ => True) m i0 eps' x r); try lra.
    - pose proof (On i Hi) as Oi; cbv beta in Oi; now rewrite Ti in Oi.
    - intros y Hy; destruct (Dense y) as (l & Hl); [|now exists l].
      pose proof (distance_triangle m y (q i0) pi); nra.
    - intros l _ Hl; apply Empty, Region; pose proof (distance_triangle m (q l) (q i0) pi); nra. }
  split; [exact R |].
  apply (simplices_of_empty_balls_are_protected label q region m g delta eps' s); trivial.
Qed.
