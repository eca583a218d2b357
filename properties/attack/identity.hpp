#pragma once

#include <string>

#include "proofs/formula/claim.hpp"
#include "properties/instances/instance_class.hpp"

namespace delcert {

/// All of a claim in a shape on which attacks depend.
[[nodiscard]] std::string contents_of(const Claim& claim, const Shape& shape);

/// What tells work on these contents from other work: the version, the seed and a digest.
[[nodiscard]] std::string identity_of(const std::string& contents, std::uint64_t seed);

}  // namespace delcert
