# What the arithmetic rests on. Directed rounding dies silently without -frounding-math; contraction to FMA rounds
# where no enclosure reckons with it, and not on every machine. Both flags are part of the interface of every library
# here.
add_library(delcert_rigour INTERFACE)
target_compile_options(delcert_rigour INTERFACE -frounding-math -ffp-contract=off)
target_compile_features(delcert_rigour INTERFACE cxx_std_20)

# What we ask of our own code only.
add_library(delcert_warnings INTERFACE)
target_compile_options(delcert_warnings INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Wnon-virtual-dtor)
# Not where only the checker is built, by whatever compiler its user has.
option(DELCERT_WARNINGS_ARE_ERRORS "A warning ends the build" ON)
if(DELCERT_WARNINGS_ARE_ERRORS)
  target_compile_options(delcert_warnings INTERFACE -Werror)
endif()
if(CMAKE_CXX_COMPILER_ID MATCHES Clang)
  # clang 14 honours -frounding-math but warns that it may not; the start-up self-test decides.
  target_compile_options(delcert_warnings INTERFACE -Wno-unknown-warning-option)
elseif(CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  # GCC 12 sees an overlap that cannot be in "text" + std::string() at -O3 (GCC bug 105329).
  target_compile_options(delcert_warnings INTERFACE -Wno-restrict)
endif()
