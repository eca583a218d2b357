#include "kernel/number/big_interval.hpp"

using namespace delcert;

BigInterval made() {
#ifdef MUST_NOT_COMPILE
  return BigInterval(0.1);  // must not compile
#else
  return BigInterval(Rational(1) / Rational(10));
#endif
}
