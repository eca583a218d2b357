#include "properties/instances/net_forbidden.hpp"

#include "kernel/number/ladder.hpp"
#include "kernel/perturb/candidates.hpp"
#include "kernel/simplex/forbidden_configuration.hpp"
#include "kernel/simplex/sphere_stack.hpp"

namespace delcert {

namespace {

template <int m>
class ForbiddenSearchInNet {
 public:
  /// Precondition: a `FilterGuard` is alive.
  ForbiddenSearchInNet(const std::vector<Vector<Rational, m>>& points, const NetForbiddenParameters& parameters)
      : points_(points),
        filter_(FrameMetric<m>::cartesian().template on<Filter>()),
        exact_{square(parameters.flake_parameter), square(parameters.sampling_radius), square(parameters.protection)},
        in_filter_(exact_.template on<Filter>()),
        squared_radius_bound_(scalar_from<Filter>(exact_.squared_sampling_radius)),
        squared_protection_(scalar_from<Filter>(exact_.squared_protection)) {
    for (const auto& point : points_) {
      Vector<Filter, m> enclosure;
      for (std::size_t axis = 0; axis < m; ++axis) enclosure[axis] = scalar_from<Filter>(point[axis]);
      position_.push_back(enclosure);
    }
    // Two vertices of the facet are within 2R, the opposite vertex and another within 2R + δ.
    const Rational reach = Rational(2) * parameters.sampling_radius + parameters.protection;
    squared_reach_ = scalar_from<Filter>(square(reach));
    near_.resize(points_.size());
    for (std::uint32_t a = 0; a < points_.size(); ++a) {
      for (std::uint32_t b = a + 1; b < points_.size(); ++b) {
        if (!is_close(a, b)) continue;
        near_[a].push_back(b);
        near_[b].push_back(a);
      }
    }
    // The volumes of a flake τ of dimension j: D(p, τ)·vol(τ_p) = D(a, τ)·vol(τ_a) with D(a, τ) < jΓ₀ʲΔ(τ) for some a,
    // and vol(τ_a) ≤ Δ(τ)^{j−1}/(j−1)!.
    Rational bound(1);
    for (int j = 0; j <= m; ++j) {
      squared_volume_bound_[static_cast<std::size_t>(j)] = scalar_from<Filter>(square(Rational(j)) * bound);
      bound *= exact_.squared_flake_parameter * square(reach);
    }
  }

  std::optional<std::vector<std::uint32_t>> run() {
    SphereStack<Filter, m> stack(filter_);
    for (std::uint32_t first = 0; first < points_.size() && !found_; ++first) {
      chosen_.assign(1, first);
      walk(stack, Filter(1));
    }
    return found_;
  }

 private:
  [[nodiscard]] bool is_close(std::uint32_t a, std::uint32_t b) const {
    return !is_refuted(less(filter_.squared_norm(difference(position_[b], position_[a])), squared_reach_));
  }

  /// All facets that begin with the chosen points. `squared_volume`: the product of their squared altitudes.
  void walk(SphereStack<Filter, m>& stack, const Filter& squared_volume) {
    const std::uint32_t origin = chosen_.front();
    for (const std::uint32_t next : near_[origin]) {
      if (found_) return;
      if (next < chosen_.back()) continue;
      bool close = true;
      for (const std::uint32_t other : chosen_)
        close = close && other != next && (other == origin || is_close(other, next));
      if (!close) continue;
      const auto edge = difference(position_[next], position_[origin]);
      const Verdict ok = stack.push(edge, filter_.squared_norm(edge));
      // Facets of flakes are good, hence not degenerate.
      if (is_refuted(ok)) continue;
      chosen_.push_back(next);
      if (is_undecided(ok)) {
        walk_exactly();
      } else {
        if (!is_refuted(less(stack.squared_radius(), squared_radius_bound_))) {
          const Filter volume = squared_volume * stack.squared_altitude();
          look_around(stack, volume);
          if (stack.dimension() < m) walk(stack, volume);
        }
        stack.pop();
      }
      chosen_.pop_back();
    }
  }

  /// The facets that contain the chosen points, where the filter could not tell whether they are degenerate.
  void walk_exactly() {
    for (const std::uint32_t apex : near_[chosen_.front()]) try_exactly(apex);
    if (chosen_.size() > m || found_) return;
    for (const std::uint32_t next : near_[chosen_.front()]) {
      if (next <= chosen_.back() || found_) continue;
      chosen_.push_back(next);
      walk_exactly();
      chosen_.pop_back();
    }
  }

  void look_around(const SphereStack<Filter, m>& stack, const Filter& squared_volume) {
    const auto j = static_cast<std::size_t>(stack.dimension()) + 1;
    const std::uint32_t origin = chosen_.front();
    for (const std::uint32_t apex : near_[origin]) {
      if (found_) return;
      const auto edge = difference(position_[apex], position_[origin]);
      if (stack.dimension() == m) {
        const Filter power = stack.power(edge, filter_.squared_norm(edge));
        if (is_proved(is_farther(power, stack.squared_radius(), squared_protection_))) continue;
      } else if (is_proved(less(squared_volume_bound_[j], squared_height(edge) * squared_volume))) {
        continue;
      }
      try_exactly(apex);
    }
  }

  /// Of the end of an edge from the first chosen point over the hull of the chosen points: 1 ≤ k ≤ m − 1 ≤ 2.
  [[nodiscard]] Filter squared_height(const Vector<Filter, m>& edge) const {
    Vector<Filter, m> rest = edge;
    std::array<Vector<Filter, m>, static_cast<std::size_t>(m)> orthogonal;
    for (std::size_t k = 1; k < chosen_.size(); ++k) {
      auto& direction = orthogonal[k - 1];
      direction = difference(position_[chosen_[k]], position_[chosen_[0]]);
      for (std::size_t i = 1; i < k; ++i) remove(direction, orthogonal[i - 1]);
      remove(rest, direction);
    }
    return filter_.squared_norm(rest);
  }
  void remove(Vector<Filter, m>& from, const Vector<Filter, m>& direction) const {
    from = difference(from, scaled(pairing(from, direction) / filter_.squared_norm(direction), direction));
  }

  void try_exactly(std::uint32_t apex) {
    for (const std::uint32_t other : chosen_) {
      if (other == apex || found_) return;
    }
    if (is_refuted(forbidden_in_filter(apex))) return;
    std::vector<std::vector<Rational>> coordinates;
    const auto add = [&](std::uint32_t at) { coordinates.emplace_back(points_[at].begin(), points_[at].end()); };
    for (const std::uint32_t at : chosen_) add(at);
    add(apex);
    if (!is_proved(is_forbidden_configuration(edge_gram_from_points(coordinates), m, exact_))) return;
    found_ = chosen_;
    found_->push_back(apex);
  }

  [[nodiscard]] Verdict forbidden_in_filter(std::uint32_t apex) const {
    std::vector<std::vector<Filter>> coordinates;
    for (const std::uint32_t at : chosen_) coordinates.emplace_back(position_[at].begin(), position_[at].end());
    coordinates.emplace_back(position_[apex].begin(), position_[apex].end());
    return is_forbidden_configuration(edge_gram_from_points(coordinates), m, in_filter_);
  }

  const std::vector<Vector<Rational, m>>& points_;
  MetricOn<Filter, m> filter_;
  ForbiddenConfigurationParameters<Rational> exact_;
  ForbiddenConfigurationParameters<Filter> in_filter_;
  Filter squared_radius_bound_;
  Filter squared_protection_;
  Filter squared_reach_;
  std::array<Filter, static_cast<std::size_t>(m) + 1> squared_volume_bound_;
  std::vector<Vector<Filter, m>> position_;
  std::vector<std::vector<std::uint32_t>> near_;
  std::vector<std::uint32_t> chosen_;
  std::optional<std::vector<std::uint32_t>> found_;
};

}  // namespace

template <int m>
std::optional<std::vector<std::uint32_t>> find_forbidden_configuration(const std::vector<Vector<Rational, m>>& points,
                                                                       const NetForbiddenParameters& parameters) {
  const FilterGuard guard;
  return ForbiddenSearchInNet<m>(points, parameters).run();
}

template std::optional<std::vector<std::uint32_t>> find_forbidden_configuration<2>(
    const std::vector<Vector<Rational, 2>>&, const NetForbiddenParameters&);
template std::optional<std::vector<std::uint32_t>> find_forbidden_configuration<3>(
    const std::vector<Vector<Rational, 3>>&, const NetForbiddenParameters&);

}  // namespace delcert
