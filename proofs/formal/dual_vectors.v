(** The first half of lem:bound.skP: row i of the pseudo-inverse of the matrix of edges is orthogonal to the facet opposite
    p_i, and its length is the inverse of the altitude. *)

Require Import Reals Lra Lia Psatz.
From Delcert Require Import vectors simplices weights projections.
Open Scope R_scope.

(** Row i of the pseudo-inverse P⁺ = (PᵀP)⁻¹Pᵀ, for edges from the vertex b: it lies in the span of the edges, and P⁺P = 1. *)
Definition is_dual_vector (m k : nat) (p : simplex) (b i : nat) (w : vector) : Prop :=
  (exists x, sum (S k) x = 0 /\ forall a, (a < m)%nat -> w a = combination k x p a) /\
  forall j, (j <= k)%nat -> dot m w (minus (p j) (p b)) = unit_at i j.

(** The altitude is attained. *)
Definition is_altitude (m k : nat) (p : simplex) (i : nat) (a : R) : Prop :=
  altitude_at_least m k p i a /\
  exists c : vector, c i = 0 /\ sum (S k) c = 1 /\ distance m (p i) (combination k c p) = a.

Lemma dot_combination m k p b c w :
  dot m w (fun a => combination k c p a - sum (S k) c * p b a) = sum (S k) (fun j => c j * dot m w (minus (p j) (p b))).
Proof.
  unfold dot; rewrite (sum_ext (S k) (fun j => c j * sum m (fun a => w a * minus (p j) (p b) a))
                               (fun j => sum m (fun a => c j * (w a * minus (p j) (p b) a))))
    by (intros; now rewrite sum_scal).
  rewrite sum_swap; apply sum_ext; intros a _; unfold combination, minus.
  rewrite (sum_ext (S k) (fun j => c j * (w a * (p j a - p b a))) (fun j => w a * (c j * p j a) - w a * p b a * c j))
    by (intros; ring).
  rewrite sum_minus, !sum_scal; ring.
Qed.

Theorem dual_vector_and_altitude m k p b i w :
  (b <= k)%nat -> (i <= k)%nat -> i <> b -> is_dual_vector m k p b i w ->
  (forall j l, (j <= k)%nat -> (l <= k)%nat -> j <> i -> l <> i -> dot m w (minus (p j) (p l)) = 0) /\
  0 < norm m w /\ is_altitude m k p i (/ norm m w).
Proof.
  intros Hb Hi D [(x & x0 & Hx) Hw].
  assert (U : forall j, j <> i -> unit_at i j = 0).
  { intros j J; unfold unit_at; now destruct (Nat.eqb_spec j i). }
  assert (Ui : unit_at i i = 1) by (unfold unit_at; now rewrite Nat.eqb_refl).
  assert (S1 : forall c, dot m w (fun a => combination k c p a - sum (S k) c * p b a) = c i).
  { intros c; rewrite dot_combination.
    rewrite (sum_ext (S k) _ (fun j => unit_at i j * c j)) by (intros; rewrite Hw by lia; ring).
    now rewrite sum_unit_at by lia. }
  (* |w|² is the weight of p_i in w *)
  assert (W : norm m w * norm m w = x i).
  { rewrite norm_squared, <- (S1 x); apply sum_ext; intros a Ha; rewrite x0, (Hx a Ha) at 1; rewrite <- (Hx a Ha); ring. }
  assert (N : 0 < norm m w).
  { destruct (Rle_lt_or_eq_dec _ _ (norm_nonneg m w)) as [L|Z]; trivial; exfalso.
    pose proof (cauchy_schwarz m w (minus (p i) (p b))) as C.
    rewrite <- Z, Rmult_0_l, (Hw i Hi), Ui, Rabs_R1 in C; lra. }
  assert (X : 0 < x i) by (rewrite <- W; now apply Rmult_lt_0_compat).
  repeat split; trivial.
  - intros j l Hj Hl J L.
    assert (E : dot m w (minus (p j) (p l)) = dot m w (minus (p j) (p b)) - dot m w (minus (p l) (p b))).
    { unfold dot; rewrite <- sum_minus; apply sum_ext; intros; unfold minus; ring. }
    rewrite E, !Hw, !U by trivial; ring.
  - intros c c0 c1.
    assert (E : dot m w (minus (p i) (combination k c p)) = 1).
    { assert (F : dot m w (minus (p i) (combination k c p))
                  = dot m w (minus (p i) (p b)) - dot m w (fun a => combination k c p a - sum (S k) c * p b a)).
      { unfold dot; rewrite <- sum_minus, c1; apply sum_ext; intros; unfold minus; ring. }
      rewrite F, S1, Hw, Ui, c0 by trivial; ring. }
    pose proof (cauchy_schwarz m w (minus (p i) (combination k c p))) as C.
    rewrite E, Rabs_R1 in C; fold (distance m (p i) (combination k c p)) in C.
    apply Rmult_le_reg_l with (norm m w); trivial; rewrite Rinv_r by lra; exact C.
  - exists (fun j => unit_at i j - / x i * x j); repeat split.
    + rewrite Ui; field; lra.
    + rewrite sum_minus, sum_scal, sum_of_unit, x0 by lia; ring.
    + assert (E : distance m (p i) (combination k (fun j => unit_at i j - / x i * x j) p)
                  = norm m (fun a => / x i * w a)).
      { apply norm_ext; intros a Ha; rewrite (Hx a Ha); unfold minus, combination.
        rewrite (sum_ext (S k) _ (fun j => unit_at i j * p j a - / x i * (x j * p j a))) by (intros; ring).
        rewrite sum_minus, sum_scal, (sum_unit_at (S k) i (fun j => p j a)) by lia; ring. }
      rewrite E, norm_scal by (left; now apply Rinv_0_lt_compat).
      rewrite <- W; field; lra.
Qed.

(** A simplex that is not degenerate has a dual vector for each vertex but the base, … *)
Theorem dual_vector_exists m k p b i :
  (b <= k)%nat -> (i <= k)%nat -> i <> b ->
  (forall c, c i = 0 -> sum (S k) c = 1 -> 0 < distance m (p i) (combination k c p)) ->
  exists w, is_dual_vector m k p b i w.
Proof.
  intros Hb Hi D Apart.
  (* the foot of the altitude, with p_b in the place of p_i *)
  pose (p' := fun j => if Nat.eqb j i then p b else p j).
  destruct (projection m p' k (p i)) as (c & c1 & Hc).
  pose (e := fun j => c j - c i * unit_at i j + c i * unit_at b j).
  assert (Ui : unit_at i i = 1) by (unfold unit_at; now rewrite Nat.eqb_refl).
  assert (Ub : unit_at b i = 0) by (unfold unit_at; now destruct (Nat.eqb_spec i b)).
  assert (e0 : e i = 0) by (unfold e; rewrite Ui, Ub; ring).
  assert (e1 : sum (S k) e = 1).
  { unfold e; rewrite sum_plus, sum_minus, !sum_scal, !sum_of_unit by lia; lra. }
  assert (Foot : forall a, combination k e p a = combination k c p' a).
  { intros a; unfold combination.
    rewrite (sum_ext (S k) (fun j => e j * p j a)
               (fun j => c j * p j a - c i * (unit_at i j * p j a) + c i * (unit_at b j * p j a))) by (intros; unfold e; ring).
    rewrite (sum_ext (S k) (fun j => c j * p' j a) (fun j => c j * p j a - c i * (unit_at i j * (p i a - p b a)))).
    - rewrite sum_plus, !sum_minus, !sum_scal, (sum_unit_at (S k) i (fun j => p j a)), (sum_unit_at (S k) b (fun j => p j a)),
        (sum_unit_at (S k) i (fun _ => p i a - p b a)) by lia; ring.
    - intros j _; unfold p', unit_at; destruct (Nat.eqb_spec j i) as [->|]; ring. }
  set (h := minus (p i) (combination k c p')) in *.
  assert (Orth : forall j, (j <= k)%nat -> j <> i -> dot m h (minus (p j) (p b)) = 0).
  { intros j Hj J; pose proof (Hc j Hj) as A; pose proof (Hc i Hi) as B.
    replace (dot m h (minus (p j) (p b))) with (dot m h (minus (p' j) (p' O)) - dot m h (minus (p' i) (p' O))); [lra |].
    unfold dot; rewrite <- sum_minus; apply sum_ext; intros a _; unfold minus, p'; rewrite Nat.eqb_refl.
    destruct (Nat.eqb_spec j i); [contradiction | ring]. }
  assert (N : 0 < dot m h h).
  { rewrite <- norm_squared; specialize (Apart e e0 e1); unfold distance in Apart.
    rewrite (norm_ext m _ h) in Apart by (intros a _; unfold h, minus; now rewrite Foot); nra. }
  assert (Self : dot m h (minus (p i) (p b)) = dot m h h).
  { assert (E : dot m h (minus (p i) (p b)) = dot m h h + dot m h (fun a => combination k e p a - sum (S k) e * p b a)).
    { unfold dot; rewrite <- sum_plus; apply sum_ext; intros a _; unfold h, minus at 2 4; rewrite e1, Foot; ring. }
    rewrite E, dot_combination, (sum_ext (S k) _ (fun _ => 0)), sum_zero; [ring |].
    intros j Hj; destruct (Nat.eq_dec j i) as [->|J]; [rewrite e0; ring | rewrite Orth by (trivial; lia); ring]. }
  exists (fun a => / dot m h h * h a); split.
  - exists (fun j => / dot m h h * (unit_at i j - e j)); split.
    + rewrite sum_scal, sum_minus, sum_of_unit, e1 by lia; ring.
    + intros a Ha; unfold combination.
      rewrite (sum_ext (S k) _ (fun j => / dot m h h * (unit_at i j * p j a - e j * p j a))) by (intros; ring).
      rewrite sum_scal, sum_minus, (sum_unit_at (S k) i (fun j => p j a)) by lia.
      fold (combination k e p a); rewrite Foot; reflexivity.
  - intros j Hj.
    assert (E : forall n, dot m (fun a => n * h a) (minus (p j) (p b)) = n * dot m h (minus (p j) (p b))).
    { intros n; unfold dot; rewrite <- sum_scal; apply sum_ext; intros; ring. }
    rewrite E; destruct (Nat.eq_dec j i) as [->|J].
    + rewrite Self, Ui; field; lra.
    + rewrite Orth by trivial; unfold unit_at; destruct (Nat.eqb_spec j i); [contradiction | ring].
Qed.

(** … and only one: P⁺ is what these conditions say. *)
Theorem dual_vector_is_unique m k p b i v w :
  is_dual_vector m k p b i v -> is_dual_vector m k p b i w -> forall a, (a < m)%nat -> v a = w a.
Proof.
  intros ((x & x0 & Hx) & Hv) ((y & y0 & Hy) & Hw).
  assert (Z : dot m (minus v w) (minus v w) = 0).
  { assert (E : dot m (minus v w) (minus v w)
                = dot m (minus v w) (fun a => combination k (fun j => x j - y j) p a - sum (S k) (fun j => x j - y j) * p b a)).
    { apply sum_ext; intros a Ha; f_equal; unfold minus at 1; rewrite (Hx a Ha), (Hy a Ha), sum_minus, x0, y0.
      unfold combination; rewrite (sum_ext (S k) (fun j => (x j - y j) * p j a) (fun j => x j * p j a - y j * p j a))
        by (intros; ring); rewrite sum_minus; ring. }
    rewrite E, dot_combination, (sum_ext (S k) _ (fun _ => 0)); [apply sum_zero |].
    intros j Hj; replace (dot m (minus v w) (minus (p j) (p b))) with (dot m v (minus (p j) (p b)) - dot m w (minus (p j) (p b))).
    - rewrite Hv, Hw by lia; ring.
    - unfold dot; rewrite <- sum_minus; apply sum_ext; intros; unfold minus; ring. }
  intros a Ha; pose proof (term_le_sum m (fun c => minus v w c * minus v w c) a ltac:(intros; cbv beta; nra) Ha) as T.
  cbv beta in T; fold (dot m (minus v w) (minus v w)) in T; rewrite Z in T; unfold minus in T; nra.
Qed.

(** lem:bound.skP, whole: for a k-simplex that is not degenerate, k > 0, and edges from the vertex b, the row of P⁺ for each
    other vertex exists, is orthogonal to the affine hull of the opposite facet, and its length is the inverse of the
    altitude; and s_k(P) ≥ √k Υ Δ. *)
Theorem thickness_and_dual_vectors m k p b d t :
  (1 <= k)%nat -> (b <= k)%nat -> 0 <= d -> 0 <= t -> is_thick m k p d t ->
  (forall i c, (i <= k)%nat -> c i = 0 -> sum (S k) c = 1 -> 0 < distance m (p i) (combination k c p)) ->
  (forall i, (i <= k)%nat -> i <> b -> exists w, is_dual_vector m k p b i w /\
     (forall v, is_dual_vector m k p b i v -> forall a, (a < m)%nat -> v a = w a) /\
     (forall j l, (j <= k)%nat -> (l <= k)%nat -> j <> i -> l <> i -> dot m w (minus (p j) (p l)) = 0) /\
     is_altitude m k p i (/ norm m w)) /\
  singular_values_at_least m k p b (sqrt (INR k) * t * d).
Proof.
  intros Hk Hb Hd Ht Thick Apart; split; [|now apply thickness_and_singular_value].
  intros i Hi D; destruct (dual_vector_exists m k p b i Hb Hi D ltac:(intros c; now apply Apart)) as (w & Hw).
  destruct (dual_vector_and_altitude m k p b i w Hb Hi D Hw) as (O & _ & A).
  exists w; split; [exact Hw | split; [| split; [exact O | exact A]]].
  intros v Hv a Ha; now apply (dual_vector_is_unique m k p b i).
Qed.
