# delcert_commit(TARGET HEADER): defines build_commit(), the commit of the sources; CMake looks again after each commit.
function(delcert_commit target header)
  set(commit "")
  find_package(Git QUIET)
  if(GIT_FOUND AND EXISTS ${PROJECT_SOURCE_DIR}/.git)
    execute_process(COMMAND ${GIT_EXECUTABLE} -C ${PROJECT_SOURCE_DIR} rev-parse HEAD
      OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    foreach(changed .git/HEAD .git/logs/HEAD)
      if(EXISTS ${PROJECT_SOURCE_DIR}/${changed})
        set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${changed})
      endif()
    endforeach()
  endif()
  set(generated ${PROJECT_BINARY_DIR}/generated/build_commit.cpp)
  file(CONFIGURE OUTPUT ${generated} @ONLY CONTENT [[
#include "@header@"

namespace delcert {

const char* build_commit() { return "@commit@"; }

}  // namespace delcert
]])
  # For ./run, which asks whether what is installed is what stands in its folder: not where there were changes besides.
  if(commit)
    execute_process(COMMAND ${GIT_EXECUTABLE} -C ${PROJECT_SOURCE_DIR} diff --quiet HEAD RESULT_VARIABLE changed)
    if(changed)
      set(commit "")
    endif()
  endif()
  file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/generated/commit @ONLY CONTENT "@commit@\n")
  target_sources(${target} PRIVATE ${generated})
  # A source of its own: it changes with each commit.
  set_source_files_properties(${generated} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON SKIP_PRECOMPILE_HEADERS ON)
endfunction()
