(** Empty balls that grow. A ball that is empty of points, with k + 1 ≤ m points on its boundary, can be moved until one
    more is on it, and so on until there are m + 1; it keeps those that it has, and a sum of differences of squared
    distances, an affine function of its centre, does not grow. Voronoi cells, as polytopes, are not needed. *)

Require Import Reals Lra Lia Psatz Classical List.
From Delcert Require Import vectors simplices circumcentres protected_stars stars.
Open Scope R_scope.

(** A direction that is orthogonal to fewer than m vectors. *)
Lemma orthogonal_direction m k (w : nat -> vector) :
  (k < m)%nat -> exists u, 0 < dot m u u /\ forall j, (j < k)%nat -> dot m u (w j) = 0.
Proof.
  intros H; destruct m as [|n]; [lia |].
  destruct (dependent_vectors n (fun a j => if Nat.ltb j k then w j a else 0)) as (u & (a & Ha & U) & Z).
  exists u; split.
  - apply Rlt_le_trans with (u a * u a); [destruct (Rtotal_order (u a) 0) as [|[|]]; [nra | contradiction | nra] |].
    apply (term_le_sum (S n) (fun b => u b * u b)); [intros; nra | lia].
  - intros j Hj; unfold dot; rewrite <- (Z j) by lia; apply sum_ext; intros b _.
    destruct (Nat.ltb_spec j k); [trivial | lia].
Qed.

(** The point s u away from x. *)
Definition along (x u : vector) (s : R) : vector := fun a => x a + s * u a.

Lemma squared_distance_along m p x u s :
  distance m p (along x u s) * distance m p (along x u s)
  = distance m p x * distance m p x - 2 * s * dot m u (minus p x) + s * s * dot m u u.
Proof.
  unfold distance; rewrite !norm_squared; unfold dot, minus, along.
  rewrite <- !sum_scal, <- sum_minus, <- sum_plus; apply sum_ext; intros; ring.
Qed.

(** |p − y|² − |z − y|², an affine function of y. *)
Definition excess (m : nat) (z y p : vector) : R :=
  distance m p y * distance m p y - distance m z y * distance m z y.

Lemma excess_along m z x u s p : excess m z (along x u s) p = excess m z x p - 2 * s * dot m u (minus p z).
Proof.
  unfold excess; rewrite !squared_distance_along.
  replace (dot m u (minus p z)) with (dot m u (minus p x) - dot m u (minus z x)); [ring |].
  unfold dot, minus; rewrite <- sum_minus; apply sum_ext; intros; ring.
Qed.

Lemma excess_nonneg m z y p : distance m z y <= distance m p y -> 0 <= excess m z y p.
Proof. intros H; pose proof (norm_nonneg m (minus z y)); fold (distance m z y) in *; unfold excess; nra. Qed.

Lemma distance_of_excess m z y p : 0 <= excess m z y p -> distance m z y <= distance m p y.
Proof. intros H; pose proof (norm_nonneg m (minus p y)); fold (distance m p y) in *; unfold excess in H; nra. Qed.

Lemma distance_of_no_excess m z y p : excess m z y p = 0 -> distance m p y = distance m z y.
Proof.
  intros H; pose proof (norm_nonneg m (minus p y)); pose proof (norm_nonneg m (minus z y)).
  fold (distance m p y) (distance m z y) in *; unfold excess in H; nra.
Qed.

Lemma least_of_finitely_many (label : Type) (P : label -> Prop) (f : label -> R) (L : list label) :
  (exists l, In l L /\ P l) -> exists l, In l L /\ P l /\ forall l', In l' L -> P l' -> f l <= f l'.
Proof.
  induction L as [|b L IH]; intros (l & Hl & Pl); [destruct Hl |].
  destruct (classic (exists l', In l' L /\ P l')) as [E|N].
  - destruct (IH E) as (c & Hc & Pc & C).
    destruct (classic (P b /\ f b < f c)) as [(Pb & B)|NB].
    + exists b; repeat split; trivial; [now left |]; intros l' [<-|Hl'] Pl'; [lra |]; specialize (C l' Hl' Pl'); lra.
    + exists c; repeat split; trivial; [now right |]; intros l' [<-|Hl'] Pl'; [|now apply C].
      apply Rnot_lt_le; intros B; apply NB; now split.
  - destruct Hl as [<-|Hl]; [|exfalso; apply N; now exists l].
    exists b; repeat split; trivial; [now left |]; intros l' [<-|Hl'] Pl'; [lra | exfalso; apply N; now exists l'].
Qed.

Section Points.
Variable label : Type.
Variable q : label -> vector.
Variable region : label -> Prop.
Variables (m : nat) (e : R).
Hypothesis radius : 0 < e.
Hypothesis finite : exists L : list label, forall l, region l -> In l L.

(** The ball about x with the points of t on its boundary is empty. *)
Definition is_empty_ball (n : nat) (t : nat -> label) (x : vector) (r : R) : Prop :=
  circumscribes m n (fun i => q (t i)) x r /\ forall l, region l -> r <= distance m (q l) x.

(** Density about the point with the label i. *)
Definition is_dense_about (i : label) : Prop :=
  forall y, distance m y (q i) <= e -> exists l, region l /\ distance m y (q l) < e.

(** Σ |q_{f a} − y|² − |q_i − y|² over the labels f 0, …, f n. *)
Definition total_excess (n : nat) (f : nat -> label) (i : label) (y : vector) : R :=
  sum (S n) (fun a => excess m (q i) y (q (f a))).

Definition then_comes (k : nat) (t : nat -> label) (l : label) : nat -> label := fun j => if Nat.leb j k then t j else l.

Lemma before_then k t l j : (j <= k)%nat -> then_comes k t l j = t j.
Proof. intros H; unfold then_comes; destruct (Nat.leb_spec j k); [trivial | lia]. Qed.

Lemma last_then k t l : then_comes k t l (S k) = l.
Proof. unfold then_comes; destruct (Nat.leb_spec (S k) k); [lia | trivial]. Qed.

(** One point more. *)
Lemma empty_ball_grows k t x r n f :
  (k < m)%nat -> is_simplex_of label region k t -> is_empty_ball k t x r -> is_dense_about (t O) ->
  exists l x' r', is_simplex_of label region (S k) (then_comes k t l) /\ is_empty_ball (S k) (then_comes k t l) x' r' /\
    total_excess n f (t O) x' <= total_excess n f (t O) x.
Proof.
  intros Hk (T1 & T2) (On & Empty) Dense.
  destruct (orthogonal_direction m k (fun j => minus (q (t (S j))) (q (t O))) Hk) as (u & U & Z).
  (* the sign for which the sum does not grow *)
  assert (V : exists v, 0 < dot m v v /\ (forall j, (j <= k)%nat -> dot m v (minus (q (t j)) (q (t O))) = 0) /\
                        0 <= sum (S n) (fun a => dot m v (minus (q (f a)) (q (t O))))).
  { assert (Z' : forall j, (j <= k)%nat -> dot m u (minus (q (t j)) (q (t O))) = 0).
    { intros [|j] Hj; [|apply Z; lia].
      unfold dot, minus; rewrite (sum_ext m _ (fun _ => 0)); [apply sum_zero | intros; ring]. }
    assert (Neg : forall w, dot m (fun a => - u a) w = - dot m u w).
    { intros w; unfold dot; replace (- sum m (fun i => u i * w i)) with (-1 * sum m (fun i => u i * w i)) by ring.
      rewrite <- sum_scal; apply sum_ext; intros; ring. }
    destruct (Rle_dec 0 (sum (S n) (fun a => dot m u (minus (q (f a)) (q (t O)))))) as [L|L].
    - exists u; auto.
    - exists (fun a => - u a); repeat split.
      + rewrite Neg, dot_comm, Neg; lra.
      + intros j Hj; rewrite Neg, Z' by trivial; ring.
      + rewrite (sum_ext (S n) _ (fun a => -1 * dot m u (minus (q (f a)) (q (t O))))) by (intros; rewrite Neg; ring).
        rewrite sum_scal; lra. }
  clear u U Z; destruct V as (v & Hv & Z & Slope).
  pose (z := q (t O)).
  assert (Rz : r = distance m z x) by (symmetry; apply (On O); lia).
  assert (E0 : forall l, region l -> 0 <= excess m z x (q l)).
  { intros l Hl; apply excess_nonneg; rewrite <- Rz; now apply Empty. }
  (* some point lies ahead *)
  assert (Ahead : exists l, region l /\ 0 < dot m v (minus (q l) z)).
  { apply NNPP; intros N.
    pose (s := (e + r) / norm m v).
    assert (Nv : 0 < norm m v).
    { pose proof (norm_nonneg m v); pose proof (norm_squared m v); destruct (Req_dec (norm m v) 0) as [X|]; [rewrite X in *; lra | lra]. }
    assert (r0 : 0 <= r) by (rewrite Rz; apply norm_nonneg).
    assert (S0 : 0 <= s) by (apply quotient_nonneg; lra).
    assert (Far : e <= distance m z (along x v s)).
    { pose proof (distance_triangle m x z (along x v s)) as T; rewrite (distance_sym m x z), <- Rz in T.
      assert (distance m x (along x v s) = e + r); [|lra].
      transitivity (norm m (fun a => s * v a)).
      - unfold distance, norm, dot; f_equal; apply sum_ext; intros; unfold minus, along; ring.
      - rewrite norm_scal by trivial; unfold s; field; lra. }
    apply (Rlt_irrefl e); apply Rle_lt_trans with (1 := Far).
    apply (radius_of_a_star label q region m (t O) e (along x v s)); trivial.
    intros l Hl _; apply distance_of_excess; rewrite excess_along; fold z.
    specialize (E0 l Hl); apply Rnot_lt_le; intros B; apply N; exists l; split; trivial.
    apply Rnot_le_lt; intros D; assert (s * dot m v (minus (q l) z) <= 0) by nra; lra. }
  destruct finite as (L & HL).
  destruct (least_of_finitely_many label (fun l => region l /\ 0 < dot m v (minus (q l) z))
              (fun l => excess m z x (q l) / (2 * dot m v (minus (q l) z))) L) as (l & _ & (Rl & Dl) & Least).
  { destruct Ahead as (l & Rl & Dl); exists l; auto. }
  set (s := excess m z x (q l) / (2 * dot m v (minus (q l) z))) in *.
  assert (S0 : 0 <= s) by (apply quotient_nonneg; [now apply E0 | lra]).
  exists l, (along x v s), (distance m z (along x v s)).
  assert (New : forall j, (j <= k)%nat -> t j <> l).
  { intros j Hj E; specialize (Z j Hj); rewrite E in Z; fold z in Z; lra. }
  split; [split |split; [split |]].
  - intros j Hj; destruct (Nat.eq_dec j (S k)) as [->|D]; [now rewrite last_then | rewrite before_then by lia; apply T1; lia].
  - intros a b Ha Hb; destruct (Nat.eq_dec a (S k)) as [->|Da], (Nat.eq_dec b (S k)) as [->|Db]; trivial.
    + rewrite last_then, before_then by lia; intros E; exfalso; apply (New b); [lia | auto].
    + rewrite last_then, before_then by lia; intros E; exfalso; apply (New a); [lia | auto].
    + rewrite !before_then by lia; apply T2; lia.
  - intros j Hj; apply distance_of_no_excess; rewrite excess_along; destruct (Nat.eq_dec j (S k)) as [->|D].
    + rewrite last_then; unfold s; field; lra.
    + rewrite before_then by lia; unfold z; rewrite Z by lia.
      replace (excess m (q (t O)) x (q (t j))) with 0; [ring |].
      unfold excess; pose proof (On j ltac:(lia)) as A; cbv beta in A; rewrite A; fold z; rewrite <- Rz; ring.
  - intros l' Hl'; apply distance_of_excess; rewrite excess_along; specialize (E0 l' Hl').
    destruct (Rle_dec (dot m v (minus (q l') z)) 0) as [N|P].
    + assert (s * dot m v (minus (q l') z) <= 0) by nra; lra.
    + apply Rnot_le_lt in P; specialize (Least l' (HL l' Hl') (conj Hl' P)).
      apply (Rmult_le_compat_r (2 * dot m v (minus (q l') z))) in Least; [|lra].
      replace (excess m z x (q l') / (2 * dot m v (minus (q l') z)) * (2 * dot m v (minus (q l') z)))
        with (excess m z x (q l')) in Least by (field; lra); lra.
  - unfold total_excess; fold z.
    rewrite (sum_ext (S n) _ (fun a => excess m z x (q (f a)) - 2 * s * dot m v (minus (q (f a)) z)))
      by (intros; apply excess_along).
    rewrite sum_minus, sum_scal; fold z in Slope; set (c := sum (S n) _) in *; nra.
Qed.

(** Until there are m + 1. *)
Theorem empty_ball_with_a_simplex k t x r n f :
  (k <= m)%nat -> is_simplex_of label region k t -> is_empty_ball k t x r -> is_dense_about (t O) ->
  exists t' x' r', (forall j, (j <= k)%nat -> t' j = t j) /\ is_simplex_of label region m t' /\ is_empty_ball m t' x' r' /\
    total_excess n f (t O) x' <= total_excess n f (t O) x.
Proof.
  intros Hk; remember (m - k)%nat as g eqn:G; revert k t x r Hk G; induction g as [|g IH]; intros k t x r Hk G T B Dense.
  - replace k with m in * by lia; exists t, x, r; repeat split; try apply T; try apply B; trivial; lra.
  - destruct (empty_ball_grows k t x r n f ltac:(lia) T B Dense) as (l & x' & r' & T' & B' & F).
    assert (E : then_comes k t l O = t O) by (apply before_then; lia).
    destruct (IH (S k) (then_comes k t l) x' r' ltac:(lia) ltac:(lia) T' B' ltac:(rewrite E; trivial))
      as (t' & x'' & r'' & K & T'' & B'' & F'').
    exists t', x'', r''; rewrite E in F''; repeat split; try apply T''; try apply B''; [|lra].
    intros j Hj; rewrite K by lia; now apply before_then.
Qed.
End Points.
