#include "kernel/number/ladder.hpp"

#include <gtest/gtest.h>

#include <array>
#include <stdexcept>
#include <string>
#include <thread>
#include <type_traits>
#include <vector>

#include "kernel/number/algebraic.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

Rational fraction(long numerator, long denominator) { return Rational(numerator) / Rational(denominator); }

/// 1 < 1 + 2^-k, computed as (1/3)*3 < (1/3)*3 + 2^-k so that no interval is a point.
struct SlightlyLess {
  long k;
  template <class S>
  Verdict operator()() const {
    const S one = scalar_from<S>(fraction(1, 3)) * S(3);
    return less(one, one + scalar_from<S>(Rational::power_of_two(-k)));
  }
};

/// A tie: (1/3)*3 < 1.
struct Tie {
  template <class S>
  Verdict operator()() const {
    return less(scalar_from<S>(fraction(1, 3)) * S(3), S(1));
  }
};

/// A tie with roots: sqrt(2) sqrt(3) < sqrt(6), or moved by 2^-k.
struct RootTie {
  long k = 0;
  template <class S>
  Verdict operator()() const {
    const S right = square_root(S(6));
    return less(square_root(S(2)) * square_root(S(3)),
                k == 0 ? right : right + scalar_from<S>(Rational::power_of_two(-k)));
  }
};

/// Gives up in every rung, and notes which it was asked in, with the precision.
struct Reluctant {
  std::vector<std::string>* asked;
  template <class S>
  Verdict operator()() const {
    if constexpr (std::is_same_v<S, Filter>) asked->push_back("filter");
    if constexpr (std::is_same_v<S, BigInterval>)
      asked->push_back(std::to_string(BigInterval::working_precision().value));
    if constexpr (std::is_same_v<S, Rational>) asked->push_back("rational");
    if constexpr (std::is_same_v<S, Algebraic>) asked->push_back("algebraic");
    return Verdict::undecided;
  }
};

template <class Decision>
LadderStatistics counted(const Decision& decision) {
  const LadderStatistics before = ladder_statistics();
  decision();
  return ladder_statistics() - before;
}

std::uint64_t on(const LadderStatistics& statistics, Rung rung) {
  return statistics.settled[static_cast<std::size_t>(rung)];
}

void expect_settled(const LadderStatistics& statistics, Rung rung) {
  EXPECT_EQ(on(statistics, rung), 1U);
  EXPECT_EQ(statistics.total(), 1U);
}

TEST(Ladder, ends_on_the_first_rung_that_is_sure) {
  expect_settled(counted([] { EXPECT_EQ(decide(SlightlyLess{10}), Verdict::proved); }), Rung::interval);
  expect_settled(counted([] { EXPECT_EQ(decide(SlightlyLess{60}), Verdict::proved); }), Rung::big_interval);
  expect_settled(counted([] { EXPECT_EQ(decide(SlightlyLess{500}), Verdict::proved); }), Rung::rational);
  expect_settled(counted([] { EXPECT_EQ(decide(Tie{}), Verdict::refuted); }), Rung::rational);
}

/// As statements of claims climb: with roots.
Verdict decide_with_roots(const auto& predicate) {
  Ladder ladder;
  {
    const FilterGuard guard;
    ladder.ask(Rung::interval, [&] { return predicate.template operator()<Filter>(); });
  }
  ladder.ask_in_bits(128, 4096, [&] { return predicate.template operator()<BigInterval>(); });
  ladder.ask(Rung::algebraic, [&] { return predicate.template operator()<Algebraic>(); });
  return ladder.finish();
}

TEST(Ladder, with_roots_ends_on_the_first_rung_that_is_sure) {
  expect_settled(counted([] { EXPECT_EQ(decide_with_roots(RootTie{10}), Verdict::proved); }), Rung::interval);
  for (const long k : {60L, 200L, 1000L, 4000L})
    expect_settled(counted([k] { EXPECT_EQ(decide_with_roots(RootTie{k}), Verdict::proved); }), Rung::big_interval);
  expect_settled(counted([] { EXPECT_EQ(decide_with_roots(RootTie{5000}), Verdict::proved); }), Rung::algebraic);
  expect_settled(counted([] { EXPECT_EQ(decide_with_roots(RootTie{}), Verdict::refuted); }), Rung::algebraic);
}

TEST(Ladder, climbs_in_order_and_admits_when_no_rung_was_sure) {
  std::vector<std::string> asked;
  const LadderStatistics rational = counted([&] { EXPECT_EQ(decide(Reluctant{&asked}), Verdict::undecided); });
  EXPECT_EQ(asked, (std::vector<std::string>{"filter", "128", "rational"}));
  EXPECT_EQ(rational.undecided, 1U);
  EXPECT_EQ(rational.total(), 1U);

  asked.clear();
  const LadderStatistics algebraic =
      counted([&] { EXPECT_EQ(decide_with_roots(Reluctant{&asked}), Verdict::undecided); });
  EXPECT_EQ(asked, (std::vector<std::string>{"filter", "128", "256", "512", "1024", "2048", "4096", "algebraic"}));
  EXPECT_EQ(algebraic.undecided, 1U);
  EXPECT_EQ(algebraic.total(), 1U);

  asked.clear();
  EXPECT_EQ(decide_above_filter(Reluctant{&asked}), Verdict::undecided);
  EXPECT_EQ(asked, (std::vector<std::string>{"128", "rational"}));
}

TEST(Ladder, asks_no_further_once_a_rung_was_sure) {
  Ladder ladder;
  EXPECT_FALSE(ladder.ask(Rung::interval, [] { return Verdict::undecided; }));
  EXPECT_TRUE(ladder.ask_in_bits(128, 256, [] { return Verdict::refuted; }));
  EXPECT_TRUE(ladder.ask(Rung::rational, []() -> Verdict { throw std::logic_error("asked again"); }));
  EXPECT_EQ(ladder.finish(), Verdict::refuted);
}

TEST(Ladder, leaves_rounding_mode_and_precision_as_they_were) {
  const BigInterval::Precision precision(PrecisionBits{77});
  EXPECT_EQ(decide_with_roots(RootTie{}), Verdict::refuted);
  EXPECT_EQ(decide(Tie{}), Verdict::refuted);
  EXPECT_EQ(BigInterval::working_precision(), PrecisionBits{77});
  volatile double one = 1;
  volatile double little = 0x1p-80;
  const volatile double sum = one + little;
  EXPECT_EQ(sum, 1.0);
}

/// |p|^2 < 1.
struct InCircle {
  Rational x;
  Rational y;
  template <class S>
  Verdict operator()() const {
    return less(square(scalar_from<S>(x)) + square(scalar_from<S>(y)), S(1));
  }
};

TEST(Ladder, agrees_with_exact_arithmetic_on_points_at_and_beside_a_circle) {
  for (long t = -20; t <= 20; ++t) {
    const Rational denominator(t * t + 49);
    const Rational x = Rational(49 - t * t) / denominator;
    const Rational y = Rational(14 * t) / denominator;
    EXPECT_EQ(decide(InCircle{x, y}), Verdict::refuted) << t;
    for (long k = 1; k <= 400; k += 21) {
      const Rational shrink = Rational(1) - Rational::power_of_two(-k);
      EXPECT_EQ(decide(InCircle{x * shrink, y * shrink}), Verdict::proved) << t << " " << k;
      EXPECT_EQ(decide(InCircle{x / shrink, y / shrink}), Verdict::refuted) << t << " " << k;
    }
  }
}

TEST(LadderStatistics, add_and_subtract_rung_by_rung) {
  LadderStatistics a;
  a.count(Rung::interval, 5);
  a.count(Rung::algebraic);
  a.undecided = 2;
  LadderStatistics b;
  b.count(Rung::interval, 3);
  b.count(Rung::rational, 4);
  a += b;
  EXPECT_EQ(a.settled, (std::array<std::uint64_t, rung_count>{8, 0, 4, 1}));
  EXPECT_EQ(a.total(), 15U);
  const LadderStatistics difference = a - b;
  EXPECT_EQ(difference.settled, (std::array<std::uint64_t, rung_count>{5, 0, 0, 1}));
  EXPECT_EQ(difference.undecided, 2U);
}

TEST(LadderStatistics, are_each_threads_own) {
  const LadderStatistics before = ladder_statistics();
  std::uint64_t elsewhere = 0;
  std::thread other([&elsewhere] {
    EXPECT_EQ(decide(Tie{}), Verdict::refuted);
    elsewhere = ladder_statistics().total();
  });
  other.join();
  EXPECT_EQ(elsewhere, 1U);
  EXPECT_EQ((ladder_statistics() - before).total(), 0U);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
