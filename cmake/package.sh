#!/usr/bin/env bash
# cmake/package.sh            Debian packages and tarballs of delcert, its checker, its library and its Python module, in build/packages.
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
    install_packages python
    if [[ -e $build/build.ninja ]]; then
      configure DELCERT_PYTHON=ON
    else
      configure DELCERT_TESTS=OFF DELCERT_UNITED_SOURCES=ON DELCERT_PYTHON=ON
    fi
    build delcert delcert-publish delcert-claims delcert-check delcert-replay delcert_properties _delcert
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
