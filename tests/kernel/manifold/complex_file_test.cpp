#include "kernel/manifold/complex_file.hpp"

#include <gtest/gtest.h>

#include "support/error.hpp"
#include "tests/support/complex_texts.hpp"
#include "tests/support/message_of.hpp"
#include "tests/support/ratio.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

using Word = std::vector<std::int32_t>;

std::string klein(const std::string& part = "", const std::string& by = "") {
  return replaced(complex_text("klein-bottle-9"), part, by);
}

std::string refusal(const std::string& text) {
  return message_of<InputError>([&] { (void)parse_complex(text, "x.toml"); });
}
/// Of the Klein bottle with one part replaced.
std::string refusal(const std::string& part, const std::string& by) { return refusal(klein(part, by)); }

TEST(ComplexFile, reads_points_words_and_simplices) {
  const ComplexDescription complex = parse_complex(klein(), "x.toml");
  EXPECT_EQ(complex.name, "klein-bottle-9");
  EXPECT_EQ(complex.form.curvature(), Curvature::zero);
  EXPECT_EQ(complex.generator_names, std::vector<std::string>{"g"});
  ASSERT_EQ(complex.points.size(), 9U);
  EXPECT_EQ(complex.point_names[4], "b1");
  EXPECT_EQ(complex.points[4], (std::vector<Rational>{ratio(1, 6), ratio(1, 2)}));
  ASSERT_EQ(complex.simplices.size(), 18U);
  // "c1", "g a0", "g e2^-1 a2": by labels.
  const auto& simplex = complex.simplices[13];
  EXPECT_EQ(simplex[0].label, 0U);
  EXPECT_EQ(simplex[0].word, Word{1});
  EXPECT_EQ(simplex[1].label, 2U);
  EXPECT_EQ(simplex[1].word, (Word{1, -3}));
  EXPECT_EQ(simplex[2].label, 7U);
  EXPECT_EQ(simplex[2].word, Word{});
  EXPECT_EQ(complex.letter_name(1), "g");
  EXPECT_EQ(complex.letter_name(3), "e2");
}

TEST(ComplexFile, reads_points_by_index_exponents_and_doubles) {
  const ComplexDescription complex = parse_complex(
      "name = \"x\"\nfamily = \"complex\"\ndimension = 2\ncurvature = -1\npoints = [[0.5, 0], [0, \"1/3\"], "
      "[\"0x1p-2\", -1]]\n"
      "simplices = [[2, \"a^2 b^-2 0\", \"1\"]]\ngenerators.a = [[1,0,0],[0,1,0],[0,0,1]]\n"
      "generators.b = [[1,0,0],[0,1,0],[0,0,1]]\n",
      "x.toml");
  EXPECT_EQ(complex.points[0][0], ratio(1, 2));
  EXPECT_EQ(complex.points[2][0], ratio(1, 4));
  EXPECT_EQ(complex.simplices[0][0].word, (Word{1, 1, -2, -2}));
  EXPECT_EQ(complex.simplices[0][2].label, 2U);
}

TEST(ComplexFile, says_which_key_is_wrong) {
  EXPECT_TRUE(mentions(refusal("name = \"x\"\nfamily = \"space-form\"\n"), "x.toml:2:10: key \"family\""));
  EXPECT_TRUE(mentions(refusal("gram =", "grem ="), "unknown key grem"));
  EXPECT_TRUE(mentions(refusal("gram =", "field = \"t^2 - 2\"\nroot = [1, 2]\ngram ="), "key \"field\""));
  EXPECT_TRUE(mentions(refusal("[generators]\ng", "[generators]\ne1"), "e1 is the translation by a basis vector"));
  EXPECT_TRUE(mentions(refusal("[generators]\ng", "[generators]\n\"2g\""), "generator 2g: expected a name"));
  EXPECT_TRUE(mentions(refusal("g = [[1, 0, 0]", "g = [[1, 0]"), "generator g, row 1: found an array of length 2"));
}

TEST(ComplexFile, says_which_point_is_wrong) {
  EXPECT_TRUE(mentions(refusal("b1 = [\"1/6\", \"1/2\"]", "b1 = [\"1/6\", \"half\"]"), "point b1, coordinate 2: "));
  EXPECT_TRUE(mentions(refusal("b1 = [\"1/6\", \"1/2\"]", "b1 = [\"1/6\"]"), "point b1: found an array of length 1"));
  EXPECT_TRUE(mentions(refusal("b1 = ", "\"b 1\" = "), "point b 1: expected a name"));
  EXPECT_TRUE(mentions(refusal("b1 = [\"1/6\", \"1/2\"]", "b1 = [nan, 0]"), "point b1, coordinate 1: found"));
  EXPECT_TRUE(mentions(refusal("a0 = [0, 0]", "a0 = [0, 0]\nz = [0, 0]"), "point z is in no simplex"));
  EXPECT_TRUE(mentions(refusal(replaced(replaced(klein("curvature = 0", "curvature = -1"), "gram =", "#"),
                                        "a0 = [0, 0]", "a0 = [2, 0]")),
                       "point a0: found an array of length 2, expected conformal coordinates of a length below 2"));
}

TEST(ComplexFile, says_which_simplex_is_wrong) {
  EXPECT_TRUE(mentions(refusal("\"g a0\"", "\"g a9\""), "simplex 13, vertex 3: no point a9, did you mean a"));
  EXPECT_TRUE(mentions(refusal("\"g a0\"", "\"h a0\""), "x.toml:15:16: simplex 13, vertex 3: no generator h"));
  EXPECT_TRUE(mentions(refusal("\"g a0\"", "\"e3 a0\""), "no generator e3"));
  EXPECT_TRUE(mentions(refusal("\"g a0\"", "\"g^x a0\""), "\"g^x\": expected an exponent"));
  EXPECT_TRUE(mentions(refusal("\"g a0\"", "\"g^0 a0\""), "\"g^0\": expected an exponent"));
  EXPECT_TRUE(mentions(refusal("\"g a0\"", "\"g^ a0\""), "\"g^\": expected an exponent"));
  EXPECT_TRUE(mentions(refusal("\"g a0\"", "\"\""), "simplex 13, vertex 3: found \"\", expected a point"));
  EXPECT_TRUE(mentions(refusal("\"g a0\"", "0.5"), "simplex 13, vertex 3: found the floating-point number"));
  EXPECT_TRUE(mentions(refusal("\"c1\", \"g a0\"]", "\"c1\"]"), "found an array of length 2, expected an array of 3"));
  EXPECT_TRUE(
      mentions(refusal("\"a0\", \"a1\", \"b0\"", "\"a0\", \"a0\", \"b0\""), "simplex 1 has the point a0 twice"));
  EXPECT_TRUE(mentions(refusal("\"a1\", \"b0\", \"b1\"", "\"a1\", \"a0\", \"e2 b0\""),
                       "simplex 2 has the points a0, a1, b0, as has simplex 1: different simplices"));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
