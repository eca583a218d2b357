# Most of the time of a clean build goes into the headers of libraries, read again for every source. With the option
# they are read once a target. It is off unless asked for: what is in a precompiled header is visible in sources that
# have forgotten to include it, and compilers' caches do not like them.
option(DELCERT_PRECOMPILED_HEADERS "Read the headers of libraries once a target: quicker clean builds" OFF)

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
