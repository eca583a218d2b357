(** An accepted certificate is the Delaunay triangulation of its points, in any dimension. *)
From Coq Require Import Reals Bool List ZArith FMapPositive Lra Lia.
From Delcert Require Import vectors certificates tessellations hints.
Import ListNotations.
Open Scope R_scope.

(** * Finitely many integer vectors *)

Definition integers_to (b : Z) : list Z := map (fun i => (Z.of_nat i - b)%Z) (seq 0 (Z.to_nat (2 * b + 1))).

Fixpoint integer_box (n : nat) (b : Z) : list (list Z) :=
  match n with
  | O => [[]]
  | S n' => flat_map (fun c => map (cons c) (integer_box n' b)) (integers_to b)
  end.

Lemma integer_box_length n b u : In u (integer_box n b) -> length u = n.
Proof.
  revert u; induction n as [| n IH]; intros u I; simpl in I.
  - destruct I as [<- | []]; reflexivity.
  - apply in_flat_map in I as [c [_ I]]. apply in_map_iff in I as [u' [<- I]]. simpl; rewrite (IH u' I); reflexivity.
Qed.

Lemma in_integer_box n b u : length u = n -> (forall i, (Z.abs (nth i u 0) <= b)%Z) -> In u (integer_box n b).
Proof.
  revert n; induction u as [| c u IH]; intros [| n] L A; try discriminate; simpl; auto.
  injection L as L. apply in_flat_map; exists c; split.
  - specialize (A 0%nat); simpl in A. unfold integers_to; apply in_map_iff.
    exists (Z.to_nat (c + b)); split; [lia |]. apply in_seq; lia.
  - apply in_map, IH; [assumption |]. intros i; exact (A (S i)).
Qed.

Lemma coordinates_bounded x : exists b, 0 <= b /\ forall i, Rabs (coordinate i x) <= b.
Proof.
  induction x as [| a x [b [P A]]].
  - exists 0; split; [lra |]. intros i; rewrite coordinate_nil, Rabs_R0; lra.
  - exists (Rabs a + b); split; [pose proof (Rabs_pos a); lra |].
    intros [| i]; unfold coordinate in *; simpl; [lra |]. specialize (A i). pose proof (Rabs_pos a); lra.
Qed.

Lemma minimum_of_list {A} (f : A -> R) a l : In a l -> exists b, In b l /\ forall c, In c l -> f b <= f c.
Proof.
  revert a; induction l as [| x l IH]; intros a I; [destruct I |].
  destruct l as [| y l].
  - exists x; split; [left; reflexivity |]. intros c [<- | []]; lra.
  - destruct (IH y (or_introl eq_refl)) as [b [B M]].
    destruct (Rle_dec (f x) (f b)) as [Le | Gt].
    + exists x; split; [left; reflexivity |]. intros c [<- | C]; [lra |]. specialize (M c C); lra.
    + exists b; split; [right; assumption |]. intros c [<- | C]; [lra | exact (M c C)].
Qed.

(** * Combinations that leave out vertices *)

Lemma total_repeat c n : total (repeat c n) = INR n * c.
Proof. induction n as [| n IH]; [simpl; lra |]. rewrite S_INR; simpl; rewrite IH; lra. Qed.

Lemma weights_of_filter (test : vertex -> bool) (place : vertex -> vector) t w :
  length w = length t -> Forall (fun c => 0 <= c) w ->
  (forall i v, nth_error t i = Some v -> test v = false -> coordinate i w = 0) ->
  exists w', length w' = length (filter test t) /\ Forall (fun c => 0 <= c) w' /\ total w' = total w /\
    forall i, coordinate i (combination w' (map place (filter test t))) = coordinate i (combination w (map place t)).
Proof.
  revert w; induction t as [| v t IH]; intros [| c w] L W Z; try discriminate.
  - exists []; simpl; auto.
  - injection L as L. inversion W; subst.
    destruct (IH w L H2 (fun i v' => Z (S i) v')) as [w' [L' [W' [T' E']]]].
    simpl; destruct (test v) eqn:T.
    + exists (c :: w'); simpl; repeat split; auto; [lra |].
      intros i. rewrite !coordinate_plus, E'; reflexivity.
    + pose proof (Z 0%nat v eq_refl T) as C. unfold coordinate in C; simpl in C; subst c.
      exists w'; repeat split; auto; [lra |].
      intros i. rewrite coordinate_plus, coordinate_scale, E'; lra.
Qed.

(** * The weights of a vertex *)

Lemma nth_of_repeat (c : R) n i : (i < n)%nat -> nth i (repeat c n) 0 = c.
Proof.
  intros L. apply (repeat_spec n). apply nth_In. rewrite repeat_length; exact L.
Qed.

Definition unit_weights (n i : nat) : vector := map (fun j => if Nat.eqb j i then 1 else 0) (seq 0 n).

Lemma coordinate_unit_weights n i j :
  coordinate j (unit_weights n i) = if andb (Nat.ltb j n) (Nat.eqb j i) then 1 else 0.
Proof.
  unfold coordinate, unit_weights. destruct (Nat.ltb_spec j n) as [L | L]; simpl.
  - set (f := fun j => if Nat.eqb j i then 1 else 0).
    rewrite (nth_indep _ 0 (f 0%nat)) by (rewrite map_length, seq_length; exact L).
    rewrite map_nth, seq_nth by exact L; reflexivity.
  - apply nth_overflow. rewrite map_length, seq_length; exact L.
Qed.

Lemma dot_unit_weights n i l : (i < n)%nat -> dot (unit_weights n i) l = coordinate i l.
Proof.
  intros L. rewrite dot_commutes, (dot_one_term i).
  - rewrite coordinate_unit_weights, Nat.eqb_refl. destruct (Nat.ltb_spec i n); simpl; [lra | lia].
  - intros j D. rewrite coordinate_unit_weights. apply Nat.eqb_neq in D; rewrite D, andb_false_r; reflexivity.
Qed.

Lemma total_unit_weights n i : (i < n)%nat -> total (unit_weights n i) = 1.
Proof.
  intros L. assert (H : forall w, total w = dot w (repeat 1 (length w))).
  { induction w as [| c w IH]; simpl; [reflexivity |]. rewrite IH; lra. }
  rewrite H, dot_unit_weights by exact L. unfold unit_weights; rewrite map_length, seq_length.
  unfold coordinate; apply nth_of_repeat, L.
Qed.

Section Soundness.
Variable d : certificate.
Variable g : hints.
Hypothesis accepted : check d g = true.
Let m := dimension d.
Let metric := map real (gram d).

Lemma rules :
  (0 < period d)%Z /\ (0 < cells g)%Z /\ PositiveMap.is_empty (simplices d) = false /\ check_metric d g = true /\
  for_all_entries (points d) (check_point d g) = true /\ for_all_entries (simplices d) (check_simplex d g) = true /\
  for_all_entries (simplices d) (check_labels d) = true.
Proof.
  pose proof accepted as C. unfold check in C. repeat (apply andb_prop in C as [C ?]).
  repeat split; try assumption; try (apply Z.ltb_lt; assumption). apply negb_true_iff; assumption.
Qed.

Let period_positive : (0 < period d)%Z := proj1 rules.
Let cells_positive : (0 < cells g)%Z := proj1 (proj2 rules).
Let points_right := proj1 (proj2 (proj2 (proj2 (proj2 rules)))).
Let simplices_right := proj1 (proj2 (proj2 (proj2 (proj2 (proj2 rules))))).

(** * Lifted simplices with their hints *)

Record lifted := { base : simplex; its_hints : simplex_hints; shift : list Z }.

Definition is_right (e : lifted) : Prop :=
  (exists k, simplex_is_right d g k (base e) (its_hints e)) /\ length (shift e) = m.

Definition vertices_of (e : lifted) : simplex := move (shift e) (base e).
Definition coordinates (e : lifted) (x : vector) : vector :=
  barycentric (its_hints e) (minus x (translation d (shift e))).
Definition centre_of (e : lifted) : vector := plus (circumcentre (its_hints e)) (translation d (shift e)).
Definition square_radius_of (e : lifted) : R := square_circumradius d (base e) (its_hints e).
Definition power (e : lifted) (x : vector) : R := square_distance d x (centre_of e) - square_radius_of e.

Lemma lifted_simplex_is_right t : is_lifted_simplex d t -> exists e, is_right e /\ vertices_of e = t.
Proof.
  intros [k [s [u [F [L ->]]]]]. destruct (every_simplex_is_right d g simplices_right k s F) as [h R].
  exists {| base := s; its_hints := h; shift := u |}. split; [| reflexivity]. split; [exists k; exact R | exact L].
Qed.

Section Lifted.
Variable e : lifted.
Hypothesis right : is_right e.
Local Notation t := (vertices_of e).
Local Notation u := (shift e).

Lemma lifted_is_lifted : is_lifted_simplex d t.
Proof.
  destruct right as [[k R] L]. exists k, (base e), (shift e). split; [apply R |]. split; [exact L | reflexivity].
Qed.

Lemma lifted_length : length t = S m.
Proof. destruct right as [[k R] _]. unfold vertices_of, move; rewrite map_length. apply (parts d g k _ _ R). Qed.

Lemma lifts v : In v t -> is_lift d v.
Proof. apply (lifted_vertices d g simplices_right), lifted_is_lifted. Qed.

Lemma lift_length v : In v t -> length (place d v) = m.
Proof. intros I; apply (place_length d g points_right), lifts, I. Qed.

Lemma lifted_places : map (place d) t = map (fun y => plus y (translation d u)) (map (place d) (base e)).
Proof.
  destruct right as [[k R] L]. unfold vertices_of, move; rewrite !map_map. apply map_ext_in; intros v I.
  apply (place_moved d g points_right u v L). apply (vertex_lift d g k _ _ R v I).
Qed.

Lemma centre_length : length (centre_of e) = m.
Proof.
  destruct right as [[k R] L]. destruct (centre_right d g k _ _ R) as [_ [C _]].
  unfold centre_of; rewrite length_plus, C, (translation_length d _ L); apply Nat.max_id.
Qed.

Lemma minus_translation x : length x = m -> length (minus x (translation d u)) = m.
Proof.
  intros L; destruct right as [_ Lu]. rewrite length_minus, L, (translation_length d _ Lu); apply Nat.max_id.
Qed.

Lemma plus_minus_translation x : length x = m -> plus (minus x (translation d u)) (translation d u) = x.
Proof.
  intros L; destruct right as [_ Lu]. apply vector_equality.
  - rewrite length_plus, minus_translation, (translation_length d _ Lu), L by assumption; apply Nat.max_id.
  - intros i; rewrite coordinate_plus, coordinate_minus; lra.
Qed.

Lemma minus_plus_translation x : length x = m -> minus (plus x (translation d u)) (translation d u) = x.
Proof.
  intros L; destruct right as [_ Lu]. apply vector_equality.
  - rewrite length_minus, length_plus, (translation_length d _ Lu), L. rewrite !Nat.max_id; reflexivity.
  - intros i; rewrite coordinate_minus, coordinate_plus; lra.
Qed.

Lemma coordinates_length x : length (coordinates e x) = length t.
Proof.
  destruct right as [[k R] _]. unfold coordinates, t, vertices_of, move; rewrite map_length.
  apply (barycentric_length d g k _ _ R).
Qed.

Lemma base_combination w :
  length w = length t -> total w = 1 ->
  combination w (map (place d) t) = plus (combination w (map (place d) (base e))) (translation d u).
Proof.
  intros L T. destruct right as [[k R] Lu]. rewrite lifted_places. apply (combination_translate m); try assumption.
  - rewrite map_length, L. unfold vertices_of, move; apply map_length.
  - apply (some_vertex d g k _ _ R).
  - apply (vertices_length d g points_right k _ _ R).
  - apply translation_length, Lu.
Qed.

Lemma coordinates_spec x :
  length x = m -> total (coordinates e x) = 1 /\ combination (coordinates e x) (map (place d) t) = x.
Proof.
  intros L. pose proof (minus_translation x L) as L'. destruct right as [[k R] _].
  destruct (barycentric_spec d g k _ _ R _ L') as [T C].
  split; [exact T |]. rewrite base_combination; [| apply coordinates_length | exact T].
  unfold coordinates; rewrite C. apply plus_minus_translation, L.
Qed.

Lemma combination_length w : length w = length t -> length (combination w (map (place d) t)) = m.
Proof.
  intros L; apply length_combination.
  - rewrite map_length; exact L.
  - pose proof lifted_length as N. destruct (vertices_of e); simpl; discriminate.
  - intros y I; apply in_map_iff in I as [v [<- I]]; apply lift_length, I.
Qed.

Lemma coordinates_unique w :
  length w = length t -> total w = 1 -> coordinates e (combination w (map (place d) t)) = w.
Proof.
  intros L T. destruct right as [[k R] _].
  assert (Lb : length w = length (base e)) by (rewrite L; apply map_length).
  rewrite base_combination by assumption. unfold coordinates. rewrite minus_plus_translation.
  - exact (barycentric_unique d g k _ _ R w Lb T).
  - apply length_combination; [rewrite map_length; exact Lb | apply (some_vertex d g k _ _ R) |
      apply (vertices_length d g points_right k _ _ R)].
Qed.

Lemma power_of_vertex v : In v t -> power e (place d v) = 0.
Proof.
  destruct right as [[k R] L]. intros I. apply in_map_iff in I as [v' [<- I]].
  change (fst v', zplus (snd v') (shift e)) with (moved u v').
  rewrite (place_moved d g points_right u v' L (vertex_lift d g k _ _ R v' I)).
  unfold power, square_radius_of. rewrite <- (vertex_on_sphere d g points_right k _ _ R v' I).
  unfold square_distance, centre_of.
  assert (E : minus (plus (place d v') (translation d u)) (plus (circumcentre (its_hints e)) (translation d u)) =
              minus (place d v') (circumcentre (its_hints e))).
  { pose proof (place_length d g points_right v' (vertex_lift d g k _ _ R v' I)) as L1.
    destruct (centre_right d g k _ _ R) as [_ [L2 _]]. pose proof (translation_length d u L) as L3.
    apply vector_equality.
    - rewrite !length_minus, !length_plus. fold m in L1, L2, L3. unfold m in *. rewrite L1, L2, L3, !Nat.max_id; reflexivity.
    - intros i; rewrite !coordinate_minus, !coordinate_plus; lra. }
  rewrite E; lra.
Qed.

(** A lift in the hull is a vertex. *)
Lemma lift_in_hull v : is_lift d v -> in_hull d (place d v) t -> In v t.
Proof.
  intros V [w [L [W [T E]]]]. destruct right as [[k R] Lu]. destruct v as [j z].
  assert (V' : is_lift d (j, zplus z (zscale (-1) u))).
  { destruct V as [P Lz]; split; [exact P |]. simpl in *. rewrite length_zplus, length_zscale, Lz, Lu; apply Nat.max_id. }
  assert (B : (j, z) = moved u (j, zplus z (zscale (-1) u))).
  { unfold moved; simpl; f_equal. apply real_injective. destruct V as [_ Lz]; simpl in Lz.
    apply vector_equality.
    - rewrite !length_real, !length_zplus, length_zscale, Lz, Lu, !Nat.max_id; reflexivity.
    - intros i; rewrite !real_plus, real_scale, !coordinate_plus, coordinate_scale; lra. }
  rewrite B. change (In (moved u (j, zplus z (zscale (-1) u))) (map (moved u) (base e))). apply in_map.
  apply (lift_inside_is_vertex d g points_right period_positive cells_positive k _ _ R _ V').
  exists w; repeat split; auto.
  - rewrite L; apply map_length.
  - assert (Lb : length w = length (base e)) by (rewrite L; apply map_length).
    assert (Lc : length (combination w (map (place d) (base e))) = m).
    { apply length_combination; [rewrite map_length; exact Lb | apply (some_vertex d g k _ _ R) |
        apply (vertices_length d g points_right k _ _ R)]. }
    rewrite base_combination in E by assumption.
    rewrite <- (minus_plus_translation (combination w (map (place d) (base e)))) by exact Lc.
    rewrite <- E. rewrite B, (place_moved d g points_right u _ Lu V').
    rewrite minus_plus_translation; [reflexivity |]. apply (place_length d g points_right), V'.
Qed.
End Lifted.

(** * The walk *)

(** The difference of the powers of two balls is an affine function. *)
Lemma difference_of_balls c r c' r' :
  affine m (fun x => (square_distance d x c - r) - (square_distance d x c' - r')).
Proof.
  pose (a := fun c => plus (apply metric c) (combination c metric)).
  exists (quadratic metric c - r - (quadratic metric c' - r')), (plus (scale (-1) (a c)) (a c')).
  intros x _. unfold square_distance. fold metric. rewrite dot_plus_left, dot_scale_left, !quadratic_minus.
  unfold a; lra.
Qed.

Lemma value_at_combination f e w :
  is_right e -> affine m f -> length w = length (vertices_of e) -> total w = 1 ->
  f (combination w (map (place d) (vertices_of e))) = dot w (map f (map (place d) (vertices_of e))).
Proof.
  intros R A L T. apply (affine_value m); try assumption.
  - rewrite map_length; exact L.
  - pose proof (lifted_length e R) as N. destruct (vertices_of e); simpl; discriminate.
  - intros y I; apply in_map_iff in I as [v [<- I]]. apply (lift_length e R), I.
Qed.

(** Beyond a facet the ball of the neighbour there has a smaller power. *)
Lemma smaller_power e x i :
  is_right e -> length x = m -> coordinate i (coordinates e x) < 0 ->
  exists e', is_right e' /\ power e' x < power e x.
Proof.
  intros R Lx N. pose proof R as [[k Rk] Lu].
  assert (I : (i < length (base e))%nat).
  { destruct (Nat.lt_ge_cases i (length (base e))) as [I | I]; [exact I |].
    unfold coordinate in N. rewrite nth_overflow in N; [lra |].
    rewrite (coordinates_length e R). unfold vertices_of, move; rewrite map_length; exact I. }
  destruct (neighbour d g points_right simplices_right k _ _ i Rk I) as [t0 [w0 [T0 [V0 [W0 [B0 P0]]]]]].
  (* the neighbour, moved as e is *)
  assert (T1 : exists e', is_right e' /\ vertices_of e' = move (shift e) t0).
  { apply lifted_simplex_is_right. destruct T0 as [k' [s' [u' [F' [L' ->]]]]].
    exists k', s', (zplus u' (shift e)). repeat split; auto.
    - rewrite length_zplus, L', Lu; apply Nat.max_id.
    - unfold move; rewrite map_map; apply map_ext_in; intros v Iv; simpl; f_equal.
      destruct (every_simplex_is_right d g simplices_right k' s' F') as [h' R'].
      destruct (vertex_lift d g k' s' h' R' v Iv) as [_ Lv].
      apply real_injective, vector_equality.
      + rewrite !length_real, !length_zplus, Lv, L', Lu, !Nat.max_id; reflexivity.
      + intros q; rewrite !real_plus, !coordinate_plus; lra. }
  destruct T1 as [e' [R' E']]. exists e'; split; [exact R' |].
  pose (f := fun y => power e y - power e' y).
  assert (A : affine m f) by apply difference_of_balls.
  pose (l := map f (map (place d) (vertices_of e))).
  assert (Z : forall j, j <> i -> coordinate j l = 0).
  { intros j D. unfold coordinate, l. rewrite map_map.
    destruct (nth_error (vertices_of e) j) as [v |] eqn:J.
    - rewrite (nth_error_nth (map _ (vertices_of e)) j 0 (x := f (place d v))) by (rewrite nth_error_map, J; reflexivity).
      unfold f. rewrite (power_of_vertex e R v), (power_of_vertex e' R' v); [lra | | apply (nth_error_In _ j), J].
      rewrite E'. unfold vertices_of, move in J. rewrite nth_error_map in J.
      change (option_map (moved (shift e)) (@nth_error vertex (base e) j) = Some v) in J.
      destruct (nth_error (base e) j) as [v' |] eqn:J'; simpl in J; [injection J as <- | discriminate J].
      apply (in_map (moved (shift e))). exact (V0 j v' D J').
    - rewrite nth_overflow; [reflexivity |]. rewrite map_length; apply nth_error_None, J. }
  assert (F : forall y, length y = m -> f y = coordinate i (coordinates e y) * coordinate i l).
  { intros y Ly. destruct (coordinates_spec e R y Ly) as [Ty Cy].
    rewrite <- (dot_one_term i (coordinates e y) l Z). rewrite <- Cy at 1.
    apply value_at_combination; [exact R | exact A | apply (coordinates_length e R) | exact Ty]. }
  (* the vertex beyond the facet *)
  pose proof (lifted_vertices d g simplices_right t0 w0 T0 W0) as Lw.
  pose proof (moved_is_lift d (shift e) w0 Lu Lw) as Lw1.
  assert (M : minus (place d (moved (shift e) w0)) (translation d (shift e)) = place d w0).
  { rewrite (place_moved d g points_right _ _ Lu Lw). apply (minus_plus_translation e R).
    apply (place_length d g points_right), Lw. }
  assert (W : f (place d (moved (shift e) w0)) > 0).
  { unfold f. rewrite (power_of_vertex e' R').
    - unfold power, square_distance, centre_of, square_radius_of.
      assert (S : minus (place d (moved (shift e) w0)) (plus (circumcentre (its_hints e)) (translation d (shift e))) =
                  minus (place d w0) (circumcentre (its_hints e))).
      { rewrite <- M. apply vector_equality.
        - rewrite !length_minus, !length_plus. lia.
        - intros q; rewrite !coordinate_minus, coordinate_plus; lra. }
      rewrite S. unfold square_distance in P0. lra.
    - rewrite E'. exact (in_map (moved (shift e)) t0 w0 W0). }
  rewrite F in W by (apply (place_length d g points_right), Lw1).
  unfold coordinates in W at 1. rewrite M in W.
  assert (Neg : coordinate i l < 0) by nra.
  pose proof (F x Lx) as Fx. unfold f in Fx. nra.
Qed.

(** * The least power *)

Lemma finitely_many_below (pairs : list (simplex * simplex_hints)) x b :
  length x = m ->
  (forall s h, In (s, h) pairs -> exists k, simplex_is_right d g k s h) ->
  exists l, (forall e, In e l -> is_right e) /\
    forall e, In (base e, its_hints e) pairs -> length (shift e) = m -> power e x <= b -> In e l.
Proof.
  intros Lx. destruct (metric_is_bounded d g (proj1 (proj2 (proj2 (proj2 rules))))) as [least [Pos Least]].
  induction pairs as [| [s h] pairs IH]; intros P.
  - exists []; split; [intros e [] | intros e []].
  - destruct IH as [l [Rl Il]]; [intros; apply P; right; assumption |].
    destruct (P s h (or_introl eq_refl)) as [k R].
    destruct (coordinates_bounded x) as [bx [Px Bx]].
    destruct (coordinates_bounded (circumcentre h)) as [bc [Pc Bc]].
    pose (r := square_circumradius d s h). pose (q := Rmax 0 ((b + r) / least)).
    pose (z := up (bx + bc + 1 + q)).
    exists (map (fun u => {| base := s; its_hints := h; shift := u |}) (integer_box m z) ++ l). split.
    + intros e I; apply in_app_or in I as [I | I]; [| exact (Rl e I)].
      apply in_map_iff in I as [u [<- I]]. split; [exists k; exact R | exact (integer_box_length _ _ _ I)].
    + intros e [I | I] Lu B; apply in_or_app; [left | right; exact (Il e I Lu B)].
      destruct e as [s' h' u]; simpl in *. injection I as -> ->.
      apply in_map_iff; exists u; split; [reflexivity |]. apply in_integer_box; [exact Lu |]. intros i.
      apply le_IZR. rewrite abs_IZR. apply Rle_trans with (bx + bc + 1 + q).
      2: { pose proof (archimed (bx + bc + 1 + q)); unfold z; lra. }
      unfold power, square_distance, centre_of, square_radius_of in B; simpl in B. fold r in B.
      pose (c := plus (circumcentre h') (translation d u)). fold c in B.
      destruct (centre_right d g k _ _ R) as [_ [Lc _]].
      assert (L : length (minus x c) = m).
      { unfold c; rewrite length_minus, length_plus, Lx, Lc, (translation_length d u Lu), !Nat.max_id; reflexivity. }
      specialize (Least (minus x c) i L).
      assert (E : coordinate i (minus x c) = coordinate i x - coordinate i (circumcentre h') - IZR (period d) * IZR (nth i u 0%Z)).
      { unfold c, translation; rewrite coordinate_minus, coordinate_plus, real_scale, coordinate_scale, coordinate_real; lra. }
      set (y := coordinate i (minus x c)) in *.
      assert (Y : y * y <= q).
      { apply Rle_trans with ((b + r) / least); [| apply Rmax_r].
        apply (Rmult_le_reg_l least); [exact Pos |]. replace (least * ((b + r) / least)) with (b + r) by (field; lra).
        change (quadratic (map real (gram d)) (minus x c) - r <= b) in B. lra. }
      specialize (Bx i); specialize (Bc i).
      assert (N1 : 1 <= IZR (period d)) by (apply (IZR_le 1); lia).
      assert (Ay : Rabs y <= 1 + q) by (unfold Rabs; destruct (Rcase_abs y); nra).
      assert (Au : Rabs (IZR (nth i u 0%Z)) <= IZR (period d) * Rabs (IZR (nth i u 0%Z))).
      { pose proof (Rabs_pos (IZR (nth i u 0%Z))); nra. }
      rewrite <- (Rabs_pos_eq (IZR (period d))) in Au at 1 by lra. rewrite <- Rabs_mult in Au.
      replace (IZR (period d) * IZR (nth i u 0%Z)) with (coordinate i x + - coordinate i (circumcentre h') + - y) in Au by (rewrite E; lra).
      pose proof (Rabs_triang (coordinate i x + - coordinate i (circumcentre h')) (- y)).
      pose proof (Rabs_triang (coordinate i x) (- coordinate i (circumcentre h'))).
      rewrite !Rabs_Ropp in *. lra.
Qed.

Definition pairs : list (simplex * simplex_hints) :=
  flat_map (fun entry => match PositiveMap.find (fst entry) (of_simplices g) with
                         | Some h => [(snd entry, h)] | None => [] end) (PositiveMap.elements (simplices d)).

Lemma pairs_right s h : In (s, h) pairs <-> exists k, simplex_is_right d g k s h.
Proof.
  unfold pairs; rewrite in_flat_map; split.
  - intros [[k s'] [I J]]. simpl in J. destruct (PositiveMap.find k (of_simplices g)) as [h' |] eqn:H; [| destruct J].
    destruct J as [J | []]. injection J as E1 E2; subst s' h'. exists k.
    apply PositiveMap.elements_complete in I. repeat split; auto.
    exact (for_all_entries_find _ _ _ _ simplices_right I).
  - intros [k [F [H _]]]. exists (k, s). split; [apply PositiveMap.elements_correct, F |]. simpl; rewrite H; left; reflexivity.
Qed.

Lemma some_simplex : exists e, is_right e.
Proof.
  pose proof (proj1 (proj2 (proj2 rules))) as N.
  destruct (PositiveMap.elements (simplices d)) as [| [k s] l] eqn:E.
  - exfalso. assert (P : PositiveMap.Empty (simplices d)).
    { intros k s M. apply PositiveMap.elements_1 in M. rewrite E in M. inversion M. }
    apply PositiveMap.is_empty_1 in P. congruence.
  - assert (F : PositiveMap.find k (simplices d) = Some s).
    { apply PositiveMap.elements_complete; rewrite E; left; reflexivity. }
    destruct (every_simplex_is_right d g simplices_right k s F) as [h R].
    exists {| base := s; its_hints := h; shift := repeat 0%Z m |}. split; [exists k; exact R | apply repeat_length].
Qed.

Lemma least_power x : length x = m -> exists e, is_right e /\ forall e', is_right e' -> power e x <= power e' x.
Proof.
  intros L. destruct some_simplex as [e0 R0].
  destruct (finitely_many_below pairs x (power e0 x) L) as [l [Rl Il]]; [intros s h I; apply pairs_right, I |].
  assert (A : forall e, is_right e -> power e x <= power e0 x -> In e l).
  { intros e [P Lu]; apply Il; [apply pairs_right, P | exact Lu]. }
  destruct (minimum_of_list (fun e => power e x) e0 l) as [e [I M]]; [apply A; [exact R0 | lra] |].
  exists e; split; [exact (Rl e I) |]. intros e' R'.
  destruct (Rle_dec (power e' x) (power e0 x)) as [Le | Gt].
  - apply M, A; assumption.
  - specialize (M e0 (A e0 R0 (Rle_refl _))). simpl in M. lra.
Qed.

(** The simplex whose ball has the least power of x contains x. *)
Lemma least_power_contains e x :
  is_right e -> length x = m -> (forall e', is_right e' -> power e x <= power e' x) -> in_hull d x (vertices_of e).
Proof.
  intros R L M. destruct (coordinates_spec e R x L) as [T C]. exists (coordinates e x).
  split; [apply (coordinates_length e R) |]. split; [| split; [exact T | symmetry; exact C]].
  apply Forall_forall; intros c I. destruct (Rle_dec 0 c) as [P | P]; [exact P | exfalso].
  apply In_nth with (d := 0) in I as [i [_ E]].
  destruct (smaller_power e x i R L) as [e' [R' S]]; [unfold coordinate; rewrite E; lra |].
  specialize (M e' R'). lra.
Qed.

Lemma power_of_lift e v : is_right e -> is_lift d v -> 0 <= power e (place d v) /\ (power e (place d v) = 0 -> In v (vertices_of e)).
Proof.
  intros R V. pose proof (place_length d g points_right v V) as L.
  destruct (least_power _ L) as [e0 [R0 M]].
  pose proof (lift_in_hull e0 R0 v V (least_power_contains e0 _ R0 L M)) as I.
  pose proof (power_of_vertex e0 R0 v I) as Z. specialize (M e R) as Me. split; [lra |].
  intros Z'. apply (lift_in_hull e R v V). apply (least_power_contains e _ R L).
  intros e' R'. specialize (M e' R'). lra.
Qed.

(** * The theorems *)

Theorem barycentric_coordinates t x :
  is_lifted_simplex d t -> length x = dimension d ->
  exists w, (length w = length t /\ total w = 1 /\ x = combination w (map (place d) t)) /\
    forall w', length w' = length t -> total w' = 1 -> x = combination w' (map (place d) t) -> w' = w.
Proof.
  intros H L. destruct (lifted_simplex_is_right t H) as [e [R <-]].
  destruct (coordinates_spec e R x L) as [T C]. exists (coordinates e x). split.
  - split; [apply (coordinates_length e R) |]. split; [exact T | symmetry; exact C].
  - intros w' L' T' E. rewrite E. symmetry. apply (coordinates_unique e R); assumption.
Qed.

Theorem every_point_is_covered x :
  length x = dimension d -> exists t, is_lifted_simplex d t /\ in_hull d x t.
Proof.
  intros L. destruct (least_power x L) as [e [R M]]. exists (vertices_of e).
  split; [apply (lifted_is_lifted e R) | apply least_power_contains; assumption].
Qed.

Theorem simplices_have_empty_balls t :
  is_lifted_simplex d t ->
  exists c r, is_empty_ball_of d t c r /\
    forall q, is_lift d q -> ~ In q t -> r < square_distance d (place d q) c.
Proof.
  intros H. destruct (lifted_simplex_is_right t H) as [e [R <-]].
  exists (centre_of e), (square_radius_of e). repeat split.
  - apply (centre_length e R).
  - intros v I. pose proof (power_of_vertex e R v I) as P. unfold power in P. lra.
  - intros q Q. destruct (power_of_lift e q R Q) as [P _]. unfold power in P. lra.
  - intros q Q N. destruct (power_of_lift e q R Q) as [P Z]. unfold power in *.
    destruct (Req_dec (square_distance d (place d q) (centre_of e) - square_radius_of e) 0); [exfalso; auto | lra].
Qed.

Theorem simplices_meet_in_common_faces t t' x :
  is_lifted_simplex d t -> is_lifted_simplex d t' -> in_hull d x t -> in_hull d x t' ->
  in_hull d x (common_face t t').
Proof.
  intros H H' [w [L [W [T E]]]] [w' [L' [W' [T' E']]]].
  destruct (lifted_simplex_is_right t H) as [e [R <-]]. destruct (lifted_simplex_is_right t' H') as [e' [R' <-]].
  pose (f := fun y => power e' y - power e y).
  assert (A : affine m f) by apply difference_of_balls.
  pose proof (value_at_combination f e w R A L T) as F. pose proof (value_at_combination f e' w' R' A L' T') as F'.
  rewrite <- E in F. rewrite <- E' in F'.
  assert (P : Forall (fun y => 0 <= y) (map f (map (place d) (vertices_of e)))).
  { apply Forall_forall; intros y I. rewrite map_map in I. apply in_map_iff in I as [v [<- I]]. unfold f.
    rewrite (power_of_vertex e R v I). destruct (power_of_lift e' v R' (lifts e R v I)); lra. }
  assert (N : Forall (fun y => y <= 0) (map f (map (place d) (vertices_of e')))).
  { apply Forall_forall; intros y I. rewrite map_map in I. apply in_map_iff in I as [v [<- I]]. unfold f.
    rewrite (power_of_vertex e' R' v I). destruct (power_of_lift e v R (lifts e' R' v I)); lra. }
  assert (Z : dot w (map f (map (place d) (vertices_of e))) = 0).
  { pose proof (dot_nonnegative _ _ W P). pose proof (dot_nonpositive _ _ W' N). lra. }
  pose proof (dot_zero_terms _ _ W P Z) as D.
  destruct (weights_of_filter (fun v => is_vertex_of v (vertices_of e')) (place d) (vertices_of e) w L W) as [v [Lv [Wv [Tv Ev]]]].
  - intros i v I N'. specialize (D i). unfold coordinate in D at 2. rewrite map_map in D.
    rewrite (nth_error_nth (map _ (vertices_of e)) i 0 (x := f (place d v))) in D by (rewrite nth_error_map, I; reflexivity).
    assert (V : In v (vertices_of e)) by (apply (nth_error_In _ i), I).
    destruct (power_of_lift e' v R' (lifts e R v V)) as [P' Z'].
    assert (S : f (place d v) <> 0).
    { unfold f; rewrite (power_of_vertex e R v V). intros Q. assert (Q' : In v (vertices_of e')) by (apply Z'; lra).
      apply is_vertex_of_spec in Q'. congruence. }
    apply Rmult_integral in D as [D | D]; [exact D | contradiction].
  - exists v. unfold common_face. repeat split; auto; [lra |].
    rewrite E. apply vector_equality; [| intros i; symmetry; apply Ev].
    rewrite (combination_length e R w L). symmetry. apply length_combination.
    + rewrite map_length; exact Lv.
    + intros Q. apply map_eq_nil in Q. rewrite Q in Lv. destruct v; [simpl in Tv; lra | discriminate].
    + intros y I. apply in_map_iff in I as [q [<- I]]. apply filter_In in I as [I _]. apply (lift_length e R), I.
Qed.

Theorem empty_balls_are_those_of_simplices t c r :
  t <> [] -> (forall v, In v t -> is_lift d v) -> is_empty_ball_of d t c r ->
  exists t', is_lifted_simplex d t' /\ incl t t'.
Proof.
  intros NE V [Lc [On Empty]].
  pose (n := length t). pose (w := repeat (/ INR n) n).
  assert (Pn : 0 < INR n) by (apply lt_0_INR; unfold n; destruct t; [congruence | simpl; lia]).
  assert (Pw : 0 < / INR n) by (apply Rinv_0_lt_compat, Pn).
  assert (T : total w = 1) by (unfold w; rewrite total_repeat; field; lra).
  assert (L : length w = length (map (place d) t)) by (unfold w; rewrite map_length; apply repeat_length).
  assert (NE' : map (place d) t <> []) by (destruct t; [congruence | discriminate]).
  assert (A0 : forall y, In y (map (place d) t) -> length y = m).
  { intros y I; apply in_map_iff in I as [v [<- I]]. apply (place_length d g points_right), V, I. }
  pose (x := combination w (map (place d) t)).
  assert (Lx : length x = m) by (apply length_combination; assumption).
  destruct (least_power x Lx) as [e [R M]].
  pose proof (least_power_contains e x R Lx M) as [we [Le [We [Te Ee]]]].
  exists (vertices_of e); split; [apply (lifted_is_lifted e R) |].
  pose (f := fun y => power e y - (square_distance d y c - r)).
  assert (A : affine m f) by apply difference_of_balls.
  pose proof (affine_value m f w (map (place d) t) A L NE' A0 T) as F. fold x in F.
  pose proof (value_at_combination f e we R A Le Te) as Fe. rewrite <- Ee in Fe.
  assert (P : Forall (fun y => 0 <= y) (map f (map (place d) t))).
  { apply Forall_forall; intros y I. rewrite map_map in I. apply in_map_iff in I as [v [<- I]]. unfold f.
    rewrite (On v I). destruct (power_of_lift e v R (V v I)); lra. }
  assert (N : Forall (fun y => y <= 0) (map f (map (place d) (vertices_of e)))).
  { apply Forall_forall; intros y I. rewrite map_map in I. apply in_map_iff in I as [v [<- I]]. unfold f.
    rewrite (power_of_vertex e R v I). specialize (Empty v (lifts e R v I)). lra. }
  assert (W : Forall (fun y => 0 <= y) w).
  { apply Forall_forall; intros y I. apply repeat_spec in I. lra. }
  assert (Z : dot w (map f (map (place d) t)) = 0).
  { pose proof (dot_nonnegative _ _ W P). pose proof (dot_nonpositive _ _ We N). lra. }
  intros v I. apply In_nth_error in I as [i I].
  pose proof (dot_zero_terms _ _ W P Z i) as D. unfold coordinate in D. rewrite map_map in D.
  rewrite (nth_error_nth (map _ t) i 0 (x := f (place d v))) in D by (rewrite nth_error_map, I; reflexivity).
  assert (Bi : (i < n)%nat) by (apply nth_error_Some; congruence).
  unfold w in D. rewrite nth_of_repeat in D by exact Bi.
  apply (nth_error_In _ i) in I. unfold f in D. rewrite (On v I) in D.
  apply (power_of_lift e v R (V v I)). nra.
Qed.

Theorem lifts_have_different_places v v' :
  is_lift d v -> is_lift d v' -> place d v = place d v' -> v = v'.
Proof.
  intros V V' E. pose proof (place_length d g points_right v V) as L.
  destruct (least_power _ L) as [e [R M]].
  pose proof (least_power_contains e _ R L M) as H.
  pose proof (lift_in_hull e R v V H) as I.
  assert (I' : In v' (vertices_of e)) by (apply (lift_in_hull e R v' V'); rewrite <- E; exact H).
  apply In_nth_error in I as [i I]. apply In_nth_error in I' as [j J].
  destruct (Nat.eq_dec i j) as [-> | D]; [congruence | exfalso].
  pose (n := length (vertices_of e)).
  assert (H' : forall q u, nth_error (vertices_of e) q = Some u ->
            (q < n)%nat /\ combination (unit_weights n q) (map (place d) (vertices_of e)) = place d u).
  { intros q u Q. assert (B : (q < n)%nat) by (apply nth_error_Some; congruence). split; [exact B |].
    apply vector_equality.
    - rewrite (combination_length e R); [| unfold unit_weights; rewrite map_length; apply seq_length].
      symmetry; apply (lift_length e R). apply (nth_error_In _ q), Q.
    - intros p. rewrite coordinate_combination, dot_unit_weights by exact B.
      unfold coordinate at 1. rewrite map_map. apply nth_error_nth. rewrite nth_error_map, Q; reflexivity. }
  assert (Ln : forall q, length (unit_weights n q) = n) by (intros; unfold unit_weights; rewrite map_length; apply seq_length).
  destruct (H' i v I) as [Bi Ei]. destruct (H' j v' J) as [Bj Ej].
  pose proof (coordinates_unique e R _ (Ln i) (total_unit_weights n i Bi)) as Ui.
  pose proof (coordinates_unique e R _ (Ln j) (total_unit_weights n j Bj)) as Uj.
  rewrite Ei in Ui. rewrite Ej, <- E, Ui in Uj.
  apply (f_equal (coordinate i)) in Uj. rewrite !coordinate_unit_weights, Nat.eqb_refl in Uj.
  apply Nat.eqb_neq in D. rewrite D in Uj. apply Nat.ltb_lt in Bi. rewrite Bi in Uj. simpl in Uj. lra.
Qed.

End Soundness.

(** * Labels *)

Section Labels.
Variable d : certificate.
Hypothesis ordered : for_all_entries (simplices d) (check_labels d) = true.

Lemma before_is_transitive x y z : is_before x y = true -> is_before y z = true -> is_before x z = true.
Proof.
  revert y z; induction x as [| a x IH]; intros [| b y] [| c z] H K; try discriminate; auto.
  simpl in *. apply orb_prop in H as [H | H]; apply orb_prop in K as [K | K].
  - apply Pos.ltb_lt in H; apply Pos.ltb_lt in K. rewrite (proj2 (Pos.ltb_lt a c)) by lia; reflexivity.
  - apply andb_prop in K as [K _]. apply Pos.ltb_lt in H; apply Pos.eqb_eq in K.
    rewrite (proj2 (Pos.ltb_lt a c)) by lia; reflexivity.
  - apply andb_prop in H as [H _]. apply Pos.eqb_eq in H; apply Pos.ltb_lt in K.
    rewrite (proj2 (Pos.ltb_lt a c)) by lia; reflexivity.
  - apply andb_prop in H as [H H']; apply andb_prop in K as [K K'].
    apply Pos.eqb_eq in H; apply Pos.eqb_eq in K; subst b c.
    rewrite Pos.eqb_refl, (IH y z H' K'), orb_true_r; reflexivity.
Qed.

Lemma before_is_irreflexive x : is_before x x = false.
Proof. induction x as [| a x IH]; simpl; auto. rewrite Pos.ltb_irrefl, Pos.eqb_refl, IH; reflexivity. Qed.

Lemma smaller_places_are_before k k' s s' :
  (k < k')%positive -> PositiveMap.find k (simplices d) = Some s -> PositiveMap.find k' (simplices d) = Some s' ->
  is_before (map fst s) (map fst s') = true.
Proof.
  revert s'; induction k' as [| k' IH] using Pos.peano_ind; intros s' L F F'; [lia |].
  pose proof (for_all_entries_find _ _ _ _ ordered F') as C.
  apply andb_prop in C as [_ C]. apply orb_prop in C as [C | C]; [apply Pos.eqb_eq in C; lia |].
  rewrite Pos.pred_succ in C.
  destruct (PositiveMap.find k' (simplices d)) as [s0 |] eqn:F0; [| discriminate].
  destruct (Pos.eq_dec k k') as [-> | D].
  - replace s with s0 by congruence. exact C.
  - apply (before_is_transitive _ _ _ (IH s0 ltac:(lia) F eq_refl) C).
Qed.

Lemma increasing_head a x : increases (a :: x) = true -> forall b, In b x -> (a < b)%positive.
Proof.
  revert a; induction x as [| c x IH]; intros a H b I; [destruct I |].
  cbn [increases] in H; apply andb_prop in H as [H1 H2]. apply Pos.ltb_lt in H1.
  destruct I as [<- | I]; [exact H1 |]. specialize (IH c H2 b I); lia.
Qed.

Lemma increasing_tail a x : increases (a :: x) = true -> increases x = true.
Proof. destruct x; [reflexivity |]. intros H; cbn [increases] in H; apply andb_prop in H; apply H. Qed.

Lemma increasing_is_different x : increases x = true -> NoDup x.
Proof.
  induction x as [| a x IH]; intros H; constructor.
  - intros I. pose proof (increasing_head a x H a I). lia.
  - apply IH, (increasing_tail a), H.
Qed.

Lemma increasing_is_determined x y :
  increases x = true -> increases y = true -> (forall j, In j x <-> In j y) -> x = y.
Proof.
  revert y; induction x as [| a x IH]; intros [| b y] Hx Hy E; auto.
  - exfalso; apply (proj2 (E b)); left; reflexivity.
  - exfalso; apply (proj1 (E a)); left; reflexivity.
  - pose proof (increasing_head a x Hx) as Ax. pose proof (increasing_head b y Hy) as Ay.
    assert (a = b).
    { destruct (proj1 (E a) (or_introl eq_refl)) as [-> | I]; [reflexivity |].
      destruct (proj2 (E b) (or_introl eq_refl)) as [-> | J]; [reflexivity |].
      specialize (Ay a I); specialize (Ax b J); lia. }
    subst b; f_equal. apply IH; try (apply (increasing_tail a); assumption).
    intros j; split; intros I.
    + destruct (proj1 (E j) (or_intror I)) as [<- | J]; [specialize (Ax a I); lia | exact J].
    + destruct (proj2 (E j) (or_intror I)) as [<- | J]; [specialize (Ay a I); lia | exact J].
Qed.

Lemma labels_increase k s : PositiveMap.find k (simplices d) = Some s -> increases (map fst s) = true.
Proof. intros F; pose proof (for_all_entries_find _ _ _ _ ordered F) as C; apply andb_prop in C; apply C. Qed.

Theorem sets_of_labels_differ k k' s s' :
  PositiveMap.find k (simplices d) = Some s -> PositiveMap.find k' (simplices d) = Some s' ->
  (forall j, In j (map fst s) <-> In j (map fst s')) -> k = k'.
Proof.
  intros F F' E.
  assert (H : map fst s = map fst s').
  { apply increasing_is_determined; [apply (labels_increase k), F | apply (labels_increase k'), F' | exact E]. }
  destruct (Pos.lt_total k k') as [L | [L | L]]; [exfalso | exact L | exfalso].
  - pose proof (smaller_places_are_before k k' s s' L F F') as B. rewrite H, before_is_irreflexive in B; discriminate.
  - pose proof (smaller_places_are_before k' k s' s L F' F) as B. rewrite H, before_is_irreflexive in B; discriminate.
Qed.
End Labels.

(** What the program says is true. *)
Theorem accepted_certificates_are_delaunay d g : check d g = true -> is_delaunay_triangulation d.
Proof.
  intros A. pose proof (proj2 (proj2 (proj2 (proj2 (proj2 (proj2 (rules d g A))))))) as O. split.
  - intros k s F. apply increasing_is_different, (labels_increase d O k s F).
  - exact (sets_of_labels_differ d O).
  - exact (lifts_have_different_places d g A).
  - exact (barycentric_coordinates d g A).
  - exact (every_point_is_covered d g A).
  - exact (simplices_meet_in_common_faces d g A).
  - exact (simplices_have_empty_balls d g A).
  - exact (empty_balls_are_those_of_simplices d g A).
Qed.
