#include "properties/instances/distortion_map_class.hpp"

#include <set>

#include "properties/instances/map_object.hpp"
#include "tests/properties/instances/class_checks.hpp"
#include "tests/support/ratio.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

std::string form_of(const Bindings& bindings) {
  return object_of<MapObject>(std::get<ObjectPointer>(bindings.at("phi"))).form_name();
}

TEST(DistortionMapClass, DrawsWhatItPromisesInEveryShape) {
  const auto traits = check_draws(distortion_map_class(), FixedLimits({{"xi", ratio(1, 100)}}), 6);
  EXPECT_GT(traits.at(Trait::nearly_degenerate), 10);
  EXPECT_GT(traits.at(Trait::boundary), 10);
}

TEST(DistortionMapClass, DrawsAlsoUnderATinyLimitAndWithout) {
  check_draws(distortion_map_class(), FixedLimits({{"xi", Rational::power_of_two(-200)}}), 2);
  check_draws(distortion_map_class(), NoLimits(), 2);
}

TEST(DistortionMapClass, EveryFormOccurs) {
  std::set<std::string> forms;
  std::set<Rational> outside;
  for (std::uint32_t number = 0; number < 200; ++number) {
    RandomChoices choices(2, 1, number);
    const auto instance = distortion_map_class().draw({2, 3}, {}, FixedLimits({{"xi", ratio(1, 50)}}), choices);
    if (!instance) continue;
    forms.insert(form_of(instance->bindings));
    outside.insert(std::get<Rational>(instance->bindings.at("outside")));
  }
  EXPECT_EQ(forms, (std::set<std::string>{"finite", "inversion", "linear", "smooth", "transition"}));
  EXPECT_EQ(outside, (std::set<Rational>{Rational(0), Rational(1)}));
}

TEST(DistortionMapClass, MeetsTheLimitsOfTheCentre) {
  const FixedLimits limits({{"xi", ratio(1, 50)}, {"offset", Rational(0)}, {"outside", Rational(0)}});
  for (std::uint32_t number = 0; number < 40; ++number) {
    const Bindings bindings = some_instance(distortion_map_class(), {2, 4}, limits, 100 * number);
    EXPECT_EQ(std::get<Rational>(bindings.at("offset")), Rational(0));
    EXPECT_EQ(std::get<Rational>(bindings.at("outside")), Rational(0));
    EXPECT_LE(std::get<Rational>(bindings.at("xi")), ratio(1, 50));
  }
}

TEST(DistortionMapClass, ProposesSimplerInstances) {
  for (std::uint32_t number = 0; number < 10; ++number) {
    const FixedLimits limits({{"xi", ratio(1, 50)}});
    check_simpler(distortion_map_class(), some_instance(distortion_map_class(), {2, 3}, limits, 50 * number));
  }
}

TEST(DistortionMapClass, RefusesWhatIsNoInstance) {
  const FixedLimits limits({{"xi", ratio(1, 50)}, {"outside", Rational(0)}});
  const Bindings good = some_instance(distortion_map_class(), {2, 3}, limits);
  EXPECT_NO_THROW(distortion_map_class().require(good));
  const auto refuses = [&](const std::string& name, const Binding& value) {
    Bindings bad = good;
    bad[name] = value;
    EXPECT_THROW(distortion_map_class().require(bad), InputError) << name;
  };
  refuses("xi", Rational(0));
  refuses("xi", Rational::power_of_two(-2000));
  refuses("offset", std::get<Rational>(good.at("offset")) + Rational(1));
  refuses("outside", Rational(1));
  refuses("k", 3L);
  refuses("m", 2L);
  refuses("t", good.at("s"));
  refuses("c", good.at("c_image"));
  const auto& centre = object_of<PointObject>(std::get<ObjectPointer>(good.at("c"))).coordinates();
  auto moved = centre;
  moved[0] += Rational::power_of_two(-400);
  refuses("c", ObjectPointer(std::make_shared<PointObject>(moved)));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
