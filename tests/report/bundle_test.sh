#!/usr/bin/env bash
# bundle_test.sh REPORT FRONT: page.js and page.css are what the sources give, byte for byte.
set -uo pipefail
report=$1 front=$2
failures=0
fail() {
  failures=$((failures + 1))
  echo "FAILED: $*"
}

# built FOLDER: bundles a copy of the sources in it.
built() {
  (cd "$1" && node build.js) || fail "the bundle cannot be built"
}

rm -rf "$front/page.js" "$front/page.css" "$front/src"
cp -r "$report/build.js" "$report/src" "$front/"
built "$front"
for bundle in page.js page.css; do
  cmp "$front/$bundle" "$report/$bundle" || fail "report/$bundle is not what report/src gives: npm ci --ignore-scripts && npm run build"
done

# Another source gives another bundle.
sed -i 's/delcert report/another report/' "$front/src/main.js"
sed -i 's/600px/601px/' "$front/src/page.css"
built "$front"
for bundle in page.js page.css; do
  cmp -s "$front/$bundle" "$report/$bundle" && fail "a change of the sources does not change $bundle"
done
echo "$failures failures"
exit $((failures > 0))
