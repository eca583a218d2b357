#!/usr/bin/env bash
# cmake/package.sh            Debian packages and tarballs of delcert, its checker and its library, in build/packages.
# cmake/package.sh checker    those of the checker alone, which needs six libraries.
set -euo pipefail
root=$(cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/.." && pwd)
# shellcheck source=cmake/setup.sh
. "$root/cmake/setup.sh"
packages=$root/build/packages

case ${1-all} in
  all)
    install_packages run
    install_packages package
    if [[ -e $build/build.ninja ]]; then configure; else configure DELCERT_TESTS=OFF DELCERT_UNITED_SOURCES=ON; fi
    build delcert delcert-claims delcert-check delcert-replay delcert_properties
    build man
    ;;
  checker)
    install_packages check
    install_packages package
    build=$root/build/checker
    cmake -S "$root/proofs/checker" -B "$build" -G Ninja >/dev/null
    cmake --build "$build"
    cmake --build "$build" --target man
    ;;
  *)
    say "usage: cmake/package.sh [checker]"
    exit 64
    ;;
esac
mkdir -p "$packages"
(cd "$build" && cpack -B "$packages" >"$build/cpack.log" 2>&1) || { cat "$build/cpack.log" >&2; exit 70; }
rm -rf "$packages/_CPack_Packages"
(cd "$packages" && sha256sum -- *.deb *.tar.gz | tee SHA256SUMS)
