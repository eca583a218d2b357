// Runs on space forms, from the net to the certificate, and the checker's word on them.

#include "tests/proofs/certificate/space_form_run.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "tests/checker/support/certificate_text.hpp"
#include "tests/checker/support/run_checker.hpp"

namespace delcert::checker_tests {
namespace {

struct Certified {
  std::string path;
  delcert::Claims claims;
  std::vector<std::string> reasons;
};

template <int m>
Certified certified(const std::string& name, const Rational& radius, int factor = 9) {
  const auto sample = test::space_form_run<m>(name, radius, factor);
  EXPECT_TRUE(sample.run.is_certified()) << name;
  Certified result;
  result.claims = sample.claims(result.reasons);
  result.path = temporary_file("");
  sample.write(result.path, result.claims);
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
