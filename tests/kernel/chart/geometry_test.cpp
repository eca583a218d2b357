#include "kernel/chart/geometry.hpp"

#include <gtest/gtest.h>

#include "kernel/manifold/flat_atlas.hpp"
#include "kernel/manifold/gluing/formula_atlas.hpp"
#include "kernel/manifold/gluing/metric_field_atlas.hpp"
#include "kernel/manifold/quotient/space_form_atlas.hpp"
#include "tests/kernel/manifold/exhaustive.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

static_assert(Geometry<FlatAtlas<1>, 1> && Geometry<FlatAtlas<2>, 2> && Geometry<FlatAtlas<3>, 3> &&
              Geometry<FlatAtlas<4>, 4>);
static_assert(Geometry<SpaceFormAtlas<2>, 2> && Geometry<SpaceFormAtlas<3>, 3>);
static_assert(Geometry<MetricFieldAtlas<2>, 2> && Geometry<MetricFieldAtlas<3>, 3>);
static_assert(Geometry<FormulaAtlas<2>, 2> && Geometry<FormulaAtlas<3>, 3>);

// The interface itself, another dimension, and what is no atlas.
static_assert(!Geometry<Atlas<2>, 2> && !Geometry<AffineAtlas<2>, 2>);
static_assert(!Geometry<FlatAtlas<2>, 3>);
static_assert(!Geometry<PointSet<2>, 2>);

template <int m, Geometry<m> Model>
bool is_exact_exactly_where_it_says_so(const Model& model) {
  for (const auto& seen : model.neighbours(Label(0))) {
    if (model.carry(Label(0), seen, Vector<Rational, m>{}).has_value() != model.has_exact_transitions()) return false;
  }
  return true;
}

TEST(Geometry, says_where_transitions_are_exact) {
  EXPECT_TRUE(is_exact_exactly_where_it_says_so<2>(
      FlatAtlas<2>(cubic_torus<2>(), PointSet<2>(random_points<2>(9, 6)), ratio(1, 10))));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
