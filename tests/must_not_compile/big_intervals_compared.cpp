#include "kernel/number/big_interval.hpp"

using namespace delcert;

Verdict compare(const BigInterval& a, const BigInterval& b) {
#ifdef MUST_NOT_COMPILE
  return verdict_of(a < b);  // must not compile
#else
  return less(a, b);
#endif
}
