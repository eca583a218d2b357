# The rule of cmake/Twins.cmake, on small trees: what is in order passes, each way to break it is named.
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/../../cmake/Twins.cmake)

# A tree of these empty files, and what the rule must say about it.
function(expect_complaints title files exemptions expected)
  file(REMOVE_RECURSE ${WORK})
  foreach(name IN LISTS files)
    file(WRITE ${WORK}/${name} "")
  endforeach()
  delcert_twin_complaints(${WORK} "${exemptions}" complaints)
  if(NOT "${complaints}" STREQUAL "${expected}")
    message(SEND_ERROR "${title}\n  expected: ${expected}\n  got:      ${complaints}")
  endif()
endfunction()

set(in_order kernel/a/x.hpp kernel/a/x.cpp tests/kernel/a/x_test.cpp proofs/constants/y.cpp tests/proofs/constants/y_test.cpp)
expect_complaints("in order" "${in_order}" "" "")
expect_complaints("other folders need no twins" "${in_order};apps/z.cpp;tests/oracles/z_test.cpp;proofs/checker/z.cpp" "" "")
expect_complaints("a source without test" "${in_order};kernel/a/z.hpp" ""
  "kernel/a/z (.hpp or .cpp) has no tests/kernel/a/z_test.cpp")
expect_complaints("the test of another folder" "${in_order};kernel/b/x.cpp" ""
  "kernel/b/x (.hpp or .cpp) has no tests/kernel/b/x_test.cpp")
expect_complaints("a test without source" "${in_order};tests/proofs/certificate/w_test.cpp" ""
  "tests/proofs/certificate/w_test.cpp has neither proofs/certificate/w.hpp nor proofs/certificate/w.cpp")
expect_complaints("explicit instantiations belong to their header"
  "${in_order};kernel/a/x_1.cpp;kernel/a/x_2.cpp" "" "")
expect_complaints("a number does not excuse what has no header" "${in_order};kernel/a/z_1.cpp" ""
  "kernel/a/z_1 (.hpp or .cpp) has no tests/kernel/a/z_1_test.cpp")
expect_complaints("exempt" "${in_order};kernel/a/z.hpp" "kernel/a/z;a reason" "")
expect_complaints("exempt without a reason" "${in_order};kernel/a/z.hpp" "kernel/a/z;"
  "cmake/Twins.cmake exempts kernel/a/z without a reason")
expect_complaints("exempt in vain" "${in_order}" "kernel/a/x;a reason"
  "cmake/Twins.cmake exempts kernel/a/x, which has its test")
expect_complaints("exempt and gone" "${in_order}" "kernel/a/z;a reason"
  "cmake/Twins.cmake exempts kernel/a/z, which does not exist")
file(REMOVE_RECURSE ${WORK})
