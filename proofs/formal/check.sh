#!/usr/bin/env bash
# check.sh theorems WORK    compiles proofs/formal/*.v in the folder WORK and looks at the axioms of every theorem.
set -uo pipefail
formal=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
work=${2:?usage: check.sh theorems WORK}
mkdir -p "$work"
work=$(cd "$work" && pwd)
# shellcheck source=proofs/formal/theory.sh
. "$formal/theory.sh"

theorems() {
  local -a modules
  mapfile -t modules < <(theory_files | sed 's/\.v$//')
  ((${#modules[@]} > 0)) || { echo "FAILED: no theory in $formal"; return 1; }
  admitted "$formal" && { echo "FAILED: proofs are left out"; return 1; }
  compile_theory && check_axioms "${modules[@]}" || return 1
  echo "${#modules[@]} files, $(cd "$formal" && statements ./*.v | wc -l) theorems and lemmas, no axioms but those of the real numbers"
}

case ${1:-} in
  theorems) theorems ;;
  *) echo "check.sh: no such task: ${1:-}" >&2; exit 64 ;;
esac
