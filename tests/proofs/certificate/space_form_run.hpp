#pragma once

#include <filesystem>

#include "kernel/manifold/space_form_file.hpp"
#include "kernel/sample/space_form_net.hpp"
#include "proofs/certificate/content.hpp"
#include "proofs/certificate/space_form_claims.hpp"

namespace delcert::test {

/// As certificates state them; nothing is claimed of Γ₀.
[[nodiscard]] inline RunParameters stated_parameters(const PerturbationParameters& parameters, Dimension dimension) {
  RunParameters result;
  result.mode = RunMode::measured;
  result.algorithm = parameters;
  result.squared_flake_parameter = square(parameters.tolerance) * power(parameters.separation, 6) *
                                   Rational::power_of_two(-34) / power(Rational(dimension.value), 3);
  return result;
}

/// A run on a built-in space form, with what goes into its certificate.
template <int m>
struct SpaceFormSample {
  SpaceFormAtlas<m> atlas;
  RunParameters parameters;
  ChartRun<m> run;

  [[nodiscard]] Claims claims(std::vector<std::string>& reasons) const {
    return derive_claims<m>(atlas, parameters, run, measure_run<m>(atlas, run, no_progress()), all_levels(), reasons);
  }
  void write(const std::filesystem::path& path, const Claims& some) const {
    write_certificate<m>(path, content_of<m>(atlas, parameters, run, some));
  }
};

template <int m>
SpaceFormSample<m> space_form_run(const std::string& name, const Rational& radius, int patch_factor = 9,
                                  std::uint32_t choices = 20) {
  const SpaceForm form = verify_space_form(find_space_form(name));
  SpaceFormAtlas<m> atlas(form, space_form_net<m>(form, radius, 1, no_progress()).centres, radius, patch_factor);
  PerturbationParameters parameters = measured_parameters(Dimension(m), 1);
  parameters.choices = choices;
  auto run = run_in_charts<m>(atlas, parameters, {}, no_progress());
  return {std::move(atlas), stated_parameters(parameters, Dimension(m)), std::move(run)};
}

}  // namespace delcert::test
