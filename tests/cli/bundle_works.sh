#!/usr/bin/env bash
# Unpacks a bundle in an empty folder and runs the commands of its README, with delcert-check as built. With a third
# argument that file of it gets a byte more before: then a command has to fail.
# bundle_works.sh BUNDLE FOLDER_OF_DELCERT_CHECK [FILE]
set -uo pipefail
bundle=$(realpath "$1") checker=$2 changed=${3-}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
cmake -E tar xf "$bundle" || exit 1
if [ -n "$changed" ]; then echo >>"$changed"; fi
mapfile -t commands < <(sed -n 's/^\$ //p' README.md)
[ "${#commands[@]}" -ge 2 ] || { echo "the README has no commands"; exit 1; }
export PATH=$checker:$PATH
for command in "${commands[@]}"; do
  bash -c "$command" >log 2>&1 || { echo "fails: $command"; exit 1; }
done
echo "${#commands[@]} commands succeed"
