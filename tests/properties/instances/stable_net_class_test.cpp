#include "properties/instances/stable_net_class.hpp"

#include "proofs/formula/simplex_object.hpp"
#include "properties/instances/net_chart.hpp"
#include "tests/properties/instances/net_checks.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

TEST(StableNetClass, DrawsWhatItPromises) {
  const auto traits =
      check_net_draws(stable_net_class(), {0, 2},
                      FixedLimits({{"rho0", Rational::power_of_two(-4)}, {"xi", Rational::power_of_two(-60)}}), 12);
  EXPECT_GT(traits.at(Trait::boundary), 0);
}

TEST(StableNetClass, StructuredDrawsAreInstances) {
  const FixedLimits limits({{"rho0", Rational::power_of_two(-4)}, {"xi", Rational::power_of_two(-60)}});
  ASSERT_TRUE(stable_net_class().has_structure({0, 2}));
  int found = 0;
  for (std::uint32_t number = 0; number < 6; ++number) {
    RandomChoices choices(3, 5, number);
    const auto instance = stable_net_class().draw_structured({0, 2}, {}, limits, choices);
    if (!instance) continue;
    ++found;
    EXPECT_NO_THROW(stable_net_class().require(instance->bindings));
  }
  EXPECT_GT(found, 3);
}

TEST(StableNetClass, RefusesWhatIsNoInstance) {
  const Bindings good = some_instance(stable_net_class(), {0, 2}, FixedLimits({{"rho0", Rational::power_of_two(-4)}}));
  ASSERT_NO_THROW(stable_net_class().require(good));
  const auto refuses = [&](const std::string& name, const Binding& value) {
    Bindings bad = good;
    bad[name] = value;
    EXPECT_THROW(stable_net_class().require(bad), InputError) << name;
  };
  refuses("xi", Rational(-1));
  refuses("j", 0L);
  refuses("w", good.at("q"));
  const ChartMap twice{Rational(2), Rational(0), Rational(0), Rational(2)};
  refuses("phi", ObjectPointer(std::make_shared<PointObject>(twice)));
}

TEST(StableNetClass, ItsClaimsHold) {
  for (const char* name : {"star-under-transition", "delaunay-metric-stability"}) check_claim(name, {0, 2}, 10);
  check_claim("stable-stars", {0, 2}, 25);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
