#include "properties/instances/map_object.hpp"

#include <nlohmann/json.hpp>

#include "kernel/manifold/any_manifold.hpp"
#include "kernel/manifold/builtin_manifolds.hpp"
#include "properties/instances/map_draw.hpp"
#include "tests/properties/instances/class_checks.hpp"
#include "tests/support/ratio.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

const Rational tiny = Rational::power_of_two(-200);

MapObject stretching(const Rational& first, const Rational& second) {
  return MapObject(LinearMap{{{first, Rational(0)}, {Rational(0), second}}, {Rational(1), Rational(2)}});
}

TEST(MapObject, LinearMapsHaveTheDistortionOfTheirSingularValues) {
  const MapObject map = stretching(ratio(11, 10), ratio(9, 10));
  EXPECT_EQ(map.image({Rational(10), Rational(20)}), (ExactPoint{Rational(12), Rational(20)}));
  EXPECT_TRUE(map.has_distortion(ratio(1, 10)));
  EXPECT_FALSE(map.has_distortion(ratio(1, 10) - tiny));
  EXPECT_FALSE(stretching(Rational(1), Rational(1) - tiny).has_distortion(tiny / Rational(2)));
  EXPECT_TRUE(stretching(Rational(-1), Rational(1) - tiny).has_distortion(tiny));
  // A shear by 1/5 has the singular values √(1 + 1/100) ± 1/10.
  const MapObject shear(
      LinearMap{{{Rational(1), ratio(1, 5)}, {Rational(0), Rational(1)}}, {Rational(0), Rational(0)}});
  EXPECT_TRUE(shear.has_distortion(ratio(1051, 10000)));
  EXPECT_FALSE(shear.has_distortion(ratio(1049, 10000)));
}

TEST(MapObject, InversionsHaveTheDistortionOfTheirBall) {
  const MapObject map(
      InversionMap{{Rational(10), Rational(0)}, Rational(100), {Rational(0), Rational(0)}, Rational(1), Rational(10)});
  EXPECT_EQ(map.image({Rational(0), Rational(0)}), (ExactPoint{Rational(0), Rational(0)}));
  EXPECT_EQ(map.image({Rational(5), Rational(0)}), (ExactPoint{Rational(-10), Rational(0)}));
  EXPECT_FALSE(map.image({Rational(10), Rational(0)}).has_value());
  EXPECT_TRUE(map.is_in_domain({Rational(1), Rational(0)}));
  EXPECT_FALSE(map.is_in_domain({Rational(1), Rational(1)}));
  // Two points of the ball near its end towards the pole: the factor is near 100/81.
  EXPECT_TRUE(map.has_distortion(ratio(19, 81)));
  EXPECT_FALSE(map.has_distortion(ratio(19, 81) - tiny));
  const auto a = *map.image({Rational(1), Rational(0)});
  const auto b = *map.image({ratio(999, 1000), Rational(0)});
  EXPECT_GT(squared_distance_between(a, b), square(ratio(1233, 1000) / Rational(1000)));
}

TEST(MapObject, SmoothMapsHaveNoMoreThanTheirLipschitzBound) {
  RandomChoices choices(1, 1, 0);
  const SimplexObject simplex({{Rational(0), Rational(0)}, {Rational(1), Rational(0)}, {Rational(0), Rational(1)}});
  const auto centred = *with_centre(simplex, true, choices);
  for (int time = 0; time < 20; ++time) {
    const SmoothMap smooth = random_smooth_map(centred, ratio(1, 5), choices);
    const MapObject map(smooth);
    const Rational bound = lipschitz_bound(smooth);
    EXPECT_LE(bound, ratio(1, 5));
    EXPECT_TRUE(map.has_distortion(bound));
    EXPECT_FALSE(map.has_distortion(bound - tiny));
    // As a map of finitely many points it cannot have more.
    FiniteMap finite{{}, {}, 12};
    for (int i = 0; i < 12; ++i) {
      finite.points.push_back({choices.symmetric(8), choices.symmetric(8)});
      finite.images.push_back(*map.image(finite.points.back()));
    }
    EXPECT_TRUE(MapObject(finite).has_distortion(bound));
  }
}

TEST(MapObject, TheSlopeOfABumpIsBelowThirteenTwentieths) {
  // 2u/(1 + u²)² has its maximum 3√3/8 at u² = 1/3: 27/64 < 169/400.
  EXPECT_LT(ratio(27, 64), ratio(169, 400));
}

TEST(MapObject, FiniteMapsAreCheckedPairByPair) {
  const FiniteMap all{{{Rational(0)}, {Rational(1)}, {Rational(3)}}, {{Rational(0)}, {Rational(1)}, {Rational(4)}}, 3};
  // 3 became 4, 2 became 3.
  EXPECT_TRUE(MapObject(all).has_distortion(ratio(1, 2)));
  EXPECT_FALSE(MapObject(all).has_distortion(ratio(1, 2) - tiny));
  FiniteMap some = all;
  some.domain_count = 2;
  EXPECT_TRUE(MapObject(some).has_distortion(Rational(0)));
  EXPECT_TRUE(MapObject(some).is_in_domain({Rational(1)}));
  EXPECT_FALSE(MapObject(some).is_in_domain({Rational(3)}));
  EXPECT_EQ(MapObject(some).image({Rational(3)}), (ExactPoint{Rational(4)}));
  EXPECT_FALSE(MapObject(some).image({Rational(2)}).has_value());
}

TEST(MapObject, EveryFamilyOfBuiltInManifoldsHasATransition) {
  std::set<ManifoldFamily> all;
  for (const auto& [name, text] : builtin_manifolds()) all.insert(find_manifold(name).family);
  std::set<ManifoldFamily> served;
  for (const std::string& name : manifolds_with_rational_lattices()) served.insert(find_manifold(name).family);
  EXPECT_EQ(served, all);
}

TEST(MapObject, LatticesAreFactorsOfTheirGramMatrices) {
  for (const std::string& name : manifolds_with_rational_lattices()) {
    const auto basis = *rational_lattice(name);
    const auto gram = find_manifold(name).gram;
    for (std::size_t i = 0; i < basis.size(); ++i) {
      for (std::size_t j = 0; j < basis.size(); ++j) {
        Rational product(0);
        for (std::size_t axis = 0; axis < basis.size(); ++axis) product += basis[i][axis] * basis[j][axis];
        EXPECT_EQ(product, gram[i][j]) << name;
      }
    }
  }
  EXPECT_FALSE(rational_lattice("torus-2-hexagonal").has_value());
  EXPECT_THROW((void)rational_lattice("no-such-manifold"), InputError);
}

TEST(MapObject, IsReadBackAndRefusedWhereItIsNone) {
  const MapObject inversion(InversionMap{{Rational(10)}, Rational(100), {Rational(0)}, Rational(1), Rational(10)});
  auto json = inversion.json();
  EXPECT_EQ(MapObject::read(json)->json(), json);
  json["distance"] = "11";
  EXPECT_THROW((void)MapObject::read(json), InputError);
  auto linear = stretching(Rational(1), Rational(2)).json();
  EXPECT_EQ(MapObject::read(linear)->json(), linear);
  linear["rows"].erase(0);
  EXPECT_THROW((void)MapObject::read(linear), InputError);
  RandomChoices choices(1, 1, 0);
  auto transition = MapObject(*random_transition(2, choices)).json();
  EXPECT_EQ(MapObject::read(transition)->json(), transition);
  transition["translation"][0] = "1/3";
  EXPECT_THROW((void)MapObject::read(transition), InputError);
  auto finite = MapObject(FiniteMap{{{Rational(0)}}, {{Rational(1)}}, 1}).json();
  EXPECT_EQ(MapObject::read(finite)->json(), finite);
  finite["domain_count"] = 2;
  EXPECT_THROW((void)MapObject::read(finite), InputError);
  EXPECT_THROW((void)MapObject::read(nlohmann::ordered_json::parse(R"({"form": "cubic"})")), InputError);
  EXPECT_THROW((void)MapObject::read(nlohmann::ordered_json::parse("[]")), InputError);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
