#!/usr/bin/env bash
# The pages of docs/tables that directed searches fill are those of their records, and the records are of the claims as they are:
# what is changed by hand is noticed. Needs the programs of the build folder.
set -uo pipefail
# shellcheck source=tests/setup/complaints.sh
. "$(dirname "${BASH_SOURCE[0]}")/complaints.sh"
build=$1

check() { python3 "$1/bench/searches.py" check --build "$build"; }
check "$project" || fail "the pages of searches are stale: bench/searches.py render, or measure"

copy() {
  rm -rf "$work/copy"
  mkdir -p "$work/copy/bench" "$work/copy/docs" "$work/copy/proofs"
  cp "$project/bench/searches.py" "$work/copy/bench/"
  cp -r "$project/docs/tables" "$work/copy/docs/"
  cp -r "$project/proofs/claims" "$work/copy/proofs/"
}

# changed TITLE FILE EXPRESSION COMPLAINT: a copy with one change in a file must be refused, and say why.
changed() {
  copy
  sed -i "$3" "$work/copy/$2"
  ! cmp -s "$work/copy/$2" "$project/$2" || fail "$1: nothing was changed"
  check "$work/copy" >"$work/log" 2>&1 && fail "$1 passes"
  grep -q "$4" "$work/log" || fail "$1: it says $(cat "$work/log")"
}
changed "a ratio changed by hand" docs/tables/tightness.md '0,/| 0\.[0-9]* |/s//| 0.987654321 |/' "docs/tables/tightness.md is not"
changed "another exponent" docs/tables/exponents.json '0,/"residual": [0-9.e-]*/s//"residual": 77.5/' "docs/tables/exponents.md is not"
changed "a claim with another constant" proofs/claims/circumradius-under-distortion.toml 's/<= 16\*k/<= 17*k/' "says something else"
# What twins and steps say is not what was searched.
copy
sed -i 's/99\/100\*k^(3\/2)/98\/100*k^(3\/2)/' "$work/copy/proofs/claims/circumradius-under-distortion.toml"
check "$work/copy" >"$work/log" 2>&1 || fail "another twin is taken for another claim: $(cat "$work/log")"
finish
