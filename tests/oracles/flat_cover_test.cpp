// Flat manifolds: the Delaunay complex of X/Γ, lifted to a torus that covers it, is that of the lifted points. CGAL's
// periodic triangulations of square and cubic tori against the certified complex, by sets of labels.

#include <functional>

#include "tests/oracles/cgal_delaunay.hpp"
#include "tests/oracles/space_form_sample.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

template <int m>
using Point = Vector<Rational, m>;

/// Where the sheets of the cover have the point with these coordinates in the lattice of translations, in the unit
/// square or cube.
template <int m>
using Sheets = std::function<std::vector<Point<m>>(const Point<m>&)>;

const Rational half(Integer(1), Integer(2));

/// The translations of the Klein bottle are 2ℤ × ℤ; of degree 4 is the square torus of side 2.
std::vector<Point<2>> sheets_of_klein_bottle(const Point<2>& x) {
  std::vector<Point<2>> result;
  for (const Point<2>& one : {x, Point<2>{x[0] + half, -x[1]}}) {
    for (const int row : {0, 1}) result.push_back({one[0], (one[1] + Rational(row)) * half});
  }
  return result;
}

/// The translations are ℤ × ℤ × 2ℤ; of degree 8 is the cubic torus of side 2.
std::vector<Point<3>> sheets_of_half_turn_space(const Point<3>& x) {
  std::vector<Point<3>> result;
  for (const Point<3>& one : {x, Point<3>{-x[0], -x[1], x[2] + half}}) {
    for (const int column : {0, 1}) {
      for (const int row : {0, 1})
        result.push_back({(one[0] + Rational(column)) * half, (one[1] + Rational(row)) * half, one[2]});
    }
  }
  return result;
}

template <int m>
LabelComplex<m> cgal_complex_of_cover(const SpaceFormSample<m>& sample, const Sheets<m>& sheets, std::size_t degree) {
  Doubles<m> points;
  std::vector<std::uint32_t> labels;
  for (std::uint32_t label = 0; label < sample.atlas.size(); ++label) {
    Point<m> x = sample.atlas.centre(Label(label));
    for (std::size_t axis = 0; axis < m; ++axis) x[axis] += sample.run.points.exact(Label(label))[axis];
    const auto lifts = sheets(x);
    EXPECT_EQ(lifts.size(), degree);
    for (const auto& lift : lifts) {
      Vector<double, m> rounded;
      for (std::size_t axis = 0; axis < m; ++axis) rounded[axis] = approximate_double(lift[axis]);
      points.push_back(rounded);
      labels.push_back(label);
    }
  }
  const auto cover = CgalTorus<m>(points).complex();
  LabelComplex<m> result;
  for (const auto& lifted : cover) {
    LabelSimplex<m> simplex;
    for (std::size_t corner = 0; corner <= m; ++corner) simplex[corner] = labels[lifted[corner].index];
    result.push_back(simplex);
  }
  sort_simplices<m>(result);
  EXPECT_EQ(cover.size(), degree * result.size());
  return result;
}

template <int m>
void expect_same_complex(const SpaceFormSample<m>& sample, const Sheets<m>& sheets, std::size_t degree) {
  expect_same_labels<m>(sample.run.complex.simplices(), cgal_complex_of_cover<m>(sample, sheets, degree));
}

TEST(FlatCover, of_the_klein_bottle_at_1_24_has_its_complex) {
  expect_same_complex<2>(certified_sample<2>("klein-bottle", Rational(Integer(1), Integer(24))), sheets_of_klein_bottle,
                         4);
}

TEST(FlatCover, by_another_group_has_another_complex) {
  const auto sample = certified_sample<2>("klein-bottle", Rational(Integer(1), Integer(24)));
  const auto torus = [](const Point<2>& x) {
    return std::vector<Point<2>>{{x[0], x[1] * half},
                                 {x[0], (x[1] + Rational(1)) * half},
                                 {x[0] + half, x[1] * half},
                                 {x[0] + half, (x[1] + Rational(1)) * half}};
  };
  EXPECT_NE(label_disagreement<2>(sample.run.complex.simplices(), cgal_complex_of_cover<2>(sample, torus, 4)), "");
}

TEST(FlatCover, of_the_half_turn_space_at_1_16_has_its_complex) {
  expect_same_complex<3>(certified_sample<3>("flat-half-turn", Rational(Integer(1), Integer(16)), 5),
                         sheets_of_half_turn_space, 8);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
