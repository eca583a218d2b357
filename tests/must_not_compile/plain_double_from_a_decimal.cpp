#include "kernel/number/plain_double.hpp"

using namespace delcert;

PlainDouble made() {
#ifdef MUST_NOT_COMPILE
  return PlainDouble(0.1);  // must not compile
#else
  return PlainDouble::exactly(0x1p-3);
#endif
}
