#include "kernel/manifold/any_manifold.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "kernel/manifold/atlas_file.hpp"
#include "kernel/manifold/builtin_manifolds.hpp"
#include "kernel/manifold/metric_field_file.hpp"
#include "kernel/manifold/space_form_file.hpp"
#include "kernel/manifold/submanifold_file.hpp"
#include "support/error.hpp"
#include "tests/support/message_of.hpp"
#include "tests/support/ratio.hpp"
#include "tests/support/temporary_folder.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

std::string refusal(const std::string& text) {
  return message_of<InputError>([&] { (void)parse_any_manifold(text, "x.toml"); });
}

TEST(AnyManifold, is_what_its_family_says) {
  EXPECT_TRUE(std::holds_alternative<ManifoldDescription>(
      parse_any_manifold("name = \"b\"\nfamily = \"euclidean-ball\"\ndimension = 2\nradius = 1\n", "x.toml")));
  EXPECT_TRUE(std::holds_alternative<SpaceFormDescription>(
      parse_any_manifold("name = \"s\"\nfamily = \"sphere\"\ndimension = 2\n", "x.toml")));
  EXPECT_TRUE(std::holds_alternative<MetricFieldDescription>(parse_any_manifold(
      "name = \"f\"\nfamily = \"metric-field\"\ndimension = 2\nconstant = [[1, 0], [0, 1]]\n", "x.toml")));
  EXPECT_TRUE(std::holds_alternative<SubmanifoldDescription>(
      parse_any_manifold("name = \"s\"\nfamily = \"submanifold\"\ndimension = 2\nvariables = [\"x\", \"y\", \"z\"]\n"
                         "equations = [\"x^2 + y^2 + z^2 - 1\"]\nbox = [[-2, 2], [-2, 2], [-2, 2]]\n",
                         "x.toml")));
}

TEST(AnyManifold, is_a_flat_torus_where_a_space_form_has_no_rotation) {
  const std::string torus =
      "name = \"t\"\nfamily = \"space-form\"\ndimension = 2\ncurvature = 0\n"
      "gram = [[\"2\", \"1/2\"], [\"1/2\", \"3\"]]\ngenerators = []\nfirst_homology = ";
  const AnyManifold found = parse_any_manifold(torus + "\"Z^2\"\n", "t.toml");
  const auto* flat = std::get_if<ManifoldDescription>(&found);
  ASSERT_NE(flat, nullptr);
  EXPECT_EQ(flat->name, "t");
  EXPECT_EQ(flat->family, ManifoldFamily::flat_torus);
  EXPECT_EQ(flat->dimension, Dimension(2));
  EXPECT_EQ(flat->gram[0][0], Rational(2));
  EXPECT_EQ(flat->gram[1][0], ratio(1, 2));
  EXPECT_EQ(flat->gram[1][1], Rational(3));
  // Whoever says something else of it is refused by the verification of groups.
  for (const std::string said : {"\"Z\"\n", "\"Z^2\"\norder = 1\n"}) {
    EXPECT_TRUE(std::holds_alternative<SpaceFormDescription>(parse_any_manifold(torus + said, "t.toml"))) << said;
  }
  EXPECT_TRUE(std::holds_alternative<SpaceFormDescription>(find_any_manifold("klein-bottle")));
  EXPECT_TRUE(std::holds_alternative<ManifoldDescription>(find_any_manifold("flat-torus-3")));
}

TEST(AnyManifold, guesses_a_family_that_is_misspelt) {
  EXPECT_EQ(
      refusal("name = \"x\"\nfamily = \"space-from\"\n"),
      "x.toml:2:10: key \"family\": found \"space-from\", expected one of flat-torus, euclidean-ball, space-form, "
      "sphere, projective-space, lens-space, regular-polygon-surface, product-with-circle, metric-field, atlas, "
      "submanifold, "
      "did you mean "
      "space-form?");
  EXPECT_TRUE(mentions(refusal("family = \"metric_field\"\n"), "did you mean metric-field?"));
  EXPECT_FALSE(mentions(refusal("family = \"knot\"\n"), "did you mean"));
  EXPECT_TRUE(mentions(refusal("family = 3\n"), "x.toml:1:10: key \"family\": found the integer 3, expected one of"));
  EXPECT_TRUE(mentions(refusal("name = \"x\"\n"), "x.toml:1:1: the key family is missing, expected one of flat-torus"));
  EXPECT_TRUE(mentions(refusal("family = \n"), "x.toml:1:10: not TOML: "));
}

/// Defect: of three readers two swallowed the errors of a file of theirs.
TEST(AnyManifold, says_what_is_wrong_in_a_file_of_any_family) {
  EXPECT_TRUE(
      mentions(refusal("name = \"x\"\nfamily = \"sphere\"\ndimension = 7\n"), "x.toml:3:13: key \"dimension\""));
  EXPECT_TRUE(
      mentions(refusal("name = \"x\"\nfamily = \"metric-field\"\ndimension = 2\n"), "the key constant is missing"));
  EXPECT_TRUE(mentions(refusal("name = \"x\"\nfamily = \"flat-torus\"\ndimension = 2\n"), "\"gram\" (inner products)"));
}

TEST(AnyManifold, cannot_be_read_from_a_folder) {
  EXPECT_TRUE(mentions(message_of<InputError>([] { (void)read_any_manifold(std::filesystem::temp_directory_path()); }),
                       "Is a directory"));
  EXPECT_TRUE(mentions(message_of<InputError>([] { (void)read_any_manifold("no-such-file.toml"); }), "No such file"));
}

TEST(FindAnyManifold, knows_every_builtin_one_by_its_name) {
  EXPECT_EQ(builtin_manifolds().size(), 10U);
  for (const BuiltinManifold& builtin : builtin_manifolds()) EXPECT_EQ(find_manifold(builtin.name).name, builtin.name);
  for (const BuiltinManifold& builtin : builtin_space_forms()) {
    if (builtin.name == "flat-torus-3") continue;
    EXPECT_EQ(std::get<SpaceFormDescription>(find_any_manifold(builtin.name)).name, builtin.name);
  }
  for (const BuiltinManifold& builtin : builtin_metric_fields())
    EXPECT_EQ(std::get<MetricFieldDescription>(find_any_manifold(builtin.name)).name, builtin.name);
  for (const BuiltinManifold& builtin : builtin_atlases())
    EXPECT_EQ(std::get<FormulaAtlasDescription>(find_any_manifold(builtin.name)).name, builtin.name);
  for (const BuiltinManifold& builtin : builtin_submanifolds())
    EXPECT_EQ(std::get<SubmanifoldDescription>(find_any_manifold(builtin.name)).name, builtin.name);
}

TEST(FindAnyManifold, reads_a_file_by_its_path) {
  const TemporaryFolder folder;
  const auto path = folder / "ball.toml";
  std::ofstream(path) << "name = \"b\"\nfamily = \"euclidean-ball\"\ndimension = 2\nradius = 2\n";
  EXPECT_EQ(find_manifold(path.string()).radius, Rational(2));
  const std::string sphere = DELCERT_SOURCE_DIR "/examples/manifolds/space-forms/sphere-3.toml";
  EXPECT_EQ(std::get<SpaceFormDescription>(find_any_manifold(sphere)).name, "sphere-3");
  EXPECT_TRUE(mentions(message_of<InputError>([&] { (void)find_manifold(sphere); }), "expected a flat torus"));
}

TEST(FindAnyManifold, lists_the_names_when_there_is_neither) {
  const std::string message = message_of<InputError>([] { (void)find_any_manifold("torus-9"); });
  EXPECT_TRUE(mentions(message, "no manifold \"torus-9\": neither a file nor one of ball-3, circle")) << message;
  EXPECT_TRUE(mentions(message, "torus-4, or of the space forms bolza-surface, ")) << message;
  EXPECT_TRUE(mentions(message, ", or of the metric fields torus-2-anisotropic, ")) << message;
  EXPECT_TRUE(mentions(message, ", or of the atlases cone-torus, klein-bottle-rectangles, ")) << message;
  EXPECT_TRUE(mentions(message, ", or of the submanifolds clifford-torus, ")) << message;
  EXPECT_TRUE(mentions(message, ", did you mean torus-2?")) << message;
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
