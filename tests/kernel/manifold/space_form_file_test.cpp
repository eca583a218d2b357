#include "kernel/manifold/space_form_file.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "tests/kernel/manifold/quotient/samples.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

std::string refusal(const std::string& text) {
  return message_of<InputError>([&] { (void)parse_space_form(text, "x.toml"); });
}

const std::string head = "name = \"x\"\nfamily = \"space-form\"\ndimension = 2\n";
const std::string glide = "generators = [[[1, 0, 0], [\"1/2\", 1, 0], [0, 0, -1]]]\nfirst_homology = \"Z + Z/2\"\n";

TEST(SpaceFormFile, reads_a_group_over_the_rationals) {
  const auto description = parse_space_form(head + "curvature = 0\ngram = [[4, 0], [0, 1]]\n" + glide, "x.toml");
  EXPECT_EQ(description.name, "x");
  EXPECT_EQ(description.form.curvature(), Curvature::zero);
  EXPECT_EQ(description.form.gram()(0, 0), FieldElement(4));
  ASSERT_EQ(description.generators.size(), 1U);
  EXPECT_EQ(description.generators[0](1, 0), FieldElement(ratio(1, 2)));
  EXPECT_EQ(description.first_homology, "Z + Z/2");
  EXPECT_FALSE(description.order.has_value());
}

TEST(SpaceFormFile, reads_a_group_over_a_field) {
  const auto description = find_space_form("seifert-weber-space");
  EXPECT_EQ(description.form.time().text(), "-7/4*t - 3/4");
  EXPECT_EQ(description.generators.size(), 6U);
  EXPECT_EQ(description.form.curvature(), Curvature::negative);
}

TEST(SpaceFormFile, reads_families) {
  EXPECT_EQ(parse_space_form("name = \"l\"\nfamily = \"lens-space\"\np = 5\nq = 2\n", "x").generators.size(), 1U);
  EXPECT_EQ(parse_space_form("name = \"s\"\nfamily = \"sphere\"\ndimension = 3\n", "x").form.dimension(), 3);
}

TEST(SpaceFormFile, reads_a_product_with_a_circle) {
  const std::string product = "name = \"p\"\nfamily = \"product-with-circle\"\nsurface = ";
  EXPECT_EQ(parse_space_form(product + "\"klein-bottle\"\nlength = \"3/2\"\n", "x").form.gram()(2, 2),
            FieldElement(ratio(9, 4)));
  EXPECT_TRUE(
      mentions(refusal(product + "\"bolza-surface\"\nlength = 1\n"), "x.toml:3:11: the product of bolza-surface"));
  EXPECT_TRUE(mentions(refusal(product + "\"klein-bottle\"\nlength = 0\n"), "a circle of the length 0"));
  EXPECT_TRUE(mentions(refusal(product + "\"klein\"\nlength = 1\n"), "no space form \"klein\""));
  EXPECT_TRUE(mentions(refusal(product + "\"klein-bottle\"\n"), "the key length is missing"));
}

TEST(SpaceFormFile, says_what_is_wrong_and_where) {
  EXPECT_TRUE(mentions(refusal("name = \n"), "x.toml:1:8: not TOML"));
  EXPECT_EQ(refusal("name = \"x\"\n"), "x.toml:1:1: the key family is missing");
  EXPECT_TRUE(mentions(refusal("name = \"x\"\nfamily = \"torus\"\n"),
                       "x.toml:2:10: key \"family\": found \"torus\", expected \"space-form\", \"sphere\""));
  EXPECT_TRUE(mentions(refusal(head + "curvature = 2\n"),
                       "x.toml:4:13: key \"curvature\": found the integer 2, expected an integer from -1 to 1"));
  EXPECT_TRUE(mentions(refusal(head + "curvature = 0\ngenerator = 3\n" + glide), "x.toml:5:1: unknown key generator"));
  EXPECT_TRUE(mentions(refusal(head + "curvature = 0\ngenerators = [[[1, 0, 0]]]\nfirst_homology = \"0\"\n"),
                       "generator 1: found an array of length 1, expected an array of 3 rows"));
  EXPECT_TRUE(mentions(refusal(head + "curvature = 0\ngenerators = [[[1, 0, 0], [0.5, 1, 0], [0, 0, 1]]]\n"),
                       "generator 1, row 2, entry 1: found the floating-point number 0.5"));
  EXPECT_TRUE(mentions(refusal(head + "curvature = 0\ngenerators = [[[1, 0, 0], [\"t\", 1, 0], [0, 0, 1]]]\n"),
                       "expected a rational number, as there is no key \"field\""));
  EXPECT_TRUE(mentions(refusal(head + "curvature = 0\ngenerators = [[[1, 0, 0], [\"1 +\", 1, 0], [0, 0, 1]]]\n"),
                       "generator 1, row 2, entry 1: \"1 +\" at character 4"));
  EXPECT_TRUE(mentions(refusal(head + "curvature = 0\ngenerators = []\n"), "the key first_homology is missing"));
  EXPECT_TRUE(mentions(refusal(head + "curvature = -1\ntime = 1\n" + glide),
                       "key \"time\": found the integer 1, expected a number with the sign"));
  EXPECT_TRUE(mentions(refusal(head + "curvature = 0\nfield = \"t^2 - 4\"\nroot = [1, 3]\n" + glide),
                       "x.toml:5:9: field polynomial t^2 - 4 is reducible"));
  EXPECT_TRUE(mentions(refusal(head + "curvature = 0\nfield = \"t^2 - 2\"\nroot = [1]\n" + glide),
                       "key \"root\": found an array of length 1, expected an array of two exact numbers"));
  EXPECT_TRUE(
      mentions(refusal(head + "curvature = 0\ngram = [[1, 1], [1, 1]]\n" + glide), "gram is not positive definite"));
  EXPECT_TRUE(mentions(refusal("name = \"l\"\nfamily = \"lens-space\"\np = 5\nq = 5\n"), "an integer from 1 to 4"));
}

TEST(SpaceFormFile, the_page_has_a_row_for_every_member) {
  std::ifstream stream(DELCERT_SOURCE_DIR "/docs/space-forms.md");
  const std::string page(std::istreambuf_iterator<char>(stream), {});
  for (const BuiltinManifold& builtin : builtin_space_forms()) {
    const SpaceForm form = verify_space_form(find_space_form(builtin.name));
    const std::string digits =
        std::to_string(floor_of(form.injectivity_radius.lower * Rational(10000)).convert_to<long>() + 100000);
    const Curvature curvature = form.form().curvature();
    const std::string sign = curvature == Curvature::negative ? "−1" : curvature == Curvature::zero ? "0" : "1";
    const std::string row = "| " + builtin.name + " | " + sign + " | " + (form.is_orientable ? "yes" : "no") + " | " +
                            group_text(form.first_homology) + " | " + digits.substr(1, 1) + "." + digits.substr(2) +
                            " |";
    EXPECT_TRUE(mentions(page, row)) << row;
  }
}

TEST(SpaceFormFile, knows_the_built_in_ones_by_their_names) {
  EXPECT_TRUE(mentions(message_of<InputError>([] { (void)find_space_form("torus"); }),
                       "no space form \"torus\", expected one of bolza-surface, flat-first-amphicosm"));
  for (const BuiltinManifold& builtin : builtin_space_forms())
    EXPECT_EQ(find_space_form(builtin.name).name, builtin.name);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
