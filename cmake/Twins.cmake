# Every source has a test of the same name in the same folder of tests/, and every such test has its source:
# kernel/number/interval.hpp and tests/kernel/number/interval_test.cpp.

# Sources that are tested under another name, and why. Each line: stem, reason. A stem that has a twin must not
# stand here.
set(DELCERT_TWIN_EXEMPTIONS
  "support/error" "exception types without behaviour of their own"
  "support/progress" "the type of a callback without behaviour of its own"
  "support/toml" "the one include of toml++, tested through support/toml_reader"
  "kernel/chart/label_range" "plain data, read in kernel/ranks/part_of_net"
  "kernel/chart/atlas" "an interface, tested through flat_atlas"
  "kernel/manifold/submanifold/embedded_manifold" "an interface, tested through zero_set_evaluation and polyhedral_mesh"
  "kernel/manifold/submanifold/mesh_evaluation" "made by PolyhedralMesh, tested in polyhedral_mesh"
  "kernel/manifold/submanifold/mesh_sampler" "made by PolyhedralMesh, tested in polyhedral_mesh"
  "kernel/manifold/submanifold/triangle_mesh" "plain data, read and tested in kernel/manifold/mesh_file"
  "proofs/formula/builtin_claims" "a declaration of what is generated, read in tests/proofs/formula/claim_test.cpp"
  "proofs/errata/builtin_errata" "a declaration of what is generated, read in tests/proofs/errata/erratum_test.cpp"
  "proofs/report/page_sources" "a declaration of what is generated, read in tests/proofs/report/page_test.cpp"
  "proofs/replay/builtin_steps" "a declaration of what is generated, read in tests/proofs/replay/stated_step_test.cpp"
  "proofs/replay/main" "the program itself, run in tests/cli/prove.cmake"
  "properties/instances/instance_classes" "the list of all classes, gone through in properties/instances/instance_class_test"
  "support/build_commit" "a declaration of what is generated, read in tests/python/certificate_test.py"
  "proofs/certification/certify_options" "plain data, read in tests/proofs/certification/certification_test.cpp"
  "proofs/certification/family" "an interface, called in tests/proofs/certification/certification_test.cpp"
  "proofs/certification/chart_family" "what families have in common, run in tests/proofs/certification/certification_test.cpp"
  "proofs/certification/flat_family" "made by family_of, run in tests/proofs/certification/certification_test.cpp"
  "proofs/certification/space_form_family" "made by family_of, run in tests/proofs/certification/certification_test.cpp"
  "proofs/certification/metric_field_family" "made by family_of, run in tests/proofs/certification/certification_test.cpp"
  "proofs/certification/atlas_family" "made by family_of, run in tests/proofs/certification/certification_test.cpp"
  "proofs/certification/submanifold_family" "made by family_of, run in tests/proofs/certification/certification_test.cpp"
  "proofs/certification/mesh_family" "made by family_of_mesh, run by the programs in tests/cli/complex.cmake"
  "proofs/certificate/chunks" "compared byte for byte with another implementation in tests/checks/chunks_test.py"
  "kernel/stars/cgal_delaunay" "dimensions 2 and 3 of approximate_delaunay, tested there"
  "kernel/stars/growing_delaunay" "what the dimensions of approximate_delaunay have in common, tested there"
  "kernel/perturb/parameters" "plain data, derived and tested in proofs/certificate/run_parameters")

# Sets `result` to the list of complaints about the tree under `root`, given the exemptions (stem, reason, …).
function(delcert_twin_complaints root exemptions result)
  set(complaints)
  set(exempt)
  while(exemptions)
    list(POP_FRONT exemptions stem reason)
    list(APPEND exempt ${stem})
    if(NOT reason)
      list(APPEND complaints "cmake/Twins.cmake exempts ${stem} without a reason")
    endif()
  endwhile()

  # A script has no build to configure again.
  set(on_change CONFIGURE_DEPENDS)
  if(CMAKE_SCRIPT_MODE_FILE)
    set(on_change)
  endif()
  set(stems)
  foreach(folder support kernel proofs/constants proofs/certificate proofs/certification proofs/drawing proofs/publication proofs/report proofs/formal proofs/formula proofs/prover proofs/replay proofs/errata proofs/tables
      properties/instances properties/attack)
    file(GLOB_RECURSE sources ${on_change} RELATIVE ${root} ${root}/${folder}/*.hpp ${root}/${folder}/*.cpp)
    file(GLOB_RECURSE tests ${on_change} RELATIVE ${root}/tests ${root}/tests/${folder}/*_test.cpp)
    list(TRANSFORM sources REPLACE "\\.[ch]pp$" "")
    list(TRANSFORM tests REPLACE "_test\\.cpp$" "")
    list(REMOVE_DUPLICATES sources)
    list(APPEND stems ${sources})
    foreach(stem IN LISTS sources)
      # x_1.cpp … x_4.cpp are explicit instantiations, one dimension each, of what x.hpp declares.
      string(REGEX REPLACE "_[1-4]$" "" header ${stem})
      if(NOT header STREQUAL stem AND header IN_LIST sources)
        continue()
      endif()
      if(NOT stem IN_LIST tests AND NOT stem IN_LIST exempt)
        list(APPEND complaints "${stem} (.hpp or .cpp) has no tests/${stem}_test.cpp")
      elseif(stem IN_LIST tests AND stem IN_LIST exempt)
        list(APPEND complaints "cmake/Twins.cmake exempts ${stem}, which has its test")
      endif()
    endforeach()
    foreach(stem IN LISTS tests)
      if(NOT stem IN_LIST sources)
        list(APPEND complaints "tests/${stem}_test.cpp has neither ${stem}.hpp nor ${stem}.cpp")
      endif()
    endforeach()
  endforeach()
  foreach(stem IN LISTS exempt)
    if(NOT stem IN_LIST stems)
      list(APPEND complaints "cmake/Twins.cmake exempts ${stem}, which does not exist")
    endif()
  endforeach()
  set(${result} ${complaints} PARENT_SCOPE)
endfunction()

if(NOT CMAKE_SCRIPT_MODE_FILE)
  delcert_twin_complaints(${PROJECT_SOURCE_DIR} "${DELCERT_TWIN_EXEMPTIONS}" complaints)
  if(complaints)
    list(JOIN complaints "\n  " complaints)
    if(DELCERT_STRICT_TWINS)
      message(FATAL_ERROR "Sources and tests that miss their twin:\n  ${complaints}")
    else()
      message(STATUS "Sources and tests that miss their twin:\n  ${complaints}")
    endif()
  endif()
endif()
