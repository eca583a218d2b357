# delcert report, and what it refuses. What pages show is tested in tests/report.

# delcert_page_test(NAME STATUS n [ERROR regex] [FIXTURES f …] FILES … [OPTIONS …]): into a file that is not there before, and
# is not there afterwards where nothing is to be written.
function(delcert_page_test name)
  cmake_parse_arguments(PARSE_ARGV 1 ARG "" "STATUS;ERROR" "FILES;FIXTURES")
  delcert_cli_test(page-${name} STATUS ${ARG_STATUS} OUTPUT "^$" ERROR "${ARG_ERROR}" FIXTURES ${ARG_FIXTURES}
    COMMAND ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/export_once.sh page-${name}.html $<TARGET_FILE:delcert> report ${ARG_FILES})
endfunction()

delcert_page_test(of-a-certificate FILES run-square.json.zst STATUS 0 ERROR "^$" FIXTURES run-square)
delcert_page_test(without-a-check FILES run-square.json.zst --no-check STATUS 0 ERROR "^$" FIXTURES run-square)
delcert_page_test(of-no-file FILES no-such-file.json STATUS 3 ERROR "^delcert: error: no-such-file.json: cannot be opened\n$")
delcert_page_test(of-something-else FILES points.txt STATUS 3 ERROR "^delcert: error: points.txt: [^\n]*\n$" FIXTURES run-points)
delcert_page_test(of-a-certificate-and-something-else FILES run-square.json.zst points.txt STATUS 3
  ERROR "^delcert: error: points.txt: [^\n]*\n$" FIXTURES run-square run-points)
delcert_page_test(of-nothing STATUS 64 ERROR "FILE is required")
delcert_cli_test(page-without-output STATUS 64 ERROR "--output is required"
  COMMAND $<TARGET_FILE:delcert> report run-square.json.zst)
delcert_cli_test(page-help STATUS 0 OUTPUT "delcert report torus-3.json.zst --output torus-3.html"
  COMMAND $<TARGET_FILE:delcert> report --help)
