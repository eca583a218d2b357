#pragma once

#include <string>

namespace delcert::checker {

/// Makes the thread round upwards and tests what the verdicts rest on: that rounding really is upwards in the code as
/// compiled, that products are not fused into sums, and that the GMP and FLINT at hand are those compiled against and
/// compute rightly in this mode. Returns what is wrong, or nothing.
std::string self_test();

}  // namespace delcert::checker
