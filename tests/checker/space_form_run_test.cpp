// Runs on space forms, from the net to the certificate, and the checker's word on them.

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "kernel/manifold/space_form_file.hpp"
#include "kernel/sample/space_form_net.hpp"
#include "proofs/certificate/space_form_claims.hpp"
#include "tests/checker/support/certificate_text.hpp"
#include "tests/checker/support/run_checker.hpp"

namespace delcert::checker_tests {
namespace {

struct Certified {
  std::string path;
  SpaceFormClaims claims;
  std::vector<std::string> reasons;
};

template <int m>
Certified certified(const std::string& name, const Rational& radius, int factor = 9) {
  const SpaceForm form = verify_space_form(find_space_form(name));
  auto net = space_form_net<m>(form, radius, 1, no_progress());
  const SpaceFormAtlas<m> atlas(form, std::move(net.centres), radius, factor);
  PerturbationParameters parameters = measured_parameters(Dimension(m), 1);
  parameters.choices = 20;
  const ChartRun<m> run = run_in_charts<m>(atlas, parameters, {}, no_progress());
  EXPECT_TRUE(run.is_certified()) << name;
  Certified result;
  result.claims = derive_claims<m>(atlas, space_form_parameters(parameters, Dimension(m), true), run,
                                   measure_run<m>(atlas, run, no_progress()), all_levels(), result.reasons);
  std::vector<Vector<Rational, m>> centres, vectors;
  for (std::uint32_t index = 0; index < atlas.size(); ++index) {
    centres.push_back(atlas.centre(Label(index)));
    vectors.push_back(run.points.exact(Label(index)));
  }
  result.path = temporary_file("");
  write_space_form_certificate<m>(
      result.path, {form, space_form_parameters(parameters, Dimension(m), true), radius, centres, vectors,
                    placed_complex<m>(atlas, run.complex), result.claims});
  return result;
}

void expect_verified(const Certified& run, const std::string& levels) {
  const CheckerRun check = run_checker_with(run.path);
  std::string reasons;
  for (const std::string& reason : run.reasons) reasons += reason + "\n";
  EXPECT_EQ(check.status, 0) << check.output << reasons;
  EXPECT_NE(check.output.find("verified: levels group " + levels + " ("), std::string::npos) << check.output << reasons;
  std::printf("%s%s", reasons.c_str(), check.output.c_str());
}

Rational ratio(int p, int q) { return Rational(p) / Rational(q); }

TEST(SpaceFormRuns, of_a_sphere_are_verified) {
  expect_verified(certified<2>("sphere-2", ratio(1, 8)), "0 1 2 2s 4 5 6");
}
TEST(SpaceFormRuns, of_a_projective_plane_are_verified) {
  expect_verified(certified<2>("projective-plane", ratio(1, 8)), "0 1 2 2s 4 5 6");
}
TEST(SpaceFormRuns, of_a_klein_bottle_are_verified) {
  expect_verified(certified<2>("klein-bottle", ratio(1, 24)), "0 1 2 2s 4 5 6");
}
TEST(SpaceFormRuns, of_a_bolza_surface_are_verified) {
  expect_verified(certified<2>("bolza-surface", ratio(1, 8)), "0 1 2 2s 4 5 6");
}
TEST(SpaceFormRuns, of_a_coarse_three_sphere_are_verified) {
  const Certified run = certified<3>("sphere-3", ratio(1, 4), 5);
  const CheckerRun check = run_checker_with(run.path);
  EXPECT_EQ(check.status, 0) << check.output;
  for (const char* level : {"level 1 ", "level 2 ", "level 4 ", "level 5 "})
    EXPECT_NE(check.output.find(level), std::string::npos) << check.output;
  std::printf("%s", check.output.c_str());
}

}  // namespace
}  // namespace delcert::checker_tests
