#include "kernel/manifold/lattice.hpp"

#include "support/error.hpp"
#include "tests/kernel/manifold/exhaustive.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

/// The shortest of all integer vectors with coordinates −reach … reach.
template <int m>
Rational least_of_a_box(const FlatSpace<m>& space, std::int32_t reach) {
  Shift<m> first;
  Shift<m> last;
  first.fill(-reach);
  last.fill(reach);
  Rational best = space.metric.gram()[0][0];
  for_each_shift<m>(first, last, [&](const Shift<m>& shift) {
    const auto vector = moved<m>(Vector<Rational, m>{}, shift);
    const Rational squared = squared_norm<m>(space, vector);
    if (shift != Shift<m>{}) best = minimum(best, squared);
  });
  return best;
}

/// UᵀGU: the same lattice in another basis.
template <int m>
FlatSpace<m> in_basis(const FlatSpace<m>& space, const Matrix<Rational, m>& basis) {
  Matrix<Rational, m> gram;
  for (std::size_t a = 0; a < m; ++a) {
    for (std::size_t b = 0; b < m; ++b) {
      for (std::size_t i = 0; i < m; ++i) {
        for (std::size_t j = 0; j < m; ++j) gram[a][b] += basis[i][a] * space.metric.gram()[i][j] * basis[j][b];
      }
    }
  }
  return torus_of<m>(gram);
}

TEST(SquaredSystole, of_lattices_that_are_known) {
  EXPECT_EQ(squared_systole<1>(cubic_torus<1>().metric), Rational(1));
  EXPECT_EQ(squared_systole<1>(torus_of<1>({{{ratio(2, 9)}}}).metric), ratio(2, 9));
  EXPECT_EQ(squared_systole<2>(cubic_torus<2>().metric), Rational(1));
  EXPECT_EQ(squared_systole<2>(hexagonal_torus().metric), Rational(1));
  EXPECT_EQ(squared_systole<3>(bcc_torus().metric), Rational(1));
  EXPECT_EQ(squared_systole<4>(cubic_torus<4>().metric), Rational(1));
  // The shortest vector is a combination, not a vector of the basis: ℤ² in the basis (5, 7), (7, 10).
  EXPECT_EQ(squared_systole<2>(torus_of<2>({{{Rational(74), Rational(105)}, {Rational(105), Rational(149)}}}).metric),
            Rational(1));
  EXPECT_EQ(squared_systole<2>(square_torus_in_a_long_basis().metric), Rational(1));
}

TEST(SquaredSystole, is_the_least_of_a_wide_enumeration) {
  std::mt19937_64 random(12);
  const auto entry = [&random] { return ratio(static_cast<long>(random() % 9) - 4, 3); };
  int combinations = 0;
  for (int trial = 0; trial < 60; ++trial) {
    Matrix<Rational, 3> gram;
    Matrix<Rational, 3> factor;
    for (auto& row : factor) {
      for (Rational& x : row) x = entry();
    }
    for (std::size_t a = 0; a < 3; ++a) {
      for (std::size_t b = 0; b < 3; ++b) {
        for (std::size_t k = 0; k < 3; ++k) gram[a][b] += factor[k][a] * factor[k][b];
      }
    }
    if (edge_determinant<3>({{}, factor[0], factor[1], factor[2]}) == Rational(0)) continue;
    const auto space = torus_of<3>(gram);
    const Rational systole = squared_systole<3>(space.metric);
    EXPECT_EQ(systole, least_of_a_box<3>(space, 9));
    if (systole < minimum(minimum(gram[0][0], gram[1][1]), gram[2][2])) ++combinations;
  }
  EXPECT_GT(combinations, 5) << "trials in which no vector of the basis is shortest";
}

TEST(SquaredSystole, does_not_depend_on_the_basis) {
  const Rational one(1);
  const Rational zero(0);
  const Matrix<Rational, 3> basis{{{one, Rational(2), Rational(-3)}, {zero, one, Rational(4)}, {zero, zero, one}}};
  for (const auto& space : {bcc_torus(), skewed_torus(), cubic_torus<3>()}) {
    EXPECT_EQ(squared_systole<3>(in_basis<3>(space, basis).metric), squared_systole<3>(space.metric));
  }
}

TEST(SquaredSystole, refuses_bases_that_are_too_skewed) {
  const Rational long_step = Rational::power_of_two(40);
  const auto skewed =
      torus_of<2>({{{Rational(1), long_step}, {long_step, square(long_step) + Rational::power_of_two(-80)}}});
  EXPECT_TRUE(mentions(message_of<InputError>([&] { (void)squared_systole<2>(skewed.metric); }), "too skewed"));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
