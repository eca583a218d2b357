#pragma once

#include <filesystem>

#include "kernel/topology/pure_complex.hpp"

namespace delcert {

/// The complex of the simplices of a certificate, plain or compressed, from their labels alone: of each row under its
/// key `simplices`, 2m + 1 integers, the first m + 1. Nothing else of the file is looked at, nor need there be anything
/// else: not the manifold, not its group, no element, no point. Throws InputError with the file and what is wrong: no
/// such list, rows of different lengths, a label twice, no simplex at all.
[[nodiscard]] PureComplex read_simplices(const std::filesystem::path& path);

}  // namespace delcert
