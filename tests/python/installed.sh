#!/usr/bin/env bash
# installed.sh BUILD WORK PYTHON: the module works where `cmake --install` puts it, and finds the checker that is installed with it;
# without the shared object it cannot be imported.
set -euo pipefail
build=$1 work=$2 python=$3
rm -rf "$work"
for component in python checker; do
  cmake --install "$build" --component "$component" --prefix "$work/usr" >"$work.log" 2>&1 || { cat "$work.log"; exit 1; }
done
cd /
imports() {
  PYTHONPATH=$work/usr/lib/python3/dist-packages "$python" -c 'import delcert.checking; print(delcert.checking.checker(), delcert.manifold.torus_2)' 2>&1
}
found=$(imports)
[[ $found == "$work/usr/bin/delcert-check torus-2" ]] || { echo "FAILED: $found"; exit 1; }
[[ -z $(find "$work/usr" -name '__pycache__') ]] || { echo "FAILED: compiled files are installed"; exit 1; }
rm "$work"/usr/lib/python3/dist-packages/_delcert.*.so
if found=$(imports); then echo "FAILED: without the shared object: $found"; exit 1; fi
rm -rf "$work"
