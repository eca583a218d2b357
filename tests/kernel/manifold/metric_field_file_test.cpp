#include "kernel/manifold/metric_field_file.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/kernel/manifold/gluing/samples.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

const std::string head = "name = \"x\"\nfamily = \"metric-field\"\ndimension = 2\nconstant = [[1, 0], [0, \"3/2\"]]\n";

std::string refusal(const std::string& text) {
  return message_of<InputError>([&] { (void)parse_metric_field(text, "x.toml"); });
}
std::string refusal_of_wave(const std::string& wave) { return refusal(head + "waves = [" + wave + "]\n"); }

TEST(MetricFieldFile, reads_constants_and_waves) {
  const auto flat = parse_metric_field(head, "x.toml");
  EXPECT_EQ(flat.name, "x");
  EXPECT_EQ(flat.dimension, Dimension(2));
  EXPECT_EQ(flat.constant[1][1], ratio(3, 2));
  EXPECT_TRUE(flat.waves.empty());
  const auto curved = parse_metric_field(
      head + "waves = [{frequency = [1, -2], sine = [[\"1/4\", \"0x1p-3\"], [\"1/8\", 0]]}]\n", "x.toml");
  ASSERT_EQ(curved.waves.size(), 1U);
  EXPECT_EQ(curved.waves[0].frequency, (std::vector<int>{1, -2}));
  EXPECT_EQ(curved.waves[0].sine[0][1], ratio(1, 8));
  EXPECT_EQ(curved.waves[0].cosine, zero_matrix(2));
}

TEST(MetricFieldFile, says_what_is_wrong_and_where) {
  EXPECT_TRUE(mentions(refusal("name = \n"), "x.toml:1:8: not TOML"));
  EXPECT_EQ(refusal("name = \"x\"\n"), "x.toml:1:1: the key family is missing");
  EXPECT_TRUE(mentions(refusal("family = \"torus\"\n"), "x.toml:1:10: key \"family\": found \"torus\", expected"));
  EXPECT_TRUE(mentions(refusal(head + "gram = 1\n"), "x.toml:5:1: unknown key gram"));
  EXPECT_TRUE(mentions(refusal("name = \"x\"\nfamily = \"metric-field\"\ndimension = 4\n"),
                       "x.toml:3:13: key \"dimension\": found the integer 4, expected an integer from 2 to 3"));
  EXPECT_TRUE(mentions(refusal("name = \"x\"\nfamily = \"metric-field\"\ndimension = 2\nconstant = [[1, 0]]\n"),
                       "key \"constant\": found an array of length 1, expected an array of 2 rows"));
  EXPECT_TRUE(mentions(
      refusal("name = \"x\"\nfamily = \"metric-field\"\ndimension = 2\nconstant = [[1, 0], [2, 1]]\n"),
      "x.toml:4:22: key \"constant\", row 2, entry 1: found the integer 2, expected 0: the matrix is symmetric"));
  EXPECT_TRUE(
      mentions(refusal("name = \"x\"\nfamily = \"metric-field\"\ndimension = 2\nconstant = [[1, 0.5], [0, 1]]\n"),
               "row 1, entry 2: found the floating-point number 0.5, expected an exact number"));
  EXPECT_TRUE(mentions(refusal_of_wave("3"), "wave 1: found the integer 3, expected a table"));
  EXPECT_TRUE(mentions(refusal_of_wave("{frequency = [1], sine = [[1, 0], [0, 1]]}"),
                       "wave 1, frequency: found an array of length 1, expected an array of 2 integers"));
  EXPECT_TRUE(mentions(refusal_of_wave("{frequency = [0, 0], sine = [[1, 0], [0, 1]]}"), "expected one that is not 0"));
  EXPECT_TRUE(mentions(refusal_of_wave("{frequency = [65, 0], sine = [[1, 0], [0, 1]]}"),
                       "wave 1, frequency: found the integer 65, expected an integer from -64 to 64"));
  EXPECT_TRUE(mentions(refusal_of_wave("{frequency = [1, 0]}"), "expected a matrix \"cosine\" or \"sine\""));
  EXPECT_TRUE(mentions(refusal_of_wave("{frequency = [1, 0], tangent = 1}"), "unknown key tangent"));
  EXPECT_TRUE(mentions(refusal_of_wave("{frequency = [1, 0], sine = [[\"1/\", 0], [0, 1]]}"), "wave 1, sine, row 1"));
}

TEST(MetricFieldFile, of_the_torus_of_revolution_is_the_metric_that_space_induces) {
  const auto& files = builtin_metric_fields();
  const auto file = std::find_if(files.begin(), files.end(),
                                 [](const BuiltinManifold& one) { return one.name == "torus-2-of-revolution"; });
  ASSERT_NE(file, files.end());
  const auto field = parse_metric_field(file->text, file->name);
  // u = 2πx, v = 2πy: the derivatives of ((2 + cos v) cos u, (2 + cos v) sin u, sin v), where cos and sin of u and v
  // are those of Pythagorean angles, and cos 2v = 2cos²v - 1.
  for (const auto& [cosine, sine] : {std::pair(ratio(3, 5), ratio(4, 5)), std::pair(ratio(-5, 13), ratio(12, 13)),
                                     std::pair(ratio(1, 1), ratio(0, 1)), std::pair(ratio(0, 1), ratio(-1, 1))}) {
    const Rational cosine_of_u = ratio(8, 17);
    const Rational sine_of_u = ratio(15, 17);
    const Rational ring = Rational(2) + cosine;
    const std::vector<std::vector<Rational>> derivatives{{-ring * sine_of_u, ring * cosine_of_u, Rational(0)},
                                                         {-sine * cosine_of_u, -sine * sine_of_u, cosine}};
    for (std::size_t row = 0; row < 2; ++row) {
      for (std::size_t column = 0; column < 2; ++column) {
        Rational induced(0);
        for (std::size_t axis = 0; axis < 3; ++axis) induced += derivatives[row][axis] * derivatives[column][axis];
        Rational entry = field.constant[row][column];
        for (const auto& wave : field.waves) {
          ASSERT_EQ(wave.frequency[0], 0);
          ASSERT_EQ(wave.sine, zero_matrix(2));
          const Rational cosine_of_wave = wave.frequency[1] == 1 ? cosine : Rational(2) * square(cosine) - Rational(1);
          entry += wave.cosine[row][column] * cosine_of_wave;
        }
        EXPECT_EQ(entry, induced) << row << column;
      }
    }
  }
}

/// A surface by its parameters.
std::string embedded(const std::string& formulas, const std::string& variables = "['u', 'v']") {
  return "name = 'x'\nfamily = 'metric-field'\ndimension = 2\nvariables = " + variables + "\nembedding = [" + formulas +
         "]\n";
}

TEST(MetricFieldFile, knows_the_metric_of_an_embedding) {
  const auto file = std::find_if(builtin_metric_fields().begin(), builtin_metric_fields().end(),
                                 [](const BuiltinManifold& one) { return one.name == "torus-2-of-revolution"; });
  const auto expected = parse_metric_field(file->text, file->name);
  const auto found = parse_metric_field(embedded("'(2 + cos(v))*cos(u)', '(2 + cos(v))*sin(u)', 'sin(v)'"), "x.toml");
  EXPECT_EQ(found.constant, expected.constant);
  ASSERT_EQ(found.waves.size(), expected.waves.size());
  for (std::size_t at = 0; at < found.waves.size(); ++at) {
    EXPECT_EQ(found.waves[at].frequency, expected.waves[at].frequency);
    EXPECT_EQ(found.waves[at].cosine, expected.waves[at].cosine);
    EXPECT_EQ(found.waves[at].sine, expected.waves[at].sine);
  }
  const auto clifford = parse_metric_field(embedded("'cos(u)', 'sin(u)', '2*cos(v)', '2*sin(v)'"), "x.toml");
  EXPECT_TRUE(clifford.waves.empty());
  EXPECT_EQ(clifford.constant, (MetricFieldDescription::Square{{1, 0}, {0, 4}}));
}

TEST(MetricFieldFile, says_what_is_wrong_with_an_embedding) {
  EXPECT_EQ(refusal(embedded("'cos(u)', 'sin(v)*u'")), "x.toml:5:32: the variable u outside of a sine or a cosine");
  EXPECT_TRUE(mentions(refusal(embedded("'cos(u)'")), "expected an array of 2 to 9 formulas"));
  EXPECT_TRUE(mentions(refusal(embedded("'cos(u)', 3")), "expected a formula such as"));
  EXPECT_TRUE(mentions(refusal(embedded("'cos(u)', 'cos(w)'")), "unknown variable w"));
  EXPECT_TRUE(mentions(refusal(embedded("'cos(u)', 'cos(v)'", "['u', 'u']")), "different from the others"));
  EXPECT_TRUE(mentions(refusal(embedded("'cos(u)', 'cos(v)'", "['u']")), "an array of 2 names"));
  EXPECT_TRUE(mentions(refusal(embedded("'cos(50*u)', 'cos(v)'")), "frequencies of at most 64"));
  EXPECT_TRUE(mentions(refusal(embedded("'cos(u)', 'cos(v)'") + "constant = [[1, 0], [0, 1]]\n"), "expected nothing"));
  EXPECT_TRUE(mentions(refusal(head + "variables = ['u', 'v']\n"), "together with an embedding"));
}

TEST(MetricFieldFile, all_built_in_fields_are_metrics_and_known_by_their_names) {
  ASSERT_GE(builtin_metric_fields().size(), 6U);
  for (const auto& builtin : builtin_metric_fields()) {
    const auto description = parse_metric_field(builtin.text, builtin.name);
    EXPECT_EQ(description.name, builtin.name);
    if (description.dimension == Dimension(2)) {
      EXPECT_GT(MetricField<2>(description).eigenvalue_bounds().lower, ratio(1, 4));
    } else {
      EXPECT_GT(MetricField<3>(description).eigenvalue_bounds().lower, ratio(1, 4));
    }
  }
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
