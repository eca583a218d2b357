#include "kernel/sample/radius_advice.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <span>
#include <string_view>

#include "kernel/manifold/submanifold/chart_fitting.hpp"
#include "kernel/number/exact_text.hpp"
#include "kernel/number/simple_fraction.hpp"
#include "kernel/sample/manifold_survey.hpp"
#include "kernel/sample/sizing.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

/// Maximal Poisson-disk sets of radius ε have about so many points on a volume of ε^m, for m = 1, 2, 3.
constexpr double points_in_unit = 0.73;

/// Shares of 1/κ that are advised, one after the other. Slopes are the same.
struct Graded {
  std::string_view text;
  double share;
};
constexpr std::array graded{Graded{"curvature:1/10,1/10", 0.1}, Graded{"curvature:1/15,1/15", 1.0 / 15},
                            Graded{"curvature:1/20,1/20", 0.05}};

/// Those of them that come after this one; all, if it is none of them.
std::span<const Graded> after(const std::string& sizing) {
  const auto found = std::find_if(graded.begin(), graded.end(), [&](const Graded& g) { return g.text == sizing; });
  return {found == graded.end() ? graded.begin() : found + 1, graded.end()};
}

class Adviser {
 public:
  Adviser(const EmbeddedManifold& manifold, ManifoldSurvey survey, const std::vector<std::vector<double>>& places)
      : manifold_(manifold), survey_(std::move(survey)) {
    constexpr std::size_t most_curved = 32;
    constexpr std::size_t others = 128;
    constexpr std::size_t most_places = 64;
    const std::vector<ManifoldSurvey::Place>& all = survey_.places;
    for (std::size_t at = 0; at < std::min(most_curved, all.size()); ++at) tried_.push_back(all[at]);
    for (std::size_t at = 0; at < all.size(); at += all.size() / others + 1) tried_.push_back(all[at]);
    const auto sampler = manifold.sampler(survey_.reach);
    for (std::size_t at = 0; at < std::min(most_places, places.size()); ++at) {
      const double curvature = sampler->curvature(places[at]);
      if (std::isfinite(curvature)) tried_.push_back({places[at], curvature});
    }
  }

  /// Less than this. What level 5 asks of charts is more than that they fit, so it is less than where they do.
  [[nodiscard]] std::optional<RadiusAdvice> constant(double below) const {
    constexpr int most_tries = 16;
    constexpr double smaller = 0.875;
    std::vector<ManifoldSurvey::Place> tried = tried_;
    for (const auto& x : survey_.narrow) tried.push_back({x, 0});
    double radius = std::min(below / smaller, survey_.reach / (manifold_.dimension() == 3 ? 9 : 7));
    for (int tries = 0; tries < most_tries; ++tries, radius *= 0.875) {
      if (!fits(tried, Rational::exactly(radius))) continue;
      return RadiusAdvice{simple_fraction_below(Rational::exactly(smaller * radius)), "",
                          count(std::pow(1 / (smaller * radius), m()))};
    }
    return std::nullopt;
  }

  /// The first of these with which charts fit, and a little larger ones too, or the last. Where sheets are near to one
  /// another that is for --refine.
  [[nodiscard]] std::optional<RadiusAdvice> by_curvature(std::span<const Graded> grades) const {
    constexpr double room = 1.125;
    std::optional<RadiusAdvice> result;
    for (const Graded& grade : grades) {
      result = by_curvature(grade);
      const Sizing sizing = sizing_for(grade, approximate_double(result->radius));
      std::vector<double> radii;
      for (const auto& place : tried_) radii.push_back(room * sizing.at(place.x.data()));
      if (fits(tried_, SamplingRadii(radii))) break;
    }
    return result;
  }

 private:
  [[nodiscard]] double m() const { return static_cast<double>(manifold_.dimension()); }
  /// Of points, for this mean of ε^-m.
  [[nodiscard]] double count(double mean) const { return points_in_unit * survey_.volume * mean; }
  [[nodiscard]] double extent() const {
    double result = 0;
    for (std::size_t axis = 0; axis < manifold_.ambient(); ++axis) {
      const auto [least, greatest] =
          std::minmax_element(survey_.places.begin(), survey_.places.end(),
                              [&](const auto& a, const auto& b) { return a.x[axis] < b.x[axis]; });
      result = std::max(result, greatest->x[axis] - least->x[axis]);
    }
    return result;
  }
  [[nodiscard]] RadiusAdvice by_curvature(const Graded& grade) const {
    // As large as suits the flattest parts, and a part of the whole.
    const double flattest = survey_.curvatures[survey_.curvatures.size() / 20];
    const double greatest = std::min(extent() / 8, 2 * grade.share / flattest);
    const Rational simple = greatest < 1 ? Rational(1) / Rational(Integer(std::ceil(1 / greatest)))
                                         : Rational(Integer(std::floor(greatest)));
    double mean = 0;
    for (const double curvature : survey_.curvatures)
      mean += std::pow(1 / std::min(approximate_double(simple), grade.share / curvature), m());
    return {simple, std::string(grade.text), count(mean / static_cast<double>(survey_.curvatures.size()))};
  }
  /// About what "curvature:k,ν" will be.
  [[nodiscard]] Sizing sizing_for(const Graded& grade, double greatest) const {
    constexpr double worth_adding = 0.875;
    Sizing result(manifold_.ambient(), greatest);
    for (const auto& place : survey_.places) {
      const double radius = grade.share / place.curvature;
      if (radius < worth_adding * result.at(place.x.data())) result.add({place.x, radius, grade.share});
    }
    return result;
  }
  /// Charts about these places with these radii.
  [[nodiscard]] bool fits(const std::vector<ManifoldSurvey::Place>& places, const SamplingRadii& radii) const {
    const double step = net_step(approximate_double(radii.greatest()));
    std::vector<std::vector<Rational>> rounded;
    for (const auto& place : places) {
      auto& point = rounded.emplace_back();
      for (const double x : place.x) point.push_back(Rational::exactly(std::nearbyint(x / step) * step));
    }
    try {
      (void)manifold_.fit_charts(rounded, radii, no_progress());
      return true;
    } catch (const Rejection&) {
      return false;
    } catch (const Undecided&) {
      return false;
    }
  }

  const EmbeddedManifold& manifold_;
  ManifoldSurvey survey_;
  std::vector<ManifoldSurvey::Place> tried_;  // where charts are tried
};

}  // namespace

std::string RadiusAdvice::text() const {
  char about[32];
  std::snprintf(about, sizeof about, "%.0f", points);
  // Two digits, the others 0.
  for (char* digit = about; *digit != 0; ++digit) {
    if (digit >= about + 2) *digit = '0';
  }
  return "--radius " + exact_text(radius) + (sizing.empty() ? "" : " --sizing " + sizing) +
         " --refine 8 should do, with some " + about + " points";
}

std::optional<RadiusAdvice> advise_radius(const EmbeddedManifold& manifold, const Rational& radius,
                                          const std::string& sizing, const std::vector<std::vector<double>>& places,
                                          std::uint64_t seed, const Progress& progress) {
  constexpr double many_points = 40000;
  constexpr double most_points = 2000000;
  if (!manifold.is_smooth()) return std::nullopt;
  const double tried = approximate_double(radius);
  ManifoldSurvey survey = survey_manifold(manifold, tried, places, seed, progress);
  if (survey.curvatures.empty() || !(survey.reach > 0)) return std::nullopt;
  const Adviser adviser(manifold, std::move(survey), places);
  std::optional<RadiusAdvice> result;
  if (sizing.empty()) result = adviser.constant(tried * 0.875);
  if (!result || result->points > many_points) {
    auto other = adviser.by_curvature(after(sizing));
    if (other && (!result || 2 * other->points < result->points)) result = std::move(other);
  }
  if (result && !(result->points < most_points)) return std::nullopt;
  return result;
}

}  // namespace delcert
