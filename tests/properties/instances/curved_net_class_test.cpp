#include "properties/instances/curved_net_class.hpp"

#include "properties/instances/space_object.hpp"
#include "tests/properties/instances/net_checks.hpp"
#include "tests/support/ratio.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

const FixedLimits& some_limits() {
  static const FixedLimits limits({{"rho0", Rational::power_of_two(-4)}, {"xi", Rational::power_of_two(-12)}});
  return limits;
}

TEST(CurvedNetClass, DrawsWhatItPromises) {
  const auto traits = check_net_draws(curved_net_class(), {0, 2}, some_limits(), 6);
  EXPECT_GT(traits.at(Trait::boundary), 0);
}

TEST(CurvedNetClass, DistortionsComeNearTheirLimitAndRadiiDiffer) {
  Rational greatest(0);
  bool do_radii_differ = false;
  std::set<std::string> manifolds;
  for (std::uint32_t number = 0; number < 8; ++number) {
    RandomChoices choices(2, 9, number);
    const auto instance = curved_net_class().draw({0, 2}, {}, some_limits(), choices);
    if (!instance) continue;
    const Bindings& bindings = instance->bindings;
    if (number_in(bindings, "xi") <= Rational::power_of_two(-12)) {
      greatest = maximum(greatest, number_in(bindings, "xi"));
    }
    do_radii_differ = do_radii_differ || number_in(bindings, "epsilon_i") != number_in(bindings, "epsilon_j");
    manifolds.insert(curved_net_class().manifold(bindings));
  }
  EXPECT_GT(greatest, Rational::power_of_two(-12) * ratio(9, 10));
  EXPECT_TRUE(do_radii_differ);
  EXPECT_EQ(manifolds, (std::set<std::string>{"hyperbolic space", "sphere"}));
}

TEST(CurvedNetClass, StructuredDrawsAreInstances) {
  ASSERT_TRUE(curved_net_class().has_structure({0, 2}));
  RandomChoices choices(3, 5, 1);
  const auto instance = curved_net_class().draw_structured({0, 2}, {}, some_limits(), choices);
  ASSERT_TRUE(instance.has_value());
  EXPECT_NO_THROW(curved_net_class().require(instance->bindings));
}

TEST(CurvedNetClass, RefusesWhatIsNoInstance) {
  const Bindings good = some_instance(curved_net_class(), {0, 2}, some_limits());
  ASSERT_NO_THROW(curved_net_class().require(good));
  const auto refuses = [&](const std::string& name, const Binding& value) {
    Bindings bad = good;
    bad[name] = value;
    EXPECT_THROW(curved_net_class().require(bad), InputError) << name;
  };
  const Rational less = Rational(1) - Rational::power_of_two(-10);
  for (const char* name : {"epsilon", "epsilon_i", "xi", "eta"}) refuses(name, number_in(good, name) * ratio(1, 2));
  refuses("epsilon_j", number_in(good, "epsilon_j") * Rational(2));
  refuses("mu0", number_in(good, "mu0") / less);
  refuses("rho0", number_in(good, "rho0") * less - Rational::power_of_two(-20));
  refuses("i", 1L);
  refuses("j", 0L);
  refuses("j", 100000L);
  refuses("m", 3L);
  refuses("w", good.at("q"));
  const auto& p = object_in<SpaceObject>(good, "p");
  const auto refuses_points = [&](std::vector<ExactPoint> points) {
    refuses("p", ObjectPointer(std::make_shared<SpaceObject>(p.curvature(), p.unit(), std::move(points))));
  };
  auto points = p.points();
  points[0][0] += Rational::power_of_two(-60);
  refuses_points(points);
  points = p.points();
  points.pop_back();
  refuses_points(points);
  // A hole: a neighbour of the first point goes to where another one is, nearly.
  points = p.points();
  points[static_cast<std::size_t>(std::get<long>(good.at("j")))] = points.back();
  points.back()[0] += Rational::power_of_two(-30);
  refuses_points(points);
}

TEST(CurvedNetClass, StarsInBothChartsAreCertifiedWhereverANetIsDrawn) {
  for (const char* name : {"curved-stable-stars", "curved-star-under-transition"}) {
    const Claim claim = find_claim(name);
    for (std::uint32_t number = 0; number < 4; ++number) {
      RandomChoices choices(8, 1, number);
      const auto instance = draw_instance(claim, HypothesisLimits(claim), {0, 2}, choices);
      if (!instance) continue;
      const Attempt result = attempt(claim, instance->bindings);
      EXPECT_FALSE(is_undecided(result.hypotheses)) << name << number;
      for (const auto& conclusion : result.conclusions) EXPECT_TRUE(is_proved(conclusion.verdict)) << name << number;
    }
  }
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
