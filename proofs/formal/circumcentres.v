(** Circumscribing balls by way of weights: R² is the greatest Σ_{i<j} c_i c_j |p_i − p_j|² of all weights that add up to
    1, a concave quadratic form in them and linear in the squares of the edges. *)

Require Import Reals Lra Lia Psatz.
From Delcert Require Import vectors simplices circumradius weights projections.
Open Scope R_scope.

(** The ball around x of radius r has all vertices on its boundary. *)
Definition circumscribes (m k : nat) (p : simplex) (x : vector) (r : R) : Prop :=
  forall i, (i <= k)%nat -> distance m (p i) x = r.

(** The circumcentre is Σ c_i p_i, the circumradius r. *)
Definition is_circumcentre (m k : nat) (p : simplex) (c : vector) (r : R) : Prop :=
  sum (S k) c = 1 /\ circumscribes m k p (combination k c p) r.

Lemma spread_in_a_ball m k p x r c :
  sum (S k) c = 1 -> circumscribes m k p x r ->
  spread m k c p = r * r - distance m (combination k c p) x * distance m (combination k c p) x.
Proof.
  intros c1 H; pose proof (lagrange m k c p x c1) as L.
  rewrite (sum_ext (S k) _ (fun i => c i * (r * r))) in L by (intros; rewrite H by lia; ring).
  rewrite sum_scal_right, c1 in L; lra.
Qed.

Theorem spread_at_most_squared_radius m k p x r c :
  sum (S k) c = 1 -> circumscribes m k p x r -> spread m k c p <= r * r.
Proof.
  intros c1 H; rewrite (spread_in_a_ball m k p x r c c1 H).
  pose proof (Rle_0_sqr (distance m (combination k c p) x)); unfold Rsqr in *; lra.
Qed.

Theorem spread_at_the_circumcentre m k p c r : is_circumcentre m k p c r -> spread m k c p = r * r.
Proof. intros [c1 H]; rewrite (spread_in_a_ball m k p _ r c c1 H), distance_zero; ring. Qed.

Lemma circumscribed_radius_nonneg m k p x r : circumscribes m k p x r -> 0 <= r.
Proof. intros H; rewrite <- (H O) by lia; apply norm_nonneg. Qed.

(** The circumradius is the least radius of all circumscribing balls, as the paper defines it. *)
Theorem circumradius_is_least m k p r x u : is_circumradius m k p r -> circumscribes m k p x u -> r <= u.
Proof.
  intros (c & c1 & Hc) H; apply le_of_squares; [now apply (circumscribed_radius_nonneg m k p x) |].
  rewrite <- (spread_at_the_circumcentre m k p c r) by (split; trivial).
  now apply (spread_at_most_squared_radius m k p x).
Qed.

Theorem circumradius_is_unique m k p r u : is_circumradius m k p r -> is_circumradius m k p u -> r = u.
Proof.
  intros Hr Hu; apply Rle_antisym; [destruct Hu as (c & _ & H) | destruct Hr as (c & _ & H)];
    now apply (circumradius_is_least m k p _ (combination k c p)).
Qed.

(** A simplex that is not degenerate has a circumcentre. *)
Theorem circumcentre_exists m k p : independent m k p -> exists c r, is_circumcentre m k p c r.
Proof.
  intros H; destruct (equidistant_point m p (p O) k H) as (w & r & w0 & _ & Hw).
  exists (fun j => unit_at 0 j + w j), r; split.
  - rewrite sum_plus, sum_of_unit, w0 by lia; ring.
  - intros i Hi; rewrite <- (Hw i Hi); apply norm_ext; intros a _; unfold minus; f_equal.
    unfold moved, combination.
    rewrite (sum_ext (S k) _ (fun j => unit_at 0 j * p j a + w j * p j a)) by (intros; ring).
    rewrite sum_plus, (sum_unit_at (S k) 0 (fun j => p j a)) by lia; trivial.
Qed.

(** The weights of the circumcentre are at most the circumradius over the altitude. *)
Lemma weights_of_the_circumcentre m k p c r a :
  (1 <= k)%nat -> 0 < a -> is_circumcentre m k p c r -> (forall i, (i <= k)%nat -> altitude_at_least m k p i a) ->
  forall i, (i <= k)%nat -> Rabs (c i) <= r / a.
Proof.
  intros Hk Ha [c1 H] Hp i Hi.
  apply at_most_quotient; trivial.
  apply (weight_within m k p c i); auto.
  intros j Hj; rewrite distance_sym, H; trivial; lra.
Qed.

(** A point at nearly the same distance from all vertices is near to the centre of a circumscribing ball: squares of the
    distances within e of v, altitudes at least a. *)
Theorem ball_near_a_point m k p x v e a :
  (1 <= k)%nat -> 0 < a -> 0 <= e -> independent m k p -> (forall i, (i <= k)%nat -> altitude_at_least m k p i a) ->
  (forall i, (i <= k)%nat -> Rabs (distance m (p i) x * distance m (p i) x - v) <= e) ->
  exists y r, circumscribes m k p y r /\ distance m x y <= (INR k + 1) * e / (2 * a).
Proof.
  intros Hk Ha He Hi Hp Hx.
  destruct (equidistant_point m p x k Hi) as (w & r & w0 & _ & Hw).
  exists (moved k w p x), r; split; [exact Hw |].
  set (h := combination k w p).
  assert (X : distance m x (moved k w p x) = norm m h).
  { rewrite distance_sym; apply norm_ext; intros; unfold minus, moved; fold h; ring. }
  rewrite X; clear X.
  (* Σ w_j |p_j − x|² = 2 |h|² *)
  assert (E : sum (S k) (fun j => w j * (distance m (p j) x * distance m (p j) x)) = 2 * dot m h h).
  { assert (Z : forall j, (j <= k)%nat -> distance m (p j) x * distance m (p j) x
                = (r * r - dot m h h + 2 * dot m (minus (p O) x) h) + 2 * dot m h (minus (p j) (p O))).
    { intros j Hj; rewrite <- (Hw j Hj).
      replace (distance m (p j) (moved k w p x)) with (distance m (p j) (fun a => x a + 1 * h a)).
      - rewrite squared_distance_moved, (dot_difference m (p j) (p O)); ring.
      - apply norm_ext; intros; unfold minus, moved; fold h; ring. }
    rewrite (sum_ext (S k) _ (fun j => w j * (r * r - dot m h h + 2 * dot m (minus (p O) x) h)
                                       + 2 * (w j * dot m h (minus (p j) (p O)))))
      by (intros; rewrite Z by lia; ring).
    rewrite sum_plus, sum_scal_right, w0, sum_scal.
    replace (sum (S k) (fun j => w j * dot m h (minus (p j) (p O)))) with (dot m h h); [ring |].
    unfold dot at 2; rewrite (sum_ext (S k) _ (fun j => sum m (fun b => w j * (h b * minus (p j) (p O) b))))
      by (intros; now rewrite sum_scal).
    rewrite sum_swap; apply sum_ext; intros b _; unfold minus.
    rewrite (sum_ext (S k) _ (fun j => h b * (w j * p j b) - h b * p O b * w j)) by (intros; ring).
    rewrite sum_minus, !sum_scal, w0; unfold h at 2, combination; ring. }
  assert (G : forall i, (i <= k)%nat -> Rabs (w i) <= norm m h / a).
  { intros i I; apply at_most_quotient; trivial; now apply difference_weight; auto. }
  pose proof (weighted_sum_near k w (fun i => distance m (p i) x * distance m (p i) x) v (norm m h / a) e G Hx) as B.
  cbv beta in B; rewrite E, w0, <- norm_squared in B; pose proof (norm_nonneg m h) as N; set (l := norm m h) in *; clearbody l.
  destruct (Req_dec l 0) as [->|NZ].
  - apply Rmult_le_pos; [apply Rmult_le_pos; [pose proof (pos_INR k); lra | trivial] |].
    left; apply Rinv_0_lt_compat; lra.
  - apply Rmult_le_reg_l with (2 * l); [lra |].
    replace (2 * l * ((INR k + 1) * e / (2 * a))) with ((INR k + 1) * (l / a * e)) by (field; lra).
    unfold Rabs in B; destruct Rcase_abs; lra.
Qed.
