# `delcert check` is delcert-check with the same arguments and the same exit status. A copy of the program beside a
# script of that name shows what is handed over; a copy on its own shows what happens without a checker.
set(delcert $<TARGET_FILE:delcert>)
file(GENERATE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/beside/delcert-check
  CONTENT "#!/bin/sh\nprintf '<%s>' \"$@\"\nexit 42\n"
  FILE_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE)
file(MAKE_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/alone/here)

delcert_cli_test(check-help COMMAND ${delcert} check --help STATUS 0 OUTPUT "FILE.*Examples:.*delcert check" ERROR "^$")
delcert_cli_test(check-without-file COMMAND ${delcert} check STATUS 64 OUTPUT "^$" ERROR "^delcert: error: FILE is required")
delcert_cli_test(check-copy COMMAND ${CMAKE_COMMAND} -E copy ${delcert} beside/delcert STATUS 0 FIXTURE_SETUP check-beside)
delcert_cli_test(check-hands-over COMMAND beside/delcert check --levels 0,1 "a file" -h -- constants STATUS 42
  OUTPUT "^<--levels><0,1><a file><-h><--><constants>$" ERROR "^$" FIXTURES check-beside)
delcert_cli_test(check-copy-alone COMMAND ${CMAKE_COMMAND} -E copy ${delcert} alone/here/delcert STATUS 0
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
