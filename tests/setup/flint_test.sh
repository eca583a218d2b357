#!/usr/bin/env bash
# flint_test.sh ROOT: no source calls what FLINT 2 has and FLINT 3 refuses, since the program builds with both.
set -uo pipefail
# shellcheck source=tests/setup/complaints.sh
. "$(dirname "${BASH_SOURCE[0]}")/complaints.sh"
root=$1
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
grep -v '^#' "$here/flint_3_refuses.txt" >"$work/names"

# uses FOLDER…: the lines that use one of the names.
uses() { grep -rnwFf "$work/names" --include='*.cpp' --include='*.hpp' "$@"; }

(cd "$root" && uses apps bench examples kernel proofs properties support tests) && fail "FLINT 3 does not have what these lines use"
mkdir "$work/copy"
printf 'int f() { return fmpz_poly_get_coeff_mpz(0, 0, 0); }\n' >"$work/copy/a.cpp"
uses "$work/copy" >"$work/log" || fail "a name of the list is not found"
printf 'int f() { return fmpz_poly_get_coeff_mpz_too(0, 0, 0); }\n' >"$work/copy/a.cpp"
uses "$work/copy" >"$work/log" && fail "a longer name is taken for one of the list"

finish
