#include "kernel/manifold/gluing/atlas_distortion.hpp"

#include "kernel/manifold/gluing/growing_bound.hpp"
#include "kernel/manifold/gluing/interval_matrix.hpp"

namespace delcert {

template <int m>
std::optional<Rational> measure_transitions(const FormulaAtlas<m>& atlas, const Rational& limit,
                                            const Progress& progress) {
  GrowingBound bound(approximate_double(limit));
  Matrix<Interval, m> identity{};
  for (std::size_t axis = 0; axis < m; ++axis) identity[axis][axis] = Interval(1);
  for (std::uint32_t index = 0; index < atlas.size(); ++index) {
    if (index % 256 == 0) progress("measure the distortion", index, atlas.size());
    const Label i(index);
    const RoundingGuard guard;
    const Matrix<Interval, m>& here = atlas.enclosed(i).matrix;
    atlas.visit_derivatives(i, [&](Label j, const Matrix<Interval, m>& derivative) {
      if (j == i) return;
      const auto whole = product(product(here, derivative), atlas.enclosed(j).inverse);
      // ‖W‖ ≤ ‖middle‖ + ‖W − middle‖, the second by the norm of Frobenius.
      Interval spread(0);
      Matrix<Interval, m> middle;
      for (std::size_t row = 0; row < m; ++row) {
        for (std::size_t column = 0; column < m; ++column) {
          const Interval& entry = whole[row][column];
          middle[row][column] = Interval::exactly(entry.lower() / 2 + entry.upper() / 2);
          spread += square(entry - middle[row][column]);
        }
      }
      const auto gram = gram_of(middle);
      const Interval rest = Interval(1) - square_root(spread);
      bound.grow_until([&](const Interval& xi) {
        return conjunction(less(Interval(0), rest + xi), is_below(gram, square(rest + xi), identity));
      });
    });
    if (!bound.is_below_limit()) return std::nullopt;
  }
  return bound.rounded();
}

template <int m>
Rational fit_patches(FormulaAtlas<m>& atlas, const Progress& progress) {
  return fitted_patches<m>(atlas, atlas.gluing().description().name, greatest_distortion(),
                           [&](const Rational& limit) { return measure_transitions<m>(atlas, limit, progress); });
}

template <int m>
ModelGeometry geometry_of(const FormulaAtlas<m>& atlas, const Rational& distortion) {
  ModelGeometry result;
  result.patch_factor = atlas.patch_factor();
  result.distortion = distortion;
  return result;
}

#define DELCERT_INSTANTIATE(m)                                                                                       \
  template std::optional<Rational> measure_transitions<m>(const FormulaAtlas<m>&, const Rational&, const Progress&); \
  template Rational fit_patches<m>(FormulaAtlas<m>&, const Progress&);                                               \
  template ModelGeometry geometry_of<m>(const FormulaAtlas<m>&, const Rational&);
DELCERT_INSTANTIATE(2)
DELCERT_INSTANTIATE(3)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
