# Steps written as files for Coq; that Coq accepts them is tested in tests/proofs/formal.
set(formalise $<TARGET_FILE:delcert> formalise)
set(folder ${CMAKE_CURRENT_BINARY_DIR}/formalise)
file(MAKE_DIRECTORY ${folder})
file(WRITE ${folder}/one.toml
  "name = 'one'\n[[step]]\nname = 'a-bound'\nforall = { x = '[0, 1]' }\nconstants = { c = '1/4' }\nclaim = 'x*(1 - x) <= c'\n")

delcert_cli_test(formalise-help COMMAND ${formalise} --help STATUS 0 OUTPUT "--into.*Examples:" ERROR "^$")
delcert_cli_test(formalise-step COMMAND ${formalise} formalise/one.toml --into formalise/one STATUS 0
  OUTPUT "^one__a_bound one/a-bound certificate\n$" ERROR "^$")
delcert_cli_test(formalise-false COMMAND ${formalise} formalise/one.toml --constant c=1/5 --into formalise/false STATUS 0
  OUTPUT "^one__a_bound one/a-bound refutation\n$" ERROR "^$")
delcert_cli_test(formalise-unknown-constant COMMAND ${formalise} formalise/one.toml --constant d=1/5 --into formalise/no
  STATUS 3 OUTPUT "^$" ERROR "--constant d=1/5: a-bound has no such constant")
delcert_cli_test(formalise-no-constant COMMAND ${formalise} formalise/one.toml --constant c --into formalise/no
  STATUS 3 OUTPUT "^$" ERROR "--constant c: expected NAME=VALUE")
delcert_cli_test(formalise-unknown-step COMMAND ${formalise} formalise/one.toml --step no --into formalise/no
  STATUS 3 OUTPUT "^$" ERROR "no step of the claims named is called no")
delcert_cli_test(formalise-nothing COMMAND ${formalise} STATUS 3 OUTPUT "^$" ERROR "no claim: name some, or say --all")
delcert_cli_test(formalise-no-folder COMMAND ${formalise} formalise/one.toml --into /dev/null/no STATUS 3 OUTPUT "^$"
  ERROR "/dev/null/no: the folder cannot be created")
