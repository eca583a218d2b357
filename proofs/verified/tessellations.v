(** What certificates stand for: lifted points and simplices in ℝᵐ. *)
From Coq Require Import Reals List ZArith FMapPositive.
From Delcert Require Import vectors certificates.
Import ListNotations.
Open Scope R_scope.

Section Tessellations.
Variable d : certificate.

(** A lift: a label of the list, moved by a lattice vector. *)
Definition is_lift (v : vertex) : Prop :=
  (exists p, PositiveMap.find (fst v) (points d) = Some p) /\ length (snd v) = dimension d.

(** Where it is in ℝᵐ. *)
Definition place (v : vertex) : vector := real (position d v).

(** t is a simplex of the list, moved by a lattice vector. *)
Definition is_lifted_simplex (t : simplex) : Prop :=
  exists k s u, PositiveMap.find k (simplices d) = Some s /\ length u = dimension d /\ t = move u s.

(** x is a combination of the vertices of t with weights ≥ 0 of sum 1. *)
Definition in_hull (x : vector) (t : simplex) : Prop :=
  exists w, length w = length t /\ Forall (fun c => 0 <= c) w /\ total w = 1 /\ x = combination w (map place t).

(** The vertices of t that are vertices of t', too. *)
Definition common_face (t t' : simplex) : simplex := filter (fun v => is_vertex_of v t') t.

(** The square of the distance, in the metric of the certificate. *)
Definition square_distance (x y : vector) : R := quadratic (map real (gram d)) (minus x y).

(** All points of the finite set t are on the sphere about c, and no lift is inside. *)
Definition is_empty_ball_of (t : list vertex) (c : vector) (r : R) : Prop :=
  length c = dimension d /\
  (forall v, In v t -> square_distance (place v) c = r) /\
  (forall q, is_lift q -> r <= square_distance (place q) c).

(** The lifted simplices are the Delaunay triangulation of the lifts, in the metric of the certificate. *)
Record is_delaunay_triangulation : Prop := {
  labels_are_different : forall k s, PositiveMap.find k (simplices d) = Some s -> NoDup (map fst s);
  label_sets_are_different : forall k k' s s', PositiveMap.find k (simplices d) = Some s ->
    PositiveMap.find k' (simplices d) = Some s' -> (forall j, In j (map fst s) <-> In j (map fst s')) -> k = k';
  lifts_are_points : forall v v', is_lift v -> is_lift v' -> place v = place v' -> v = v';
  simplices_are_independent : forall t x, is_lifted_simplex t -> length x = dimension d ->
    exists w, (length w = length t /\ total w = 1 /\ x = combination w (map place t)) /\
      forall w', length w' = length t -> total w' = 1 -> x = combination w' (map place t) -> w' = w;
  simplices_cover : forall x, length x = dimension d -> exists t, is_lifted_simplex t /\ in_hull x t;
  simplices_meet_in_faces : forall t t' x, is_lifted_simplex t -> is_lifted_simplex t' ->
    in_hull x t -> in_hull x t' -> in_hull x (common_face t t');
  balls_are_empty : forall t, is_lifted_simplex t ->
    exists c r, is_empty_ball_of t c r /\ forall q, is_lift q -> ~ In q t -> r < square_distance (place q) c;
  no_other_ball_is_empty : forall t c r, t <> [] -> (forall v, In v t -> is_lift v) -> is_empty_ball_of t c r ->
    exists t', is_lifted_simplex t' /\ incl t t'
}.
End Tessellations.
