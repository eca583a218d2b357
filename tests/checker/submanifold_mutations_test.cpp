// Certificates of a circle, a sphere and a mesh, changed at random.

#include <gtest/gtest.h>

#include "tests/checker/hypersurface_oracle.hpp"
#include "tests/checker/mutation_campaign.hpp"
#include "tests/checker/support/submanifold_model.hpp"
#include "tests/checker/upwards.hpp"

namespace delcert::checker_tests {
namespace {

/// An oracle finds false what is false at a sample.
class MutationsOfSubmanifolds : public testing::Test {
 protected:
  const test::Upwards upwards;
  const std::vector<std::string> all_levels_ = {"1", "2", "2s", "4", "5", "5i", "6"};

  static void mutate(const std::string& name, const Json& document, int few, std::uint64_t seed) {
    run_campaign({.name = name, .text = sealed(document), .fault = fault_of_hypersurface, .few = few, .seed = seed});
  }
};

TEST_F(MutationsOfSubmanifolds, of_a_circle_sealed_anew_are_accepted_only_if_nothing_false_is_found) {
  mutate("a circle", certificate(circle_model(40, 1), all_levels_), 1500, 7);
}

TEST_F(MutationsOfSubmanifolds, of_a_sphere_sealed_anew_are_accepted_only_if_nothing_false_is_found) {
  mutate("a sphere", certificate(sphere_model(3), all_levels_), 30, 8);
}

/// Level 5i by normals, in place of a margin.
Json by_normals(const SubmanifoldModel& model) {
  Json document = certificate(model, {"1", "2", "5", "5i"});
  document["levels"]["5i"] = {{"cosine", "63/64"}};
  return document;
}

TEST_F(MutationsOfSubmanifolds, of_a_circle_by_normals_are_accepted_only_if_nothing_false_is_found) {
  mutate("a circle by normals", by_normals(circle_model(40, 1)), 500, 13);
}

TEST_F(MutationsOfSubmanifolds, of_a_sphere_by_normals_are_accepted_only_if_nothing_false_is_found) {
  mutate("a sphere by normals", by_normals(sphere_model(3)), 20, 14);
}

/// The manifold is a polyhedron, of which the simplices are a coarser triangulation.
TEST_F(MutationsOfSubmanifolds, of_a_mesh_sealed_anew_are_accepted_only_if_nothing_false_is_found) {
  SubmanifoldModel model = on_mesh(sphere_model(3), sphere_model(4));
  model.displacement *= 1.25;
  mutate("a mesh", certificate(model, all_levels_), 12, 9);
}

/// A mesh of fewer points, for more mutations.
TEST_F(MutationsOfSubmanifolds, of_a_coarse_mesh_sealed_anew_are_accepted_only_if_nothing_false_is_found) {
  SubmanifoldModel model = on_mesh(sphere_model(2), sphere_model(3));
  model.displacement *= 1.25;
  model.contraction = 0.9;
  mutate("a coarse mesh", certificate(model, {"1", "2", "2s", "5"}), 40, 12);
}

}  // namespace
}  // namespace delcert::checker_tests
