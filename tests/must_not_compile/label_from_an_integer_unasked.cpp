#include "kernel/number/strong.hpp"

using namespace delcert;

Label made() {
#ifdef MUST_NOT_COMPILE
  return 7;  // must not compile
#else
  return Label(7);
#endif
}
