# `delcert check` is delcert-check with the same arguments and the same exit status. A copy of the program beside a
# script of that name shows what is handed over; a copy on its own shows what happens without a checker.
set(delcert $<TARGET_FILE:delcert>)
file(GENERATE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/beside/delcert-check
  CONTENT "#!/bin/sh\nprintf '<%s>' \"$@\"\nexit 42\n"
  FILE_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE)
file(MAKE_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/alone/here)

delcert_cli_test(check-help COMMAND ${delcert} check --help STATUS 0 OUTPUT "FILE.*Examples:.*delcert check" ERROR "^$")
delcert_cli_test(check-without-file COMMAND ${delcert} check STATUS 64 OUTPUT "^$" ERROR "^delcert: error: FILE is required")
delcert_cli_test(check-copy COMMAND ${CMAKE_COMMAND} -E copy ${delcert} $<TARGET_FILE:delcert-certify> beside STATUS 0
  FIXTURE_SETUP check-beside)
delcert_cli_test(check-hands-over COMMAND beside/delcert check --levels 0,1 "a file" -h -- constants STATUS 42
  OUTPUT "^<--levels><0,1><a file><-h><--><constants>$" ERROR "^$" FIXTURES check-beside)
delcert_cli_test(check-copy-alone COMMAND ${CMAKE_COMMAND} -E copy ${delcert} $<TARGET_FILE:delcert-certify> alone/here STATUS 0
  FIXTURE_SETUP check-alone)
delcert_cli_test(check-not-installed STATUS 70 OUTPUT "^$" FIXTURES check-alone
  COMMAND ${CMAKE_COMMAND} -E env PATH=/nowhere alone/here/delcert check file
  ERROR "delcert-check is not installed.*alone/here/delcert-check\n.*alone/proofs/checker/delcert-check\n.*/nowhere/delcert-check\n$")
delcert_cli_test(check-found-in-path STATUS 42 OUTPUT "^<file>$" FIXTURES check-alone
  COMMAND ${CMAKE_COMMAND} -E env PATH=${CMAKE_CURRENT_BINARY_DIR}/beside alone/here/delcert check file)
# A file that is not there is refused by the checker as by every other command.
delcert_cli_test(check-no-file STATUS 3 OUTPUT "^$" ERROR "^delcert-check: error: no-such-file.json: cannot be read\n$"
  COMMAND ${delcert} check no-such-file.json)
delcert_cli_test(check-folder STATUS 3 OUTPUT "^$" ERROR "^delcert-check: error: alone: cannot be read\n$"
  COMMAND ${delcert} check alone)

# delcert split divides certificates of space forms; what the checker says of chunks is tested in tests/checker.
delcert_cli_test(split-help COMMAND ${delcert} split --help STATUS 0 OUTPUT "--chunks N.*Examples:.*delcert-check --chunk" ERROR "^$")
delcert_cli_test(split-a-torus COMMAND ${delcert} split run-square.json.zst --chunks 2 --output split-square STATUS 3
  OUTPUT "^$" ERROR "^delcert: error: run-square.json.zst: is no certificate of a space form" FIXTURES run-square)
delcert_cli_test(split-without-number COMMAND ${delcert} split run-square.json.zst --output split-square STATUS 64
  OUTPUT "^$" ERROR "--chunks is required")
delcert_cli_test(check-chunk-and-part STATUS 64 OUTPUT "^$" ERROR "^delcert-check: error: --part and --chunk exclude one another"
  COMMAND $<TARGET_FILE:delcert-check> --chunk 1 --part 1/2 --receipt r folder)
delcert_cli_test(check-chunk-without-receipt STATUS 64 OUTPUT "^$" ERROR "^delcert-check: error: --chunk needs --receipt"
  COMMAND $<TARGET_FILE:delcert-check> --chunk 1 folder)
delcert_cli_test(check-chunk-zero STATUS 64 OUTPUT "^$" ERROR "--chunk: expected a number from 1 to 1000000, found 0"
  COMMAND $<TARGET_FILE:delcert-check> --chunk 0 --receipt r folder)
delcert_cli_test(check-chunk-of-no-folder STATUS 3 OUTPUT "^$" ERROR "^delcert-check: error: no-such-folder/header.json: cannot be read"
  COMMAND $<TARGET_FILE:delcert-check> --chunk 1 --receipt r no-such-folder)
