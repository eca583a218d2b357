#include "properties/instances/run_class.hpp"

#include "properties/attack/claim_library.hpp"
#include "properties/attack/claim_variants.hpp"
#include "tests/properties/instances/net_checks.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

TEST(RunClass, DrawsWhatItPromisesOnSurfaces) {
  const auto traits = check_net_draws(run_class(), {0, 2}, NoLimits(), 12);
  EXPECT_GT(traits.at(Trait::boundary), 2);
}

TEST(RunClass, RefusesWhatIsNoInstance) {
  const Bindings good = some_instance(run_class(), {0, 2}, NoLimits());
  for (const char* name : {"epsilon", "mu0", "rho0"}) {
    Bindings bad = good;
    bad[name] = std::get<Rational>(good.at(name)) + Rational::power_of_two(-60);
    EXPECT_THROW(run_class().require(bad), InputError) << name;
  }
  Bindings bad = good;
  bad["m"] = 3L;
  EXPECT_THROW(run_class().require(bad), InputError);
}

TEST(RunClass, ItsClaimsHold) {
  for (const char* name :
       {"algorithm-guarantee", "manifold-mesh", "delaunay-complex", "riemannian-delaunay-triangulation"}) {
    check_claim(name, {0, 2}, 8);
  }
}

TEST(RunClass, WithoutTheHypothesisTheClaimsAreRefuted) {
  const ClaimCount count = count_outcomes(twin_of_hypothesis(find_claim("delaunay-complex"), 0), {0, 2}, 60);
  EXPECT_GT(count.violated, 0);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
