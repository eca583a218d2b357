#pragma once

#include <memory>

#include "kernel/manifold/gluing/atlas_distortion.hpp"
#include "kernel/run/chart_run.hpp"
#include "kernel/sample/atlas_net.hpp"
#include "kernel/sample/separation.hpp"
#include "tests/kernel/manifold/gluing/atlas_samples.hpp"

namespace delcert::test {

template <int m>
struct GluedRun {
  FormulaAtlas<m> atlas;
  ChartRun<m> run;
};

/// A certified run on a built-in atlas.
template <int m>
GluedRun<m> glued_run(const std::string& name, const Rational& radius) {
  const auto gluing = std::make_shared<const ChartGluing>(atlas_named(name));
  FormulaAtlas<m> atlas(gluing, atlas_net<m>(*gluing, radius, 1, no_progress()).places, radius);
  const ModelGeometry geometry = geometry_of<m>(atlas, fit_patches<m>(atlas, no_progress()));
  PerturbationParameters parameters = measured_parameters(Dimension(m), 1);
  parameters.separation = measure_separation<m>(atlas);
  parameters.perturbation = parameters.separation / Rational(4);
  RunRequest request;
  request.certify_model = false;
  auto run = run_in_charts<m>(atlas, geometry, parameters, request, no_progress());
  return {std::move(atlas), std::move(run)};
}

/// Some 2000 points on the sphere, made once.
inline const GluedRun<2>& fine_sphere() {
  static const auto run = glued_run<2>("sphere-2-stereographic", ratio(1, 20));
  return run;
}

}  // namespace delcert::test
