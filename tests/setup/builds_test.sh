#!/usr/bin/env bash
# What building costs is said as it was measured: the table of docs/performance.md and what ./run reads are those of
# bench/builds.json, and changed ones are noticed.
set -uo pipefail
# shellcheck source=tests/setup/complaints.sh
. "$(dirname "${BASH_SOURCE[0]}")/complaints.sh"

"$project/bench/builds.py" check || fail "the table of builds is stale: bench/builds.py render"

# changed TITLE FILE PATTERN SAYS: a copy with one change in a file must be refused.
changed() {
  rm -rf "$work/copy"
  mkdir -p "$work/copy/bench" "$work/copy/docs" "$work/copy/cmake"
  cp "$project/docs/performance.md" "$work/copy/docs/"
  cp "$project/bench/builds.json" "$work/copy/bench/"
  cp "$project/cmake/build-costs.tsv" "$work/copy/cmake/"
  "$project/bench/builds.py" check --root "$work/copy" >"$work/log" || fail "$1: the copy is refused before the change"
  sed -i "$3" "$work/copy/$2"
  ! cmp -s "$work/copy/$2" "$project/$2" || fail "$1: nothing was changed"
  "$project/bench/builds.py" check --root "$work/copy" >"$work/log" 2>&1 && fail "$1 passes"
  grep -q "$4" "$work/log" || fail "$1: it says $(cat "$work/log")"
}
changed "a figure changed by hand" docs/performance.md '/<!-- builds -->/,/<!-- builds: end -->/s/| [0-9]\+ |$/| 1 |/' "docs/performance.md: not what"
changed "what ./run reads" cmake/build-costs.tsv 's/^delcert .*/delcert 1 1/' "cmake/build-costs.tsv: not what"
changed "another measurement" bench/builds.json '0,/"processor": [0-9]*/s//"processor": 7/' "docs/performance.md: not what"
changed "a page without its place" docs/performance.md 's/<!-- builds -->//' "has 0 places for the table"

# What a first ./run says is of that file.
grep -qE '^delcert [0-9]+ [0-9]+$' "$project/cmake/build-costs.tsv" || fail "cmake/build-costs.tsv has no line of delcert"

finish
