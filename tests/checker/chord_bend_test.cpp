#include "proofs/checker/submanifolds/chord_bend.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "tests/checker/upwards.hpp"

namespace delcert::checker_tests {
namespace {

using namespace checker;
using Place = std::array<double, 3>;

Interval around(double x, double half) { return Interval::between(x - half, x + half); }

Matrix<Interval> box_around(const Place& x, double half) {
  Matrix<Interval> result(3, 1);
  for (std::size_t k = 0; k < 3; ++k) result[k] = around(x[k], half);
  return result;
}

/// A surface and arcs in it that are shortest, by the turn in one direction and in another.
struct Surface {
  const char* name;
  const char* formula;
  std::function<Place(double, double)> place;
  std::function<double(double, double)> length;  // from (0, 0)
};

double angle(double turn, double radius) { return std::abs(turn) * radius; }

const Surface surfaces[] = {
    {"sphere", "x^2+y^2+z^2-1",
     [](double a, double b) {
       return Place{std::cos(a) * std::cos(b), std::sin(a) * std::cos(b), std::sin(b)};
     },
     [](double a, double b) { return std::acos(std::cos(a) * std::cos(b)); }},
    {"sphere by another function", "(x^2+y^2+z^2-1)*(3+y-z)",
     [](double a, double b) {
       return Place{std::cos(a) * std::cos(b), std::sin(a) * std::cos(b), std::sin(b)};
     },
     [](double a, double b) { return std::acos(std::cos(a) * std::cos(b)); }},
    {"cylinder", "x^2+y^2-1",
     [](double a, double b) {
       return Place{std::cos(a), std::sin(a), b};
     },
     [](double a, double b) { return std::hypot(a, b); }},
    {"outer circle of a torus", "(x^2+y^2+z^2+3)^2-16*(x^2+y^2)",
     [](double a, double b) {
       return Place{3 * std::cos(a + b), 3 * std::sin(a + b), 0};
     },
     [](double a, double b) { return angle(a + b, 3); }},
    {"meridian of a torus", "(x^2+y^2+z^2+3)^2-16*(x^2+y^2)",
     [](double a, double b) {
       return Place{2 + std::cos(1 + a + b), 0, std::sin(1 + a + b)};
     },
     [](double a, double b) { return angle(a + b, 1); }},
    {"inner circle of a torus", "(x^2+y^2+z^2+3)^2-16*(x^2+y^2)",
     [](double a, double b) {
       return Place{std::cos(a + b), std::sin(a + b), 0};
     },
     [](double a, double b) { return angle(a + b, 1); }},
};

std::vector<std::array<Quantity, 2>> box_of(int half) {
  return {3, {Quantity(Rational(-half)), Quantity(Rational(half))}};
}

/// Chords from points of the surface whose coordinates differ by at most so much from those of place (0, 0).
struct Chords {
  FormulaMap map;
  FormulaValues<Interval> values{map};
  Matrix<Interval> from, to;
  std::optional<ChordBend> bend;

  Chords(const Surface& surface, double a, double b, double half, int half_of_box = 4)
      : map({"x", "y", "z"}, {surface.formula}),
        from(box_around(surface.place(0, 0), half)),
        to(box_around(surface.place(a, b), 1e-14)),
        bend(bend_about_chords(box_of(half_of_box), values, from, to)) {}
  ChordExcess excess() const { return bend->excess(to - from); }
};

double length_of_chord(const Place& x, const Place& y) { return std::hypot(y[0] - x[0], y[1] - x[1], y[2] - x[2]); }

struct ChordBendOfChecker : testing::Test, test::Upwards {};

constexpr std::array<std::array<double, 2>, 5> turns = {
    {{0.02, 0.01}, {0.05, -0.03}, {0, 0.1}, {0.08, 0.1}, {-0.2, 0.05}}};

TEST_F(ChordBendOfChecker, bounds_distances_in_spheres_cylinders_and_tori) {
  for (const Surface& surface : surfaces) {
    for (const auto& [a, b] : turns) {
      const Chords chords(surface, a, b, 1e-14);
      ASSERT_TRUE(chords.bend) << surface.name;
      const double chord = length_of_chord(surface.place(0, 0), surface.place(a, b));
      const double more = surface.length(a, b) - chord, error = 1e-13;
      const ChordExcess excess = chords.excess();
      EXPECT_LE(excess.least, more + error) << surface.name;
      EXPECT_GE(excess.most, more - error) << surface.name;
      // They differ by a part that falls with the chord.
      if (chord > 0.25) continue;
      EXPECT_LT(excess.most - excess.least, 8 * chord * more + error) << surface.name << ' ' << a;
      // Were it bent a little more or less, the distance would not be between them.
      if (chord > 0.1 || !(more > 0)) continue;
      ChordBend other = *chords.bend;
      other.second = (Interval(1) - Interval(8) * around(chord, 0)) * other.second;
      EXPECT_LT(other.excess(chords.to - chords.from).most, more) << surface.name << ' ' << a;
      other.second = (Interval(1) + Interval(8) * around(chord, 0)) * chords.bend->second;
      EXPECT_GT(other.excess(chords.to - chords.from).least, more) << surface.name << ' ' << a;
    }
  }
}

TEST_F(ChordBendOfChecker, holds_for_all_chords_from_a_box) {
  for (const Surface& surface : surfaces) {
    const double half = 0.004;
    const Chords chords(surface, 0.06, 0.05, half);
    ASSERT_TRUE(chords.bend) << surface.name;
    const ChordExcess excess = chords.excess();
    EXPECT_GT(excess.least, 0);
    for (const double s : {-1.0, -0.5, 0.0, 0.75, 1.0}) {
      const double at = s * half / 3;
      const double chord = length_of_chord(surface.place(at, 0), surface.place(0.06, 0.05));
      const double more = surface.length(0.06 - at, 0.05) - chord;
      EXPECT_LT(excess.least, more) << surface.name;
      EXPECT_GT(excess.most, more) << surface.name;
    }
  }
}

/// A bend that some function might have, of which all is known exactly.
struct KnownBend {
  ChordBend bend;
  Matrix<Interval> chord{3, 1};

  KnownBend() {
    constexpr std::array<std::array<double, 3>, 3> second = {{{2, 0.5, 1}, {0.5, -1, 0.25}, {1, 0.25, 4}}};
    bend.second = Matrix<Interval>(3, 3);
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t l = 0; l < 3; ++l) bend.second(k, l) = around(second[k][l], 0);
    }
    bend.gradient = box_around({0.125, 0, 4}, 0);
    bend.room = 0.01;
    bend.beside = 0.005;
    chord = box_around({0.125, 0, 0}, 0);
  }
};

TEST_F(ChordBendOfChecker, is_what_the_lemma_says) {
  const KnownBend known;
  const double c = 0.125, A = 2, beta = std::hypot(0.5, 1), size = std::hypot(0.125, 4), off = 0.015;
  // D^2 f times u, and times n.
  const Place bent = {2, 0.5, 1}, tilted = {0.25 + 4, 0.0625 + 1, 0.125 + 16};
  const auto norm = [](const Place& x) { return std::hypot(x[0], x[1], x[2]); };
  const double rise = (size * size - (0.125 * bent[0] + 4 * bent[2]) * c / 2 - off * norm(tilted)) / size;
  const double gamma = rise - 0.125 / size * (A * c / 2 + beta * 0.01), pi = std::numbers::pi;
  const double all = std::sqrt(4 + 1 + 16 + 2 * (0.25 + 1 + 0.0625));
  const double steepest =
      std::sqrt(size * size + (0.125 * bent[0] + 4 * bent[2]) * c + c * c * norm(bent) * norm(bent) / 4) + off * all;
  const double above = A * c / std::sqrt(12.0) / (gamma - beta * c / pi);
  const double below = A * c / std::sqrt(12.0) / (steepest + beta * c * (1 + above * above / 2) / pi);
  const ChordExcess excess = known.bend.excess(known.chord);
  EXPECT_NEAR(excess.most / (c * above * above / 2), 1, 1e-5);
  EXPECT_NEAR(excess.least / (c * below * below / 2), 1, 1e-5);
  EXPECT_GE(excess.most, c * above * above / 2);
  EXPECT_LE(excess.least, c * below * below / 2);
  // Of an interval of derivatives, the nearest to 0 and the farthest; nothing at least if 0 is in it.
  KnownBend wide;
  wide.bend.second(0, 0) = Interval::between(1, 2);
  EXPECT_NEAR(wide.bend.excess(wide.chord).least / excess.least, 0.25, 0.01);
  EXPECT_NEAR(wide.bend.excess(wide.chord).most / excess.most, 1, 0.03);
  wide.bend.second(0, 0) = Interval::between(-2, 1);
  EXPECT_EQ(wide.bend.excess(wide.chord).least, 0);
  EXPECT_NEAR(wide.bend.excess(wide.chord).most / excess.most, 1, 0.1);
}

TEST_F(ChordBendOfChecker, compares_distances_by_their_chords) {
  // Along M the distances are between chord + least and chord + most: they compare as the leads of the chords say.
  const double p = 2, p_most = 0.5, q_least = 0.25;
  const Distance near{p, {0.125, p_most}};
  const double needed = least_lead(near, {q_least, 1});
  for (const double q : {2.0, 2.24, 2.26, 2.5}) EXPECT_EQ(q * q - p * p > needed, q + q_least > p + p_most) << q;
  // In R^N as well.
  EXPECT_EQ(least_lead(near, {0.75, 1}), 0);
  EXPECT_EQ(least_lead({p, {}}, {q_least, 1}), std::numeric_limits<double>::infinity());
}

TEST_F(ChordBendOfChecker, knows_distances_of_what_a_chart_shows) {
  // A circle of radius 1 over [-0.5, 0.5], which is as steep as 1/sqrt 3 at the ends; its slopes have a rate of 1.54.
  const ChartBend chart{std::sqrt(4.0 / 3) + 1e-15, 1.5396008};
  for (const double a : {-0.5, -0.1, 0.3}) {
    for (const double b : {-0.4, 0.0, 0.5}) {
      const double turned = std::abs(std::asin(b) - std::asin(a)), chord = 2 * std::sin(turned / 2);
      const Distance known = chart.distance(around((b - a) * (b - a), 1e-15), true);
      EXPECT_GE(known.chord, chord);
      EXPECT_LE(known.chord, 1.16 * std::abs(b - a) + 1e-6);
      EXPECT_EQ(known.excess.least, 0);
      EXPECT_GE(known.excess.most, turned - chord - 1e-13);
      EXPECT_LE(known.excess.most, std::min(0.16 * std::abs(b - a), chart.excess(std::abs(b - a))) + 1e-6);
    }
  }
  EXPECT_NEAR(chart.excess(0.5), 0.25 / 2 * 0.5 * 1.5396008 * 1.5396008 / 12, 1e-7);
  EXPECT_NEAR((ChartBend{1.25, 0, 0.5}.excess(0.5)), 0.0625, 1e-12);
  // Where slopes are said not to change there is no excess; of slopes that change much, what the stretch says.
  EXPECT_NEAR((ChartBend{1.25}.distance(Interval(4), true).excess.most), 0, 1e-12);
  EXPECT_NEAR((ChartBend{1.25, 100}.distance(Interval(4), true).excess.most), 0.5, 1e-12);
}

TEST_F(ChordBendOfChecker, knows_nothing_of_distances_to_what_a_chart_does_not_show) {
  // Another sheet may be over the same place, as far away as it likes.
  const ChartBend chart{1.25, 1, 1};
  for (const double place : {0.0, 0.01, 1.0}) {
    const Distance unknown = chart.distance(Interval::between(place, place), false);
    EXPECT_EQ(unknown.chord, std::numeric_limits<double>::infinity());
    EXPECT_EQ(unknown.excess.most, std::numeric_limits<double>::infinity());
    EXPECT_EQ(unknown.excess.least, 0);
    EXPECT_EQ(least_lead(unknown, {0, 0}), std::numeric_limits<double>::infinity());
    EXPECT_LT(chart.distance(Interval::between(place, place), true).chord, 1.26);
  }
}

TEST_F(ChordBendOfChecker, says_nothing_where_a_curve_might_leave) {
  const auto says = [](const KnownBend& known) {
    return known.bend.excess(known.chord).most < std::numeric_limits<double>::infinity();
  };
  KnownBend known;
  EXPECT_TRUE(says(known));
  // A c^2 / 4 <= (gamma - beta c / 2) h, with gamma about 3.5.
  known.bend.room = 0.0024;
  EXPECT_TRUE(says(known));
  known.bend.room = 0.0020;
  EXPECT_FALSE(says(known));
  known.bend.room = 0.126;  // more than the chord
  EXPECT_FALSE(says(known));
  known.bend.room = 0.01;
  known.bend.gradient = box_around({0, 0, 0.2}, 0);  // a curve might not be a graph over the chord
  EXPECT_FALSE(says(known));
  KnownBend point;
  point.chord[0] = around(0, 0.01);
  EXPECT_FALSE(says(point));
}

TEST(ReachOfBends, is_all_of_the_disc_and_no_more_than_the_chart_shows) {
  EXPECT_EQ(reach_of_bends(1, 10), 2);
  EXPECT_EQ(reach_of_bends(1, 1.5), 1.5 * 0.999);
  for (const double shown : {1.0002, 1.0009, 1.002}) {
    EXPECT_GE(reach_of_bends(1, shown), 1);
    EXPECT_LT(reach_of_bends(1, shown), shown);
  }
}

TEST_F(ChordBendOfChecker, asks_that_the_function_is_known_and_the_box_is_left_by_none) {
  const Surface& sphere = surfaces[0];
  EXPECT_TRUE(Chords(sphere, 0.1, 0, 1e-14, 2).bend);
  EXPECT_FALSE(Chords(sphere, 0.1, 0, 1e-14, 1).bend);  // the ends are within 1, but not all points as near
  Surface other = sphere;
  other.formula = "x^2+y^2+z^2-1+(sqrt(1-x)-sqrt(1-x))";
  EXPECT_FALSE(Chords(other, 0.1, 0, 1e-14).bend);
  other.formula = "(x-1)^2+y^2+z^2";
  EXPECT_FALSE(Chords(other, 0.02, 0, 0.01).bend);
}

}  // namespace
}  // namespace delcert::checker_tests
