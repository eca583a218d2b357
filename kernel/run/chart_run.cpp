#include "kernel/run/chart_run.hpp"

#include <algorithm>
#include <stdexcept>

#include "kernel/chart/length_units.hpp"
#include "kernel/parallel/parts.hpp"
#include "kernel/simplex/dimensions.hpp"

namespace delcert {

namespace {

/// The stars of all labels, kept up to date while points move.
template <int m>
class Stars {
 public:
  Stars(const Atlas<m>& atlas, const ModelGeometry& geometry, double required_protection)
      : atlas_(atlas),
        geometry_(geometry),
        units_(atlas),
        required_protection_(required_protection),
        stars_(atlas.size()),
        outdated_(atlas.size(), true) {
    for (std::uint32_t index = 0; index < atlas.size(); ++index) interior_.push_back(atlas.is_interior(Label(index)));
  }

  /// Computes what is out of date.
  void update(const PointSet<m>& points, const Progress& progress) {
    std::vector<Label> labels;
    for (std::uint32_t index = 0; index < stars_.size(); ++index) {
      if (outdated_[index]) labels.emplace_back(index);
    }
    outdated_.assign(stars_.size(), false);
    const ChartView<m> empty_view(atlas_, points, geometry_);
    const auto certify = [&](std::size_t first, std::size_t last) {
      ChartView<m> view = empty_view;
      double reach = 0;
      for (std::size_t at = first; at < last; ++at) {
        CertifiedStar<m>& star = stars_[labels[at].value];
        star.star.label = labels[at];
        if (interior_[labels[at].value])
          star = chart_star<m>(view, labels[at], required_protection_ * units_.of(labels[at]));
        reach = std::max(reach, star.reach);
      }
      return reach;
    };
    in_parts("certify stars", labels.size(), progress, certify,
             [&](double reach) { farthest_reach_ = std::max(farthest_reach_, reach); });
  }

  /// The stars in whose charts one of these labels had a say.
  void outdate(const std::vector<Label>& moved) {
    std::vector<Sighting<m>> seen;
    std::vector<bool> has_moved(stars_.size());
    for (const Label label : moved) has_moved[label.value] = true;
    for (const Label label : moved) {
      // The distance of original points is the same from both sides, but for the distortion; a little more for its
      // rounding.
      const double stretch = 1 + approximate_double(geometry_.distortion);
      atlas_.sightings(label, farthest_reach_ * stretch * (1 + 0x1p-20), seen);
      for (const auto& sighting : seen) outdated_[sighting.index] = true;
      outdated_[label.value] = true;
    }
    if (!units_.vary()) return;
    // Of those that may see a moved point from far away most look less far.
    for (std::uint32_t index = 0; index < outdated_.size(); ++index) {
      if (!outdated_[index] || has_moved[index]) continue;
      atlas_.sightings(Label(index), stars_[index].reach * (1 + 0x1p-20), seen);
      outdated_[index] =
          std::any_of(seen.begin(), seen.end(), [&](const auto& other) { return has_moved[other.index]; });
    }
  }

  [[nodiscard]] ChartComplex<m> complex() const {
    std::vector<ChartStar<m>> stars;
    stars.reserve(stars_.size());
    for (const auto& star : stars_) stars.push_back(star.star);
    return ChartComplex<m>(std::move(stars), interior_);
  }
  [[nodiscard]] std::vector<StarFailure> failures() const {
    std::vector<StarFailure> result;
    for (const auto& star : stars_) result.insert(result.end(), star.failures.begin(), star.failures.end());
    return result;
  }
  [[nodiscard]] LocalMargins margins() const {
    LocalMargins result;
    bool is_first = true;
    for (std::size_t index = 0; index < stars_.size(); ++index) {
      if (!interior_[index] || !stars_[index].failures.empty()) continue;
      const LocalMargins here = stars_[index].margins.as_multiples(units_, Label(index));
      if (is_first) result = here;
      result.include(here);
      is_first = false;
    }
    return result;
  }

 private:
  const Atlas<m>& atlas_;
  ModelGeometry geometry_;
  LengthUnits units_;
  double required_protection_;
  std::vector<CertifiedStar<m>> stars_;
  std::vector<bool> interior_;
  std::vector<bool> outdated_;
  double farthest_reach_ = 0;
};

std::size_t star_count(const std::vector<StarFailure>& failures) {
  std::size_t result = 0;
  for (std::size_t at = 0; at < failures.size(); ++at) {
    if (at == 0 || failures[at].label != failures[at - 1].label) ++result;
  }
  return result;
}

}  // namespace

template <int m>
ChartRun<m> run_in_charts(const Atlas<m>& atlas, const ModelGeometry& geometry,
                          const PerturbationParameters& parameters, const RunRequest& request,
                          const Progress& progress) {
  Perturbation<m> perturbation(atlas, parameters);
  if (request.perturb) perturbation.place_all(progress);
  const double required = request.required_protection ? approximate_double(*request.required_protection) : 0;
  Stars<m> stars(atlas, geometry, required);
  StarAgreement first_agreement;
  std::size_t first_failures = 0;
  std::size_t repaired = 0;
  for (int round = 0;; ++round) {
    stars.update(perturbation.points(), progress);
    ChartComplex<m> complex = stars.complex();
    auto failures = stars.failures();
    StarAgreement agreement = complex.agreement();
    if (round == 0) {
      first_agreement = agreement;
      first_failures = star_count(failures);
    }
    ModelReport model;
    std::vector<StarFailure> all = failures;
    all.insert(all.end(), agreement.failures.begin(), agreement.failures.end());
    if (all.empty() && request.certify_model) {
      model = check_model_delaunay<m>(atlas, perturbation.points(), geometry, complex, progress);
      all = model.failures;
    }
    const auto labels = labels_concerned_by(all);
    if (labels.empty() || !request.perturb || round == request.most_repair_rounds) {
      return {perturbation.points(),
              std::move(complex),
              stars.margins(),
              std::move(agreement),
              std::move(model),
              std::move(failures),
              first_agreement,
              first_failures,
              perturbation.statistics(),
              round,
              repaired};
    }
    repaired += labels.size();
    perturbation.place_anew(labels, progress);
    stars.outdate(labels);
  }
}

template <int m>
ModelGeometry geometry_of(const SpaceFormAtlas<m>& atlas) {
  const Rational factor = atlas.patch_radius() / atlas.sampling_radius();
  return {atlas.curvature(), atlas.form().injectivity_radius.lower, floor_of(factor).template convert_to<int>(),
          atlas.curvature() == Curvature::zero};
}
template ModelGeometry geometry_of<2>(const SpaceFormAtlas<2>&);
template ModelGeometry geometry_of<3>(const SpaceFormAtlas<3>&);

PerturbationParameters measured_parameters(Dimension dimension, std::uint64_t seed) {
  if (dimension.value < 1 || dimension.value > 3)
    throw std::invalid_argument("parameters for runs in charts exist in dimensions 1 to 3");
  const bool is_surface = dimension.value <= 2;
  PerturbationParameters result;
  result.separation = Rational(1);
  result.perturbation = Rational(Integer(1), Integer(4));
  result.tolerance = is_surface ? Rational(Integer(1), Integer(50)) : Rational(Integer(1), Integer(5000));
  result.edge_bound = Rational(Integer(5), Integer(2));
  result.circumradius_bound = Rational(2);
  result.clearance = is_surface ? Rational(Integer(1), Integer(20)) : Rational(Integer(1), Integer(50));
  result.choices = is_surface ? 20 : 100;
  result.seed = seed;
  return result;
}

#define DELCERT_INSTANTIATE(m)                                                                                \
  template ChartRun<m> run_in_charts<m>(const Atlas<m>&, const ModelGeometry&, const PerturbationParameters&, \
                                        const RunRequest&, const Progress&);
DELCERT_FOR_EACH_DIMENSION(DELCERT_INSTANTIATE)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
