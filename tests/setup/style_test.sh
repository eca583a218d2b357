#!/usr/bin/env bash
# style_test.sh: the style checks of ./test find what they are there for.
set -uo pipefail
# shellcheck source=tests/setup/complaints.sh
. "$(dirname "${BASH_SOURCE[0]}")/complaints.sh"

cp "$project/.clang-format" "$project/.clang-tidy" "$work/"
"$project/cmake/check-format.sh" "$work" 2>/dev/null && fail "a folder without C++ passes"
printf 'int f() { return 1; }\n' >"$work/a.cpp"
"$project/cmake/check-format.sh" "$work" || fail "a well-formatted file does not pass"
printf 'int f( ) {return 1;}\n' >"$work/b.hpp"
"$project/cmake/check-format.sh" "$work" 2>/dev/null && fail "a badly formatted header passes"

# tidies CODE: clang-tidy with our rules on this code.
tidies() {
  printf '%s\n' "$1" >"$work/c.cpp"
  clang-tidy --quiet "$work/c.cpp" -- -std=c++20 >"$work/tidy.log" 2>&1
}
guard='struct RoundingGuard { RoundingGuard(); ~RoundingGuard(); };'
tidies "$guard int f() { const RoundingGuard guard; return 1; }" || fail "good code does not pass clang-tidy: $(cat "$work/tidy.log")"
tidies "$guard int f() { RoundingGuard(); return 1; }" && fail "a rounding guard that dies at once passes"
tidies 'int compute_It(int x) { return x; }' && fail "a badly named function passes"
tidies 'double half(int x) { return x / 2; }' && fail "a quotient of integers taken for a number passes"

# Every source of our libraries and programs is looked at by the target `tidy`; fuzz targets are tests.
cmake -S "$project" -B "$work/build" -G Ninja -D DELCERT_TESTS=ON -D DELCERT_UNITED_SOURCES=OFF >"$work/configure.log" 2>&1 ||
  fail "cannot configure: $(cat "$work/configure.log")"
looked_at=$(ninja -C "$work/build" -t query tidy | sed -n 's,^ *tidy/\(.*\)\.log$,\1,p' | sort)
sources=$(cd "$project" && find support kernel proofs properties apps -path properties/fuzz -prune -o -name '*.cpp' -print | sort)
[[ -n $sources && $looked_at == "$sources" ]] || fail "clang-tidy looks at other files:
$(diff <(echo "$sources") <(echo "$looked_at"))"

# unlisted ROOT: pages that the index of the documentation does not link to, and links of it that lead nowhere.
unlisted() {
  (cd "$1/docs" || exit
    links=$(grep -o '](\([^)#]*\)' README.md | cut -c3- | sort -u)
    comm -13 <(echo "$links") <(find . -name '*.md' ! -path './decisions/*' ! -path ./README.md | cut -c3- | sort)
    for link in $links; do [[ -e $link ]] || echo "$link is no file"; done)
}
[[ -z $(unlisted "$project") ]] || fail "docs/README.md does not list: $(unlisted "$project")"
mkdir -p "$work/pages/docs"
touch "$work/pages/docs/listed.md" "$work/pages/docs/forgotten.md"
echo '[a](listed.md) [b](gone.md)' >"$work/pages/docs/README.md"
[[ $(unlisted "$work/pages") == $'forgotten.md\ngone.md is no file' ]] || fail "the index of pages is not held to the pages"

finish
