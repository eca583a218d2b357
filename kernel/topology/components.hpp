#pragma once

#include <cstddef>

#include "kernel/topology/pure_complex.hpp"

namespace delcert {

/// The number of connected components. Linear time but for the inverse of Ackermann's function.
[[nodiscard]] std::size_t component_count(const PureComplex& complex);

}  // namespace delcert
