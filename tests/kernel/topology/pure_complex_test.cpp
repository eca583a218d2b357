#include "kernel/topology/pure_complex.hpp"

#include <gtest/gtest.h>

#include <set>

#include "support/error.hpp"
#include "tests/kernel/topology/known_complexes.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

PureComplex pure(const LabelComplex& complex) { return {Dimension(complex.dimension), complex.labels}; }

TEST(PureComplex, has_the_faces_of_its_simplices_once) {
  for (const KnownComplex& known : known_complexes()) {
    SCOPED_TRACE(known.name);
    const PureComplex complex = pure(known.complex);
    std::vector<std::uint32_t> names = known.complex.labels;
    std::sort(names.begin(), names.end());
    names.erase(std::unique(names.begin(), names.end()), names.end());
    std::vector<std::set<std::vector<std::uint32_t>>> expected(known.complex.corners());
    for (std::size_t simplex = 0; simplex < known.complex.size(); ++simplex) {
      for (unsigned subset = 1; subset < 1U << known.complex.corners(); ++subset) {
        std::vector<std::uint32_t> face;
        for (std::size_t corner = 0; corner < known.complex.corners(); ++corner) {
          if ((subset >> corner & 1U) != 0) {
            face.push_back(known.complex.labels[simplex * known.complex.corners() + corner]);
          }
        }
        std::sort(face.begin(), face.end());
        expected[face.size() - 1].insert(face);
      }
    }
    for (int k = 0; k <= complex.dimension(); ++k) {
      std::vector<std::vector<std::uint32_t>> found;
      for (std::size_t face = 0; face < complex.count(k); ++face) {
        found.emplace_back();
        for (const std::uint32_t vertex : complex.vertices(k, face)) found.back().push_back(names[vertex]);
      }
      const auto& wanted = expected[static_cast<std::size_t>(k)];
      EXPECT_EQ(found, (std::vector<std::vector<std::uint32_t>>(wanted.begin(), wanted.end())));
    }
  }
}

TEST(PureComplex, has_facets_opposite_to_vertices) {
  const PureComplex complex = pure(lens_space(3, 1));
  for (int k = 1; k <= 3; ++k) {
    for (std::size_t face = 0; face < complex.count(k); ++face) {
      const auto vertices = complex.vertices(k, face);
      const auto facets = complex.facets(k, face);
      ASSERT_EQ(facets.size(), vertices.size());
      for (std::size_t omitted = 0; omitted < vertices.size(); ++omitted) {
        std::vector<std::uint32_t> rest(vertices.begin(), vertices.end());
        rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(omitted));
        const auto facet = complex.vertices(k - 1, facets[omitted]);
        ASSERT_EQ(std::vector<std::uint32_t>(facet.begin(), facet.end()), rest);
      }
    }
  }
}

TEST(PureComplex, has_an_euler_characteristic) {
  EXPECT_EQ(pure(smallest_sphere(2)).euler_characteristic(), 2);
  EXPECT_EQ(pure(smallest_sphere(3)).euler_characteristic(), 0);
  EXPECT_EQ(pure(seven_vertex_torus()).euler_characteristic(), 0);
  EXPECT_EQ(pure(six_vertex_projective_plane()).euler_characteristic(), 1);
  EXPECT_EQ(pure(glued_polygon("abABcdCD")).euler_characteristic(), -2);
  EXPECT_EQ(pure(without_simplex(seven_vertex_torus(), 3)).euler_characteristic(), -1);
  EXPECT_EQ(pure({2, {}}).euler_characteristic(), 0);
}

TEST(PureComplex, counts_a_simplex_that_is_given_twice_once) {
  const PureComplex complex(Dimension(2), {4000000000, 1, 7, 7, 1, 4000000000, 1, 7, 9});
  EXPECT_EQ(complex.count(2), 2U);
  EXPECT_EQ(complex.count(1), 5U);
  EXPECT_EQ(complex.count(0), 4U);
  EXPECT_EQ(complex.count(3), 0U);
  EXPECT_EQ(complex.count(-1), 0U);
}

TEST(PureComplex, numbers_labels_in_their_order_whatever_they_are) {
  const std::vector<std::uint32_t> triangles{0, 1, 2, 3, 2, 1, 0, 3, 1, 0, 2, 3};
  const PureComplex near(Dimension(2), triangles);
  // One label is missing; labels beyond their number; labels far apart.
  for (const auto& names :
       std::vector<std::vector<std::uint32_t>>{{0, 2, 3, 4}, {9, 10, 11, 12}, {7, 100, 5000, 4000000000}}) {
    std::vector<std::uint32_t> named;
    for (const std::uint32_t label : triangles) named.push_back(names[label]);
    const PureComplex complex(Dimension(2), named);
    for (int k = 0; k <= 2; ++k) {
      ASSERT_EQ(complex.count(k), near.count(k));
      for (std::size_t face = 0; face < near.count(k); ++face) {
        const auto found = complex.vertices(k, face), expected = near.vertices(k, face);
        EXPECT_TRUE(std::equal(found.begin(), found.end(), expected.begin(), expected.end()));
      }
    }
  }
}

TEST(PureComplex, refuses_what_is_no_set_of_simplices) {
  EXPECT_THROW(PureComplex(Dimension(2), {0, 1, 2, 3}), std::invalid_argument);
  EXPECT_THROW(PureComplex(Dimension(-1), {}), std::invalid_argument);
  try {
    const PureComplex complex(Dimension(2), {0, 1, 2, 17, 3, 17});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "a simplex has the label 17 more than once");
  }
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
