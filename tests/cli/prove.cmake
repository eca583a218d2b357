# Steps decided, their logs written and checked by the other program.
set(delcert $<TARGET_FILE:delcert>)
set(replay $<TARGET_FILE:delcert-replay>)
set(folder ${CMAKE_CURRENT_BINARY_DIR}/prove)
file(MAKE_DIRECTORY ${folder}/logs)
foreach(step "right;x*(1 - x) <= 1/4" "wrong;x*(1 - x) <= 1/5" "open;9*x^2 - 6*x + 1 + (3*y - 1)^2 + log2(1) >= 0")
  list(GET step 0 name)
  list(GET step 1 claim)
  file(WRITE ${folder}/${name}.toml "name = '${name}'\n[[step]]\nname = 'only'\nforall = { x = '[0, 1]', y = '[0, 1]' }\nclaim = '${claim}'\n")
endforeach()
file(WRITE ${folder}/malformed.toml "name = 'a'\n[[step]]\nname = 'only'\nforall = { x = '[0, 1' }\nclaim = 'x > 0'\n")
file(WRITE ${folder}/constant.toml
  "name = 'constant'\n[[step]]\nname = 'only'\nforall = { x = '[0, 1]' }\nconstants = { c = '3' }\nclaim = 'x + 1 <= c'\n")
file(WRITE ${folder}/no-steps.toml "name = 'no-steps'\ninstance = 'simplex'\n[[show]]\nclaim = 'k >= 1'\n")
foreach(step "vacuous;x > 1;x = 7" "perhaps;x^2 = 1/2;x <= 1")
  list(POP_FRONT step name given claim)
  file(WRITE ${folder}/${name}.toml
    "name = '${name}'\n[[step]]\nname = 'only'\nforall = { x = '[0, 1]' }\ngiven = ['${given}']\nclaim = '${claim}'\n")
endforeach()
file(WRITE ${folder}/no-log.jsonl "{}\n")
file(WRITE ${folder}/not-library/claim.toml "name = 'thickness-under-distortion'\n[[step]]\nname = 'longest-edge-ratio'\nforall = { eta = '(0, 1]', u = '(0, 1]', theta = '[0, 1]' }\nlet = { xi = 'theta*(eta*u/2)^2' }\nclaim = '1/(1 + xi) >= 0'\n")

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
delcert_cli_test(prove-without-steps STATUS 2 OUTPUT "^$" ERROR "^delcert: error: prove/no-steps.toml: no ..step.., so there is nothing to prove\n$"
  COMMAND ${delcert} prove prove/right.toml prove/no-steps.toml)
delcert_cli_test(prove-claim-without-steps STATUS 2 OUTPUT "^$" ERROR "adaptive-density.toml: no ..step.."
  COMMAND ${delcert} prove adaptive-density)
delcert_cli_test(prove-vacuous STATUS 4 ERROR "^$"
  OUTPUT "vacuous / only .* vacuous .* never: x > 1 .*0 proved, 0 refuted, 0 undecided, 1 vacuous, .*  vacuous: vacuous / only .user.\n$"
  COMMAND ${delcert} prove prove/vacuous.toml)
delcert_cli_test(prove-vacuous-and-wrong STATUS 1 ERROR "^$" OUTPUT "0 proved, 1 refuted, 0 undecided, 1 vacuous"
  COMMAND ${delcert} prove prove/vacuous.toml prove/wrong.toml)
delcert_cli_test(prove-vacuous-and-open STATUS 4 ERROR "^$" OUTPUT "0 proved, 0 refuted, 1 undecided, 1 vacuous"
  COMMAND ${delcert} prove prove/vacuous.toml prove/open.toml)
delcert_cli_test(prove-perhaps-vacuous STATUS 2 ERROR "^$"
  OUTPUT "perhaps / only .* proved .* undecided whether ever: x.2 = 1/2 .*1 proved, .*  undecided whether vacuous: perhaps / only"
  COMMAND ${delcert} prove prove/perhaps.toml)
delcert_cli_test(prove-vacuous-json STATUS 4 ERROR "^$" OUTPUT "\"verdict\": \"vacuous\".*\"never\": \"x > 1\""
  COMMAND ${delcert} prove prove/vacuous.toml --json)
delcert_cli_test(prove-log-nowhere STATUS 3 OUTPUT "^$" ERROR "--log prove/nowhere: no such folder"
  COMMAND ${delcert} prove prove/right.toml --log prove/nowhere)
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
delcert_cli_test(replay STATUS 0 ERROR "^$" FIXTURES proof-log
  OUTPUT "^accepted prove/logs/right.jsonl: 1 of 1 steps of prove/right.toml, 1 goals, [0-9]+ leaves\n$"
  COMMAND ${replay} --claims prove/right.toml prove/logs/right.jsonl)
delcert_cli_test(replay-unknown-claim STATUS 1 ERROR "^$" OUTPUT "^rejected prove/logs/right.jsonl:1: rule claim: .*--claims" FIXTURES proof-log
  COMMAND ${replay} --claims prove/wrong.toml prove/logs/right.jsonl)
# From another folder, where the file is not.
delcert_cli_test(replay-by-the-text-in-the-log STATUS 0 ERROR "^$" FIXTURES proof-log
  OUTPUT "^accepted ../logs/right.jsonl: 1 of 1 steps of right as the text in the log states it .SHA-256 [0-9a-f]+; --claims compares with a file., 1 goals, [0-9]+ leaves\n$"
  COMMAND sh -c "mkdir -p prove/elsewhere && cd prove/elsewhere && $<TARGET_FILE:delcert-replay> ../logs/right.jsonl")
# The file, with a comment more, and the same statement.
delcert_cli_test(replay-changed-file STATUS 1 ERROR "^$" FIXTURES proof-log
  OUTPUT "prove/right.toml has changed since ../logs/right.jsonl was written\nrejected ../logs/right.jsonl:1: rule text: prove/right.toml has changed since the log was written: its SHA-256 is [0-9a-f]+, that of the text in the log [0-9a-f]+\n$"
  COMMAND sh -c "mkdir -p prove/changed/prove && cd prove/changed && (cat ../right.toml && echo '# changed') > prove/right.toml && $<TARGET_FILE:delcert-replay> ../logs/right.jsonl && $<TARGET_FILE:delcert-replay> --claims prove/right.toml ../logs/right.jsonl")
delcert_cli_test(replay-changed-text STATUS 1 ERROR "^$" OUTPUT "^rejected prove/retold.jsonl:1: rule hash: " FIXTURES proof-log
  COMMAND sh -c "sed '1s|name = |name  = |' prove/logs/right.jsonl > prove/retold.jsonl && $<TARGET_FILE:delcert-replay> --claims prove/right.toml prove/retold.jsonl")
# Nobody can pass off a text of their own for a claim of the library.
delcert_cli_test(replay-not-the-library STATUS 1 ERROR "^$" OUTPUT "^rejected prove/not-library/thickness-under-distortion.jsonl:2: thickness-under-distortion / longest-edge-ratio: rule statement: .*proofs/claims/thickness-under-distortion.toml:[0-9]+"
  COMMAND sh -c "$<TARGET_FILE:delcert> prove prove/not-library/claim.toml --log prove/not-library > prove/not-library/table.txt && $<TARGET_FILE:delcert-replay> prove/not-library/thickness-under-distortion.jsonl")
delcert_cli_test(replay-tampered STATUS 1 ERROR "^$" OUTPUT "^rejected prove/tampered.jsonl:2: right / only: rule statement: .*1 5.*, stated is .*1 4" FIXTURES proof-log
  COMMAND sh -c "sed 's|(/ 1 4)|(/ 1 5)|' prove/logs/right.jsonl > prove/tampered.jsonl && $<TARGET_FILE:delcert-replay> --claims prove/right.toml prove/tampered.jsonl")
# Right proofs of something else under the claim's name: another claim, a narrower range, one more hypothesis.
foreach(forgery "statement;[0, 1];0 <= 1;" "ranges;[0, 1/2];x*(1 - x) <= 1/4;" "hypotheses;[0, 1];x*(1 - x) <= 1/4;given = ['y < x']\n")
  list(GET forgery 0 rule)
  list(GET forgery 1 range)
  list(GET forgery 2 claim)
  list(GET forgery 3 more)
  file(WRITE ${folder}/forged-${rule}/right.toml
    "name = 'right'\n[[step]]\nname = 'only'\nforall = { x = '${range}', y = '[0, 1]' }\n${more}claim = '${claim}'\n")
  delcert_cli_test(replay-forged-${rule} STATUS 1 ERROR "^$"
    OUTPUT "^accepted prove/forged-${rule}/right.jsonl: .*rejected prove/forged-${rule}/right.jsonl:2: right / only: rule ${rule}: [^\n]* .prove/right.toml:2.\n$"
    COMMAND sh -c "$<TARGET_FILE:delcert> prove prove/forged-${rule}/right.toml --log prove/forged-${rule} > prove/forged-${rule}/table.txt && $<TARGET_FILE:delcert-replay> --claims prove/forged-${rule}/right.toml prove/forged-${rule}/right.jsonl && $<TARGET_FILE:delcert-replay> --claims prove/right.toml prove/forged-${rule}/right.jsonl")
endforeach()
delcert_cli_test(replay-claims-of-a-folder STATUS 3 OUTPUT "^$" ERROR "delcert-replay: error: prove/malformed.toml: step only: no range" FIXTURES proof-log
  COMMAND ${replay} --claims prove prove/logs/right.jsonl)
delcert_cli_test(replay-no-claims STATUS 3 OUTPUT "^$" ERROR "nowhere.toml: cannot be read" FIXTURES proof-log
  COMMAND ${replay} --claims nowhere.toml prove/logs/right.jsonl)
delcert_cli_test(replay-no-log STATUS 3 OUTPUT "^$" ERROR "delcert-replay: error: prove/no-log.jsonl: "
  COMMAND ${replay} prove/no-log.jsonl)
delcert_cli_test(replay-no-file STATUS 3 OUTPUT "^$" ERROR "there-is-none.jsonl: cannot be read" COMMAND ${replay} there-is-none.jsonl)
delcert_cli_test(replay-usage STATUS 64 OUTPUT "^$" ERROR "^Usage: " COMMAND ${replay})
delcert_cli_test(replay-help STATUS 0 OUTPUT "^Usage: " ERROR "^$" COMMAND ${replay} --help)

# The steps of the library: what is refuted is the paper's or in the list of our readings of it, every constant has its limit, the other program agrees.
file(MAKE_DIRECTORY ${folder}/all)
delcert_cli_test(prove-all STATUS 1 ERROR "^$" OUTPUT " 0 undecided, 0 vacuous, .* refuted with a counterexample .100.0 %.\n$" FIXTURE_SETUP proof-logs
  COMMAND ${delcert} prove --all --mutate --log prove/all)
delcert_cli_test(prove-all-refutes-nothing-else STATUS 0 ERROR "^$" OUTPUT "refuted: "
  COMMAND sh -c "$<TARGET_FILE:delcert> prove --all | grep 'refuted: ' > prove/refuted.txt && sed -n 's|^ *refuted: \\(.*\\) (user)$|\\1|p' prove/refuted.txt | diff - ${CMAKE_CURRENT_SOURCE_DIR}/refuted_readings.txt && ! grep -v -e '(paper)$' -e '(user)$' prove/refuted.txt && cat prove/refuted.txt")
delcert_cli_test(replay-all STATUS 0 ERROR "^$" OUTPUT "^(accepted [^\n]* steps of proofs/claims/[^\n]*\n)+$" FIXTURES proof-logs
  COMMAND sh -c "$<TARGET_FILE:delcert-replay> prove/all/*.jsonl")

# By sums of squares: proved, checked by the other program, and refuted with a factor that is 1 % larger.
file(MAKE_DIRECTORY ${folder}/means)
delcert_cli_test(prove-means STATUS 0 ERROR "^$" FIXTURE_SETUP prove-means
  OUTPUT "means / three .* squares . proved .*means / four .* squares . proved .*5 proved, 0 refuted, 0 undecided"
  COMMAND ${delcert} prove ${PROJECT_SOURCE_DIR}/examples/claims/means.toml --log prove/means)
delcert_cli_test(prove-means-replay STATUS 0 ERROR "^$" FIXTURES prove-means OUTPUT "means"
  COMMAND ${replay} --claims ${PROJECT_SOURCE_DIR}/examples/claims/means.toml prove/means/means.jsonl)
delcert_cli_test(prove-means-too-strong STATUS 1 ERROR "^$" OUTPUT "0 proved, 2 refuted, 0 undecided"
  COMMAND ${delcert} prove ${PROJECT_SOURCE_DIR}/examples/claims/means-too-strong.toml)
