#include <gtest/gtest.h>

#include "tests/checker/support/run_checker.hpp"
#include "tests/checker/support/space_form_samples.hpp"

namespace delcert::checker_tests {
namespace {

void expect_accepted(const SpaceFormSample& sample) {
  const CheckerRun run = run_checker(sealed(sample.document()));
  EXPECT_EQ(run.status, 0) << run.output;
  std::printf("%zu points: %s", sample.model.size(), run.output.c_str());
}

TEST(SpaceForm, an_icosphere_is_accepted) { expect_accepted(icosphere()); }
TEST(SpaceForm, a_projective_plane_is_accepted) { expect_accepted(projective_plane()); }
TEST(SpaceForm, the_600_cell_is_accepted) { expect_accepted(cell_600()); }
TEST(SpaceForm, half_of_the_600_cell_is_accepted) { expect_accepted(projective_space()); }
TEST(SpaceForm, a_klein_bottle_is_accepted) { expect_accepted(klein_bottle()); }
TEST(SpaceForm, a_bolza_surface_is_accepted) { expect_accepted(bolza_surface()); }

}  // namespace
}  // namespace delcert::checker_tests
