(** Projections onto affine hulls and circumscribing balls exist: what the paper's proofs take from linear algebra, by
    induction over the vertices. *)

Require Import Reals Lra Lia Psatz.
From Delcert Require Import vectors simplices weights.
Open Scope R_scope.

(** The weights c − s·e of p 0, …, p k, and s for p (k + 1). *)
Definition extended (k : nat) (s : R) (c e : vector) : vector := fun j => if Nat.eqb j (S k) then s else c j - s * e j.

Lemma sum_extended k s c e f :
  sum (S (S k)) (fun j => extended k s c e j * f j) =
  sum (S k) (fun j => c j * f j) + s * (f (S k) - sum (S k) (fun j => e j * f j)).
Proof.
  change (sum (S (S k)) ?g) with (sum (S k) g + g (S k)); cbv beta.
  unfold extended at 2; rewrite Nat.eqb_refl.
  rewrite (sum_ext (S k) _ (fun j => c j * f j - s * (e j * f j))).
  - rewrite sum_minus, sum_scal; ring.
  - intros j Hj; unfold extended; destruct (Nat.eqb_spec j (S k)); [lia | ring].
Qed.

Lemma sum_of_extended k s c e : sum (S (S k)) (extended k s c e) = sum (S k) c + s * (1 - sum (S k) e).
Proof.
  rewrite (sum_ext (S (S k)) _ (fun j => extended k s c e j * 1)) by (intros; ring).
  rewrite (sum_extended k s c e (fun _ => 1)); f_equal; [|f_equal; f_equal]; apply sum_ext; intros; ring.
Qed.

Lemma combination_extended k s c e p a :
  combination (S k) (extended k s c e) p a = combination k c p a + s * minus (p (S k)) (combination k e p) a.
Proof. unfold combination at 1; rewrite (sum_extended k s c e (fun j => p j a)); reflexivity. Qed.

Lemma dot_shift m u s v w : dot m (fun a => u a + s * v a) w = dot m u w + s * dot m v w.
Proof. unfold dot; rewrite <- sum_scal, <- sum_plus; apply sum_ext; intros; ring. Qed.

Lemma dot_ext m u v w : (forall a, u a = v a) -> dot m u w = dot m v w.
Proof. intros H; apply sum_ext; intros; now rewrite H. Qed.

(** The edge to the last vertex, by way of a point of the affine hull of the others. *)
Lemma last_edge m k p e v :
  sum (S k) e = 1 ->
  dot m v (minus (p (S k)) (p O)) =
  dot m v (minus (p (S k)) (combination k e p)) + sum (S k) (fun i => e i * dot m v (minus (p i) (p O))).
Proof.
  intros e1; unfold dot at 3.
  rewrite (sum_ext (S k) _ (fun i => sum m (fun a => e i * (v a * minus (p i) (p O) a))))
    by (intros; now rewrite sum_scal).
  rewrite sum_swap; unfold dot; rewrite <- sum_plus; apply sum_ext; intros a _; unfold minus.
  rewrite (sum_ext (S k) _ (fun i => v a * (e i * p i a) - v a * p O a * e i)) by (intros; ring).
  rewrite sum_minus, !sum_scal, e1; unfold combination; ring.
Qed.

(** Every point has an orthogonal projection onto the affine hull of p 0, …, p k, degenerate or not. *)
Theorem projection m p : forall k y, exists c,
  sum (S k) c = 1 /\ forall j, (j <= k)%nat -> dot m (minus y (combination k c p)) (minus (p j) (p O)) = 0.
Proof.
  induction k as [|k IH]; intros y.
  { exists (fun _ => 1); split; [simpl; ring |].
    intros j Hj; replace j with O by lia; unfold dot.
    rewrite (sum_ext m _ (fun _ => 0)); [apply sum_zero | intros; unfold minus; ring]. }
  destruct (IH y) as (c & c1 & Hc); destruct (IH (p (S k))) as (e & e1 & He).
  set (r := minus y (combination k c p)) in *; set (h := minus (p (S k)) (combination k e p)) in *.
  set (s := dot m r h / dot m h h).
  assert (Hs : dot m r h = s * dot m h h).
  { unfold s; destruct (Req_dec (dot m h h) 0) as [Z|NZ]; [|now field].
    pose proof (cauchy_schwarz_squared m r h) as C; rewrite Z, Rmult_0_r in C |- *; nra. }
  exists (extended k s c e); split; [rewrite sum_of_extended, c1, e1; ring |].
  assert (E : forall v, dot m (minus y (combination (S k) (extended k s c e) p)) v = dot m r v - s * dot m h v).
  { intros v; replace (dot m r v - s * dot m h v) with (dot m r v + (- s) * dot m h v) by ring.
    rewrite <- dot_shift; apply dot_ext; intros a; unfold minus at 1; rewrite combination_extended.
    unfold r, h, minus; ring. }
  assert (F : forall j, (j <= k)%nat ->
              dot m (minus y (combination (S k) (extended k s c e) p)) (minus (p j) (p O)) = 0).
  { intros j Hj; rewrite E, Hc, He by trivial; ring. }
  intros j Hj; destruct (Nat.eq_dec j (S k)) as [->|D]; [|apply F; lia].
  rewrite (last_edge m k p e _ e1); fold h.
  rewrite (sum_ext (S k) _ (fun _ => 0)), sum_zero by (intros; rewrite F by lia; ring).
  rewrite E, Hs; ring.
Qed.

(** Each vertex lies off the affine hull of those before it. *)
Definition independent (m k : nat) (p : simplex) : Prop :=
  forall i, (i < k)%nat -> forall c, sum (S i) c = 1 -> 0 < distance m (p (S i)) (combination i c p).

Lemma sum_prefix n i f : (i <= n)%nat -> sum n (fun j => if Nat.ltb j i then f j else 0) = sum i f.
Proof.
  induction n as [|n IH]; intros H; [replace i with O by lia; trivial |].
  simpl; destruct (Nat.ltb_spec n i) as [L|L].
  - replace i with (S n) by lia; simpl; f_equal; apply sum_ext; intros j Hj.
    destruct (Nat.ltb_spec j (S n)); trivial; lia.
  - rewrite IH by lia; ring.
Qed.

Lemma thick_simplices_are_independent m k p d t : 0 < d -> 0 < t -> is_thick m k p d t -> independent m k p.
Proof.
  intros Hd Ht H i Hi c c1.
  set (c' := fun j => if Nat.ltb j (S i) then c j else 0).
  assert (A : INR k * t * d <= distance m (p (S i)) (combination k c' p)).
  { apply H; [lia | unfold c'; destruct (Nat.ltb_spec (S i) (S i)); [lia | trivial] |].
    unfold c'; rewrite sum_prefix by lia; trivial. }
  assert (K : 0 < INR k) by (apply lt_0_INR; lia).
  assert (0 < INR k * t * d) by (repeat apply Rmult_lt_0_compat; trivial).
  replace (distance m (p (S i)) (combination i c p)) with (distance m (p (S i)) (combination k c' p)); [lra |].
  apply norm_ext; intros a _; unfold minus; f_equal; unfold combination.
  rewrite <- (sum_prefix (S k) (S i) (fun j => c j * p j a)) by lia.
  apply sum_ext; intros j _; unfold c'; destruct (Nat.ltb j (S i)); ring.
Qed.

(** x + Σ w_j p_j, for weights that add up to 0: x moved parallel to the affine hull. *)
Definition moved (k : nat) (w : vector) (p : simplex) (x : vector) : vector := fun a => x a + combination k w p a.

Lemma squared_distance_moved m u x s h :
  distance m u (fun a => x a + s * h a) * distance m u (fun a => x a + s * h a) =
  distance m u x * distance m u x - 2 * s * dot m (minus u x) h + s * s * dot m h h.
Proof.
  rewrite !distance_squared; unfold dot; rewrite <- !sum_scal, <- sum_minus, <- sum_plus.
  apply sum_ext; intros; unfold minus; ring.
Qed.

Lemma dot_difference m u v x h : dot m (minus u x) h = dot m (minus v x) h + dot m h (minus u v).
Proof. unfold dot; rewrite <- sum_plus; apply sum_ext; intros; unfold minus; ring. Qed.

(** The centre of a ball around independent points is found from any point x, parallel to their affine hull. *)
Theorem equidistant_point m p x : forall k, independent m k p -> exists w r,
  sum (S k) w = 0 /\ 0 <= r /\ forall j, (j <= k)%nat -> distance m (p j) (moved k w p x) = r.
Proof.
  induction k as [|k IH]; intros H.
  { exists (fun _ => 0), (distance m (p O) (moved 0 (fun _ => 0) p x)); split; [simpl; ring |].
    split; [apply norm_nonneg |]; intros j Hj; now replace j with O by lia. }
  destruct IH as (w & r & w0 & Hr & Hw); [intros i Hi; apply H; lia |].
  destruct (projection m p k (p (S k))) as (e & e1 & He).
  pose proof (H k ltac:(lia) e e1) as P.
  set (h := minus (p (S k)) (combination k e p)) in *; set (z := moved k w p x) in *.
  assert (N : 0 < dot m h h).
  { unfold distance in P; fold h in P; rewrite <- norm_squared; now apply Rmult_lt_0_compat. }
  set (D := distance m (p (S k)) z * distance m (p (S k)) z - distance m (p O) z * distance m (p O) z).
  set (s := D / (2 * dot m h h)).
  exists (extended k s w e), (distance m (p O) (fun a => z a + s * h a)).
  split; [rewrite sum_of_extended, w0, e1; ring | split; [apply norm_nonneg |]].
  intros j Hj.
  assert (M : forall u, distance m u (moved (S k) (extended k s w e) p x) = distance m u (fun a => z a + s * h a)).
  { intros u; apply norm_ext; intros a _; unfold minus; f_equal.
    unfold moved at 1; rewrite combination_extended; unfold z, moved, h; ring. }
  rewrite M; apply Rle_antisym; apply le_of_squares; try apply norm_nonneg; right;
    rewrite !squared_distance_moved; (destruct (Nat.eq_dec j (S k)) as [->|J]).
  1, 3: rewrite (dot_difference m (p (S k)) (p O)), (last_edge m k p e h e1); fold h;
    rewrite (sum_ext (S k) _ (fun _ => 0)), sum_zero by (intros; rewrite He by lia; ring);
    replace (distance m (p (S k)) z * distance m (p (S k)) z) with (D + distance m (p O) z * distance m (p O) z)
      by (unfold D; ring); unfold s; field; lra.
  all: rewrite (Hw j), (Hw O), (dot_difference m (p j) (p O)), He by lia; ring.
Qed.
