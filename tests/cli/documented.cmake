# The console sessions of docs/cli.md and docs/complex-file.md, run again: blocks that begin with ```console.
file(CREATE_LINK ${PROJECT_SOURCE_DIR}/examples ${CMAKE_CURRENT_BINARY_DIR}/examples SYMBOLIC)
add_executable(test_documented documented_test.cpp)
target_link_libraries(test_documented PRIVATE delcert_warnings GTest::gtest_main)
target_compile_definitions(test_documented PRIVATE
  DELCERT_PROGRAM="$<TARGET_FILE:delcert>" DELCERT_DOCUMENTATION="${PROJECT_SOURCE_DIR}/docs/")
add_dependencies(test_documented delcert delcert-check)
gtest_discover_tests(test_documented WORKING_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR} DISCOVERY_TIMEOUT 60)
