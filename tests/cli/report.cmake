# What certify --json prints, in every family, against docs/report.schema.json; and reports that are to be refused.
find_package(Python3 3.11 REQUIRED COMPONENTS Interpreter)
add_test(NAME cli.report-schema COMMAND Python3::Interpreter ${CMAKE_CURRENT_LIST_DIR}/report_schema.py
  $<TARGET_FILE:delcert> ${PROJECT_SOURCE_DIR}/docs/report.schema.json ${PROJECT_SOURCE_DIR}/docs/report-format.md)
set_tests_properties(cli.report-schema PROPERTIES TIMEOUT 300)
