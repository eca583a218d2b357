(** Certificates of triangulations of flat tori, and the function that decides them. All numbers are integers.
    Coordinates are those of a basis of the lattice in units of 1/period: the lattice is period·ℤᵐ. *)
From Coq Require Import Bool List ZArith FMapPositive.
From Delcert Require Import vectors.
Import ListNotations.
Open Scope Z_scope.

(** A vertex of the lifted complex: a label and the lattice vector, in units of the period, that moves its point. *)
Definition vertex := (positive * list Z)%type.
Definition simplex := list vertex.

Record certificate := {
  dimension : nat;
  period : Z;
  gram : list (list Z);  (** xᵀGx is the square of the length of x, up to a factor *)
  points : PositiveMap.t (list Z);
  simplices : PositiveMap.t simplex
}.

(** What is found in another way and verified here. The theorems do not speak of it. *)
Record simplex_hints := {
  volume : Z;                             (** a common denominator of the barycentric coordinates *)
  forms : list (list Z);                  (** their numerators: for each vertex the constant and m coefficients *)
  centre_denominator : Z;
  centre : list Z;                        (** of the circumball *)
  neighbours : list (positive * list Z);  (** beyond each facet: a simplex of the list, and how it is moved *)
  lowest : list Z;                        (** a box around the simplex *)
  highest : list Z
}.

Record hints := {
  gram_factor : Z;
  least_stretch : Z;
  squares : list (Z * list Z);  (** factor·xᵀGx = stretch·x·x + the sum of the c (l·x)² *)
  cells : Z;                    (** into how many cells of a grid the period is cut *)
  in_cells : PositiveMap.t (list positive);  (** the labels of each cell, modulo the lattice *)
  of_simplices : PositiveMap.t simplex_hints
}.

(** * Equality *)

Fixpoint equal_lists {A} (equal : A -> A -> bool) (x y : list A) : bool :=
  match x, y with
  | [], [] => true
  | a :: x', b :: y' => equal a b && equal_lists equal x' y'
  | _, _ => false
  end.

Definition equal_vectors := equal_lists Z.eqb.
Definition equal_matrices := equal_lists equal_vectors.
Definition equal_vertices (v w : vertex) : bool := Pos.eqb (fst v) (fst w) && equal_vectors (snd v) (snd w).
Definition is_vertex_of (v : vertex) (t : simplex) : bool := existsb (equal_vertices v) t.

Definition for_all_entries {A} (m : PositiveMap.t A) (f : positive -> A -> bool) : bool :=
  forallb (fun entry => f (fst entry) (snd entry)) (PositiveMap.elements m).

Fixpoint for_all_below (n : nat) (f : nat -> bool) : bool :=
  match n with O => true | S n' => for_all_below n' f && f n' end.

(** * Positions *)

(** The position of a vertex; [] if there is no such label. *)
Definition position (d : certificate) (v : vertex) : list Z :=
  match PositiveMap.find (fst v) (points d) with
  | Some p => zplus p (zscale (period d) (snd v))
  | None => []
  end.

Definition move (u : list Z) (s : simplex) : simplex := map (fun v => (fst v, zplus (snd v) u)) s.

Definition has_length {A} (n : nat) (x : list A) : bool := Nat.eqb (length x) n.

(** * Rules *)

(** The metric is positive definite. *)
Definition check_metric (d : certificate) (h : hints) : bool :=
  (0 <? gram_factor h) && (0 <? least_stretch h) && forallb (fun s => 0 <=? fst s) (squares h) &&
  equal_matrices (map (zscale (gram_factor h)) (gram d))
    (mplus (scalar_matrix (dimension d) (least_stretch h))
       (sum_of_products (map (fun s => zscale (fst s) (snd s)) (squares h)) (map snd (squares h)))).

Definition cell_of (d : certificate) (h : hints) (x : list Z) : list Z := map (fun c => cells h * c / period d) x.
Definition cell_key (h : hints) (c : list Z) : positive :=
  Z.to_pos (fold_left (fun k r => k * cells h + r mod cells h) c 0 + 1).
Definition labels_in (h : hints) (c : list Z) : list positive :=
  match PositiveMap.find (cell_key h c) (in_cells h) with Some labels => labels | None => [] end.

(** The labels of each cell are complete. *)
Definition check_point (d : certificate) (h : hints) (label : positive) (p : list Z) : bool :=
  has_length (dimension d) p && existsb (Pos.eqb label) (labels_in h (cell_of d h p)).

Definition form_at (form x : list Z) : Z := zdot form (1 :: x).

(** Barycentric coordinates: the vertices are affinely independent, and each point is a combination of them. *)
Definition check_forms (d : certificate) (h : simplex_hints) (vertices : list (list Z)) : bool :=
  let order := S (dimension d) in
  (0 <? volume h) &&
  equal_matrices (sum_of_products (map (cons 1) vertices) (forms h)) (scalar_matrix order (volume h)) &&
  equal_matrices (map (fun form => map (form_at form) vertices) (forms h)) (scalar_matrix order (volume h)).

(** The denominator of the centre times x, less its numerator. *)
Definition from_centre (h : simplex_hints) (x : list Z) : list Z :=
  zplus (zscale (centre_denominator h) x) (zscale (-1) (centre h)).
Definition square_from_centre (d : certificate) (h : simplex_hints) (x : list Z) : Z :=
  zquadratic (gram d) (from_centre h x).
Definition square_radius (d : certificate) (h : simplex_hints) (vertices : list (list Z)) : Z :=
  match vertices with [] => 0 | v :: _ => square_from_centre d h v end.

Definition check_centre (d : certificate) (h : simplex_hints) (vertices : list (list Z)) (square : Z) : bool :=
  (0 <? centre_denominator h) && has_length (dimension d) (centre h) &&
  forallb (fun v => square_from_centre d h v =? square) vertices.

(** A neighbour has all vertices of s but the one at place i, and another one beyond that facet, outside of the ball. *)
Definition check_neighbour (d : certificate) (h : simplex_hints) (s : simplex) (square : Z) (i : nat) : bool :=
  match nth_error (neighbours h) i, nth_error (forms h) i with
  | Some (k, u), Some form =>
      match PositiveMap.find k (simplices d) with
      | Some base =>
          let t := move u base in
          has_length (dimension d) u &&
          for_all_below (length s)
            (fun j => Nat.eqb j i || match nth_error s j with Some v => is_vertex_of v t | None => true end) &&
          existsb (fun w => let x := position d w in
                            (form_at form x <? 0) && (square <? square_from_centre d h x)) t
      | None => false
      end
  | _, _ => false
  end.

(** All integer vectors between two. *)
Fixpoint for_all_from (n : nat) (from : Z) (f : Z -> bool) : bool :=
  match n with O => true | S n' => f from && for_all_from n' (from + 1) f end.
Fixpoint for_all_cells (low high : list Z) (f : list Z -> bool) : bool :=
  match low, high with
  | a :: low', b :: high' =>
      for_all_from (Z.to_nat (b - a + 1)) a (fun c => for_all_cells low' high' (fun cs => f (c :: cs)))
  | _, _ => f []
  end.

Fixpoint at_most (x y : list Z) : bool :=
  match x, y with
  | [], [] => true
  | a :: x', b :: y' => (a <=? b) && at_most x' y'
  | _, _ => false
  end.

(** The lift of a label in a cell is a vertex of s or outside of s. *)
Definition check_lift (d : certificate) (g : hints) (h : simplex_hints) (s : simplex) (cell : list Z)
    (label : positive) : bool :=
  match PositiveMap.find label (points d) with
  | Some p =>
      let v := (label, map (fun c => c / cells g) (zplus cell (zscale (-1) (cell_of d g p)))) in
      let x := position d v in
      is_vertex_of v s || existsb (fun form => form_at form x <? 0) (forms h)
  | None => true
  end.

(** No point but its vertices is in s. *)
Definition check_inside (d : certificate) (g : hints) (h : simplex_hints) (s : simplex) (vertices : list (list Z)) : bool :=
  forallb (fun v => at_most (lowest h) v && at_most v (highest h)) vertices &&
  for_all_cells (cell_of d g (lowest h)) (cell_of d g (highest h))
    (fun cell => forallb (check_lift d g h s cell) (labels_in g cell)).

Definition check_simplex (d : certificate) (g : hints) (k : positive) (s : simplex) : bool :=
  match PositiveMap.find k (of_simplices g) with
  | None => false
  | Some h =>
      let vertices := map (position d) s in
      let square := square_radius d h vertices in
      has_length (S (dimension d)) s &&
      forallb (fun v => has_length (dimension d) (snd v) && PositiveMap.mem (fst v) (points d)) s &&
      check_forms d h vertices &&
      check_centre d h vertices square &&
      for_all_below (length s) (check_neighbour d h s square) &&
      check_inside d g h s vertices
  end.

(** In lexicographic order, which no vector is before itself. *)
Fixpoint is_before (x y : list positive) : bool :=
  match x, y with
  | [], _ :: _ => true
  | a :: x', b :: y' => Pos.ltb a b || (Pos.eqb a b && is_before x' y')
  | _, [] => false
  end.

Fixpoint increases (x : list positive) : bool :=
  match x with a :: ((b :: _) as x') => Pos.ltb a b && increases x' | _ => true end.

(** The labels of a simplex increase, and those of the simplex before it in the list are smaller. *)
Definition check_labels (d : certificate) (k : positive) (s : simplex) : bool :=
  increases (map fst s) &&
  (Pos.eqb k 1 ||
   match PositiveMap.find (Pos.pred k) (simplices d) with
   | Some s' => is_before (map fst s') (map fst s)
   | None => false
   end).

(** A certificate is accepted if it is right and the hints show it. *)
Definition check (d : certificate) (h : hints) : bool :=
  (0 <? period d) && (0 <? cells h) && negb (PositiveMap.is_empty (simplices d)) &&
  check_metric d h && for_all_entries (points d) (check_point d h) &&
  for_all_entries (simplices d) (check_labels d) && for_all_entries (simplices d) (check_simplex d h).
