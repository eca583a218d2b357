# Files that are wrong, one for each way to be wrong; the first line of each is "# expect: " and a part of the message.
add_executable(test_malformed malformed_test.cpp)
target_link_libraries(test_malformed PRIVATE delcert_kernel delcert_warnings GTest::gtest_main)
target_compile_definitions(test_malformed PRIVATE
  DELCERT_MALFORMED="${CMAKE_CURRENT_SOURCE_DIR}/malformed" DELCERT_EXAMPLES="${PROJECT_SOURCE_DIR}/examples")
gtest_discover_tests(test_malformed DISCOVERY_TIMEOUT 60)
