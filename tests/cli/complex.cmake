# delcert certify --complex: the examples, and what is refused, in the names of the file.
set(delcert $<TARGET_FILE:delcert>)
set(check $<TARGET_FILE:delcert-check>)
set(complexes ${PROJECT_SOURCE_DIR}/examples/complexes)

# delcert_complex_test(NAME levels homology): certified, verified once more, with these groups.
function(delcert_complex_test name levels homology)
  delcert_cli_test(certify-complex-${name} STATUS 0 OUTPUT "levels\n${levels}.*delcert-check verified" ERROR "^$" FIXTURE_SETUP complex-${name}
    COMMAND ${delcert} certify --complex ${complexes}/${name}.toml --output complex-${name}.json.zst)
  delcert_cli_test(verify-complex-${name} STATUS 0 OUTPUT "\nverified: levels 2" ERROR "^$" FIXTURES complex-${name}
    COMMAND ${check} complex-${name}.json.zst)
  delcert_cli_test(homology-complex-${name} STATUS 0 OUTPUT "components   1\n.*homology     ${homology}\n$" ERROR "^$" FIXTURES complex-${name}
    COMMAND ${delcert} homology complex-${name}.json.zst)
endfunction()

delcert_complex_test(klein-bottle-9 "  2 .*\n  4 .*\n  5 .*\n  6 .*self-Delaunay" "Z, Z . Z/2, 0")
delcert_complex_test(genus-2 "  2 .*\n  4 .*\n  5 .*\n  6 .*self-Delaunay" "Z, Z.4, Z")
delcert_complex_test(four-crosscaps "  2 .*\n  4 .*\n  5 .*\n  6 .*self-Delaunay" "Z, Z.3 . Z/2, 0")
delcert_complex_test(seifert-weber "  2 .*\n  5 .*\n  6 .*not reached: level 4: point [0-9]* is not certainly outside" "Z, .Z/5..3, 0, Z")
delcert_complex_test(dodecahedral-29 "  2 .*\n  5 .*\n  6 .*not reached: level 4: " "Z, Z/29, 0, Z")

delcert_cli_test(certify-complex-json STATUS 0 ERROR "^$"
  OUTPUT "\"delcert-complex-report\".*\"levels\": .*\"homology\": .*\"Z.4\".*\"5\": .*\"checker\": .*\"status\": \"verified\""
  COMMAND ${delcert} certify --complex ${complexes}/genus-2.toml --json --output complex-json.json)
delcert_cli_test(certify-complex-few-levels STATUS 0 OUTPUT "levels\n  2 [^\n]*\nchecked" ERROR "^$"
  COMMAND ${delcert} certify --complex ${complexes}/klein-bottle-9.toml --levels 2 --output complex-few.json)

# What is made of an example by replacing parts of it: delcert_broken_complex(NAME example status reason part by …).
function(delcert_broken_complex name example status reason)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${complexes}/${example}.toml)
  file(READ ${complexes}/${example}.toml text)
  math(EXPR last "${ARGC} - 1")
  foreach(at RANGE 4 ${last} 2)  # a list would stumble over brackets
    math(EXPR next "${at} + 1")
    set(part "${ARGV${at}}")
    set(by "${ARGV${next}}")
    string(FIND "${text}" "${part}" found)
    if(found EQUAL -1)
      message(FATAL_ERROR "delcert_broken_complex(${name}): ${part} is not in ${example}")
    endif()
    string(REPLACE "${part}" "${by}" text "${text}")
  endforeach()
  file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/broken-${name}.toml "${text}")
  delcert_cli_test(certify-broken-complex-${name} STATUS ${status} OUTPUT "^$" ERROR "${reason}"
    COMMAND ${delcert} certify --complex broken-${name}.toml --output broken-${name}.json)
  delcert_cli_test(certify-broken-complex-${name}-writes-nothing STATUS 1
    COMMAND sh -c "ls -a | grep broken-${name}.json")
  # While it runs it has a temporary file.
  set_tests_properties(cli.certify-broken-complex-${name}-writes-nothing PROPERTIES
    DEPENDS cli.certify-broken-complex-${name})
endfunction()

delcert_broken_complex(word klein-bottle-9 1 "core.edges: the edge {a0, c[01]} has different relative elements"
  "\"c1\", \"g a0\"]" "\"c1\", \"g e2 a0\"]")
delcert_broken_complex(missing klein-bottle-9 1 "core.facets: simplex {[a-c0-2, ]*} without its point [a-c0-2]* is in 1 simplices"
  "[\"a0\", \"a1\", \"b0\"], " "")
delcert_broken_complex(generator klein-bottle-9 1 "core.(facets|sign|stars): .*simplex {[a-c0-2, ]*}"
  "g = [[1, 0, 0], [\"1/2\", 1, 0], [\"1/6\", 0, -1]]" "g = [[1, 0, 0], [\"1/2\", -1, 0], [\"1/6\", 0, 1]]")
delcert_broken_complex(no-isometry klein-bottle-9 1 "klein-bottle-9: generator g: " "0, -1]]" "0, 2]]")
delcert_broken_complex(points klein-bottle-9 1 "core.facets: .* are on the same side of a facet"
  "b1 = " "B1 = " "c2 = " "b1 = " "B1 = " "c2 = ")
delcert_broken_complex(subgroup klein-bottle-9 1 "does not seem to contain h: no closed path"
  "[generators]\n" "[generators]\nh = [[1, 0, 0], [\"1/2\", 1, 0], [0, 0, 1]]\n")
delcert_broken_complex(missing-in-subgroup klein-bottle-9 1 "core.facets: .* is in 1 simplices"
  "[generators]\n" "[generators]\nh = [[1, 0, 0], [\"1/2\", 1, 0], [0, 0, 1]]\n" "[\"a0\", \"a1\", \"b0\"], " "")
file(READ ${complexes}/klein-bottle-9.toml second)
string(REGEX MATCH "simplices = \\[(.*)\\]\n\n\\[points\\]\n(.*)\n\\[generators\\]" ignored "${second}")
set(second_simplices "${CMAKE_MATCH_1}")
set(second_points "${CMAKE_MATCH_2}")
foreach(column a b c)
  string(REGEX REPLACE "${column}([0-2])" "second-${column}\\1" second_simplices "${second_simplices}")
  string(REGEX REPLACE "${column}([0-2]) =" "second-${column}\\1 =" second_points "${second_points}")
endforeach()
delcert_broken_complex(components klein-bottle-9 1 "core.connected: 9 labels are not connected with point a0"
  "simplices = [" "simplices = [${second_simplices}" "[points]\n" "[points]\n${second_points}")
delcert_broken_complex(letters genus-2 3 "broken-letters.toml:[0-9]+:[0-9]+: simplex [0-9]+, vertex [0-9]: .b.*: expected an exponent"
  "\"b^-1 a v\"]" "\"b^ a v\"]")
delcert_broken_complex(unknown-point genus-2 3 "simplex 1, vertex 1: no point r0, did you mean"
  "[\"r00\", \"v\", \"a1\"]" "[\"r0\", \"v\", \"a1\"]")
delcert_broken_complex(unknown-generator genus-2 3 "simplex [0-9]+, vertex [0-9]: no generator z" "\"a a2\"]" "\"z a2\"]")
delcert_broken_complex(repeated genus-2 3 "simplex 2 has the points a1, r00, v, as has simplex 1: different simplices"
  "  [\"r00\", \"r01\", \"a1\"],\n" "  [\"v\", \"r00\", \"a1\"],\n")
delcert_broken_complex(generators-exchanged genus-2 1 "core.(facets|sign|stars): " "\na = " "\nx = " "\nb = " "\na = " "\nx = " "\nb = ")
delcert_broken_complex(tetrahedron seifert-weber 1 "core.facets: simplex {[0-9, ]*} without its point [0-9]+ is in 1 simplices"
  "  [3, 347, 493, 507],\n" "")
delcert_broken_complex(word-in-space seifert-weber 1 "core.edges: the edge {[0-9]+, [0-9]+} has different relative elements"
  "  [\"c 39\", 347, 493, 507],\n" "  [\"b 39\", 347, 493, 507],\n")
# Side pairings of the one space with the simplices of the other.
delcert_broken_complex(other-turns seifert-weber 1 "core.(facets|sign|stars): " "\na = [" "\nx = [" "\nb = [" "\na = [" "\nx = [" "\nb = [")

delcert_cli_test(certify-complex-and-net STATUS 64 OUTPUT "^$" ERROR "--complex excludes --radius"
  COMMAND ${delcert} certify --complex ${complexes}/genus-2.toml --radius 1/10 --output never.json)
delcert_cli_test(certify-neither-manifold-nor-complex STATUS 64 OUTPUT "^$" ERROR "--manifold is required"
  COMMAND ${delcert} certify --radius 1/10)
delcert_cli_test(certify-no-complex STATUS 3 OUTPUT "^$" ERROR "no-such-file.toml" COMMAND ${delcert} certify --complex no-such-file.toml)

find_package(Python3 3.11 REQUIRED COMPONENTS Interpreter)
delcert_cli_test(complexes-are-made STATUS 0 OUTPUT "^$" ERROR "^$"
  COMMAND sh -c "rm -rf made && mkdir made && '${Python3_EXECUTABLE}' -B ${complexes}/make.py made && diff -r --exclude=make.py ${complexes} made")

# Meshes of a surface in space, against its equation.
add_executable(surface-mesh ${CMAKE_CURRENT_LIST_DIR}/surface_mesh.cpp)
target_compile_features(surface-mesh PRIVATE cxx_std_20)
target_compile_options(surface-mesh PRIVATE $<$<CONFIG:Release>:-O1>)
target_link_libraries(surface-mesh PRIVATE CGAL::CGAL Eigen3::Eigen)
add_test(NAME cli.mesh COMMAND Python3::Interpreter ${CMAKE_CURRENT_LIST_DIR}/mesh.py
  $<TARGET_FILE:delcert> $<TARGET_FILE:delcert-check> $<TARGET_FILE:surface-mesh>)
add_test(NAME cli.mesh_manifold COMMAND Python3::Interpreter ${CMAKE_CURRENT_LIST_DIR}/mesh_manifold.py
  $<TARGET_FILE:delcert> $<TARGET_FILE:delcert-check>)
# It begins early: it takes longer than others.
set_tests_properties(cli.mesh PROPERTIES COST 100)
set_tests_properties(cli.mesh cli.mesh_manifold PROPERTIES TIMEOUT 600)
# Surfaces that the examples do not have, with the radii that are advised.
add_test(NAME cli.surfaces COMMAND Python3::Interpreter ${CMAKE_CURRENT_LIST_DIR}/surfaces.py
  $<TARGET_FILE:delcert> $<TARGET_FILE:delcert-check>)
set_tests_properties(cli.surfaces PROPERTIES TIMEOUT 600)
# Files that do not describe a manifold, or are malformed.
add_test(NAME cli.wrong-manifolds COMMAND Python3::Interpreter ${CMAKE_CURRENT_LIST_DIR}/wrong_manifolds.py $<TARGET_FILE:delcert>)
set_tests_properties(cli.wrong-manifolds PROPERTIES TIMEOUT 1200)
if(DELCERT_DEEP)
  add_test(NAME cli.all-surfaces COMMAND Python3::Interpreter ${CMAKE_CURRENT_LIST_DIR}/surfaces.py
    $<TARGET_FILE:delcert> $<TARGET_FILE:delcert-check> --all)
  set_tests_properties(cli.all-surfaces PROPERTIES TIMEOUT 3600)
  # Meshes of 50 000 triangles. VTK is a module of Debian's Python.
  find_program(DELCERT_DEBIAN_PYTHON python3 PATHS /usr/bin NO_DEFAULT_PATH REQUIRED)
  add_test(NAME cli.large-meshes COMMAND ${DELCERT_DEBIAN_PYTHON} ${CMAKE_CURRENT_LIST_DIR}/mesh.py
    $<TARGET_FILE:delcert> $<TARGET_FILE:delcert-check> $<TARGET_FILE:surface-mesh> --large)
  set_tests_properties(cli.large-meshes PROPERTIES TIMEOUT 3600)
endif()
