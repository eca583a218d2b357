#include "kernel/number/verdict.hpp"

using namespace delcert;

Verdict opposite(Verdict verdict) {
#ifdef MUST_NOT_COMPILE
  return verdict_of(!verdict);  // must not compile
#else
  return negation(verdict);
#endif
}
