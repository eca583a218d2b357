(** The image of a ball under a transition function contains a ball: it is open, and inverse images of a segment in it
    cannot run out of the domain. *)

Require Import Reals Lra Lia Psatz Classical.
From Delcert Require Import vectors.
Open Scope R_scope.

(** The coordinates that count are the same. *)
Definition agree (m : nat) (u v : vector) : Prop := forall a, (a < m)%nat -> u a = v a.

Lemma distance_agree m u u' v v' : agree m u u' -> agree m v v' -> distance m u v = distance m u' v'.
Proof. intros U V; apply norm_ext; intros a Ha; unfold minus; now rewrite U, V. Qed.

Lemma coordinate_at_most_distance m u v a : (a < m)%nat -> Rabs (u a - v a) <= distance m u v.
Proof.
  intros Ha; apply abs_le_of_squares; [apply norm_nonneg |]; unfold distance; rewrite norm_squared.
  apply (term_le_sum m (fun b => minus u v b * minus u v b)); [intros; nra | trivial].
Qed.

Lemma distance_at_most_coordinates m u v : distance m u v <= sum m (fun a => Rabs (u a - v a)).
Proof.
  induction m as [|m IH]; [unfold distance, norm, dot; simpl; rewrite sqrt_0; lra |].
  change (sum (S m) ?f) with (sum m f + f m); cbv beta.
  assert (N : 0 <= Rabs (u m - v m)) by apply Rabs_pos.
  assert (D : 0 <= distance m u v) by apply norm_nonneg.
  apply Rle_trans with (distance m u v + Rabs (u m - v m)); [|lra].
  apply norm_le; [lra |]; change (dot (S m) ?x ?x) with (dot m x x + x m * x m).
  rewrite <- norm_squared; fold (distance m u v); unfold minus at 1 2.
  assert (E : (u m - v m) * (u m - v m) = Rabs (u m - v m) * Rabs (u m - v m)) by (unfold Rabs; destruct Rcase_abs; ring).
  rewrite E; nra.
Qed.

(** A sequence of vectors whose distances are at most those of a convergent sequence of numbers converges. *)
Lemma limit_of_vectors m (x : nat -> vector) (s : nat -> R) (c limit : R) :
  0 <= c -> Un_cv s limit -> (forall i j, distance m (x i) (x j) <= c * Rabs (s i - s j)) ->
  exists y, forall d, 0 < d -> exists n, Rabs (s n - limit) < d /\ distance m (x n) y < d.
Proof.
  intros Hc Hs Hx.
  assert (Coordinate : forall a, (a < m)%nat -> { l | Un_cv (fun n => x n a) l }).
  { intros a Ha; apply R_complete; intros d Hd.
    destruct (CV_Cauchy s (exist _ limit Hs) (d / (c + 1)) ltac:(apply Rdiv_lt_0_compat; lra)) as (N & HN).
    exists N; intros i j Hi Hj; unfold R_dist.
    eapply Rle_lt_trans; [apply (coordinate_at_most_distance m (x i) (x j) a Ha) |].
    eapply Rle_lt_trans; [apply Hx |]; specialize (HN i j Hi Hj); unfold R_dist in HN.
    apply Rle_lt_trans with (c * (d / (c + 1))); [apply Rmult_le_compat_l; lra |].
    replace d with ((c + 1) * (d / (c + 1))) at 2 by (field; lra).
    assert (0 < d / (c + 1)) by (apply Rdiv_lt_0_compat; lra); nra. }
  assert (All : forall k, (k <= m)%nat -> exists y : vector, forall d, 0 < d -> exists N, forall n, (n >= N)%nat ->
                  sum k (fun a => Rabs (x n a - y a)) < d).
  { induction k as [|k IH]; intros Hk.
    - exists (fun _ => 0); intros d Hd; exists O; intros; simpl; lra.
    - destruct (IH ltac:(lia)) as (y & Hy); destruct (Coordinate k ltac:(lia)) as (l & Hl).
      exists (fun a => if Nat.eqb a k then l else y a); intros d Hd.
      destruct (Hy (d / 2) ltac:(lra)) as (N1 & H1); destruct (Hl (d / 2) ltac:(lra)) as (N2 & H2).
      exists (Nat.max N1 N2); intros n Hn; simpl sum; rewrite Nat.eqb_refl.
      specialize (H1 n ltac:(lia)); specialize (H2 n ltac:(lia)); unfold R_dist in H2.
      rewrite (sum_ext k _ (fun a => Rabs (x n a - y a))); [lra |].
      intros a Ha; destruct (Nat.eqb_spec a k); [lia | trivial]. }
  destruct (All m ltac:(lia)) as (y & Hy); exists y; intros d Hd.
  destruct (Hy d Hd) as (N1 & H1); destruct (Hs d Hd) as (N2 & H2).
  exists (Nat.max N1 N2); split; [apply H2; lia |].
  eapply Rle_lt_trans; [apply distance_at_most_coordinates | apply H1; lia].
Qed.

(** φ maps D into the open set V, and ψ maps V into D; φ(ψ(y)) = y, and neither changes distances by more than ξ times
    what they were. These are transition functions between two charts, restricted to D and to V = φ(D). *)
Definition is_transition (m : nat) (D V : vector -> Prop) (phi psi : vector -> vector) (xi : R) : Prop :=
  (forall x, D x -> V (phi x)) /\ (forall y, V y -> D (psi y) /\ agree m (phi (psi y)) y) /\
  (forall y, V y -> exists h, 0 < h /\ forall y', distance m y' y < h -> V y') /\
  (forall x x', D x -> D x' -> Rabs (distance m x x' - distance m (phi x) (phi x')) <= xi * distance m x x') /\
  (forall y y', V y -> V y' -> Rabs (distance m y y' - distance m (psi y) (psi y')) <= xi * distance m y y').

Theorem image_contains_a_ball m D V phi psi xi c a y :
  0 <= xi < 1 -> is_transition m D V phi psi xi -> (forall x, distance m x c < a -> D x) ->
  distance m y (phi c) < (1 - xi) * a -> V y.
Proof.
  intros Hxi (Into & Inverse & Open & Forth & _) Ball Hy.
  pose (w := minus y (phi c)); pose (way := fun s => fun b => phi c b + s * w b).
  set (len := distance m y (phi c)) in *.
  assert (L0 : 0 <= len) by apply norm_nonneg.
  assert (Ha : 0 < a) by nra.
  assert (Dc : D c) by (apply Ball; now rewrite distance_zero).
  assert (Between : forall s t, distance m (way s) (way t) = Rabs (s - t) * len).
  { intros s t; transitivity (norm m (fun b => Rabs (s - t) * w b)); [|apply norm_scal, Rabs_pos].
    unfold distance, norm, dot; f_equal; apply sum_ext; intros b _; unfold minus, way.
    unfold Rabs; destruct Rcase_abs; ring. }
  assert (W0 : agree m (way 0) (phi c)) by (intros b _; unfold way; ring).
  assert (W1 : agree m (way 1) y) by (intros b _; unfold way, w, minus; ring).
  assert (Same : forall u, agree m u u) by (intros u b _; trivial).
  assert (Agree : forall u v, V u -> agree m v u -> V v).
  { intros u v Vu E; destruct (Open u Vu) as (h & Hh & O); apply O.
    rewrite (distance_agree m v u u u E (Same u)); now rewrite distance_zero. }
  assert (Back : forall x x', D x -> D x' -> (1 - xi) * distance m x x' <= distance m (phi x) (phi x')).
  { intros x x' Dx Dx'; specialize (Forth x x' Dx Dx'); unfold Rabs in Forth; destruct Rcase_abs; lra. }
  (* the part of the way up to s is in V *)
  pose (E := fun s => 0 <= s <= 1 /\ forall t, 0 <= t <= s -> V (way t)).
  assert (E0 : E 0).
  { split; [lra |]; intros t Ht; replace t with 0 by lra; apply (Agree (phi c)); auto. }
  destruct (completeness E) as (T & Up & Low).
  { exists 1; intros s Hs; apply Hs. }
  { now exists 0. }
  assert (T0 : 0 <= T <= 1) by (split; [now apply Up | apply Low; intros s Hs; apply Hs]).
  assert (Before : forall s, 0 <= s < T -> V (way s)).
  { intros s Hs; destruct (classic (exists t, E t /\ s < t)) as [(t & (_ & Et) & Lt)|N]; [apply Et; lra |].
    assert (T <= s); [|lra]; apply Low; intros t Et; apply Rnot_lt_le; intros L; apply N; now exists t. }
  assert (Inner : forall s, V (way s) -> (1 - xi) * distance m (psi (way s)) c <= Rabs s * len).
  { intros s Vs; destruct (Inverse _ Vs) as (Ds & Is); eapply Rle_trans; [now apply Back |].
    rewrite (distance_agree m (phi (psi (way s))) (way s) (phi c) (way 0) Is); [|intros b Hb; now rewrite W0].
    rewrite Between, Rminus_0_r; lra. }
  (* the point T of the way is in V *)
  assert (VT : V (way T)).
  { destruct (Req_dec T 0) as [->|TN]; [apply E0; lra |].
    pose (s := fun n => T - T * / INR (S n)).
    assert (S0 : forall n, 0 <= s n < T).
    { intros n; pose proof (lt_0_INR (S n) ltac:(lia)) as N0.
      assert (1 <= INR (S n)) by (change 1 with (INR 1); apply le_INR; lia).
      assert (0 < / INR (S n) <= 1).
      { split; [now apply Rinv_0_lt_compat |]; rewrite <- Rinv_1; apply Rinv_le_contravar; lra. }
      unfold s; split; [|assert (0 < T * / INR (S n)) by (apply Rmult_lt_0_compat; lra); lra].
      assert (T * / INR (S n) <= T * 1) by (apply Rmult_le_compat_l; lra); lra. }
    assert (Lim : Un_cv s T).
    { intros d Hd.
      assert (HN : exists N, / d < INR N).
      { destruct (archimed (/ d)) as (A & _).
        assert (0 < / d) by (now apply Rinv_0_lt_compat).
        exists (Z.to_nat (up (/ d))); rewrite INR_IZR_INZ, Z2Nat.id; trivial.
        apply le_IZR; lra. }
      destruct HN as (N & HN); exists N; intros n Hn; unfold R_dist, s.
      assert (INR N <= INR (S n)) by (apply le_INR; lia).
      assert (0 < / d) by (now apply Rinv_0_lt_compat).
      assert (I : / INR (S n) < d).
      { rewrite <- (Rinv_inv d); apply Rinv_lt_contravar; [apply Rmult_lt_0_compat |]; lra. }
      assert (I0 : 0 < / INR (S n)) by (apply Rinv_0_lt_compat; lra).
      replace (T - T * / INR (S n) - T) with (- (T * / INR (S n))) by ring; rewrite Rabs_Ropp, Rabs_pos_eq by nra; nra. }
    destruct (limit_of_vectors m (fun n => psi (way (s n))) s (len / (1 - xi)) T) as (x & Hx); trivial.
    { apply quotient_nonneg; lra. }
    { intros i j; destruct (Inverse _ (Before _ (S0 i))) as (Di & Ii), (Inverse _ (Before _ (S0 j))) as (Dj & Ij).
      pose proof (Back _ _ Di Dj) as B.
      rewrite (distance_agree m (phi (psi (way (s i)))) (way (s i)) (phi (psi (way (s j)))) (way (s j)) Ii Ij), Between in B.
      replace (len / (1 - xi) * Rabs (s i - s j)) with (Rabs (s i - s j) * len / (1 - xi)) by (field; lra).
      apply at_most_quotient; lra. }
    assert (Dx : D x).
    { apply Ball; pose (d := (a - len / (1 - xi)) / 2).
      assert (Hd : 0 < d).
      { unfold d; assert (len / (1 - xi) < a); [|lra].
        apply Rmult_lt_reg_r with (1 - xi); [lra |]; unfold Rdiv; rewrite Rmult_assoc, Rinv_l; lra. }
      destruct (Hx d Hd) as (n & _ & Hn); pose proof (Inner (s n) (Before _ (S0 n))) as I.
      pose proof (distance_triangle m x (psi (way (s n))) c) as Tr; rewrite (distance_sym m x (psi (way (s n)))) in Tr.
      assert (distance m (psi (way (s n))) c <= len / (1 - xi)); [|unfold d in *; lra].
      apply at_most_quotient; [lra |]; pose proof (S0 n) as Sn; rewrite Rabs_pos_eq in I by lra; nra. }
    apply (Agree (phi x)); [now apply Into |].
    assert (Z : distance m (way T) (phi x) <= 0).
    { apply le_epsilon; intros d Hd; rewrite Rplus_0_l.
      pose (h := d / (len + 2)); assert (Hh : 0 < h) by (apply Rdiv_lt_0_compat; lra).
      destruct (Hx h Hh) as (n & Sn & Xn); destruct (Inverse _ (Before _ (S0 n))) as (Dn & In).
      pose proof (distance_triangle m (way T) (way (s n)) (phi x)) as Tr.
      rewrite Between, Rabs_minus_sym in Tr.
      rewrite <- (distance_agree m (phi (psi (way (s n)))) (way (s n)) (phi x) (phi x) In (Same _)) in Tr.
      specialize (Forth _ _ Dn Dx); set (g := distance m (psi (way (s n))) x) in *.
      assert (0 <= g) by apply norm_nonneg.
      assert (Rabs (s n - T) * len <= h * len) by (apply Rmult_le_compat_r; lra).
      assert (d = h * (len + 2)) by (unfold h; field; lra).
      assert (distance m (phi (psi (way (s n)))) (phi x) <= (1 + xi) * g) by (unfold Rabs in Forth; destruct Rcase_abs; lra).
      assert ((1 + xi) * g <= 2 * h) by (apply Rmult_le_compat; lra); lra. }
    intros b Hb; pose proof (coordinate_at_most_distance m (way T) (phi x) b Hb) as C.
    unfold Rabs in C; destruct Rcase_abs; lra. }
  destruct (Rlt_le_dec T 1) as [L|G].
  - exfalso; destruct (Open _ VT) as (h & Hh & O).
    pose (u := Rmin 1 (T + h / (2 * (len + 1)))).
    assert (Hu : 0 < h / (2 * (len + 1))) by (apply Rdiv_lt_0_compat; lra).
    assert (U : T < u <= 1) by (unfold u, Rmin; destruct Rle_dec; lra).
    assert (E u); [split; [lra |]; intros t Ht | now apply (Rlt_irrefl T), Rlt_le_trans with u; [|apply Up]].
    destruct (Rlt_le_dec t T) as [Lt|Ge]; [apply Before; lra |].
    apply O; rewrite Between, Rabs_pos_eq by lra.
    assert (t - T <= h / (2 * (len + 1))) by (unfold u, Rmin in Ht; destruct Rle_dec in Ht; lra).
    apply Rle_lt_trans with (h / (2 * (len + 1)) * len); [apply Rmult_le_compat_r; lra |].
    replace h with (h / (2 * (len + 1)) * (2 * (len + 1))) at 2 by (field; lra); nra.
  - apply (Agree (way 1)); [replace 1 with T by lra; trivial |]; intros b Hb; now rewrite W1.
Qed.
