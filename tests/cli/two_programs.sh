#!/usr/bin/env bash
# two_programs.sh CASE DELCERT: delcert and delcert-claims, beside it, are one program to their users.
set -uo pipefail
case=$1 delcert=$2 claims=$2-claims
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

case $case in
  help) diff <("$delcert" --help) <("$claims" --help) && diff <("$delcert" attack --help) <("$claims" attack --help) && echo "the same" ;;
  process)
    "$delcert" attack --all --samples 1000000 --threads 1 >"$folder/output" 2>&1 &
    process=$!
    for _ in $(seq 600); do
      if [[ $(readlink "/proc/$process/exe") == */delcert-claims ]]; then echo "the same process"; break; fi
      sleep 0.1
    done
    kill -9 "$process"
    wait "$process" 2>/dev/null
    true
    ;;
  alone)
    # A folder where ./run has built the first only.
    cp "$delcert" "$folder/delcert"
    "$folder/delcert" manifolds torus-2 --names || exit 99
    "$folder/delcert" claims
    ;;
esac
