#include "kernel/number/interval.hpp"

using namespace delcert;

Interval made() {
#ifdef MUST_NOT_COMPILE
  const Interval x = 0.5;  // must not compile
#else
  const Interval x = 1;
#endif
  return x;
}
