#include "properties/instances/net_draw.hpp"

#include "properties/instances/net_forbidden.hpp"
#include "tests/properties/instances/net_checks.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

const Rational& number(const PerturbedNet& net, const char* name) {
  return std::get<Rational>(net.instance.bindings.at(name));
}

TEST(PerturbedNet, keeps_to_the_limits_and_reaches_them) {
  const FixedLimits limits({{"mu0", Rational::power_of_two(-1)}, {"rho0", Rational::power_of_two(-5)}});
  int reached = 0;
  for (std::uint32_t at = 0; at < 10; ++at) {
    RandomChoices choices(2, 1, at);
    const auto net = draw_perturbed_net(2, 8, Rational(0), {}, limits, choices);
    ASSERT_TRUE(net.has_value());
    EXPECT_LE(number(*net, "mu0"), Rational::power_of_two(-1));
    EXPECT_LE(number(*net, "rho0"), Rational::power_of_two(-5));
    reached += number(*net, "rho0") == Rational::power_of_two(-5) ? 1 : 0;
    EXPECT_NO_THROW(require_perturbed_net(net->instance.bindings, 8));
    EXPECT_THROW(require_perturbed_net(net->instance.bindings, 9), InputError);
  }
  EXPECT_GT(reached, 0);
}

TEST(PerturbedNet, leaves_room_for_a_distortion) {
  const Rational slack = Rational::power_of_two(-4);
  RandomChoices choices(2, 2, 1);
  const auto net = draw_perturbed_net(2, 8, slack, {}, FixedLimits({{"rho0", Rational(0)}}), choices);
  ASSERT_TRUE(net.has_value());
  const auto& p = dynamic_cast<const NetObject&>(*std::get<ObjectPointer>(net->instance.bindings.at("p")));
  EXPECT_LE(p.covering()->upper * (Rational(1) + slack), number(*net, "epsilon"));
}

TEST(PerturbedNet, has_no_forbidden_configuration_if_gamma0_is_limited_but_for_some) {
  const FixedLimits limits({{"rho0", Rational::power_of_two(-3)}, {"gamma0", Rational::power_of_two(-5)}});
  int with = 0;
  int without = 0;
  for (std::uint32_t at = 0; at < 30; ++at) {
    RandomChoices choices(2, 3, at);
    const auto net = draw_perturbed_net(2, 8, Rational(0), {}, limits, choices);
    ASSERT_TRUE(net.has_value());
    const auto& q = dynamic_cast<const NetObject&>(*std::get<ObjectPointer>(net->instance.bindings.at("q")));
    std::vector<Vector<Rational, 2>> region;
    for (const auto& point : q.vectors<2>()) {
      if (pairing(point, point) < square(Rational(6) * number(*net, "epsilon"))) region.push_back(point);
    }
    const Rational& epsilon = number(*net, "epsilon");
    const auto found = find_forbidden_configuration<2>(
        region, {number(*net, "gamma0"), (Rational(1) + number(*net, "rho0")) * epsilon,
                 number(*net, "delta0") * (number(*net, "mu0") - Rational(2) * number(*net, "rho0")) * epsilon});
    ++(found ? with : without);
  }
  EXPECT_GE(without, 24);
  EXPECT_GT(with, 0);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
