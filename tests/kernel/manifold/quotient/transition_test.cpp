#include "kernel/manifold/quotient/transition.hpp"

#include <gtest/gtest.h>

#include "kernel/manifold/quotient/space_form_families.hpp"
#include "kernel/manifold/space_form_file.hpp"
#include "kernel/number/rounding_guard.hpp"
#include "tests/kernel/manifold/quotient/samples.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

Vector<Rational, 2> point(long x, long y) { return {ratio(x, 64), ratio(y, 64)}; }

template <std::size_t n>
std::array<BigInterval, n> enclosed(const std::array<Rational, n>& x) {
  std::array<BigInterval, n> result;
  for (std::size_t axis = 0; axis < n; ++axis) result[axis] = BigInterval(x[axis]);
  return result;
}

template <std::size_t n>
void expect_same(const std::array<BigInterval, n>& a, const std::array<BigInterval, n>& b) {
  for (std::size_t axis = 0; axis < n; ++axis) {
    EXPECT_FALSE(is_proved(less(a[axis], b[axis])));
    EXPECT_FALSE(is_proved(less(b[axis], a[axis])));
    EXPECT_LE(a[axis].upper() - a[axis].lower(), Rational::power_of_two(-80));
    EXPECT_LE(b[axis].upper() - b[axis].lower(), Rational::power_of_two(-80));
  }
}

TEST(Transition, of_the_same_chart_by_the_identity_is_the_identity) {
  for (const Curvature curvature : {Curvature::negative, Curvature::zero, Curvature::positive}) {
    const auto form = InvariantForm::standard(curvature, 2);
    const auto matrix = transition_matrix<2>(form, FieldMatrix::identity(3), point(20, -7), point(20, -7));
    const auto v = enclosed(point(9, 5));
    expect_same(carried<BigInterval, 2>(curvature, matrix, v), v);
  }
}

TEST(Transition, takes_the_centre_of_a_chart_to_where_it_is_seen) {
  // The centre of the chart of i is v = 0; the chart of o sees it at exp_o⁻¹ p_i.
  for (const Curvature curvature : {Curvature::negative, Curvature::zero, Curvature::positive}) {
    const auto form = InvariantForm::standard(curvature, 2);
    const auto matrix = transition_matrix<2>(form, FieldMatrix::identity(3), point(20, -7), point(0, 0));
    expect_same(carried<BigInterval, 2>(curvature, matrix, enclosed(point(0, 0))),
                logarithm_of_conformal<BigInterval, 2>(curvature, enclosed(point(20, -7))));
  }
}

TEST(Transition, composes) {
  // i → j through γ, then j → k through δ, is i → k through δγ.
  for (const std::string name : {"bolza-surface", "projective-plane", "klein-bottle", "klein-quartic"}) {
    const auto description = find_space_form(name);
    const FieldMatrix& gamma = description.generators.front();
    const FieldMatrix& delta = description.generators.back();
    const Curvature curvature = description.form.curvature();
    const auto i = point(3, 8);
    const auto j = point(-11, 2);
    const auto k = point(6, -5);
    const auto first = transition_matrix<2>(description.form, gamma, i, j);
    const auto second = transition_matrix<2>(description.form, delta, j, k);
    const auto both = transition_matrix<2>(description.form, delta * gamma, i, k);
    const auto v = enclosed(point(2, 1));
    const auto seen = carried<BigInterval, 2>(curvature, first, v);
    expect_same(carried<BigInterval, 2>(curvature, second, seen), carried<BigInterval, 2>(curvature, both, v));
  }
}

TEST(Transition, enclosures_in_doubles_contain_those_of_the_next_rung) {
  const auto description = find_space_form("seifert-weber-space");
  const Vector<Rational, 3> i{ratio(1, 3), ratio(1, 8), ratio(-1, 5)};
  const Vector<Rational, 3> j{ratio(1, 4), ratio(1, 9), ratio(0, 1)};
  const Vector<Rational, 3> v{ratio(1, 100), ratio(-1, 50), ratio(1, 70)};
  const auto big = transition_matrix<3>(description.form, description.generators[0], i, j);
  const auto exact = carried<BigInterval, 3>(Curvature::negative, big, enclosed(v));
  const RoundingGuard guard;
  Vector<Interval, 3> small_v;
  for (std::size_t axis = 0; axis < 3; ++axis) small_v[axis] = scalar_from<Interval>(v[axis]);
  const auto small = carried<Interval, 3>(Curvature::negative, in_doubles<3>(big), small_v);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    EXPECT_LE(Rational::exactly(small[axis].lower()), exact[axis].lower());
    EXPECT_GE(Rational::exactly(small[axis].upper()), exact[axis].upper());
    EXPECT_LE(small[axis].upper() - small[axis].lower(), 0x1p-42);
  }
}

TEST(Transition, is_an_isometry_of_distances_but_not_of_charts) {
  // The distance of two carried points from the centre of a chart is their distance from it in the manifold; straight
  // lengths between them change, which is the distortion.
  const auto form = InvariantForm::standard(Curvature::positive, 2);
  const auto matrix = transition_matrix<2>(form, FieldMatrix::identity(3), point(16, 0), point(0, 16));
  const auto a = carried<BigInterval, 2>(Curvature::positive, matrix, enclosed(point(3, 5)));
  const auto b = carried<BigInterval, 2>(Curvature::positive, matrix, enclosed(point(-4, 6)));
  const BigInterval seen = detail::sum_of_squares(difference(a, b));
  const BigInterval home = detail::sum_of_squares(difference(enclosed(point(3, 5)), enclosed(point(-4, 6))));
  EXPECT_TRUE(is_refuted(less(seen, home)) || is_proved(less(seen, home)));
  EXPECT_TRUE(is_proved(less(absolute(seen - home), home / BigInterval(8))));
  const auto metric = FrameMetric<2>::cartesian().on<BigInterval>();
  const auto chord = [&](const Vector<BigInterval, 2>& x, const Vector<BigInterval, 2>& y) {
    return squared_chord<BigInterval, 2>(Curvature::positive, metric,
                                         exponential<BigInterval, 2>(Curvature::positive, x),
                                         exponential<BigInterval, 2>(Curvature::positive, y));
  };
  EXPECT_TRUE(is_undecided(less(chord(a, b), chord(enclosed(point(3, 5)), enclosed(point(-4, 6))))));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
