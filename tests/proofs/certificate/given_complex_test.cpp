#include "proofs/certificate/given_complex.hpp"

#include <gtest/gtest.h>

#include "support/error.hpp"
#include "tests/support/complex_texts.hpp"
#include "tests/support/message_of.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

template <int m>
GivenComplex<m> placed(const std::string& text) {
  return place_complex<m>(parse_complex(text, "x.toml"));
}

FieldMatrix product_of(const GivenComplex<2>& given, const InvariantForm& form, std::size_t loop) {
  FieldMatrix product = given.elements[0];
  for (const LoopStep& step : given.complex.loops[loop]) {
    const auto& simplex = given.complex.simplices[step.simplex];
    product = product * form.inverse_of(given.elements[element_at<2>(simplex, step.from)]) *
              given.elements[element_at<2>(simplex, step.to)];
  }
  return product;
}

TEST(GivenComplex, is_moved_to_its_first_labels_with_every_element_once) {
  const std::string text = complex_text("klein-bottle-9");
  const auto given = placed<2>(text);
  EXPECT_TRUE(std::is_sorted(given.complex.simplices.begin(), given.complex.simplices.end()));
  for (const auto& simplex : given.complex.simplices) {
    EXPECT_LT(simplex[0], simplex[1]);
    EXPECT_LT(simplex[1], simplex[2]);
  }
  // The same lifts in other words: e2 g = g e2⁻¹.
  const auto same = placed<2>(replaced(text, "\"g e2^-1 a2\"]", "\"e2 g a2\"]"));
  EXPECT_EQ(same.elements.size(), given.elements.size() + 1) << "the prefix e2 of the word is an element of its own";
  std::set<FieldMatrix, Precedes> different(same.elements.begin(), same.elements.end());
  EXPECT_EQ(different.size(), same.elements.size());
  EXPECT_TRUE(same.without_loop.empty());
}

TEST(GivenComplex, has_loops_along_its_generators) {
  const ComplexDescription description = parse_complex(complex_text("genus-2"), "x.toml");
  const auto given = place_complex<2>(description);
  EXPECT_TRUE(given.without_loop.empty());
  ASSERT_EQ(given.complex.loops.size(), 4U);
  for (std::size_t at = 0; at < 4; ++at)
    EXPECT_TRUE(product_of(given, description.form, at) == description.generators[at]) << at;
}

TEST(GivenComplex, of_a_smaller_group_lacks_a_loop) {
  // h is a square root of the translation e1 that the complex does not have.
  const auto given = placed<2>(complex_text("klein-bottle-9") + "h = [[1, 0, 0], [\"1/2\", 1, 0], [\"1/2\", 0, 1]]\n");
  EXPECT_EQ(given.without_loop, std::vector<std::string>{"h"});
  EXPECT_TRUE(given.complex.loops[1].empty());
  EXPECT_FALSE(given.complex.loops[0].empty());
}

TEST(GivenComplex, refuses_what_is_no_isometry) {
  const auto refusal = [](const std::string& part, const std::string& by) {
    return message_of<Rejection>([&] { (void)placed<2>(replaced(complex_text("klein-bottle-9"), part, by)); });
  };
  EXPECT_TRUE(mentions(refusal("0, -1]]", "0, 2]]"), "klein-bottle-9: generator g: "));
  EXPECT_TRUE(
      mentions(refusal("g = [[1, 0, 0], [\"1/2\", 1, 0], [\"1/6\", 0, -1]]", "g = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]"),
               "generator g is the identity"));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
