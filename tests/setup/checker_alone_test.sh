#!/usr/bin/env bash
# The checker builds from what is in a bundle, as the README there says, and the program checks.
# checker_alone_test.sh SOURCE WORK COMPILER DELCERT
set -euo pipefail
source=$1 work=$2 compiler=$3 delcert=$4
rm -rf "$work"
mkdir -p "$work"
"$delcert" certify --manifold torus-2 --radius 1/24 --seed 1 --output "$work/torus.json" >/dev/null
"$delcert" bundle "$work/torus.json" --title Torus --author "Doe, Jane" --output "$work/bundle.zip" >/dev/null
cd "$work"
cmake -E tar xf bundle.zip
sha256sum --quiet -c SHA256SUMS
command=$(sed -n 's/^    \(cmake .*\)/\1/p' README.md)
[[ $command == "cmake -S checker/proofs/checker "* ]] || { echo "the README does not say how the checker is built"; exit 1; }

# Whether it builds and is right, not how quick it is.
CXX=$compiler CMAKE_BUILD_TYPE=None CMAKE_GENERATOR=Ninja CXXFLAGS=-O0 bash -c "set -e; $command; command -v delcert-check" \
  >"$work/build.log" 2>&1 || { tail -n 40 "$work/build.log"; exit 1; }
tail -n 1 "$work/build.log" | grep -qx "$work/build/delcert-check" || { echo "the README's command leads to another checker"; exit 1; }

"$work/build/delcert-check" "$work/torus.json" | grep -q '^verified: levels 0 1 2 2s 3 4 5 6 ' || { echo "does not verify"; exit 1; }
sed 's/"seed":"1"/"seed":"2"/' "$work/torus.json" >"$work/forged.json"
status=0
"$work/build/delcert-check" "$work/forged.json" >/dev/null || status=$?
[[ $status == 3 ]] || { echo "verifies what is forged: $status"; exit 1; }
[[ $("$work/build/delcert-check" --version) == "$(cat "$source/VERSION")" ]] || { echo "another version"; exit 1; }

# Six libraries besides the compiler: gmp, flint, arb, zstd, nettle, and nlohmann-json, which is headers.
readelf -d "$work/build/delcert-check" | sed -n 's/.*(NEEDED).*\[\(.*\)\]/\1/p' >"$work/linked"
if grep -vE '^lib(c|m|gcc_s|stdc\+\+|gmp|flint|flint-arb|arb|zstd|nettle)\.so' "$work/linked"; then
  echo "is linked with what it should not need"
  exit 1
fi
grep -q libflint "$work/linked" || { echo "is not seen to be linked at all"; exit 1; }
rm -rf "$work"
