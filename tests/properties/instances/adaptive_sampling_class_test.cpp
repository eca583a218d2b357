#include "properties/instances/adaptive_sampling_class.hpp"

#include "proofs/formula/simplex_object.hpp"
#include "properties/attack/claim_library.hpp"
#include "tests/properties/instances/net_checks.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

TEST(AdaptiveSamplingClass, DrawsWhatItPromisesInEveryShape) {
  for (const Shape& shape : adaptive_sampling_class().shapes()) {
    const auto traits = check_net_draws(adaptive_sampling_class(), shape, FixedLimits({{"c", Rational(1)}}), 60);
    EXPECT_GT(traits.at(Trait::boundary), 5);
  }
}

TEST(AdaptiveSamplingClass, RefusesWhatIsNoInstance) {
  const Bindings good = some_instance(adaptive_sampling_class(), {0, 2}, FixedLimits({{"c", Rational(1)}}));
  ASSERT_NO_THROW(adaptive_sampling_class().require(good));
  const auto refuses = [&](const std::string& name, const Binding& value) {
    Bindings bad = good;
    bad[name] = value;
    EXPECT_THROW(adaptive_sampling_class().require(bad), InputError) << name;
  };
  refuses("m", 1L);
  refuses("nu", Rational(2));
  refuses("c", Rational(0));
  refuses("d", Rational(-1));
  refuses("mu_hat", Rational(100));
  refuses("x", ObjectPointer(std::make_shared<PointObject>(std::vector<Rational>{Rational(0), Rational(1)})));
  refuses("y", good.at("x"));
}

TEST(AdaptiveSamplingClass, ItsClaimsHoldAndTheSlipsOfThePaperAreFound) {
  for (const Shape& shape : adaptive_sampling_class().shapes()) {
    for (const char* name :
         {"adaptive-density", "adaptive-radii-mended", "adaptive-separation", "adaptive-separation-constant-mended"}) {
      check_claim(name, shape, 100);
    }
    EXPECT_GT(count_outcomes(find_claim("adaptive-radii"), shape, 200).violated, 0);
    EXPECT_GT(count_outcomes(find_claim("adaptive-separation-constant"), shape, 20).violated, 0);
  }
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
