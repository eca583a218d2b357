# What the checker rests on, and the rest of the house too.
find_package(nlohmann_json REQUIRED)
find_package(PkgConfig REQUIRED)
pkg_check_modules(zstd REQUIRED IMPORTED_TARGET GLOBAL libzstd)
pkg_check_modules(nettle REQUIRED IMPORTED_TARGET GLOBAL nettle)

# Libraries without a package file: a header to find and a library to link, each by the first of its names that there is.
function(delcert_find_library name headers libraries)
  find_path(${name}_INCLUDE_DIR NAMES ${headers} REQUIRED)
  find_library(${name}_LIBRARY NAMES ${libraries} NAMES_PER_DIR REQUIRED)
  mark_as_advanced(${name}_INCLUDE_DIR ${name}_LIBRARY)
  if(NOT TARGET delcert::${name})
    add_library(delcert::${name} UNKNOWN IMPORTED GLOBAL)
    set_target_properties(delcert::${name} PROPERTIES
      IMPORTED_LOCATION "${${name}_LIBRARY}"
      INTERFACE_INCLUDE_DIRECTORIES "${${name}_INCLUDE_DIR}")
  endif()
endfunction()
delcert_find_library(gmp gmp.h gmp)
delcert_find_library(flint flint/fmpq.h flint)
# FLINT 3 holds what were Arb and Calcium.
delcert_find_library(arb "flint/arb.h;arb.h" "flint-arb;arb;flint")
