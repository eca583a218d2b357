#!/usr/bin/env bash
# run.sh [--check] [NAME…]: breaks kernel/simplex in a copy of the project, one mutation at a time, and fails unless the
# property named for it fails then. --check only looks whether every mutation still fits the sources and stands in
# docs/attacks.md. TMPDIR says where the copy goes: 2 GB, and some minutes for the build and for each mutation.
#
# mutations/NAME.txt: what breaks (a comment), `file:`, `from:` and `to:` (a text that occurs once in the file, and what
# it becomes), `caught by:` (the claim whose property has to fail).
set -uo pipefail
folder=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
project=$(cd "$folder/../.." && pwd)
check_only=
[[ ${1:-} == --check ]] && { check_only=yes; shift; }
stop() {
  echo "mutations: $*" >&2
  exit 1
}

names=("$@")
if (($# == 0)); then
  for each in "$folder"/mutations/*.txt; do names+=("$(basename "$each" .txt)"); done
fi

# field NAME KEY: one line of a mutation.
field() {
  local value
  value=$(sed -n "s/^$2: //p" "$folder/mutations/$1.txt") || exit 1
  [[ -n $value ]] || stop "$1 has no '$2:'"
  printf '%s' "$value"
}

# mutated NAME TREE: the text of the file of the tree with the mutation in it.
mutated() {
  local from to text rest
  from=$(field "$1" from) && to=$(field "$1" to) || exit 1
  text=$(cat "$2/$(field "$1" file)" && echo .) || stop "$1: no such file"
  rest=${text#*"$from"}
  [[ $rest != "$text" ]] || stop "$1: its text is not in the file any more"
  [[ ${rest#*"$from"} == "$rest" ]] || stop "$1: its text is in the file more than once"
  text=${text/"$from"/"$to"}
  printf '%s' "${text%.}"
}

for name in "${names[@]}"; do
  mutated "$name" "$project" >/dev/null || exit 1
  claim=$(field "$name" 'caught by') || exit 1
  [[ -e $project/proofs/claims/$claim.toml ]] || stop "$name: there is no claim $claim"
  grep -q "^| \`$name\` | .* | \`$claim\` |\$" "$project/docs/attacks.md" || stop "docs/attacks.md does not list $name, $claim"
done
echo "${#names[@]} mutations fit the sources"
[[ -z $check_only ]] || exit 0

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
tar -C "$project" --exclude=./build --exclude=./.git -cf - . | tar -C "$work" -xf - || stop "cannot copy the project"
tests=$work/build/release/tests/test_properties_property
build() { ninja -C "$work/build/release" test_properties_property >"$work/build.log" 2>&1; }
# falsified CLAIM: status 0 if the property of this claim fails by an instance, 1 if it holds.
falsified() {
  RC_PARAMS="seed=1 max_success=100" timeout 900 "$tests" --gtest_filter="Claims/EveryClaim.holds*/${1//-/_}" \
    >"$work/run.log" 2>&1
  case $? in
    0) grep -q '^\[  PASSED  \] 1 test' "$work/run.log" || stop "there is no property of $1" ;;
    1) grep -q '^Falsifiable' "$work/run.log" || stop "the property of $1 fails without an instance" && return 0 ;;
    *) stop "the property of $1 comes to no end" ;;
  esac
  return 1
}

if ! (cd "$work" && cmake --preset release -DDELCERT_TESTS=ON) >"$work/build.log" 2>&1 || ! build; then
  tail -n 20 "$work/build.log"
  stop "the project does not build as it is"
fi
for claim in $(for name in "${names[@]}"; do field "$name" 'caught by' && echo; done | sort -u); do
  falsified "$claim" && stop "the property of $claim fails without any mutation"
done

failures=0
for name in "${names[@]}"; do
  claim=$(field "$name" 'caught by')
  file=$work/$(field "$name" file)
  cp -p "$file" "$work/original"
  mutated "$name" "$work" >"$work/broken" && cp "$work/broken" "$file"
  if ! build; then
    failures=$((failures + 1))
    echo "FAILED: $name does not build"
    tail -n 5 "$work/build.log"
  elif falsified "$claim"; then
    echo "caught: $name by the property of $claim"
  else
    failures=$((failures + 1))
    echo "FAILED: $name: the property of $claim holds nevertheless"
  fi
  cp "$work/original" "$file"  # with a new time, so that it is built again
done
echo "${#names[@]} mutations, $failures not caught"
exit $((failures > 0))
