(** lem:prop.forbid.cfg: what the paper's forbidden configurations have in common, P1 to P4, with μ₀ ≤ 1, which the paper
    does not say. A (k + 1)-simplex is a flake if it is not Γ₀-good, and its facets are. *)

Require Import Reals Lra Lia Psatz Classical.
From Delcert Require Import vectors simplices circumradius weights projections circumcentres.
Open Scope R_scope.

(** * Facets *)

(** The place in p of the vertex j of the facet opposite v. *)
Definition skip (v j : nat) : nat := if Nat.ltb j v then j else S j.
Definition facet (v : nat) (p : simplex) : simplex := fun j => p (skip v j).

Lemma sum_skip k v f : (v <= k)%nat -> sum (S k) f = f v + sum k (fun j => f (skip v j)).
Proof.
  induction k as [|k IH]; intros Hv.
  - replace v with O by lia; simpl; ring.
  - change (sum (S (S k)) f) with (sum (S k) f + f (S k)).
    change (sum (S k) (fun j => f (skip v j))) with (sum k (fun j => f (skip v j)) + f (skip v k)).
    destruct (Nat.eq_dec v (S k)) as [->|D].
    + assert (E : forall n, (n <= S k)%nat -> sum n (fun j => f (skip (S k) j)) = sum n f).
      { intros n Hn; apply sum_ext; intros j Hj; unfold skip; destruct (Nat.ltb_spec j (S k)); trivial; lia. }
      rewrite (E k) by lia; unfold skip; destruct (Nat.ltb_spec k (S k)); [simpl; ring | lia].
    + rewrite IH by lia; unfold skip at 3; destruct (Nat.ltb_spec k v); [lia | ring].
Qed.

Lemma skip_other k v i : (v <= S k)%nat -> (i <= S k)%nat -> i <> v -> exists j, (j <= k)%nat /\ skip v j = i.
Proof.
  intros Hv Hi D; destruct (Nat.lt_ge_cases i v) as [L|L].
  - exists i; split; [lia |]; unfold skip; destruct (Nat.ltb_spec i v); [trivial | lia].
  - exists (pred i); split; [lia |]; unfold skip; destruct (Nat.ltb_spec (pred i) v); lia.
Qed.

Lemma skip_range k v j : (j <= k)%nat -> (skip v j <= S k)%nat /\ skip v j <> v.
Proof. intros Hj; unfold skip; destruct (Nat.ltb_spec j v); lia. Qed.

Lemma skip_injective v i j : skip v i = skip v j -> i = j.
Proof. unfold skip; destruct (Nat.ltb_spec i v), (Nat.ltb_spec j v); lia. Qed.

(** Weights that leave out a vertex are weights of its facet. *)
Lemma combination_of_facet k v c p a :
  (v <= S k)%nat -> combination (S k) c p a = c v * p v a + combination k (fun j => c (skip v j)) (facet v p) a.
Proof. intros Hv; unfold combination; rewrite (sum_skip (S k) v) by lia; reflexivity. Qed.

(** * Goodness *)

(** The thickness of p is at least t. *)
Definition thickness_at_least (m k : nat) (p : simplex) (t : R) : Prop :=
  forall d, is_longest_edge m k p d -> is_thick m k p d t.

(** Each face of dimension j ≥ 1 is Γ₀^j-thick: p itself, its facets, theirs, and so on. *)
Fixpoint is_good (m k : nat) (p : simplex) (g : R) : Prop :=
  match k with
  | O => True
  | S k' => thickness_at_least m k p (g ^ k) /\ forall v, (v <= k)%nat -> is_good m k' (facet v p) g
  end.

Definition is_flake (m k : nat) (p : simplex) (g : R) : Prop :=
  ~ is_good m (S k) p g /\ forall v, (v <= S k)%nat -> is_good m k (facet v p) g.

Lemma greatest_of_finitely_many n (f : nat -> R) : exists i, (i <= n)%nat /\ forall j, (j <= n)%nat -> f j <= f i.
Proof.
  induction n as [|n (i & Hi & H)].
  - exists O; split; [lia |]; intros j Hj; replace j with O by lia; lra.
  - destruct (Rle_dec (f i) (f (S n))) as [L|L].
    + exists (S n); split; [lia |]; intros j Hj; destruct (Nat.eq_dec j (S n)) as [->|D]; [lra |].
      specialize (H j ltac:(lia)); lra.
    + exists i; split; [lia |]; intros j Hj; destruct (Nat.eq_dec j (S n)) as [->|D]; [lra |]; apply H; lia.
Qed.

Lemma longest_edge_exists m k p : exists d, is_longest_edge m k p d.
Proof.
  assert (H : forall n, (n <= k)%nat -> exists i j, (i <= n)%nat /\ (j <= k)%nat /\
              forall u v, (u <= n)%nat -> (v <= k)%nat -> distance m (p u) (p v) <= distance m (p i) (p j)).
  { induction n as [|n IH]; intros Hn.
    - destruct (greatest_of_finitely_many k (fun v => distance m (p O) (p v))) as (j & Hj & H).
      exists O, j; repeat split; trivial; intros u v Hu Hv; replace u with O by lia; auto.
    - destruct (IH ltac:(lia)) as (i & j & Hi & Hj & H).
      destruct (greatest_of_finitely_many k (fun v => distance m (p (S n)) (p v))) as (l & Hl & G); cbv beta in G.
      destruct (Rle_dec (distance m (p i) (p j)) (distance m (p (S n)) (p l))) as [L|L].
      + exists (S n), l; repeat split; trivial; intros u v Hu Hv; destruct (Nat.eq_dec u (S n)) as [->|D]; [auto |].
        eapply Rle_trans; [apply H; lia | exact L].
      + exists i, j; repeat split; trivial; try lia; intros u v Hu Hv; destruct (Nat.eq_dec u (S n)) as [->|D].
        * specialize (G v Hv); lra.
        * apply H; lia. }
  destruct (H k ltac:(lia)) as (i & j & Hi & Hj & G).
  exists (distance m (p i) (p j)); split; [intros u v Hu Hv; now apply G | now exists i, j].
Qed.

(** A flake has a vertex near the affine hull of the others. *)
Lemma near_hull_in_a_flake m k p g :
  is_flake m k p g -> exists d a c, is_longest_edge m (S k) p d /\ (a <= S k)%nat /\ c a = 0 /\ sum (S (S k)) c = 1 /\
    distance m (p a) (combination (S k) c p) < INR (S k) * g ^ S k * d.
Proof.
  intros (NG & F).
  assert (NT : ~ thickness_at_least m (S k) p (g ^ S k)) by (intros T; apply NG; split; trivial).
  apply not_all_ex_not in NT as (d & NT); apply imply_to_and in NT as (Hd & NT).
  apply not_all_ex_not in NT as (a & NT); apply imply_to_and in NT as (Ha & NT).
  apply not_all_ex_not in NT as (c & NT); apply imply_to_and in NT as (c0 & NT); apply imply_to_and in NT as (c1 & NT).
  exists d, a, c; repeat split; trivial; try apply Hd; now apply Rnot_le_lt.
Qed.

Lemma altitude_in_a_good_facet m k p g v s :
  (1 <= k)%nat -> (v <= S k)%nat -> 0 <= s -> 0 <= g ->
  is_good m k (facet v p) g -> (forall i j, (i <= S k)%nat -> (j <= S k)%nat -> i <> j -> s <= distance m (p i) (p j)) ->
  forall i, (i <= k)%nat -> altitude_at_least m k (facet v p) i (INR k * g ^ k * s).
Proof.
  intros Hk Hv Hs Hg G S i Hi c c0 c1.
  destruct k as [|k]; [lia |]; destruct G as (T & _).
  destruct (longest_edge_exists m (Datatypes.S k) (facet v p)) as (d & Hd).
  apply Rle_trans with (INR (Datatypes.S k) * g ^ Datatypes.S k * d); [|now apply (T d Hd i Hi c)].
  apply Rmult_le_compat_l; [apply Rmult_le_pos; [apply pos_INR | now apply pow_le] |].
  destruct Hd as (E & _); eapply Rle_trans; [|apply (E O 1%nat); lia].
  apply S; try apply skip_range; try lia; intros Q; apply skip_injective in Q; lia.
Qed.

(** * Altitudes: every vertex is near the affine hull of its facet *)

Lemma power_times_dimension g k : 0 <= g <= 1 / 2 -> (1 <= k)%nat -> INR k * g ^ k <= 1 / 2.
Proof.
  intros Hg Hk; induction Hk as [|k Hk IH]; [simpl; lra |].
  rewrite S_INR; simpl pow.
  assert (0 <= g ^ k) by (apply pow_le; lra); assert (1 <= INR k) by (change 1 with (INR 1); now apply le_INR).
  assert (g * g ^ k <= 1 / 2 * g ^ k) by (apply Rmult_le_compat_r; lra); nra.
Qed.

Lemma power_at_most_one g n : 0 <= g <= 1 -> 0 <= g ^ n <= 1.
Proof. intros H; induction n as [|n IH]; simpl; [lra | nra]. Qed.

(** For each v a point y of the affine hull of its facet with |v − y| μ ≤ 11 Γ e. *)
Lemma every_vertex_is_near_its_facet m k p g mu e v :
  (1 <= k)%nat -> (v <= S k)%nat -> 0 < e -> 0 < mu <= 1 -> 0 < g -> 15 * g <= mu ->
  is_flake m k p g -> (forall i j, (i <= S k)%nat -> (j <= S k)%nat -> i <> j -> mu * e <= distance m (p i) (p j)) ->
  edges_at_most m (S k) p (2001 / 1000 * e) ->
  exists c, sum (S k) c = 1 /\ distance m (p v) (combination k c (facet v p)) * mu <= 11 * g * e.
Proof.
  intros Hk Hv He Hmu Hg Hgm F Sep Edges.
  destruct (near_hull_in_a_flake m k p g F) as (d & a & c & Hd & Ha & c0 & c1 & N).
  set (eta := distance m (p a) (combination (S k) c p)) in *.
  assert (eta0 : 0 <= eta) by apply norm_nonneg.
  assert (K : 1 <= INR k) by (change 1 with (INR 1); now apply le_INR).
  set (G := g ^ k) in *; assert (G0 : 0 < G) by (now apply pow_lt).
  assert (d1 : d <= 2001 / 1000 * e).
  { destruct Hd as (_ & i & j & Hi & Hj & <-); now apply Edges. }
  assert (d0 : 0 <= d) by (destruct Hd as (_ & i & j & Hi & Hj & <-); apply norm_nonneg).
  assert (E1 : eta <= 2 * (INR k * G) * (g * d)).
  { apply Rle_trans with (INR (S k) * g ^ S k * d); [lra |].
    rewrite S_INR; change (g ^ S k) with (g * G).
    assert (0 <= G * (g * d)) by (apply Rmult_le_pos; [lra | apply Rmult_le_pos; lra]).
    replace ((INR k + 1) * (g * G) * d) with ((INR k + 1) * (G * (g * d))) by ring.
    replace (2 * (INR k * G) * (g * d)) with (2 * INR k * (G * (g * d))) by ring.
    apply Rmult_le_compat_r; lra. }
  destruct (Nat.eq_dec v a) as [->|D].
  - exists (fun j => c (skip a j)); split.
    + rewrite (sum_skip (S k) a) in c1 by lia; rewrite c0 in c1; lra.
    + assert (E : distance m (p a) (combination k (fun j => c (skip a j)) (facet a p)) = eta).
      { apply norm_ext; intros l _; unfold minus; rewrite (combination_of_facet k a c p l Ha), c0; ring. }
      rewrite E; pose proof (power_times_dimension g k ltac:(lra) Hk) as B; fold G in B.
      assert (0 <= INR k * G) by (apply Rmult_le_pos; lra).
      assert (2 * (INR k * G) * (g * d) <= 1 * (g * (2001 / 1000 * e))).
      { apply Rmult_le_compat; try lra; [apply Rmult_le_pos; lra | apply Rmult_le_compat_l; lra]. }
      assert (0 <= g * e) by (apply Rmult_le_pos; lra); nra.
  - (* x = 1 at a, −c elsewhere: weights with sum 0 *)
    set (x := fun j => unit_at a j - c j).
    assert (x0 : sum (S (S k)) x = 0) by (unfold x; rewrite sum_minus, sum_of_unit, c1 by lia; ring).
    assert (xa : x a = 1) by (unfold x, unit_at; rewrite Nat.eqb_refl, c0; ring).
    assert (X : forall l, combination (S k) x p l = minus (p a) (combination (S k) c p) l).
    { intros l; unfold x, combination, minus.
      rewrite (sum_ext (S (S k)) _ (fun j => unit_at a j * p j l - c j * p j l)) by (intros; ring).
      rewrite sum_minus, (sum_unit_at (S (S k)) a (fun j => p j l)) by lia; reflexivity. }
    (* another vertex b of the facet takes the weight of v *)
    destruct (skip_other k v a Hv Ha (fun Q => D (eq_sym Q))) as (ja & Hja & Eja).
    destruct (another_vertex k ja Hk) as (jb & Hjb & Djb).
    set (b := skip v jb).
    set (w := fun j => x (skip v j) + x v * unit_at jb j).
    assert (w0 : sum (S k) w = 0).
    { unfold w; rewrite sum_plus, sum_scal, sum_of_unit by lia. rewrite (sum_skip (S k) v) in x0 by lia; lra. }
    assert (wa : w ja = 1).
    { unfold w, unit_at; rewrite Eja, xa; destruct (Nat.eqb_spec ja jb); [contradiction | ring]. }
    pose proof (altitude_in_a_good_facet m k p g v (mu * e) Hk Hv ltac:(nra) ltac:(lra) (proj2 F v Hv) Sep ja Hja) as Alt.
    fold G in Alt.
    pose proof (difference_weight m k (facet v p) w ja _ Hk Hja w0 Alt) as L.
    rewrite wa, Rabs_R1, Rmult_1_l in L.
    assert (W : norm m (combination k w (facet v p)) <= eta + Rabs (x v) * d).
    { apply Rle_trans with (norm m (fun l => combination (S k) x p l + x v * minus (p b) (p v) l)).
      - right; apply norm_ext; intros l _; rewrite (combination_of_facet k v x p l Hv); unfold w, combination at 1, minus.
        rewrite (sum_ext (S k) _ (fun j => x (skip v j) * facet v p j l + x v * (unit_at jb j * facet v p j l)))
          by (intros; ring).
        rewrite sum_plus, sum_scal, (sum_unit_at (S k) jb (fun j => facet v p j l)) by lia.
        unfold combination, b, facet; ring.
      - eapply Rle_trans; [apply norm_triangle |]; apply Rplus_le_compat.
        + right; apply norm_ext; intros; apply X.
        + apply Rle_trans with (Rabs (x v) * norm m (minus (p b) (p v))).
          * right; rewrite <- norm_scal by apply Rabs_pos; unfold norm; f_equal; apply sum_ext; intros.
            unfold Rabs; destruct Rcase_abs; ring.
          * apply Rmult_le_compat_l; [apply Rabs_pos |]; apply Hd; [apply skip_range; trivial | trivial]. }
    set (xv := Rabs (x v)) in *; assert (xv0 : 0 <= xv) by apply Rabs_pos.
    set (q := INR k * G) in *; assert (q0 : 0 < q) by (apply Rmult_lt_0_compat; lra).
    (* |x_v| d ≥ 11/15 k Γᵏ μ e *)
    assert (E2 : eta <= 4 / 15 * (q * (mu * e)) + 2 / 15000 * (q * (mu * e))).
    { apply Rle_trans with (2 * q * (g * (2001 / 1000 * e))).
      - eapply Rle_trans; [exact E1 |]; apply Rmult_le_compat_l; [lra |]; apply Rmult_le_compat_l; lra.
      - assert (q * (15 * g * e) <= q * (mu * e)).
        { apply Rmult_le_compat_l; [lra |]; apply Rmult_le_compat_r; lra. }
        lra. }
    assert (E3 : 733 / 1000 * (q * (mu * e)) <= xv * d) by lra.
    assert (xv1 : 0 < xv).
    { destruct xv0 as [P|P]; trivial; exfalso. rewrite <- P in E3.
      assert (0 < q * (mu * e)) by (repeat apply Rmult_lt_0_compat; lra); lra. }
    assert (xvnz : x v <> 0) by (intros Z; unfold xv in xv1; rewrite Z, Rabs_R0 in xv1; lra).
    exists (fun j => - / x v * x (skip v j)); split.
    + rewrite sum_scal; rewrite (sum_skip (S k) v) in x0 by lia.
      replace (sum (S k) (fun j => x (skip v j))) with (- x v) by lra; field; trivial.
    + assert (E : distance m (p v) (combination k (fun j => - / x v * x (skip v j)) (facet v p)) = / xv * eta).
      { assert (N2 : eta = norm m (combination (S k) x p)) by (apply norm_ext; intros; symmetry; apply X).
        rewrite N2, <- norm_scal by (left; now apply Rinv_0_lt_compat).
        unfold distance, norm; f_equal; apply sum_ext; intros l _.
        assert (Y : minus (p v) (combination k (fun j => - / x v * x (skip v j)) (facet v p)) l = / x v * combination (S k) x p l).
        { rewrite (combination_of_facet k v x p l Hv); unfold minus, combination.
          rewrite (sum_ext (S k) _ (fun j => - / x v * (x (skip v j) * facet v p j l))) by (intros; ring).
          rewrite sum_scal; field; trivial. }
        rewrite Y; unfold xv, Rabs; destruct Rcase_abs; [|ring].
        replace (/ - x v) with (- / x v) by (field; trivial); ring. }
      rewrite E; apply Rmult_le_reg_l with xv; trivial.
      replace (xv * (/ xv * eta * mu)) with (eta * mu) by (field; lra).
      destruct (Req_dec d 0) as [Z|NZ].
      { rewrite Z, Rmult_0_r in E3. assert (0 < q * (mu * e)) by (repeat apply Rmult_lt_0_compat; lra); lra. }
      apply Rmult_le_reg_l with d; [lra |].
      (* d η μ ≤ 2 q g d² μ ≤ 8.01 q g e² μ ≤ 11 g e · 0.733 q μ e *)
      assert (D2 : d * d <= 2001 / 1000 * e * (2001 / 1000 * e)) by (apply Rmult_le_compat; lra).
      assert (P : 0 <= q * g * mu) by (repeat apply Rmult_le_pos; lra).
      assert (H1 : d * (eta * mu) <= 2 * (q * g * mu) * (d * d)).
      { replace (2 * (q * g * mu) * (d * d)) with (d * (2 * q * (g * d) * mu)) by ring.
        apply Rmult_le_compat_l; [lra |]; apply Rmult_le_compat_r; lra. }
      assert (H2 : q * g * mu * (d * d) <= q * g * mu * (2001 / 1000 * e * (2001 / 1000 * e))) by (apply Rmult_le_compat_l; trivial).
      assert (H3 : 11 * g * e * (733 / 1000 * (q * (mu * e))) <= 11 * g * e * (xv * d)).
      { apply Rmult_le_compat_l; [apply Rmult_le_pos; lra | trivial]. }
      assert (P2 : 0 <= q * g * mu * (e * e)) by (apply Rmult_le_pos; [trivial | nra]).
      replace (d * (xv * (11 * g * e))) with (11 * g * e * (xv * d)) by ring.
      lra.
Qed.

(** * A nearly circumscribing ball for every vertex *)

(** For some vertex v the facet has a circumscribing ball of radius r < e about x with r − δ ≤ |p_v − x| ≤ r + δ. *)
Definition is_forbidden_configuration (m k : nat) (p : simplex) (g delta e : R) : Prop :=
  is_flake m k p g /\ exists v x r, (v <= S k)%nat /\ circumscribes m k (facet v p) x r /\ r < e /\
    r - delta <= distance m (p v) x <= r + delta.

Definition separated_vertices (m k : nat) (p : simplex) (s : R) : Prop :=
  forall i j, (i <= k)%nat -> (j <= k)%nat -> i <> j -> s <= distance m (p i) (p j).

Lemma distance_to_the_centre m k p v x r i :
  (v <= S k)%nat -> circumscribes m k (facet v p) x r -> (i <= S k)%nat -> i <> v -> distance m (p i) x = r.
Proof. intros Hv H Hi D; destruct (skip_other k v i Hv Hi D) as (j & Hj & <-); exact (H j Hj). Qed.

(** P3 in general: no edge is longer than 2r + δ. *)
Lemma edges_of_a_configuration m k p v x r delta :
  (v <= S k)%nat -> 0 <= delta -> circumscribes m k (facet v p) x r -> distance m (p v) x <= r + delta ->
  edges_at_most m (S k) p (2 * r + delta).
Proof.
  intros Hv Hd H Hp i j Hi Hj.
  pose proof (circumscribed_radius_nonneg m k (facet v p) x r H) as r0.
  destruct (Nat.eq_dec i j) as [->|D]; [rewrite distance_zero; lra |].
  pose proof (distance_triangle m (p i) x (p j)) as T; rewrite (distance_sym m x (p j)) in T.
  pose proof (fun l Hl E => distance_to_the_centre m k p v x r l Hv H Hl E) as On.
  destruct (Nat.eq_dec i v) as [->|Di], (Nat.eq_dec j v) as [->|Dj].
  - contradiction.
  - rewrite (On j Hj Dj) in T; lra.
  - rewrite (On i Hi Di) in T; lra.
  - rewrite (On i Hi Di), (On j Hj Dj) in T; lra.
Qed.

Lemma good_facets_are_independent m k p g s v :
  (1 <= k)%nat -> (v <= S k)%nat -> 0 < g -> 0 < s -> is_good m k (facet v p) g -> separated_vertices m (S k) p s ->
  independent m k (facet v p).
Proof.
  intros Hk Hv Hg Hs G Sep; destruct k as [|k]; [lia |]; destruct G as (T & _).
  destruct (longest_edge_exists m (S k) (facet v p)) as (d & Hd).
  apply (thick_simplices_are_independent m (S k) (facet v p) d (g ^ S k)); [|now apply pow_lt | now apply T].
  eapply Rlt_le_trans; [exact Hs |]; eapply Rle_trans; [|apply (proj1 Hd O 1%nat); lia].
  apply Sep; try apply skip_range; try lia; intros Q; apply skip_injective in Q; lia.
Qed.

Lemma difference_of_squares d r delta :
  0 <= r -> 0 <= d -> 0 <= delta -> r - delta <= d <= r + delta -> Rabs (d * d - r * r) <= delta * (2 * r + delta).
Proof.
  intros; replace (d * d - r * r) with ((d - r) * (d + r)) by ring; rewrite Rabs_mult.
  apply Rmult_le_compat; try apply Rabs_pos; apply Rabs_le; lra.
Qed.

Section Configuration.
Variables (m k : nat) (p : simplex) (g mu e delta : R).
Hypothesis dimension : (1 <= k)%nat.
Hypothesis unit : 0 < e.
Hypothesis separation : 0 < mu <= 1.
Hypothesis goodness : 0 < g <= 2 / 75.
Hypothesis goodness_and_separation : 15 * g <= mu.
Hypothesis protection : 0 <= delta <= g * g ^ k * (mu * e).
Hypothesis separated : separated_vertices m (S k) p (mu * e).
Hypothesis forbidden : is_forbidden_configuration m k p g delta e.

Lemma protection_is_small : delta <= e / 1000.
Proof.
  assert (g * g ^ k <= g * g).
  { apply Rmult_le_compat_l; [lra |]; destruct k as [|n]; [lia |]; change (g ^ S n) with (g * g ^ n).
    destruct (power_at_most_one g n ltac:(lra)); nra. }
  assert (0 <= g * g ^ k) by (apply Rmult_le_pos; [lra | apply pow_le; lra]).
  assert (g * g <= 2 / 75 * (2 / 75)) by (apply Rmult_le_compat; lra).
  assert (mu * e <= 1 * e) by (apply Rmult_le_compat_r; lra).
  assert (0 <= mu * e) by (apply Rmult_le_pos; lra).
  apply Rle_trans with (g * g ^ k * (mu * e)); [lra |].
  apply Rle_trans with (2 / 75 * (2 / 75) * (1 * e)); [apply Rmult_le_compat; lra | lra].
Qed.

Lemma edges_in_a_configuration : edges_at_most m (S k) p (2001 / 1000 * e).
Proof.
  destruct forbidden as (_ & v & x & r & Hv & H & Hr & Hp); pose proof protection_is_small.
  intros i j Hi Hj; eapply Rle_trans; [apply (edges_of_a_configuration m k p v x r delta); trivial; lra |]; lra.
Qed.

Lemma nearly_circumscribing_ball v :
  (v <= S k)%nat -> exists y r, circumscribes m k (facet v p) y r /\ r <= 1027 / 1000 * e /\
    Rabs (distance m (p v) y - r) <= 2002 / 1000 * (g * e).
Proof.
  intros Hv; destruct forbidden as (F & w & x & r & Hw & H & Hr & Hp); pose proof protection_is_small as Small.
  pose proof (circumscribed_radius_nonneg m k (facet w p) x r H) as r0.
  assert (G0 : 0 < g ^ k) by (apply pow_lt; lra).
  destruct (power_at_most_one g k ltac:(lra)) as (_ & G1).
  assert (ge : 0 < g * e) by (apply Rmult_lt_0_compat; lra).
  destruct (Nat.eq_dec v w) as [->|D].
  { exists x, r; repeat split; trivial; [lra |].
    assert (g * g ^ k * (mu * e) <= g * 1 * (1 * e)).
    { apply Rmult_le_compat; [apply Rmult_le_pos; lra | apply Rmult_le_pos; lra | apply Rmult_le_compat_l; lra |
        apply Rmult_le_compat_r; lra]. }
    apply Rabs_le; lra. }
  pose proof (fun l Hl E => distance_to_the_centre m k p w x r l Hw H Hl E) as On.
  set (d := distance m (p w) x) in *; assert (d0 : 0 <= d) by apply norm_nonneg.
  pose proof (difference_of_squares d r delta r0 d0 ltac:(lra) Hp) as Sq.
  set (t := d * d - r * r) in *.
  assert (K : 1 <= INR k) by (change 1 with (INR 1); now apply le_INR).
  assert (mue : 0 < mu * e) by (apply Rmult_lt_0_compat; lra).
  pose (a := INR k * g ^ k * (mu * e)).
  assert (a0 : 0 < a) by (unfold a; repeat apply Rmult_lt_0_compat; lra).
  destruct (ball_near_a_point m k (facet v p) x (r * r + t / 2) (Rabs t / 2) a dimension a0) as (y & r' & Hy & B).
  - pose proof (Rabs_pos t); lra.
  - apply (good_facets_are_independent m k p g (mu * e)); trivial; [lra | now apply F].
  - intros i Hi; apply (altitude_in_a_good_facet m k p g v (mu * e)); trivial; try lra; now apply F.
  - intros i Hi; destruct (Nat.eq_dec (skip v i) w) as [E|E].
    + unfold facet; rewrite E; fold d; replace (d * d - (r * r + t / 2)) with (t / 2) by (unfold t; field).
      unfold Rdiv; rewrite Rabs_mult, (Rabs_pos_eq (/ 2)); lra.
    + unfold facet; rewrite On; [|apply skip_range; trivial | trivial].
      replace (r * r - (r * r + t / 2)) with (- (t / 2)) by field; rewrite Rabs_Ropp.
      unfold Rdiv; rewrite Rabs_mult, (Rabs_pos_eq (/ 2)); lra.
  - assert (Near : distance m x y <= 1001 / 1000 * (g * e)).
    { eapply Rle_trans; [exact B |]; apply quotient_at_most; [lra |].
      assert (T : Rabs t <= g * g ^ k * (mu * e) * (2001 / 1000 * e)).
      { eapply Rle_trans; [exact Sq |]; apply Rmult_le_compat; lra. }
      assert (T2 : (INR k + 1) * Rabs t <= 2 * INR k * (g * g ^ k * (mu * e) * (2001 / 1000 * e))).
      { apply Rmult_le_compat; [lra | apply Rabs_pos | lra | trivial]. }
      unfold a.
      replace (1001 / 1000 * (g * e) * (2 * (INR k * g ^ k * (mu * e)))) with (2002 / 1000 * (INR k * (g * g ^ k * (mu * e) * e)))
        by field.
      assert (0 <= INR k * (g * g ^ k * (mu * e) * e)) by (repeat apply Rmult_le_pos; lra).
      lra. }
    destruct (skip_other k v w Hv Hw (fun Q => D (eq_sym Q))) as (iw & Hiw & Eiw).
    destruct (another_vertex k iw dimension) as (b & Hb & Db).
    assert (Eb : distance m (facet v p b) x = r).
    { apply On; [apply skip_range; trivial |]; intros Q; rewrite <- Eiw in Q; apply skip_injective in Q; congruence. }
    pose proof (On v Hv D) as Ev. specialize (Hy b Hb) as Hb'.
    pose proof (distance_triangle m (facet v p b) x y) as T1; pose proof (distance_triangle m (facet v p b) y x) as T2.
    pose proof (distance_triangle m (p v) x y) as T3; pose proof (distance_triangle m (p v) y x) as T4.
    rewrite (distance_sym m y x) in T2, T4; rewrite Eb, Hb' in T1, T2; rewrite Ev in T3, T4.
    exists y, r'; repeat split; trivial.
    + assert (g * e <= 2 / 75 * e) by (apply Rmult_le_compat_r; lra); lra.
    + apply Rabs_le; lra.
Qed.

(** * P1 and P2 *)

Lemma circumradius_of_a_facet v r :
  (v <= S k)%nat -> is_circumradius m k (facet v p) r -> mu * e / 2 <= r <= 1027 / 1000 * e.
Proof.
  intros Hv Hr; destruct (nearly_circumscribing_ball v Hv) as (y & u & Hy & Hu & _); split.
  - destruct Hr as (c & _ & H); pose proof (H O ltac:(lia)) as H0; pose proof (H 1%nat dimension) as H1.
    pose proof (distance_triangle m (facet v p 0%nat) (combination k c (facet v p)) (facet v p 1%nat)) as T.
    rewrite (distance_sym m (combination k c (facet v p)) (facet v p 1%nat)), H0, H1 in T.
    assert (mu * e <= distance m (facet v p 0%nat) (facet v p 1%nat)); [|lra].
    apply separated; try apply skip_range; try lia; intros Q; apply skip_injective in Q; lia.
  - eapply Rle_trans; [|exact Hu]; now apply (circumradius_is_least m k (facet v p) r y u).
Qed.

(** From a point of the affine hull to the sphere about the circumcentre. *)
Lemma to_the_circumsphere q c0 r c :
  is_circumcentre m k q c0 r -> sum (S k) c = 1 ->
  exists f, sum (S k) f = 1 /\ distance m (combination k f q) (combination k c0 q) = r /\
    distance m (combination k c q) (combination k f q) <= Rabs (distance m (combination k c q) (combination k c0 q) - r).
Proof.
  intros (c01 & H) c1; pose proof (circumscribed_radius_nonneg m k q _ r H) as r0.
  set (a := distance m (combination k c q) (combination k c0 q)).
  assert (a0 : 0 <= a) by apply norm_nonneg.
  destruct (Req_dec a 0) as [Z|NZ].
  - exists (unit_at 0); split; [apply sum_of_unit; lia |].
    assert (E : forall l, combination k (unit_at 0) q l = q O l)
      by (intros l; unfold combination; now rewrite (sum_unit_at (S k) 0 (fun j => q j l)) by lia).
    assert (E1 : forall x, distance m (combination k (unit_at 0) q) x = distance m (q O) x)
      by (intros x; apply norm_ext; intros; unfold minus; now rewrite E).
    split; [rewrite E1; apply H; lia |].
    rewrite distance_sym, E1; pose proof (distance_triangle m (q O) (combination k c0 q) (combination k c q)) as T.
    rewrite (distance_sym m (combination k c0 q)), H in T by lia; fold a in T; rewrite Z in T |- *.
    unfold Rabs; destruct Rcase_abs; lra.
  - exists (fun j => c0 j + r / a * (c j - c0 j)); split.
    + rewrite sum_plus, sum_scal, sum_minus, c1, c01; field; trivial.
    + assert (E : forall l, combination k (fun j => c0 j + r / a * (c j - c0 j)) q l =
                       combination k c0 q l + r / a * (combination k c q l - combination k c0 q l)).
      { intros l; unfold combination.
        rewrite (sum_ext (S k) _ (fun j => c0 j * q j l + r / a * (c j * q j l - c0 j * q j l))) by (intros; ring).
        rewrite sum_plus, sum_scal, sum_minus; ring. }
      split.
      * apply eq_trans with (norm m (fun l => r / a * minus (combination k c q) (combination k c0 q) l)).
        -- apply norm_ext; intros l _; unfold minus; rewrite E; ring.
        -- rewrite norm_scal by (apply quotient_nonneg; lra); change (r / a * a = r); field; trivial.
      * apply Rle_trans with (norm m (fun l => Rabs (1 - r / a) * minus (combination k c q) (combination k c0 q) l)).
        -- right; unfold distance, norm; f_equal; apply sum_ext; intros l _; unfold minus; rewrite E.
           unfold Rabs; destruct Rcase_abs; ring.
        -- rewrite norm_scal by apply Rabs_pos; change (Rabs (1 - r / a) * a <= Rabs (a - r)).
           right; rewrite <- (Rabs_pos_eq a) at 2 by trivial; rewrite <- Rabs_mult; f_equal; field; trivial.
Qed.

Lemma near_the_circumsphere v c0 r :
  (v <= S k)%nat -> is_circumcentre m k (facet v p) c0 r ->
  exists f, sum (S k) f = 1 /\ distance m (combination k f (facet v p)) (combination k c0 (facet v p)) = r /\
    distance m (p v) (combination k f (facet v p)) <= 175 * (g / mu ^ 3) * r.
Proof.
  intros Hv Hc; set (q := facet v p) in *.
  destruct (every_vertex_is_near_its_facet m k p g mu e v dimension Hv unit separation (proj1 goodness)
              goodness_and_separation (proj1 forbidden) separated edges_in_a_configuration) as (c & c1 & Hh); fold q in Hh.
  destruct (nearly_circumscribing_ball v Hv) as (y & u & Hy & Hu & Hs); fold q in Hy.
  pose proof (circumradius_of_a_facet v r Hv (ex_intro _ c0 Hc)) as Hr.
  destruct (to_the_circumsphere q c0 r c Hc c1) as (f & f1 & Hf & Hz).
  exists f; repeat split; trivial.
  pose proof (spread_in_a_ball m k q y u c c1 Hy) as S1; pose proof (spread_in_a_ball m k q _ r c c1 (proj2 Hc)) as S2.
  pose proof (distance_triangle m (p v) (combination k c q) (combination k f q)) as T.
  pose proof (distance_triangle m (p v) (combination k c q) y) as T1.
  pose proof (distance_triangle m (combination k c q) (p v) y) as T2.
  rewrite (distance_sym m (combination k c q) (p v)) in T2.
  pose proof (circumscribed_radius_nonneg m k q y u Hy) as u0.
  set (h := distance m (p v) (combination k c q)) in *; assert (h0 : 0 <= h) by apply norm_nonneg.
  set (b := distance m (combination k c q) y) in *; assert (b0 : 0 <= b) by apply norm_nonneg.
  set (a := distance m (combination k c q) (combination k c0 q)) in *; assert (a0 : 0 <= a) by apply norm_nonneg.
  set (s := distance m (p v) y) in *; clearbody h b a s.
  set (tau := g / mu ^ 3).
  assert (mu3 : 0 < mu ^ 3) by (apply pow_lt; lra).
  assert (tau0 : 0 < tau) by (apply Rdiv_lt_0_compat; lra).
  assert (gt : g = tau * (mu * (mu * mu))) by (unfold tau; field; lra).
  set (w := 2002 / 1000 * (g * e) + h).
  assert (ge : 0 < g * e) by (apply Rmult_lt_0_compat; lra).
  assert (w0 : 0 <= w) by (unfold w; lra).
  assert (Bu : u - w <= b <= u + w).
  { unfold w; unfold Rabs in Hs; destruct Rcase_abs; lra. }
  assert (Wm : w * mu <= 13002 / 1000 * (g * e)).
  { unfold w; assert (g * e * mu <= g * e * 1) by (apply Rmult_le_compat_l; lra); lra. }
  assert (Wt : w <= 13002 / 1000 * (tau * (mu * (mu * e)))).
  { apply Rmult_le_reg_r with mu; [lra |]; eapply Rle_trans; [exact Wm |]; rewrite gt; lra. }
  assert (We : w <= 87 / 100 * e).
  { apply Rmult_le_reg_r with mu; [lra |]; eapply Rle_trans; [exact Wm |].
    assert (15 * g * e <= mu * e) by (apply Rmult_le_compat_r; lra).
    assert (0 <= mu * e) by (apply Rmult_le_pos; lra); lra. }
  assert (Ht : h <= 11 * (tau * (mu * (mu * e)))).
  { apply Rmult_le_reg_r with mu; [lra |]; eapply Rle_trans; [exact Hh |]; rewrite gt; lra. }
  assert (me : 0 < mu * e) by (apply Rmult_lt_0_compat; lra).
  assert (tm : tau * (mu * (mu * e)) <= 2 * (tau * r)).
  { assert (mu * (mu * e) <= 1 * (2 * r)) by (apply Rmult_le_compat; lra).
    replace (2 * (tau * r)) with (tau * (1 * (2 * r))) by ring; apply Rmult_le_compat_l; lra. }
  pose proof (difference_of_squares b u w u0 b0 w0 Bu) as Q.
  assert (Q1 : Rabs (a * a - r * r) <= w * (2 * u + w)).
  { replace (a * a - r * r) with (b * b - u * u) by lra; exact Q. }
  assert (Q2 : w * (2 * u + w) <= 153 * (tau * r) * r).
  { apply Rle_trans with (13002 / 1000 * (tau * (mu * (mu * e))) * (2924 / 1000 * e)).
    - apply Rmult_le_compat; lra.
    - assert (mu * e * (mu * e) <= 2 * r * (2 * r)) by (apply Rmult_le_compat; lra).
      assert (tau * (mu * e * (mu * e)) <= tau * (2 * r * (2 * r))) by (apply Rmult_le_compat_l; lra).
      assert (0 <= tau * (mu * e * (mu * e))) by (apply Rmult_le_pos; [lra | nra]).
      replace (13002 / 1000 * (tau * (mu * (mu * e))) * (2924 / 1000 * e))
        with (13002 / 1000 * (2924 / 1000) * (tau * (mu * e * (mu * e)))) by ring.
      replace (153 * (tau * r) * r) with (153 / 4 * (tau * (2 * r * (2 * r)))) by field.
      lra. }
  assert (A : Rabs (a - r) <= 153 * (tau * r)).
  { apply Rmult_le_reg_r with r; [lra |].
    apply Rle_trans with (Rabs (a - r) * (a + r)); [apply Rmult_le_compat_l; [apply Rabs_pos | lra] |].
    rewrite <- (Rabs_pos_eq (a + r)) at 1 by lra; rewrite <- Rabs_mult.
    replace ((a - r) * (a + r)) with (a * a - r * r) by ring; lra. }
  lra.
Qed.
End Configuration.

(** * The lemma *)

(** lem:prop.forbid.cfg, P1 to P4, for τ with vertices μ₀′ε′ apart: ε′ = (1 + ρ₀) ε, μ₀′ = (μ₀ − 2ρ₀)/(1 + ρ₀),
    δ = δ₀μ₀′ε′. P4 is part of the definition of a flake. The constant of P1 could be 2735. *)
Theorem properties_of_forbidden_configurations m k p mu0 rho0 eps g delta0 :
  (1 <= k <= m)%nat -> 0 < eps -> 0 < mu0 <= 1 -> 0 <= rho0 <= mu0 / 4 -> 0 < g <= 2 * mu0 ^ 2 / 75 ->
  0 <= delta0 <= g ^ (m + 1) ->
  let eps' := (1 + rho0) * eps in
  let mu' := (mu0 - 2 * rho0) / (1 + rho0) in
  separated_vertices m (S k) p (mu' * eps') -> is_forbidden_configuration m k p g (delta0 * mu' * eps') eps' ->
  forall v, (v <= S k)%nat ->
    (forall c r, is_circumcentre m k (facet v p) c r ->
       exists f, sum (S k) f = 1 /\ distance m (combination k f (facet v p)) (combination k c (facet v p)) = r /\
         distance m (p v) (combination k f (facet v p)) <= 2 ^ 13 * g / mu0 ^ 3 * r) /\
    (exists r, is_circumradius m k (facet v p) r) /\
    (forall r, is_circumradius m k (facet v p) r -> r < 2 * eps) /\
    (forall d, is_longest_edge m (S k) p d -> d < 5 / 2 * (1 + delta0 * mu0 / 2) * eps) /\
    is_good m k (facet v p) g.
Proof.
  intros (Hk & Hkm) He Hmu Hrho Hg Hd eps' mu' Sep Forbidden v Hv.
  assert (S2 : mu0 ^ 2 <= mu0) by (simpl; nra).
  assert (E1 : 0 < eps') by (unfold eps'; nra).
  assert (E2 : eps' <= 5 / 4 * eps) by (unfold eps'; nra).
  assert (M1 : mu' * (1 + rho0) = mu0 - 2 * rho0) by (unfold mu'; field; lra).
  assert (M2 : 2 / 5 * mu0 <= mu') by (unfold mu'; apply at_most_quotient; nra).
  assert (M3 : mu' <= 1) by (unfold mu'; apply quotient_at_most; lra).
  assert (G1 : g <= 2 / 75) by lra.
  assert (G2 : 15 * g <= mu') by lra.
  assert (Pw : forall i j, (i <= j)%nat -> g ^ j <= g ^ i).
  { intros i j H; induction H as [|j H IH]; [lra |]; simpl; assert (0 <= g ^ j) by (apply pow_le; lra); nra. }
  assert (me : 0 < mu' * eps') by (apply Rmult_lt_0_compat; lra).
  assert (Pr : 0 <= delta0 * mu' * eps' <= g * g ^ k * (mu' * eps')).
  { rewrite Rmult_assoc; split; [apply Rmult_le_pos; lra |]; apply Rmult_le_compat_r; [lra |].
    eapply Rle_trans; [apply Hd |]; change (g * g ^ k) with (g ^ S k); apply Pw; lia. }
  repeat split.
  - intros c r Hc.
    destruct (near_the_circumsphere m k p g mu' eps' (delta0 * mu' * eps') Hk E1 ltac:(lra) ltac:(lra) G2 Pr Sep Forbidden v c r Hv Hc)
      as (f & f1 & F1 & F2).
    exists f; repeat split; trivial; eapply Rle_trans; [exact F2 |].
    pose proof (circumscribed_radius_nonneg m k (facet v p) _ r (proj2 Hc)) as r0.
    apply Rmult_le_compat_r; [trivial |].
    assert (C : 8 / 125 * mu0 ^ 3 <= mu' ^ 3).
    { replace (8 / 125 * mu0 ^ 3) with ((2 / 5 * mu0) ^ 3) by field; apply pow_incr; lra. }
    assert (0 < mu0 ^ 3) by (apply pow_lt; lra).
    unfold Rdiv at 1; rewrite <- Rmult_assoc; fold (175 * g / mu' ^ 3).
    apply quotient_at_most; [lra |].
    apply Rle_trans with (2 ^ 13 * g / mu0 ^ 3 * (8 / 125 * mu0 ^ 3)).
    + replace (2 ^ 13 * g / mu0 ^ 3 * (8 / 125 * mu0 ^ 3)) with (2 ^ 13 * (8 / 125) * g) by (field; lra); simpl; lra.
    + apply Rmult_le_compat_l; [|trivial]; apply quotient_nonneg; [|lra]; apply Rmult_le_pos; [simpl; lra | lra].
  - destruct (circumcentre_exists m k (facet v p)) as (c & r & Hc).
    + apply (good_facets_are_independent m k p g (mu' * eps')); trivial; [lra | now apply Forbidden].
    + exists r, c; exact Hc.
  - intros r Hr.
    destruct (circumradius_of_a_facet m k p g mu' eps' (delta0 * mu' * eps') Hk E1 ltac:(lra) ltac:(lra) Pr Sep Forbidden v r Hv Hr)
      as (_ & U); lra.
  - intros d (_ & i & j & Hi & Hj & <-).
    destruct Forbidden as (_ & w & x & r & Hw & H & Hr & Hp).
    eapply Rle_lt_trans.
    { apply (edges_of_a_configuration m k p w x r (delta0 * mu' * eps')); trivial; lra. }
    assert (Q : delta0 * mu' * eps' = delta0 * (mu0 - 2 * rho0) * eps).
    { rewrite <- M1; unfold eps'; ring. }
    rewrite Q.
    assert (2 * r < 5 / 2 * eps) by lra.
    assert (delta0 * (mu0 - 2 * rho0) * eps <= delta0 * (5 / 4 * mu0) * eps).
    { apply Rmult_le_compat_r; [lra |]; apply Rmult_le_compat_l; lra. }
    lra.
  - now apply Forbidden.
Qed.
