#!/usr/bin/env bash
# rotating_seed_test.sh: a project without a seed of its own gets that of the day or $DELCERT_SEED, one with a seed keeps it.
set -uo pipefail
project=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failures=0
fail() {
  failures=$((failures + 1))
  echo "FAILED: $*"
}
cat >"$work/CMakeLists.txt" <<END
cmake_minimum_required(VERSION 3.25)
project(seeds LANGUAGES NONE)
list(APPEND CMAKE_MODULE_PATH $project/cmake)
enable_testing()
include(RapidCheckSeed)
add_test(NAME seed COMMAND sh -c "echo got: \$RC_PARAMS")
if(DELCERT_RAPIDCHECK_ENVIRONMENT)
  set_tests_properties(seed PROPERTIES \${DELCERT_RAPIDCHECK_ENVIRONMENT})
endif()
END
# seen PARAMETERS: what ctest prints and the test gets.
seen() {
  cmake -S "$work" -B "$work/build" -DDELCERT_RAPIDCHECK="$1" >"$work/log" 2>&1 || fail "configure: $(cat "$work/log")"
  (cd "$work/build" && ctest -V 2>&1)
}
# expect NAME TEXT OUTPUT
expect() { grep -qF "$2" <<<"$3" || fail "$1: no '$2' in $3"; }
unset RC_PARAMS DELCERT_SEED
before=$(date -u +%Y%m%d)
today=$(seen "max_success=7")
after=$(date -u +%Y%m%d)
# Unless midnight came in between.
[[ $before != "$after" ]] || {
  expect "the seed of the day" "got: seed=$before max_success=7" "$today"
  expect "the seed is printed" "RapidCheck: seed $before; DELCERT_SEED=$before repeats it" "$today"
}
expect "a seed of one's own" "got: seed=42 max_success=7" "$(DELCERT_SEED=42 seen "max_success=7")"
expect "no seed" "DELCERT_SEED=x: a number was expected" "$(DELCERT_SEED=x seen "max_success=7")"
fixed=$(DELCERT_SEED=42 seen "seed=1 max_success=7")
expect "a fixed seed" "got: seed=1 max_success=7" "$fixed"
grep -q "RapidCheck: seed" <<<"$fixed" && fail "a seed is printed that is not used"
echo "$failures failures"
exit $((failures > 0))
