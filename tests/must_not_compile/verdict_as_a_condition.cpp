#include "kernel/number/verdict.hpp"

using namespace delcert;

int answer(Verdict verdict) {
#ifdef MUST_NOT_COMPILE
  if (verdict) return 1;  // must not compile
#else
  if (is_proved(verdict)) return 1;
#endif
  return 0;
}
