# delcert export, and what it refuses.
set(delcert $<TARGET_FILE:delcert>)
find_package(Python3 3.11 REQUIRED COMPONENTS Interpreter)

# delcert_export_test(NAME CERTIFICATE FIXTURE STATUS n [OUTPUT regex] [ERROR regex] OPTIONS …): into a file that is not
# there before, and is not there afterwards, nor any part of it, unless the status is 0.
function(delcert_export_test name)
  cmake_parse_arguments(PARSE_ARGV 1 ARG "" "STATUS;OUTPUT;ERROR;CERTIFICATE;FIXTURE" "OPTIONS")
  if(ARG_STATUS EQUAL 0)
    set(ARG_ERROR "^$")
  else()
    set(ARG_OUTPUT "^$")
  endif()
  delcert_cli_test(export-${name} STATUS ${ARG_STATUS} OUTPUT "${ARG_OUTPUT}" ERROR "${ARG_ERROR}" FIXTURES ${ARG_FIXTURE}
    COMMAND ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/export_once.sh export-${name}.out ${delcert} export ${ARG_CERTIFICATE} ${ARG_OPTIONS})
endfunction()

foreach(copies quotient cell glued)
  delcert_export_test(json-${copies} CERTIFICATE run-square.json.zst FIXTURE run-square STATUS 0
    OPTIONS --format json --copies ${copies} OUTPUT "vertices, [0-9]+ simplices of dimension 2, approximate, not verified")
endforeach()
foreach(format vtu medit gmsh off obj ply csv)
  delcert_export_test(${format} CERTIFICATE run-square.json.zst FIXTURE run-square STATUS 0
    OPTIONS --format ${format} OUTPUT "vertices, 798 simplices of dimension 2, approximate, not verified")
endforeach()
foreach(format simplex-tree regina isosig)
  delcert_export_test(${format} CERTIFICATE run-square.json.zst FIXTURE run-square STATUS 0
    OPTIONS --format ${format} OUTPUT ": 399 vertices, 798 simplices of dimension 2, not verified")
endforeach()
foreach(format vtu medit gmsh csv simplex-tree regina)
  delcert_export_test(${format}-of-dimension-3 CERTIFICATE run-torus-3.json.zst FIXTURE run-torus-3 STATUS 0
    OPTIONS --format ${format} OUTPUT "simplices of dimension 3")
endforeach()
foreach(format isosig snappea)
  delcert_export_test(${format}-simplified CERTIFICATE run-torus-3.json.zst FIXTURE run-torus-3 STATUS 0
    OPTIONS --format ${format} --simplify
    OUTPUT "simplified from [0-9]+ to [0-9]+ simplices by [0-9]+ contractions of edges, homology Z, Z.3, Z.3, Z before and after, not verified")
endforeach()
delcert_export_test(signature-too-large CERTIFICATE run-torus-3.json.zst FIXTURE run-torus-3 STATUS 3 OPTIONS --format isosig
  ERROR "at most 2000 simplices, and these are [0-9]+: try --simplify\n$")
foreach(format off obj ply)
  delcert_export_test(${format}-of-dimension-3 CERTIFICATE run-torus-3.json.zst FIXTURE run-torus-3 STATUS 3 OPTIONS --format ${format}
    ERROR "run-torus-3.json.zst: ${format} holds complexes of dimension 2, and this one has dimension 3\n$")
endforeach()
delcert_export_test(vtu-of-dimension-4 CERTIFICATE export-torus-4.json FIXTURE export-forged STATUS 3 OPTIONS --format vtu
  ERROR "vtu holds complexes of dimension 1 to 3, and this one has dimension 4\n$")
delcert_export_test(off-of-dimension-4 CERTIFICATE export-torus-4.json FIXTURE export-forged STATUS 3 OPTIONS --format off
  ERROR "off holds complexes of dimension 2, and this one has dimension 4\n$")
delcert_export_test(snappea-of-a-surface CERTIFICATE run-square.json.zst FIXTURE run-square STATUS 3 OPTIONS --format snappea
  ERROR "snappea holds complexes of dimension 3, and this one has dimension 2\n$")
delcert_export_test(simplify-with-coordinates CERTIFICATE run-square.json.zst FIXTURE run-square STATUS 64
  OPTIONS --format vtu --simplify ERROR "--simplify: the result would have no measures")
delcert_export_test(simplify-a-ball CERTIFICATE run-disk.json.zst FIXTURE run-disk STATUS 3 OPTIONS --format regina --simplify
  ERROR "--simplify is for closed complexes; this one has a boundary")
delcert_export_test(copies-without-coordinates CERTIFICATE run-square.json.zst FIXTURE run-square STATUS 64
  OPTIONS --format regina --copies cell ERROR "--copies: there are no coordinates in files of the format regina")
delcert_export_test(exact-without-room CERTIFICATE run-square.json.zst FIXTURE run-square STATUS 64
  OPTIONS --format vtu --exact ERROR "--exact: there are no exact numbers in files of the format vtu")
delcert_export_test(only-verified CERTIFICATE run-square.json.zst FIXTURE run-square STATUS 0
  OPTIONS --format json --only-verified OUTPUT "approximate, verified")
delcert_export_test(unknown-format CERTIFICATE run-square.json.zst FIXTURE run-square STATUS 64
  OPTIONS --format jsn ERROR "no format jsn, did you mean json")
delcert_export_test(unknown-copies CERTIFICATE run-square.json.zst FIXTURE run-square STATUS 64
  OPTIONS --format json --copies cel ERROR "cel, did you mean cell")
delcert_export_test(model-of-another-family CERTIFICATE run-square.json.zst FIXTURE run-square STATUS 3
  OPTIONS --format json --model gnomonic ERROR "run-square.json.zst: the family flat-torus is not drawn in the model gnomonic, but in: unit")
delcert_export_test(no-certificate CERTIFICATE points.txt FIXTURE run-points STATUS 3 OPTIONS --format json ERROR "points.txt: ")

# A certificate that was changed has a wrong seal; with its seal made right again the checker refuses it.
delcert_cli_test(export-forge STATUS 0 FIXTURES run-circle-plain FIXTURE_SETUP export-forged
  COMMAND ${Python3_EXECUTABLE} ${CMAKE_CURRENT_LIST_DIR}/forge.py export-circle.json export-unsealed.json export-resealed.json
    export-torus-4.json)
delcert_cli_test(export-circle STATUS 0 FIXTURE_SETUP run-circle-plain
  COMMAND ${delcert} certify --manifold circle --radius 1/30 --output export-circle.json)
delcert_export_test(wrong-seal CERTIFICATE export-unsealed.json FIXTURE export-forged STATUS 3 OPTIONS --format json
  ERROR "export-unsealed.json: the seal is wrong")
delcert_export_test(rejected CERTIFICATE export-resealed.json FIXTURE export-forged STATUS 1
  OPTIONS --format json --only-verified ERROR "delcert-check rejects it")
delcert_export_test(not-asked CERTIFICATE export-resealed.json FIXTURE export-forged STATUS 0
  OPTIONS --format json OUTPUT "not verified")
delcert_cli_test(export-onto-a-file STATUS 3 OUTPUT "^$" ERROR "points.txt: the file exists and is not replaced\n$" FIXTURES run-points run-square
  COMMAND ${delcert} export run-square.json.zst --format json --output points.txt)
delcert_cli_test(export-full-disk STATUS 70 ERROR "cannot write" FIXTURES run-square
  COMMAND sh -c "\"$1\" export run-square.json.zst --format json > /dev/full" sh ${delcert})
