(** Vectors and matrices as lists: of real numbers in theorems, of integers in computations.
    Missing entries count as 0, so that sums and scalar products need no hypotheses about lengths. *)
From Coq Require Import Reals List ZArith Lra Lia.
Import ListNotations.
Open Scope R_scope.

(** * Real vectors *)

Definition vector := list R.

Fixpoint dot (a x : vector) : R :=
  match a, x with c :: a', y :: x' => c * y + dot a' x' | _, _ => 0 end.

Fixpoint plus (x y : vector) : vector :=
  match x, y with
  | [], _ => y
  | _, [] => x
  | a :: x', b :: y' => (a + b) :: plus x' y'
  end.

Definition scale (c : R) (x : vector) : vector := map (Rmult c) x.
Definition minus (x y : vector) : vector := plus x (scale (-1) y).

Fixpoint total (w : vector) : R := match w with [] => 0 | c :: w' => c + total w' end.

(** The combination of ys with the weights w. *)
Fixpoint combination (w : vector) (ys : list vector) : vector :=
  match w, ys with c :: w', y :: ys' => plus (scale c y) (combination w' ys') | _, _ => [] end.

(** A matrix is the list of its rows. *)
Definition apply (g : list vector) (x : vector) : vector := map (fun row => dot row x) g.
Definition quadratic (g : list vector) (x : vector) : R := dot x (apply g x).

Definition coordinate (i : nat) (x : vector) : R := nth i x 0.

Lemma coordinate_nil i : coordinate i [] = 0.
Proof. destruct i; reflexivity. Qed.

Lemma coordinate_plus i x y : coordinate i (plus x y) = coordinate i x + coordinate i y.
Proof.
  unfold coordinate; revert i y; induction x as [| a x IH]; intros [| i] [| b y]; simpl; try lra.
  apply IH.
Qed.

Lemma coordinate_scale i c x : coordinate i (scale c x) = c * coordinate i x.
Proof. unfold coordinate; revert i; induction x as [| a x IH]; intros [| i]; simpl; try lra. apply IH. Qed.

Lemma length_plus x y : length (plus x y) = Nat.max (length x) (length y).
Proof. revert y; induction x as [| a x IH]; intros [| b y]; simpl; auto. Qed.

Lemma length_scale c x : length (scale c x) = length x.
Proof. apply map_length. Qed.

Lemma length_minus x y : length (minus x y) = Nat.max (length x) (length y).
Proof. unfold minus; rewrite length_plus, length_scale; reflexivity. Qed.

Lemma coordinate_minus i x y : coordinate i (minus x y) = coordinate i x - coordinate i y.
Proof. unfold minus; rewrite coordinate_plus, coordinate_scale; lra. Qed.

Lemma vector_equality x y : length x = length y -> (forall i, coordinate i x = coordinate i y) -> x = y.
Proof. intros L E; apply (nth_ext x y 0 0 L); intros i _; apply E. Qed.

Lemma dot_nil_right a : dot a [] = 0.
Proof. destruct a; reflexivity. Qed.

Lemma dot_commutes a x : dot a x = dot x a.
Proof. revert x; induction a as [| c a IH]; intros [| y x]; simpl; try lra. rewrite IH; lra. Qed.

Lemma dot_plus_left a b x : dot (plus a b) x = dot a x + dot b x.
Proof.
  revert b x; induction a as [| c a IH]; intros [| d b] [| y x]; simpl; try lra.
  rewrite IH; lra.
Qed.

Lemma dot_plus_right a x y : dot a (plus x y) = dot a x + dot a y.
Proof. rewrite dot_commutes, dot_plus_left, (dot_commutes x), (dot_commutes y); reflexivity. Qed.

Lemma dot_scale_left c a x : dot (scale c a) x = c * dot a x.
Proof. revert x; induction a as [| d a IH]; intros [| y x]; simpl; try lra. unfold scale in IH; rewrite IH; lra. Qed.

Lemma dot_scale_right c a x : dot a (scale c x) = c * dot a x.
Proof. rewrite dot_commutes, dot_scale_left, dot_commutes; reflexivity. Qed.

Lemma dot_combination a w ys : dot a (combination w ys) = dot w (map (dot a) ys).
Proof.
  revert ys; induction w as [| c w IH]; intros [| y ys]; simpl; try apply dot_nil_right.
  rewrite dot_plus_right, dot_scale_right, IH; reflexivity.
Qed.

Lemma dot_square_is_large x i : coordinate i x * coordinate i x <= dot x x.
Proof.
  unfold coordinate; revert i; induction x as [| a x IH]; intros i; simpl.
  - destruct i; simpl; lra.
  - pose proof (Rle_trans _ _ _ (Rle_0_sqr (nth 0 x 0)) (IH 0%nat)) as P. pose proof (Rle_0_sqr a) as Q.
    unfold Rsqr in Q. destruct i as [| i]; [| specialize (IH i)]; simpl; lra.
Qed.

Lemma combination_cons w ys :
  length w = length ys -> w <> [] -> combination w (map (cons 1) ys) = total w :: combination w ys.
Proof.
  revert ys; induction w as [| c w IH]; intros [| y ys] L NE; try discriminate; try congruence.
  injection L as L; simpl.
  destruct w as [| c' w].
  - destruct ys; [simpl | discriminate]. f_equal; [lra |]. destruct (scale c y); reflexivity.
  - rewrite IH; [simpl | assumption | discriminate]. f_equal; lra.
Qed.

Lemma length_combination m w ys :
  length w = length ys -> ys <> [] -> (forall y, In y ys -> length y = m) -> length (combination w ys) = m.
Proof.
  revert ys; induction w as [| c w IH]; intros [| y ys] L NE A; try discriminate; try congruence.
  injection L as L; simpl; rewrite length_plus, length_scale, (A y (or_introl eq_refl)).
  destruct ys as [| y' ys].
  - destruct w; [simpl; lia | discriminate].
  - rewrite IH; [lia | assumption | discriminate | intros; apply A; right; assumption].
Qed.

Lemma total_scale c w : total (scale c w) = c * total w.
Proof. unfold scale; induction w as [| a w IH]; simpl; [| rewrite IH]; lra. Qed.

(** * Quadratic forms *)

Lemma dot_apply_plus u g x y : dot u (apply g (plus x y)) = dot u (apply g x) + dot u (apply g y).
Proof.
  revert u; induction g as [| r g IH]; intros [| c u]; simpl; try lra.
  unfold apply in *; rewrite IH, dot_plus_right; lra.
Qed.

Lemma dot_apply_scale u g c x : dot u (apply g (scale c x)) = c * dot u (apply g x).
Proof.
  revert u; induction g as [| r g IH]; intros [| d u]; simpl; try lra.
  unfold apply in *; rewrite IH, dot_scale_right; lra.
Qed.

(** u·Gx is a linear form of x. *)
Lemma dot_apply u g x : dot u (apply g x) = dot (combination u g) x.
Proof.
  rewrite (dot_commutes (combination u g)), dot_combination.
  unfold apply; f_equal; apply map_ext; intros; apply dot_commutes.
Qed.

Lemma quadratic_minus g x c :
  quadratic g (minus x c) =
  quadratic g x - dot (plus (apply g c) (combination c g)) x + quadratic g c.
Proof.
  unfold quadratic, minus.
  rewrite dot_plus_left, dot_scale_left, !dot_apply_plus, !dot_apply_scale, dot_plus_left, <- dot_apply.
  rewrite (dot_commutes (apply g c) x); ring.
Qed.

(** * Affine functions *)

(** g is an affine function on the vectors of length m. *)
Definition affine (m : nat) (g : vector -> R) : Prop :=
  exists b a, forall x, length x = m -> g x = b + dot a x.

Lemma affine_value m g w ys :
  affine m g -> length w = length ys -> ys <> [] -> (forall y, In y ys -> length y = m) -> total w = 1 ->
  g (combination w ys) = dot w (map g ys).
Proof.
  intros [b [a E]] L NE A T.
  rewrite E by (apply length_combination; assumption).
  rewrite dot_combination.
  assert (H : dot w (map g ys) = b * total w + dot w (map (dot a) ys)).
  { clear T NE. revert ys L A; induction w as [| c w IH]; intros [| y ys] L A; try discriminate; simpl; try lra.
    injection L as L. rewrite IH; [| assumption | intros; apply A; right; assumption].
    rewrite E by (apply A; left; reflexivity). lra. }
  rewrite H, T; lra.
Qed.

(** * Signs of combinations *)

Lemma dot_nonnegative w l : Forall (fun c => 0 <= c) w -> Forall (fun y => 0 <= y) l -> 0 <= dot w l.
Proof.
  revert l; induction w as [| c w IH]; intros [| y l] W F; simpl; try lra.
  inversion W; inversion F; subst. specialize (IH l H2 H6). nra.
Qed.

Lemma dot_nonpositive w l : Forall (fun c => 0 <= c) w -> Forall (fun y => y <= 0) l -> dot w l <= 0.
Proof.
  revert l; induction w as [| c w IH]; intros [| y l] W F; simpl; try lra.
  inversion W; inversion F; subst. specialize (IH l H2 H6). nra.
Qed.

(** A combination of numbers >= 0 that is 0 has no positive weight at a positive number. *)
Lemma dot_zero_terms w l :
  Forall (fun c => 0 <= c) w -> Forall (fun y => 0 <= y) l -> dot w l = 0 ->
  forall i, coordinate i w * coordinate i l = 0.
Proof.
  revert l; induction w as [| c w IH]; intros [| y l] W F Z i; try (rewrite ?coordinate_nil; lra).
  inversion W as [| ? ? C W']; inversion F as [| ? ? Y F']; subst; simpl in Z.
  pose proof (dot_nonnegative w l W' F') as P.
  assert (c * y = 0 /\ dot w l = 0) as [E D] by nra.
  destruct i as [| i]; [exact E | exact (IH l W' F' D i)].
Qed.

(** Only one term is not 0. *)
Lemma dot_one_term i w l :
  (forall j, j <> i -> coordinate j l = 0) -> dot w l = coordinate i w * coordinate i l.
Proof.
  revert i l; induction w as [| c w IH]; intros i [| y l] A; simpl; try (rewrite ?coordinate_nil; lra).
  destruct i as [| i].
  - rewrite (IH (length l) l).
    + unfold coordinate at 2; rewrite nth_overflow by lia; unfold coordinate; simpl; lra.
    + intros j _; exact (A (S j) ltac:(discriminate)).
  - rewrite (IH i l).
    + pose proof (A 0%nat ltac:(discriminate)) as E; unfold coordinate in *; simpl in *; rewrite E; lra.
    + intros j D; apply (A (S j)); congruence.
Qed.

(** * Integer vectors *)

Fixpoint zdot (a x : list Z) : Z :=
  match a, x with c :: a', y :: x' => (c * y + zdot a' x')%Z | _, _ => 0%Z end.

Fixpoint zplus (x y : list Z) : list Z :=
  match x, y with
  | [], _ => y
  | _, [] => x
  | a :: x', b :: y' => (a + b)%Z :: zplus x' y'
  end.

Definition zscale (c : Z) (x : list Z) : list Z := map (Z.mul c) x.
Definition zquadratic (g : list (list Z)) (x : list Z) : Z := zdot x (map (fun row => zdot row x) g).

Definition real (x : list Z) : vector := map IZR x.

Lemma length_real x : length (real x) = length x.
Proof. apply map_length. Qed.

Lemma real_dot a x : IZR (zdot a x) = dot (real a) (real x).
Proof. revert x; induction a as [| c a IH]; intros [| y x]; simpl; auto. rewrite plus_IZR, mult_IZR, IH; reflexivity. Qed.

Lemma real_plus x y : real (zplus x y) = plus (real x) (real y).
Proof. revert y; induction x as [| a x IH]; intros [| b y]; simpl; auto. rewrite plus_IZR, IH; reflexivity. Qed.

Lemma real_scale c x : real (zscale c x) = scale (IZR c) (real x).
Proof. unfold real, zscale, scale; rewrite !map_map; apply map_ext; intros; apply mult_IZR. Qed.

Lemma real_quadratic g x : IZR (zquadratic g x) = quadratic (map real g) (real x).
Proof.
  unfold zquadratic, quadratic, apply; rewrite real_dot; f_equal.
  unfold real at 1; rewrite !map_map; apply map_ext; intros; apply real_dot.
Qed.

Lemma length_zplus x y : length (zplus x y) = Nat.max (length x) (length y).
Proof. revert y; induction x as [| a x IH]; intros [| b y]; simpl; auto. Qed.

Lemma length_zscale c x : length (zscale c x) = length x.
Proof. apply map_length. Qed.

(** * Integer matrices *)

Fixpoint mplus (g h : list (list Z)) : list (list Z) :=
  match g, h with
  | [], _ => h
  | _, [] => g
  | a :: g', b :: h' => zplus a b :: mplus g' h'
  end.

(** The sum of the matrices v aᵀ, v in vs and a at the same place in forms. *)
Fixpoint sum_of_products (vs forms : list (list Z)) : list (list Z) :=
  match vs, forms with
  | v :: vs', a :: forms' => mplus (map (fun c => zscale c a) v) (sum_of_products vs' forms')
  | _, _ => []
  end.

(** d times the unit matrix of order n. *)
Fixpoint scalar_matrix (n : nat) (d : Z) : list (list Z) :=
  match n with
  | O => []
  | S n' => (d :: repeat 0%Z n') :: map (cons 0%Z) (scalar_matrix n' d)
  end.

Definition zapply (g : list (list Z)) (x : vector) : vector := map (fun row => dot (real row) x) g.

Lemma apply_mplus g h x : zapply (mplus g h) x = plus (zapply g x) (zapply h x).
Proof.
  revert h; induction g as [| a g IH]; intros [| b h]; simpl; auto.
  rewrite real_plus, dot_plus_left. f_equal. apply IH.
Qed.

Lemma apply_sum_of_products vs forms x :
  zapply (sum_of_products vs forms) x = combination (map (fun a => dot (real a) x) forms) (map real vs).
Proof.
  revert forms; induction vs as [| v vs IH]; intros [| a forms]; simpl; auto.
  rewrite apply_mplus, IH; f_equal.
  unfold zapply, scale, real; rewrite !map_map; apply map_ext; intros c.
  change (map IZR (zscale c a)) with (real (zscale c a)).
  rewrite real_scale, dot_scale_left; unfold real; lra.
Qed.

Lemma dot_of_zeros n x : dot (real (repeat 0%Z n)) x = 0.
Proof. revert x; induction n as [| n IH]; intros [| y x]; simpl; try lra. unfold real in IH; rewrite IH; lra. Qed.

Lemma apply_scalar_matrix n d x : length x = n -> zapply (scalar_matrix n d) x = scale (IZR d) x.
Proof.
  revert x; induction n as [| n IH]; intros [| y x] L; try discriminate; simpl; auto.
  injection L as L. f_equal.
  - change (map IZR (repeat 0%Z n)) with (real (repeat 0%Z n)); rewrite dot_of_zeros; lra.
  - change (map (Rmult (IZR d)) x) with (scale (IZR d) x).
    rewrite <- IH by assumption. unfold zapply; rewrite map_map; apply map_ext; intros row; simpl; unfold real; lra.
Qed.

(** x is the combination of the vectors vs whose weights are the forms at x, divided by d. *)
Lemma resolution n d vs forms x :
  sum_of_products vs forms = scalar_matrix n d -> length x = n ->
  combination (map (fun a => dot (real a) x) forms) (map real vs) = scale (IZR d) x.
Proof. intros E L; rewrite <- apply_sum_of_products, E; apply apply_scalar_matrix, L. Qed.
