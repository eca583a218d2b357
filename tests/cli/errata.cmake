# The errata: the page, the findings of a user, and the commands that reproduce them.
set(errata $<TARGET_FILE:delcert> errata)
set(finding ${CMAKE_CURRENT_BINARY_DIR}/one-finding.toml)
file(WRITE ${finding} "label = 'lem:x'\nnumber = 'Lemma 1'\nlines = '7'\nkind = 'misprint'\nprinted = 'p'\nwrong = 'w'\ndecidable = false\n")
file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/malformed-finding.toml "label = 'lem:x'\nnumber = 'Lemma 1'\nlines = '7-3'\n")

delcert_cli_test(errata-help COMMAND ${errata} --help STATUS 0 OUTPUT "--json.*Examples:" ERROR "^$")
delcert_cli_test(errata-json COMMAND ${errata} --json STATUS 0 OUTPUT "^{\n  \"text\": [^\n]*preprint[^\n]*,\n  \"errata\": \\[.*lem:bound.cc.*\\]\n}\n$" ERROR "^$")
delcert_cli_test(errata-file COMMAND ${errata} ${finding} STATUS 0 OUTPUT "^# Errata\n.*\n### Lemma 1, line 7, lem:x: misprint\n" ERROR "^$")
delcert_cli_test(errata-malformed COMMAND ${errata} malformed-finding.toml STATUS 3 OUTPUT "^$"
  ERROR "^delcert: error: malformed-finding.toml:3:9: lines are [^\n]*\n$")
delcert_cli_test(errata-missing COMMAND ${errata} nowhere.toml STATUS 3 OUTPUT "^$" ERROR "nowhere.toml: cannot be read")
delcert_cli_test(errata-unknown-option COMMAND ${errata} --jsn STATUS 64 OUTPUT "^$" ERROR "--jsn")

add_executable(test_errata errata_test.cpp)
target_link_libraries(test_errata PRIVATE delcert_proofs delcert_warnings GTest::gtest_main)
target_compile_definitions(test_errata PRIVATE
  DELCERT_PROGRAM="$<TARGET_FILE:delcert>" DELCERT_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
add_dependencies(test_errata delcert)
gtest_discover_tests(test_errata DISCOVERY_TIMEOUT 60 PROPERTIES TIMEOUT 300)
