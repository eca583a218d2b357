# Most of the time of a clean build goes into the headers of libraries, read again for every source: they are read once
# for the libraries and programs, and once for the tests of each kind instead. Each time takes a quarter of a gigabyte in the
# build. What is in a precompiled header is visible in sources that have forgotten to include it, so the preset `clang` does
# without. A compiler cache works better without, too.
option(DELCERT_PRECOMPILED_HEADERS "Read the headers of libraries once a target: quicker clean builds" ON)

if(DELCERT_PRECOMPILED_HEADERS AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # From a precompiled header, GCC 12 takes the standard library's strings to be ours and warns of them, wrongly.
  target_compile_options(delcert_warnings INTERFACE -Wno-stringop-overflow -Wno-stringop-overread -Wno-array-bounds)
endif()

# delcert_precompile(TARGET HEADER…): for all C++ sources of the target. Headers as in an #include, with <> or "".
function(delcert_precompile target)
  if(DELCERT_PRECOMPILED_HEADERS)
    target_precompile_headers(${target} PRIVATE ${ARGN})
  endif()
endfunction()

# delcert_precompile_like(TARGET OTHER): the same, compiled once for both, which are compiled with the same flags.
function(delcert_precompile_like target other)
  if(DELCERT_PRECOMPILED_HEADERS)
    target_precompile_headers(${target} REUSE_FROM ${other})
  endif()
endfunction()
