#include "properties/instances/simplex_pair_class.hpp"

#include "proofs/formula/simplex_object.hpp"
#include "tests/properties/instances/class_checks.hpp"
#include "tests/support/ratio.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

TEST(SimplexPairClass, DrawsWhatItPromisesInEveryShape) {
  const auto traits = check_draws(simplex_pair_class(), FixedLimits({{"xi", ratio(2, 3)}}), 10);
  EXPECT_GT(traits.at(Trait::nearly_degenerate), 20);
  EXPECT_GT(traits.at(Trait::boundary), 20);
}

TEST(SimplexPairClass, DrawsAlsoUnderATinyLimitAndWithout) {
  const Rational smallest = Rational::power_of_two(-300);
  check_draws(simplex_pair_class(), FixedLimits({{"xi", smallest}}), 3);
  check_draws(simplex_pair_class(), NoLimits(), 3);
  for (std::uint32_t number = 0; number < 20; ++number) {
    const Bindings bindings =
        some_instance(simplex_pair_class(), {2, 3}, FixedLimits({{"xi", smallest}}), 100 * number);
    EXPECT_LE(std::get<Rational>(bindings.at("xi")), smallest);
  }
}

TEST(SimplexPairClass, ProposesSimplerInstances) {
  for (std::uint32_t number = 0; number < 12; ++number) {
    const FixedLimits limits({{"xi", ratio(1, 4)}});
    check_simpler(simplex_pair_class(), some_instance(simplex_pair_class(), {2, 3}, limits, 50 * number));
  }
}

TEST(SimplexPairClass, RefusesWhatIsNoInstance) {
  const auto edge = [](long length) -> ObjectPointer {
    return std::make_shared<SimplexObject>(SimplexObject::Points{{Rational(0)}, {Rational(length)}});
  };
  const Bindings good{{"s", edge(3)}, {"t", edge(2)}, {"xi", ratio(1, 3)}, {"k", 1L}, {"m", 1L}};
  EXPECT_NO_THROW(simplex_pair_class().require(good));
  const auto refuses = [&](const std::string& name, const Binding& value) {
    Bindings bad = good;
    bad[name] = value;
    EXPECT_THROW(simplex_pair_class().require(bad), InputError) << name;
  };
  refuses("xi", ratio(1, 3) - Rational::power_of_two(-200));
  refuses("xi", Rational(-1));
  refuses("k", 2L);
  refuses("m", 2L);
  refuses("s", edge(0));
  refuses("t", ObjectPointer(std::make_shared<SimplexObject>(
                   SimplexObject::Points{{Rational(0)}, {Rational(3)}, {Rational(4)}})));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
