#include "kernel/number/algebraic.hpp"

using namespace delcert;

Algebraic made() {
#ifdef MUST_NOT_COMPILE
  return Algebraic(0.1);  // must not compile
#else
  return Algebraic(Rational(1) / Rational(10));
#endif
}
