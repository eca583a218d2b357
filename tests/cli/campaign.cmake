# delcert campaign and attack --part: what they refuse at the command line. What they do is in campaign_parts_test.cpp.
set(delcert $<TARGET_FILE:delcert>)
set(claim ${PROJECT_SOURCE_DIR}/examples/claims/circumradius-from-below.toml)

delcert_cli_test(campaign-help STATUS 0 ERROR "^$" OUTPUT "merge.*table.*status.*recheck.*Examples:" COMMAND ${delcert} campaign --help)
delcert_cli_test(campaign-merge-help STATUS 0 ERROR "^$" OUTPUT "Exit status: 0 every block" COMMAND ${delcert} campaign merge --help)
delcert_cli_test(campaign-alone STATUS 64 OUTPUT "^$" ERROR "^delcert: error: .*see delcert --help" COMMAND ${delcert} campaign)
delcert_cli_test(campaign-unknown STATUS 64 OUTPUT "^$" ERROR "^delcert: error: " COMMAND ${delcert} campaign marge)
delcert_cli_test(campaign-merge-nothing STATUS 64 OUTPUT "^$" ERROR "logs is required" COMMAND ${delcert} campaign merge --output none.jsonl)
delcert_cli_test(campaign-merge-nowhere STATUS 64 OUTPUT "^$" ERROR "--output is required" COMMAND ${delcert} campaign merge campaign-whole.jsonl)
foreach(subcommand status table recheck)
  delcert_cli_test(campaign-${subcommand}-no-log STATUS 3 OUTPUT "^$" ERROR "no-such-log.jsonl: cannot be read"
    COMMAND ${delcert} campaign ${subcommand} no-such-log.jsonl)
  delcert_cli_test(campaign-${subcommand}-something-else STATUS 3 OUTPUT "^$" ERROR "points.txt:1: " FIXTURES run-points
    COMMAND ${delcert} campaign ${subcommand} points.txt)
endforeach()

delcert_cli_test(attack-part-without-log STATUS 3 OUTPUT "^$" ERROR "--part needs a --log" COMMAND ${delcert} attack ${claim} --part 1/2)
delcert_cli_test(attack-until-without-log STATUS 3 OUTPUT "^$" ERROR "--until needs a --log" COMMAND ${delcert} attack ${claim} --until 8h)
foreach(part 0/2 3/2 1 1/ /2 a/b 1/2/3 -1/2)
  string(MAKE_C_IDENTIFIER "${part}" name)
  delcert_cli_test(attack-part-${name} STATUS 3 OUTPUT "^$" ERROR "--part ${part}: a part such as 3/8 was expected"
    COMMAND ${delcert} attack ${claim} --part=${part} --log attack-part-none.jsonl)
endforeach()
delcert_cli_test(attack-until-what STATUS 3 OUTPUT "^$" ERROR "--until 8x: a time was expected"
  COMMAND ${delcert} attack ${claim} --until 8x --log attack-part-none.jsonl)
delcert_cli_test(attack-progress-every-what STATUS 3 OUTPUT "^$" ERROR "--progress-every 0s: a time was expected"
  COMMAND ${delcert} attack ${claim} --progress-every 0s --log attack-part-none.jsonl)

# A log of another commit, from a build before, is no log of this campaign.
delcert_cli_test(campaign-part STATUS 0 ERROR "^$" OUTPUT "^part 1/2: 1 of 1 blocks are finished in campaign-part.jsonl\n$" FIXTURE_SETUP campaign-part
  COMMAND sh -c "rm -f campaign-part.jsonl && exec \"$1\" attack \"$2\" --shape 1,1 --samples 300 --part 1/2 --log campaign-part.jsonl" sh ${delcert} ${claim})
delcert_cli_test(campaign-part-json STATUS 0 ERROR "^$" OUTPUT "\"part\": .*\"finished\": 1" FIXTURES campaign-part
  COMMAND ${delcert} attack ${claim} --shape 1,1 --samples 300 --part 1/2 --log campaign-part.jsonl --json)
delcert_cli_test(campaign-table-of-a-part STATUS 3 OUTPUT "^$" ERROR "campaign-part.jsonl: the log of part 1/2" FIXTURES campaign-part
  COMMAND ${delcert} campaign table campaign-part.jsonl)
delcert_cli_test(campaign-merge-of-a-part STATUS 2 OUTPUT "^$" ERROR "block 1 .circumradius-from-below, k=1, m=1, samples 250 to 299. is missing; the first is of part 2/2"
  FIXTURES campaign-part COMMAND ${delcert} campaign merge campaign-part.jsonl --output campaign-none.jsonl)
delcert_cli_test(campaign-status STATUS 0 ERROR "^$" OUTPUT "campaign-part.jsonl +1/2 +finished +1/1 +100 % .*1 of 1 blocks; 1 of 1 logs finished, 0 running, 0 stopped\n$"
  FIXTURES campaign-part COMMAND ${delcert} campaign status campaign-part.jsonl)
delcert_cli_test(campaign-recheck STATUS 0 ERROR "^$" OUTPUT "^1 of 1 blocks rechecked are as the log says, of 1 in all .--seed 7.\n$"
  FIXTURES campaign-part COMMAND ${delcert} campaign recheck campaign-part.jsonl --share 1/2 --seed 7)
delcert_cli_test(campaign-recheck-json STATUS 0 ERROR "^$" OUTPUT "\"rechecked\": 1,.*\"differences\": ..,.*\"noticeable_blocks\": 1"
  FIXTURES campaign-part COMMAND ${delcert} campaign recheck campaign-part.jsonl --json)
foreach(share 0 2 -1/2 half)
  string(MAKE_C_IDENTIFIER "${share}" name)
  delcert_cli_test(campaign-recheck-share-${name} STATUS 3 OUTPUT "^$" ERROR "--share " FIXTURES campaign-part
    COMMAND ${delcert} campaign recheck campaign-part.jsonl --share=${share})
endforeach()
delcert_cli_test(campaign-merge-json STATUS 0 ERROR "^$" OUTPUT "\"blocks\": 1,.*\"logs\": " FIXTURE_SETUP campaign-whole
  COMMAND sh -c "rm -f campaign-one.jsonl && \"$1\" attack \"$2\" --shape 1,1 --samples 200 --log campaign-one.jsonl >/dev/null; \"$1\" campaign merge campaign-one.jsonl --output campaign-whole.jsonl --json"
    sh ${delcert} ${claim})
delcert_cli_test(campaign-table STATUS 0 ERROR "^$" OUTPUT "circumradius-from-below / radius . k=1 m=1 . ℝᵐ . 200 " FIXTURES campaign-whole
  COMMAND ${delcert} campaign table campaign-whole.jsonl --least 50)
delcert_cli_test(campaign-table-full-disk STATUS 70 OUTPUT "^$" ERROR "cannot write to standard output" FIXTURES campaign-whole
  COMMAND sh -c "\"$1\" campaign table campaign-whole.jsonl > /dev/full" sh ${delcert})

add_executable(test_campaign_parts campaign_parts_test.cpp)
target_link_libraries(test_campaign_parts PRIVATE delcert_warnings GTest::gtest_main)
target_include_directories(test_campaign_parts PRIVATE ${PROJECT_SOURCE_DIR})
target_compile_definitions(test_campaign_parts PRIVATE DELCERT_PROGRAM="$<TARGET_FILE:delcert>"
  DELCERT_CLAIMS="${PROJECT_SOURCE_DIR}/examples/claims")
add_dependencies(test_campaign_parts delcert)
gtest_discover_tests(test_campaign_parts DISCOVERY_TIMEOUT 60 PROPERTIES TIMEOUT 600)
