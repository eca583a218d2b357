# Files that are wrong, one for each way to be wrong; the first line of each is "# expect: " and a part of the message.
add_executable(test_malformed malformed_test.cpp)
target_link_libraries(test_malformed PRIVATE delcert_kernel delcert_warnings GTest::gtest_main)
target_compile_definitions(test_malformed PRIVATE
  DELCERT_MALFORMED="${CMAKE_CURRENT_SOURCE_DIR}/malformed" DELCERT_EXAMPLES="${PROJECT_SOURCE_DIR}/examples")
gtest_discover_tests(test_malformed DISCOVERY_TIMEOUT 60)

# The same files on the command line. What is special in a regular expression stands for any character there.
function(delcert_malformed_test kind file)
  cmake_path(GET file STEM stem)
  file(STRINGS ${file} first_line LIMIT_COUNT 1 ENCODING UTF-8)
  string(REGEX REPLACE "^# expect: " "" message "${first_line}")
  string(REGEX REPLACE "[][+.*()^?$|{}\\\\]" "." message "${message}")
  delcert_cli_test(malformed-${kind}-${stem} COMMAND $<TARGET_FILE:delcert> certify ${ARGN} --output unused.json
    STATUS 3 OUTPUT "^$" ERROR "^delcert: error: .*${message}.*\n$")
endfunction()
file(GLOB manifolds CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/malformed/manifolds/*)
foreach(file IN LISTS manifolds)
  delcert_malformed_test(manifold ${file} --manifold ${file} --radius 1/24)
endforeach()
file(GLOB points CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/malformed/points/*)
foreach(file IN LISTS points)
  delcert_malformed_test(points ${file} --manifold torus-2 --points ${file})
endforeach()
