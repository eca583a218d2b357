# shellcheck shell=bash
# For tests that are scripts and count what is wrong: the folder `project`, an empty folder `work` that goes away at the
# end, fail, and finish as the last line.
project=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failures=0

# fail WHAT…: counts a failure, and says what it is.
fail() {
  failures=$((failures + 1))
  echo "FAILED: $*"
}

# finish: says how many there were; the exit status is 1 if there was one.
finish() {
  echo "$failures failures"
  exit $((failures > 0))
}
