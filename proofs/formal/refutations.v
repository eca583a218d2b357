(** Steps that are false: the numbers that show it are put in, and what then is claimed of numbers is refuted. *)

Require Import Reals Lra Psatz.
From Delcert Require Import enclosure.
Open Scope R_scope.

(** A true comparison of numbers. *)
Ltac number :=
  try unfold Rpower;
  lazymatch goal with
  | |- _ /\ _ => split; number
  | |- _ => first [lra | interval with (i_prec 60) | interval with (i_prec 600) | right; field; lra | field; lra]
  end.

(** From a claim about numbers that is false: a contradiction. *)
Ltac refute H :=
  lazymatch type of H with
  | _ /\ _ => let A := fresh "A" in let B := fresh "B" in destruct H as [A B]; first [refute A | refute B]
  | _ \/ _ => destruct H as [H|H]; refute H
  | ?a <= ?b => apply Rle_not_lt in H; apply H; number
  | ?a < ?b => apply Rlt_not_le in H; apply H; number
  | ?a >= ?b => apply Rge_le in H; refute H
  | ?a > ?b => apply Rgt_lt in H; refute H
  | ?a = ?b => first [assert (a < b) by number; lra | assert (b < a) by number; lra]
  | _ -> _ => specialize (H ltac:(number)); refute H
  end.
