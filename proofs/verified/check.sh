#!/usr/bin/env bash
# check.sh WORK: compiles proofs/verified/*.v in the folder WORK, looks at the axioms of every theorem, extracts the
# function that decides certificates, and compiles the program WORK/delcert-verified.
# What has been compiled in WORK and has not changed is not compiled again.
set -uo pipefail
formal=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
work=${1:?usage: check.sh WORK}
mkdir -p "$work"
work=$(cd "$work" && pwd)
# shellcheck source=proofs/formal/theory.sh
. "$formal/../formal/theory.sh"

# After what it needs: the core that Coq prints, then the reader, the hints and the program.
program_files="lattice_file.ml hint_search.ml main.ml"

theorems() {
  local -a modules
  mapfile -t modules < <(theory_files | sed 's/\.v$//' | grep -vxE 'extraction|certificates|tessellations')
  ((${#modules[@]} > 0)) || { echo "FAILED: no theory in $formal"; return 1; }
  admitted "$formal" && { echo "FAILED: proofs are left out"; return 1; }
  compile_theory && check_axioms "${modules[@]}" || return 1
  echo "${#modules[@]} files, $(cd "$formal" && statements ./*.v | wc -l) theorems and lemmas, no axioms but those of the real numbers"
}

program() {
  local key file
  [[ -e $work/verified_core.ml ]] || { echo "FAILED: Coq has not printed the program"; return 1; }
  key=$(cd "$formal" && cat "$work"/verified_core.ml* $program_files | sha256sum | cut -c1-16)
  [[ -x $work/delcert-verified && $(cat "$work/delcert-verified.key" 2>/dev/null) == "$key" ]] && return
  for file in $program_files; do cp "$formal/$file" "$work/"; done
  # What Coq prints has unused values; our own files may have none.
  (cd "$work" && ocamlfind ocamlopt -w -a -package zarith -c verified_core.mli verified_core.ml &&
    ocamlfind ocamlopt -w +a-4-9-40-42-44-45-70 -warn-error +a -package zarith -linkpkg verified_core.cmx $program_files -o delcert-verified) \
    >"$work/log" 2>&1 || { echo "FAILED: the program: $(cat "$work/log")"; return 1; }
  echo "$key" >"$work/delcert-verified.key"
}

theorems && program
