#include "kernel/number/rational.hpp"

using namespace delcert;

Rational made() {
#ifdef MUST_NOT_COMPILE
  return Rational(0.1);  // must not compile
#else
  return Rational(1) / Rational(10);
#endif
}
