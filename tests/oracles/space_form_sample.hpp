#pragma once

#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "kernel/manifold/quotient/patch_size.hpp"
#include "kernel/manifold/space_form_file.hpp"
#include "kernel/run/chart_run.hpp"
#include "kernel/sample/space_form_net.hpp"
#include "tests/oracles/label_complex.hpp"

// Runs on space forms for other software to look at.
namespace delcert::test {

template <int m>
struct SpaceFormSample {
  SpaceFormAtlas<m> atlas;
  ChartRun<m> run;
};

/// What the command `certify` computes before it writes, with the seed 1; fewer tries a point in dimension 3. Patches
/// have the factor that fits, or the one given.
template <int m>
SpaceFormSample<m> space_form_sample(const std::string& manifold, const Rational& radius, bool is_perturbed = true,
                                     int patch_factor = 0) {
  constexpr std::uint64_t seed = 1;
  const SpaceForm form = verify_space_form(find_space_form(manifold));
  auto net = space_form_net<m>(form, radius, seed, no_progress());
  const int factor = patch_factor > 0 ? patch_factor : fitting_patch_factor(form, m, radius);
  SpaceFormAtlas<m> atlas(form, std::move(net.centres), radius, factor);
  auto parameters = measured_parameters(Dimension(m), seed);
  if (m == 3) parameters.choices = 5;
  RunRequest request;
  request.perturb = is_perturbed;
  auto run = run_in_charts<m>(atlas, parameters, request, no_progress());
  return {std::move(atlas), std::move(run)};
}

/// A certified run, whose geodesic circumballs are so well protected that points may be moved by 2⁻⁴⁰ε before the
/// complex changes: what a point is moved by moves a ball by at most that over the thickness and the quotient of radius
/// and shortest edge. (What is asked of CGAL are points rounded by less than 2⁻⁴⁸.)
template <int m>
SpaceFormSample<m> certified_sample(const std::string& manifold, const Rational& radius, int patch_factor = 0) {
  auto sample = space_form_sample<m>(manifold, radius, true, patch_factor);
  EXPECT_TRUE(sample.run.is_certified());
  EXPECT_GT(sample.run.model.protection * sample.run.margins.thickness, approximate_double(radius) * 0x1p-25);
  return sample;
}

/// The lift p̂′ that is the label's home, in the linear model: the middle of an enclosure narrower than 2⁻²⁰⁰.
template <int m>
ModelPoint<Rational, m> model_position(const SpaceFormSample<m>& sample, Label label) {
  constexpr unsigned bits = 256;
  const BigInterval::Precision precision(PrecisionBits{bits});
  const auto enclosure = sample.atlas.template lift<BigInterval>(
      Sighting<m>{label.value, {}}, sample.run.points.template coordinates<BigInterval>(label));
  ModelPoint<Rational, m> result;
  for (std::size_t axis = 0; axis <= m; ++axis) {
    const Rational lower = enclosure[axis].lower();
    const Rational upper = enclosure[axis].upper();
    EXPECT_LT(upper - lower, Rational::power_of_two(-200));
    result[axis] = (lower + upper) / Rational(2);
  }
  return result;
}

/// A number of one of CGAL's lazy exact fields.
template <class Lazy>
Lazy cgal_number(const Rational& x) {
  return Lazy(typename Lazy::ET(x.gmp()));
}

}  // namespace delcert::test
