# Half of what a compiler does for a source of ours, it does for others, too: it reads the same headers and instantiates
# the same templates. So several sources are compiled as one where all is built once: ./run and ./test. It is off
# otherwise, since a change of one source then compiles its neighbours, and clang-tidy reads them one by one.
option(DELCERT_UNITED_SOURCES "Compile several sources as one: quicker clean builds" OFF)
if(DELCERT_UNITED_SOURCES AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # GCC takes the sources that are compiled as one to be headers, whose unnamed namespaces it warns of.
  target_compile_options(delcert_warnings INTERFACE -Wno-subobject-linkage)
endif()

# delcert_unite(TARGET NUMBER): so many of the target's sources at a time, 0: all. What is in their unnamed namespaces
# has different names. Not for what rounding is the essence of: the arithmetic is compiled as it is read.
# Tests have a namespace DELCERT_THIS_FILE in the place of an unnamed one: another one for each file where files are
# united, the unnamed one elsewhere. So two tests may have helpers of the same name.
function(delcert_unite target number)
  if(DELCERT_UNITED_SOURCES)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${number}
      UNITY_BUILD_UNIQUE_ID DELCERT_THIS_FILE)
  endif()
endfunction()

# delcert_unite_by_folder(TARGETS SOURCES): the sources of a folder as one; not the arithmetic, which is compiled as it is read,
# nor the files for one dimension each, which take the longest, nor what needs flags of its own, nor what GCC 12 warns of
# wrongly in company.
function(delcert_unite_by_folder targets sources)
  if(NOT DELCERT_UNITED_SOURCES)
    return()
  endif()
  set_target_properties(${targets} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  foreach(source IN LISTS sources)
    get_filename_component(folder "${source}" DIRECTORY)
    get_filename_component(folder "${folder}" NAME)
    if(folder AND NOT folder MATCHES "^(number|parallel)$" AND NOT source MATCHES "(_[1-4]|/metric_field_file)[.]cpp$")
      set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${folder})
    endif()
  endforeach()
endfunction()
