#include "kernel/run/chart_run.hpp"

#include <algorithm>
#include <stdexcept>

#include "kernel/run/kept_stars.hpp"
#include "kernel/simplex/dimensions.hpp"

namespace delcert {

namespace {

double required_protection(const RunRequest& request) {
  return request.required_protection ? approximate_double(*request.required_protection) : 0;
}

}  // namespace

template <int m>
ChartRun<m> run_in_charts(const Atlas<m>& atlas, const ModelGeometry& geometry,
                          const PerturbationParameters& parameters, const RunRequest& request,
                          const Progress& progress) {
  Perturbation<m> perturbation(atlas, parameters);
  if (request.perturb) perturbation.place_all(progress);
  KeptStars<m> stars(atlas, geometry, required_protection(request), all_labels_of(atlas));
  StarAgreement first_agreement;
  std::size_t first_failures = 0;
  std::size_t repaired = 0;
  for (int round = 0;; ++round) {
    stars.update(perturbation.points(), progress);
    ChartComplex<m> complex = stars.lend_complex();
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
    std::optional<StarStability> stability;
    if (all.empty() && request.repair_stability) {
      stability = check_stability<m>(atlas, perturbation.points(), geometry, complex, progress);
      // Where a chart shows too little, other places of points do not help.
      if (stability->stars == stability->occupied) all = stability->failures;
    }
    const auto labels = labels_concerned_by(all);
    if (labels.empty() || !request.perturb || round == request.most_repair_rounds) {
      return {perturbation.take_points(),
              std::move(complex),
              stars.margins(),
              std::move(agreement),
              std::move(model),
              std::move(failures),
              first_agreement,
              first_failures,
              perturbation.statistics(),
              round,
              repaired,
              std::move(stability)};
    }
    repaired += labels.size();
    stars.take_back(complex.take_stars());
    perturbation.place_anew(labels, progress);
    stars.outdate(labels);
  }
}

template <int m>
ChartRun<m> stars_in_charts(const Atlas<m>& atlas, const ModelGeometry& geometry, PointSet<m> points,
                            const RunRequest& request, const Progress& progress) {
  KeptStars<m> stars(atlas, geometry, required_protection(request), all_labels_of(atlas));
  stars.update(points, progress);
  ChartComplex<m> complex = stars.lend_complex();
  StarAgreement agreement = complex.agreement();
  auto failures = stars.failures();
  const std::size_t failing = star_count(failures);
  return {std::move(points),
          std::move(complex),
          stars.margins(),
          agreement,
          {},
          std::move(failures),
          agreement,
          failing,
          {},
          0,
          0,
          {}};
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

#define DELCERT_INSTANTIATE(m)                                                                                   \
  template ChartRun<m> run_in_charts<m>(const Atlas<m>&, const ModelGeometry&, const PerturbationParameters&,    \
                                        const RunRequest&, const Progress&);                                     \
  template ChartRun<m> stars_in_charts<m>(const Atlas<m>&, const ModelGeometry&, PointSet<m>, const RunRequest&, \
                                          const Progress&);
DELCERT_FOR_EACH_DIMENSION(DELCERT_INSTANTIATE)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
