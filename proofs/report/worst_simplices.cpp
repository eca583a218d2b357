#include "proofs/report/worst_simplices.hpp"

#include <algorithm>
#include <cmath>

namespace delcert {

std::vector<std::uint32_t> worst_simplices(const std::vector<double>& values, bool least_is_worst) {
  std::vector<std::uint32_t> order;
  for (std::size_t at = 0; at < values.size(); ++at) {
    if (!std::isnan(values[at])) order.push_back(static_cast<std::uint32_t>(at));
  }
  const std::size_t listed = std::min(worst_listed, order.size());
  std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(listed), order.end(),
                    [&](std::uint32_t a, std::uint32_t b) {
                      return values[a] == values[b] ? a < b : (values[a] < values[b]) == least_is_worst;
                    });
  order.resize(listed);
  return order;
}

}  // namespace delcert
