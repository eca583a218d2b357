#include "proofs/checker/core/powers_around.hpp"

#include <gtest/gtest.h>

#include "tests/checker/core_samples.hpp"
#include "tests/checker/support/exact_double.hpp"
#include "tests/checker/upwards.hpp"

namespace delcert::checker_tests::by_hand {
namespace {

namespace core = checker::core;
using checker::Interval;
using checker::Rational;

struct PowersAround : testing::Test {
  const test::Upwards upwards;
};

constexpr double infinity = std::numeric_limits<double>::infinity();

/// What doubles say of all simplices of a complex, compared with intervals, and with rational numbers where there are.
struct Comparison {
  explicit Comparison(const CoreSample& sample) {
    core::Complex complex(sample.data);
    checker::Report report;
    core::check_manifold(complex, report);
    core::PowersAround around(complex);
    const core::Form<Interval> form(sample.data);
    for (std::uint32_t s = 0; s < sample.data.simplices(); ++s) {
      const core::Circumball<Interval> ball(sample.data, form, complex.lifts<Interval>(s));
      around.look(s, ball);
      double least = infinity;
      for (const auto& [label, element, power] : around.points()) {
        const Interval enclosed = ball.power(complex.elements.moved(element, complex.point<Interval>(label)));
        least = std::min(least, enclosed.lower());
        // Both enclose the power.
        failed += power - around.error() > enclosed.upper() || power + around.error() < enclosed.lower() ? 1 : 0;
        failed += around.is_above({label, element, power}, enclosed.upper()) ? 1 : 0;
        above += around.is_above({label, element, power}, enclosed.lower() - 0.001) ? 1 : 0;
        ++number;
        if (sample.data.exact == nullptr) continue;
        const core::Form<Rational> exact_form(sample.data);
        const core::Circumball<Rational> exact_ball(sample.data, exact_form, complex.lifts<Rational>(s));
        const Rational exact_power = exact_ball.power(complex.elements.moved(element, complex.point<Rational>(label)));
        needed += less(exact_power, exact(power)) == checker::Verdict::proved ? 1 : 0;
        const Interval around_power =
            Interval::between(power, power) + Interval::between(-around.error(), around.error());
        failed += less(around_power, enclosure(exact_power)) == checker::Verdict::proved ||
                          less(enclosure(exact_power), around_power) == checker::Verdict::proved
                      ? 1
                      : 0;
      }
      found += around.least(ball) == least ? 1 : 0;
      leasts.push_back(around.least(ball));
    }
  }
  int number = 0, failed = 0, above = 0, needed = 0;
  int found = 0;  // simplices of which the least power is that of all intervals
  std::vector<double> leasts;
};

TEST_F(PowersAround, are_wrong_by_no_more_than_their_bound) {
  int needed = 0;
  for (const CoreSample& sample :
       {grid_torus(2, 3), grid_torus(3, 3), klein_bottle(), bolza_surface(), icosahedron(false), cell_600(true)}) {
    const Comparison compared(sample);
    EXPECT_GT(compared.number, 50);
    EXPECT_EQ(compared.failed, 0);
    EXPECT_EQ(compared.above, compared.number);
    EXPECT_EQ(compared.found, static_cast<int>(sample.data.simplices()));
    needed += compared.needed;
  }
  EXPECT_GT(needed, 0) << "the bound is never needed";
}

/// Then nothing but intervals says what is least.
TEST_F(PowersAround, leave_open_what_is_known_roughly_or_not_bounded) {
  for (CoreSample sample : {grid_torus(2, 3), klein_bottle(), bolza_surface()}) {
    const Comparison narrow(sample);
    for (auto& x : sample.data.filter) x[1] = x[1] + Interval::between(-0.002, 0.002);
    const Comparison rough(sample);
    EXPECT_EQ(rough.failed, 0);
    for (std::size_t s = 0; s < rough.leasts.size(); ++s) EXPECT_LE(rough.leasts[s], narrow.leasts[s] + 1e-12);
    for (auto& x : sample.data.filter) x[1] = Interval::between(-infinity, infinity);
    const Comparison unbounded(sample);
    EXPECT_EQ(unbounded.above, 0);
    EXPECT_EQ(unbounded.found, static_cast<int>(sample.data.simplices()));
  }
}

}  // namespace
}  // namespace delcert::checker_tests::by_hand
