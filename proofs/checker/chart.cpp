#include "proofs/checker/chart.hpp"

#include <algorithm>

namespace delcert::checker {

std::size_t Chart::find(Label label) const {
  const auto [first, last] = std::equal_range(seen_.begin(), seen_.end(), Seen{label, 0, {}},
                                              [](const Seen& a, const Seen& b) { return a.label < b.label; });
  if (last - first > 1) {
    throw Undecided("label " + std::to_string(label) + " may have two lifts in reach of label " +
                    std::to_string(label_));
  }
  return first == last ? none : static_cast<std::size_t>(first - seen_.begin());
}

std::vector<std::size_t> Chart::find(Label first, const Label* others, Label& missing) const {
  std::vector<std::size_t> places;
  for (int k = -1; k < c_.m; ++k) {
    missing = k < 0 ? first : others[k];
    places.push_back(find(missing));
    if (places.back() == none) return {};
  }
  return places;
}

}  // namespace delcert::checker
