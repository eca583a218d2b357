#!/usr/bin/env bash
# packages.sh REPORT FRONT: the npm packages that report/package-lock.json lists, in FRONT/node_modules; nothing is done twice.
set -euo pipefail
report=$1 front=$2
mkdir -p "$front"
if [[ -d $front/node_modules ]] && cmp -s "$report/package-lock.json" "$front/installed.json"; then exit 0; fi
cp "$report/package.json" "$report/package-lock.json" "$front/"
cd "$front"
npm ci --ignore-scripts --no-audit --no-fund
cp package-lock.json installed.json
