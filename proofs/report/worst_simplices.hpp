#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace delcert {

/// How many of the worst simplices a page lists for each measure.
inline constexpr std::size_t worst_listed = 10;

/// The places of the `worst_listed` worst values, the worst first; of equal ones the first. NaN is no value.
[[nodiscard]] std::vector<std::uint32_t> worst_simplices(const std::vector<double>& values, bool least_is_worst);

}  // namespace delcert
