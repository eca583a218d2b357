#!/usr/bin/env bash
# parallel_test.sh DELCERT CHECKER SOURCE: a certificate checked in 4 parts by GNU parallel, one of which is killed and done
# again, gives what one check gives; what is missing, rejected or of another certificate is named.
set -uo pipefail
delcert=$(readlink -f "$1") program=$(readlink -f "$2") source=$3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
mkdir bin
# Kills the first check of part 3 as soon as it has begun, and counts all checks.
cat >bin/delcert-check <<END
#!/usr/bin/env bash
echo "\$*" >>"$work/calls.txt"
if [[ "\$*" == *"--part 3/4"* && ! -e "$work/killed.txt" ]]; then
  "$program" "\$@" &
  checker=\$!
  until [[ -n \$(cat /proc/\$checker/task/\$checker/children) ]]; do
    kill -0 \$checker || exit 70
  done
  kill -9 \$checker
  wait \$checker
  status=\$?
  echo \$status >"$work/killed.txt"
  exit \$status
fi
exec "$program" "\$@"
END
chmod +x bin/delcert-check
export PATH=$work/bin:$PATH HOME=$work PARALLEL=-j2
fail() { echo "FAILED: $*"; exit 1; }
script=$source/examples/checks/gnu-parallel.sh
without_times() { sed 's/  \[[0-9.]* s\]$//' "$1"; }

"$delcert" certify --manifold torus-2 --radius 1/100 --seed 1 --output torus.json.zst >certify.txt || fail "certify"
"$program" torus.json.zst >single.txt || fail "a check of the whole"
bash "$script" 4 receipts torus.json.zst >merged.txt 2>errors.txt || fail "status $?: $(cat merged.txt errors.txt)"
[[ $(cat killed.txt) == 137 ]] || fail "part 3 was not killed"
(($(grep -c -- '--part 3/4' calls.txt) == 2)) || fail "part 3 was not done again"
grep -q '^verified: levels 0 1 2 2s 3 4 5 6 ' merged.txt || fail "not verified: $(cat merged.txt)"
cmp <(without_times merged.txt) <(without_times single.txt) || fail "another report"
compgen -G 'receipts/*.part' && fail "a part of a receipt"

# Again: no part is done twice.
: >calls.txt
bash "$script" 4 receipts torus.json.zst >again.txt 2>&1 || fail "again: $(cat again.txt)"
grep -q -- '--part' calls.txt && fail "parts are done again: $(cat calls.txt)"

# The twins: a receipt that is missing, one of another certificate, a certificate that is wrong in one part.
"$program" --merge receipts/[134]-of-4.json torus.json.zst >missing.txt 2>&1
(($? == 2)) || fail "a part is missing, and nobody says so"
grep -q 'merge.missing: what lies between 1/4 and 2/4 of each loop is missing$' missing.txt || fail "$(cat missing.txt)"
grep -q verified missing.txt && fail "verified without a part"

"$delcert" certify --manifold torus-2 --radius 1/100 --seed 2 --output other.json.zst >certify.txt || fail "certify"
"$program" other.json.zst >single.txt || fail "a check of the other"
bash "$script" 4 receipts other.json.zst >merged.txt 2>errors.txt || fail "$(cat errors.txt)"
(($(grep -c 'is done again: .*merge.certificate' errors.txt) == 4)) || fail "receipts of another certificate stay: $(cat errors.txt)"
cmp <(without_times merged.txt) <(without_times single.txt) || fail "another report of the other"

zstd -qdc torus.json.zst >wrong.json || fail "zstd"
python3 - <<'END' || fail "python3"
import hashlib, re
text = open('wrong.json').read()
# Point 0 is moved by a little more than its perturbation may be.
at = text.index('"points":[[') + len('"points":[["')
end = text.index('"', at)
text = text[:at] + '1/3' + text[end:]
content = text[:text.rindex(',"sha256":"')]
open('wrong.json', 'w').write(content + ',"sha256":"' + hashlib.sha256(content.encode()).hexdigest() + '"}\n')
END
bash "$script" 4 wrong wrong.json >rejected.txt 2>&1
(($? == 1)) || fail "a wrong certificate: $(cat rejected.txt)"
grep -q '^rejected, part 1/4: levels' rejected.txt || fail "$(cat rejected.txt)"
grep -q verified rejected.txt && fail "a wrong certificate is verified"
echo "passed"
