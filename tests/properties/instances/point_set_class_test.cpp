#include "properties/instances/point_set_class.hpp"

#include "proofs/formula/claim.hpp"
#include "proofs/formula/decision.hpp"
#include "proofs/formula/scene.hpp"
#include "properties/attack/hypothesis_limits.hpp"
#include "tests/properties/instances/class_checks.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

Claim claim_about(const std::string& rules) {
  return parse_claim("name = 'n'\ninstance = 'point-set'\n[points]\n" + rules + "[[show]]\nclaim = 'n >= 1'\n",
                     "a.toml", full_vocabulary(), {{"point-set", point_set_class().signature()}});
}

/// How many of 200 draws lead to points, each of which has to meet the constraints exactly.
int draws(const Claim& claim, const Shape& shape) {
  int result = 0;
  const HypothesisLimits limits(claim);
  for (std::uint64_t number = 0; number < 200; ++number) {
    RandomChoices choices(5, 6, number);
    const auto instance = draw_instance(claim, limits, shape, choices);
    if (!instance) continue;
    ++result;
    EXPECT_NO_THROW(point_set_class().require(read_back(instance->bindings, point_set_class().signature())));
    EXPECT_EQ(std::get<long>(instance->bindings.at("n")), shape.k + 1);
    EXPECT_EQ(std::get<long>(instance->bindings.at("m")), shape.m);
    Scene scene(instance->bindings);
    for (const Hypothesis& constraint : claim.hypotheses) {
      EXPECT_EQ(decide_statement(*constraint.formula, scene), Verdict::proved) << constraint.text;
    }
  }
  return result;
}

TEST(PointSetClass, DrawsPointsInTheirBox) {
  EXPECT_EQ(draws(claim_about("number = 3\ndimension = 2\nbox = '[0, 1]'\n"), {2, 2}), 200);
  EXPECT_EQ(draws(claim_about("number = 4\ndimension = 2\nbox = ['(0, 1)', '[5, 5]']\n"), {3, 2}), 200);
}

/// Few random triples have it: without repair one in hundreds.
TEST(PointSetClass, MovesPointsUntilTheyMeetTheConstraints) {
  const Claim claim = claim_about(
      "number = 3\ndimension = 2\nbox = '[0, 1]'\n"
      "constraints = ['forall i in 0 .. 2, j in 0 .. i - 1: 9/10 <= edge(p, i, j) <= 1']\n");
  EXPECT_GT(draws(claim, {2, 2}), 40);
}

TEST(PointSetClass, DrawsNothingWhereAConstraintIsNeverMet) {
  const Claim claim = claim_about("number = 2\ndimension = 2\nbox = '[0, 1]'\nconstraints = ['edge(p, 0, 1) >= 2']\n");
  EXPECT_EQ(draws(claim, {1, 2}), 0);
}

TEST(PointSetClass, ProposesSimplerInstancesOfTheSameSize) {
  const Bindings drawn = some_instance(point_set_class(), {3, 2}, NoLimits());
  check_simpler(point_set_class(), drawn);
  for (const Bindings& each : point_set_class().simpler(drawn)) {
    EXPECT_EQ(std::get<long>(each.at("n")), 4);
    EXPECT_EQ(std::get<long>(each.at("m")), 2);
  }
}

TEST(PointSetClass, RefusesWhatIsNoInstance) {
  const Bindings good = some_instance(point_set_class(), {2, 2}, NoLimits());
  EXPECT_NO_THROW(point_set_class().require(good));
  Bindings bad = good;
  bad["n"] = 4L;
  EXPECT_THROW(point_set_class().require(bad), InputError);
  bad = good;
  bad.erase("m");
  EXPECT_THROW(point_set_class().require(bad), InputError);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
