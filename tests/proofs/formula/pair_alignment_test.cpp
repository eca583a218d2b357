#include "proofs/formula/pair_alignment.hpp"

#include "properties/instances/choices.hpp"
#include "tests/proofs/formula/vocabulary_checks.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

using Points = SimplexObject::Points;

Points random_points(std::size_t count, std::size_t dimension, Choices& choices) {
  Points points(count);
  for (auto& each : points) {
    for (std::size_t axis = 0; axis < dimension; ++axis) each.push_back(choices.symmetric(12));
  }
  return points;
}

/// |x|² of the difference of two edges from vertex 0.
Rational squared_gap(const Points& a, const Points& b, std::size_t i) {
  Rational result(0);
  for (std::size_t axis = 0; axis < a[0].size(); ++axis) {
    result += square((a[i][axis] - a[0][axis]) - (b[i][axis] - b[0][axis]));
  }
  return result;
}

template <class S>
Partial<Alignment<S>> aligned(const Points& before, const Points& after) {
  const Bindings none;
  Scene scene(none);
  Evaluation<S> evaluation(scene);
  return alignment(evaluation, SimplexObject(before), SimplexObject(after));
}

TEST(PairAlignment, OfAMovedCopyIsNearlyNothingOnEveryRung) {
  RandomChoices choices(1, 1, 0);
  const Points before = random_points(4, 3, choices);
  Points after = before;
  // A rotation of the first two axes by (3/5, 4/5), then a tiny displacement of one vertex.
  for (auto& each : after) {
    const auto old = each;
    each[0] = ratio(3, 5) * old[0] - ratio(4, 5) * old[1];
    each[1] = ratio(4, 5) * old[0] + ratio(3, 5) * old[1];
  }
  after[2][0] += Rational::power_of_two(-20);
  {
    const RoundingGuard guard;
    const auto found = aligned<Interval>(before, after);
    ASSERT_TRUE(found.has_value());
    // The rotation itself leaves 2⁻²⁰; the polar factor does about as well.
    EXPECT_LT(found->matrix_error.upper(), 0x1p-17);
    EXPECT_GT(found->matrix_error.upper(), 0x1p-24);
    EXPECT_LE(found->vertex_error.upper(), found->matrix_error.upper() * 1.5);
  }
  after[2][0] += Rational::power_of_two(-300) - Rational::power_of_two(-20);
  const BigInterval::Precision precision(PrecisionBits{512});
  const auto found = aligned<BigInterval>(before, after);
  ASSERT_TRUE(found.has_value());
  EXPECT_LT(found->matrix_error.upper(), Rational::power_of_two(-296));
}

TEST(PairAlignment, IsNeverAboveAnIsometryAtHandByMuchNorBelowWhatAllNeed) {
  // The identity is an isometry: the least error is at most its error, and the polar factor loses at most a factor.
  for (std::uint32_t number = 0; number < 40; ++number) {
    RandomChoices choices(1, 2, number);
    const std::size_t k = 1 + number % 5;
    const Points before = random_points(k + 1, k, choices);
    Points after = before;
    for (auto& each : after) {
      for (Rational& coordinate : each) coordinate += choices.symmetric(8) * Rational::power_of_two(-6);
    }
    Rational frobenius(0);
    for (std::size_t i = 1; i <= k; ++i) frobenius += squared_gap(before, after, i);
    const RoundingGuard guard;
    const auto found = aligned<Interval>(before, after);
    if (!found) continue;
    const auto bound = scalar_from<Interval>(frobenius);
    // Whatever holds for all isometries holds for the identity.
    EXPECT_LE(found->matrix_error.lower(), square_root(bound).upper());
    EXPECT_LE(found->matrix_error.lower(), found->matrix_error.upper());
    EXPECT_LE(found->vertex_error.lower(), found->matrix_error.upper());
  }
}

TEST(PairAlignment, ServesDegenerateImagesAboveTheFilter) {
  const Rational zero(0);
  const Points before{{zero, zero}, {Rational(1), zero}, {zero, Rational(1)}};
  const Points after{{zero, zero}, {Rational(1), zero}, {Rational(1), zero}};
  const RoundingGuard guard;
  EXPECT_EQ(aligned<Interval>(before, after).exists(), Verdict::undecided);
  const auto found = aligned<BigInterval>(before, after);
  ASSERT_TRUE(found.has_value());
  // Every isometry maps the unit axes a distance of √2 apart: some vertex is √2/2 off at least.
  EXPECT_GT(found->matrix_error.upper(), ratio(7, 10));
  EXPECT_LT(found->matrix_error.upper(), Rational(2));
}

TEST(PairAlignment, OfEdgesIsTheDifferenceOfLengthsOnEveryRung) {
  const Points before{{Rational(0)}, {Rational(3)}};
  const Points after{{Rational(1)}, {Rational(-1)}};
  {
    const RoundingGuard guard;
    const auto found = aligned<Interval>(before, after);
    EXPECT_LE(found->matrix_error.lower(), 1);
    EXPECT_GE(found->matrix_error.upper(), 1);
    EXPECT_LT(found->matrix_error.upper() - found->matrix_error.lower(), 0x1p-40);
  }
  EXPECT_EQ(is_zero(Algebraic(aligned<Algebraic>(before, after)->matrix_error - Algebraic(1))), Verdict::proved);
  EXPECT_EQ(aligned<Surd>(before, after).exists(), Verdict::undecided);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
