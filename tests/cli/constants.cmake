set(constants $<TARGET_FILE:delcert> constants)
set(surface --dim 2 --separation 1 --perturbation 1/4)

delcert_cli_test(constants-help COMMAND ${constants} --help STATUS 0
  OUTPUT "--dim.*--separation.*--perturbation.*--json.*--latex.*Examples:" ERROR "^$")
delcert_cli_test(constants-table COMMAND ${constants} ${surface} STATUS 0 ERROR "^$"
  OUTPUT "flake parameter +2.[(]-101/2[)] .*tolerance +2.[(]-32[)] .*Hypotheses 2 .hyps:param.bnds. hold for")
delcert_cli_test(constants-json COMMAND ${constants} ${surface} --json STATUS 0 ERROR "^$"
  OUTPUT "^{\n.*\"log2_lower\": \"-50.5\".*\"hypotheses_2\": true\n}\n$")
delcert_cli_test(constants-latex COMMAND ${constants} ${surface} --latex STATUS 0 ERROR "^$"
  OUTPUT "^{.footnotesize.*.begin{longtable}.*.toprule.*.bottomrule.*.end{longtable}}\n")
delcert_cli_test(constants-dimension-three STATUS 0 ERROR "^$"
  COMMAND ${constants} --dim 3 --separation 1/2 --perturbation 1/10 --latex OUTPUT "longtable")
delcert_cli_test(constants-with-distortion STATUS 0 ERROR "^$"
  COMMAND ${constants} --dim 2 --separation 1 --perturbation 1/5 --distortion 1/100 --radius-variation 0x1p-10
  OUTPUT "radius variation +1/1024.*do not hold: the distortion 1/100 is above its bound")

delcert_cli_test(constants-sharper STATUS 0 ERROR "^$" COMMAND ${constants} ${surface} --hypotheses sharper
  OUTPUT "flake parameter +2.[(]-49[)] .*distortion bound +2.[(]-298[)] [^\n]*sharper-lemmas.*sharper Hypotheses 2 .* hold for these")
delcert_cli_test(constants-sharper-json STATUS 0 ERROR "^$" COMMAND ${constants} ${surface} --hypotheses sharper --json
  OUTPUT "\"hypotheses\": \"sharper\".*\"hypotheses_2\": true")
delcert_cli_test(constants-printed STATUS 0 ERROR "^$" COMMAND ${constants} ${surface} --hypotheses printed --only distortion_bound
  OUTPUT "2.[(]-509[)] [^\n]*hyps:param.bnds\n\nHypotheses 2 .hyps:param.bnds. hold for")
delcert_cli_test(constants-sharper-sweep STATUS 0 ERROR "^$" COMMAND ${constants} --dim 2,3 --separation 1 --hypotheses sharper
  OUTPUT "The sharper Hypotheses 2 .* hold for all of these parameters")
# What has one value only under the printed hypotheses: too much distortion; Theorem 3 under both.
delcert_cli_test(constants-sharper-distortion STATUS 0 ERROR "^$"
  COMMAND ${constants} --dim 2 --separation 1 --perturbation 1/5 --distortion 0x1p-310 --only distortion_bound --hypotheses sharper
  OUTPUT "The sharper Hypotheses 2 .* hold for these")
delcert_cli_test(constants-printed-distortion STATUS 0 ERROR "^$"
  COMMAND ${constants} --dim 2 --separation 1 --perturbation 1/5 --distortion 0x1p-310 --only distortion_bound
  OUTPUT "Hypotheses 2 .* do not hold: the distortion")
delcert_cli_test(constants-sharper-theorem-3 STATUS 0 ERROR "^$"
  COMMAND ${constants} ${surface} --hypotheses sharper --only riemannian_sampling_radius,self_delaunay_sampling_radius
  OUTPUT "2.[(]-146[)]..?5.[(]-3[)] .*2.[(]-240[)]..?5.[(]-5[)] ")
delcert_cli_test(constants-printed-self-delaunay STATUS 3 OUTPUT "^$"
  COMMAND ${constants} ${surface} --only tolerance,self_delaunay_sampling_radius
  ERROR "self_delaunay_sampling_radius is a constant of the sharper hypotheses only")
delcert_cli_test(constants-unknown-hypotheses STATUS 64 OUTPUT "^$" COMMAND ${constants} ${surface} --hypotheses sharp
  ERROR "no hypotheses are called sharp, did you mean sharper")

# Outside the range for which the constants are meant.
delcert_cli_test(constants-separation-too-large STATUS 3 OUTPUT "^$"
  COMMAND ${constants} --dim 2 --separation 3/2 --perturbation 1/4
  ERROR "^delcert: error: separation is 3/2.*at most 1.*use min.1, measured.*\n$")
delcert_cli_test(constants-separation-zero STATUS 3 OUTPUT "^$"
  COMMAND ${constants} --dim 2 --separation 0 --perturbation 1/4 ERROR "separation is 0.*above 0 and at most 1")
delcert_cli_test(constants-perturbation-too-large STATUS 3 OUTPUT "^$"
  COMMAND ${constants} --dim 2 --separation 1/2 --perturbation 1/4 ERROR "perturbation is 1/4.*above 0 and at most 1/8")
delcert_cli_test(constants-perturbation-zero STATUS 3 OUTPUT "^$"
  COMMAND ${constants} --dim 2 --separation 1 --perturbation 0 ERROR "perturbation is 0")
delcert_cli_test(constants-dimension-zero STATUS 3 OUTPUT "^$"
  COMMAND ${constants} --dim 0 --separation 1 --perturbation 1/4 ERROR "dimension is 0.*1 to 16")
delcert_cli_test(constants-distortion-one STATUS 3 OUTPUT "^$"
  COMMAND ${constants} ${surface} --distortion 1 ERROR "distortion is 1.*below 1")
delcert_cli_test(constants-radius-variation-too-large STATUS 3 OUTPUT "^$"
  COMMAND ${constants} --dim 2 --separation 1 --perturbation 1/10 --radius-variation 3/2
  ERROR "radius variation is 3/2.*0 to .*= 1\n$")

# Command lines that cannot be read.
delcert_cli_test(constants-decimal STATUS 64 OUTPUT "^$"
  COMMAND ${constants} --dim 2 --separation 1 --perturbation 0.25 ERROR "--perturbation.*0.25.*write 25/100")
delcert_cli_test(constants-dimension-as-fraction STATUS 64 OUTPUT "^$"
  COMMAND ${constants} --dim 5/2 --separation 1 --perturbation 1/4 ERROR "--dim")
delcert_cli_test(constants-without-separation STATUS 64 OUTPUT "^$"
  COMMAND ${constants} --dim 2 --perturbation 1/4 ERROR "--separation is required")
delcert_cli_test(constants-json-and-latex STATUS 64 OUTPUT "^$"
  COMMAND ${constants} ${surface} --json --latex ERROR "--json excludes --latex")
delcert_cli_test(constants-unknown-option STATUS 64 OUTPUT "^$" COMMAND ${constants} ${surface} --separtion 1
  ERROR "--separtion")

# Sweeps.
delcert_cli_test(constants-sweep STATUS 0 ERROR "^$" COMMAND ${constants} --dim 2..6 --separation 1/4,1/2,1
  OUTPUT "^ρ̃₀  perturbation tilde  .hyps:param.bnds.\n.*2  1/2  1/8 +2.[(]-989[)].*6  1/4  1/16 .*Hypotheses 2 .* hold for all")
delcert_cli_test(constants-sweep-json STATUS 0 ERROR "^$"
  COMMAND ${constants} --dim 2,3 --separation 1/4,1 --perturbation 1/16,1/4 --json --only flake_parameter
  OUTPUT "^{\n  \"ledgers\": .*\"exact\": \"2.[(]-293/2[)]\".*\"left_out\": .*perturbation is 1/4")
delcert_cli_test(constants-sweep-latex STATUS 0 ERROR "^$" COMMAND ${constants} --dim 2,3 --separation 1 --latex
  OUTPUT "^{.footnotesize.*.begin{longtable}.*.toprule.*.end{longtable}}\n")
delcert_cli_test(constants-default-perturbation STATUS 0 ERROR "^$" COMMAND ${constants} --dim 2 --separation 1/2
  OUTPUT "ρ₀ +perturbation +1/8 ")
delcert_cli_test(constants-only STATUS 0 ERROR "^$" COMMAND ${constants} ${surface} --only tolerance
  OUTPUT "^ +constant [^\n]*\n2α̃₀ +tolerance +2.[(]-32[)] [^\n]*\n\nHypotheses")
delcert_cli_test(constants-sweep-value-that-fits-nothing STATUS 3 OUTPUT "^$"
  COMMAND ${constants} --dim 2..17 --separation 1 ERROR "^delcert: error: dimension is 17; allowed: 1 to 16\n$")
delcert_cli_test(constants-sweep-perturbation-too-large STATUS 3 OUTPUT "^$"
  COMMAND ${constants} --dim 2 --separation 1/4,1/2 --perturbation 1/16,1/4 ERROR "perturbation is 1/4; allowed")
foreach(malformed "--dim;6..2" "--dim;2.." "--dim;two" "--dim;2,2" "--separation;1/2,,1" "--separation;0.5,1"
    "--separation;1/2,2/4" "--perturbation;," "--only;flake-parameter" "--only;nothing")
  list(GET malformed 0 option)
  list(POP_FRONT malformed)
  list(JOIN malformed "-" name)
  string(MAKE_C_IDENTIFIER "${option}-${name}" name)
  set(arguments --dim 2 --separation 1 --perturbation 1/4)
  list(FIND arguments ${option} at)
  if(NOT at EQUAL -1)
    math(EXPR next "${at} + 1")
    list(REMOVE_AT arguments ${at} ${next})
  endif()
  delcert_cli_test(constants-malformed-${name} STATUS 64 OUTPUT "^$"
    COMMAND ${constants} ${arguments} ${option} ${malformed} ERROR "^delcert: error: [^\n]+\ndelcert: see delcert --help\n$")
endforeach()
