# Attacks on claims: what holds, what is refuted, witnesses, replay, twins, campaigns that are interrupted.
set(delcert $<TARGET_FILE:delcert>)
set(claims ${PROJECT_SOURCE_DIR}/examples/claims)
file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/never.toml
  "name = 'never'\ninstance = 'simplex'\ngiven = ['k = 0']\n[[show]]\nclaim = 'k = 0'\n")
file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/much.toml
  "name = 'much'\ninstance = 'simplex'\n[[show]]\nclaim = 'altitude(s, 9) > 0'\n")
file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/broken-witness.json "{}\n")
file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/diary.txt "my diary\n")

delcert_cli_test(attack-true STATUS 0 ERROR "^$" OUTPUT "circumradius-from-below / radius . k=2 m=2 .* not refuted by [0-9]+ instances .\n\n.*circumradius-from-below / radius: not refuted by 1[0-9][0-9] instances in 2 shapes, of them boundary "
  COMMAND ${delcert} attack ${claims}/circumradius-from-below.toml --samples 100 --shape 1,1 --shape 2,2)
# Ten instances are not two thousand.
delcert_cli_test(attack-hardly STATUS 2 ERROR "^$" OUTPUT "hardly attacked: 10 instances .\n\n.*: hardly attacked: 10 instances in 1 shape, .* 1 in 3 such"
  COMMAND ${delcert} attack ${claims}/circumradius-from-below.toml --samples 10 --shape 2,2)
delcert_cli_test(attack-enough STATUS 0 ERROR "^$" OUTPUT "not refuted by 10 instances .\n"
  COMMAND ${delcert} attack ${claims}/circumradius-from-below.toml --samples 10 --shape 2,2 --least-instances 10)
delcert_cli_test(attack-false STATUS 1 ERROR "^$" FIXTURE_SETUP attack-found
  OUTPUT "REFUTED.*refuted: circumradius-below-edge / radius in k=2 m=2.*\"points\""
  COMMAND ${delcert} attack ${claims}/circumradius-below-edge.toml --samples 100 --shape 2,2 --seed 1 --witnesses attack-found)
delcert_cli_test(attack-replay STATUS 1 ERROR "^$" FIXTURES attack-found
  OUTPUT "the hypotheses are proved\ncircumradius.s. <= longest_edge.s.: refuted, ratio [1-9]"
  COMMAND ${delcert} attack --replay attack-found/circumradius-below-edge.radius.json)
delcert_cli_test(attack-replay-of-another-claim STATUS 0 ERROR "^$" FIXTURES attack-found OUTPUT ": proved, ratio 0[.]"
  COMMAND ${delcert} attack ${claims}/circumradius-by-thickness.toml --replay attack-found/circumradius-below-edge.radius.json)
delcert_cli_test(attack-json STATUS 1 ERROR "^$" OUTPUT "^{\n \"seed\": 7,\n \"least_instances\": 100,.*\"totals\": .*\"refutations\": .*\"delcert_witness\": 2"
  COMMAND ${delcert} attack ${claims}/circumradius-below-edge.toml --samples 50 --shape 2,2 --seed 7 --json)
delcert_cli_test(attack-never-met STATUS 2 ERROR "^$" OUTPUT "not attacked: never, no sample met its hypotheses"
  COMMAND ${delcert} attack never.toml --samples 5 --shape 1,1)
delcert_cli_test(attack-asks-too-much STATUS 3 OUTPUT "^$" ERROR "^delcert: error: much .k=1, m=1.: .*vert"
  COMMAND ${delcert} attack much.toml --samples 5 --shape 1,1)

delcert_cli_test(attack-twins STATUS 0 ERROR "^$" OUTPUT "^1 of 1 twins refuted\n$" FIXTURE_SETUP attack-twins
  COMMAND ${delcert} attack ${claims}/circumradius-by-thickness.toml --twins --samples 100 --witnesses attack-twins)
delcert_cli_test(attack-twins-stored STATUS 0 ERROR "^$" OUTPUT "^1 of 1 twins refuted\n$" FIXTURES attack-twins
  COMMAND ${delcert} attack ${claims}/circumradius-by-thickness.toml --twins --stored --witnesses attack-twins)
delcert_cli_test(attack-twin-replay STATUS 1 ERROR "^$" OUTPUT "circumradius-by-thickness/radius-twin: .*refuted" FIXTURES attack-twins
  COMMAND ${delcert} attack --replay attack-twins/circumradius-by-thickness.radius-twin.json)
delcert_cli_test(attack-twins-none-stored STATUS 1 ERROR "^$" OUTPUT "not refuted: circumradius-by-thickness/radius-twin\n0 of 1"
  COMMAND ${delcert} attack ${claims}/circumradius-by-thickness.toml --twins --stored --witnesses attack-nowhere)
delcert_cli_test(attack-twins-without STATUS 1 ERROR "^$" OUTPUT "neither twin nor reason: circumradius-below-edge/radius\n0 of 1"
  COMMAND ${delcert} attack ${claims}/circumradius-below-edge.toml --twins)
delcert_cli_test(attack-twins-json STATUS 1 ERROR "^$" OUTPUT "^{\n \"twins\": .*\"refuted\": false"
  COMMAND ${delcert} attack ${claims}/circumradius-below-edge.toml --twins --json)

delcert_cli_test(attack-no-samples STATUS 3 OUTPUT "^$" ERROR "--samples takes 1 to"
  COMMAND ${delcert} attack thickness-and-singular-value --samples 0)
delcert_cli_test(attack-negative-samples STATUS 3 OUTPUT "^$" ERROR "--samples takes 1 to"
  COMMAND ${delcert} attack thickness-and-singular-value --samples=-1)
delcert_cli_test(attack-too-many-samples STATUS 3 OUTPUT "^$" ERROR "--samples takes 1 to"
  COMMAND ${delcert} attack thickness-and-singular-value --samples 10000000001)
delcert_cli_test(attack-nothing STATUS 3 OUTPUT "^$" ERROR "no claim: name some" COMMAND ${delcert} attack)
delcert_cli_test(attack-unknown-claim STATUS 3 OUTPUT "^$" ERROR "did you mean thickness-and-singular-value[?]"
  COMMAND ${delcert} attack thickness-and-singular-valu)
delcert_cli_test(attack-impossible-shape STATUS 3 OUTPUT "^$" ERROR "--shape 3,2: the class simplex of .* has k=1 m=1"
  COMMAND ${delcert} attack thickness-and-singular-value --shape 3,2)
delcert_cli_test(attack-shape-of-no-class STATUS 3 OUTPUT "^$" ERROR "no claim is about a class with this --shape"
  COMMAND ${delcert} attack --all --shape 9,2)
delcert_cli_test(attack-no-witness STATUS 3 OUTPUT "^$" ERROR "no-such-file.json: cannot be read"
  COMMAND ${delcert} attack --replay no-such-file.json)
delcert_cli_test(attack-broken-witness STATUS 3 OUTPUT "^$" ERROR "broken-witness.json: not a witness"
  COMMAND ${delcert} attack --replay broken-witness.json)
delcert_cli_test(attack-log-of-something-else STATUS 3 OUTPUT "^$" ERROR "diary.txt:1: "
  COMMAND ${delcert} attack thickness-and-singular-value --log diary.txt FIXTURE_SETUP attack-diary)
delcert_cli_test(attack-log-of-something-else-is-left STATUS 0 OUTPUT "^my diary\n$" FIXTURES attack-diary
  COMMAND ${CMAKE_COMMAND} -E cat diary.txt)

# Killed, interrupted and resumed; more threads.
add_executable(test_campaign campaign_test.cpp)
target_link_libraries(test_campaign PRIVATE delcert_warnings GTest::gtest_main)
target_include_directories(test_campaign PRIVATE ${PROJECT_SOURCE_DIR})
target_compile_definitions(test_campaign PRIVATE DELCERT_PROGRAM="$<TARGET_FILE:delcert>" DELCERT_CLAIMS="${claims}")
add_dependencies(test_campaign delcert)
gtest_discover_tests(test_campaign DISCOVERY_TIMEOUT 60 PROPERTIES TIMEOUT 600)

# Points of one's own: what holds, its twins, and what the draws hardly meet.
foreach(claim whitney-angle-bound protection-implies-thickness)
  delcert_cli_test(attack-${claim} STATUS 0 ERROR "^$"
    OUTPUT "${claim}: not refuted by .*points: ${claim}, [0-9]+ of [0-9]+ draws met the constraints .[0-9.]+ %.\n$|points: ${claim}"
    COMMAND ${delcert} attack ${claims}/${claim}.toml --samples 200 --least 20)
  delcert_cli_test(attack-${claim}-twins STATUS 0 ERROR "^$" OUTPUT "^1 of 1 twins refuted\n$"
    COMMAND ${delcert} attack ${claims}/${claim}.toml --twins --samples 2000)
endforeach()
delcert_cli_test(attack-means-of-altitudes STATUS 0 ERROR "^$" OUTPUT "means-of-altitudes / inverse: not refuted"
  COMMAND ${delcert} attack ${claims}/means-of-altitudes.toml --samples 200 --shape 1,1 --shape 2,2 --shape 3,3)
delcert_cli_test(attack-means-of-altitudes-twins STATUS 0 ERROR "^$" OUTPUT "^3 of 3 twins refuted\n$"
  COMMAND ${delcert} attack ${claims}/means-of-altitudes.toml --twins --samples 500 --shape 1,1 --shape 2,2)
file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/rare.toml
  "name = 'rare'\ninstance = 'point-set'\n[points]\nnumber = 2\ndimension = 2\nbox = '[0, 1]'\n"
  "constraints = ['edge(p, 0, 1) > 2']\n[[show]]\nclaim = 'n = 2'\nno_twin = 'a test'\n")
delcert_cli_test(attack-points-hardly-drawn STATUS 2 ERROR "^$"
  OUTPUT "points: rare, 0 of 50 draws met the constraints .0.0 %., hardly any: least_acceptance is 1/20\n"
  COMMAND ${delcert} attack rare.toml --samples 50 --least 0)
