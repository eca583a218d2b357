(** The tactic `interval` on numbers of Coq's own integers. The one that coq-interval gives by default computes with the
    machine's integers and floating-point numbers, whose properties are axioms: with `i_prec` above 53 this one rests on
    the axioms of the real numbers alone. *)

From Interval Require Import Float.Specific_stdz Float.Specific_ops Tactic.
Module Numbers := SpecificFloat StdZRadix2.
Module Tactics := IntervalTactic Numbers.
Export Tactics.
Notation i_bisect := Interval.Tactic.i_bisect.
Notation i_prec := Interval.Tactic.i_prec.
Notation i_depth := Interval.Tactic.i_depth.
