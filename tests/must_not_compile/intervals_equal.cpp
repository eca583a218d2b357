#include "kernel/number/interval.hpp"

using namespace delcert;

Verdict compare(const Interval& a, const Interval& b) {
#ifdef MUST_NOT_COMPILE
  return verdict_of(a == b);  // must not compile
#else
  return is_zero(a - b);
#endif
}
