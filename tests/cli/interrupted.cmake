# Whole runs that end by a signal.
add_executable(test_interrupted interrupted_test.cpp)
target_link_libraries(test_interrupted PRIVATE delcert_warnings GTest::gtest_main)
target_include_directories(test_interrupted PRIVATE ${PROJECT_SOURCE_DIR})
target_compile_definitions(test_interrupted PRIVATE
  DELCERT_PROGRAM="$<TARGET_FILE:delcert>" DELCERT_CHECKER="$<TARGET_FILE:delcert-check>")
add_dependencies(test_interrupted delcert delcert-check)
gtest_discover_tests(test_interrupted DISCOVERY_TIMEOUT 60 PROPERTIES TIMEOUT 900)
