#include "kernel/run/run.hpp"

#include "kernel/simplex/dimensions.hpp"

namespace delcert {

namespace {

template <int m>
StarComplex<m> stars_of(const FlatAtlas<m>& atlas, const PointSet<m>& points, const Progress& progress) {
  progress("triangulate", 0, 1);
  std::vector<bool> interior;
  for (std::uint32_t index = 0; index < atlas.size(); ++index) interior.push_back(atlas.is_interior(Label(index)));
  auto simplices =
      propose_delaunay<m>(atlas.space(), points.approximate_all(), approximate_double(atlas.sampling_radius()));
  progress("triangulate", 1, 1);
  return StarComplex<m>(std::move(simplices), interior);
}

}  // namespace

template <int m>
RunResult<m> run_algorithm(const FlatAtlas<m>& atlas, const PerturbationParameters& parameters,
                           const RunRequest& request, const Progress& progress) {
  Perturbation<m> perturbation(atlas, parameters);
  if (request.perturb) perturbation.place_all(progress);
  std::size_t repaired = 0;
  for (int round = 0;; ++round) {
    StarComplex<m> complex = stars_of(atlas, perturbation.points(), progress);
    ProtectionReport protection =
        certify_protection(atlas, perturbation.points(), complex, request.required_protection, progress);
    std::vector<StarFailure> combinatorial = complex.combinatorial_failures();
    const bool certified = protection.margins && combinatorial.empty();
    if (certified || !request.perturb || round == request.most_repair_rounds) {
      return {perturbation.take_points(),
              std::move(complex),
              std::move(protection),
              std::move(combinatorial),
              perturbation.statistics(),
              round,
              repaired};
    }
    std::vector<StarFailure> failures = protection.failures;
    failures.insert(failures.end(), combinatorial.begin(), combinatorial.end());
    const std::vector<Label> labels = labels_concerned_by(failures);
    repaired += labels.size();
    perturbation.place_anew(labels, progress);
  }
}

#define DELCERT_INSTANTIATE(m)                                                                                  \
  template RunResult<m> run_algorithm<m>(const FlatAtlas<m>&, const PerturbationParameters&, const RunRequest&, \
                                         const Progress&);
DELCERT_FOR_EACH_DIMENSION(DELCERT_INSTANTIATE)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
