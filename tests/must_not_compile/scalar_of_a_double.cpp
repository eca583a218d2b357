#include "kernel/number/scalar.hpp"

using namespace delcert;

void make(const Rational& x) {
#ifdef MUST_NOT_COMPILE
  static_cast<void>(scalar_from<double>(x));  // must not compile
#else
  static_cast<void>(scalar_from<Interval>(x));
#endif
}
