#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace delcert {

/// What every certified result rests on, tried out in this very process and thread: that directed rounding is really
/// directed (sums, products, quotients, roots against exact rationals), that the compiler neither evaluated in
/// advance, nor regrouped, nor contracted to fused operations, that nothing flushes subnormals to zero, that rounding
/// is to nearest outside a guard and again after one, that Interval and MPFI enclose, that MPFR and FLINT keep threads
/// apart, and that each library is the one whose headers were compiled. Returns one sentence for each failure; empty
/// means fit to certify. Precondition: no RoundingGuard is alive. Takes well under a millisecond: programs run it at
/// their start.
[[nodiscard]] std::vector<std::string> arithmetic_self_test();

/// The libraries that the arithmetic uses, as name and version, in alphabetical order; the same for every compiler.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> library_versions();

namespace detail {
/// The complaint about a library that is not the one its headers belong to; empty if it is.
[[nodiscard]] std::string version_mismatch(std::string_view library, std::string_view of_headers,
                                           std::string_view of_library);
}  // namespace detail

}  // namespace delcert
