#!/usr/bin/env bash
# gnu-parallel.sh PARTS FOLDER CERTIFICATE
#
# Checks a certificate in parts by GNU parallel, for example
#   gnu-parallel.sh 8 receipts poincare.json.zst
# The receipts are in FOLDER. A part that is killed is done again, at most three times; after an interruption the same
# command does only the parts without a receipt of this certificate. How many parts run at a time, and on which machines
# (which share FOLDER), is what the environment variable PARALLEL says: "-j4", "--sshlogin one,two".
# The exit status is that of `delcert-check --merge`.
set -euo pipefail
parts=$1 folder=$2 certificate=$3
mkdir -p "$folder"
# A receipt is there as a whole or not at all; one that is in the way, of another certificate or checker, goes.
for ((k = 1; k <= parts; k++)); do
  receipt=$folder/$k-of-$parts.json
  [[ -e $receipt ]] || continue
  status=0
  said=$(delcert-check --merge "$receipt" "$certificate" 2>&1) || status=$?
  if ((status == 3)); then
    echo "$receipt is done again: $said" >&2
    rm "$receipt"
  fi
done
# Status 1 or 2: a part that is rejected or undecided has a receipt too, and would be so again.
parallel --quote --retries 3 --joblog "$folder/parts.txt" bash -c '
  [[ -e $3/$1-of-$2.json ]] && exit 0
  status=0
  delcert-check --quiet "$4" --part "$1/$2" --receipt "$3/$1-of-$2.json" || status=$?
  ((status < 3)) && [[ -e $3/$1-of-$2.json ]]' \
  part {} "$parts" "$folder" "$certificate" ::: $(seq "$parts") || true
receipts=()
for ((k = 1; k <= parts; k++)); do
  if [[ -e $folder/$k-of-$parts.json ]]; then receipts+=("$folder/$k-of-$parts.json"); fi
done
exec delcert-check --merge "${receipts[@]}" "$certificate"
