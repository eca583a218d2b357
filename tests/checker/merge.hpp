#pragma once

#include <string>
#include <vector>

namespace delcert::checker_tests {

/// Expects that the parts of the check of a certificate, put together from their receipts, say what the check says, for
/// each of the numbers of parts.
void expect_the_same_in_parts(const std::string& certificate, const std::vector<unsigned>& numbers);

}  // namespace delcert::checker_tests
