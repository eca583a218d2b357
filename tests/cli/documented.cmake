# The console sessions of the documentation, run again.
add_executable(test_documented documented_test.cpp)
target_link_libraries(test_documented PRIVATE delcert_warnings GTest::gtest_main)
target_compile_definitions(test_documented PRIVATE DELCERT_PROGRAM="$<TARGET_FILE:delcert>"
  DELCERT_CHECK="$<TARGET_FILE:delcert-check>" DELCERT_SOURCE="${PROJECT_SOURCE_DIR}")
add_dependencies(test_documented delcert delcert-check)
# Pages about several processes are read where there is MPI.
if(TARGET delcert-ranks)
  target_compile_definitions(test_documented PRIVATE DELCERT_RANKS_FOLDER="$<TARGET_FILE_DIR:delcert-ranks>")
  add_dependencies(test_documented delcert-ranks)
else()
  target_compile_definitions(test_documented PRIVATE DELCERT_RANKS_FOLDER="")
endif()
gtest_discover_tests(test_documented DISCOVERY_TIMEOUT 60)
