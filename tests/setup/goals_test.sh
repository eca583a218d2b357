#!/usr/bin/env bash
# The aims of docs/performance.md are told as they were measured: the table is that of bench/goals.json, changed ones are noticed,
# and a line is bold only where the aim is met.
set -uo pipefail
# shellcheck source=tests/setup/complaints.sh
. "$(dirname "${BASH_SOURCE[0]}")/complaints.sh"

"$project/bench/goals.py" check || fail "the table of aims is stale: bench/goals.py render"

copy() {
  rm -rf "$work/copy"
  mkdir -p "$work/copy/bench" "$work/copy/docs"
  cp "$project/docs/performance.md" "$work/copy/docs/"
  cp "$project/bench/goals.json" "$project/bench/costs.json" "$work/copy/bench/"
}

# changed TITLE FILE EXPRESSION: a copy with one change in a file must be refused.
changed() {
  copy
  sed -i "$3" "$work/copy/$2"
  ! cmp -s "$work/copy/$2" "$project/$2" || fail "$1: nothing was changed"
  "$project/bench/goals.py" check --root "$work/copy" >"$work/log" 2>&1 && fail "$1 passes"
  grep -q "performance.md" "$work/log" || fail "$1: it says $(cat "$work/log")"
}
changed "a figure changed by hand" docs/performance.md '/<!-- goals -->/,/<!-- goals: end -->/s/ | [0-9]\+ | \([0-9.]*\) |$/ | 99 | \1 |/'
changed "another measurement" bench/goals.json '0,/"load": [0-9.]*/s//"load": 77/'
changed "a page without its place" docs/performance.md 's/<!-- goals -->//'

# Lines that were measured with these programs are not those of others.
copy
PYTHONPATH=$project/bench python3 - "$work/copy/bench" <<'END' || fail "the record has no programs"
import json, sys
import costs
folder = sys.argv[1]
identity = costs.identity_of(json.load(open(f"{folder}/costs.json")))
record = json.load(open(f"{folder}/goals.json"))
for one in record.values():
    one["programs"] = identity
json.dump(record, open(f"{folder}/goals.json", "w"))
END
"$project/bench/goals.py" render --root "$work/copy"
"$project/bench/goals.py" check --root "$work/copy" >/dev/null || fail "lines of these programs are not"
sed -i 's/"content": "/"content": "0/' "$work/copy/bench/costs.json"
"$project/bench/goals.py" check --root "$work/copy" >/dev/null && fail "other programs pass"

# A median on the wrong side of what is asked is not bold, one on the right side is.
copy
python3 - "$work/copy/bench/goals.json" <<'END' || fail "the record has no such lines"
import json, sys
record = json.load(open(sys.argv[1]))
for name, figure in (("cgal", 1000.0), ("check torus-2", 0.001), ("threads attack", 0.5)):
    record[name]["figures"] = [figure] * 5
json.dump(record, open(sys.argv[1], "w"))
END
"$project/bench/goals.py" render --root "$work/copy"
grep -q "periodic triangulation.* | 1000 |" "$work/copy/docs/performance.md" || fail "an aim that is missed is not told"
grep -qF '| **0.001** |' "$work/copy/docs/performance.md" || fail "an aim that is met is not bold"
grep -q "attack on.* | 0.5 |" "$work/copy/docs/performance.md" || fail "a speed-up that is missed is not told"

# Certified : plain doubles of a curved run is the ratio of what two programs say of the same points.
mkdir -p "$work/build/bench"
# says PROGRAM KERNEL POINTS SECONDS: it takes one second more than that.
says() {
  printf '#!/bin/sh\necho '"'"'{"kernel": "%s", "points": %s, "levels 1, 2, 4": true, "seconds": {"net": 1, "perturb": %s}}'"'"'\n' \
    "$2" "$3" "$4" >"$work/build/bench/$1"
  chmod +x "$work/build/bench/$1"
}
ratio() {
  PYTHONPATH=$project/bench python3 -c '
import pathlib, sys
import goals
print(goals.curved_beside_plain_doubles("sphere-2", "1/84")(pathlib.Path(sys.argv[1])))' "$work/build" 2>"$work/log"
}
says curved_certified certified 100 2
says curved_plain "plain doubles" 100 1
[[ $(ratio) == 1.5 ]] || fail "3 seconds to 2 are $(ratio)"
says curved_plain "plain doubles" 101 1
ratio >/dev/null && fail "other points pass"
grep -q "100 points, with doubles 101" "$work/log" || fail "other points: it says $(cat "$work/log")"
says curved_plain certified 100 1
ratio >/dev/null && fail "intervals pass for doubles"

# Export : certify is that of the slowest format.
slowest() {
  PYTHONPATH=$project/bench python3 -c '
import pathlib
import costs, goals
seconds = {"certify": 2.0, "gmsh": 0.5}
costs.timed = lambda command: ("{\"points\": 5}", {"user": next((seconds[word] for word in command if word in seconds), 0.25)})
print(goals.export_beside_certify("torus-2", "1/100", 1)(pathlib.Path("build")))'
}
[[ $(slowest) == 0.25 ]] || fail "half a second to two is $(slowest)"

finish
