# The console sessions of docs/cli.md, run again: blocks that begin with ```console.
add_executable(test_documented documented_test.cpp)
target_link_libraries(test_documented PRIVATE delcert_warnings GTest::gtest_main)
target_compile_definitions(test_documented PRIVATE
  DELCERT_PROGRAM="$<TARGET_FILE:delcert>" DELCERT_DOCUMENTATION="${PROJECT_SOURCE_DIR}/docs/cli.md")
add_dependencies(test_documented delcert)
gtest_discover_tests(test_documented DISCOVERY_TIMEOUT 60)
