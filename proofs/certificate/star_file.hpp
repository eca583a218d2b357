#pragma once

#include <filesystem>

#include "kernel/topology/pure_complex.hpp"

namespace delcert {

/// The complex of all simplices in the stars of a certificate, plain or compressed: the list under its key `stars`,
/// that has for each label the other labels of the simplices of its star. Nothing else of the file is looked at, nor
/// need there be anything else: not the manifold, not its group, no point. Throws InputError with the file and what is
/// wrong: no such list, a label that is not a number of the list, simplices of different dimensions, no simplex at all.
[[nodiscard]] PureComplex read_star_complex(const std::filesystem::path& path);

}  // namespace delcert
