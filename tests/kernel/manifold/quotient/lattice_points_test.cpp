#include "kernel/manifold/quotient/lattice_points.hpp"

#include <gtest/gtest.h>

#include <random>
#include <stdexcept>

#include "tests/kernel/manifold/quotient/samples.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

TEST(LatticePoints, are_all_that_a_wide_search_finds) {
  std::mt19937_64 random(2);
  for (int trial = 0; trial < 20; ++trial) {
    const auto entry = [&] { return ratio(static_cast<long>(random() % 5) - 2, 2); };
    const RationalMatrix factor{{Rational(2), entry()}, {entry(), Rational(3)}};
    RationalMatrix gram(2, RationalVector(2));
    for (std::size_t a = 0; a < 2; ++a) {
      for (std::size_t b = 0; b < 2; ++b) gram[a][b] = factor[0][a] * factor[0][b] + factor[1][a] * factor[1][b];
    }
    if (gram[0][0] * gram[1][1] == gram[0][1] * gram[1][0]) continue;
    const RationalVector offset{entry() / Rational(3), entry()};
    const Rational bound = ratio(static_cast<long>(random() % 60), 2);
    std::size_t count = 0;
    Rational least = Rational(1000000);
    for (long x = -12; x <= 12; ++x) {
      for (long y = -12; y <= 12; ++y) {
        const Rational squared = squared_norm(gram, {offset[0] + Rational(x), offset[1] + Rational(y)});
        if (squared <= bound) ++count;
        if (squared > Rational(0)) least = minimum(least, squared);
      }
    }
    const auto found = lattice_points(gram, offset, bound);
    EXPECT_EQ(found.size(), count);
    for (const RationalVector& x : found) EXPECT_LE(squared_norm(gram, x), bound);
    EXPECT_EQ(least_squared_norm(gram, offset), least);
  }
}

TEST(LatticePoints, inverses_are_exact) {
  const RationalMatrix inverted = inverse(RationalMatrix{{Rational(0), Rational(2)}, {Rational(3), Rational(1)}});
  EXPECT_EQ(inverted, (RationalMatrix{{ratio(-1, 6), ratio(1, 3)}, {ratio(1, 2), Rational(0)}}));
  EXPECT_THROW((void)inverse(RationalMatrix{{Rational(1), Rational(2)}, {Rational(2), Rational(4)}}),
               std::domain_error);
}

TEST(LatticePoints, too_many_are_refused) {
  const RationalMatrix gram{{Rational(1), Rational(0)}, {Rational(0), Rational::power_of_two(-60)}};
  EXPECT_TRUE(mentions(message_of<InputError>([&] {
                         (void)lattice_points(gram, {Rational(0), Rational(0)}, Rational(1));
                       }),
                       "too skewed"));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
