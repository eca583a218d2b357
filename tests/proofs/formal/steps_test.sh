#!/usr/bin/env bash
# steps_test.sh WORK DELCERT EXTENT: the steps compile in Coq, and mutated ones do not. EXTENT: steps (the sample and what
# has changed) or all-steps.
set -uo pipefail
project=$(cd "$(dirname "${BASH_SOURCE[0]}")/../../.." && pwd)
work=$1 delcert=$2
failures=0
fail() {
  failures=$((failures + 1))
  echo "FAILED: $*"
}

"$project/proofs/formal/check.sh" "$3" "$work" "$delcert" || fail "steps"

copy=$(mktemp -d)
trap 'rm -rf "$copy"' EXIT
coq() { (cd "$copy" && timeout 60 coqc -q -w none -Q "$work/Delcert" Delcert "$1") >"$copy/log" 2>&1; }

# mutated CLAIM STEP CONSTANT VALUE TEXT OTHER: with the constant moved just past its slack the exporter's proof is a
# refutation, and Coq accepts that; and the certificate of the step is no proof of the statement with OTHER for TEXT.
mutated() {
  local stem name method
  read -r stem name method < <("$delcert" formalise "$1" --step "$2" --constant "$3=$4" --into "$copy")
  [[ $method == refutation ]] || fail "$name with $3 = $4: $method"
  coq "$stem.v" || fail "$name with $3 = $4: Coq does not refute it: $(cat "$copy/log")"
  read -r stem name method < <("$delcert" formalise "$1" --step "$2" --into "$copy")
  coq "$stem.v" || fail "$name does not compile: $(cat "$copy/log")"
  # Only the statement, which ends where the proof begins.
  sed -i "1,/^Proof/s|$5|$6|" "$copy/$stem.v"
  grep -qF "$6" "$copy/$stem.v" || fail "$name: the statement was not changed"
  coq "$stem.v" && fail "$name: the certificate proves the mutated statement"
}
mutated circumcentres-under-distortion forty-two c 41 '((42 \* ' '((41 * '
mutated gram-matrix-under-distortion entries c 399/100 '(4 \* ' '((399 / 100) * '
# By sums of squares.
mutated "$project/examples/claims/means.toml" three factor 101/100 '((1 \* a) \* b)' '(((101 / 100) * a) * b)'
mutated thickness-under-distortion longest-edge-ratio c 81/100 '(4 / 5)' '(81 / 100)'

# The export as it was, which the programs would take as long for again.
cp -r "$work/export" "$copy/kept"
cp "$work/steps.list" "$copy/kept.list"
again=$copy/again
cat >"$again" <<END
#!/bin/sh
mkdir -p "\$4" && cp "$copy"/kept/* "\$4" && cat "$copy/kept.list"
END
chmod +x "$again"

# refused NAME EDIT REASON: with the lists of proofs/formal edited so, check.sh refuses the steps for this reason.
refused() {
  rm -rf "$copy/formal"
  cp -r "$project/proofs/formal" "$copy/formal"
  (cd "$copy/formal" && eval "$2")
  "$copy/formal/check.sh" steps "$work" "$again" >"$copy/log" 2>&1 && { fail "$1: accepted"; return; }
  grep -q "$3" "$copy/log" || fail "$1: refused for another reason: $(cat "$copy/log")"
}
refused "a step of the sample that does not exist" "echo no-claim/no-step >>sample.txt" "no-claim/no-step of sample.txt does not exist"
refused "a step that is listed but compiles" \
  "echo 'circumcentres-under-distortion/forty-two: too hard' >>not-formalised.txt" "compiles, but not-formalised.txt lists it"
# A budget that is spent before the first of them.
FORMAL_BUDGET=-1 refused "changed steps that were not compiled" "sed -i '/adaptive-sampling.density/d' steps.txt" "were not compiled: run check.sh record"

# Another lemma in the place of a step, compiled, with the hash of the step: the sample trusts the hash, all-steps does not.
# With what the exported steps use, and one step only.
rm -rf "$copy/formal" "$copy/work"
mkdir "$copy/formal"
cp "$project"/proofs/formal/{certificates,enclosure,refutations}.v "$project"/proofs/formal/*.sh "$copy/formal"
echo circumcentres-under-distortion/forty-two >"$copy/formal/sample.txt"
: >"$copy/formal/not-formalised.txt"
one_step=$copy/one-step
cat >"$one_step" <<END
#!/bin/sh
exec "$delcert" formalise circumcentres-under-distortion --step forty-two --into "\$4"
END
chmod +x "$one_step"
one() { "$copy/formal/check.sh" "$1" "$copy/work" "$one_step" >"$copy/log" 2>&1 || fail "$1 of one step: $(cat "$copy/log")"; }
one steps
stem=$(cut -d' ' -f1 "$copy/work/steps.list")
compiled=$copy/work/Delcert/$stem.v
echo 'Lemma nothing : True. Proof. exact I. Qed.' >"$compiled"
(cd "$copy/work" && coqc -q -w none -Q Delcert Delcert "$compiled") || fail "another lemma does not compile"
one steps
grep -q nothing "$compiled" || fail "the sample does not trust the hash, so nothing is tested here"
one all-steps
cmp -s "$compiled" "$copy/work/export/$stem.v" || fail "all-steps trusts the hash of what has been compiled"

echo "$failures failures"
exit $((failures > 0))
