#include "kernel/manifold/quotient/tile_walk.hpp"

#include <gtest/gtest.h>

#include <set>

#include "kernel/manifold/quotient/space_form_families.hpp"
#include "kernel/manifold/space_form_file.hpp"
#include "tests/kernel/manifold/quotient/samples.hpp"
#include "tests/kernel/manifold/quotient/side_pairings.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

DirichletPolyhedron polyhedron_of(const SpaceFormDescription& description) {
  const SidePairings pairings = with_inverses(description);
  return dirichlet_polyhedron(description.form, pairings.elements, pairings.names, ElementsWithoutSide::are_errors);
}

using Elements = std::set<FieldMatrix, Precedes>;

TEST(TileWalk, finds_what_all_short_words_find) {
  const auto description = regular_polygon_surface(2);
  const auto polygon = polyhedron_of(description);
  const BigInterval radius(Rational(5));
  // Words of up to 4 letters: 8·7³ elements and more, without a thought about tiles.
  Elements words{FieldMatrix::identity(3)};
  for (int length = 0; length < 4; ++length) {
    Elements longer = words;
    for (const FieldMatrix& word : words) {
      for (const auto& side : polygon.sides) longer.insert(word * side.element);
    }
    words = std::move(longer);
  }
  Elements expected;
  for (const FieldMatrix& word : words) {
    const BigInterval distance =
        description.form.distance_from(description.form.displacement_of_origin(word.column(0)).enclosure());
    if (!is_proved(less(radius, distance))) expected.insert(word);
  }
  const auto found = tiles_with_centre_within(description.form, polygon, radius);
  EXPECT_EQ(found.size(), expected.size());
  EXPECT_EQ(Elements(found.begin(), found.end()), expected);
  EXPECT_EQ(found.size(), 49U);
  EXPECT_TRUE(is_identity(found.front()));
}

TEST(TileWalk, finds_what_lattices_enumerate) {
  const auto description = find_space_form("klein-bottle");
  const auto group = crystallographic_group(description.form, description.generators);
  const SidePairings near = numbered(short_elements(description.form, group, Rational(9)));
  const auto polygon =
      dirichlet_polyhedron(description.form, near.elements, near.names, ElementsWithoutSide::are_left_out);
  const auto found = tiles_with_centre_within(description.form, polygon, BigInterval(Rational(6)));
  const auto expected = short_elements(description.form, group, Rational(36));
  EXPECT_EQ(found.size(), expected.size() + 1);
  Elements all(found.begin(), found.end());
  for (const FieldMatrix& element : expected) EXPECT_TRUE(all.contains(element));
}

TEST(TileWalk, the_number_of_tiles_is_that_of_the_area) {
  // Tiles whose centre is within R lie within R + D and cover the disc of radius R − D.
  const auto description = find_space_form("bolza-surface");
  const auto polygon = polyhedron_of(description);
  const BigInterval radius(Rational(6));
  const BigInterval reach = circumradius(description.form, polygon);
  const auto found = tiles_with_centre_within(description.form, polygon, radius);
  // Area 2π(cosh − 1) of a disc, 4π of the surface.
  const BigInterval least = (hyperbolic_cosine(radius - reach) - BigInterval(1)) / BigInterval(2);
  const BigInterval most = (hyperbolic_cosine(radius + reach) - BigInterval(1)) / BigInterval(2);
  const Rational count(found.size());
  EXPECT_GE(count, least.lower());
  EXPECT_LE(count, most.upper());
  EXPECT_GT(count, Rational(50));
}

TEST(TileWalk, tiles_near_the_polyhedron_include_all_that_touch_it) {
  const auto description = regular_polygon_surface(2);
  const auto polygon = polyhedron_of(description);
  const auto near = tiles_near_polyhedron(description.form, polygon, BigInterval(0));
  const Elements all(near.begin(), near.end());
  // Around the one vertex class of eight: the tile itself, 8 across sides and 8·(8 − 3) that touch in a vertex only.
  std::size_t touching = 0;
  for (const FieldMatrix& tile : near) {
    bool touches = false;
    for (const FieldVector& vertex : polygon.vertices)
      touches = touches || polygon.vertex_on(tile * vertex) < polygon.vertices.size();
    touching += touches ? 1U : 0U;
  }
  EXPECT_EQ(touching, 1U + 8U + 8U * 5U);
  for (const auto& side : polygon.sides) EXPECT_TRUE(all.contains(side.element));
}

TEST(TileWalk, gives_up_with_a_message) {
  const auto description = regular_polygon_surface(2);
  EXPECT_TRUE(mentions(message_of<InputError>([&] {
                         (void)tiles_with_centre_within(description.form, polyhedron_of(description),
                                                        BigInterval(Rational(5)), 30);
                       }),
                       "more than 30 copies of the polyhedron are within reach"));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
