#include "kernel/number/strong.hpp"

using namespace delcert;

Dimension dimension_of(Label label) {
#ifdef MUST_NOT_COMPILE
  return Dimension(label);  // must not compile
#else
  return Dimension(label.value);
#endif
}
