#pragma once

#include <string>

namespace delcert::checker_tests {

/// Where a certificate of a space form claims what another, a true one,
/// does not imply, as far as that can be seen without geometry: other words are informative, lower bounds may be less
/// and upper ones more. The paths of the other differences; nothing if there are none. In the kernel's rational
/// arithmetic and with a reader of its own.
std::string stronger_claims(const std::string& truth, const std::string& text);

}  // namespace delcert::checker_tests
