# shellcheck shell=bash
# Compiling with coqc, and the axioms that what was compiled rests on. Expects $formal, the folder of the theory, and
# $work, a folder of the build: what is there already and has not changed is not compiled again.

logical=Delcert
out=${work:?}/$logical

# What Coq's library of the real numbers is built on: nothing else may appear below a theorem or a step.
allowed_axioms='ClassicalDedekindReals.sig_forall_dec
ClassicalDedekindReals.sig_not_dec
FunctionalExtensionality.functional_extensionality_dep
Classical_Prop.classic'

# In $work, as the tactics leave files where they run.
coq() { coq_within 600 "$@"; }
# coq_within SECONDS ARGUMENT…
coq_within() { (cd "$work" && timeout "$1" coqc -q -Q "$out" $logical -w none "${@:2}"); }

# digest FILE…: one for all of them and for the version of Coq.
coq_version=$(coqc --print-version)
digest() {
  { echo "$coq_version"; cat "$@"; } | sha256sum | cut -c1-16
}

# The theory's files, each after what it needs.
theory_files() { (cd "${formal:?}" && coqdep -Q . $logical -sort ./*.v 2>/dev/null) | tr ' ' '\n' | sed 's,^.*/,,' | grep '\.v$'; }

# needed_by_files: of each file a line, with those of the theory's files that it names after it.
needed_by_files() {
  (cd "${formal:?}" && coqdep -Q . $logical ./*.v 2>/dev/null) |
    sed -nE 's,^([^ ]*/)?([A-Za-z0-9_]+)\.vo [^:]*: [^ ]*\.v ?,\2 ,p' | sed -E 's,[^ ]*/,,g; s/\.vo//g'
}

# compile_theory: 0 if every file compiles; the first that does not is named. The key of what has been compiled is of the file
# and of the keys of what it needs.
compile_theory() {
  local file name names key keys
  local -A needed_by=() key_of=()
  mkdir -p "$out"
  while read -r name names; do needed_by[$name]=$names; done < <(needed_by_files)
  while read -r file; do
    keys=""
    for name in ${needed_by[${file%.v}]}; do keys+="${key_of[$name]:-} "; done
    key=$(digest "$formal/$file" - <<<"$keys")
    key_of[${file%.v}]=$key
    [[ -e $out/${file}o && $(cat "$out/$file.key" 2>/dev/null) == "$key" ]] && continue
    cp "$formal/$file" "$out/$file"
    if ! coq "$out/$file" >"$work/log" 2>&1; then
      echo "FAILED: $file: $(tr '\n' ' ' <"$work/log")"
      return 1
    fi
    echo "$key" >"$out/$file.key"
  done < <(theory_files)
}

# statements FILE…: the names of all that is proved there.
statements() { grep -ohE '\<(Theorem|Lemma|Corollary|Proposition|Fact|Remark) +[A-Za-z0-9_]+' "$@" | sed 's/.* //'; }

# axioms_of MODULE…: the axioms below everything that is proved in these modules, one a line.
axioms_of() {
  local module name all=tt
  {
    for module in "$@"; do echo "From $logical Require $module."; done
    for module in "$@"; do
      for name in $(statements "$out/$module.v"); do all="(@$module.$name, $all)"; done
    done
    echo "Definition everything := $all."
    echo "Print Assumptions everything."
  } >"$work/axioms_probe.v"
  coq -o "$work/axioms_probe.vo" "$work/axioms_probe.v" >"$work/axioms.log" 2>&1 || { cat "$work/axioms.log" >&2; return 1; }
  sed -nE 's/^([A-Za-z_][A-Za-z0-9_.]*)( *:.*)?$/\1/p' "$work/axioms.log" | grep -vx Axioms
  # Something is printed at any rate: a module of which nothing is asked would be no question.
  grep -qE '^(Axioms:|Closed under the global context)' "$work/axioms.log"
}

# check_axioms MODULE…: 0 if they are those of the real numbers.
check_axioms() {
  local found more
  found=$(axioms_of "$@") || { echo "FAILED: no axioms found for $*"; return 1; }
  more=$(grep -vxF "$allowed_axioms" <<<"$found" | grep .) || return 0
  echo "FAILED: more axioms than those of the real numbers: ${more//$'\n'/ }"
  return 1
}

# admitted FOLDER…: the places where a proof is left out.
admitted() { grep -rnwE 'Admitted|admit|Axiom|Parameter|Conjecture|give_up|Unset Guard Checking' --include='*.v' "$@"; }
