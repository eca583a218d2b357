#include "kernel/number/interval.hpp"

using namespace delcert;

Interval sum(const Interval& a) {
#ifdef MUST_NOT_COMPILE
  return a + 1.0;  // must not compile
#else
  return a + 1;
#endif
}
