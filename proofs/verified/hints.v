(** What the hints of an accepted certificate show: barycentric coordinates, circumballs, neighbours. *)
From Coq Require Import Reals Bool List ZArith FMapPositive Lra Lia.
From Delcert Require Import vectors certificates tessellations.
Import ListNotations.
Open Scope R_scope.

(** * Equality and lists *)

Lemma equal_lists_sound {A} (equal : A -> A -> bool) :
  (forall a b, equal a b = true -> a = b) -> forall x y, equal_lists equal x y = true -> x = y.
Proof.
  intros S; induction x as [| a x IH]; intros [| b y] E; try discriminate; auto.
  simpl in E; apply andb_prop in E as [E1 E2]. f_equal; auto.
Qed.

Lemma equal_vectors_sound x y : equal_vectors x y = true -> x = y.
Proof. apply equal_lists_sound; intros a b E; apply Z.eqb_eq, E. Qed.

Lemma equal_matrices_sound x y : equal_matrices x y = true -> x = y.
Proof. apply equal_lists_sound, equal_vectors_sound. Qed.

Lemma equal_lists_refl {A} (equal : A -> A -> bool) :
  (forall a, equal a a = true) -> forall x, equal_lists equal x x = true.
Proof. intros S; induction x as [| a x IH]; simpl; auto. rewrite S, IH; reflexivity. Qed.

Lemma is_vertex_of_spec v t : is_vertex_of v t = true <-> In v t.
Proof.
  unfold is_vertex_of; rewrite existsb_exists; split.
  - intros [w [I E]]. apply andb_prop in E as [E1 E2].
    apply Pos.eqb_eq in E1; apply equal_vectors_sound in E2.
    destruct v, w; simpl in *; subst; assumption.
  - intros I; exists v; split; [assumption |]. unfold equal_vertices.
    rewrite Pos.eqb_refl; apply equal_lists_refl, Z.eqb_refl.
Qed.

Lemma for_all_entries_find {A} (m : PositiveMap.t A) f k a :
  for_all_entries m f = true -> PositiveMap.find k m = Some a -> f k a = true.
Proof.
  unfold for_all_entries; rewrite forallb_forall; intros H F.
  apply (H (k, a)), PositiveMap.elements_correct, F.
Qed.

Lemma for_all_below_spec n f : for_all_below n f = true -> forall i, (i < n)%nat -> f i = true.
Proof.
  induction n as [| n IH]; simpl; intros H i L; [lia |].
  apply andb_prop in H as [H1 H2]. destruct (Nat.eq_dec i n) as [-> | D]; [assumption | apply IH; [assumption | lia]].
Qed.

Lemma has_length_spec {A} n (x : list A) : has_length n x = true -> length x = n.
Proof. apply Nat.eqb_eq. Qed.

Lemma real_injective x y : real x = real y -> x = y.
Proof.
  revert y; induction x as [| a x IH]; intros [| b y] E; try discriminate; auto.
  injection E as E1 E2. apply eq_IZR in E1; f_equal; auto.
Qed.

Lemma length_scalar_matrix n c : length (scalar_matrix n c) = n.
Proof. induction n as [| n IH]; simpl; [| rewrite map_length, IH]; reflexivity. Qed.

(** * More about combinations *)

Lemma scale_plus c x y : scale c (plus x y) = plus (scale c x) (scale c y).
Proof. unfold scale; revert y; induction x as [| a x IH]; intros [| b y]; simpl; auto. rewrite IH; f_equal; lra. Qed.

Lemma scale_scale a b x : scale a (scale b x) = scale (a * b) x.
Proof. unfold scale; rewrite map_map; apply map_ext; intros; lra. Qed.

Lemma scale_one x : scale 1 x = x.
Proof. unfold scale; rewrite <- (map_id x) at 2; apply map_ext; intros; lra. Qed.

Lemma combination_scale c w ys : combination (scale c w) ys = scale c (combination w ys).
Proof.
  unfold scale at 1; revert ys; induction w as [| a w IH]; intros [| y ys]; simpl; auto.
  rewrite scale_plus, scale_scale, IH; reflexivity.
Qed.

Lemma coordinate_combination i w ys : coordinate i (combination w ys) = dot w (map (coordinate i) ys).
Proof.
  revert ys; induction w as [| a w IH]; intros [| y ys]; simpl; try apply coordinate_nil.
  rewrite coordinate_plus, coordinate_scale, IH; reflexivity.
Qed.

Lemma combination_translate m w ys a :
  length w = length ys -> ys <> [] -> (forall y, In y ys -> length y = m) -> length a = m -> total w = 1 ->
  combination w (map (fun y => plus y a) ys) = plus (combination w ys) a.
Proof.
  intros L NE A La T. apply vector_equality.
  - rewrite length_plus, (length_combination m w ys L NE A), La, (length_combination m); try lia.
    + rewrite map_length; assumption.
    + destruct ys; [congruence | discriminate].
    + intros y I; apply in_map_iff in I as [z [<- I]]. rewrite length_plus, La, (A z I); lia.
  - intros i. rewrite coordinate_plus, !coordinate_combination, map_map.
    assert (H : forall b, dot w (map (fun y => coordinate i (plus y b)) ys) =
                     dot w (map (coordinate i) ys) + total w * coordinate i b).
    { intros b; clear - L; revert ys L; induction w as [| c w IH]; intros [| y ys] L; try discriminate; simpl; try lra.
      injection L as L. rewrite IH, coordinate_plus by assumption; lra. }
    rewrite H, T; lra.
Qed.

Lemma dot_of_bounded_below b w l :
  length w = length l -> Forall (fun c => 0 <= c) w -> (forall y, In y l -> b <= y) -> b * total w <= dot w l.
Proof.
  revert l; induction w as [| c w IH]; intros [| y l] L W A; try discriminate; simpl; try lra.
  injection L as L. inversion W; subst.
  specialize (IH l L H2 (fun z I => A z (or_intror I))). specialize (A y (or_introl eq_refl)). nra.
Qed.

Lemma quadratic_scale g c x : quadratic g (scale c x) = c * c * quadratic g x.
Proof. unfold quadratic; rewrite dot_apply_scale, dot_scale_left; lra. Qed.

(** * The metric *)

Section Hints.
Variable d : certificate.
Variable g : hints.
Let m := dimension d.
Let metric := map real (gram d).

Definition metric_bound (least : R) : Prop :=
  0 < least /\ forall x i, length x = m -> least * (coordinate i x * coordinate i x) <= quadratic metric x.

Lemma metric_is_bounded : check_metric d g = true -> exists least, metric_bound least.
Proof.
  unfold check_metric; intros H; repeat (apply andb_prop in H as [H ?]).
  apply Z.ltb_lt, IZR_lt in H; rename H into He.
  match goal with K : (0 <? least_stretch g)%Z = true |- _ => apply Z.ltb_lt, IZR_lt in K; rename K into Hk end.
  match goal with K : equal_matrices _ _ = true |- _ => apply equal_matrices_sound in K; rename K into E end.
  match goal with K : forallb _ _ = true |- _ => rename K into P end.
  exists (IZR (least_stretch g) / IZR (gram_factor g)); split; [apply Rdiv_lt_0_compat; assumption |].
  intros x i L.
  assert (Q : IZR (gram_factor g) * quadratic metric x =
              IZR (least_stretch g) * dot x x +
              dot x (combination (map (fun a => dot (real a) x) (map snd (squares g)))
                       (map real (map (fun s => zscale (fst s) (snd s)) (squares g))))).
  { rewrite <- apply_sum_of_products, <- dot_scale_right, <- dot_plus_right, <- (apply_scalar_matrix m) by assumption.
    rewrite <- apply_mplus. unfold m; rewrite <- E. unfold quadratic, apply, zapply, metric.
    rewrite <- dot_scale_right; f_equal. unfold scale; rewrite !map_map; apply map_ext; intros r.
    rewrite real_scale, dot_scale_left; reflexivity. }
  assert (S : 0 <= dot x (combination (map (fun a => dot (real a) x) (map snd (squares g)))
                       (map real (map (fun s => zscale (fst s) (snd s)) (squares g))))).
  { rewrite dot_combination. clear - P. induction (squares g) as [| [c l] r IH]; simpl; [lra |].
    simpl in P; apply andb_prop in P as [P1 P2]. specialize (IH P2). apply Z.leb_le, IZR_le in P1.
    change (map (Z.mul c) l) with (zscale c l).
    change (map IZR (zscale c l)) with (real (zscale c l)).
    rewrite real_scale, dot_scale_right, (dot_commutes x (real l)).
    change (map IZR l) with (real l) in *.
    set (v := dot (real l) x) in *. unfold real in *. nra. }
  pose proof (dot_square_is_large x i) as B.
  apply (Rmult_le_reg_l (IZR (gram_factor g))); [assumption |].
  unfold Rdiv; rewrite Q. field_simplify; [| lra]. nra.
Qed.

(** * Places *)

Hypothesis points_right : for_all_entries (points d) (check_point d g) = true.
Hypothesis period_positive : (0 < period d)%Z.
Hypothesis cells_positive : (0 < cells g)%Z.

Lemma point_length k p : PositiveMap.find k (points d) = Some p -> length p = m.
Proof.
  intros F; pose proof (for_all_entries_find _ _ _ _ points_right F) as H.
  apply andb_prop in H as [H _]. apply has_length_spec, H.
Qed.

Lemma place_length v : is_lift d v -> length (place d v) = m.
Proof.
  intros [[p F] L]; unfold place, position; rewrite F, length_real, length_zplus, length_zscale, L, (point_length _ _ F).
  apply Nat.max_id.
Qed.

(** By how much a lattice vector moves. *)
Definition translation (u : list Z) : vector := real (zscale (period d) u).

Lemma translation_length u : length u = m -> length (translation u) = m.
Proof. intros L; unfold translation; rewrite length_real, length_zscale; assumption. Qed.

Definition moved (u : list Z) (v : vertex) : vertex := (fst v, zplus (snd v) u).

Lemma moved_is_lift u v : length u = m -> is_lift d v -> is_lift d (moved u v).
Proof. intros L [P Lv]; split; [exact P |]. simpl; rewrite length_zplus, Lv, L; apply Nat.max_id. Qed.

Lemma place_moved u v : length u = m -> is_lift d v -> place d (moved u v) = plus (place d v) (translation u).
Proof.
  intros L V; pose proof (moved_is_lift u v L V) as V'; apply vector_equality.
  - rewrite length_plus, translation_length, !place_length by assumption; symmetry; apply Nat.max_id.
  - intros i; destruct V as [[p F] Lv]. rewrite coordinate_plus.
    unfold place, position, moved, translation; simpl; rewrite F.
    rewrite !real_plus, !real_scale, !real_plus, !coordinate_plus, !coordinate_scale, !coordinate_plus; ring.
Qed.

(** * Simplices *)

Definition simplex_is_right (k : positive) (s : simplex) (h : simplex_hints) : Prop :=
  PositiveMap.find k (simplices d) = Some s /\ PositiveMap.find k (of_simplices g) = Some h /\
  check_simplex d g k s = true.

Section Simplex.
Variables (k : positive) (s : simplex) (h : simplex_hints).
Hypothesis right : simplex_is_right k s h.

Let vertices := map (position d) s.
Let square := square_radius d h vertices.

Lemma parts :
  length s = S m /\ (forall v, In v s -> is_lift d v) /\ check_forms d h vertices = true /\
  check_centre d h vertices square = true /\
  (forall i, (i < length s)%nat -> check_neighbour d h s square i = true) /\
  check_inside d g h s vertices = true.
Proof.
  destruct right as [_ [F C]]. unfold check_simplex in C; rewrite F in C; cbv zeta in C.
  fold vertices in C; fold square in C.
  repeat (apply andb_prop in C as [C ?]).
  split; [apply has_length_spec; assumption |].
  split; [| repeat split; try assumption; apply for_all_below_spec; assumption].
  intros v I. match goal with K : forallb _ s = true |- _ => rewrite forallb_forall in K; specialize (K v I); rename K into V end.
  apply andb_prop in V as [V1 V2]. split; [| apply has_length_spec, V1].
  unfold PositiveMap.mem in V2.
  apply PositiveMap.mem_2 in V2. destruct V2 as [p V2]. exists p; exact V2.
Qed.

Lemma vertex_lift v : In v s -> is_lift d v.
Proof. apply parts. Qed.

Lemma places : map (place d) s = map real vertices.
Proof. unfold vertices, place; rewrite map_map; reflexivity. Qed.

Lemma vertices_length y : In y (map (place d) s) -> length y = m.
Proof. intros I; apply in_map_iff in I as [v [<- I]]. apply place_length, vertex_lift, I. Qed.

Lemma some_vertex : map (place d) s <> [].
Proof. destruct parts as [L _]; destruct s; [discriminate | discriminate]. Qed.

(** ** Barycentric coordinates *)

Definition barycentric (x : vector) : vector :=
  map (fun form => dot (real form) (1 :: x) / IZR (volume h)) (forms h).

Lemma forms_right :
  0 < IZR (volume h) /\
  sum_of_products (map (cons 1%Z) vertices) (forms h) = scalar_matrix (S m) (volume h) /\
  map (fun form => map (form_at form) vertices) (forms h) = scalar_matrix (S m) (volume h).
Proof.
  destruct parts as [_ [_ [F _]]]. unfold check_forms in F; cbv zeta in F.
  apply andb_prop in F as [F F3]; apply andb_prop in F as [F1 F2].
  split; [apply IZR_lt, Z.ltb_lt, F1 |]. split; apply equal_matrices_sound; assumption.
Qed.

Lemma barycentric_length x : length (barycentric x) = length s.
Proof.
  destruct forms_right as [_ [_ E]]. destruct parts as [L _]. unfold barycentric; rewrite map_length.
  apply (f_equal (@length _)) in E. rewrite map_length, length_scalar_matrix in E. congruence.
Qed.

Lemma barycentric_scaled x :
  barycentric x = scale (/ IZR (volume h)) (map (fun form => dot (real form) (1 :: x)) (forms h)).
Proof. unfold barycentric, scale; rewrite map_map; apply map_ext; intros; unfold Rdiv; apply Rmult_comm. Qed.

Lemma homogeneous_places : map real (map (cons 1%Z) vertices) = map (cons 1) (map (place d) s).
Proof. rewrite places, !map_map; apply map_ext; reflexivity. Qed.

Lemma barycentric_spec x :
  length x = m -> total (barycentric x) = 1 /\ combination (barycentric x) (map (place d) s) = x.
Proof.
  intros L. destruct forms_right as [V [E _]].
  pose proof (resolution (S m) _ _ _ (1 :: x) E (f_equal S L)) as R.
  apply (f_equal (scale (/ IZR (volume h)))) in R.
  rewrite <- combination_scale, <- barycentric_scaled, scale_scale, Rinv_l, scale_one, homogeneous_places in R by lra.
  rewrite combination_cons in R.
  - injection R as R1 R2; split; assumption.
  - rewrite barycentric_length, map_length; reflexivity.
  - intros N; pose proof (barycentric_length x) as B; rewrite N in B. destruct parts as [Ls _]; rewrite Ls in B; discriminate.
Qed.

Lemma barycentric_unique w :
  length w = length s -> total w = 1 -> barycentric (combination w (map (place d) s)) = w.
Proof.
  intros L T. destruct forms_right as [V [_ E]]. destruct parts as [Ls _].
  assert (NE : w <> []) by (intros ->; rewrite Ls in L; discriminate).
  assert (B : map (fun form => dot (real form) (1 :: combination w (map (place d) s))) (forms h) = scale (IZR (volume h)) w).
  { rewrite <- (apply_scalar_matrix (S m)) by congruence.
    rewrite <- E. unfold zapply; rewrite map_map; apply map_ext; intros form.
    rewrite (dot_commutes _ w), <- T, <- combination_cons; [| rewrite map_length; assumption | assumption].
    rewrite dot_combination, places; f_equal. unfold real; rewrite !map_map; apply map_ext; intros v.
    unfold form_at; rewrite real_dot; reflexivity. }
  rewrite barycentric_scaled, B, scale_scale, Rinv_l, scale_one by lra; reflexivity.
Qed.

(** The sign of a form is that of the barycentric coordinate. *)
Lemma form_sign i form x :
  nth_error (forms h) i = Some form -> (form_at form x < 0)%Z -> coordinate i (barycentric (real x)) < 0.
Proof.
  intros F N. destruct forms_right as [V _]. unfold coordinate, barycentric.
  rewrite (nth_error_nth (map _ (forms h)) i 0 (x := dot (real form) (1 :: real x) / IZR (volume h)))
    by (rewrite nth_error_map, F; reflexivity).
  apply IZR_lt in N. unfold form_at in N; rewrite real_dot in N. change (real (1%Z :: x)) with (1 :: real x) in N.
  apply Rmult_lt_reg_r with (IZR (volume h)); [assumption |]. unfold Rdiv; rewrite Rmult_assoc, Rinv_l by lra. lra.
Qed.

(** ** The circumball *)

Definition circumcentre : vector := scale (/ IZR (centre_denominator h)) (real (centre h)).
Definition square_circumradius : R := IZR square / (IZR (centre_denominator h) * IZR (centre_denominator h)).

Lemma centre_right :
  0 < IZR (centre_denominator h) /\ length circumcentre = m /\
  (forall v, In v s -> square_from_centre d h (position d v) = square).
Proof.
  destruct parts as [_ [_ [_ [C _]]]]. unfold check_centre in C.
  apply andb_prop in C as [C C3]; apply andb_prop in C as [C1 C2].
  split; [apply IZR_lt, Z.ltb_lt, C1 |]. split.
  - unfold circumcentre; rewrite length_scale, length_real. apply has_length_spec, C2.
  - intros v I. rewrite forallb_forall in C3. apply Z.eqb_eq, C3. apply in_map, I.
Qed.

Lemma square_distance_from_centre x :
  length x = m ->
  square_distance d (real x) circumcentre =
  IZR (square_from_centre d h x) / (IZR (centre_denominator h) * IZR (centre_denominator h)).
Proof.
  intros L. destruct centre_right as [E [Lc _]]. unfold square_from_centre; rewrite real_quadratic.
  replace (real (from_centre h x)) with (scale (IZR (centre_denominator h)) (minus (real x) circumcentre)).
  - rewrite quadratic_scale. unfold square_distance. field. lra.
  - unfold from_centre, minus, circumcentre. rewrite real_plus, !real_scale, scale_plus, !scale_scale.
    f_equal. f_equal. field. lra.
Qed.

Lemma vertex_on_sphere v : In v s -> square_distance d (place d v) circumcentre = square_circumradius.
Proof.
  intros I. unfold place; rewrite square_distance_from_centre.
  - unfold square_circumradius; destruct centre_right as [_ [_ C]]; rewrite C by assumption; reflexivity.
  - rewrite <- length_real; apply place_length, vertex_lift, I.
Qed.

Lemma outside_of_sphere x :
  length x = m -> (square < square_from_centre d h x)%Z -> square_circumradius < square_distance d (real x) circumcentre.
Proof.
  intros L Q. rewrite square_distance_from_centre by assumption. unfold square_circumradius.
  destruct centre_right as [E _]. apply IZR_lt in Q.
  apply Rmult_lt_compat_r; [apply Rinv_0_lt_compat; nra | assumption].
Qed.

(** ** No other point is inside *)

Lemma cell_key_moved c z : length z = length c -> cell_key g (zplus c (zscale (cells g) z)) = cell_key g c.
Proof.
  intros L; unfold cell_key; do 2 f_equal.
  assert (H : forall k, fold_left (fun k r => k * cells g + r mod cells g)%Z (zplus c (zscale (cells g) z)) k =
                   fold_left (fun k r => k * cells g + r mod cells g)%Z c k); [| apply H].
  revert z L; induction c as [| a c IH]; intros [| b z] L k'; try discriminate; auto.
  injection L as L; simpl. rewrite (Z.mul_comm (cells g) b), Z_mod_plus_full. exact (IH z L _).
Qed.

Lemma cell_of_moved p z :
  length z = length p ->
  cell_of d g (zplus p (zscale (period d) z)) = zplus (cell_of d g p) (zscale (cells g) z).
Proof.
  revert z; induction p as [| a p IH]; intros [| b z] L; try discriminate; auto.
  injection L as L; simpl; f_equal; [| exact (IH z L)].
  replace (cells g * (a + period d * b))%Z with (cells g * a + (cells g * b) * period d)%Z by ring.
  rewrite Z.div_add by lia. reflexivity.
Qed.

Lemma cell_difference c z :
  length z = length c ->
  map (fun a => a / cells g)%Z (zplus (zplus c (zscale (cells g) z)) (zscale (-1) c)) = z.
Proof.
  revert z; induction c as [| a c IH]; intros [| b z] L; try discriminate; auto.
  injection L as L; cbn [zscale map zplus]; f_equal; [| exact (IH z L)].
  replace (a + cells g * b + -1 * a)%Z with (b * cells g)%Z by ring. apply Z.div_mul; lia.
Qed.

Lemma at_most_spec x y :
  at_most x y = true <-> length x = length y /\ forall i, (nth i x 0 <= nth i y 0)%Z.
Proof.
  revert y; induction x as [| a x IH]; intros [| b y]; simpl; split; intros H; try discriminate; try (destruct H; discriminate); auto.
  - split; [reflexivity |]. intros [| i]; reflexivity.
  - apply andb_prop in H as [H1 H2]. apply IH in H2 as [L A]. split; [congruence |].
    intros [| i]; [apply Z.leb_le, H1 | apply A].
  - destruct H as [L A]. rewrite (proj2 (Z.leb_le a b) (A 0%nat)); simpl. apply IH. split; [congruence |].
    intros i; exact (A (S i)).
Qed.

Lemma cell_of_monotone x y : at_most x y = true -> at_most (cell_of d g x) (cell_of d g y) = true.
Proof.
  revert y; induction x as [| a x IH]; intros [| b y] H; try discriminate; auto.
  simpl in *; apply andb_prop in H as [H1 H2]. rewrite (IH y H2), andb_true_r.
  apply Z.leb_le. apply Z.leb_le in H1. apply Z.div_le_mono; [assumption |]. apply Z.mul_le_mono_nonneg_l; lia.
Qed.

Lemma for_all_from_spec f n from c :
  for_all_from n from f = true -> (from <= c < from + Z.of_nat n)%Z -> f c = true.
Proof.
  revert from; induction n as [| n IH]; intros from H B; [lia |].
  simpl in H; apply andb_prop in H as [H1 H2].
  destruct (Z.eq_dec c from) as [-> | D]; [assumption |]. apply (IH (from + 1)%Z H2). lia.
Qed.

Lemma for_all_cells_spec f low high c :
  for_all_cells low high f = true -> at_most low c = true -> at_most c high = true -> f c = true.
Proof.
  revert f high c; induction low as [| a low IH]; intros f [| b high] [| e c] H A B; try discriminate; auto.
  simpl in *; apply andb_prop in A as [A1 A2]; apply andb_prop in B as [B1 B2].
  apply Z.leb_le in A1; apply Z.leb_le in B1.
  apply (for_all_from_spec _ _ _ e) in H; [| lia].
  exact (IH _ _ _ H A2 B2).
Qed.

Lemma coordinate_real i x : coordinate i (real x) = IZR (nth i x 0%Z).
Proof. unfold coordinate, real; change 0 with (IZR 0); apply map_nth. Qed.

(** A lift in the hull of s lies in the box. *)
Lemma in_the_box x :
  length x = m -> in_hull d (real x) s -> at_most (lowest h) x = true /\ at_most x (highest h) = true.
Proof.
  intros Lx [w [L [W [T E]]]]. destruct parts as [Ls [_ [_ [_ [_ C]]]]].
  unfold check_inside in C; apply andb_prop in C as [C _]. rewrite forallb_forall in C.
  assert (B : forall y, In y (map (place d) s) -> exists v, y = real v /\ at_most (lowest h) v = true /\ at_most v (highest h) = true).
  { rewrite places; intros y I; apply in_map_iff in I as [v [<- I]]. exists v; split; [reflexivity |].
    specialize (C v I). apply andb_prop in C; assumption. }
  assert (M : exists v, length v = m /\ at_most (lowest h) v = true /\ at_most v (highest h) = true).
  { pose proof some_vertex as NE. destruct (map (place d) s) as [| y ys] eqn:EY; [congruence |].
    destruct (B y (or_introl eq_refl)) as [v [-> A]]. exists v; split; [| assumption].
    rewrite <- (length_real v). apply vertices_length; rewrite EY; left; reflexivity. }
  destruct M as [v0 [Lv0 [A0 B0]]]. apply at_most_spec in A0 as [A0 _]. apply at_most_spec in B0 as [B0 _].
  assert (Lw : length w = length (map (place d) s)) by (rewrite map_length; assumption).
  split; apply at_most_spec; (split; [congruence |]); intros i; apply le_IZR; rewrite <- (coordinate_real i x), E, coordinate_combination.
  - apply Rle_trans with (IZR (nth i (lowest h) 0%Z) * total w); [rewrite T; lra |].
    apply dot_of_bounded_below; [rewrite map_length; assumption | assumption |].
    intros y I; apply in_map_iff in I as [z [<- I]]. destruct (B z I) as [v [-> [A _]]].
    rewrite coordinate_real. apply IZR_le. apply at_most_spec in A; apply A.
  - apply Ropp_le_cancel.
    apply Rle_trans with (- IZR (nth i (highest h) 0%Z) * total w); [rewrite T; lra |].
    replace (- dot w (map (coordinate i) (map (place d) s))) with
      (dot w (scale (-1) (map (coordinate i) (map (place d) s)))) by (rewrite dot_scale_right; lra).
    apply dot_of_bounded_below; [rewrite length_scale, map_length; assumption | assumption |].
    intros y I. unfold scale in I. rewrite map_map in I. apply in_map_iff in I as [z [<- I]]. destruct (B z I) as [v [-> [_ A]]].
    rewrite coordinate_real. assert (IZR (nth i v 0%Z) <= IZR (nth i (highest h) 0%Z)); [| lra].
    apply IZR_le. apply at_most_spec in A; apply A.
Qed.

Lemma lift_inside_is_vertex v : is_lift d v -> in_hull d (place d v) s -> In v s.
Proof.
  intros V H. pose proof V as [[p F] Lv]. destruct v as [j z]; simpl in *.
  pose proof (point_length _ _ F) as Lp.
  assert (Lz : length z = length p) by (rewrite Lp; exact Lv).
  pose proof (place_length _ V) as Lx. unfold place in Lx; rewrite length_real in Lx.
  destruct (in_the_box _ Lx H) as [A B].
  destruct parts as [Ls [_ [_ [_ [_ C]]]]]. unfold check_inside in C; apply andb_prop in C as [_ C].
  apply (for_all_cells_spec _ _ _ (cell_of d g (position d (j, z)))) in C; try (apply cell_of_monotone; assumption).
  rewrite forallb_forall in C.
  assert (P : position d (j, z) = zplus p (zscale (period d) z)) by (unfold position; simpl; rewrite F; reflexivity).
  assert (I : In j (labels_in g (cell_of d g (position d (j, z))))).
  { pose proof (for_all_entries_find _ _ _ _ points_right F) as Q. apply andb_prop in Q as [_ Q].
    apply existsb_exists in Q as [j' [Q J]]. apply Pos.eqb_eq in J; subst j'.
    unfold labels_in in *. rewrite P, cell_of_moved, cell_key_moved; [exact Q | |].
    - unfold cell_of; rewrite map_length; exact Lz.
    - exact Lz. }
  specialize (C j I). unfold check_lift in C; rewrite F in C; cbv zeta in C.
  rewrite P, cell_of_moved, cell_difference in C; try (unfold cell_of; rewrite ?map_length; exact Lz).
  apply orb_prop in C as [C | C]; [apply is_vertex_of_spec, C |]. exfalso.
  apply existsb_exists in C as [form [C N]]. apply Z.ltb_lt in N.
  apply In_nth_error in C as [i C]. apply (form_sign i form _ C) in N. fold (place d (j, z)) in N.
  destruct H as [w [L [W [T E]]]]. rewrite E, barycentric_unique in N by assumption.
  rewrite Forall_forall in W. unfold coordinate in N.
  destruct (Nat.lt_ge_cases i (length w)) as [I' | I'].
  - specialize (W _ (nth_In w 0 I')). lra.
  - rewrite nth_overflow in N by assumption. lra.
Qed.

End Simplex.

(** * All simplices *)

Hypothesis simplices_right : for_all_entries (simplices d) (check_simplex d g) = true.

Lemma every_simplex_is_right k s : PositiveMap.find k (simplices d) = Some s -> exists h, simplex_is_right k s h.
Proof.
  intros F. pose proof (for_all_entries_find _ _ _ _ simplices_right F) as C.
  pose proof C as C'. unfold check_simplex in C'.
  destruct (PositiveMap.find k (of_simplices g)) as [h |] eqn:H; [| discriminate].
  exists h; repeat split; assumption.
Qed.

Lemma lifted_vertices t v : is_lifted_simplex d t -> In v t -> is_lift d v.
Proof.
  intros [k [s [u [F [L ->]]]]] I. apply in_map_iff in I as [v' [<- I]].
  destruct (every_simplex_is_right k s F) as [h R]. apply (moved_is_lift u v' L). exact (vertex_lift k s h R v' I).
Qed.

Lemma neighbour k s h i :
  simplex_is_right k s h -> (i < length s)%nat ->
  exists t w, is_lifted_simplex d t /\
    (forall j v, j <> i -> nth_error s j = Some v -> In v t) /\
    In w t /\ coordinate i (barycentric h (place d w)) < 0 /\
    square_circumradius s h < square_distance d (place d w) (circumcentre h).
Proof.
  intros R I. destruct (parts k s h R) as [_ [_ [_ [_ [N _]]]]]. specialize (N i I). unfold check_neighbour in N.
  destruct (nth_error (neighbours h) i) as [[k' u] |] eqn:E1; [| discriminate].
  destruct (nth_error (forms h) i) as [form |] eqn:E2; [| discriminate].
  destruct (PositiveMap.find k' (simplices d)) as [base |] eqn:E3; [| discriminate].
  cbv zeta in N. apply andb_prop in N as [N N3]; apply andb_prop in N as [N1 N2].
  apply has_length_spec in N1. apply existsb_exists in N3 as [w [W N3]].
  apply andb_prop in N3 as [N3 N4]. apply Z.ltb_lt in N3; apply Z.ltb_lt in N4.
  assert (T : is_lifted_simplex d (move u base)) by (exists k', base, u; auto).
  exists (move u base), w; repeat split; auto.
  - intros j v D J. assert (B : (j < length s)%nat) by (apply nth_error_Some; congruence).
    pose proof (for_all_below_spec _ _ N2 j B) as Q. cbv beta in Q; rewrite J in Q. apply orb_prop in Q as [Q | Q].
    + apply Nat.eqb_eq in Q; contradiction.
    + apply is_vertex_of_spec, Q.
  - exact (form_sign k s h R i form _ E2 N3).
  - apply (outside_of_sphere k s h R); [| assumption].
    pose proof (place_length w (lifted_vertices _ w T W)) as L. unfold place in L; rewrite length_real in L; exact L.
Qed.

End Hints.
