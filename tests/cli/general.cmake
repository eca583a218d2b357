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

# delcert and delcert-claims are one program to its users: the first knows of the second's subcommands their names, and hands
# over, in the same process and with the same arguments.
set(claims $<TARGET_FILE:delcert-claims>)
delcert_cli_test(two-programs-one-help STATUS 0 OUTPUT "^$" ERROR "^$"
  COMMAND bash -c "diff <(\"$1\" --help) <(\"$2\" --help)" bash ${delcert} ${claims})
delcert_cli_test(left-to-claims STATUS 0 OUTPUT "^(.*)\nUsage: delcert claims .*\nthe same\n$" ERROR "^$"
  COMMAND bash -c "\"$1\" claims --help && diff <(\"$1\" claims --help) <(\"$2\" claims --help) && echo the same" bash ${delcert} ${claims})
delcert_cli_test(left-to-claims-arguments STATUS 3 OUTPUT "^$" ERROR "no claim is called .*no such claim"
  COMMAND ${delcert} attack "no such claim")
delcert_cli_test(left-to-claims-process STATUS 0 OUTPUT "^the same process\n$" ERROR "^$"
  COMMAND bash -c "set -m; \"$1\" attack --all --samples 1000000 >/dev/null 2>&1 & \
for i in $(seq 600); do case $(readlink /proc/$!/exe) in */delcert-claims) echo the same process; break;; esac; sleep 0.1; done; kill -9 $!; wait $! 2>/dev/null; true"
    bash ${delcert})
delcert_cli_test(left-to-claims-that-are-missing STATUS 70 OUTPUT "^$"
  ERROR "^delcert: error: internal: [^\n]*/delcert-claims is not there, and claims are its part; in the source tree ./run builds it\n$"
  COMMAND bash -c "folder=$(mktemp -d) && cp \"$1\" $folder/delcert && $folder/delcert claims; status=$?; rm -r $folder; exit $status" bash ${delcert})
delcert_cli_test(left-to-claims-not-the-rest STATUS 0 OUTPUT "^torus-2\n" ERROR "^$"
  COMMAND bash -c "folder=$(mktemp -d) && cp \"$1\" $folder/delcert && $folder/delcert manifolds torus-2 --names; status=$?; rm -r $folder; exit $status" bash ${delcert})
