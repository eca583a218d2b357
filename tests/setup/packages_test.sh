#!/usr/bin/env bash
# The package of the checker holds a program that works where it is unpacked, its manual page and its completions; the tarball
# unpacks into one folder.
# packages_test.sh BUILD WORK
set -euo pipefail
build=$1 work=$2
rm -rf "$work"
mkdir -p "$work"
cmake --build "$build" --target manual-of-delcert-check >"$work/man.log" 2>&1 || { cat "$work/man.log"; exit 1; }
(cd "$build" && cpack -B "$work/packages" -D CPACK_COMPONENTS_ALL=checker) >"$work/cpack.log" 2>&1 || { cat "$work/cpack.log"; exit 1; }

expect() {
  local title=$1
  shift
  "$@" || { echo "FAILED: $title"; exit 1; }
}
package=$(echo "$work"/packages/delcert-check_*.deb)
dpkg-deb -x "$package" "$work/root"
version=$(cat "$(dirname "${BASH_SOURCE[0]}")/../../VERSION")
expect "the program runs" test "$("$work/root/usr/bin/delcert-check" --version)" = "$version"
for file in bin/delcert-check share/man/man1/delcert-check.1 share/bash-completion/completions/delcert-check \
  share/zsh/site-functions/_delcert-check share/doc/delcert-check/certificate-format.md share/doc/delcert-check/LICENSE; do
  expect "$file is there" test -s "$work/root/usr/$file"
done
expect "the manual page has the options" grep -q 'expect\\-manifold' "$work/root/usr/share/man/man1/delcert-check.1"
expect "nothing of the rest is there" test ! -e "$work/root/usr/bin/delcert"
depends=$(dpkg-deb --field "$package" Depends)
expect "what it is linked with is asked for" grep -q libflint <<<"$depends"
expect "nothing else is" test -z "$(tr ',' '\n' <<<"$depends" | grep -vE 'libc6|libgcc|libstdc|libgmp|libmpfr|libflint|libzstd|libnettle')"

# Every subcommand has its manual page; that of `check` is the checker's.
listed=$(sed -n '/^foreach(subcommand/,/)/p' "$(dirname "${BASH_SOURCE[0]}")/../../cmake/Install.cmake" | tr -c 'a-z' '\n')
for subcommand in $("$build/apps/delcert" --help | sed -n '/^Subcommands:/,/^$/s/^  \([a-z]\+\) .*/\1/p' | grep -v '^check$'); do
  expect "$subcommand has a manual page" grep -qx "$subcommand" <<<"$listed"
done

mkdir "$work/anywhere"
tar -C "$work/anywhere" -xzf "$work"/packages/*.tar.gz
expect "one folder" test "$(find "$work/anywhere" -mindepth 1 -maxdepth 1 | wc -l)" = 1
expect "the program runs anywhere" test "$("$work"/anywhere/*/bin/delcert-check --version)" = "$version"

# The completion of bash offers what --help lists.
offered=$(PATH=$work/root/usr/bin:$PATH bash -c '. "$1"; COMP_WORDS=(delcert-check --mem); COMP_CWORD=1; _delcert_check; echo "${COMPREPLY[*]}"' \
  _ "$work/root/usr/share/bash-completion/completions/delcert-check")
expect "an option is completed" test "$offered" = --memory-limit
rm -rf "$work"
