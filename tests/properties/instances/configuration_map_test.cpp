#include "properties/instances/configuration_map.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "kernel/simplex/edge_gram.hpp"
#include "support/error.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

/// Stretching by (1/8, −1/8) along the axes and a fold of constant 1/16 in the plane.
ConfigurationMap::Data example() {
  const Rational eighth = Rational(1) / Rational(8);
  ConfigurationMap::Data data;
  data.mirror = {1, 1};
  data.stretching = {{eighth}, {0, -eighth}};
  data.stretch = eighth;
  data.fold_direction = {0, Rational(1) / Rational(16)};
  data.fold_normal = {1, 0};
  data.fold_offset = Rational(1) / Rational(2);
  data.fold = Rational(1) / Rational(16);
  return data;
}

TEST(ConfigurationMap, ImagesAreAsByHand) {
  // (1, 2) ↦ (9/8, 7/4) + (0, 1/32), mirrored at the line x + y = 0.
  const auto image = ConfigurationMap(example()).image({{1, 2}});
  const Rational y = Rational(7) / Rational(4) + Rational(1) / Rational(32);
  EXPECT_EQ(image, (SimplexObject::Points{{-y, -Rational(9) / Rational(8)}}));
}

TEST(ConfigurationMap, NoDistanceIsDistortedMoreThanCertified) {
  const ConfigurationMap map(example());
  EXPECT_EQ(map.distortion(), Rational(3) / Rational(16));
  SimplexObject::Points points;
  for (long x = -3; x <= 3; ++x) {
    for (long y = -3; y <= 3; ++y) points.push_back({Rational(x) / Rational(2), Rational(y) / Rational(3)});
  }
  const auto before = edge_gram_from_points(points);
  const auto after = edge_gram_from_points(map.image(points));
  bool is_sharp = false;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Rational& edge = before.squared_edge(i, j);
      EXPECT_LE(after.squared_edge(i, j), square(Rational(1) + map.distortion()) * edge);
      EXPECT_GE(after.squared_edge(i, j), square(Rational(1) - map.distortion()) * edge);
      is_sharp = is_sharp || after.squared_edge(i, j) >= square(Rational(1) + Rational(1) / Rational(8)) * edge;
    }
  }
  EXPECT_TRUE(is_sharp);
}

TEST(ConfigurationMap, ACertificateThatDoesNotHoldIsRefused) {
  EXPECT_NO_THROW(ConfigurationMap{example()});
  ConfigurationMap::Data stretched = example();
  stretched.stretch -= Rational::power_of_two(-200);
  EXPECT_THROW(ConfigurationMap{stretched}, InputError);
  ConfigurationMap::Data folded = example();
  folded.fold -= Rational::power_of_two(-200);
  EXPECT_THROW(ConfigurationMap{folded}, InputError);
  ConfigurationMap::Data large = example();
  large.stretch = Rational(15) / Rational(16);
  EXPECT_THROW(ConfigurationMap{large}, InputError);
}

TEST(ConfigurationMap, PartsOfDifferentDimensionsAreRefused) {
  ConfigurationMap::Data data = example();
  data.fold_normal = {1, 0, 0};
  EXPECT_THROW(ConfigurationMap{data}, InputError);
  data = example();
  data.stretching = {{0}, {0}};
  EXPECT_THROW(ConfigurationMap{data}, InputError);
  EXPECT_THROW((void)ConfigurationMap(example()).image({{1, 2, 3}}), InputError);
}

TEST(ConfigurationMap, ReadsBackWhatItWrites) {
  const ConfigurationMap map(example());
  const auto again = ConfigurationMap::read(map.json());
  EXPECT_EQ(again->json(), map.json());
  EXPECT_EQ(dynamic_cast<const ConfigurationMap&>(*again).image({{1, 2}, {-3, 5}}), map.image({{1, 2}, {-3, 5}}));
}

/// Three points of a line, the last one moved off it: its distances √(1 + 1/64) and √(4 + 1/64).
ConfigurationMap::Finite finite_example() {
  return {{{0, 0}, {1, 0}, {2, 0}}, {{0, 0}, {1, 0}, {2, Rational(1) / Rational(8)}}, Rational(1) / Rational(64)};
}

TEST(ConfigurationMap, AFiniteMapIsDecidedPairByPair) {
  const ConfigurationMap map(finite_example());
  EXPECT_TRUE(map.is_finite());
  EXPECT_EQ(map.distortion(), Rational(1) / Rational(64));
  EXPECT_EQ(map.dimension(), 2U);
  EXPECT_EQ(map.image({{2, 0}, {0, 0}}), (SimplexObject::Points{{2, Rational(1) / Rational(8)}, {0, 0}}));
  // √(1 + 1/64) − 1 is between 1/129 and 1/128.
  ConfigurationMap::Finite finite = finite_example();
  finite.distortion = Rational(1) / Rational(128);
  EXPECT_NO_THROW(ConfigurationMap{finite});
  finite.distortion = Rational(1) / Rational(129);
  EXPECT_THROW(ConfigurationMap{finite}, InputError);
}

TEST(ConfigurationMap, AFiniteMapIsDefinedOnItsPointsOnly) {
  const ConfigurationMap map(finite_example());
  EXPECT_TRUE(map.is_defined_on({{1, 0}, {2, 0}}));
  EXPECT_FALSE(map.is_defined_on({{1, 0}, {1, 1}}));
  EXPECT_FALSE(map.is_defined_on({{1, 0, 0}}));
  EXPECT_THROW((void)map.image({{1, 1}}), InputError);
  ConfigurationMap::Finite finite = finite_example();
  finite.images.pop_back();
  EXPECT_THROW(ConfigurationMap{finite}, InputError);
  finite = finite_example();
  finite.images[1] = {1, 0, 0};
  EXPECT_THROW(ConfigurationMap{finite}, InputError);
  EXPECT_THROW(ConfigurationMap(ConfigurationMap::Finite{}), InputError);
  // Two points with one image.
  EXPECT_THROW(ConfigurationMap(ConfigurationMap::Finite{{{0}, {1}}, {{0}, {0}}, Rational(1)}), InputError);
}

TEST(ConfigurationMap, AFiniteMapReadsBack) {
  const ConfigurationMap map(finite_example());
  const auto again = ConfigurationMap::read(map.json());
  EXPECT_EQ(again->json(), map.json());
  for (const char* key : {"points", "images", "distortion"}) {
    auto wrong = map.json();
    wrong[key] = 1;
    EXPECT_THROW((void)ConfigurationMap::read(wrong), InputError) << key;
  }
}

TEST(ConfigurationMap, MalformedWitnessesAreRefused) {
  const auto good = ConfigurationMap(example()).json();
  for (const char* key : {"mirror", "stretching", "stretch", "fold_direction", "fold_normal", "fold_offset", "fold"}) {
    auto without = good;
    without.erase(key);
    EXPECT_THROW((void)ConfigurationMap::read(without), InputError) << key;
    auto wrong = good;
    wrong[key] = 1;
    EXPECT_THROW((void)ConfigurationMap::read(wrong), InputError) << key;
  }
  EXPECT_THROW((void)ConfigurationMap::read(nlohmann::ordered_json::array()), InputError);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
