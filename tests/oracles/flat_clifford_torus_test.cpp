// The Clifford torus, two circles in ℝ⁴: the length of curves in it is that of the flat torus of the two angles, so
// that the complex which level 4 speaks of is CGAL's periodic Delaunay triangulation of the angles.

#include <cmath>

#include "tests/oracles/cgal_delaunay.hpp"
#include "tests/oracles/submanifold_sample.hpp"
#include "tests/support/ratio.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

TEST(FlatCliffordTorus, has_the_delaunay_complex_of_its_angles) {
  const SubmanifoldSample<2> sample("clifford-torus", ratio(1, 10));
  const double turn = 2 * std::acos(-1.0);
  Doubles<2> angles;
  for (std::uint32_t label = 0; label < sample.size(); ++label) {
    const std::vector<double> x = sample.position(label);
    angles.push_back({std::atan2(x[1], x[0]) / turn, std::atan2(x[3], x[2]) / turn});
  }
  LabelComplex<2> theirs;
  for (const LiftedSimplex<2>& simplex : CgalTorus<2>(angles).complex())
    theirs.push_back({simplex[0].index, simplex[1].index, simplex[2].index});
  sort_simplices<2>(theirs);
  expect_same_labels<2>(sample.simplices, theirs);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
