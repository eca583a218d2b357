# The TOML files of a folder become part of a library, so that their names can be used anywhere: `header` declares
# struct `type` {name, text} and `const std::vector<type>& function()`, which is generated. The generated source changes
# only when one of the files does.
function(delcert_embed_files target folder header type function)
  file(GLOB files CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${folder}/*.toml)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${files})
  set(stems "")
  foreach(file IN LISTS files)
    cmake_path(GET file STEM stem)
    list(APPEND stems ${stem})
  endforeach()
  list(SORT stems)
  set(entries "")
  foreach(stem IN LISTS stems)
    file(READ ${PROJECT_SOURCE_DIR}/${folder}/${stem}.toml text)
    string(APPEND entries "    {\"${stem}\", R\"toml(${text})toml\"},\n")
  endforeach()
  set(generated ${PROJECT_BINARY_DIR}/generated/${function}.cpp)
  file(CONFIGURE OUTPUT ${generated} @ONLY CONTENT [[
#include "@header@"

namespace delcert {

const std::vector<@type@>& @function@() {
  static const std::vector<@type@> files{
@entries@  };
  return files;
}

}  // namespace delcert
]])
  target_sources(${target} PRIVATE ${generated})
endfunction()

# A text file becomes `std::string_view function()` of a library, which `header` declares.
function(delcert_embed_text target file header function)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${file})
  file(READ ${PROJECT_SOURCE_DIR}/${file} text)
  set(generated ${PROJECT_BINARY_DIR}/generated/${function}.cpp)
  file(CONFIGURE OUTPUT ${generated} @ONLY CONTENT [[
#include "@header@"

namespace delcert {

std::string_view @function@() { return R"embedded(@text@)embedded"; }

}  // namespace delcert
]])
  target_sources(${target} PRIVATE ${generated})
endfunction()
