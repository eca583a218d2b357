#!/usr/bin/env bash
# parallel_test.sh PROGRAM SOURCE: a campaign in 8 parts by GNU parallel, two of which are killed, gives what a single
# attack gives; what is missing is named.
set -uo pipefail
program=$(readlink -f "$1") source=$2
# What attacks is the program that delcert hands over to.
writer=$(dirname "$program")/delcert-claims
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
# shellcheck source=tests/campaigns/kill_writer.sh
. "$here/kill_writer.sh"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
mkdir bin
ln -s "$program" bin/delcert
export PATH=$work/bin:$PATH HOME=$work PARALLEL=-j2
fail() { echo "FAILED: $*"; exit 1; }

attack=("$source/examples/claims/circumradius-below-edge.toml" --shape "2,2" --shape "6,6" --samples 64000 --seed 4)
# Files that are not there cannot be killed: the killers wait for them.
kill_writer found/part-3.jsonl 4 "$writer" & third=$!
kill_writer found/part-6.jsonl 5 "$writer" & sixth=$!
bash "$source/examples/campaigns/gnu-parallel.sh" 8 found "${attack[@]}" >table.txt 2>errors.txt
status=$?
cat errors.txt
((status == 1)) || fail "status $status of a campaign that refutes a claim"
wait $third || fail "part 3 was not killed"
wait $sixth || fail "part 6 was not killed"
(($(grep -c '^{"writer"' found/part-3.jsonl) == 2)) || fail "part 3 did not go on"
grep -q '^coverage: blocks 0 to 511, each once; 128000 samples$' table.txt || fail "coverage is not stated"

delcert attack "${attack[@]}" --witnesses single >single.txt
# What the parts print, and the proof of coverage, come before the table.
sed -n '/^| claim/,$p' table.txt | sed 's|found/witnesses|single|' | cmp - single.txt || fail "another table"
cmp found/witnesses/circumradius-below-edge.radius.json single/circumradius-below-edge.radius.json || fail "another witness"

# Again: nothing is left to do, and nothing changes.
cp found/whole.jsonl before.jsonl
bash "$source/examples/campaigns/gnu-parallel.sh" 8 found "${attack[@]}" >again.txt 2>&1
cmp before.jsonl found/whole.jsonl || fail "another whole"

# The twin: without a part the merge fails, and names what is missing.
rm found/part-5.jsonl
delcert campaign merge found/part-*.jsonl --output none.jsonl 2>missing.txt && fail "a part is missing, and nobody says so"
grep -q 'block 4 (.*) is missing, and 63 others: .*; the first is of part 5/8' missing.txt || fail "$(cat missing.txt)"
[[ ! -e none.jsonl ]] || fail "a whole without a part"
echo "passed"
