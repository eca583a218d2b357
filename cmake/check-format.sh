#!/usr/bin/env bash
# check-format.sh [FOLDER]: fails if clang-format would change a C++ file of the project (of the folder) or finds none.
set -euo pipefail
cd "${1:-$(dirname "${BASH_SOURCE[0]}")/..}"
mapfile -d '' -t files < <(find . \( -name build -o -name .git \) -prune -o \( -name '*.cpp' -o -name '*.hpp' \) -print0)
((${#files[@]} > 0)) || { echo "no C++ files in $PWD" >&2; exit 1; }
clang-format --dry-run --Werror --style=file "${files[@]}"
