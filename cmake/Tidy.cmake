# The target `tidy`: clang-tidy over every source of our libraries and programs (their headers with them), one
# command each, so that Ninja runs them in parallel and repeats only those whose object file is older than a change
# of the source, of a header that it includes, or of .clang-tidy. Not where sources are compiled together.

# Sets `result` to the libraries and programs defined in `folder` and below.
function(delcert_targets_below folder result)
  get_property(targets DIRECTORY ${folder} PROPERTY BUILDSYSTEM_TARGETS)
  get_property(below DIRECTORY ${folder} PROPERTY SUBDIRECTORIES)
  foreach(subfolder IN LISTS below)
    delcert_targets_below(${subfolder} more)
    list(APPEND targets ${more})
  endforeach()
  set(${result} ${targets} PARENT_SCOPE)
endfunction()

find_program(DELCERT_CLANG_TIDY clang-tidy)
mark_as_advanced(DELCERT_CLANG_TIDY)
if(NOT DELCERT_CLANG_TIDY OR DELCERT_UNITED_SOURCES)
  return()
endif()

# The compile commands may be GCC's, with warnings that clang does not know and with precompiled headers that clang
# cannot read: it gets a copy without them.
file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/tidy)
set(commands ${PROJECT_BINARY_DIR}/tidy/compile_commands.json)
add_custom_command(OUTPUT ${commands}
  COMMAND sh -c "sed 's, -Winvalid-pch -include [^ ]*/cmake_pch[.]hxx,,' \
'${PROJECT_BINARY_DIR}/compile_commands.json' >'${commands}'"
  DEPENDS ${PROJECT_BINARY_DIR}/compile_commands.json VERBATIM)
set(stamps)
foreach(folder support kernel proofs properties apps)
  delcert_targets_below(${PROJECT_SOURCE_DIR}/${folder} targets)
  foreach(target IN LISTS targets)
    get_target_property(type ${target} TYPE)
    if(NOT type MATCHES "STATIC_LIBRARY|OBJECT_LIBRARY|EXECUTABLE")
      continue()
    endif()
    get_target_property(sources ${target} SOURCES)
    get_target_property(source_folder ${target} SOURCE_DIR)
    get_target_property(binary_folder ${target} BINARY_DIR)
    foreach(source IN LISTS sources)
      cmake_path(ABSOLUTE_PATH source BASE_DIRECTORY ${source_folder} NORMALIZE)
      cmake_path(IS_PREFIX source_folder ${source} ours)
      if(NOT source MATCHES "\\.cpp$" OR NOT ours)
        continue()
      endif()
      cmake_path(RELATIVE_PATH source BASE_DIRECTORY ${source_folder} OUTPUT_VARIABLE local)
      cmake_path(RELATIVE_PATH source BASE_DIRECTORY ${PROJECT_SOURCE_DIR} OUTPUT_VARIABLE name)
      set(stamp ${PROJECT_BINARY_DIR}/tidy/${name}.log)
      if(stamp IN_LIST stamps)  # built twice, with other definitions
        continue()
      endif()
      cmake_path(GET stamp PARENT_PATH stamp_folder)
      file(MAKE_DIRECTORY ${stamp_folder})
      add_custom_command(OUTPUT ${stamp}
        COMMAND sh -c "'${DELCERT_CLANG_TIDY}' --quiet -p '${PROJECT_BINARY_DIR}/tidy' \
--extra-arg=-Wno-unknown-warning-option '${source}' >'${stamp}.new' 2>&1 \
|| { cat '${stamp}.new'; exit 1; }; mv '${stamp}.new' '${stamp}'"
        DEPENDS ${commands} ${binary_folder}/CMakeFiles/${target}.dir/${local}.o ${PROJECT_SOURCE_DIR}/.clang-tidy
        COMMENT "clang-tidy ${name}" VERBATIM)
      list(APPEND stamps ${stamp})
    endforeach()
  endforeach()
endforeach()
add_custom_target(tidy DEPENDS ${stamps})
