#include "kernel/number/strong.hpp"

using namespace delcert;

bool same(Label label, Dimension dimension) {
#ifdef MUST_NOT_COMPILE
  return label == dimension;  // must not compile
#else
  return label == Label(dimension.value);
#endif
}
