#!/usr/bin/env bash
# slurm_test.sh PROGRAM SOURCE: a campaign in 8 tasks of an array of Slurm, two of which are killed and queued again, gives
# what a single attack gives; what is missing is named. As root, as slurmd asks for it.
set -uo pipefail
program=$(readlink -f "$1") source=$2
# What attacks is the program that delcert hands over to.
writer=$(dirname "$program")/delcert-claims
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
# shellcheck source=tests/campaigns/kill_writer.sh
. "$here/kill_writer.sh"
# shellcheck source=tests/campaigns/slurm_cluster.sh
. "$here/slurm_cluster.sh"
# install_packages is given the folder of the project.
root=$source
# shellcheck source=cmake/setup.sh
. "$source/cmake/setup.sh"
install_packages deep
work=$(mktemp -d)
trap 'stop_cluster; rm -rf "$work"' EXIT
cd "$work" || exit 1
mkdir bin
ln -s "$program" bin/delcert
export PATH=$work/bin:$PATH
fail() { echo "FAILED: $*"; tail -n 20 "$work"/cluster/*.log "$work"/*.txt 2>/dev/null; exit 1; }
job_is_over() { [[ -z $(squeue --noheader --jobs "$1" 2>/dev/null) ]]; }

start_cluster "$work/cluster" || fail "Slurm does not start"
attack=("$source/examples/claims/circumradius-below-edge.toml" --shape "2,2" --shape "6,6" --samples 40000 --seed 4)
array=$(sbatch --parsable --array=1-8 "$source/examples/campaigns/slurm-array.sh" found "${attack[@]}") || fail "sbatch"
whole=$(sbatch --parsable --dependency=afterok:"$array" --output merge.txt \
  --wrap 'delcert campaign merge found/part-*.jsonl --output found/whole.jsonl') || fail "sbatch of the merge"
kill_writer found/part-3.jsonl 25 "$writer" & third=$!
kill_writer found/part-6.jsonl 26 "$writer" & sixth=$!
wait_until 900 job_is_over "$array" || fail "the array does not end"
wait $third || fail "part 3 was not killed"
wait $sixth || fail "part 6 was not killed"
(($(grep -c '^{"writer"' found/part-3.jsonl) == 2)) || fail "part 3 did not go on"
(($(grep -c '^{"writer"' found/part-6.jsonl) == 2)) || fail "part 6 did not go on"
delcert campaign status found/part-*.jsonl
wait_until 120 job_is_over "$whole" || fail "the merge does not end"
cat merge.txt
grep -q '^coverage: blocks 0 to 319, each once; 80000 samples$' merge.txt || fail "coverage is not stated"

delcert campaign table found/whole.jsonl >table.txt
delcert attack "${attack[@]}" >single.txt
cmp table.txt single.txt || fail "another table"

# The twin: without the last block of a part the merge fails, and names it.
sed -i '$d' found/part-7.jsonl
delcert campaign merge found/part-*.jsonl --output none.jsonl 2>missing.txt
(($? == 2)) || fail "a block is missing, and the status does not say so"
cat missing.txt
grep -q 'block [0-9]* (circumradius-below-edge, .*) is missing; the first is of part 7/8' missing.txt || fail "not named"
[[ ! -e none.jsonl ]] || fail "a whole without a block"
echo "passed"
