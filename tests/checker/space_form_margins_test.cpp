// A run from the net to the certificate, verified by the checker; and the same with margins that are a little better
// than what holds.

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "kernel/manifold/space_form_file.hpp"
#include "kernel/sample/space_form_net.hpp"
#include "proofs/certificate/space_form_claims.hpp"
#include "proofs/certificate/space_form_writer.hpp"
#include "tests/checker/support/run_checker.hpp"
#include "tests/support/temporary_folder.hpp"

namespace delcert::checker_tests {
namespace {

struct Certified {
  SpaceFormAtlas<2> atlas;
  RunParameters parameters;
  ChartRun<2> run;
  SpaceFormClaims claims;

  [[nodiscard]] CheckerRun check(const SpaceFormClaims& some) const {
    std::vector<Vector<Rational, 2>> centres;
    std::vector<Vector<Rational, 2>> vectors;
    for (std::uint32_t index = 0; index < atlas.size(); ++index) {
      centres.push_back(atlas.centre(Label(index)));
      vectors.push_back(run.points.exact(Label(index)));
    }
    const test::TemporaryFolder folder;
    write_space_form_certificate<2>(folder / "run.json", {atlas.form(), parameters, atlas.sampling_radius(), centres,
                                                          vectors, placed_complex<2>(atlas, run.complex), some});
    std::ifstream file(folder / "run.json", std::ios::binary);
    return run_checker(std::string(std::istreambuf_iterator<char>(file), {}));
  }
};

Certified certified(const std::string& name, const Rational& radius) {
  const auto form = verify_space_form(find_space_form(name));
  auto net = space_form_net<2>(form, radius * (Rational(1) + Rational::power_of_two(-20)), 1, no_progress());
  SpaceFormAtlas<2> atlas(form, std::move(net.centres), radius);
  const auto parameters = space_form_parameters(measured_parameters(Dimension(2), 1), Dimension(2), true);
  auto run = run_in_charts<2>(atlas, parameters.algorithm, {}, no_progress());
  std::vector<std::string> reasons;
  auto claims =
      derive_claims<2>(atlas, parameters, run, measure_run<2>(atlas, run, no_progress()), all_levels(), reasons);
  return {std::move(atlas), parameters, std::move(run), std::move(claims)};
}

class SpaceFormMargins : public testing::TestWithParam<std::string> {};

TEST_P(SpaceFormMargins, hold_and_little_more_does_not) {
  const auto sample = certified(GetParam(), Rational(1) / Rational(8));
  ASSERT_TRUE(sample.claims.stars && sample.claims.delaunay && sample.claims.metric);
  const CheckerRun verified = sample.check(sample.claims);
  ASSERT_EQ(verified.status, 0) << verified.message;
  const Rational more = Rational(1001) / Rational(1000);
  const auto expect = [&](const std::string& rule, const auto& change) {
    SpaceFormClaims claims = sample.claims;
    change(claims);
    const CheckerRun run = sample.check(claims);
    EXPECT_EQ(run.status, 1) << rule;
    EXPECT_EQ(run.rules, std::set<std::string>{rule}) << run.message;
  };
  expect("1.protection", [&](SpaceFormClaims& claims) { claims.stars->protection *= more; });
  expect("1.thickness", [&](SpaceFormClaims& claims) { claims.stars->thickness *= more; });
  expect("1.radius", [&](SpaceFormClaims& claims) { claims.stars->circumradius /= more; });
  expect("4.empty", [&](SpaceFormClaims& claims) { claims.delaunay->protection *= more; });
  expect("6.self-delaunay", [&](SpaceFormClaims& claims) { claims.metric->weight = Rational(1); });
  expect("0.density", [&](SpaceFormClaims& claims) { *claims.density /= more; });
}

INSTANTIATE_TEST_SUITE_P(Runs, SpaceFormMargins, testing::Values("projective-plane", "bolza-surface"));

}  // namespace
}  // namespace delcert::checker_tests
