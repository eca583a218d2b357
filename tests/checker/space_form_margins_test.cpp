// A run from the net to the certificate, verified by the checker; and the same with margins that are a little better
// than what holds.

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "tests/checker/support/run_checker.hpp"
#include "tests/proofs/certificate/space_form_run.hpp"
#include "tests/support/temporary_folder.hpp"

namespace delcert::checker_tests {
namespace {

struct Certified {
  test::SpaceFormSample<2> sample;
  delcert::Claims claims;

  [[nodiscard]] CheckerRun check(const delcert::Claims& some) const {
    const test::TemporaryFolder folder;
    sample.write(folder / "run.json", some);
    std::ifstream file(folder / "run.json", std::ios::binary);
    return run_checker(std::string(std::istreambuf_iterator<char>(file), {}));
  }
};

Certified certified(const std::string& name, const Rational& radius) {
  auto sample = test::space_form_run<2>(name, radius);
  std::vector<std::string> reasons;
  delcert::Claims claims = sample.claims(reasons);
  return {std::move(sample), std::move(claims)};
}

class SpaceFormMargins : public testing::TestWithParam<std::string> {};

TEST_P(SpaceFormMargins, hold_and_little_more_does_not) {
  const auto sample = certified(GetParam(), Rational(1) / Rational(8));
  ASSERT_TRUE(sample.claims.stars && sample.claims.delaunay && sample.claims.metric);
  const CheckerRun verified = sample.check(sample.claims);
  ASSERT_EQ(verified.status, 0) << verified.message;
  const Rational more = Rational(1001) / Rational(1000);
  const auto expect = [&](const std::string& rule, const auto& change) {
    delcert::Claims claims = sample.claims;
    change(claims);
    const CheckerRun run = sample.check(claims);
    EXPECT_EQ(run.status, 1) << rule;
    EXPECT_EQ(run.rules, std::set<std::string>{rule}) << run.message;
  };
  expect("1.protection", [&](delcert::Claims& claims) { claims.stars->protection *= more; });
  expect("1.thickness", [&](delcert::Claims& claims) { claims.stars->thickness *= more; });
  expect("1.radius", [&](delcert::Claims& claims) { claims.stars->circumradius /= more; });
  expect("4.empty", [&](delcert::Claims& claims) { claims.delaunay->balls->protection *= more; });
  expect("6.self-delaunay", [&](delcert::Claims& claims) { claims.metric->weight = Rational(1); });
  expect("0.density", [&](delcert::Claims& claims) { claims.input->density->density /= more; });
}

/// A flat run states so large a reach that level 2s follows; with less of it the charts are looked at one by one, which
/// says the same until the reach is too small.
TEST(FlatSpaceFormMargins, are_those_that_looking_at_each_of_them_finds) {
  const auto sample = certified("klein-bottle", Rational(1) / Rational(24));
  ASSERT_TRUE(sample.claims.stars && sample.claims.stable_stars);
  const Rational enough = Rational(4) * sample.claims.stars->circumradius;
  ASSERT_GT(*sample.claims.stable_stars->reach, enough);
  for (const auto& [factor, status] :
       {std::pair(Rational(1), 0), {Rational(999) / Rational(1000), 0}, {Rational(1) / Rational(2), 1}}) {
    delcert::Claims claims = sample.claims;
    *claims.stable_stars->reach *= factor;
    const CheckerRun run = sample.check(claims);
    EXPECT_EQ(run.status, status) << run.message;
    EXPECT_EQ(run.rules, status == 0 ? std::set<std::string>{} : std::set<std::string>{"2s.reach"}) << run.message;
  }
}

INSTANTIATE_TEST_SUITE_P(Runs, SpaceFormMargins, testing::Values("projective-plane", "bolza-surface"));

}  // namespace
}  // namespace delcert::checker_tests
