# The directed search.
set(delcert $<TARGET_FILE:delcert>)
set(claims ${PROJECT_SOURCE_DIR}/examples/claims)
delcert_cli_test(tighten-guess STATUS 0 ERROR "^$" OUTPUT "\"guess\": \"looks like 1/4, not attained\""
  COMMAND ${delcert} tighten ${claims}/circumradius-by-thickness.toml --shape 2,2 --seed 1 --json)

delcert_cli_test(tighten-loose STATUS 0 ERROR "^$" OUTPUT "circumradius-by-thickness / radius . k=1 m=1 . 0[.]5 . [0-9]+ . holds; looks like 1/2 .a guess. .\n$"
  COMMAND ${delcert} tighten ${claims}/circumradius-by-thickness.toml --evaluations 40 --shape 1,1)
delcert_cli_test(tighten-equality STATUS 0 ERROR "^$" OUTPUT " 1 . [0-9]+ . equality, exactly .\n$"
  COMMAND ${delcert} tighten ${claims}/circumradius-from-below.toml --evaluations 40 --shape 1,1)
delcert_cli_test(tighten-false STATUS 1 ERROR "^$" OUTPUT "REFUTED; looks unbounded .a guess. ." FIXTURE_SETUP tighten-found
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
# The exponent of a quantity: a triangle of thickness v has a circumradius of some Δ/v.
delcert_cli_test(tighten-along STATUS 0 ERROR "^$"
  OUTPUT "circumradius-by-thickness / radius . k=2 m=2 . `thickness.s.` . -1 . -(0[.]9[0-9]|1[.]0[0-9]) ± 0[.][0-9]+ . 0[.][0-9]+ . 4 of 4 ."
  COMMAND ${delcert} tighten ${claims}/circumradius-by-thickness.toml --evaluations 800 --seed 1 --shape 2,2 --along "thickness(s)" --values 1/8,1/32,1/128,1/512)
delcert_cli_test(tighten-along-json STATUS 0 ERROR "^$" OUTPUT "\"exponent_in_bound\": \"0\".*\"exponent_found\": [-0-9.e]+.*\"ratio_lower\""
  COMMAND ${delcert} tighten ${claims}/circumradius-by-thickness.toml --evaluations 40 --shape 1,1 --shape 2,2 --shape 3,3 --along k --json)
delcert_cli_test(tighten-along-nothing STATUS 3 OUTPUT "^$" ERROR "\"thicknes.s.\" is no quantity of circumradius-by-thickness: column 1: "
  COMMAND ${delcert} tighten ${claims}/circumradius-by-thickness.toml --along "thicknes(s)" --values 1/8,1/16,1/32)
delcert_cli_test(tighten-along-two-values STATUS 3 OUTPUT "^$" ERROR "three values or more"
  COMMAND ${delcert} tighten ${claims}/circumradius-by-thickness.toml --along "thickness(s)" --values 1/8,1/16)
delcert_cli_test(tighten-values-of-nothing STATUS 64 OUTPUT "^$" ERROR "--along"
  COMMAND ${delcert} tighten ${claims}/circumradius-by-thickness.toml --values 1/8,1/16,1/32)
