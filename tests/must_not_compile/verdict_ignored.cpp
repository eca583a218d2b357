#include "kernel/number/rational.hpp"

using namespace delcert;

void decide(const Rational& a) {
#ifdef MUST_NOT_COMPILE
  verdict_of(a < Rational(1));  // must not compile
#else
  static_cast<void>(verdict_of(a < Rational(1)));
#endif
}
