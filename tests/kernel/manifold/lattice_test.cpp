#include "kernel/manifold/lattice.hpp"

#include <flint/fmpz_lll.h>
#include <flint/fmpz_mat.h>

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

TEST(SquaredSystole, of_a_very_skewed_basis) {
  const Rational long_step = Rational::power_of_two(40);
  const auto skewed =
      torus_of<2>({{{Rational(1), long_step}, {long_step, square(long_step) + Rational::power_of_two(-80)}}});
  EXPECT_EQ(squared_systole<2>(skewed.metric), Rational::power_of_two(-80));
}

/// FLINT's opinion, on the matrix times a common denominator.
template <int m>
bool is_reduced(const Matrix<Rational, m>& gram) {
  Integer denominator(1);
  for (const auto& row : gram) {
    for (const Rational& x : row) denominator *= x.denominator();
  }
  fmpz_mat_t matrix;
  fmpz_mat_init(matrix, m, m);
  for (std::size_t row = 0; row < m; ++row) {
    for (std::size_t column = 0; column < m; ++column) {
      const Rational scaled = gram[row][column] * Rational(denominator);
      fmpz_set_str(fmpz_mat_entry(matrix, static_cast<slong>(row), static_cast<slong>(column)),
                   floor_of(scaled).str().c_str(), 10);
    }
  }
  const bool result = fmpz_mat_is_reduced_gram(matrix, 0.98, 0.5001) != 0;
  fmpz_mat_clear(matrix);
  return result;
}

TEST(ReducedGram, leaves_a_reduced_basis_as_it_is) {
  EXPECT_EQ(reduced_gram<2>(cubic_torus<2>().metric), cubic_torus<2>().metric.gram());
  EXPECT_EQ(reduced_gram<3>(skewed_torus().metric), skewed_torus().metric.gram());
  EXPECT_EQ(reduced_gram<2>(hexagonal_torus().metric), hexagonal_torus().metric.gram());
}

TEST(ReducedGram, is_the_same_lattice_in_a_reduced_basis) {
  std::mt19937_64 random(5);
  const auto multiple = [&random] { return Rational(static_cast<long>(random() % 2001) - 1000); };
  for (int trial = 0; trial < 20; ++trial) {
    Matrix<Rational, 3> basis{{{Rational(1), multiple(), multiple()},
                               {Rational(0), Rational(1), multiple()},
                               {Rational(0), Rational(0), Rational(1)}}};
    const auto skewed = in_basis<3>(skewed_torus(), basis);
    const auto reduced = torus_of<3>(reduced_gram<3>(skewed.metric));
    EXPECT_TRUE(is_reduced<3>(reduced.metric.gram()));
    EXPECT_FALSE(is_reduced<3>(skewed.metric.gram()));
    EXPECT_EQ(squared_systole<3>(reduced.metric), squared_systole<3>(skewed_torus().metric));
    EXPECT_EQ(edge_determinant<3>({{}, reduced.metric.gram()[0], reduced.metric.gram()[1], reduced.metric.gram()[2]}),
              edge_determinant<3>({{}, skewed.metric.gram()[0], skewed.metric.gram()[1], skewed.metric.gram()[2]}));
  }
  const auto thin = torus_of<2>({{{Rational(1), Rational(1000)}, {Rational(1000), Rational(1000001)}}});
  EXPECT_EQ(gram_text<2>(reduced_gram<2>(thin.metric)), "gram = [[\"1\", \"0\"], [\"0\", \"1\"]]");
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
