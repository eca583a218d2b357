#!/usr/bin/env bash
# check.sh theorems WORK          compiles proofs/formal/*.v in the folder WORK and looks at the axioms of every theorem.
# check.sh steps WORK DELCERT     exports all steps of all claims and compiles the fixed sample of sample.txt and what
#                                 differs from what steps.txt records as compiled. The latter may take $FORMAL_BUDGET
#                                 seconds (90); what is left then is a failure: record it.
# check.sh all-steps WORK DELCERT compiles the theory and all steps anew: it trusts no hash, neither those of steps.txt
#                                 nor those of what has been compiled in WORK.
# check.sh record WORK DELCERT    compiles all steps, and writes steps.txt.
# But for all-steps, what has been compiled in WORK and has not changed is not compiled again.
set -uo pipefail
formal=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
work=${2:?usage: check.sh theorems|steps|all-steps|record WORK [DELCERT]}
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

# compile_step MODULE: compiles an exported step for at most a minute. Leaves $outcome (compiled or failed), $seconds
# (empty if it had been done before), $message.
compile_step() {
  local module=$1 key before
  key=${hash_of[$module]}-$theory
  seconds="" message=""
  if [[ $(cat "$out/$module.key" 2>/dev/null) == "$key" && -e $out/$module.vo ]]; then outcome=compiled; return; fi
  before=$(head -n 1 "$out/$module.failed" 2>/dev/null)
  if [[ $before == "$key" ]]; then outcome=failed message=$(sed 1d "$out/$module.failed"); return; fi
  rm -f "$out/$module".*
  cp "$work/export/$module.v" "$out/"
  local start=${EPOCHREALTIME/./}
  if coq_within 60 "$out/$module.v" >"$work/log" 2>&1; then
    outcome=compiled
    echo "$key" >"$out/$module.key"
  else
    outcome=failed
    message=$(tr '\n' ' ' <"$work/log" | tail -c 200)
    printf '%s\n%s\n' "$key" "${message:-more than a minute}" >"$out/$module.failed"
  fi
  seconds=$(((${EPOCHREALTIME/./} - start) / 1000))
}

# steps sample|all|record DELCERT
steps() {
  local extent=$1 delcert=${2:?check.sh steps WORK DELCERT} start=$SECONDS module step method
  local -A hash_of=() step_of=() method_of=() recorded=() in_sample=() reason=()
  compile_theory || return 1
  rm -rf "$work/export"
  "$delcert" formalise --all --into "$work/export" >"$work/steps.list" || { echo "FAILED: the export"; return 1; }
  admitted "$work/export" && { echo "FAILED: proofs are left out"; return 1; }
  while read -r module step method; do step_of[$module]=$step method_of[$module]=$method; done <"$work/steps.list"
  ((${#step_of[@]} > 0)) || { echo "FAILED: no steps"; return 1; }
  while read -r hash file; do hash_of[$(basename "$file" .v)]=${hash:0:16}; done < <(sha256sum "$work"/export/*.v)
  theory=$(digest "$formal"/certificates.v "$formal"/enclosure.v "$formal"/refutations.v)

  # A step that is listed with its reason need not compile; one that does must not be listed.
  while IFS=: read -r step why; do [[ -z $step || $step == '#'* ]] || reason[$step]=$why; done <"$formal/not-formalised.txt"
  while read -r step; do [[ -z $step || $step == '#'* ]] || in_sample[$step]=1; done <"$formal/sample.txt"
  if [[ $(head -n 1 "$formal/steps.txt" 2>/dev/null) == "theory $theory" ]]; then
    while read -r hash step _; do recorded[$step]=$hash; done < <(sed 1d "$formal/steps.txt")
  fi

  local seconds message outcome failures=0 compiled=0 refuted=0 listed=0 unchanged=0 left=0 budget_from=$SECONDS
  local -a modules=()
  local record=$work/steps.txt
  echo "theory $theory" >"$record"
  for step in "${!in_sample[@]}"; do
    grep -q " $step " "$work/steps.list" || { echo "FAILED: $step of sample.txt does not exist"; failures=$((failures + 1)); }
  done
  for step in "${!reason[@]}"; do
    grep -q " $step " "$work/steps.list" || { echo "FAILED: $step of not-formalised.txt does not exist"; failures=$((failures + 1)); }
  done
  while read -r module; do
    step=${step_of[$module]}
    if [[ ${method_of[$module]} == none ]]; then
      outcome=failed message="no counterpart in Coq" seconds=""
    elif [[ $extent == sample && -z ${in_sample[$step]:-} && ${recorded[$step]:-} == "${hash_of[$module]}" ]]; then
      unchanged=$((unchanged + 1))
      continue
    elif [[ $extent == sample && -z ${in_sample[$step]:-} ]] && ((SECONDS - budget_from > ${FORMAL_BUDGET:-90})); then
      left=$((left + 1))
      continue
    else
      compile_step "$module"
    fi
    if [[ $outcome == compiled ]]; then
      modules+=("$module")
      if [[ ${method_of[$module]} == refutation ]]; then refuted=$((refuted + 1)); else compiled=$((compiled + 1)); fi
      echo "${hash_of[$module]} $step ${method_of[$module]}" >>"$record"
      [[ -z ${reason[$step]:-} ]] || { echo "FAILED: $step compiles, but not-formalised.txt lists it"; failures=$((failures + 1)); }
    elif [[ -n ${reason[$step]:-} ]]; then
      listed=$((listed + 1))
      echo "${hash_of[$module]:-0} $step not-formalised" >>"$record"
    else
      echo "FAILED: $step: $message"
      failures=$((failures + 1))
    fi
    [[ -z $seconds || $extent == sample ]] || printf '%-6s ms  %-12s %s\n' "$seconds" "$outcome" "$step"
  done < <(cut -d' ' -f1 "$work/steps.list")

  ((${#modules[@]} == 0)) || check_axioms "${modules[@]}" || failures=$((failures + 1))
  echo "${#step_of[@]} steps: $compiled proved and $refuted refuted in Coq, $listed not formalised (not-formalised.txt)," \
    "$failures failures; no axioms but those of the real numbers; $((SECONDS - start)) s"
  [[ $extent != sample ]] || echo "  $unchanged as steps.txt records them"
  ((left == 0)) || echo "FAILED: $left steps that steps.txt does not record were not compiled: run check.sh record"
  ((failures == 0 && left == 0)) || return 1
  [[ $extent != record ]] || cp "$record" "$formal/steps.txt"
}

case ${1:-} in
  theorems) theorems ;;
  steps) steps sample "${3:-}" ;;
  all-steps) rm -rf "$out" && steps all "${3:-}" ;;
  record) steps record "${3:-}" ;;
  *) echo "check.sh: no such task: ${1:-}" >&2; exit 64 ;;
esac
