# The directed search.
set(delcert $<TARGET_FILE:delcert>)
set(claims ${PROJECT_SOURCE_DIR}/examples/claims)

delcert_cli_test(tighten-loose STATUS 0 ERROR "^$" OUTPUT "circumradius-by-thickness / radius . k=1 m=1 . 0[.]5 . [0-9]+ . holds .\n$"
  COMMAND ${delcert} tighten ${claims}/circumradius-by-thickness.toml --evaluations 40 --shape 1,1)
delcert_cli_test(tighten-equality STATUS 0 ERROR "^$" OUTPUT " 1 . [0-9]+ . equality, exactly .\n$"
  COMMAND ${delcert} tighten ${claims}/circumradius-from-below.toml --evaluations 40 --shape 1,1)
delcert_cli_test(tighten-false STATUS 1 ERROR "^$" OUTPUT "REFUTED" FIXTURE_SETUP tighten-found
  COMMAND ${delcert} tighten ${claims}/circumradius-below-edge.toml --evaluations 200 --shape 2,2 --witnesses tighten-found)
delcert_cli_test(tighten-replay STATUS 1 ERROR "^$" OUTPUT ": refuted, ratio" FIXTURES tighten-found
  COMMAND ${delcert} attack --replay tighten-found/circumradius-below-edge.radius.2-2.json)
delcert_cli_test(tighten-json STATUS 0 ERROR "^$" OUTPUT "\"note\": \"equality, exactly\""
  COMMAND ${delcert} tighten ${claims}/circumradius-from-below.toml --evaluations 40 --shape 1,1 --json)
delcert_cli_test(tighten-same-seed STATUS 0 ERROR "^$" OUTPUT "^$"
  COMMAND sh -c "\"$1\" tighten \"$2\" --evaluations 100 --seed 5 --shape 2,3 > tighten-1.txt && \"$1\" tighten \"$2\" --evaluations 100 --seed 5 --shape 2,3 > tighten-2.txt && cmp tighten-1.txt tighten-2.txt"
  sh ${delcert} ${claims}/circumradius-by-thickness.toml)
# From half of a log the rest is found, from that of another seed nothing.
delcert_cli_test(tighten-log STATUS 3 OUTPUT "^$" ERROR "half.jsonl:1: the log of another search"
  COMMAND sh -c "\"$1\" tighten \"$2\" --evaluations 50 --seed 5 --log whole.jsonl > tighten-3.txt && head -n 4 whole.jsonl > half.jsonl && \"$1\" tighten \"$2\" --evaluations 50 --seed 5 --log half.jsonl --threads 3 > tighten-4.txt && cmp tighten-3.txt tighten-4.txt  || exit 1; \"$1\" tighten \"$2\" --evaluations 50 --seed 6 --log half.jsonl"
  sh ${delcert} ${claims}/circumradius-by-thickness.toml)
delcert_cli_test(tighten-nothing STATUS 3 OUTPUT "^$" ERROR "no claim: name some" COMMAND ${delcert} tighten)
delcert_cli_test(tighten-no-evaluations STATUS 3 OUTPUT "^$" ERROR "--evaluations takes 1 to"
  COMMAND ${delcert} tighten ${claims}/circumradius-from-below.toml --evaluations 0)
delcert_cli_test(tighten-impossible-shape STATUS 3 OUTPUT "^$" ERROR "--shape 3,2: the class simplex"
  COMMAND ${delcert} tighten ${claims}/circumradius-from-below.toml --shape 3,2)
