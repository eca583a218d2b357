#include "kernel/theorems/simplex_pairs.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "kernel/chart/ambient_grid.hpp"
#include "kernel/number/middle.hpp"
#include "kernel/number/rounding_guard.hpp"
#include "kernel/parallel/parts.hpp"

namespace delcert {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr std::size_t simplices_at_a_time_in_pairs = 16;

/// The pairs, simplex by simplex. All but the constructor needs a `RoundingGuard`, and that too.
template <int m>
class PairSearch {
 public:
  PairSearch(const GraphVertices& vertices, const std::vector<LabelSimplex<m>>& simplices,
             const std::vector<GraphSimplex<m>>& measures, const std::vector<bool>& is_tight, double displacement,
             double most)
      : vertices_(vertices),
        simplices_(simplices),
        measures_(measures),
        n_(vertices.manifold.ambient()),
        q_(vertices.manifold.codimension()),
        most_(most),
        rooms_(vertices.charts.size(), infinite),
        rank_(vertices.charts.size(), none) {
    for (std::size_t at = 0; at < simplices.size(); ++at) {
      bool is_one = false;
      for (std::size_t v = 0; v <= m; ++v) {
        const std::uint32_t label = simplices[at][v];
        is_one = is_one || is_tight[label];
        const Interval room = Interval::exactly(measures[at].rooms[v]) / Interval::exactly(vertices.unit(label));
        rooms_[label] = std::min(rooms_[label], room.lower());
      }
      if (is_one) near_.push_back(near_simplex(at, displacement));
    }
    // Each is compared with those that are not larger.
    std::stable_sort(near_.begin(), near_.end(), [](const Near& a, const Near& b) { return a.radius < b.radius; });
    const double usual = near_.empty() ? 1 : near_[near_.size() / 2].radius;
    grid_.emplace(n_, 4 * usual);
    for (const Near& one : near_) grid_->insert(one.middle.data());
  }

  /// How many simplices have a tight label.
  [[nodiscard]] std::size_t size() const { return near_.size(); }

  /// The pairs of the simplex with this number and one before it.
  void add_pairs_of(std::size_t number, const std::vector<bool>& is_tight, SimplexPairs& result) const {
    const Near& one = near_[number];
    grid_->visit(one.middle.data(), 2 * one.radius, [&](std::uint32_t other, double squared) {
      if (other >= number) return false;
      const double reach = (one.radius + near_[other].radius) * (1 + 0x1p-20);
      if (squared > reach * reach) return false;
      const double found = margin_of(one, near_[other]);
      if (found < result.margin) {
        result.margin = found;
        result.tightest = Label(simplices_[one.at][0]);
      }
      if (found > 0) return false;
      for (const std::size_t at : {one.at, near_[other].at}) {
        for (const std::uint32_t label : simplices_[at]) {
          if (is_tight[label]) result.crowded.emplace_back(label);
        }
      }
      return false;
    });
  }

 private:
  static constexpr std::uint32_t none = 0xffffffffU;
  using Place = std::array<double, most_ambient_dimensions>;

  /// A simplex that has a tight label.
  struct Near {
    std::size_t at;
    Place middle{};     // its barycentre, rounded
    double radius = 0;  // what H may move it to, and the greatest margin about that, are nearer to the barycentre
    std::array<Place, static_cast<std::size_t>(m) + 1> outward{};  // in its plane, normals of its facets, rounded
  };

  [[nodiscard]] Near near_simplex(std::size_t at, double displacement) {
    const LabelSimplex<m>& simplex = simplices_[at];
    Near result{at};
    for (const std::uint32_t v : simplex) {
      for (std::size_t axis = 0; axis < n_; ++axis)
        result.middle[axis] += vertices_.position(v)[axis].lower() / (m + 1);
    }
    // A point of a simplex is at most m/(m + 1) edges from the barycentre.
    const Interval room =
        (Interval::exactly(displacement) + Interval::exactly(most_)) * Interval::exactly(vertices_.unit(simplex));
    result.radius = ((Interval::exactly(measures_[at].edge) * Interval(m) / Interval(m + 1) + room) *
                     Interval::exactly(1 + 0x1p-20))
                        .upper();
    const GraphSimplexCheck<m> check(vertices_);
    const auto gradients = check.gradients(simplex[0], simplex);
    const EnclosedChart<Interval>& chart = vertices_.charts[simplex[0]].enclosed();
    for (std::size_t v = 0; gradients && v <= m; ++v) {
      for (std::size_t axis = 0; axis < n_; ++axis) {
        for (std::size_t column = 0; column < m; ++column)
          result.outward[v][axis] -= middle_of(chart.at(axis, column)) * middle_of((*gradients)[v][column]);
      }
    }
    for (const std::uint32_t v : simplex) {
      if (rank_[v] != none) continue;
      rank_[v] = static_cast<std::uint32_t>(fibres_.size());
      fibres_.resize(fibres_.size() + n_ * q_);
      check.fibre(v, &fibres_[rank_[v]]);
    }
    return result;
  }

  [[nodiscard]] double margin_of(const Near& one, const Near& other) const {
    double result = -infinite;
    for (const std::uint32_t label : simplices_[one.at]) {
      const LabelSimplex<m>& there = simplices_[other.at];
      if (std::find(there.begin(), there.end(), label) != there.end()) result = std::max(result, rooms_[label]);
    }
    return result > -infinite ? result : gap_of(one, other);
  }

  /// Between simplices without a common label, less what they are moved by, in units: along the best of a few vectors.
  [[nodiscard]] double gap_of(const Near& one, const Near& other) const {
    const double unit = std::min(vertices_.unit(simplices_[one.at]), vertices_.unit(simplices_[other.at]));
    double result = -infinite;
    const auto look_along = [&](const Place& normal) {
      if (result < most_) result = std::max(result, (gap_along(normal, one, other) / Interval::exactly(unit)).lower());
    };
    Place normal{};
    for (std::size_t axis = 0; axis < n_; ++axis) normal[axis] = other.middle[axis] - one.middle[axis];
    look_along(normal);
    for (const Near* here : {&one, &other}) {
      for (const Place& outward : here->outward) look_along(outward);
    }
    for (const Near* here : {&one, &other}) {
      const EnclosedChart<Interval>& chart = vertices_.charts[simplices_[here->at][0]].enclosed();
      for (std::size_t column = m; column < n_; ++column) {
        for (std::size_t axis = 0; axis < n_; ++axis) normal[axis] = middle_of(chart.at(axis, column));
        look_along(normal);
      }
    }
    return result;
  }

  /// How far the two are apart along a vector, less what they are moved by along it.
  [[nodiscard]] Interval gap_along(const Place& normal, const Near& one, const Near& other) const {
    const auto [low, high] = extent_along(normal, one);
    const auto [other_low, other_high] = extent_along(normal, other);
    Interval squared(0);
    for (std::size_t axis = 0; axis < n_; ++axis) squared += square(Interval::exactly(normal[axis]));
    const Interval moved = movement_along(normal, one) + movement_along(normal, other);
    return (maximum(other_low - high, low - other_high) - moved) / square_root(squared);
  }
  [[nodiscard]] std::pair<Interval, Interval> extent_along(const Place& normal, const Near& one) const {
    std::array<Interval, static_cast<std::size_t>(m) + 1> heights;
    for (std::size_t v = 0; v <= m; ++v) {
      const Interval* place = vertices_.position(simplices_[one.at][v]);
      for (std::size_t axis = 0; axis < n_; ++axis) heights[v] += Interval::exactly(normal[axis]) * place[axis];
    }
    std::pair<Interval, Interval> result{heights[0], heights[0]};
    for (const Interval& height : heights) {
      result.first = minimum(result.first, height);
      result.second = maximum(result.second, height);
    }
    return result;
  }
  [[nodiscard]] Interval movement_along(const Place& normal, const Near& one) const {
    Interval result(0);
    for (const std::uint32_t v : simplices_[one.at]) {
      Interval squared(0);
      for (std::size_t column = 0; column < q_; ++column) {
        Interval sum(0);
        for (std::size_t axis = 0; axis < n_; ++axis)
          sum += Interval::exactly(normal[axis]) * fibres_[rank_[v] + axis * q_ + column];
        squared += square(sum);
      }
      result = maximum(result, square_root(squared));
    }
    return result * Interval::exactly(measures_[one.at].shift);
  }

  const GraphVertices& vertices_;
  const std::vector<LabelSimplex<m>>& simplices_;
  const std::vector<GraphSimplex<m>>& measures_;
  std::size_t n_, q_;
  double most_;
  std::vector<double> rooms_;        // 5i.star of each label, in units
  std::vector<std::uint32_t> rank_;  // where W of a label begins
  std::vector<Interval> fibres_;     // N×q for each of these labels
  std::vector<Near> near_;
  std::optional<AmbientGrid> grid_;  // their barycentres
};

}  // namespace

template <int m>
SimplexPairs check_simplex_pairs(const GraphVertices& vertices, const std::vector<LabelSimplex<m>>& simplices,
                                 const std::vector<GraphSimplex<m>>& measures, const std::vector<bool>& is_tight,
                                 double displacement, double most, const Progress& progress) {
  std::optional<PairSearch<m>> search;
  {
    const RoundingGuard guard;
    search.emplace(vertices, simplices, measures, is_tight, displacement, most);
  }
  SimplexPairs result;
  result.margin = most;
  in_parts<simplices_at_a_time_in_pairs>(
      "pairs of simplices", search->size(), progress,
      [&](std::size_t first, std::size_t last) {
        const RoundingGuard guard;
        SimplexPairs part;
        part.margin = most;
        for (std::size_t number = first; number < last; ++number) search->add_pairs_of(number, is_tight, part);
        return part;
      },
      [&](const SimplexPairs& part) {
        if (part.margin < result.margin) {
          result.margin = part.margin;
          result.tightest = part.tightest;
        }
        result.crowded.insert(result.crowded.end(), part.crowded.begin(), part.crowded.end());
      });
  std::sort(result.crowded.begin(), result.crowded.end());
  result.crowded.erase(std::unique(result.crowded.begin(), result.crowded.end()), result.crowded.end());
  return result;
}

#define DELCERT_INSTANTIATE(m)                                                                                        \
  template SimplexPairs check_simplex_pairs<m>(const GraphVertices&, const std::vector<LabelSimplex<m>>&,             \
                                               const std::vector<GraphSimplex<m>>&, const std::vector<bool>&, double, \
                                               double, const Progress&);
DELCERT_INSTANTIATE(1)
DELCERT_INSTANTIATE(2)
DELCERT_INSTANTIATE(3)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
