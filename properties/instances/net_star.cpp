#include "properties/instances/net_star.hpp"

#include <algorithm>
#include <set>

#include "kernel/number/ladder.hpp"
#include "kernel/simplex/sphere_stack.hpp"

namespace delcert {

namespace {

/// The points around the first one, relative to it, the nearest first.
template <int m>
class Surroundings {
 public:
  Surroundings(const std::vector<Vector<Rational, m>>& points, const Rational& distance)
      : filter_(FrameMetric<m>::cartesian().template on<Filter>()),
        exact_(FrameMetric<m>::cartesian().template on<Rational>()) {
    std::vector<std::pair<Rational, std::uint32_t>> order;
    for (std::uint32_t at = 1; at < points.size(); ++at) {
      Rational squared = exact_.squared_norm(difference(points[at], points[0]));
      if (squared <= square(distance)) order.emplace_back(std::move(squared), at);
    }
    std::sort(order.begin(), order.end());
    has_all_ = order.size() + 1 == points.size();
    squared_reach_ = square(distance) / Rational(4);
    for (auto& [squared, at] : order) {
      number_.push_back(at);
      edge_.push_back(difference(points[at], points[0]));
      squared_.push_back(std::move(squared));
      Vector<Filter, m> enclosure;
      for (std::size_t axis = 0; axis < m; ++axis) enclosure[axis] = scalar_from<Filter>(edge_.back()[axis]);
      filter_edge_.push_back(enclosure);
      filter_squared_.push_back(scalar_from<Filter>(squared_.back()));
    }
  }

  [[nodiscard]] bool has_all() const { return has_all_; }
  /// Nothing if what is around does not settle the cells.
  [[nodiscard]] std::optional<StarCells> cells() {
    constexpr std::size_t most = m == 2 ? 300 : 160;
    if (edge_.size() > most || !is_surrounded()) return std::nullopt;
    SphereStack<Filter, m> stack(filter_);
    std::array<std::size_t, static_cast<std::size_t>(m)> chosen{};
    walk(stack, chosen, 0, 0);
    if (!has_all_ && squared_reach_ < largest_) return std::nullopt;
    return StarCells(found_.begin(), found_.end());
  }

 private:
  /// Whether the first point is strictly inside a simplex of points around it, so that its Voronoi cell is bounded.
  /// Only simplices of the nearest points are tried: more points around, or all of them, come later.
  [[nodiscard]] bool is_surrounded() const {
    constexpr std::size_t most = 30;
    std::vector<std::size_t> subset(static_cast<std::size_t>(m) + 1);
    return surrounds(subset, 0, 0, std::min(edge_.size(), most));
  }
  bool surrounds(std::vector<std::size_t>& subset, std::size_t depth, std::size_t first, std::size_t count) const {
    if (depth == subset.size()) return holds_origin(subset);
    for (std::size_t at = first; at < count; ++at) {
      subset[depth] = at;
      if (surrounds(subset, depth + 1, at + 1, count)) return true;
    }
    return false;
  }
  /// Whether 0 = Σ λ_v v with all λ_v > 0: the determinants with a vertex left out alternate strictly.
  [[nodiscard]] bool holds_origin(const std::vector<std::size_t>& subset) const {
    const auto all_alike = [&]<class S>(const std::vector<Vector<S, m>>& edges) {
      Verdict positive = Verdict::proved;
      Verdict negative = Verdict::proved;
      for (std::size_t omitted = 0; omitted < subset.size(); ++omitted) {
        std::array<Vector<S, m>, static_cast<std::size_t>(m)> rows;
        std::size_t row = 0;
        for (std::size_t v = 0; v < subset.size(); ++v) {
          if (v != omitted) rows[row++] = edges[subset[v]];
        }
        std::array<Vector<S, m>, static_cast<std::size_t>(m)> others;
        for (std::size_t v = 1; v < m; ++v) others[v - 1] = rows[v];
        const S determinant = pairing(wedge(others), rows[0]);
        const bool odd = omitted % 2 == 1;
        positive = conjunction(positive, odd ? less(determinant, S(0)) : less(S(0), determinant));
        negative = conjunction(negative, odd ? less(S(0), determinant) : less(determinant, S(0)));
      }
      return disjunction(positive, negative);
    };
    const Verdict quick = all_alike(filter_edge_);
    return is_proved(is_undecided(quick) ? all_alike(edge_) : quick);
  }

  void walk(SphereStack<Filter, m>& stack, std::array<std::size_t, static_cast<std::size_t>(m)>& chosen,
            std::size_t depth, std::size_t first) {
    for (std::size_t at = first; at < edge_.size(); ++at) {
      chosen[depth] = at;
      const Verdict ok = stack.push(filter_edge_[at], filter_squared_[at]);
      if (is_refuted(ok)) continue;
      if (is_undecided(ok)) {
        walk_exactly(chosen, depth + 1, at + 1);
        continue;
      }
      if (depth + 1 == m) {
        look(stack, chosen);
      } else {
        walk(stack, chosen, depth + 1, at + 1);
      }
      stack.pop();
    }
  }

  /// The same where the filter could not tell whether the chosen edges are independent.
  void walk_exactly(std::array<std::size_t, static_cast<std::size_t>(m)>& chosen, std::size_t depth,
                    std::size_t first) {
    if (depth == m) {
      look_exactly(chosen);
      return;
    }
    for (std::size_t at = first; at < edge_.size(); ++at) {
      chosen[depth] = at;
      walk_exactly(chosen, depth + 1, at + 1);
    }
  }

  void look(const SphereStack<Filter, m>& stack, const std::array<std::size_t, static_cast<std::size_t>(m)>& chosen) {
    for (std::size_t other = 0; other < edge_.size(); ++other) {
      if (std::find(chosen.begin(), chosen.end(), other) != chosen.end()) continue;
      if (is_proved(less(stack.power(filter_edge_[other], filter_squared_[other]), Filter(0)))) return;
    }
    // Few are left: what they have on their spheres, and their radii, are wanted exactly.
    look_exactly(chosen);
  }

  void look_exactly(const std::array<std::size_t, static_cast<std::size_t>(m)>& chosen) {
    SphereStack<Rational, m> stack(exact_);
    for (const std::size_t at : chosen) {
      if (!is_proved(stack.push(edge_[at], squared_[at]))) return;
    }
    std::vector<std::uint32_t> cell{0};
    for (std::size_t other = 0; other < edge_.size(); ++other) {
      const Rational power = stack.power(edge_[other], squared_[other]);
      if (power < Rational(0)) return;
      if (power == Rational(0)) cell.push_back(number_[other]);
    }
    std::sort(cell.begin(), cell.end());
    largest_ = maximum(largest_, stack.squared_radius());
    found_.insert(std::move(cell));
  }

  MetricOn<Filter, m> filter_;
  MetricOn<Rational, m> exact_;
  std::vector<std::uint32_t> number_;
  std::vector<Vector<Rational, m>> edge_;
  std::vector<Rational> squared_;
  std::vector<Vector<Filter, m>> filter_edge_;
  std::vector<Filter> filter_squared_;
  bool has_all_ = false;
  Rational squared_reach_;
  Rational largest_;
  std::set<std::vector<std::uint32_t>> found_;
};

}  // namespace

template <int m>
std::optional<StarCells> star_cells(const std::vector<Vector<Rational, m>>& points, const Rational& distance) {
  const FilterGuard guard;
  for (Rational reach = distance;; reach *= Rational(Integer(5), Integer(4))) {
    Surroundings<m> surroundings(points, reach);
    if (auto cells = surroundings.cells()) return cells;
    if (surroundings.has_all()) return std::nullopt;
  }
}

template std::optional<StarCells> star_cells<2>(const std::vector<Vector<Rational, 2>>&, const Rational&);
template std::optional<StarCells> star_cells<3>(const std::vector<Vector<Rational, 3>>&, const Rational&);

}  // namespace delcert
