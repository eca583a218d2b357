# Steps decided, their logs written and checked by the other program.
set(delcert $<TARGET_FILE:delcert>)
set(replay $<TARGET_FILE:delcert-replay>)
set(folder ${CMAKE_CURRENT_BINARY_DIR}/prove)
file(MAKE_DIRECTORY ${folder}/logs)
foreach(step "right;x*(1 - x) <= 1/4" "wrong;x*(1 - x) <= 1/5" "open;(3*x - 1)^2 + (3*y - 1)^2 >= 0")
  list(GET step 0 name)
  list(GET step 1 claim)
  file(WRITE ${folder}/${name}.toml "name = '${name}'\n[[step]]\nname = 'only'\nforall = { x = '[0, 1]', y = '[0, 1]' }\nclaim = '${claim}'\n")
endforeach()
file(WRITE ${folder}/malformed.toml "name = 'a'\n[[step]]\nname = 'only'\nforall = { x = '[0, 1' }\nclaim = 'x > 0'\n")
file(WRITE ${folder}/constant.toml
  "name = 'constant'\n[[step]]\nname = 'only'\nforall = { x = '[0, 1]' }\nconstants = { c = '3' }\nclaim = 'x + 1 <= c'\n")
file(WRITE ${folder}/no-log.jsonl "{}\n")

delcert_cli_test(prove-right STATUS 0 ERROR "^$" OUTPUT "right / only .* proved .*1 proved, 0 refuted, 0 undecided"
  COMMAND ${delcert} prove prove/right.toml)
delcert_cli_test(prove-wrong STATUS 1 ERROR "^$" OUTPUT "wrong / only .* refuted .* false at x = 1/2, y = 0 .*1 refuted"
  COMMAND ${delcert} prove prove/wrong.toml)
delcert_cli_test(prove-open STATUS 2 ERROR "^$" OUTPUT "open / only .* undecided .* left"
  COMMAND ${delcert} prove prove/open.toml)
delcert_cli_test(prove-wrong-and-open STATUS 1 ERROR "^$" OUTPUT "0 proved, 1 refuted, 1 undecided"
  COMMAND ${delcert} prove prove/open.toml prove/wrong.toml)
delcert_cli_test(prove-malformed STATUS 3 OUTPUT "^$" ERROR "malformed.toml:4:22: the end where the end of the interval"
  COMMAND ${delcert} prove prove/malformed.toml)
delcert_cli_test(prove-unknown-step STATUS 3 OUTPUT "^.*$" ERROR "no step of the claims named is called nothing"
  COMMAND ${delcert} prove prove/right.toml --step nothing)
delcert_cli_test(prove-nothing STATUS 3 OUTPUT "^$" ERROR "no claim: name some, or say --all" COMMAND ${delcert} prove)
delcert_cli_test(prove-json STATUS 1 ERROR "^$" OUTPUT "\"verdict\": \"refuted\".*\"counterexample\".*\"x\": \"1/2\""
  COMMAND ${delcert} prove prove/wrong.toml --json)
delcert_cli_test(prove-slack STATUS 0 ERROR "^$" OUTPUT "constant / only . c . 3 . 2 . [0-9]+/[0-9]+ ."
  COMMAND ${delcert} prove prove/constant.toml --slack)
delcert_cli_test(prove-mutated STATUS 0 ERROR "^$" OUTPUT "1 constants moved past their slack: 1 refuted with a counterexample .100.0 %"
  COMMAND ${delcert} prove prove/constant.toml --mutate)
delcert_cli_test(attack-steps-only STATUS 3 OUTPUT "^$" ERROR "right has steps only, which are proved and not attacked: delcert prove right"
  COMMAND ${delcert} attack prove/right.toml)
delcert_cli_test(claims-show-step STATUS 0 ERROR "^$" OUTPUT "step only .user.: x.*for all x in .0, 1."
  COMMAND ${delcert} claims show prove/right.toml)

delcert_cli_test(prove-log STATUS 0 ERROR "^$" OUTPUT "1 proved" FIXTURE_SETUP proof-log
  COMMAND ${delcert} prove prove/right.toml --log prove/logs)
delcert_cli_test(replay STATUS 0 ERROR "^$" OUTPUT "^accepted prove/logs/right.jsonl: 1 steps, 1 goals, [0-9]+ leaves\n$" FIXTURES proof-log
  COMMAND ${replay} prove/logs/right.jsonl)
delcert_cli_test(replay-tampered STATUS 1 ERROR "^$" OUTPUT "^rejected .*right / only: goal 1: another statement\n$" FIXTURES proof-log
  COMMAND sh -c "sed 's|(/ 1 4)|(/ 1 5)|' prove/logs/right.jsonl > prove/tampered.jsonl && $<TARGET_FILE:delcert-replay> prove/tampered.jsonl")
delcert_cli_test(replay-no-log STATUS 3 OUTPUT "^$" ERROR "delcert-replay: error: prove/no-log.jsonl: "
  COMMAND ${replay} prove/no-log.jsonl)
delcert_cli_test(replay-no-file STATUS 3 OUTPUT "^$" ERROR "there-is-none.jsonl: cannot be read" COMMAND ${replay} there-is-none.jsonl)
delcert_cli_test(replay-usage STATUS 64 OUTPUT "^$" ERROR "^Usage: " COMMAND ${replay})
delcert_cli_test(replay-help STATUS 0 OUTPUT "^Usage: " ERROR "^$" COMMAND ${replay} --help)

# The steps of the library: what is refuted is the paper's or in the list of our readings of it, every constant has its limit, the other program agrees.
file(MAKE_DIRECTORY ${folder}/all)
delcert_cli_test(prove-all STATUS 1 ERROR "^$" OUTPUT " 0 undecided, .* refuted with a counterexample .100.0 %.\n$" FIXTURE_SETUP proof-logs
  COMMAND ${delcert} prove --all --mutate --log prove/all)
delcert_cli_test(prove-all-refutes-nothing-else STATUS 0 ERROR "^$" OUTPUT "refuted: "
  COMMAND sh -c "$<TARGET_FILE:delcert> prove --all | grep 'refuted: ' > prove/refuted.txt && sed -n 's|^ *refuted: \\(.*\\) (user)$|\\1|p' prove/refuted.txt | diff - ${CMAKE_CURRENT_SOURCE_DIR}/refuted_readings.txt && ! grep -v -e '(paper)$' -e '(user)$' prove/refuted.txt && cat prove/refuted.txt")
delcert_cli_test(replay-all STATUS 0 ERROR "^$" OUTPUT "^(accepted [^\n]*\n)+$" FIXTURES proof-logs
  COMMAND sh -c "$<TARGET_FILE:delcert-replay> prove/all/*.jsonl")
