# The list of claims and what they can speak of.
set(delcert $<TARGET_FILE:delcert>)
set(claims ${PROJECT_SOURCE_DIR}/examples/claims)
file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/malformed-claim.toml
  "name = 'a'\ninstance = 'simplex'\n[[show]]\nclaim = 'circumradus(s) <= 1'\n")

delcert_cli_test(claims STATUS 0 ERROR "^$" OUTPUT "thickness-and-singular-value +lem:bound.skP +paper +simplex\n" COMMAND ${delcert} claims)
delcert_cli_test(claims-show STATUS 0 ERROR "^$" OUTPUT "^thickness-and-singular-value: .*source: lem:bound.skP .paper.*show .*twin, to be refuted: "
  COMMAND ${delcert} claims show thickness-and-singular-value)
delcert_cli_test(claims-show-file STATUS 0 ERROR "^$" OUTPUT "show radius: circumradius.s. <= longest_edge.s.\n"
  COMMAND ${delcert} claims show ${claims}/circumradius-below-edge.toml)
delcert_cli_test(claims-classes STATUS 0 ERROR "^$" OUTPUT "simplex: a non-degenerate.*s, a simplex\n" COMMAND ${delcert} claims classes)
delcert_cli_test(claims-functions STATUS 0 ERROR "^$"
  OUTPUT "`volume.simplex. -> number` .*`sum.x in set: number. -> number` .*`constant_c.m, mu0.`" COMMAND ${delcert} claims functions)
delcert_cli_test(claims-functions-with-a-word STATUS 0 ERROR "^$" OUTPUT "^. `circumradius.simplex. -> number` "
  COMMAND ${delcert} claims functions circumradius)
delcert_cli_test(claims-functions-with-a-word-only STATUS 0 ERROR "^$" OUTPUT "^0\n$"
  COMMAND sh -c "\"$1\" claims functions circumradius | grep -cv circumradius || true" sh ${delcert})
delcert_cli_test(claims-functions-with-no-word STATUS 3 OUTPUT "^$"
  ERROR "^delcert: error: nothing that formulas can use has .circumradus. in its name or meaning, did you mean circumradius.\n$"
  COMMAND ${delcert} claims functions circumradus)
delcert_cli_test(claims-unknown STATUS 3 OUTPUT "^$" ERROR "no claim is called nothing" COMMAND ${delcert} claims show nothing)
delcert_cli_test(claims-unknown-subcommand STATUS 64 OUTPUT "^$" ERROR "^delcert: error: " COMMAND ${delcert} claims shwo)
delcert_cli_test(claims-malformed STATUS 3 OUTPUT "^$" ERROR "malformed-claim.toml:4:[0-9]+: "
  COMMAND ${delcert} claims show malformed-claim.toml)
