#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <queue>
#include <vector>

namespace delcert {

/// m + 1 labels in increasing order, then the numbers of the group elements at which the second to the last vertex are:
/// the lifts of the simplex are p_{j_0}, g_{e_1} p_{j_1}, ….
template <int m>
using PlacedSimplex = std::array<std::uint32_t, 2 * static_cast<std::size_t>(m) + 1>;

template <int m>
[[nodiscard]] std::uint32_t element_at(const PlacedSimplex<m>& simplex, std::size_t corner) {
  return corner == 0 ? 0 : simplex[static_cast<std::size_t>(m) + corner];
}

/// From one vertex of a simplex, by its position, to another.
struct LoopStep {
  std::uint32_t simplex, from, to;
  friend bool operator==(const LoopStep&, const LoopStep&) = default;
};

/// Edge paths in the universal cover of a complex of placed simplices, from label 0 to its image under an element of
/// the group: best first, by the distance that remains, so that a path is about as short as a straight one.
///
/// `Motions` has a type `Motion` (an element of the group, possibly approximate) and
/// * `identity()`, `of(number)`, `inverse_of(number)`, `product(a, b)`;
/// * `are_same(a, b)`: whether these are the same element, if both take one label to places that are near each other;
/// * `remaining(label, a, target)`: increases with the distance of the label, moved by a, from label 0 moved by target.
template <int m, class Motions>
class LoopSearch {
 public:
  using Motion = typename Motions::Motion;

  LoopSearch(const std::vector<PlacedSimplex<m>>& simplices, std::size_t labels, const Motions& motions)
      : simplices_(simplices), motions_(motions), first_(labels + 1, 0) {
    for (const auto& simplex : simplices) {
      for (std::size_t corner = 0; corner <= m; ++corner) ++first_[simplex[corner] + 1];
    }
    for (std::size_t label = 0; label < labels; ++label) first_[label + 1] += first_[label];
    at_.resize(first_.back());
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for (std::uint32_t number = 0; number < simplices.size(); ++number) {
      for (std::size_t corner = 0; corner <= m; ++corner) at_[next[simplices[number][corner]]++] = number;
    }
  }

  /// None if there is no path, or none among the first `most_places` places that are looked at.
  [[nodiscard]] std::optional<std::vector<LoopStep>> find(const Motion& target, std::size_t most_places = 1000000) {
    nodes_.assign(1, {0, motions_.identity(), 0, {}});
    known_.clear();
    known_[0].emplace(far_from_start(0, nodes_[0].motion), 0);
    std::priority_queue<std::pair<double, std::size_t>, std::vector<std::pair<double, std::size_t>>, std::greater<>>
        open;
    open.push({0, 0});
    while (!open.empty() && nodes_.size() < most_places) {
      const std::size_t here = open.top().second;
      open.pop();
      if (here != 0 && nodes_[here].label == 0 && motions_.are_same(nodes_[here].motion, target)) return path_to(here);
      for (std::size_t at = first_[nodes_[here].label]; at < first_[nodes_[here].label + 1]; ++at) {
        for (const std::size_t added : neighbours_in(at_[at], here))
          open.push({motions_.remaining(nodes_[added].label, nodes_[added].motion, target), added});
      }
    }
    return std::nullopt;
  }

 private:
  struct Node {
    std::uint32_t label;
    Motion motion;
    std::size_t before;
    LoopStep step;
  };

  /// The same, up to rounding, for the same places.
  double far_from_start(std::uint32_t label, const Motion& motion) const {
    return motions_.remaining(label, motion, motions_.identity());
  }

  /// The vertices of the simplex that are new.
  std::vector<std::size_t> neighbours_in(std::uint32_t number, std::size_t here) {
    const PlacedSimplex<m>& simplex = simplices_[number];
    std::uint32_t from = 0;
    while (simplex[from] != nodes_[here].label) ++from;
    const Motion base = motions_.product(nodes_[here].motion, motions_.inverse_of(element_at<m>(simplex, from)));
    std::vector<std::size_t> result;
    for (std::uint32_t to = 0; to <= m; ++to) {
      if (to == from) continue;
      const Motion motion = motions_.product(base, motions_.of(element_at<m>(simplex, to)));
      auto& places = known_[simplex[to]];
      const double far = far_from_start(simplex[to], motion);
      const double rounding = 1e-6 * (1 + std::abs(far));
      bool is_known = false;
      for (auto at = places.lower_bound(far - rounding); at != places.upper_bound(far + rounding) && !is_known; ++at)
        is_known = motions_.are_same(nodes_[at->second].motion, motion);
      if (is_known) continue;
      places.emplace(far, nodes_.size());
      result.push_back(nodes_.size());
      nodes_.push_back({simplex[to], motion, here, {number, from, to}});
    }
    return result;
  }

  std::vector<LoopStep> path_to(std::size_t node) const {
    std::vector<LoopStep> result;
    for (; node != 0; node = nodes_[node].before) result.push_back(nodes_[node].step);
    return {result.rbegin(), result.rend()};
  }

  const std::vector<PlacedSimplex<m>>& simplices_;
  const Motions& motions_;
  std::vector<std::size_t> first_;  // simplices with a label: at_[first_[label]] … at_[first_[label + 1] − 1]
  std::vector<std::uint32_t> at_;
  std::vector<Node> nodes_;
  std::map<std::uint32_t, std::multimap<double, std::size_t>> known_;  // places of a label, by how far from the start
};

}  // namespace delcert
