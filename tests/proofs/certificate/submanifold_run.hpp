#pragma once

#include "kernel/sample/separation.hpp"
#include "kernel/sample/submanifold_net.hpp"
#include "proofs/certificate/content.hpp"
#include "proofs/certificate/submanifold_claims.hpp"
#include "tests/support/ratio.hpp"

namespace delcert::test {

inline SubmanifoldDescription unit_sphere() {
  SubmanifoldDescription result;
  result.name = "unit-sphere";
  result.dimension = Dimension(2);
  result.variables = {"x", "y", "z"};
  result.equations = {"x^2 + y^2 + z^2 - 1"};
  result.box = {{Rational(-2), Rational(2)}, {Rational(-2), Rational(2)}, {Rational(-2), Rational(2)}};
  return result;
}

/// A certified run on a submanifold, with everything that goes into its certificate.
template <int m>
struct SubmanifoldSample {
  SubmanifoldAtlas<m> atlas;
  RunParameters parameters;
  ChartRun<m> run;
  SubmanifoldMeasures<m> measures;

  [[nodiscard]] Claims claims(std::vector<std::string>& reasons, const LevelSelection& levels = all_levels()) const {
    return derive_claims<m>(atlas, parameters, run, measures, levels, reasons);
  }
  [[nodiscard]] SubmanifoldMeasures<m> measured(const LevelSelection& levels) const {
    return measure_submanifold<m>(atlas, run, geometry_of<m>(atlas), levels, no_progress());
  }
  void write(const std::filesystem::path& path, const Claims& some) const {
    write_certificate<m>(path, content_of<m>(atlas, parameters, run, some));
  }
};

template <int m>
SubmanifoldSample<m> certified_run(const SubmanifoldDescription& description, const Rational& radius) {
  const ZeroSet zero_set(description);
  auto net = submanifold_net<m>(zero_set, radius, 1, no_progress());
  SubmanifoldAtlas<m> atlas(zero_set, std::move(net.charts), radius, no_progress());
  ParameterChoice choice;
  choice.mode = RunMode::measured;
  const auto usual = measured_parameters(Dimension(m), 1);
  choice.tolerance = usual.tolerance;
  auto parameters = parameters_for(Dimension(m), measure_separation<m>(atlas), choice);
  parameters.algorithm.clearance = usual.clearance;
  parameters.algorithm.choices = usual.choices;
  RunRequest request;
  request.certify_model = false;
  const auto geometry = geometry_of<m>(atlas);
  auto run = run_in_charts<m>(atlas, geometry, parameters.algorithm, request, no_progress());
  auto measures = measure_submanifold<m>(atlas, run, geometry, all_levels(), no_progress());
  return {std::move(atlas), parameters, std::move(run), std::move(measures)};
}

/// Some 1 000 points on the unit sphere, made once.
[[nodiscard]] inline const SubmanifoldSample<2>& sphere_run() {
  static const auto run = certified_run<2>(unit_sphere(), ratio(1, 8));
  return run;
}

}  // namespace delcert::test
