(** The function that decides certificates as an OCaml program: verified_core.ml and .mli, in the folder where coqc runs. *)
From Coq Require Import ZArith FMapPositive Extraction ExtrOcamlBasic ExtrOcamlZBigInt.
From Delcert Require Import vectors certificates.

Extraction Language OCaml.
Extraction "verified_core.ml" check check_labels check_metric check_point check_forms check_centre check_neighbour check_inside
  square_radius position PositiveMap.add PositiveMap.find PositiveMap.empty.
