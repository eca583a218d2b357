#include "properties/instances/space_object.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "support/error.hpp"
#include "tests/support/ratio.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

using Points = std::vector<ExactPoint>;

const Points& some_points() {
  static const Points points{{ratio(1, 3), ratio(-1, 4), ratio(1, 2)},
                             {Rational(0), Rational(0), Rational(0)},
                             {ratio(-5, 4), ratio(1, 8), Rational(1)},
                             {ratio(3, 7), ratio(1, 9), ratio(-1, 5)}};
  return points;
}

Rational squared_length(const ExactPoint& point) { return pairing(point, point); }

TEST(SpaceObject, SeesFromTheOriginWhatItIsGiven) {
  for (const Curvature curvature : {Curvature::negative, Curvature::positive}) {
    const SpaceObject space(curvature, Rational(2), some_points());
    for (std::size_t at = 0; at < space.size(); ++at) EXPECT_EQ(space.seen_from(1, at), some_points()[at]);
  }
}

/// Two points see each other at the same distance, and a point as far as sees the Möbius difference of the plane.
TEST(SpaceObject, DistancesAreSymmetricAndThoseOfTheMoebiusDifference) {
  for (const Curvature curvature : {Curvature::negative, Curvature::positive}) {
    const SpaceObject space(curvature, Rational(1), some_points());
    const Rational k(sign_of(curvature));
    for (std::size_t a = 0; a < space.size(); ++a) {
      for (std::size_t b = 0; b < a; ++b) {
        const Rational squared = squared_length(*space.seen_from(a, b));
        EXPECT_EQ(squared, squared_length(*space.seen_from(b, a)));
        // |x − y|²/(1 + 2K⟨x, y⟩/4 + |x|²|y|²/16), for the coordinates x and y.
        const ExactPoint& x = some_points()[a];
        const ExactPoint& y = some_points()[b];
        const ExactPoint step = combined(x, Rational(-1), y);
        const Rational divisor =
            Rational(1) + k * pairing(x, y) / Rational(2) + pairing(x, x) * pairing(y, y) / Rational(16);
        EXPECT_EQ(squared, pairing(step, step) / divisor);
      }
    }
  }
}

TEST(SpaceObject, AnAntipodeIsNotSeen) {
  const SpaceObject sphere(Curvature::positive, Rational(1),
                           {{Rational(1), Rational(1)}, {Rational(-2), Rational(-2)}});
  EXPECT_FALSE(sphere.seen_from(0, 1).has_value());
  EXPECT_TRUE(sphere.seen_from(0, 0).has_value());
  EXPECT_THROW((void)sphere.seen_from(0, 2), InputError);
}

TEST(SpaceObject, WhatIsNoPointOfASpaceIsRefused) {
  const auto refused = [](Curvature curvature, const Rational& unit, const Points& points) {
    EXPECT_THROW(SpaceObject(curvature, unit, points), InputError);
  };
  refused(Curvature::zero, Rational(1), some_points());
  refused(Curvature::positive, Rational(0), some_points());
  refused(Curvature::positive, Rational(1), {});
  refused(Curvature::positive, Rational(1), {{Rational(1)}});
  refused(Curvature::positive, Rational(1), {{Rational(1), Rational(1)}, {Rational(1), Rational(1), Rational(1)}});
  refused(Curvature::negative, Rational(1), {{Rational(2), Rational(0)}});
  EXPECT_NO_THROW(SpaceObject(Curvature::positive, Rational(1), {{Rational(2), Rational(0)}}));
}

TEST(SpaceObject, ReadsBackBitForBit) {
  const SpaceObject space(Curvature::negative, ratio(7, 3), some_points());
  const auto json = space.json();
  EXPECT_EQ(SpaceObject::read(nlohmann::ordered_json::parse(json.dump()))->json(), json);
  for (const auto& [key, value] : json.items()) {
    auto bad = json;
    bad.erase(key);
    EXPECT_THROW((void)SpaceObject::read(bad), InputError) << key;
    bad[key] = 0;
    EXPECT_THROW((void)SpaceObject::read(bad), InputError) << key;
  }
}

TEST(SpaceObject, LengthsOfCoordinatesAreTangentsFromBelow) {
  // tan(π/4) = 1 and tanh(log(3)/2) = 1/2, a little below and above these distances.
  EXPECT_LT(conformal_length(Curvature::positive, ratio(15707, 10000)), Rational(2));
  EXPECT_GT(conformal_length(Curvature::positive, ratio(15708, 10000)), Rational(2));
  EXPECT_LT(conformal_length(Curvature::negative, ratio(10986, 10000)), Rational(1));
  EXPECT_GT(conformal_length(Curvature::negative, ratio(10987, 10000)), Rational(1));
  EXPECT_EQ(conformal_length(Curvature::positive, Rational(0)), Rational(0));
  const Rational tiny = Rational::power_of_two(-200);
  EXPECT_LE(conformal_length(Curvature::negative, tiny), tiny);
  EXPECT_GE(conformal_length(Curvature::negative, tiny), tiny * (Rational(1) - Rational::power_of_two(-50)));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
