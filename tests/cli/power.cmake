# How far claims can be moved.
set(delcert $<TARGET_FILE:delcert>)
set(claims ${PROJECT_SOURCE_DIR}/examples/claims)

delcert_cli_test(power-slack STATUS 0 ERROR "^$"
  OUTPUT "circumradius-by-thickness / radius . k=1 m=1 . `longest_edge.s./thickness.s.` . bound . × 0[.]49[0-9]* . – ."
  COMMAND ${delcert} power ${claims}/circumradius-by-thickness.toml --evaluations 40 --shape 1,1)
delcert_cli_test(power-refuted STATUS 1 ERROR "^$" OUTPUT "bound . REFUTED ." FIXTURE_SETUP power-found
  COMMAND ${delcert} power ${claims}/circumradius-below-edge.toml --evaluations 200 --shape 2,2 --witnesses power-found)
delcert_cli_test(power-replay STATUS 1 ERROR "^$" OUTPUT ": refuted, ratio" FIXTURES power-found
  COMMAND ${delcert} attack --replay power-found/circumradius-below-edge.radius.2-2.place-1.json)
delcert_cli_test(power-none STATUS 2 ERROR "^$" OUTPUT "`shortest_edge.s.` . summand . no power . no power ."
  COMMAND sh -c "printf 'name = \"redundant\"\\ninstance = \"simplex\"\\n[[show]]\\nclaim = \"circumradius(s) <= longest_edge(s)/(2*thickness(s)) + shortest_edge(s)\"\\n' > redundant.toml; \"$1\" power redundant.toml --evaluations 200 --shape 2,2" sh ${delcert})
delcert_cli_test(power-json STATUS 0 ERROR "^$" OUTPUT "\"scale\": \"[0-9]+/[0-9]+\""
  COMMAND ${delcert} power ${claims}/circumradius-by-thickness.toml --evaluations 40 --shape 1,1 --json)
delcert_cli_test(power-threads STATUS 0 ERROR "^$" OUTPUT "^$"
  COMMAND sh -c "\"$1\" power \"$2\" --evaluations 60 --seed 5 --shape 2,3 --threads 1 > power-1.txt; \"$1\" power \"$2\" --evaluations 60 --seed 5 --shape 2,3 --threads 3 > power-2.txt; cmp power-1.txt power-2.txt"
  sh ${delcert} ${claims}/circumradius-by-thickness.toml)
delcert_cli_test(power-nothing STATUS 3 OUTPUT "^$" ERROR "no claim: name some" COMMAND ${delcert} power)
delcert_cli_test(power-no-evaluations STATUS 3 OUTPUT "^$" ERROR "--evaluations takes 1 to"
  COMMAND ${delcert} power ${claims}/circumradius-by-thickness.toml --evaluations 0)
