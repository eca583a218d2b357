# sample, certify, check, info, one after the other on the same files, and what each refuses.
set(delcert $<TARGET_FILE:delcert>)
set(check $<TARGET_FILE:delcert-check>)

# delcert_run_test(NAME manifold-and-net-options… [LEVELS regex]): certified, and every claimed level verified.
function(delcert_run_test name)
  cmake_parse_arguments(PARSE_ARGV 1 ARG "" "LEVELS" "")
  delcert_cli_test(certify-${name} STATUS 0 OUTPUT "${ARG_LEVELS}" ERROR "^$" FIXTURE_SETUP run-${name}
    COMMAND ${delcert} certify ${ARG_UNPARSED_ARGUMENTS} --output run-${name}.json.zst)
  delcert_cli_test(verify-${name} STATUS 0 OUTPUT "verified" ERROR "^$" FIXTURES run-${name}
    COMMAND ${check} run-${name}.json.zst)
endfunction()

set(all "levels\n  0 .*\n  1 .*\n  2 .*\n  2s .*\n  3 .*\n  4 .*\n  5 .*\n  6 ")
set(ball "levels\n  0 .*\n  1 .*\n  2 .*\n  2s .*\n  3 .*\n  4 .*\n  not reached: levels 5 and 6")
delcert_run_test(circle --manifold circle --radius 1/30 LEVELS "${all}")
delcert_run_test(square --manifold torus-2 --radius 1/24 --seed 1 LEVELS "${all}")
delcert_run_test(square-sharper --manifold torus-2 --radius 1/24 --seed 1 --hypotheses sharper
  LEVELS "tolerance 0x2201p-47 = .*levels\n  0   input: net, Hypotheses 1, the sharper Hypotheses 2\n  1 .*\n  6 ")
delcert_run_test(space-sharper --manifold torus-3 --radius 1/24 --seed 1 --hypotheses sharper
  LEVELS "input: net, Hypotheses 1, the sharper Hypotheses 2\n  1 .*\n  6 ")
delcert_run_test(space-printed --manifold torus-3 --radius 1/24 --seed 1 --hypotheses printed
  LEVELS "input: net, Hypotheses 1, Hypotheses 2\n  1 .*\n  6 ")
delcert_run_test(skewed --manifold torus-2-skewed --radius 1/30 --seed 2 LEVELS "${all}")
delcert_run_test(measured --manifold torus-2 --radius 1/24 --mode measured --required-protection 1/50 --seed 3 LEVELS "${all}")
delcert_run_test(square-with-sizing --manifold torus-2 --radius 1/32 --sizing ${PROJECT_SOURCE_DIR}/examples/sizings/torus-2.txt --seed 1
  LEVELS "radii        2.3.*ε₀ ≤ 1.*within 9.1 . ε₀. ε_i.*levels\n  0   input: net, Hypotheses 1, Hypotheses 2\n  1 .*\n  2 .*\n  2s .*\n  3 .*\n  4 .*\n  5 .*\n  6 ")
delcert_run_test(circle-with-sizing --manifold circle --radius 1/40 --sizing ${CMAKE_CURRENT_LIST_DIR}/sizings/circle.txt --mode theory LEVELS "radii .*${all}")
delcert_cli_test(certify-sizing-too-steep STATUS 1 OUTPUT "^$" ERROR "radii vary too much"
  COMMAND ${delcert} certify --manifold torus-2 --radius 1/32 --sizing ${CMAKE_CURRENT_LIST_DIR}/sizings/steep.txt --output never.json)
delcert_cli_test(certify-sizing-of-a-sphere STATUS 3 OUTPUT "^$" ERROR "--sizing is for flat tori and submanifolds"
  COMMAND ${delcert} certify --manifold sphere-2 --radius 1/5 --sizing ${CMAKE_CURRENT_LIST_DIR}/sizings/steep.txt --output never.json)
delcert_cli_test(certify-sizing-of-a-ball STATUS 3 OUTPUT "^$" ERROR "--sizing is for flat tori and submanifolds"
  COMMAND ${delcert} certify --manifold disk --radius 1/12 --sizing ${CMAKE_CURRENT_LIST_DIR}/sizings/steep.txt --output never.json)
delcert_cli_test(certify-sizing-by-curvature-of-a-torus STATUS 3 OUTPUT "^$" ERROR "a flat torus has no curvature"
  COMMAND ${delcert} certify --manifold torus-2 --radius 1/32 --sizing curvature:1/10,1/10 --output never.json)
delcert_cli_test(certify-sizing-without-radius STATUS 3 OUTPUT "^$" ERROR "the greatest radius of --sizing"
  COMMAND ${delcert} certify --manifold torus-2 --sizing ${CMAKE_CURRENT_LIST_DIR}/sizings/steep.txt --output never.json)
delcert_cli_test(sample-with-sizing STATUS 0 OUTPUT "points in graded.txt.*in the charts separation" ERROR "^$" FIXTURE_SETUP run-graded-points
  COMMAND ${delcert} sample --manifold torus-2 --radius 1/32 --sizing ${PROJECT_SOURCE_DIR}/examples/sizings/torus-2.txt --seed 1 --output graded.txt)
delcert_cli_test(certify-graded-points STATUS 0 OUTPUT "radii .*${all}" ERROR "^$" FIXTURES run-graded-points
  COMMAND ${delcert} certify --manifold torus-2 --radius 1/32 --points graded.txt --sizing ${PROJECT_SOURCE_DIR}/examples/sizings/torus-2.txt --output from-graded-points.json)
delcert_run_test(square-lattice --manifold torus-2 --lattice 20 LEVELS "${all}")
delcert_run_test(square-lattice-displaced --manifold torus-2 --lattice 20 --displace 60 --seed 5 LEVELS "${all}")
delcert_run_test(hexagonal-lattice --manifold torus-2-hexagonal --lattice 20 --mode measured LEVELS "${all}")
delcert_run_test(whole --manifold torus-2-hexagonal --lattice 15 --candidates whole LEVELS "${all}")
delcert_run_test(printed --manifold torus-2-hexagonal --lattice 15 --candidates printed LEVELS "${all}")
delcert_run_test(best-of-many --manifold torus-2 --radius 1/24 --seed 1 --clearance 1/20 --choices 20 LEVELS "${all}")
delcert_run_test(disk --manifold disk --radius 1/12 --seed 1 LEVELS "${ball}")
delcert_run_test(ball-lattice --manifold disk --lattice 12 --seed 1 LEVELS "${ball}")
delcert_run_test(torus-3 --manifold torus-3 --radius 1/24 --seed 1 LEVELS "${all}")

delcert_run_test(metric-field --manifold torus-2-hills --radius 1/40 --seed 1 LEVELS
  "metric       positive definite everywhere.*levels\n  1 .*\n  2 .*homology Z, Z.2, Z; closed\n  2s .*\n  5 .*\n  not reached: level 4: .*margin of stability ≥ -[0-9].*\nstability .*margin ≥ -[0-9]")
delcert_run_test(torus-of-revolution --manifold torus-2-of-revolution --radius 1/40 --seed 1 LEVELS
  "metric       positive definite everywhere.*levels\n  1 .*\n  2 .*Euler characteristic 0, homology Z, Z.2, Z; closed\n  5 .*\n  not reached: level 2s: ")
delcert_run_test(constant-metric-field --manifold torus-2-anisotropic --radius 1/30 --seed 1 LEVELS
  "levels\n  1 .*\n  2 .*\n  2s .*\n  4 .*Delaunay for the distance of the metric: margin of stability ≥ [0-9].*\n  5 .*\nstability .*margin ≥ [0-9]")
delcert_cli_test(certify-metric-field-json STATUS 0 ERROR "^$"
  OUTPUT "\"levels\": .*\"4\": .*\"edge\": .*\"exact\": \"[0-9].*\"delaunay_margin\": .*\"is_enough\": true"
  COMMAND ${delcert} certify --manifold torus-2-anisotropic --radius 1/20 --json --output anisotropic.json)

delcert_cli_test(certify-raw-lattice STATUS 1 OUTPUT "^$" ERROR "nothing is certified.*star of 0: simplex"
  COMMAND ${delcert} certify --manifold torus-2 --lattice 20 --no-perturbation --output never.json)
delcert_cli_test(certify-raw-lattice-writes-nothing STATUS 1 COMMAND ${CMAKE_COMMAND} -E cat never.json)
delcert_cli_test(certify-torus-too-small STATUS 1 OUTPUT "^$" ERROR "Hypotheses 1:.*patches.*must be at least .*: take a sampling radius of at most 1.24.\n"
  COMMAND ${delcert} certify --manifold torus-2 --radius 1/10 --output never.json)
delcert_cli_test(certify-impossible-tolerance STATUS 1 OUTPUT "^$" ERROR "no good perturbation of label"
  COMMAND ${delcert} certify --manifold torus-2 --radius 1/24 --mode measured --tolerance 31/128 --output never.json)
delcert_cli_test(certify-tolerance-in-theory STATUS 3 OUTPUT "^$" ERROR "tolerance"
  COMMAND ${delcert} certify --manifold torus-2 --radius 1/24 --tolerance 1/64 --output never.json)
delcert_cli_test(certify-hypotheses-in-measured-mode STATUS 3 OUTPUT "^$" ERROR "the hypotheses can be chosen in theory mode only; mode is measured"
  COMMAND ${delcert} certify --manifold torus-2 --radius 1/24 --mode measured --hypotheses sharper --output never.json)
delcert_cli_test(certify-unknown-hypotheses STATUS 64 OUTPUT "^$" ERROR "--hypotheses: sharp not in {printed,sharper}"
  COMMAND ${delcert} certify --manifold torus-2 --radius 1/24 --hypotheses sharp --output never.json)
delcert_cli_test(certify-mode-by-number STATUS 64 OUTPUT "^$" ERROR "--mode: 0 not in {theory,measured}"
  COMMAND ${delcert} certify --manifold torus-2 --radius 1/24 --mode 0 --output never.json)
delcert_cli_test(certify-help-names-choices STATUS 0 ERROR "^$" OUTPUT "--mode theory.measured  .*--hypotheses printed.sharper[ \n]"
  COMMAND ${delcert} certify --help)
delcert_cli_test(certify-perturbation-too-large STATUS 3 OUTPUT "^$" ERROR "perturbation 1/2"
  COMMAND ${delcert} certify --manifold torus-2 --radius 1/24 --perturbation 1/2 --output never.json)
delcert_cli_test(certify-without-net STATUS 3 OUTPUT "^$" ERROR "give --radius, --lattice or --points"
  COMMAND ${delcert} certify --manifold torus-2 --output never.json)
delcert_cli_test(certify-clearance-too-large STATUS 3 OUTPUT "^$" ERROR "clearance 1 is not in"
  COMMAND ${delcert} certify --manifold torus-2 --radius 1/24 --clearance 1 --output never.json)
file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/very-skewed.toml
  "name = \"very-skewed\"\nfamily = \"flat-torus\"\ndimension = 2\nbasis = [[1, 0], [1000, 1]]\n")
delcert_cli_test(certify-skewed-basis STATUS 3 OUTPUT "^$" ERROR "too skewed.*a reduced basis, gram = "
  COMMAND ${delcert} certify --manifold very-skewed.toml --radius 1/24 --output never.json)
file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/misspelt.toml "name = \"x\"\nfamily = \"space-from\"\ndimension = 2\n")
delcert_cli_test(certify-misspelt-family STATUS 3 OUTPUT "^$" ERROR "misspelt.toml:2:10: key .family.*did you mean space-form"
  COMMAND ${delcert} certify --manifold misspelt.toml --radius 1/24 --output never.json)
delcert_cli_test(certify-unknown-level STATUS 64 OUTPUT "^$" ERROR "7"
  COMMAND ${delcert} certify --manifold torus-2 --radius 1/24 --levels 0,7 --output never.json)
delcert_cli_test(certify-no-such-folder STATUS 3 OUTPUT "^$" ERROR "no-such-folder"
  COMMAND ${delcert} certify --manifold torus-2 --lattice 20 --output no-such-folder/x.json)
delcert_cli_test(certify-json STATUS 0 OUTPUT "\"levels\": .*\"stages\": " ERROR "^$"
  COMMAND ${delcert} certify --manifold circle --radius 1/30 --json --output circle.json)
delcert_cli_test(certify-few-levels STATUS 0 OUTPUT "levels\n  1 .*\n  2 .*\n  4 .*stages" ERROR "^$"
  COMMAND ${delcert} certify --manifold circle --radius 1/30 --levels 1,2,4 --output circle-124.json FIXTURE_SETUP run-few)
delcert_cli_test(verify-few-levels STATUS 0 OUTPUT "verified" FIXTURES run-few COMMAND ${check} circle-124.json)

delcert_cli_test(sample-points STATUS 0 OUTPUT "points in points.txt.*both certified" ERROR "^$" FIXTURE_SETUP run-points
  COMMAND ${delcert} sample --manifold torus-2 --radius 1/24 --seed 7 --output points.txt)
delcert_cli_test(certify-points STATUS 0 OUTPUT "${all}" FIXTURES run-points
  COMMAND ${delcert} certify --manifold torus-2 --points points.txt --radius 1/24 --output from-points.json)
delcert_cli_test(sample-metric-field STATUS 0 OUTPUT "points in field.txt.*in the charts separation .*, certified" ERROR "^$"
  COMMAND ${delcert} sample --manifold torus-2-shear --radius 1/20 --seed 7 --output field.txt)
delcert_cli_test(sample-metric-field-too-coarse STATUS 1 OUTPUT "^$" ERROR "torus-2-hills: the radius of a net is below an eighth"
  COMMAND ${delcert} sample --manifold torus-2-hills --radius 1/4 --output never.txt)
# A refusal advises a number that can be typed as it is, and is then accepted.
foreach(member "torus-2-hills;1" "klein-bottle;1" "lens-space-5-2;1")
  list(GET member 0 name)
  list(GET member 1 radius)
  delcert_cli_test(sample-as-advised-${name} STATUS 0 OUTPUT "points in advised-${name}.txt" ERROR "^$"
    COMMAND sh -c "r=$(${delcert} sample --manifold ${name} --radius ${radius} --output advised-${name}.txt 2>&1 | sed -n 's|.* at most \\([0-9]*/[0-9]*\\)$|\\1|p') && test -n \"$r\" && ${delcert} sample --manifold ${name} --radius $r --output advised-${name}.txt")
endforeach()
delcert_cli_test(certify-as-advised STATUS 0 OUTPUT "levels" ERROR "^$"
  COMMAND sh -c "r=$(${delcert} certify --manifold klein-bottle --radius 1/10 --output advised.json 2>&1 | sed -n 's|.* at most \\([0-9]*/[0-9]*\\)$|\\1|p') && test -n \"$r\" && ${delcert} certify --manifold klein-bottle --radius $r --output advised.json")
delcert_cli_test(certify-metric-field-in-theory STATUS 1 OUTPUT "^$" ERROR "use --mode measured"
  COMMAND ${delcert} certify --manifold torus-2-hills --radius 1/24 --mode theory --output never.json)
delcert_cli_test(certify-metric-field-lattice STATUS 3 OUTPUT "^$" ERROR "are not for metric fields"
  COMMAND ${delcert} certify --manifold torus-2-hills --lattice 24 --output never.json)
delcert_cli_test(certify-submanifold-in-theory STATUS 1 OUTPUT "^$" ERROR "use --mode measured"
  COMMAND ${delcert} certify --manifold ellipsoid --radius 1/12 --mode theory --output never.json)
delcert_cli_test(certify-submanifold-lattice STATUS 3 OUTPUT "^$" ERROR "are not for submanifolds"
  COMMAND ${delcert} certify --manifold torus-of-revolution --lattice 24 --output never.json)
delcert_cli_test(certify-submanifold STATUS 0
  OUTPUT "all of the manifold.*1   stars.*2   manifold: .*Euler characteristic 2, homology Z, 0, Z.*5   triangulation: by straight simplices.*5i  isotopy"
  ERROR "^$" COMMAND ${delcert} certify --manifold ${CMAKE_CURRENT_LIST_DIR}/submanifolds/sphere.toml --radius 1/8 --seed 1 --output sphere-of-equations.json)
delcert_run_test(trefoil --manifold trefoil --radius 1/26 --seed 1 LEVELS
  "all of the manifold.*levels\n  1 .*\n  2 .*Euler characteristic 0, homology Z, Z; closed\n  2s .*\n  4 .*\n  5 .*\n  5i .*\n  6 ")
delcert_run_test(circle-in-the-plane --manifold ${CMAKE_CURRENT_LIST_DIR}/submanifolds/circle.toml --radius 1/10 --seed 1 LEVELS
  "levels\n  1 .*\n  2 .*homology Z, Z; closed\n  2s .*\n  4 .*\n  5 .*\n  5i .*\n  6 ")
# Defect: where curves could be much longer than their chords, labels were looked for without end.
delcert_cli_test(certify-curve-hardly STATUS 1 OUTPUT "^$" ERROR "no level is reached: level 1"
  COMMAND ${delcert} certify --manifold trefoil --radius 1/14 --seed 4 --output never.json)
delcert_cli_test(certify-curve-in-theory STATUS 1 OUTPUT "^$" ERROR "use --mode measured"
  COMMAND ${delcert} certify --manifold trefoil --radius 1/26 --mode theory --output never.json)
delcert_cli_test(certify-curve-too-coarse STATUS 1 OUTPUT "^$" ERROR "trefoil: label [0-9]+ at .*: its patch is"
  COMMAND ${delcert} certify --manifold trefoil --radius 1/10 --output never.json)
delcert_cli_test(certify-submanifold-of-other-homology STATUS 1 OUTPUT "^$"
  ERROR "the homology is Z, 0, Z, and not Z, Z.2, Z as the file says"
  COMMAND ${delcert} certify --manifold ${CMAKE_CURRENT_LIST_DIR}/submanifolds/no-torus.toml --radius 1/8 --seed 1 --output never.json)
delcert_cli_test(certify-raw-metric-field STATUS 1 OUTPUT "^$" ERROR "nothing is certified.*star of"
  COMMAND ${delcert} certify --manifold torus-2-shear --radius 1/20 --no-perturbation --output never.json)
delcert_cli_test(sample-json STATUS 0 OUTPUT "\"separation\": \"1\"" ERROR "^$"
  COMMAND ${delcert} sample --manifold disk --radius 1/10 --json --output disk.txt)
delcert_cli_test(sample-negative-radius STATUS 3 OUTPUT "^$" ERROR "--radius -1/2"
  COMMAND ${delcert} sample --manifold torus-2 --radius=-1/2 --output never.txt)
delcert_cli_test(sample-too-many STATUS 1 OUTPUT "^$" ERROR "more than 4000000 points"
  COMMAND ${delcert} sample --manifold torus-3 --radius 1/10000 --output never.txt)

delcert_cli_test(info STATUS 0 OUTPUT "torus-2 .flat-torus, dimension 2.*levels claimed.*homology +Z, Z.2, Z.*sha256 [0-9a-f]+" ERROR "^$"
  FIXTURES run-square COMMAND ${delcert} info run-square.json.zst --picture square.svg)
delcert_cli_test(homology STATUS 0 OUTPUT "components   1\nfacets       0 in one simplex, 0 in three or more\norientable   yes\nEuler        0\nhomology     Z, Z.2, Z\n$" ERROR "^$"
  FIXTURES run-square COMMAND ${delcert} homology run-square.json.zst)
delcert_cli_test(homology-json STATUS 0 OUTPUT "\"components\": 1,.*\"orientable\": true,.*\"homology\": .*\"Z.2\"" ERROR "^$"
  FIXTURES run-square COMMAND ${delcert} homology run-square.json.zst --json)
delcert_cli_test(homology-without-simplices STATUS 3 OUTPUT "^$" ERROR "points.txt: " FIXTURES run-points
  COMMAND ${delcert} homology points.txt)
delcert_cli_test(info-json STATUS 0 OUTPUT "\"levels_claimed\": .*\"homology\": \"Z, Z.2, Z\"" ERROR "^$" FIXTURES run-square
  COMMAND ${delcert} info run-square.json.zst --json)
delcert_cli_test(info-picture-of-dimension-3 STATUS 3 ERROR "pictures are of certificates of dimension 1 or 2" FIXTURES run-torus-3
  COMMAND ${delcert} info run-torus-3.json.zst --picture never.svg)
delcert_cli_test(info-no-file STATUS 3 OUTPUT "^$" ERROR "no-such-file.json: cannot be opened"
  COMMAND ${delcert} info no-such-file.json)
delcert_cli_test(info-no-certificate STATUS 3 OUTPUT "^$" ERROR "points.txt: " FIXTURES run-points
  COMMAND ${delcert} info points.txt)

# The certificate does not depend on the number of threads, byte for byte; on the seed it does.
foreach(member "sphere-2;1/8" "klein-bottle;1/24")
  list(GET member 0 name)
  list(GET member 1 radius)
  foreach(threads 1 2 4)
    delcert_cli_test(certify-${name}-threads-${threads} STATUS 0 OUTPUT "levels" ERROR "^$" FIXTURE_SETUP run-${name}-threads
      COMMAND ${delcert} certify --manifold ${name} --radius ${radius} --threads ${threads} --output ${name}-${threads}.json)
  endforeach()
  delcert_cli_test(certify-${name}-other-seed STATUS 0 OUTPUT "levels" ERROR "^$" FIXTURE_SETUP run-${name}-threads
    COMMAND ${delcert} certify --manifold ${name} --radius ${radius} --seed 2 --output ${name}-other.json)
  foreach(threads 2 4)
    delcert_cli_test(certify-${name}-same-for-${threads} STATUS 0 OUTPUT "^$" ERROR "^$" FIXTURES run-${name}-threads
      COMMAND ${CMAKE_COMMAND} -E compare_files ${name}-1.json ${name}-${threads}.json)
  endforeach()
  delcert_cli_test(certify-${name}-not-the-same STATUS 1 FIXTURES run-${name}-threads
    COMMAND ${CMAKE_COMMAND} -E compare_files ${name}-1.json ${name}-other.json)
endforeach()
delcert_cli_test(certify-threads-are-a-number STATUS 64 OUTPUT "^$" ERROR "threads"
  COMMAND ${delcert} certify --manifold sphere-2 --radius 1/8 --threads many --output never.json)
delcert_cli_test(certify-threads-are-some STATUS 64 OUTPUT "^$" ERROR "threads"
  COMMAND ${delcert} certify --manifold sphere-2 --radius 1/8 --threads 0 --output never.json)

# Raw nets of spheres, on which stars of different charts disagree; the same net perturbed, in patches of seven radii.
foreach(dimension 2 3)
  delcert_cli_test(certify-raw-sphere-${dimension} STATUS 1 OUTPUT "^$"
    ERROR "nothing is certified: .* is in the star of label .*stars are not in agreement with another: [0-9]"
    COMMAND ${delcert} certify --manifold sphere-${dimension} --radius 1/5 --seed 1 --no-perturbation --output never-${dimension}.json)
  delcert_cli_test(certify-raw-sphere-${dimension}-writes-nothing STATUS 1 COMMAND ${CMAKE_COMMAND} -E cat never-${dimension}.json)
endforeach()
delcert_cli_test(certify-sphere-in-small-patches STATUS 0 ERROR "^$" FIXTURE_SETUP run-small-patches
  OUTPUT "patches of radius 7 ε.*levels\n  1 .*\n  2 .*\n  4 .*\n  5 .*not reached: level 0: patches are smaller than 9 sampling radii"
  COMMAND ${delcert} certify --manifold sphere-2 --radius 1/5 --seed 1 --output small-patches.json)
delcert_cli_test(verify-sphere-in-small-patches STATUS 0 OUTPUT "verified" FIXTURES run-small-patches
  COMMAND ${check} small-patches.json)
delcert_cli_test(sample-for-small-patches STATUS 0 OUTPUT "221 points in small-patches.txt" ERROR "^$"
  COMMAND ${delcert} sample --manifold sphere-2 --radius 1/5 --seed 1 --output small-patches.txt)
delcert_cli_test(certify-sphere-too-coarse STATUS 1 OUTPUT "^$" ERROR "no smaller than half of the sphere"
  COMMAND ${delcert} certify --manifold sphere-2 --radius 23/100 --seed 1 --output never.json)
