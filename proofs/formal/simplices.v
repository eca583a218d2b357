(** Simplices of any dimension k in ℝᵐ for any m: altitudes, thickness, and the smallest singular value of the matrix of
    edges, lem:bound.skP and eq:upper.bnd.small.sing. *)

Require Import Reals Lra Lia Psatz.
From Delcert Require Import vectors.
Open Scope R_scope.

(** A k-simplex is its vertices p 0, …, p k. *)
Definition simplex := nat -> vector.

(** c 0 · p 0 + … + c k · p k; of affine weights, which add up to 1, a point of the affine hull. *)
Definition combination (k : nat) (c : vector) (p : simplex) : vector := fun a => sum (S k) (fun j => c j * p j a).

(** The altitude of p i is at least a: that far it is from all points of the affine hull of the opposite facet. *)
Definition altitude_at_least (m k : nat) (p : simplex) (i : nat) (a : R) : Prop :=
  forall c : vector, c i = 0 -> sum (S k) c = 1 -> a <= distance m (p i) (combination k c p).

Definition edges_at_most (m k : nat) (p : simplex) (d : R) : Prop :=
  forall i j, (i <= k)%nat -> (j <= k)%nat -> distance m (p i) (p j) <= d.

Definition is_longest_edge (m k : nat) (p : simplex) (d : R) : Prop :=
  edges_at_most m k p d /\ exists i j, (i <= k)%nat /\ (j <= k)%nat /\ distance m (p i) (p j) = d.

(** The thickness of p is at least t, its longest edge being d: every altitude is at least k·t·d. *)
Definition is_thick (m k : nat) (p : simplex) (d t : R) : Prop :=
  forall i, (i <= k)%nat -> altitude_at_least m k p i (INR k * t * d).

(** The thickness is t: the largest that p has. *)
Definition is_thickness (m k : nat) (p : simplex) (d t : R) : Prop :=
  is_thick m k p d t /\ forall u, is_thick m k p d u -> u <= t.

(** P·x for the matrix P whose columns are the edges p j − p b from the vertex p b (the column j = b is 0). *)
Definition edge_map (k : nat) (p : simplex) (b : nat) (x : vector) : vector :=
  fun a => sum (S k) (fun j => x j * (p j a - p b a)).

(** x without what stands at the index b: |x| for the vectors of ℝᵏ on which P acts is the norm of this. *)
Definition without (b : nat) (x : vector) : vector := fun j => if Nat.eqb j b then 0 else x j.
Definition norm_without (k b : nat) (x : vector) : R := norm (S k) (without b x).

(** s·|x| ≤ |P·x| for all x: the smallest singular value of P, the largest such s, is at least s. *)
Definition singular_values_at_least (m k : nat) (p : simplex) (b : nat) (s : R) : Prop :=
  forall x, s * norm_without k b x <= norm m (edge_map k p b x).

Definition unit_at (i : nat) : vector := fun j => if Nat.eqb j i then 1 else 0.

Lemma sum_unit_at n i (f : vector) : (i < n)%nat -> sum n (fun j => unit_at i j * f j) = f i.
Proof.
  intros H; rewrite <- (sum_single n i (f i) H) at 1.
  apply sum_ext; intros j _; unfold unit_at; destruct (Nat.eqb_spec j i) as [->|]; ring.
Qed.

Lemma sum_of_unit n i : (i < n)%nat -> sum n (unit_at i) = 1.
Proof. intros H; apply sum_single; trivial. Qed.

(** A sum of k + 1 terms of which one is 0 and the others are at most a. *)
Lemma sum_without_le k b f a :
  (b <= k)%nat -> f b = 0 -> (forall j, (j <= k)%nat -> j <> b -> f j <= a) -> sum (S k) f <= INR k * a.
Proof.
  intros Hb Hf H.
  apply Rle_trans with (sum (S k) (fun j => a - (if Nat.eqb j b then a else 0))).
  - apply sum_le; intros j Hj; destruct (Nat.eqb_spec j b) as [->|D]; [rewrite Hf; lra |].
    rewrite Rminus_0_r; apply H; [lia | trivial].
  - rewrite sum_minus, sum_const, sum_single by lia; rewrite S_INR; lra.
Qed.

Lemma norm_without_nonneg k b x : 0 <= norm_without k b x.
Proof. apply norm_nonneg. Qed.

Lemma norm_without_squared k b x :
  norm_without k b x * norm_without k b x = sum (S k) (fun j => without b x j * without b x j).
Proof. apply norm_squared. Qed.

Lemma coordinate_le_norm k b x i : (i <= k)%nat -> i <> b -> Rabs (x i) <= norm_without k b x.
Proof.
  intros Hi D; apply abs_le_of_squares; [apply norm_without_nonneg |].
  rewrite norm_without_squared.
  replace (x i * x i) with (without b x i * without b x i).
  - apply (term_le_sum (S k) (fun j => without b x j * without b x j)); [intros; nra | lia].
  - unfold without; destruct (Nat.eqb_spec i b); [contradiction | trivial].
Qed.

(** |x i| · altitude of p i ≤ |P·x|: P·x is x i times the way from a point of the affine hull of the others to p i. *)
Lemma altitude_times_coordinate m k p b x i a :
  (b <= k)%nat -> (i <= k)%nat -> i <> b -> altitude_at_least m k p i a ->
  Rabs (x i) * a <= norm m (edge_map k p b x).
Proof.
  intros Hb Hi D Ha.
  destruct (Req_dec (x i) 0) as [Z|NZ].
  { rewrite Z, Rabs_R0, Rmult_0_l; apply norm_nonneg. }
  set (total := sum (S k) x).
  set (y := fun j => x j - total * unit_at b j).
  set (c := fun j => unit_at i j - / x i * y j).
  assert (Hy : sum (S k) y = 0).
  { unfold y; rewrite sum_minus, sum_scal, sum_of_unit by lia; unfold total; lra. }
  assert (yi : y i = x i).
  { unfold y, unit_at; destruct (Nat.eqb_spec i b); [contradiction | ring]. }
  assert (c0 : c i = 0).
  { unfold c; rewrite yi; unfold unit_at; rewrite Nat.eqb_refl; now field. }
  assert (c1 : sum (S k) c = 1).
  { unfold c; rewrite sum_minus, sum_scal, sum_of_unit, Hy by lia; lra. }
  specialize (Ha c c0 c1).
  apply Rle_trans with (Rabs (x i) * distance m (p i) (combination k c p)).
  { apply Rmult_le_compat_l; [apply Rabs_pos | trivial]. }
  right; unfold distance; rewrite <- norm_scal by apply Rabs_pos.
  assert (E : forall l, x i * minus (p i) (combination k c p) l = edge_map k p b x l).
  { intros l; unfold minus, combination, edge_map, c.
    rewrite (sum_ext (S k) (fun j => (unit_at i j - / x i * y j) * p j l)
                           (fun j => unit_at i j * p j l - / x i * (y j * p j l))) by (intros; ring).
    rewrite sum_minus, sum_scal, (sum_unit_at (S k) i (fun j => p j l)) by lia.
    rewrite (sum_ext (S k) (fun j => y j * p j l) (fun j => x j * p j l - total * (unit_at b j * p j l)))
      by (intros; unfold y; ring).
    rewrite sum_minus, sum_scal, (sum_unit_at (S k) b (fun j => p j l)) by lia.
    rewrite (sum_ext (S k) (fun j => x j * (p j l - p b l)) (fun j => x j * p j l - x j * p b l)) by (intros; ring).
    rewrite sum_minus, sum_scal_right; unfold total; field; trivial. }
  unfold norm; f_equal; apply sum_ext; intros l _.
  rewrite <- E; unfold Rabs; destruct Rcase_abs; ring.
Qed.

(** lem:bound.skP, the bound on the smallest singular value: s_k(P) ≥ √k · thickness · longest edge. *)
Theorem thickness_and_singular_value m k p b d t :
  (1 <= k)%nat -> (b <= k)%nat -> 0 <= d -> 0 <= t ->
  is_thick m k p d t -> singular_values_at_least m k p b (sqrt (INR k) * t * d).
Proof.
  intros Hk Hb Hd Ht H x.
  set (n := norm m (edge_map k p b x)).
  assert (Hn : 0 <= n) by apply norm_nonneg.
  assert (K : 1 <= INR k) by (change 1 with (INR 1); now apply le_INR).
  assert (td : 0 <= t * d) by (now apply Rmult_le_pos).
  assert (B : INR k * (t * d) * (t * d) * sum (S k) (fun j => without b x j * without b x j) <= n * n).
  { assert (C : sum (S k) (fun j => INR k * (t * d) * (INR k * (t * d)) * (without b x j * without b x j))
                <= INR k * (n * n)).
    { apply (sum_without_le k b); trivial.
      - unfold without; rewrite Nat.eqb_refl; ring.
      - intros j Hj D.
        pose proof (altitude_times_coordinate m k p b x j _ Hb Hj D (H j Hj)) as A; fold n in A.
        unfold without; destruct (Nat.eqb_spec j b); [contradiction |].
        assert (P : 0 <= INR k * t * d) by nra.
        pose proof (Rmult_le_pos _ _ (Rabs_pos (x j)) P) as U.
        pose proof (Rmult_le_compat _ _ _ _ U U A A) as S.
        replace (x j * x j) with (Rabs (x j) * Rabs (x j)) by (unfold Rabs; destruct Rcase_abs; ring).
        lra. }
    rewrite sum_scal in C; set (q := sum _ _) in *; clearbody q; nra. }
  apply le_of_squares; trivial.
  replace (sqrt (INR k) * t * d * norm_without k b x * (sqrt (INR k) * t * d * norm_without k b x))
    with (sqrt (INR k) * sqrt (INR k) * (t * d) * (t * d) * (norm_without k b x * norm_without k b x)) by ring.
  rewrite sqrt_sqrt, norm_without_squared by lra; trivial.
Qed.

(** eq:upper.bnd.small.sing: s_k(P) is at most the altitude of every vertex but the one where the edges begin. *)
Theorem singular_value_from_above m k p b s i :
  (b <= k)%nat -> (i <= k)%nat -> i <> b -> 0 <= s ->
  singular_values_at_least m k p b s -> altitude_at_least m k p i s.
Proof.
  intros Hb Hi D Hs H c c0 c1.
  set (x := fun j => unit_at i j - c j).
  apply Rle_trans with (s * norm_without k b x).
  - rewrite <- (Rmult_1_r s) at 1; apply Rmult_le_compat_l; trivial.
    apply Rle_trans with (Rabs (x i)); [|now apply coordinate_le_norm].
    unfold x, unit_at; rewrite Nat.eqb_refl, c0, Rminus_0_r, Rabs_R1; lra.
  - eapply Rle_trans; [apply H |]; right; unfold distance; apply norm_ext; intros l _.
    unfold edge_map, x, minus, combination.
    rewrite (sum_ext (S k) _ (fun j => unit_at i j * (p j l - p b l) - (c j * p j l - c j * p b l))) by (intros; ring).
    rewrite sum_minus, (sum_unit_at (S k) i (fun j => p j l - p b l)), sum_minus, sum_scal_right, c1 by lia; ring.
Qed.

(** Altitudes are at most as long as edges, so thickness is at most 1. *)
Lemma thickness_at_most_one m k p d t :
  (1 <= k)%nat -> 0 < d -> edges_at_most m k p d -> is_thick m k p d t -> t <= 1.
Proof.
  intros Hk Hd He Ht.
  specialize (Ht O ltac:(lia) (unit_at 1) eq_refl (sum_of_unit (S k) 1 ltac:(lia))).
  assert (E : distance m (p O) (combination k (unit_at 1) p) = distance m (p O) (p 1%nat)).
  { unfold distance; apply norm_ext; intros l _; unfold minus, combination.
    now rewrite (sum_unit_at (S k) 1 (fun j => p j l)) by lia. }
  rewrite E in Ht; specialize (He O 1%nat ltac:(lia) ltac:(lia)).
  assert (K : 1 <= INR k) by (change 1 with (INR 1); now apply le_INR).
  destruct (Rle_or_lt t 1); trivial.
  assert (d < INR k * t * d); [|lra].
  assert (1 < INR k * t) by nra; nra.
Qed.

(** faces-of-thick-simplices: if σ is t-thick, so is each face τ. A face is a set F of vertices, j its dimension, e its
    longest edge; its affine hulls are those of weights that vanish outside of F. *)
Theorem faces_of_thick_simplices m k p d t (F : nat -> Prop) j e :
  is_thick m k p d t -> (j <= k)%nat -> 0 <= t -> 0 <= e <= d ->
  forall i, (i <= k)%nat -> F i ->
  forall c : vector, (forall l, ~ F l -> c l = 0) -> c i = 0 -> sum (S k) c = 1 ->
  INR j * t * e <= distance m (p i) (combination k c p).
Proof.
  intros H Hj Ht He i Hi _ c _ c0 c1.
  eapply Rle_trans; [|now apply H].
  apply le_INR in Hj; pose proof (pos_INR j).
  apply Rmult_le_compat; try lra; nra.
Qed.
