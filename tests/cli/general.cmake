# What the program does whatever the subcommand.
set(delcert $<TARGET_FILE:delcert>)

delcert_cli_test(version COMMAND ${delcert} --version STATUS 0 OUTPUT "^delcert [0-9]+[.][0-9]+[.][0-9]+\n$" ERROR "^$")
delcert_cli_test(help COMMAND ${delcert} --help STATUS 0 OUTPUT "constants.*check.*Exit status.*Examples:" ERROR "^$")
delcert_cli_test(no-subcommand COMMAND ${delcert} STATUS 64 OUTPUT "^$" ERROR "^delcert: error: .*see delcert --help")
delcert_cli_test(unknown-subcommand COMMAND ${delcert} certfy STATUS 64 OUTPUT "^$" ERROR "^delcert: error: there is no subcommand certfy, did you mean certify[?]")
delcert_cli_test(manifolds COMMAND ${delcert} manifolds STATUS 0 OUTPUT "torus-2 +2 +flat +The square torus.*bolza-surface +2 +space form.*tanglecube" ERROR "^$")
delcert_cli_test(manifolds-word COMMAND ${delcert} manifolds lens --names STATUS 0 OUTPUT "^lens-space-5-2\nlens-space-7-2\n$" ERROR "^$")
delcert_cli_test(manifolds-none COMMAND ${delcert} manifolds bolsa-surface STATUS 3 OUTPUT "^$" ERROR "did you mean bolza-surface")
delcert_cli_test(manifolds-json COMMAND ${delcert} manifolds klein-quartic --json STATUS 0 ERROR "^$"
  OUTPUT "\"name\": \"klein-quartic\".*\"dimension\": 2")
delcert_cli_test(unknown-option COMMAND ${delcert} --frobnicate STATUS 64 OUTPUT "^$" ERROR "^delcert: error: ")
delcert_cli_test(full-disk
  COMMAND sh -c "\"$1\" constants --dim 2 --separation 1 --perturbation 1/4 > /dev/full" sh ${delcert}
  STATUS 70 ERROR "cannot write to standard output")

# delcert, delcert-certify, delcert-publish and delcert-claims are one program to its users: the first knows the names of the
# subcommands of the others and hands over, in the same process and with the same arguments.
set(two_programs ${CMAKE_CURRENT_LIST_DIR}/two_programs.sh)
delcert_cli_test(two-programs-one-help COMMAND ${two_programs} help ${delcert} STATUS 0 OUTPUT "^the same\n$" ERROR "^$")
delcert_cli_test(left-to-claims COMMAND ${delcert} claims --help STATUS 0 OUTPUT "delcert claims show" ERROR "^$")
delcert_cli_test(left-to-claims-arguments COMMAND ${delcert} attack "no such claim" STATUS 3 OUTPUT "^$" ERROR "no such claim")
delcert_cli_test(left-to-claims-process COMMAND ${two_programs} process ${delcert} STATUS 0 OUTPUT "^the same process\n$" ERROR "^$")
delcert_cli_test(left-to-claims-that-are-missing COMMAND ${two_programs} alone ${delcert} STATUS 70 OUTPUT "^torus-2\n"
  ERROR "^delcert: error: internal: [^\n]*/delcert-claims is not there, and claims are its part; in the source tree ./run builds it\n$")
delcert_cli_test(left-to-publishing COMMAND ${delcert} export --help STATUS 0 OUTPUT "delcert export" ERROR "^$")
delcert_cli_test(left-to-publishing-arguments COMMAND ${delcert} cite --format bibtx STATUS 64 OUTPUT "^$" ERROR "did you mean bibtex")
delcert_cli_test(left-to-publishing-that-is-missing COMMAND ${two_programs} alone-publishing ${delcert} STATUS 70 OUTPUT "^torus-2\n"
  ERROR "^delcert: error: internal: [^\n]*/delcert-publish is not there, and exports, figures and pages are its part; in the source tree ./run builds it\n$")
delcert_cli_test(left-to-all-when-alone COMMAND ${two_programs} alone-in-front ${delcert} STATUS 70 OUTPUT "^$"
  ERROR "^delcert: error: internal: [^\n]*/delcert-certify cannot be run, and certificates are its part\n$")
if(CMAKE_BUILD_TYPE STREQUAL Release)
  # A sanitizer has libraries of its own.
  delcert_cli_test(left-at-once COMMAND ${two_programs} libraries ${delcert} STATUS 0 OUTPUT "^libc[.]so[.]6\n$" ERROR "^$")
endif()
delcert_cli_test(left-to-two-programs COMMAND ${two_programs} without-claims ${delcert} STATUS 70 OUTPUT "^$"
  ERROR "^delcert: error: internal: [^\n]*/delcert-claims is not there, and claims are its part")
