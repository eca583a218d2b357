# The table of constants: the page is what the program prints from the files of the sources.
set(tables $<TARGET_FILE:delcert> tables)
set(pages ${PROJECT_SOURCE_DIR}/docs/tables)
file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/no-slack.json "{\"steps\": 3}")

delcert_cli_test(tables-help COMMAND ${tables} --help STATUS 0 OUTPUT "--slack.*--ratios.*--power.*--latex.*Examples:" ERROR "^$")
delcert_cli_test(tables-without-slack COMMAND ${tables} STATUS 0 ERROR "^$"
  OUTPUT "lem:splx.gram . ..E_ij.. ≤ c·ξΔ² . 4 . – . > 33/10 . – . – . gram-matrix-under-distortion.entries-twin.json")
delcert_cli_test(tables-other-json COMMAND ${tables} --slack no-slack.json STATUS 3 OUTPUT "^$"
  ERROR "^delcert: error: no-slack.json: not what delcert prove --slack --json prints")
delcert_cli_test(tables-other-ratios COMMAND ${tables} --ratios no-slack.json STATUS 3 OUTPUT "^$"
  ERROR "^delcert: error: no-slack.json: not what delcert tighten --json prints")
delcert_cli_test(tables-other-power COMMAND ${tables} --power no-slack.json STATUS 3 OUTPUT "^$"
  ERROR "^delcert: error: no-slack.json: not what delcert power --json prints")
delcert_cli_test(tables-missing-file COMMAND ${tables} --slack nowhere.json STATUS 3 OUTPUT "^$" ERROR "nowhere.json: cannot be read")
delcert_cli_test(tables-unknown-option COMMAND ${tables} --latx STATUS 64 OUTPUT "^$" ERROR "--latx")
delcert_cli_test(tables-power.md STATUS 0 OUTPUT "^$" ERROR "^$"
  COMMAND sh -c "\"$1\" tables --power \"$2/power.json\" --places | diff - \"$2/power.md\"" sh $<TARGET_FILE:delcert> ${pages})
delcert_cli_test(tables-places-of-nothing COMMAND ${tables} --places STATUS 64 OUTPUT "^$" ERROR "--power")
foreach(page "constants.md;" "constants.tex;--latex")
  list(GET page 0 file)
  list(GET page 1 option)
  delcert_cli_test(tables-${file} STATUS 0 OUTPUT "^$" ERROR "^$"
    COMMAND sh -c "\"$1\" tables --slack \"$2/slack.json\" --ratios \"$2/tightness.json\" --power \"$2/power.json\" $4 | diff - \"$2/$3\"" sh $<TARGET_FILE:delcert> ${pages} ${file} ${option})
endforeach()
