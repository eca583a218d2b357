#!/usr/bin/env bash
# two_programs.sh CASE DELCERT: delcert, and the three programs beside it, are one program to their users.
set -uo pipefail
case=$1 delcert=$2 certify=$2-certify publish=$2-publish claims=$2-claims
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

case $case in
  help)
    diff <("$delcert" --help) <("$claims" --help) && diff <("$delcert" --help) <("$publish" --help) && diff <("$delcert" --help) <("$certify" --help) &&
      diff <("$delcert" attack --help) <("$claims" attack --help) && diff <("$delcert" export --help) <("$claims" export --help) && echo "the same"
    ;;
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
    cp "$delcert" "$certify" "$folder"
    "$folder/delcert" manifolds torus-2 --names || exit 99
    "$folder/delcert" claims
    ;;
  alone-publishing)
    cp "$delcert" "$certify" "$folder"
    "$folder/delcert" manifolds torus-2 --names || exit 99
    "$folder/delcert" cite
    ;;
  alone-in-front)
    cp "$delcert" "$publish" "$folder"
    "$folder/delcert" cite --format bibtex >/dev/null || exit 99
    ln -s "$folder/delcert" "$folder/link"
    "$folder/link" --version
    ;;
  libraries)
    # What is called at every start is worth nothing if it starts as slowly as the programs behind it.
    readelf -d "$delcert" | sed -n 's/.*(NEEDED).*\[\(.*\)\]/\1/p'
    ;;
  without-claims)
    # A witness is handed over twice, and the second program is the one that is missing.
    cp "$delcert" "$certify" "$publish" "$folder"
    printf '{"delcert_witness": 1}' >"$folder/witness.json"
    "$folder/delcert" figure "$folder/witness.json" --output "$folder/witness.svg"
    ;;
esac
