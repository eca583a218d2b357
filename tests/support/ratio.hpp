#pragma once

#include "kernel/number/rational.hpp"

namespace delcert::test {

inline Rational ratio(long numerator, long denominator) { return Rational(numerator) / Rational(denominator); }

}  // namespace delcert::test
