(** The circumradius of a simplex of any dimension: lem:crude.rad.bnd. *)

Require Import Reals Lra Lia Psatz.
From Delcert Require Import vectors simplices.
Open Scope R_scope.

(** The circumcentre lies in the affine hull, at the distance r, the circumradius, from each vertex. *)
Definition is_circumradius (m k : nat) (p : simplex) (r : R) : Prop :=
  exists c : vector, sum (S k) c = 1 /\ forall i, (i <= k)%nat -> distance m (p i) (combination k c p) = r.

(** lem:crude.rad.bnd: R ≤ Δ / (2 Υ). *)
Theorem crude_circumradius_bound m k p d t r :
  (1 <= k)%nat -> 0 < d -> 0 < t -> edges_at_most m k p d -> is_thick m k p d t -> is_circumradius m k p r ->
  r <= d / (2 * t).
Proof.
  intros Hk Hd Ht He Hthick (c & c1 & Hr).
  set (y := edge_map k p 0 c).
  assert (Y : forall l, minus (combination k c p) (p O) l = y l).
  { intros l; unfold y, edge_map, minus, combination.
    rewrite (sum_ext _ (fun j => c j * (p j l - p O l)) (fun j => c j * p j l - c j * p O l)) by (intros; ring).
    rewrite sum_minus, sum_scal_right, c1; ring. }
  assert (R0 : norm m y = r).
  { rewrite <- (Hr O), distance_sym by lia; apply norm_ext; intros; now rewrite <- Y. }
  (* Pᵀ C = b *)
  assert (B : forall j, (j <= k)%nat ->
              dot m y (minus (p j) (p O)) = distance m (p j) (p O) * distance m (p j) (p O) / 2).
  { intros j Hj; rewrite dot_from_norms, R0.
    replace (norm m (minus y (minus (p j) (p O)))) with r.
    - fold (distance m (p j) (p O)); field.
    - rewrite <- (Hr j Hj), distance_sym; apply norm_ext; intros; unfold minus at 2; rewrite <- Y; unfold minus; ring. }
  assert (S2 : r * r = dot (S k) (without 0 c) (without 0 (fun j => distance m (p j) (p O) * distance m (p j) (p O) / 2))).
  { rewrite <- R0, norm_squared; unfold y at 2; unfold dot, edge_map.
    rewrite (sum_ext m _ (fun a => sum (S k) (fun j => c j * (y a * minus (p j) (p O) a))))
      by (intros; rewrite <- sum_scal; apply sum_ext; intros; unfold minus; ring).
    rewrite sum_swap; apply sum_ext; intros j Hj; rewrite sum_scal; fold (dot m y (minus (p j) (p O))).
    rewrite B by lia; unfold without; destruct (Nat.eqb_spec j 0) as [->|]; [rewrite distance_zero; field | trivial]. }
  pose proof (cauchy_schwarz (S k) (without 0 c)
    (without 0 (fun j => distance m (p j) (p O) * distance m (p j) (p O) / 2))) as C.
  rewrite <- S2 in C.
  assert (K : 1 <= INR k) by (change 1 with (INR 1); now apply le_INR).
  assert (K' : 0 < sqrt (INR k)) by (apply sqrt_lt_R0; lra).
  assert (Sk : sqrt (INR k) * sqrt (INR k) = INR k) by (apply sqrt_sqrt; lra).
  (* |b| ≤ √k Δ²/2 *)
  assert (N : norm (S k) (without 0 (fun j => distance m (p j) (p O) * distance m (p j) (p O) / 2))
              <= sqrt (INR k) * (d * d / 2)).
  { apply norm_le; [apply Rmult_le_pos; nra |].
    replace (sqrt (INR k) * (d * d / 2) * (sqrt (INR k) * (d * d / 2)))
      with (sqrt (INR k) * sqrt (INR k) * (d * d / 2 * (d * d / 2))) by ring.
    rewrite Sk; apply (sum_without_le k 0); [lia | unfold without; simpl; ring |].
    intros j Hj D; unfold without; destruct (Nat.eqb_spec j 0); [contradiction |].
    pose proof (He j O Hj ltac:(lia)); pose proof (norm_nonneg m (minus (p j) (p O))) as P.
    fold (distance m (p j) (p O)) in P.
    assert (0 <= distance m (p j) (p O) * distance m (p j) (p O) / 2 <= d * d / 2) by (split; nra); nra. }
  pose proof (thickness_and_singular_value m k p 0 d t Hk ltac:(lia) ltac:(lra) ltac:(lra) Hthick c) as T.
  fold y in T; rewrite R0 in T; fold (norm_without k 0 c) in C.
  pose proof (norm_without_nonneg k 0 c) as W.
  assert (r0 : 0 <= r) by (rewrite <- R0; apply norm_nonneg).
  set (w := norm_without k 0 c) in *; clearbody w.
  assert (L : r * r <= w * (sqrt (INR k) * (d * d / 2))).
  { eapply Rle_trans; [apply Rle_abs | eapply Rle_trans; [exact C | now apply Rmult_le_compat_l]]. }
  set (q := sqrt (INR k) * w) in *; assert (Q : q * t * d <= r) by (unfold q; lra).
  assert (L' : r * r <= q * d * d / 2) by (unfold q; lra).
  clear - Q L' r0 Hd Ht.
  apply Rmult_le_reg_l with (2 * t); [lra |].
  replace (2 * t * (d / (2 * t))) with d by (field; lra).
  destruct (Req_dec r 0) as [->|NZ]; [lra |].
  apply Rmult_le_reg_l with r; [lra |].
  assert (t * (r * r) <= t * (q * d * d / 2)) by (apply Rmult_le_compat_l; lra).
  assert (q * t * d * d <= r * d) by (apply Rmult_le_compat_r; lra).
  lra.
Qed.
