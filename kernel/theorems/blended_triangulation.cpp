#include "kernel/theorems/blended_triangulation.hpp"

#include <algorithm>

#include "kernel/manifold/gluing/interval_matrix.hpp"
#include "kernel/number/rounding_guard.hpp"
#include "kernel/topology/components.hpp"

namespace delcert {

namespace {

constexpr long digits_of_blends = 12;

/// A number of few digits above x, and not below the other one, with room for readers whose enclosures are wider.
Rational with_room_for_readers(double x, const Rational& least) {
  if (Rational::exactly(x) < least) return least;
  const Rational wider = Rational::exactly(x) * (Rational(17) / Rational(16));
  return rounded_up(wider, binary_exponent(wider) - digits_of_blends + 1);
}

/// A seam, as the chart of its last home sees it.
struct Seam {
  std::size_t at;  // of the simplices
  Label chart;
  double displacement;
};

/// Rule 5.clear.
template <int m>
class ClearOfSeams {
 public:
  ClearOfSeams(const FormulaAtlas<m>& atlas, const GluedPlaces<m>& places,
               const std::vector<LabelSimplex<m>>& simplices, const std::vector<Seam>& seams)
      : atlas_(atlas), places_(places), simplices_(simplices), seams_(seams), is_pure_(places.labels(), true) {
    for (const LabelSimplex<m>& simplex : simplices) {
      for (const std::uint32_t v : simplex) {
        for (const std::uint32_t w : simplex) is_pure_[v] = is_pure_[v] && places.home(v) == places.home(w);
      }
    }
  }

  /// Whether no simplex without k may come to its point, and those with it are straight in one chart.
  [[nodiscard]] bool is_clear(std::uint32_t k) const {
    return is_pure_[k] && std::all_of(seams_.begin(), seams_.end(), [&](const Seam& seam) { return is_far(k, seam); });
  }

 private:
  /// In the last home chart of the seam, which shows all of it: all is within the greatest edge at its first vertex,
  /// and what it was moved by, of this vertex; k is farther, or not shown.
  [[nodiscard]] bool is_far(std::uint32_t k, const Seam& seam) const {
    const std::size_t home = places_.home(seam.chart.value);
    if (!places_.place(home, k)) return true;
    const LabelSimplex<m>& simplex = simplices_[seam.at];
    const auto offset = [&](std::uint32_t v) {
      return applied(atlas_.enclosed(seam.chart).matrix,
                     difference(*places_.place(home, v), *places_.place(home, simplex[0])));
    };
    double longest = 0;
    for (const std::uint32_t v : simplex) longest = std::max(longest, length_above(offset(v)));
    const Vector<Interval, m> there = offset(k);
    return square_root(pairing(there, there)).lower() >
           (Interval::exactly(longest) + Interval::exactly(seam.displacement)).upper();
  }

  const FormulaAtlas<m>& atlas_;
  const GluedPlaces<m>& places_;
  const std::vector<LabelSimplex<m>>& simplices_;
  const std::vector<Seam>& seams_;
  std::vector<bool> is_pure_;
};

}  // namespace

template <int m>
BlendedTriangulation<m> check_blended_triangulation(const FormulaAtlas<m>& atlas, const PointSet<m>& points,
                                                    const std::vector<LabelSimplex<m>>& simplices) {
  const GluedPlaces<m> places(atlas, points);
  BlendedTriangulation<m> result;
  std::vector<Seam> seams;
  double displacement = 0;
  double contraction = 0;
  const std::vector<std::uint32_t> component = component_of_labels(places.labels(), simplices);
  std::vector<bool> is_settled(places.labels());
  {
    const RoundingGuard guard;
    BlendedSimplexCheck<m> check(atlas, places);
    for (std::size_t at = 0; at < simplices.size(); ++at) {
      const BlendedSimplex found = check.measure(simplices[at]);
      if (!found.is_seam) continue;
      ++result.seams;
      if (found.cause) {
        result.failures.push_back({simplices[at], *found.cause});
        continue;
      }
      displacement = std::max(displacement, found.displacement);
      contraction = std::max(contraction, found.contraction);
      seams.push_back(
          {at, Label(check.representative(simplices[at], check.homes_of(simplices[at]).back())), found.displacement});
    }
    if (result.failures.empty()) {
      const ClearOfSeams<m> labels(atlas, places, simplices, seams);
      for (std::uint32_t k = 0; k < places.labels(); ++k) {
        if (!is_settled[component[k]] && labels.is_clear(k)) is_settled[component[k]] = true;
      }
      for (std::uint32_t k = 0; k < places.labels(); ++k) {
        if (component[k] == k && !is_settled[k]) result.unclear.emplace_back(k);
      }
    }
  }
  for (std::size_t chart = 0; chart < places.charts(); ++chart) {
    bool is_seen = false;
    for (std::uint32_t k = 0; k < places.labels() && !is_seen; ++k) is_seen = places.place(chart, k).has_value();
    if (!is_seen) result.unseen.push_back(chart);
  }
  result.displacement = with_room_for_readers(displacement, Rational::power_of_two(-40) * atlas.sampling_radius());
  result.contraction = with_room_for_readers(contraction, Rational::power_of_two(-30));
  for (const Seam& seam : seams) {
    if (!(result.contraction < Rational(1))) {
      result.failures.push_back({simplices[seam.at], BlendCause::fold});
      break;
    }
  }
  return result;
}

#define DELCERT_INSTANTIATE(m)                                                                                \
  template BlendedTriangulation<m> check_blended_triangulation<m>(const FormulaAtlas<m>&, const PointSet<m>&, \
                                                                  const std::vector<LabelSimplex<m>>&);
DELCERT_INSTANTIATE(2)
DELCERT_INSTANTIATE(3)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
