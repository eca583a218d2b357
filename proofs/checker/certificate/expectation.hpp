#pragma once

#include <string>
#include <string_view>

namespace delcert::checker {

/// Compares a manifold block with the one that is expected: the document is a certificate, or such a block alone.
/// Numbers are compared by value. Not compared are the name and what a run chooses or certifies: injectivity_radius,
/// rounding, patch_radius, metric_distortion. Returns the first key at which they differ, or nothing. Throws
/// std::invalid_argument if the document is neither.
std::string difference_from_expected(std::string_view document, std::string_view block);

}  // namespace delcert::checker
