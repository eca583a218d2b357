#!/usr/bin/env bash
# verified_test.sh WORK DELCERT: the theory of proofs/verified compiles, and does not if a rule is left out; the program
# accepts what delcert certifies, the torus of ./run among it, and refuses the forgeries.
set -uo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
project=$(cd "$here/../../.." && pwd)
mkdir -p "$1"
work=$(cd "$1" && pwd)
delcert=$2
failures=0
fail() {
  failures=$((failures + 1))
  echo "FAILED: $*"
}

"$project/proofs/verified/check.sh" "$work" || { fail "the theory or the program"; exit 1; }

copy=$(mktemp -d)
trap 'rm -rf "$copy"' EXIT

# refused NAME FILE EXPRESSION REASON: with a file changed by sed, the theory is refused for this reason.
refused() {
  rm -rf "${copy:?}"/*
  mkdir "$copy/formal"
  cp "$project/proofs/formal/theory.sh" "$copy/formal/"
  cp -r "$project/proofs/verified" "$copy/verified"
  cp -r "$work" "$copy/work"
  local name=$1 file=$copy/verified/$2 changed
  changed=$(sed "$3" "$file")
  [[ $changed != "$(cat "$file")" ]] || { fail "$name: nothing was changed"; return; }
  printf '%s\n' "$changed" >"$file"
  "$copy/verified/check.sh" "$copy/work" >"$copy/log" 2>&1 && { fail "$name: accepted"; return; }
  grep -q "$4" "$copy/log" || fail "$name: refused for another reason: $(cat "$copy/log")"
}

refused "a proof left out" soundness.v 's/^Lemma some_simplex.*/&\nProof. Admitted.\nLemma some_simplex2 : exists e, is_right e./' "proofs are left out"
# A rule that is left out, or weaker.
refused "a vertex beyond a facet on the sphere" certificates.v 's/(square <? square_from_centre d h x)/(square <=? square_from_centre d h x)/' \
  "FAILED: hints.v"
refused "a neighbour on the same side" certificates.v 's/(form_at form x <? 0) && (square <?/(square <?/' "FAILED: hints.v"
refused "a neighbour without the facet" certificates.v 's/Nat.eqb j i || match/true || match/' "FAILED: hints.v"
refused "points inside of simplices" certificates.v 's/^      check_inside d g h s vertices$/      true/' "FAILED: hints.v"
refused "cells without some of their labels" certificates.v 's/ && existsb (Pos.eqb label) (labels_in h (cell_of d h p))//' "FAILED: hints.v"
refused "any metric" certificates.v 's/^  check_metric d h && /  /' "FAILED: soundness.v"
refused "an empty list" certificates.v 's/ && negb (PositiveMap.is_empty (simplices d))//' "FAILED: soundness.v"
refused "simplices in any order" certificates.v 's/ && for_all_entries (simplices d) (check_labels d)//; s/for_all_entries (simplices d) (check_labels d) && //' \
  "FAILED: soundness.v"
refused "a stronger theorem" tessellations.v 's/~ In q t -> r < square_distance/~ In q t -> r + 1 < square_distance/' "FAILED: soundness.v"

# certified NAME ARGUMENT…: the list of a certificate.
certified() {
  local name=$1
  shift
  (cd "$project" && "$delcert" certify "$@" --output "$copy/$name.json.zst") >"$copy/log" 2>&1 || { fail "$name: $(cat "$copy/log")"; return; }
  "$delcert" export "$copy/$name.json.zst" --format lattice >"$copy/$name.txt" || fail "$name: export"
}

rm -rf "${copy:?}"/*
certified torus-2 --manifold torus-2 --radius 1/24 --seed 1
certified torus-2-hexagonal --manifold torus-2-hexagonal --radius 1/24 --seed 1
certified torus-3 --manifold examples/manifolds/torus-3.toml --radius 1/24 --mode theory --seed 1
python3 "$here/forgeries.py" "$work/delcert-verified" "$copy/torus-2.txt" "$copy/torus-2-hexagonal.txt" "$copy/torus-3.txt" || fail "the program"
# The page lists these forgeries.
diff <(python3 "$here/forgeries.py" --table) <(sed -n '/<!-- forgeries: begin -->/,/<!-- forgeries: end -->/p' "$project/docs/verified.md" | sed '1d;$d') ||
  fail "the table of docs/verified.md: forgeries.py --table prints it"

echo "$failures failures"
exit $((failures > 0))
