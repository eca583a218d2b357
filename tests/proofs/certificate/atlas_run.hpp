#pragma once

#include "kernel/manifold/gluing/gluing_check.hpp"
#include "kernel/sample/atlas_net.hpp"
#include "kernel/sample/separation.hpp"
#include "proofs/certificate/atlas_claims.hpp"
#include "proofs/certificate/content.hpp"
#include "tests/kernel/manifold/gluing/atlas_samples.hpp"

namespace delcert::test {

/// A certified run on an atlas by formulas, with everything that goes into its certificate.
template <int m>
struct AtlasSample {
  FormulaAtlas<m> atlas;
  Rational distortion;
  RunParameters parameters;
  ChartRun<m> run;
  AtlasMeasures<m> measures;

  [[nodiscard]] Claims claims(std::vector<std::string>& reasons, const LevelSelection& levels = all_levels()) const {
    return derive_claims<m>(atlas, parameters, run, measures, levels, reasons);
  }
  void write(const std::filesystem::path& path, const Claims& some) const {
    write_certificate<m>(path, content_of<m>(atlas, distortion, parameters, run, some));
  }
};

template <int m>
AtlasSample<m> certified_atlas_run(const FormulaAtlasDescription& description, const Rational& radius) {
  const auto gluing = std::make_shared<const ChartGluing>(description);
  (void)check_gluing(*gluing);
  FormulaAtlas<m> atlas(gluing, atlas_net<m>(*gluing, radius, 1, no_progress()).places, radius);
  const Rational distortion = fit_patches<m>(atlas, no_progress());
  ParameterChoice choice;
  choice.mode = RunMode::measured;
  const auto usual = measured_parameters(Dimension(m), 1);
  choice.tolerance = usual.tolerance;
  const auto parameters = parameters_for(Dimension(m), measure_separation<m>(atlas), choice);
  RunRequest request;
  request.certify_model = false;
  const auto geometry = geometry_of<m>(atlas, distortion);
  auto run = run_in_charts<m>(atlas, geometry, parameters.algorithm, request, no_progress());
  AtlasMeasures<m> measures = measure_atlas<m>(atlas, run, geometry, all_levels(), no_progress());
  return {std::move(atlas), distortion, parameters, std::move(run), std::move(measures)};
}

/// The sphere in two charts, made once.
[[nodiscard]] inline const AtlasSample<2>& glued_sphere_run() {
  static const auto run = certified_atlas_run<2>(atlas_named("sphere-2-stereographic"), ratio(1, 16));
  return run;
}

}  // namespace delcert::test
