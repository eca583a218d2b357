# delcert info as a referee and as a program reads it; delcert cite.
set(delcert $<TARGET_FILE:delcert>)

delcert_cli_test(info-decimals STATUS 0 ERROR "^$" FIXTURES run-square COMMAND ${delcert} info run-square.json.zst
  OUTPUT "sampling_radius +1/24 +≈ 0.04166.*protection +≥ 0x[0-9a-f]+p-[0-9]+ +≥ 0.0[0-9]+ +≥ 0.0[0-9]+ ε\n.*\ncommand delcert certify .*\nsha256 ")
delcert_cli_test(info-typed STATUS 0 ERROR "^$" FIXTURES run-square COMMAND ${delcert} info run-square.json.zst --json
  OUTPUT "\"levels\": .*\"exact\": \"0x[0-9a-f]+p-[0-9]+\",\n *\"value\": 0.*\"in_sampling_radii\": 0.*\"simplices\": [0-9]+,.*\"closed\": true.*\"command\": \"delcert certify")
delcert_cli_test(info-latex STATUS 0 ERROR "^$" FIXTURES run-square COMMAND ${delcert} info run-square.json.zst --latex
  OUTPUT "begin{tabular}.*torus-.allowbreak..2, dimension 2.*cdot 2.{-.*SHA-256 .texttt{[0-9a-f]+.allowbreak")
delcert_cli_test(info-latex-and-json STATUS 64 OUTPUT "^$" ERROR "excludes" FIXTURES run-square
  COMMAND ${delcert} info run-square.json.zst --latex --json)
delcert_cli_test(info-latex-of-changed STATUS 3 OUTPUT "^$" ERROR "export-unsealed.json: the seal is wrong" FIXTURES export-forged
  COMMAND ${delcert} info export-unsealed.json --latex)

delcert_cli_test(cite STATUS 0 ERROR "^$" FIXTURES run-square COMMAND ${delcert} cite run-square.json.zst
  OUTPUT "^@article{boissonnat2018delaunay,.*@misc{delcert,.*@misc{delcert-[0-9a-f]+,.*of torus-2.*SHA-256 .*}\n$")
delcert_cli_test(cite-text STATUS 0 ERROR "^$" COMMAND ${delcert} cite --format text
  OUTPUT "^Boissonnat, .*doi:10.1007/s10208-017-9344-1.\nThe delcert developers: delcert.*\n$")
delcert_cli_test(cite-unknown-format STATUS 64 OUTPUT "^$" ERROR "no format bibtx, did you mean bibtex" COMMAND ${delcert} cite --format bibtx)
delcert_cli_test(cite-changed STATUS 3 OUTPUT "^$" ERROR "export-unsealed.json: the seal is wrong" FIXTURES export-forged
  COMMAND ${delcert} cite export-unsealed.json)
delcert_cli_test(cite-no-certificate STATUS 3 OUTPUT "^$" ERROR "points.txt: " FIXTURES run-points COMMAND ${delcert} cite points.txt)

# Whatever LaTeX is printed fits a line of article at 10 pt. The page of all claims, and the built-in tables, are long.
find_program(DELCERT_PDFLATEX pdflatex REQUIRED)
set(fits ${CMAKE_CURRENT_LIST_DIR}/latex_fits.sh)
function(delcert_latex_test name)
  cmake_parse_arguments(PARSE_ARGV 1 ARG "" "FIXTURES" "COMMAND")
  delcert_cli_test(latex-${name} STATUS 0 OUTPUT "${name} fits: Output written" ERROR "^$" FIXTURES "${ARG_FIXTURES}"
    COMMAND ${fits} ${name} ${ARG_COMMAND})
endfunction()
delcert_latex_test(info FIXTURES run-square COMMAND ${delcert} info run-square.json.zst --latex)
delcert_latex_test(info-of-dimension-3 FIXTURES run-torus-3 COMMAND ${delcert} info run-torus-3.json.zst --latex)
delcert_latex_test(info-of-an-atlas FIXTURES run-glued COMMAND ${delcert} info glued.json --latex)
foreach(dimension 1 2 3 4)
  delcert_latex_test(constants-${dimension} COMMAND ${delcert} constants --dim ${dimension} --separation 1/2 --perturbation 1/10 --latex)
endforeach()
delcert_latex_test(constants-16 COMMAND ${delcert} constants --dim 16 --separation 1/1000 --perturbation 1/10000 --latex)
delcert_latex_test(constants-sweep COMMAND ${delcert} constants --dim 2..6 --separation 1/4,1/2,1 --latex)
delcert_latex_test(tables COMMAND cat ${PROJECT_SOURCE_DIR}/docs/tables/constants.tex)
delcert_latex_test(attack COMMAND ${delcert} attack thickness-and-singular-value circumradius-under-distortion --samples 20 --latex)
delcert_latex_test(attack-short COMMAND ${delcert} attack thickness-and-singular-value crude-circumradius-bound gram-matrix-under-distortion --samples 1 --short --latex)
delcert_latex_test(tighten COMMAND ${delcert} tighten thickness-and-singular-value circumradius-under-distortion --evaluations 20 --latex)
delcert_latex_test(claims COMMAND ${delcert} claims show --all --latex)

# What does not fit, and what is no LaTeX, is noticed.
delcert_cli_test(latex-too-wide STATUS 1 OUTPUT "Overfull .hbox .5[45].*pt too wide" ERROR "^$"
  COMMAND ${fits} wide echo "\\noindent\\rule{400pt}{1pt}")
delcert_cli_test(latex-table-too-wide STATUS 1 OUTPUT "Overfull .hbox" ERROR "^$"
  COMMAND ${fits} wide echo "\\begin{tabular}{@{}p{300pt}p{60pt}@{}} a & b \\end{tabular}")
delcert_cli_test(latex-broken STATUS 1 OUTPUT "Undefined control sequence" ERROR "^$" COMMAND ${fits} broken echo "\\nonsense")
delcert_cli_test(latex-of-a-command-that-fails STATUS 1 ERROR "the command ends with 64" COMMAND ${fits} fails ${delcert} attack --latx)

# Figures, and that TikZ sets them.
delcert_cli_test(figure-svg STATUS 0 ERROR "^$" FIXTURES run-square COMMAND ${delcert} figure run-square.json.zst --output figure.svg
  OUTPUT "^figure.svg: delcert .*manifold .*not verified.*triangles, shaded by thickness; the star of label [0-9]+ is marked.*protection about 0.0")
delcert_cli_test(figure-has-scale STATUS 0 OUTPUT "class=.scale.*>0.2<" FIXTURES run-square
  COMMAND sh -c "\"$1\" figure run-square.json.zst --output figure-scale.svg > /dev/null && tail -n 5 figure-scale.svg" sh ${delcert})
delcert_cli_test(figure-plain STATUS 0 OUTPUT "^0\n$" FIXTURES run-square
  COMMAND sh -c "\"$1\" figure run-square.json.zst --plain --output figure-plain.svg > /dev/null && ! grep -c scale figure-plain.svg" sh ${delcert})
delcert_cli_test(figure-other-ending STATUS 3 OUTPUT "^$" ERROR "figure.png: the name ends in .svg or .pdf, or" FIXTURES run-square
  COMMAND ${delcert} figure run-square.json.zst --output figure.png)
delcert_cli_test(figure-of-dimension-3 STATUS 3 OUTPUT "^$" ERROR "run-torus-3.json.zst: pictures are of certificates of dimension 1 or 2" FIXTURES run-torus-3
  COMMAND ${delcert} figure run-torus-3.json.zst --output never.svg)
delcert_cli_test(figure-of-changed STATUS 3 OUTPUT "^$" ERROR "export-unsealed.json: the seal is wrong" FIXTURES export-forged
  COMMAND ${delcert} figure export-unsealed.json --output never.svg)
delcert_latex_test(figure FIXTURES run-square
  COMMAND sh -c "\"$1\" figure run-square.json.zst --output figure-fits.tikz > /dev/null && cat figure-fits.tikz" sh ${delcert})

# Whether pdflatex reads the page of PDF, and it fits the line: 12 cm are 341.4 pt.
function(delcert_pdf_test name file)
  cmake_parse_arguments(PARSE_ARGV 2 ARG "" "FIXTURES" "")
  delcert_latex_test(${name} FIXTURES ${ARG_FIXTURES} COMMAND sh -c
    "\"$1\" figure \"$2\" --output ${name}.pdf > /dev/null && printf '%s' '\\includegraphics{'\"$PWD\"'/${name}.pdf}'" sh ${delcert} ${file})
endfunction()
delcert_pdf_test(figure-pdf run-square.json.zst FIXTURES run-square)

set(witnesses ${PROJECT_SOURCE_DIR}/proofs/claims/witnesses)
delcert_cli_test(figure-witness STATUS 0 ERROR "^$"
  OUTPUT "witness against faces-of-thick-simplices, sharper-twin, twin sharper-twin: the hypotheses are proved, .* is refuted, ratio .*; the simplex s\n$"
  COMMAND ${delcert} figure ${witnesses}/faces-of-thick-simplices.sharper-twin.json --output figure-witness.svg)
delcert_latex_test(figure-witness COMMAND sh -c "\"$1\" figure \"$2\" --output figure-witness.tikz > /dev/null && cat figure-witness.tikz"
  sh ${delcert} ${witnesses}/faces-of-thick-simplices.sharper-twin.json)
delcert_pdf_test(figure-witness-pdf ${witnesses}/faces-of-thick-simplices.sharper-twin.json)
delcert_cli_test(figure-curve STATUS 0 ERROR "^$" OUTPUT "not verified.; [0-9]+ edges; the star of label" COMMAND sh -c
  "\"$1\" certify --manifold circle --radius 1/30 --output figure-circle.json > /dev/null && \"$1\" figure figure-circle.json --output figure-circle.svg"
  sh ${delcert})

find_package(Python3 3.11 REQUIRED COMPONENTS Interpreter)

# Bundles: the same bytes again, commands of the README that succeed, and one that fails where a byte is changed.
set(supplement --no-checker --title "A & b" --author "Doe, Jane" --author "The group" --license CC-BY-4.0 --date 2026-05-31)
set(no_day ${supplement})
list(REMOVE_ITEM no_day --date 2026-05-31)
set(bundle_works ${CMAKE_CURRENT_LIST_DIR}/bundle_works.sh)
delcert_cli_test(bundle STATUS 0 ERROR "^$" FIXTURES run-square run-torus-3 FIXTURE_SETUP bundle
  OUTPUT "^supplement.zip: 14 files, 2 certificates, not verified\n$"
  COMMAND sh -c "rm -f supplement.zip && exec \"$@\"" sh ${delcert} bundle run-square.json.zst run-torus-3.json.zst ${supplement} --output supplement.zip)
delcert_cli_test(bundle-again STATUS 0 OUTPUT "^$" ERROR "^$" FIXTURES run-square run-torus-3 bundle
  COMMAND sh -c "rm -f again.zip && \"$@\" > /dev/null && cmp supplement.zip again.zip" sh ${delcert} bundle run-square.json.zst run-torus-3.json.zst ${supplement} --output again.zip)
# The day also as seconds since 1970; on the next day the bytes are others.
set(on_day sh -c "rm -f day.zip && SOURCE_DATE_EPOCH=$0 \"$@\" > /dev/null && cmp day.zip supplement.zip")
set(bundled ${delcert} bundle run-square.json.zst run-torus-3.json.zst ${no_day} --output day.zip)
delcert_cli_test(bundle-on-the-day STATUS 0 OUTPUT "^$" ERROR "^$" FIXTURES run-square run-torus-3 bundle COMMAND ${on_day} 1780185600 ${bundled})
delcert_cli_test(bundle-on-the-next STATUS 1 OUTPUT "differ" ERROR "^$" FIXTURES run-square run-torus-3 bundle COMMAND ${on_day} 1780272000 ${bundled})
set_tests_properties(cli.bundle-on-the-day cli.bundle-on-the-next PROPERTIES RESOURCE_LOCK day-of-bundle)
delcert_cli_test(bundle-on-no-day STATUS 3 OUTPUT "^$" ERROR "a bundle needs a day of publication such as 2026-05-31, and not .31.5.2026" FIXTURES run-square
  COMMAND ${delcert} bundle run-square.json.zst --title x --author y --date 31.5.2026 --output never.zip)
delcert_cli_test(bundle-works STATUS 0 OUTPUT "^3 commands succeed\n$" ERROR "^$" FIXTURES bundle
  COMMAND ${bundle_works} supplement.zip $<TARGET_FILE_DIR:delcert-check>)
delcert_cli_test(bundle-schemas STATUS 0 OUTPUT "^4 descriptions follow their schemas; [0-9]+ changes are noticed\n$" ERROR "^$" FIXTURES bundle
  COMMAND ${Python3_EXECUTABLE} ${CMAKE_CURRENT_LIST_DIR}/bundle_schemas.py supplement.zip)
foreach(changed certificates/run-square.json.zst exports/run-torus-3.vtu)
  string(MAKE_C_IDENTIFIER ${changed} name)
  delcert_cli_test(bundle-changed-${name} STATUS 1 OUTPUT "fails: sha256sum -c" ERROR "^$" FIXTURES bundle
    COMMAND ${bundle_works} supplement.zip $<TARGET_FILE_DIR:delcert-check> ${changed})
endforeach()
delcert_cli_test(bundle-has-the-checker STATUS 0 OUTPUT "^source.zip: [0-9]+ files, 1 certificate, not verified, and the source of the checker\n.*checker/proofs/checker/program/main.cpp: OK" ERROR "^$"
  FIXTURES run-square COMMAND sh -c "rm -rf source.zip source-of-checker && mkdir source-of-checker && \"$1\" bundle run-square.json.zst --title x --author y --date 2026-05-31 --output source.zip \
    && cd source-of-checker && cmake -E tar xf ../source.zip && sha256sum -c SHA256SUMS" sh ${delcert})
delcert_cli_test(bundle-onto-a-file STATUS 3 OUTPUT "^$" ERROR "supplement.zip: the file exists and is not replaced" FIXTURES run-square bundle
  COMMAND ${delcert} bundle run-square.json.zst ${supplement} --output supplement.zip)
delcert_cli_test(bundle-of-changed STATUS 3 OUTPUT "^$" ERROR "export-unsealed.json: the seal is wrong" FIXTURES export-forged
  COMMAND ${delcert} bundle export-unsealed.json ${supplement} --output never.zip)
delcert_cli_test(bundle-without-author STATUS 64 OUTPUT "^$" ERROR "--author is required"
  COMMAND ${delcert} bundle x.json --title x --output never.zip)
