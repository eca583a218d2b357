#include "properties/instances/run_object.hpp"

#include <nlohmann/json.hpp>

#include "kernel/manifold/any_manifold.hpp"
#include "kernel/manifold/flat_space.hpp"
#include "kernel/manifold/input_check.hpp"
#include "kernel/number/exact_text.hpp"
#include "kernel/perturb/forbidden_search.hpp"
#include "kernel/sample/lattice_net.hpp"
#include "kernel/sample/net_measure.hpp"
#include "kernel/sample/poisson_disk.hpp"
#include "kernel/sample/separation.hpp"
#include "proofs/certificate/flat_claims.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

template <int m>
std::vector<Vector<Rational, m>> net_points(const FlatSpace<m>& space, const RunRecipe& recipe) {
  if (recipe.divisions == 0) return poisson_disk_net<m>(space, recipe.radius, recipe.net_seed, no_progress());
  LatticeNet lattice;
  lattice.divisions = recipe.divisions;
  lattice.centred = recipe.centred;
  return lattice_net<m>(space, lattice);
}

template <int m>
std::vector<Rational> squared_edges_of(const FlatAtlas<m>& atlas, const PointSet<m>& points,
                                       const LiftedSimplex<m>& simplex) {
  const auto metric = atlas.metric().template on<Rational>();
  const auto position = [&](std::size_t at) {
    const Label label(simplex[at].index);
    return atlas.carry(label, simplex[at], points.exact(label)).value();
  };
  std::vector<Rational> result;
  for (std::size_t i = 0; i < simplex.size(); ++i) {
    for (std::size_t j = i + 1; j < simplex.size(); ++j) {
      result.push_back(metric.squared_norm(difference(position(j), position(i))));
    }
  }
  return result;
}

/// Refuted if some simplex was found, exactly, to have another point on or in its sphere.
Verdict stars_verdict(bool certified, const ProtectionReport& report) {
  if (certified) return Verdict::proved;
  for (const StarFailure& failure : report.failures) {
    if (failure.cause == FailureCause::occupied_ball) return Verdict::refuted;
  }
  return Verdict::undecided;
}

}  // namespace

template <int m>
void RunObject::run() {
  const auto space = flat_space_of<m>(find_manifold(recipe_.manifold));
  PointSet<m> net(net_points<m>(space, recipe_));
  const auto nominal = recipe_.divisions == 0 ? std::optional(recipe_.radius) : std::nullopt;
  sampling_radius_ = measure_density<m>(space, net, nominal, no_progress()).sampling_radius;
  const FlatAtlas<m> atlas(space, std::move(net), sampling_radius_);
  separation_ = measure_separation<m>(atlas);
  ParameterChoice choice;
  choice.mode = recipe_.mode;
  choice.perturbation = separation_ * recipe_.perturbation_share / Rational(4);
  choice.seed = recipe_.seed;
  choice.clearance = Rational(0);  // the first good perturbation, as the paper has it
  choice.choices = 1;
  const RunParameters parameters = parameters_for(Dimension(m), separation_, choice);
  perturbation_ = parameters.algorithm.perturbation;
  Verdict input = Verdict::proved;
  for (const InputItem& item : check_input<m>(atlas, separation_, perturbation_)) {
    input = conjunction(input, item.verdict);
  }
  hypotheses_ = conjunction(input, verdict_of(recipe_.mode == RunMode::theory));
  RunRequest request;
  request.perturb = recipe_.mode != RunMode::none;
  const RunResult<m> result = run_algorithm<m>(atlas, parameters.algorithm, request, no_progress());
  stars_ = stars_verdict(result.is_certified(), result.protection);

  const auto search = search_forbidden<m>(atlas, result.points, parameters.forbidden(sampling_radius_),
                                          perturbation_ * sampling_radius_, no_progress());
  no_forbidden_ = verdict_of(!search.found.has_value());
  if (result.is_certified() && is_proved(input)) {
    std::vector<std::string> reasons;
    claims_ = derive_claims<m>(atlas, parameters, result, {"0", "1", "2", "2s", "4", "5", "6"}, no_progress(), reasons);
  }
  const FlatAtlas<m> perturbed(space, result.points, sampling_radius_);
  const Rational ratio = measure_separation<m>(perturbed);
  distance_lower_ = ratio * sampling_radius_;
  distance_upper_ = (ratio + Rational::power_of_two(-19)) * sampling_radius_;
  const auto density = measure_density<m>(space, result.points, std::nullopt, no_progress());
  covering_lower_ = density.covering_radius_lower;
  covering_upper_ = density.sampling_radius;
  for (const auto& simplex : result.complex.simplices()) {
    squared_edges_.push_back(squared_edges_of<m>(atlas, result.points, simplex));
  }
}

RunObject::RunObject(RunRecipe recipe) : recipe_(std::move(recipe)) {
  const auto description = find_manifold(recipe_.manifold);
  dimension_ = description.dimension.value;
  if (description.family != ManifoldFamily::flat_torus) throw InputError("runs of this class are on flat tori");
  if (recipe_.perturbation_share <= Rational(0) || recipe_.perturbation_share > Rational(1)) {
    throw InputError("perturbation_share is not in (0, 1]");
  }
  if ((recipe_.divisions == 0) == (recipe_.radius == Rational(0)) || recipe_.radius < Rational(0)) {
    throw InputError("a run is of a net of some radius or of a lattice of some divisions");
  }
  switch (dimension_) {
    case 2:
      run<2>();
      return;
    case 3:
      run<3>();
      return;
    default:
      throw InputError("runs of this class are in dimensions 2 and 3");
  }
}

nlohmann::ordered_json RunObject::json() const {
  return {{"manifold", recipe_.manifold},
          {"radius", exact_text(recipe_.radius)},
          {"divisions", recipe_.divisions},
          {"centred", recipe_.centred},
          {"net_seed", recipe_.net_seed},
          {"perturbed", recipe_.mode == RunMode::theory},
          {"perturbation_share", exact_text(recipe_.perturbation_share)},
          {"seed", recipe_.seed}};
}

ObjectPointer RunObject::read(const nlohmann::ordered_json& json) {
  try {
    RunRecipe recipe;
    recipe.manifold = json.at("manifold").get<std::string>();
    recipe.radius = parse_exact(json.at("radius").get<std::string>());
    recipe.divisions = json.at("divisions").get<std::uint32_t>();
    recipe.centred = json.at("centred").get<bool>();
    recipe.net_seed = json.at("net_seed").get<std::uint64_t>();
    recipe.mode = json.at("perturbed").get<bool>() ? RunMode::theory : RunMode::none;
    recipe.perturbation_share = parse_exact(json.at("perturbation_share").get<std::string>());
    recipe.seed = json.at("seed").get<std::uint64_t>();
    return std::make_shared<RunObject>(std::move(recipe));
  } catch (const nlohmann::json::exception& error) {
    throw InputError(std::string("a run: ") + error.what());
  } catch (const Rejection& error) {
    throw InputError(std::string("a run: ") + error.what());
  }
}

}  // namespace delcert
