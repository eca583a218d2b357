#include "proofs/formula/simplex_object.hpp"

#include <gtest/gtest.h>

#include <array>
#include <nlohmann/json.hpp>

#include "support/error.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

using Json = nlohmann::ordered_json;

const SimplexObject& simplex_of(const ObjectPointer& object) { return dynamic_cast<const SimplexObject&>(*object); }

TEST(SimplexObjects, are_read_back_from_points) {
  const SimplexObject simplex(SimplexObject::Points{{0, 0, 0}, {3, 0, 0}, {0, 4, Rational(Integer(1), Integer(3))}});
  EXPECT_EQ(simplex.dimension(), 2U);
  EXPECT_EQ(simplex.ambient_dimension(), 3U);
  const ObjectPointer read = SimplexObject::read(Json::parse(simplex.json().dump()));
  EXPECT_EQ(simplex_of(read).points(), simplex.points());
}

TEST(SimplexObjects, are_read_back_from_edges) {
  const ObjectPointer object = SimplexObject::read(Json::parse(R"({"squared_edges": [["9"], ["16", "25"]]})"));
  const SimplexObject& simplex = simplex_of(object);
  EXPECT_FALSE(simplex.has_coordinates());
  EXPECT_EQ(simplex.ambient_dimension(), 2U);
  EXPECT_EQ(simplex.exact_gram().squared_edge(1, 2), Rational(25));
  EXPECT_EQ(simplex_of(SimplexObject::read(simplex.json())).json(), simplex.json());
}

TEST(SimplexObjects, faces_keep_what_the_simplex_is_known_by) {
  const SimplexObject points(SimplexObject::Points{{0, 0}, {3, 0}, {0, 4}});
  const std::array<std::size_t, 2> vertices{1, 2};
  EXPECT_EQ(points.face(vertices).points(), (SimplexObject::Points{{3, 0}, {0, 4}}));
  const ObjectPointer edges = SimplexObject::read(Json::parse(R"({"squared_edges": [["9"], ["16", "25"]]})"));
  EXPECT_EQ(simplex_of(edges).face(vertices).exact_gram().squared_edge(0, 1), Rational(25));
}

TEST(SimplexObjects, what_is_no_simplex_is_refused) {
  for (const char* text :
       {R"({})", R"({"points": []})", R"({"points": [["1"], ["1", "2"]]})", R"({"points": [[1], [2]]})",
        R"({"points": [["1.5"], ["2"]]})", R"({"squared_edges": [["9"], ["16"]]})",
        R"({"squared_edges": [["9", "1"]]})", R"({"points": 7})"}) {
    EXPECT_THROW((void)SimplexObject::read(Json::parse(text)), InputError) << text;
  }
}

TEST(PointObjects, are_read_back) {
  const PointObject point({Rational(1), Rational(Integer(1), Integer(3))});
  const ObjectPointer read = PointObject::read(Json::parse(point.json().dump()));
  EXPECT_EQ(dynamic_cast<const PointObject&>(*read).coordinates(), point.coordinates());
  EXPECT_THROW((void)PointObject::read(Json::parse(R"([1])")), InputError);
  EXPECT_THROW((void)PointObject::read(Json::parse(R"("1")")), InputError);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
