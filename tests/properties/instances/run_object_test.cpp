#include "properties/instances/run_object.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "support/error.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

RunRecipe small_recipe() {
  RunRecipe recipe;
  recipe.divisions = 18;
  return recipe;
}

TEST(RunObject, of_a_lattice_satisfies_the_hypotheses_and_what_follows) {
  const RunObject run(small_recipe());
  EXPECT_EQ(run.dimension(), 2);
  EXPECT_EQ(run.hypotheses(), Verdict::proved);
  EXPECT_EQ(run.stars(), Verdict::proved);
  EXPECT_EQ(run.no_forbidden(), Verdict::proved);
  EXPECT_EQ(run.squared_edges().size(), 2U * 18 * 18);
  EXPECT_EQ(run.claims().names(), (std::vector<std::string>{"0", "1", "2", "2s", "4", "5", "6"}));
  EXPECT_EQ(run.claims().manifold->euler_characteristic, 0);
  EXPECT_LT(run.covering_lower(), run.covering_upper());
  EXPECT_LT(run.distance_lower(), run.distance_upper());
}

TEST(RunObject, without_perturbation_is_refuted_by_cospherical_points) {
  RunRecipe recipe = small_recipe();
  recipe.mode = RunMode::none;
  const RunObject run(recipe);
  EXPECT_EQ(run.hypotheses(), Verdict::refuted);
  EXPECT_EQ(run.stars(), Verdict::refuted);
  EXPECT_EQ(run.no_forbidden(), Verdict::refuted);
  EXPECT_TRUE(run.claims().names().empty());
}

TEST(RunObject, on_a_coarse_net_does_not_satisfy_the_hypotheses) {
  RunRecipe recipe = small_recipe();
  recipe.divisions = 12;
  EXPECT_EQ(RunObject(recipe).hypotheses(), Verdict::refuted);
}

TEST(RunObject, is_made_again_from_what_it_wrote) {
  const RunObject run(small_recipe());
  const auto again = RunObject::read(run.json());
  const auto& read = dynamic_cast<const RunObject&>(*again);
  EXPECT_EQ(read.json(), run.json());
  EXPECT_EQ(read.squared_edges(), run.squared_edges());
  EXPECT_EQ(read.claims().stars->protection, run.claims().stars->protection);
}

TEST(RunObject, refuses_what_is_no_recipe) {
  const auto refuses = [](auto change) {
    RunRecipe recipe = small_recipe();
    change(recipe);
    EXPECT_THROW(RunObject{recipe}, InputError);
  };
  refuses([](RunRecipe& recipe) { recipe.manifold = "disk"; });
  refuses([](RunRecipe& recipe) { recipe.manifold = "nowhere"; });
  refuses([](RunRecipe& recipe) { recipe.manifold = "circle"; });
  refuses([](RunRecipe& recipe) { recipe.perturbation_share = Rational(2); });
  refuses([](RunRecipe& recipe) { recipe.radius = Rational(1); });
  refuses([](RunRecipe& recipe) { recipe.divisions = 0; });
  EXPECT_THROW((void)RunObject::read(nlohmann::ordered_json::parse(R"({"manifold": "torus-2"})")), InputError);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
