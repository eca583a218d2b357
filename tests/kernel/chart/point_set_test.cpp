#include "kernel/chart/point_set.hpp"

#include "tests/kernel/manifold/exhaustive.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

const ExactPoints<2> points{{ratio(1, 3), ratio(-22, 7)},
                            {ratio(1, 4), Rational(0)},
                            {Rational::power_of_two(-300) / Rational(3), Rational(1) + Rational::power_of_two(-60)}};

TEST(PointSet, encloses_its_points_in_the_tightest_intervals) {
  const PointSet<2> set(points);
  ASSERT_EQ(set.size(), points.size());
  for (std::uint32_t index = 0; index < points.size(); ++index) {
    const Label label(index);
    EXPECT_EQ(set.exact(label), points[index]);
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const Filter enclosure = set.enclosure(label)[axis];
      EXPECT_TRUE(contains(enclosure, points[index][axis]));
      EXPECT_GE(std::nextafter(enclosure.lower(), 1e300), enclosure.upper()) << "wider than needed";
    }
  }
}

TEST(PointSet, holds_doubles_as_they_are) {
  const PointSet<2> set(points);
  EXPECT_EQ(set.enclosure(Label(1))[0].lower(), 0.25);
  EXPECT_EQ(set.enclosure(Label(1))[0].upper(), 0.25);
  EXPECT_EQ(set.enclosure(Label(1))[1].upper(), 0);
}

TEST(PointSet, approximates_within_a_unit_in_the_last_place) {
  const PointSet<2> set(points);
  const auto all = set.approximate_all();
  ASSERT_EQ(all.size(), points.size());
  for (std::uint32_t index = 0; index < points.size(); ++index) {
    EXPECT_EQ(all[index], set.approximate(Label(index)));
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const Rational error = absolute(Rational::exactly(all[index][axis]) - points[index][axis]);
      EXPECT_LE(error, absolute(points[index][axis]) * Rational::power_of_two(-52));
    }
  }
}

TEST(PointSet, gives_coordinates_on_every_rung) {
  const PointSet<2> set(points);
  EXPECT_EQ(set.coordinates<Rational>(Label(2)), points[2]);
  const auto big = set.coordinates<BigInterval>(Label(2));
  for (std::size_t axis = 0; axis < 2; ++axis) {
    EXPECT_TRUE(contains(big[axis], points[2][axis]));
    EXPECT_LE(big[axis].upper() - big[axis].lower(), Rational::power_of_two(-120));
  }
  EXPECT_EQ(set.coordinates<Filter>(Label(0))[0].upper(), set.enclosure(Label(0))[0].upper());
}

TEST(PointSet, replaces_one_point_and_its_enclosure) {
  PointSet<2> set(points);
  const Vector<Rational, 2> place{ratio(2, 3), Rational(5)};
  {
    const FilterGuard guard;
    set.place(Label(1), place);
  }
  EXPECT_EQ(set.exact(Label(1)), place);
  EXPECT_TRUE(contains(set.enclosure(Label(1))[0], place[0]));
  EXPECT_EQ(set.enclosure(Label(1))[1].lower(), 5);
  EXPECT_EQ(set.exact(Label(0)), points[0]);
  EXPECT_EQ(PointSet<2>().size(), 0U);
}

TEST(PointSet, keeps_apart_what_is_no_double_and_copies_it) {
  PointSet<2> set(points);
  const PointSet<2> copy = set;
  {
    const FilterGuard guard;
    set.place(Label(0), {Rational(1), Rational(2)});
    set.place(Label(1), {ratio(1, 3), Rational(2)});
  }
  EXPECT_EQ(set.exact(Label(0)), (Vector<Rational, 2>{Rational(1), Rational(2)})) << "a double in place of a fraction";
  EXPECT_EQ(set.exact(Label(1)), (Vector<Rational, 2>{ratio(1, 3), Rational(2)})) << "a fraction in place of a double";
  for (std::uint32_t index = 0; index < points.size(); ++index) EXPECT_EQ(copy.exact(Label(index)), points[index]);
  // Next to a double, and beyond the ends of their range.
  const ExactPoints<2> close{{Rational(1) + Rational::power_of_two(-200), Rational::power_of_two(-1080)},
                             {Rational::power_of_two(2000), Rational::power_of_two(-1074)}};
  const PointSet<2> other(close);
  for (std::uint32_t index = 0; index < close.size(); ++index) EXPECT_EQ(other.exact(Label(index)), close[index]);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
