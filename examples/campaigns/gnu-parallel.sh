#!/usr/bin/env bash
# gnu-parallel.sh PARTS FOLDER CLAIM… [OPTION…]
#
# A campaign in parts by GNU parallel, for example
#   gnu-parallel.sh 8 found --all --samples 10000 --seed 1
# The parts' logs, the whole and the witnesses are in FOLDER. A part that is killed goes on from its log, at most three
# times; after an interruption the same command goes on from all logs. How many parts run at a time, and on which
# machines (which share FOLDER), is what the environment variable PARALLEL says: "-j4", "--sshlogin one,two".
# The exit status is that of `delcert campaign table`, or 70 if a part or the merge failed.
set -euo pipefail
parts=$1 folder=$2
shift 2
mkdir -p "$folder"
parallel --quote --retries 3 --joblog "$folder/parts.txt" \
  delcert attack "$@" --threads 1 --part "{}/$parts" --log "$folder/part-{}.jsonl" \
  ::: $(seq "$parts") || exit 70
delcert campaign merge "$folder"/part-*.jsonl --output "$folder/whole.jsonl" || exit 70
exec delcert campaign table "$folder/whole.jsonl" --witnesses "$folder/witnesses"
