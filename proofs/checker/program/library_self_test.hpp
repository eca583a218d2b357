#pragma once

#include <string>

namespace delcert::checker {

/// Tests the functions of FLINT and Arb that verdicts rest on by known answers, in the mode of rounding of the thread:
/// Smith's normal form, factors of polynomials and arithmetic modulo one run under upward rounding, enclosures by balls
/// under rounding to nearest. Both are tested under both. Returns what is wrong, or nothing. The mode is as before.
std::string library_self_test();

}  // namespace delcert::checker
