#include "kernel/manifold/submanifold/chord_bend.hpp"

#include <cmath>
#include <functional>
#include <numbers>

#include "kernel/number/rounding_guard.hpp"
#include "tests/kernel/manifold/submanifold/samples.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

using Place = std::array<double, 3>;

/// Points of a surface, and their distance along it.
struct Pair {
  const char* name;
  ZeroSet surface;
  Place x, y;
  double distance;
};

std::vector<Pair> pairs() {
  const ZeroSet torus = torus_of_revolution();
  const std::vector<Rational> box(3, Rational(4));
  const ZeroSet cylinder = zero_set("cylinder", {"x", "y", "z"}, {"x^2 + y^2 - 1"}, box);
  const ZeroSet weighted = zero_set("sphere", {"x", "y", "z"}, {"(x^2 + y^2 + z^2 - 1)*(3 + y - z)"}, box);
  std::vector<Pair> result;
  for (const double t : {0.02, 0.05, 0.1, 0.2}) {
    const double c = std::cos(t), s = std::sin(t);
    result.push_back({"sphere", unit_sphere_in_space(), {0, 0, 1}, {s, 0, c}, t});
    result.push_back({"sphere by another function", weighted, {0, 0, 1}, {0, s, c}, t});
    result.push_back({"cylinder", cylinder, {1, 0, 0}, {c, s, 0.75 * t}, 1.25 * t});
    result.push_back({"outer circle", torus, {3, 0, 0}, {3 * c, 3 * s, 0}, 3 * t});
    result.push_back({"inner circle", torus, {1, 0, 0}, {c, s, 0}, t});
    result.push_back({"meridian", torus, {2, 0, 1}, {2 + s, 0, c}, t});
  }
  return result;
}

struct Chord {
  std::array<Interval, 3> from, to, chord;

  Chord(const Pair& pair, double half) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      from[axis] = Interval::between(pair.x[axis] - half, pair.x[axis] + half);
      to[axis] = Interval::between(pair.y[axis] - 1e-14, pair.y[axis] + 1e-14);
      chord[axis] = to[axis] - from[axis];
    }
  }
  [[nodiscard]] std::optional<ChordBend> bend(const ZeroSet& surface) const {
    FormulaEvaluation<Interval> f(surface.map());
    return bend_about_chords(surface, f, from.data(), to.data());
  }
};

TEST(ChordBend, bounds_distances_in_spheres_cylinders_and_tori) {
  for (const Pair& pair : pairs()) {
    const double length = std::hypot(pair.y[0] - pair.x[0], pair.y[1] - pair.x[1], pair.y[2] - pair.x[2]);
    const double more = pair.distance - length;
    const double error = 1e-13;
    const RoundingGuard guard;
    const Chord at(pair, 1e-14);
    auto bend = at.bend(pair.surface);
    ASSERT_TRUE(bend) << pair.name;
    const ChordExcess excess = bend->excess(at.chord.data());
    EXPECT_LE(excess.least, more + error) << pair.name;
    EXPECT_GE(excess.most, more - error) << pair.name;
    if (length > 0.25) continue;
    EXPECT_LT(excess.most - excess.least, 8 * length * more + error) << pair.name << ' ' << length;
    // The same with D²f that is too small, or too great.
    if (length > 0.1) continue;
    const Dense<Interval> second = bend->second;
    for (Interval& entry : bend->second) entry *= Interval::exactly(1 - 8 * length);
    EXPECT_LT(bend->excess(at.chord.data()).most, more) << pair.name;
    for (std::size_t k = 0; k < second.size(); ++k) bend->second[k] = second[k] * Interval::exactly(1 + 8 * length);
    EXPECT_GT(bend->excess(at.chord.data()).least, more) << pair.name;
  }
}

TEST(ChordBend, holds_for_all_chords_from_a_box) {
  for (const Pair& pair : pairs()) {
    const double length = std::hypot(pair.y[0] - pair.x[0], pair.y[1] - pair.x[1], pair.y[2] - pair.x[2]);
    if (length > 0.25) continue;
    const RoundingGuard guard;
    const Chord box(pair, length / 32);
    const Chord one(pair, 1e-14);
    const auto bend = box.bend(pair.surface);
    ASSERT_TRUE(bend) << pair.name;
    const ChordExcess of_all = bend->excess(box.chord.data());
    // Of one chord, by what is known about all, and by what is known about it.
    for (const ChordExcess& excess :
         {bend->excess(one.chord.data()), one.bend(pair.surface)->excess(one.chord.data())}) {
      EXPECT_LE(of_all.least, excess.least) << pair.name;
      EXPECT_GE(of_all.most, excess.most) << pair.name;
    }
    EXPECT_GT(of_all.least, 0) << pair.name;
    EXPECT_LT(of_all.most, length) << pair.name;
  }
}

TEST(ChordBend, is_what_the_lemma_says) {
  const RoundingGuard guard;
  ChordBend bend;
  for (const double entry : {2.0, 0.5, 1.0, 0.5, -1.0, 0.25, 1.0, 0.25, 4.0})
    bend.second.push_back(Interval::exactly(entry));
  bend.gradient = {Interval::exactly(0.125), Interval(0), Interval(4)};
  bend.room = 0.01;
  bend.beside = 0.005;
  std::array<Interval, 3> chord{Interval::exactly(0.125), Interval(0), Interval(0)};
  const double c = 0.125, curved = 2, beta = std::hypot(0.5, 1), size = std::hypot(0.125, 4), off = 0.015;
  const Place bent = {2, 0.5, 1};               // D²f·u
  const Place tilted = {4.25, 1.0625, 16.125};  // D²f·n
  const auto norm = [](const Place& x) { return std::hypot(x[0], x[1], x[2]); };
  const double turn = 0.125 * bent[0] + 4 * bent[2];
  const double gamma =
      (size * size - turn * c / 2 - off * norm(tilted)) / size - 0.125 / size * (curved * c / 2 + beta * 0.01);
  const double all = std::sqrt(4 + 1 + 16 + 2 * (0.25 + 1 + 0.0625));
  const double steepest = std::sqrt(size * size + turn * c + c * c * norm(bent) * norm(bent) / 4) + off * all;
  const double above = curved * c / std::sqrt(12.0) / (gamma - beta * c / std::numbers::pi);
  const double below =
      curved * c / std::sqrt(12.0) / (steepest + beta * c * (1 + above * above / 2) / std::numbers::pi);
  const ChordExcess excess = bend.excess(chord.data());
  EXPECT_NEAR(excess.most / (c * above * above / 2), 1, 1e-5);
  EXPECT_NEAR(excess.least / (c * below * below / 2), 1, 1e-5);
  bend.second[0] = Interval::between(-2, 1);
  EXPECT_EQ(bend.excess(chord.data()).least, 0);
  const auto is_bounded = [&] { return bend.excess(chord.data()).most < std::numeric_limits<double>::infinity(); };
  EXPECT_TRUE(is_bounded());
  bend.room = 0.0020;  // a quarter of A′c² needs more
  EXPECT_FALSE(is_bounded());
  bend.room = 0.126;  // more than the chord
  EXPECT_FALSE(is_bounded());
  bend.room = 0.01;
  bend.gradient = {Interval(0), Interval(0), Interval::exactly(0.2)};
  EXPECT_FALSE(is_bounded());
  bend.gradient = {Interval(0), Interval(0), Interval(4)};
  chord[0] = Interval::between(-0.01, 0.01);
  EXPECT_FALSE(is_bounded());
}

TEST(ChordBend, asks_for_one_function_that_is_known_and_a_box_around) {
  const RoundingGuard guard;
  const Pair pair = pairs().front();
  const Chord at(pair, 1e-14);
  EXPECT_TRUE(at.bend(pair.surface));
  const std::vector<Rational> wide(3, Rational(2));
  const std::vector<Rational> narrow(3, Rational(1));
  EXPECT_FALSE(at.bend(zero_set("sphere", {"x", "y", "z"}, {"x^2 + y^2 + z^2 - 1"}, narrow)));
  EXPECT_FALSE(at.bend(zero_set("root", {"x", "y", "z"}, {"x^2 + y^2 + z^2 - 1 + sqrt(1 - z)"}, wide)));
  EXPECT_FALSE(at.bend(zero_set("circle", {"x", "y", "z"}, {"x^2 + y^2 + z^2 - 1", "y"}, wide)));
  EXPECT_FALSE(Chord(pair, 0.01).bend(zero_set("point", {"x", "y", "z"}, {"x^2 + y^2 + (z - 1)^2"}, wide)));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
