(** The first half of lem:bound.skP: row i of the pseudo-inverse of the matrix of edges is orthogonal to the facet opposite
    p_i, and its length is the inverse of the altitude. *)

Require Import Reals Lra Lia Psatz.
From Delcert Require Import vectors simplices weights.
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
