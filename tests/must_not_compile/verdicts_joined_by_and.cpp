#include "kernel/number/verdict.hpp"

using namespace delcert;

Verdict both(Verdict a, Verdict b) {
#ifdef MUST_NOT_COMPILE
  return verdict_of(a && b);  // must not compile
#else
  return conjunction(a, b);
#endif
}
