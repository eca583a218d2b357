#include "properties/instances/local_net_class.hpp"

#include "properties/instances/net_object.hpp"
#include "tests/properties/instances/net_checks.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

TEST(LocalNetClass, DrawsWhatItPromisesInThePlane) {
  const auto traits =
      check_net_draws(local_net_class(), {0, 2}, FixedLimits({{"rho0", Rational::power_of_two(-4)}}), 40);
  EXPECT_GT(traits.at(Trait::boundary), 5);
  EXPECT_GT(traits.at(Trait::cospherical), 0);
}

TEST(LocalNetClass, DrawsWhatItPromisesInSpace) {
  check_net_draws(local_net_class(), {0, 3}, FixedLimits({{"rho0", Rational::power_of_two(-4)}}), 2);
}

TEST(LocalNetClass, RefusesWhatIsNoInstance) {
  const Bindings good = some_instance(local_net_class(), {0, 2}, FixedLimits({{"rho0", Rational::power_of_two(-3)}}));
  ASSERT_NO_THROW(local_net_class().require(good));
  const auto refuses = [&](const std::string& name, const Binding& value) {
    Bindings bad = good;
    bad[name] = value;
    EXPECT_THROW(local_net_class().require(bad), InputError) << name;
  };
  const auto& p = dynamic_cast<const NetObject&>(*std::get<ObjectPointer>(good.at("p")));
  const auto& q = dynamic_cast<const NetObject&>(*std::get<ObjectPointer>(good.at("q")));
  refuses("m", 3L);
  refuses("rho0", Rational(-1));
  refuses("mu0", Rational(3));
  refuses("epsilon", std::get<Rational>(good.at("epsilon")) / Rational(2));
  // A point that is moved too far, one that is missing, a net that is too sparse.
  auto points = q.points();
  points[5][0] += std::get<Rational>(good.at("epsilon"));
  refuses("q", ObjectPointer(std::make_shared<NetObject>(points, q.sampling_radius(), q.ball_radius())));
  points.pop_back();
  refuses("q", ObjectPointer(std::make_shared<NetObject>(points, q.sampling_radius(), q.ball_radius())));
  points = p.points();
  std::swap(points[0], points[1]);
  refuses("p", ObjectPointer(std::make_shared<NetObject>(points, p.sampling_radius(), p.ball_radius())));
  refuses("p", ObjectPointer(std::make_shared<NetObject>(p.points(), p.sampling_radius(), Rational(0))));
}

TEST(LocalNetClass, ProposesInstancesOnly) {
  const FixedLimits limits({{"rho0", Rational::power_of_two(-3)}});
  std::size_t proposed = 0;
  for (std::uint32_t number = 0; number < 4; ++number) {
    const Bindings bindings = some_instance(local_net_class(), {0, 2}, limits, 10 * number);
    for (const Bindings& each : local_net_class().simpler(bindings)) {
      ++proposed;
      EXPECT_NO_THROW(local_net_class().require(each));
    }
  }
  EXPECT_GT(proposed, 0U);
}

TEST(LocalNetClass, ItsClaimsHold) {
  for (const char* name : {"perturbed-net-parameters-mended", "star-in-region-of-interest", "number-of-candidates",
                           "containment-radius-mended"}) {
    check_claim(name, {0, 2}, 12);
  }
  check_claim("protected-stars", {0, 2}, 40);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
