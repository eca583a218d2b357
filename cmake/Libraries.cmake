# Every dependency, found in one place. None is vendored.
find_package(CGAL 5.5 REQUIRED)
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(fmt REQUIRED)
find_package(CLI11 REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(PkgConfig REQUIRED)
pkg_check_modules(tomlplusplus REQUIRED IMPORTED_TARGET GLOBAL tomlplusplus)
pkg_check_modules(zstd REQUIRED IMPORTED_TARGET GLOBAL libzstd)
pkg_check_modules(nettle REQUIRED IMPORTED_TARGET GLOBAL nettle)

# Libraries without a package file: a header to find and a library to link.
function(delcert_find_library name header library)
  find_path(${name}_INCLUDE_DIR ${header} REQUIRED)
  find_library(${name}_LIBRARY ${library} REQUIRED)
  mark_as_advanced(${name}_INCLUDE_DIR ${name}_LIBRARY)
  if(NOT TARGET delcert::${name})
    add_library(delcert::${name} UNKNOWN IMPORTED GLOBAL)
    set_target_properties(delcert::${name} PROPERTIES
      IMPORTED_LOCATION "${${name}_LIBRARY}"
      INTERFACE_INCLUDE_DIRECTORIES "${${name}_INCLUDE_DIR}")
  endif()
endfunction()
delcert_find_library(gmp gmp.h gmp)
delcert_find_library(mpfr mpfr.h mpfr)
delcert_find_library(mpfi mpfi.h mpfi)
delcert_find_library(flint flint/fmpq.h flint)
delcert_find_library(arb arb.h flint-arb)
delcert_find_library(calcium calcium/qqbar.h calcium)
