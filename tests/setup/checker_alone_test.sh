#!/usr/bin/env bash
# The checker's sources build without the rest of the house, and the program checks.
# checker_alone_test.sh SOURCE WORK COMPILER DELCERT
set -euo pipefail
source=$1 work=$2 compiler=$3 delcert=$4
rm -rf "$work"
mkdir -p "$work/proofs" "$work/docs"
cp -r "$source/proofs/checker" "$work/proofs/"
cp -r "$source/cmake" "$source/VERSION" "$source/LICENSE" "$work/"
cp "$source/docs/certificate-format.md" "$work/docs/"

# Whether it builds and is right, not how quick it is.
cmake -S "$work/proofs/checker" -B "$work/build" -D CMAKE_CXX_COMPILER="$compiler" -D CMAKE_BUILD_TYPE=None -G Ninja \
  -D CMAKE_CXX_FLAGS=-O0 >"$work/configure.log" 2>&1 || { cat "$work/configure.log"; exit 1; }
cmake --build "$work/build" >"$work/build.log" 2>&1 || { tail -n 40 "$work/build.log"; exit 1; }

"$delcert" certify --manifold torus-2 --radius 1/24 --seed 1 --output "$work/torus.json" >/dev/null
"$work/build/delcert-check" "$work/torus.json" | grep -q '^verified: levels 0 1 2 2s 3 4 5 6 ' || { echo "does not verify"; exit 1; }
sed 's/"seed":"1"/"seed":"2"/' "$work/torus.json" >"$work/forged.json"
status=0
"$work/build/delcert-check" "$work/forged.json" >/dev/null || status=$?
[[ $status == 3 ]] || { echo "verifies what is forged: $status"; exit 1; }
[[ $("$work/build/delcert-check" --version) == "$(cat "$source/VERSION")" ]] || { echo "another version"; exit 1; }

# Six libraries beside the compiler: gmp, flint, arb, zstd, nettle, and nlohmann-json, which is headers.
readelf -d "$work/build/delcert-check" | sed -n 's/.*(NEEDED).*\[\(.*\)\]/\1/p' >"$work/linked"
if grep -vE '^lib(c|m|gcc_s|stdc\+\+|gmp|flint|flint-arb|arb|zstd|nettle)\.so' "$work/linked"; then
  echo "is linked with what it should not need"
  exit 1
fi
grep -q libflint "$work/linked" || { echo "is not seen to be linked at all"; exit 1; }
rm -rf "$work"
