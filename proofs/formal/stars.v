(** lem:inclusion.star.equivalences: a star of a Delaunay complex depends on near points only. *)

Require Import Reals Lra Lia Psatz.
From Delcert Require Import vectors simplices circumcentres.
Open Scope R_scope.

(** If points are e-dense near q_i, an empty ball with q_i on its boundary has a radius below e: otherwise the ball of
    radius e that touches it in q_i from inside contains a point. *)
Lemma radius_of_a_star (label : Type) (q : label -> vector) (all : label -> Prop) m i e x r :
  0 < e -> distance m (q i) x = r ->
  (forall y, distance m y (q i) <= e -> exists l, all l /\ distance m y (q l) < e) ->
  (forall l, all l -> distance m (q l) (q i) < 2 * e -> r <= distance m (q l) x) -> r < e.
Proof.
  intros He Hi Dense Empty; apply Rnot_le_lt; intros L.
  pose (y := fun a => q i a + e / r * (x a - q i a)).
  assert (Y1 : distance m (q i) y = e).
  { apply eq_trans with (norm m (fun a => e / r * minus (q i) x a)).
    - unfold distance, norm, dot; f_equal; apply sum_ext; intros; unfold minus, y; ring.
    - rewrite norm_scal by (apply quotient_nonneg; lra); fold (distance m (q i) x); rewrite Hi; field; lra. }
  assert (Y2 : distance m y x = r - e).
  { apply eq_trans with (norm m (fun a => (1 - e / r) * minus (q i) x a)).
    - apply norm_ext; intros; unfold minus, y; ring.
    - assert (e / r <= 1) by (apply quotient_at_most; lra).
      rewrite norm_scal by lra; fold (distance m (q i) x); rewrite Hi; field; lra. }
  destruct (Dense y) as (l & Al & Hl); [rewrite distance_sym; lra |].
  pose proof (distance_triangle m (q l) y (q i)) as T1; pose proof (distance_triangle m (q l) y x) as T2.
  rewrite (distance_sym m (q l) y) in T1, T2; rewrite (distance_sym m y (q i)), Y1 in T1; rewrite Y2 in T2.
  specialize (Empty l Al ltac:(lra)); lra.
Qed.

(** The labels t 0, …, t n span a simplex of the Delaunay complex of the points of A, with a ball about x. *)
Definition is_delaunay (label : Type) (q : label -> vector) (m : nat) (A : label -> Prop) (n : nat) (t : nat -> label)
    (x : vector) (r : R) : Prop :=
  (forall i, (i <= n)%nat -> A (t i)) /\ circumscribes m n (fun i => q (t i)) x r /\ forall l, A l -> r <= distance m (q l) x.

(** The star of i is the same in any two sets of points, one in the other, that have the same points within 2e of q_i. *)
Theorem star_of_near_points (label : Type) (q : label -> vector) (A B : label -> Prop) m i e n t x r :
  0 < e -> (forall l, B l -> A l) -> (forall l, A l -> distance m (q l) (q i) < 2 * e -> B l) ->
  (forall y, distance m y (q i) <= e -> exists l, A l /\ distance m y (q l) < e) ->
  (exists j, (j <= n)%nat /\ t j = i) ->
  (is_delaunay label q m B n t x r <-> is_delaunay label q m A n t x r) /\
  (is_delaunay label q m A n t x r -> r < e /\ forall j, (j <= n)%nat -> distance m (q (t j)) (q i) < 2 * e).
Proof.
  intros He BA AB Dense (j & Hj & Tj).
  assert (Radius : circumscribes m n (fun i => q (t i)) x r -> (forall l, B l -> r <= distance m (q l) x) -> r < e).
  { intros On Empty; apply (radius_of_a_star label q A m i e x r He); trivial.
    - specialize (On j Hj); cbv beta in On; now rewrite Tj in On.
    - intros l Al Hl; apply Empty, AB; trivial. }
  assert (Vertices : circumscribes m n (fun i => q (t i)) x r -> r < e ->
                     forall l, (l <= n)%nat -> distance m (q (t l)) (q i) < 2 * e).
  { intros On L l Hl; pose proof (On l Hl) as O1; pose proof (On j Hj) as O2; cbv beta in O1, O2; rewrite Tj in O2.
    pose proof (distance_triangle m (q (t l)) x (q i)) as T; rewrite (distance_sym m x (q i)) in T; lra. }
  split; [split |].
  - intros (V & On & Empty); pose proof (Radius On Empty) as L; split; [intros k Hk; apply BA; now apply V |]; split; trivial.
    intros l Al; apply Rnot_lt_le; intros N.
    pose proof (On j Hj) as O2; cbv beta in O2; rewrite Tj in O2.
    pose proof (distance_triangle m (q l) x (q i)) as T; rewrite (distance_sym m x (q i)) in T.
    specialize (Empty l (AB l Al ltac:(lra))); lra.
  - intros (V & On & Empty); assert (L : r < e) by (apply Radius; auto); split; [|split; auto].
    intros k Hk; apply AB; auto.
  - intros (V & On & Empty); assert (L : r < e) by (apply Radius; auto); split; auto.
Qed.

(** lem:inclusion.star.equivalences, first part: star(p′_i; Del(Q′_i)) = star(p′_i; Del(P′_i)), Q′_i the points of P′_i
    within 6ε_i of p_i, and its vertices are more than 2ε′_i from the sphere of radius 6ε_i. *)
Theorem star_in_the_region (label : Type) (q : label -> vector) (points : label -> Prop) m pi eps rho i n t x r :
  0 < eps -> 0 <= rho <= 1 / 4 ->
  let eps' := (1 + rho) * eps in
  let region := fun l => points l /\ distance m (q l) pi < 6 * eps in
  (forall y, distance m y pi <= 8 * eps -> exists l, points l /\ distance m y (q l) < eps') ->
  distance m (q i) pi <= rho * eps -> (exists j, (j <= n)%nat /\ t j = i) ->
  (is_delaunay label q m region n t x r <-> is_delaunay label q m points n t x r) /\
  (is_delaunay label q m points n t x r -> forall j, (j <= n)%nat -> 2 * eps' < 6 * eps - distance m (q (t j)) pi).
Proof.
  intros He Hrho eps' region Dense Near T.
  assert (E1 : 0 < eps' <= 5 / 4 * eps) by (unfold eps'; split; nra).
  assert (P : distance m (q i) pi <= 1 / 4 * eps) by nra.
  destruct (star_of_near_points label q points region m i eps' n t x r) as (S & V); trivial; try lra.
  - intros l Rl; apply Rl.
  - intros l Al Hl; split; trivial; pose proof (distance_triangle m (q l) (q i) pi); lra.
  - intros y Hy; apply Dense; pose proof (distance_triangle m y (q i) pi); lra.
  - split; trivial; intros D j Hj; destruct (V D) as (_ & W); specialize (W j Hj).
    pose proof (distance_triangle m (q (t j)) (q i) pi); lra.
Qed.

(** Second part, in the chart j of a vertex of the star: star(p′_i; Del(φ_ji(Q′_i))) = star(p′_i; Del(P′_j)). q are the
    positions in chart j, q' those in chart i. What the transition function is used for are the hypotheses: the points
    of Q′_i are among those of P′_j; a point of P′_j within 2ε′_j of p′_i is in chart i, not farther than 1 + ξ₀ times. *)
Theorem star_in_another_chart (label : Type) (q q' : label -> vector) (points points' : label -> Prop)
    m pi pj epsi epsj rho rho' xi eps0 i j n t x r :
  0 < epsi -> 0 < epsj -> 0 <= rho <= 1 / 4 -> 0 <= rho' <= 1 / 4 -> 0 <= xi -> 0 <= eps0 -> (1 + eps0) * (1 + xi) <= 2 ->
  epsj <= (1 + eps0) * epsi -> epsi <= (1 + eps0) * epsj ->
  let epsj' := (1 + rho) * epsj in
  let region := fun l => points' l /\ distance m (q' l) pi < 6 * epsi in
  (forall l, region l -> points l) ->
  (forall l, points l -> distance m (q l) (q i) < 2 * epsj' ->
     points' l /\ distance m (q' l) (q' i) <= (1 + xi) * distance m (q l) (q i)) ->
  (forall y, distance m y pj <= 8 * epsj -> exists l, points l /\ distance m y (q l) < epsj') ->
  distance m (q' i) pi <= rho' * epsi -> distance m (q j) pj <= rho * epsj ->
  distance m (q' i) (q' j) < 2 * ((1 + rho') * epsi) -> distance m (q i) (q j) <= (1 + xi) * distance m (q' i) (q' j) ->
  (exists k, (k <= n)%nat /\ t k = i) ->
  (is_delaunay label q m region n t x r <-> is_delaunay label q m points n t x r).
Proof.
  intros Hi Hj Hrho Hrho' Hxi He0 Hc Rij Rji epsj' region Sub Seen Dense Ni Nj Star Image T.
  assert (E1 : 0 < epsj' <= 5 / 4 * epsj) by (unfold epsj'; split; nra).
  assert (C1 : (1 + xi) * epsj <= 2 * epsi).
  { apply Rle_trans with ((1 + xi) * ((1 + eps0) * epsi)); [apply Rmult_le_compat_l; lra | nra]. }
  assert (C2 : (1 + xi) * epsi <= 2 * epsj).
  { apply Rle_trans with ((1 + xi) * ((1 + eps0) * epsj)); [apply Rmult_le_compat_l; lra | nra]. }
  (* p′_i is within 5ε_j of p′_j *)
  assert (D : distance m (q i) (q j) <= 5 * epsj).
  { eapply Rle_trans; [exact Image |].
    apply Rle_trans with ((1 + xi) * (2 * (5 / 4 * epsi))); [apply Rmult_le_compat_l; [lra |]; nra | lra]. }
  assert (Nj' : distance m (q j) pj <= 1 / 4 * epsj) by nra.
  assert (Ni' : distance m (q' i) pi <= 1 / 4 * epsi) by nra.
  destruct (star_of_near_points label q points region m i epsj' n t x r) as (S & _); trivial; try lra.
  - intros l Al Hl; destruct (Seen l Al Hl) as (A' & B); split; trivial.
    assert ((1 + xi) * distance m (q l) (q i) <= (1 + xi) * (5 / 2 * epsj)) by (apply Rmult_le_compat_l; lra).
    pose proof (distance_triangle m (q' l) (q' i) pi); lra.
  - intros y Hy; apply Dense.
    pose proof (distance_triangle m y (q i) pj); pose proof (distance_triangle m (q i) (q j) pj); lra.
Qed.
