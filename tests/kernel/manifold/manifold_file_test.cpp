#include "kernel/manifold/manifold_file.hpp"

#include <gtest/gtest.h>

#include <string>

#include "support/error.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

using Matrix = std::vector<std::vector<Rational>>;

Rational fraction(long numerator, long denominator) { return Rational(numerator) / Rational(denominator); }

std::string torus(const std::string& rest) {
  return "name = \"x\"\nfamily = \"flat-torus\"\ndimension = 2\n" + rest + "\n";
}

std::string ball(const std::string& rest) {
  return "name = \"x\"\nfamily = \"euclidean-ball\"\ndimension = 2\n" + rest + "\n";
}

std::string message_for(const std::string& text) {
  try {
    (void)parse_manifold(text, "x.toml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

#define EXPECT_MESSAGE(text, fragment)                                              \
  do {                                                                              \
    const std::string message = message_for(text);                                  \
    EXPECT_NE(message.find(fragment), std::string::npos) << "message: " << message; \
  } while (false)

TEST(ManifoldFile, reads_a_gram_matrix) {
  const ManifoldDescription manifold = parse_manifold(torus(R"(gram = [["1", "1/2"], ["0x1p-1", 3]])"), "x.toml");
  EXPECT_EQ(manifold.name, "x");
  EXPECT_EQ(manifold.family, ManifoldFamily::flat_torus);
  EXPECT_EQ(manifold.dimension, Dimension{2});
  EXPECT_EQ(manifold.gram, (Matrix{{Rational(1), fraction(1, 2)}, {fraction(1, 2), Rational(3)}}));
}

TEST(ManifoldFile, computes_the_gram_matrix_of_a_basis) {
  const ManifoldDescription manifold = parse_manifold(torus(R"(basis = [["1", "0"], ["2/5", "9/10"]])"), "x.toml");
  EXPECT_EQ(manifold.gram, (Matrix{{Rational(1), fraction(2, 5)}, {fraction(2, 5), fraction(97, 100)}}));
}

TEST(ManifoldFile, reads_a_ball) {
  const ManifoldDescription manifold = parse_manifold(ball("radius = \"3/2\""), "x.toml");
  EXPECT_EQ(manifold.family, ManifoldFamily::euclidean_ball);
  EXPECT_EQ(manifold.radius, fraction(3, 2));
  EXPECT_EQ(manifold.gram, (Matrix{{Rational(1), Rational(0)}, {Rational(0), Rational(1)}}));
}

TEST(ManifoldFile, names_its_families) {
  EXPECT_EQ(name_of(ManifoldFamily::flat_torus), "flat-torus");
  EXPECT_EQ(name_of(ManifoldFamily::euclidean_ball), "euclidean-ball");
}

TEST(ManifoldFile, refuses_what_is_not_toml) {
  EXPECT_MESSAGE("name = \n", "x.toml:1:8: not TOML: ");
  EXPECT_MESSAGE("name = \"x\"\nname = \"y\"\n", "x.toml:2:");
}

TEST(ManifoldFile, refuses_missing_keys) {
  EXPECT_MESSAGE("", "x.toml:1:1: the key family is missing, expected \"flat-torus\" or \"euclidean-ball\"");
  EXPECT_MESSAGE("family = \"flat-torus\"", "x.toml:1:1: the key name is missing");
  EXPECT_MESSAGE("family = \"flat-torus\"\nname = \"x\"",
                 "x.toml:1:1: the key dimension is missing, expected an integer from 1 to 4");
  EXPECT_MESSAGE(torus(""),
                 "x.toml:1:1: key \"gram\" (inner products) or \"basis\" (lattice basis, by rows) is missing");
  EXPECT_MESSAGE(ball(""), "x.toml:1:1: the key radius is missing");
}

TEST(ManifoldFile, refuses_unknown_keys_and_says_where) {
  EXPECT_MESSAGE(torus("  grma = 1"), "x.toml:4:3: unknown key grma, did you mean gram?");
  EXPECT_MESSAGE(torus("gram = [[1,0],[0,1]]\nradius = \"1\""), "x.toml:5:1: unknown key radius");
  EXPECT_MESSAGE(ball("radius = 1\ngram = [[1,0],[0,1]]"), "x.toml:5:1: unknown key gram");
}

TEST(ManifoldFile, refuses_wrong_families_names_and_dimensions) {
  EXPECT_MESSAGE("family = \"klein\"", "x.toml:1:10: key \"family\": found \"klein\", expected \"flat-torus\"");
  EXPECT_MESSAGE("family = 3", "found the integer 3");
  EXPECT_MESSAGE("family = \"flat-torus\"\nname = \"a b\"",
                 "x.toml:2:8: key \"name\": found \"a b\", expected a string");
  EXPECT_MESSAGE("family = \"flat-torus\"\nname = \"\"", "key \"name\": found \"\"");
  EXPECT_MESSAGE("family = \"flat-torus\"\nname = true", "found the boolean true");
  const std::string head = "family = \"flat-torus\"\nname = \"x\"\ndimension = ";
  EXPECT_MESSAGE(head + "0", "x.toml:3:13: key \"dimension\": found the integer 0, expected an integer from 1 to 4");
  EXPECT_MESSAGE(head + "5", "found the integer 5");
  EXPECT_MESSAGE(head + "2.0", "found the floating-point number 2.0");
  EXPECT_MESSAGE(head + "\"2\"", "found \"2\"");
  EXPECT_MESSAGE(head + "1979-05-27", "found a date or a time");
}

TEST(ManifoldFile, quotes_long_texts_in_one_short_line) {
  const std::string message = message_for("family = \"line\\n" + std::string(100000, 'a') + "\"");
  EXPECT_LT(message.size(), 300U);
  EXPECT_EQ(message.find('\n'), std::string::npos);
  EXPECT_NE(message.find("line?aaa"), std::string::npos) << message;
}

TEST(ManifoldFile, refuses_numbers_that_are_not_exact) {
  EXPECT_MESSAGE(torus("gram = [[1, 0.5], [0.5, 1]]"),
                 "x.toml:4:13: key \"gram\", row 1, entry 2: found the floating-point number 0.5, expected an exact "
                 "number: an integer, or a string such as \"3/4\" or \"0x3p-2\"; a floating-point number would be "
                 "rounded before it is read");
  EXPECT_MESSAGE(torus("gram = [[1, \"0.5\"], [0, 1]]"),
                 "x.toml:4:13: key \"gram\", row 1, entry 2: not an exact number: \"0.5\"");
  EXPECT_MESSAGE(torus("gram = [[1, \"1/0\"], [0, 1]]"), "a denominator other than 0");
  EXPECT_MESSAGE(torus("gram = [[1, \"\"], [0, 1]]"), "row 1, entry 2: not an exact number: \"\"");
  EXPECT_MESSAGE(torus("gram = [[1, {}], [0, 1]]"), "row 1, entry 2: found a table");
  EXPECT_MESSAGE(ball("radius = 1.5"), "key \"radius\": found the floating-point number 1.5");
}

TEST(ManifoldFile, refuses_matrices_of_the_wrong_shape) {
  EXPECT_MESSAGE(torus("gram = \"1\""),
                 "x.toml:4:8: key \"gram\": found \"1\", expected an array of 2 rows of 2 numbers");
  EXPECT_MESSAGE(torus("gram = [[1]]"), "found an array of length 1, expected an array of 2 rows of 2 numbers");
  EXPECT_MESSAGE(torus("basis = [[1, 0], [0]]"),
                 "x.toml:4:18: key \"basis\", row 2: found an array of length 1, expected an array of 2 numbers");
  EXPECT_MESSAGE(torus("basis = [[1, 0], 7]"), "key \"basis\", row 2: found the integer 7");
  EXPECT_MESSAGE(torus("gram = [[1,0],[0,1]]\nbasis = [[1,0],[0,1]]"),
                 "x.toml:5:9: both \"gram\" and \"basis\" are given, expected one of them");
}

TEST(ManifoldFile, refuses_matrices_that_are_no_inner_products) {
  EXPECT_MESSAGE(torus("gram = [[1, 0], [\"1/3\", 1]]"),
                 "x.toml:4:18: key \"gram\", row 2, entry 1: found 1/3, expected 0 as in row 1, entry 2");
  EXPECT_MESSAGE(torus("gram = [[0, 0], [0, 1]]"), "found a leading 1 × 1 minor of 0, expected above 0");
  EXPECT_MESSAGE(torus("gram = [[1, 2], [2, 1]]"), "found a leading 2 × 2 minor of -3, expected above 0");
  EXPECT_MESSAGE(torus("gram = [[1, 1], [1, 1]]"), "found a leading 2 × 2 minor of 0");
  EXPECT_MESSAGE(torus("basis = [[1, 2], [2, 4]]"),
                 "x.toml:4:18: key \"basis\", row 2: found a linear combination of the rows before");
  EXPECT_MESSAGE(torus("basis = [[0, 0], [2, 4]]"), "key \"basis\", row 1: found a linear combination");
  // The smallest exact amount on the right side of the border is accepted.
  EXPECT_EQ(message_for(torus("gram = [[1, 1], [1, \"0x100000000000000000001p-80\"]]")), "accepted");
}

TEST(ManifoldFile, refuses_balls_without_a_positive_radius) {
  EXPECT_MESSAGE(ball("radius = 0"), "x.toml:4:10: key \"radius\": found the integer 0, expected a number above 0");
  EXPECT_MESSAGE(ball("radius = \"-1/2\""), "found \"-1/2\", expected a number above 0");
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
