#!/usr/bin/env bash
# costs_test.sh BUILD: the tables of costs are those that were measured with these programs, and tables that are not are
# noticed.
set -uo pipefail
# shellcheck source=tests/setup/complaints.sh
. "$(dirname "${BASH_SOURCE[0]}")/complaints.sh"
build=$1

# The programs are the same each time, so what they count is, too.
counts=$work/counts.json
"$project/bench/costs.py" check --build "$build" --counts "$counts" || fail "the tables are stale: bench/costs.py measure"

# changed TITLE FILE PATTERN SAYS: a copy of the pages and the record, with one change in a file, must be refused.
changed() {
  rm -rf "$work/copy"
  mkdir -p "$work/copy/bench" "$work/copy/docs"
  cp "$project/README.md" "$work/copy/"
  cp "$project"/docs/{performance,space-forms,submanifolds,atlases}.md "$work/copy/docs/"
  cp "$project/bench/costs.json" "$work/copy/bench/"
  sed -i "$3" "$work/copy/$2"
  ! cmp -s "$work/copy/$2" "$project/$2" || fail "$1: nothing was changed"
  local output
  output=$("$project/bench/costs.py" check --build "$build" --counts "$counts" --root "$work/copy") && fail "$1 passes"
  [[ $output == *"$4"* ]] || fail "$1: it says $output"
}
changed "a figure changed by hand" README.md '/costs: readme-tori/,/costs: end/s/ s |/0 s |/' "README.md: a table is not that of"
changed "a margin of a member" docs/space-forms.md '/costs: members -->/,/costs: end/s/| Z, 0, Z |/| Z, Z, Z |/' "space-forms.md: a table is not that"
changed "a margin of an atlas" docs/atlases.md '/costs: atlases -->/,/costs: end/s/| 0.702 |/| 0.701 |/' "atlases.md: a table is not that"
changed "a table without its mark" docs/performance.md 's/<!-- costs: sizes -->//' "the table sizes stands nowhere"
changed "other decisions" bench/costs.json '0,/"perturb": [0-9]*,$/s//"perturb": 7,/' "the tables are older than the programs"
changed "other decisions of the checker" bench/costs.json '0,/"intervals": [0-9]*/s//"intervals": 7/' "check/decisions/intervals: recorded 7"
changed "other points" bench/costs.json '0,/"content": "[0-9a-f]/s//"content": "x/' "content: recorded x"

finish
