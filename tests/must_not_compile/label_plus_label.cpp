#include "kernel/number/strong.hpp"

using namespace delcert;

unsigned sum(Label a, Label b) {
#ifdef MUST_NOT_COMPILE
  return a + b;  // must not compile
#else
  return a.value + b.value;
#endif
}
