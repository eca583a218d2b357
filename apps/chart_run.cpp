#include "apps/chart_run.hpp"

#include "support/error.hpp"

namespace delcert {

RunParameters measured_run_parameters(const CertifyOptions& options, Dimension dimension, const Rational& separation) {
  const PerturbationParameters usual = measured_parameters(dimension, options.choice.seed);
  ParameterChoice choice = options.choice;
  choice.mode = options.no_perturbation ? RunMode::none : RunMode::measured;
  if (!options.no_perturbation && !choice.tolerance) choice.tolerance = usual.tolerance;
  RunParameters result = parameters_for(dimension, separation, choice);
  if (!options.choice.clearance) result.algorithm.clearance = usual.clearance;
  if (!options.choice.choices) result.algorithm.choices = usual.choices;
  return result;
}

RunRequest run_request(const CertifyOptions& options, const Rational& sampling_radius) {
  RunRequest request;
  request.perturb = !options.no_perturbation;
  request.most_repair_rounds = options.repair_rounds;
  if (options.required_protection) request.required_protection = *options.required_protection * sampling_radius;
  return request;
}

template <int m>
void require_certified(const ChartRun<m>& run) {
  if (run.is_certified()) return;
  std::vector<StarFailure> failures = run.star_failures;
  failures.insert(failures.end(), run.agreement.failures.begin(), run.agreement.failures.end());
  failures.insert(failures.end(), run.model.failures.begin(), run.model.failures.end());
  throw Rejection(star_failures_text(failures, run.repair_rounds) + disagreement_text(run.agreement.labels));
}

template void require_certified<2>(const ChartRun<2>&);
template void require_certified<3>(const ChartRun<3>&);

}  // namespace delcert
