#include "kernel/number/interval.hpp"

using namespace delcert;

Interval made() {
#ifdef MUST_NOT_COMPILE
  return Interval(0.1);  // must not compile
#else
  return Interval::exactly(0x1p-3);
#endif
}
