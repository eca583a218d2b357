#include "kernel/number/rational.hpp"

using namespace delcert;

Rational half(const Rational& a) {
#ifdef MUST_NOT_COMPILE
  return a * 0.5;  // must not compile
#else
  return a / 2;
#endif
}
