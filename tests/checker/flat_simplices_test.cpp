#include "proofs/checker/core/flat_simplices.hpp"

#include <gtest/gtest.h>

#include <random>

#include "proofs/checker/core/around_simplex.hpp"
#include "proofs/checker/parts/chunk_items.hpp"
#include "tests/checker/core_samples.hpp"
#include "tests/checker/support/exact_double.hpp"
#include "tests/checker/upwards.hpp"

namespace delcert::checker_tests::by_hand {
namespace {

namespace core = checker::core;
using checker::Interval;
using checker::Rational;
using checker::Verdict;

struct FlatSimplices : testing::Test {
  const test::Upwards upwards;
};

constexpr double unbounded = std::numeric_limits<double>::infinity();

/// The quantities of a simplex, without rounding, and the least power of all points around it.
struct ExactSimplex {
  ExactSimplex(core::Complex& complex, std::uint32_t s) {
    const core::Form<Rational> form(complex.data);
    const core::Lifts<Rational> lifts = complex.lifts<Rational>(s);
    const core::Circumball<Rational> ball(complex.data, form, lifts);
    radius = ball.tangent_squared();
    bool is_first = true;
    core::AroundSimplex(complex).visit(s, [&](checker::Label label, core::Elements::Id element) {
      const Rational found = ball.power(complex.elements.moved(element, complex.point<Rational>(label)));
      if (is_first || less(found, power) == Verdict::proved) power = found;
      is_first = false;
    });
    longest = Rational(0);
    for (std::size_t k = 0; k <= complex.data.m; ++k) {
      for (std::size_t i = 0; i < k; ++i) longest = maximum(longest, form.squared(lifts[k] - lifts[i]));
      const std::size_t base = k == 0 ? 1 : 0;
      const core::Frame<Rational> frame(0, complex.data.m, lifts, base);
      const auto cofactors = frame.cofactors_of(k);
      const Rational determinant = dot(cofactors, lifts[k] - lifts[base], complex.data.m);
      const Rational height = square(determinant) / form.squared_covector(cofactors);
      if (k == 0 || less(height, altitude) == Verdict::proved) altitude = height;
    }
  }
  Rational power, radius, altitude, longest;
};

bool is_at_most(double bound, const Rational& x) { return less(x, exact(bound)) != Verdict::proved; }
bool is_at_least(double bound, const Rational& x) { return less(exact(bound), x) != Verdict::proved; }

/// What is known of all simplices, compared with what they are.
struct FlatComparison {
  explicit FlatComparison(const CoreSample& sample) {
    core::Complex complex(sample.data);
    checker::Report report;
    core::check_manifold(complex, report);
    core::FlatSimplices flat(complex);
    for (std::uint32_t s = 0; s < sample.data.simplices(); ++s) {
      const core::FlatSimplex& found = flat.of(s);
      const ExactSimplex simplex(complex, s);
      const bool is_known = found.power > 0;
      known += is_known ? 1 : 0;
      if (!is_known) continue;
      EXPECT_TRUE(is_at_most(found.power, simplex.power)) << complex.name(s);
      EXPECT_TRUE(is_at_most(found.nearest, simplex.radius + Rational(2) * simplex.power));
      EXPECT_TRUE(is_at_most(found.altitude, simplex.altitude));
      EXPECT_TRUE(is_at_least(found.radius, simplex.radius));
      EXPECT_TRUE(is_at_least(found.longest, simplex.longest));
      const auto is_near = [](double bound, const Rational& x) {
        return std::fabs(bound / enclosure(x).upper() - 1) < 0x1p-30;
      };
      near += is_near(found.power, simplex.power) && is_near(found.radius, simplex.radius) &&
                      is_near(found.altitude, simplex.altitude) && is_near(found.longest, simplex.longest)
                  ? 1
                  : 0;
    }
  }
  int known = 0, near = 0;
};

/// The grid with every coordinate moved by up to 2^-7, to one with all digits.
CoreSample moved_grid(std::size_t m, int sides, unsigned seed) {
  CoreSample sample = grid_torus(m, sides);
  std::mt19937_64 random(seed);
  for (auto& x : sample.coordinates) {
    for (std::size_t k = 0; k < m; ++k) {
      Rational move;
      fmpq_set_si(move.raw(), static_cast<long>(random() % (1UL << 50)) - (1L << 49), 3UL << 56);
      x[k] = x[k] + move;
    }
  }
  sample.place_points();
  return sample;
}

TEST_F(FlatSimplices, are_bounded_by_what_is_known_of_them) {
  for (const unsigned seed : {1U, 2U, 3U}) {
    for (const CoreSample& sample : {moved_grid(2, 5, seed), moved_grid(3, 3, seed)}) {
      const FlatComparison compared(sample);
      EXPECT_EQ(compared.known, static_cast<int>(sample.data.simplices()));
      EXPECT_EQ(compared.near, compared.known);
    }
  }
}

/// All vertices of a cube are on one sphere.
CoreSample cut_cubes(std::size_t m) {
  CoreSample sample = grid_torus(m, 4);
  sample.data.form = checker::FieldMatrix::identity(m);
  return sample;
}

TEST_F(FlatSimplices, are_unknown_where_a_point_is_on_the_circumsphere) {
  EXPECT_EQ(FlatComparison(cut_cubes(2)).known, 0);
  EXPECT_EQ(FlatComparison(cut_cubes(3)).known, 0);
}

TEST_F(FlatSimplices, are_unknown_or_bounded_where_coordinates_are_known_roughly) {
  for (CoreSample sample : {moved_grid(2, 5, 1), moved_grid(3, 3, 1)}) {
    const auto narrow = sample.data.filter;
    for (auto& x : sample.data.filter) x[1] = x[1] + Interval::between(-0.002, 0.002);
    const FlatComparison rough(sample);
    EXPECT_EQ(rough.near, 0);
    sample.data.filter = narrow;
    for (auto& x : sample.data.filter) x[1] = Interval::between(-unbounded, unbounded);
    EXPECT_EQ(FlatComparison(sample).known, 0);
  }
}

/// Where they are not known, hinges are decided without them: those of cut squares are not strictly Delaunay.
TEST_F(FlatSimplices, decide_no_hinge_that_they_do_not_know) {
  const CoreSample cut = cut_cubes(2), moved = moved_grid(2, 5, 1);
  for (const CoreSample* sample : {&moved, &cut}) {
    core::Complex complex(sample->data);
    checker::Report report;
    core::check_manifold(complex, report);
    core::FlatSimplices flat(complex);
    core::check_hinges(complex, &flat, report);
    EXPECT_EQ(report.findings.size(), sample == &cut ? 1U : 0U);
  }
}

/// Otherwise neighbours of vertices could be missing.
TEST_F(FlatSimplices, in_a_chunk_need_all_simplices_of_their_vertices) {
  const CoreSample sample = moved_grid(2, 5, 1);
  core::Complex complex(sample.data);
  checker::Report report;
  core::check_manifold(complex, report);
  core::FlatSimplices flat(complex);
  checker::chunk_items.emplace();
  checker::chunk_items->whole.assign(complex.size(), true);
  const checker::Label missing = complex.label(3, 1);
  checker::chunk_items->whole[missing] = false;
  std::size_t thrown = 0;
  for (std::uint32_t s = 0; s < sample.data.simplices(); ++s) {
    try {
      (void)flat.of(s);
    } catch (const checker::NotRead&) {
      ++thrown;
    }
  }
  checker::chunk_items.reset();
  EXPECT_EQ(thrown, complex.star.size(missing));
}

TEST_F(FlatSimplices, are_for_translations_of_dimension_2_and_3) {
  EXPECT_TRUE(core::FlatSimplices::are(grid_torus(2, 3).data));
  EXPECT_TRUE(core::FlatSimplices::are(grid_torus(3, 3).data));
  for (const CoreSample& sample : {grid_torus(1, 3), grid_torus(4, 3), icosahedron(false), klein_bottle()})
    EXPECT_FALSE(core::FlatSimplices::are(sample.data));
}

}  // namespace
}  // namespace delcert::checker_tests::by_hand
