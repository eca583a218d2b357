#include "kernel/number/rounding_guard.hpp"

using namespace delcert;

void use(const RoundingGuard& guard) {
#ifdef MUST_NOT_COMPILE
  const RoundingGuard other = guard;  // must not compile
#else
  const RoundingGuard& other = guard;
#endif
  static_cast<void>(other);
}
