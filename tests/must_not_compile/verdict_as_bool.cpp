#include "kernel/number/verdict.hpp"

using namespace delcert;

bool truth(Verdict verdict) {
#ifdef MUST_NOT_COMPILE
  return verdict;  // must not compile
#else
  return is_proved(verdict);
#endif
}
