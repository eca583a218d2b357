# Charts by formulas, from the file to the certificate. What is no atlas is in wrong_manifolds.py.
delcert_run_test(sphere-by-charts --manifold sphere-2-stereographic --radius 1/16 --seed 1 LEVELS
  "gluing       verified: 2 charts, 1 transitions.*levels\n  1 .*\n  2 .*Euler characteristic 2, homology Z, 0, Z; closed.*\n  5   triangulation: by straight simplices that are moved by ≤ ")
delcert_run_test(projective-plane-by-charts --manifold projective-plane-by-charts --radius 1/16 --seed 1 LEVELS
  "levels\n  1 .*\n  2 .*Euler characteristic 1, homology Z, Z/2, 0; closed.*\n  5   triangulation")
delcert_run_test(klein-bottle-by-charts --manifold klein-bottle-rectangles --radius 1/30 --seed 1 LEVELS
  "levels\n  1 .*\n  2 .*Euler characteristic 0, homology Z, Z . Z/2, 0; closed\n  2s .*\n  5   triangulation")
delcert_run_test(bent-torus-by-charts --manifold torus-2-bent --radius 1/40 --seed 1 LEVELS
  "levels\n  1 .*\n  2 .*Euler characteristic 0, homology Z, Z.2, Z; closed.*\n  5   triangulation")
delcert_run_test(cone-torus --manifold cone-torus --radius 1/36 --seed 1 LEVELS
  "gluing       verified: 6 charts, 21 transitions.*levels\n  1 .*\n  2 .*Euler characteristic 0, homology Z, Z.2, Z; closed.*\n  5   triangulation")
delcert_cli_test(certify-atlas-json STATUS 0 ERROR "^$"
  OUTPUT "\"family\": \"atlas\".*\"gluing\": .*\"charts\": 2,.*\"compact_cells\": [1-9]"
  COMMAND ${delcert} certify --manifold sphere-2-stereographic --radius 1/8 --json --output glued.json FIXTURE_SETUP run-glued)
delcert_cli_test(certify-atlas-too-coarse-for-level-5 STATUS 0 ERROR "^$"
  OUTPUT "not reached: level 5: [0-9]+ of [0-9]+ simplices between charts are not certainly mapped as they should be; simplex [0-9 ]+: what transitions do to it may fold it"
  COMMAND ${delcert} certify --manifold projective-plane-by-charts --radius 1/8 --seed 1 --output coarse.json)
delcert_cli_test(certify-atlas-by-volumes STATUS 0 ERROR "^$" OUTPUT "  5   triangulation"
  COMMAND ${delcert} certify --manifold sphere-2-stereographic --radius 1/8 --seed 1 --levels 1,2,5 --output volumes.json FIXTURE_SETUP run-volumes)
delcert_cli_test(check-atlas-by-volumes STATUS 0 ERROR "^$" OUTPUT "level 5    verified   95 simplices between charts" FIXTURES run-volumes
  COMMAND ${delcert} check volumes.json)
delcert_cli_test(certify-atlas-between-charts STATUS 0 ERROR "^$" OUTPUT "not reached: level 5: 2 of 298 simplices between charts"
  COMMAND ${delcert} certify --manifold projective-plane-by-charts --radius 1/14 --seed 1 --levels 1,2,5 --output between.json)
delcert_cli_test(certify-atlas-without-such-homes STATUS 0 ERROR "^$"
  OUTPUT "not reached: level 5: 3 of 217 simplices .*not reached: refinement: in 5 rounds no home charts were found with which levels 1, 2 and 5 hold"
  COMMAND ${delcert} certify --manifold projective-plane-by-charts --radius 1/10 --seed 1 --levels 1,2,5 --refine 5 --output no-homes.json)
delcert_cli_test(certify-atlas-with-other-homes STATUS 0 ERROR "^$" OUTPUT "1 round of refinement.*  5   triangulation"
  COMMAND ${delcert} certify --manifold projective-plane-by-charts --radius 1/14 --seed 1 --levels 1,2,5 --refine 30 --output homes.json FIXTURE_SETUP run-homes)
delcert_cli_test(check-atlas-with-other-homes STATUS 0 ERROR "^$" OUTPUT "level 5    verified   303 simplices between charts" FIXTURES run-homes
  COMMAND ${delcert} check homes.json)
delcert_cli_test(info-of-atlas STATUS 0 OUTPUT "sphere-2-stereographic .atlas, dimension 2., [0-9]* points" ERROR "^$"
  FIXTURES run-glued COMMAND ${delcert} info glued.json)
delcert_cli_test(sample-atlas STATUS 0 OUTPUT "points in glued.txt" ERROR "^$" FIXTURE_SETUP run-glued-points
  COMMAND ${delcert} sample --manifold torus-2-by-charts --radius 1/30 --seed 7 --output glued.txt)
delcert_cli_test(certify-atlas-points STATUS 0 OUTPUT "homology Z, Z.2, Z; closed\n  2s " ERROR "^$" FIXTURES run-glued-points
  COMMAND ${delcert} certify --manifold torus-2-by-charts --points glued.txt --radius 1/30 --output from-glued.json)
file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/no-chart.txt "0 1/8 1/8\n7 1/8 1/8\n")
delcert_cli_test(certify-atlas-points-in-no-chart STATUS 3 OUTPUT "^$" ERROR "no-chart.txt: point 1: no chart has the number 7"
  COMMAND ${delcert} certify --manifold torus-2-by-charts --points no-chart.txt --radius 1/30 --output never.json)

delcert_cli_test(certify-atlas-in-theory STATUS 1 OUTPUT "^$" ERROR "use --mode measured"
  COMMAND ${delcert} certify --manifold torus-2-by-charts --radius 1/30 --mode theory --output never.json)
delcert_cli_test(certify-atlas-lattice STATUS 3 OUTPUT "^$" ERROR "are not for atlases"
  COMMAND ${delcert} certify --manifold torus-2-by-charts --lattice 24 --output never.json)

# Thin tetrahedra between charts.
delcert_cli_test(certify-sphere-3-by-charts STATUS 0 ERROR "^$" OUTPUT "homology Z, 0, 0, Z; closed\n  5   triangulation"
  COMMAND ${delcert} certify --manifold sphere-3-stereographic --radius 1/10 --seed 1 --levels 1,2,5 --output glued-3.json FIXTURE_SETUP run-glued-3)
delcert_cli_test(check-sphere-3-by-charts STATUS 0 ERROR "^$" OUTPUT "level 5    verified   7904 simplices between charts" FIXTURES run-glued-3
  COMMAND ${delcert} check glued-3.json)

# The square torus by charts is the built-in one.
delcert_cli_test(torus-by-charts-is-the-torus STATUS 0 OUTPUT "triangles, the same: True" ERROR "^$"
  COMMAND ${Python3_EXECUTABLE} ${CMAKE_CURRENT_LIST_DIR}/torus_by_charts.py ${delcert})
delcert_cli_test(torus-by-charts-with-points-exchanged-is-not STATUS 1 OUTPUT "triangles, the same: False" ERROR "^$"
  COMMAND ${Python3_EXECUTABLE} ${CMAKE_CURRENT_LIST_DIR}/torus_by_charts.py ${delcert} --twin)
