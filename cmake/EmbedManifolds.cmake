# The files of examples/manifolds become part of the library, so that their names can be used anywhere. The generated
# source changes only when one of them does.
function(delcert_embed_manifolds target)
  file(GLOB files CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/examples/manifolds/*.toml)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${files})
  set(stems "")
  foreach(file IN LISTS files)
    cmake_path(GET file STEM stem)
    list(APPEND stems ${stem})
  endforeach()
  list(SORT stems)
  set(entries "")
  foreach(stem IN LISTS stems)
    file(READ ${PROJECT_SOURCE_DIR}/examples/manifolds/${stem}.toml text)
    string(APPEND entries "    {\"${stem}\", R\"toml(${text})toml\"},\n")
  endforeach()
  set(generated ${PROJECT_BINARY_DIR}/generated/builtin_manifolds.cpp)
  file(CONFIGURE OUTPUT ${generated} @ONLY CONTENT [[
#include "kernel/manifold/builtin_manifolds.hpp"

namespace delcert {

const std::vector<BuiltinManifold>& builtin_manifolds() {
  static const std::vector<BuiltinManifold> manifolds{
@entries@  };
  return manifolds;
}

}  // namespace delcert
]])
  target_sources(${target} PRIVATE ${generated})
endfunction()
