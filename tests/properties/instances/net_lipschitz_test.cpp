#include "properties/instances/net_lipschitz.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "kernel/formula/parser.hpp"
#include "proofs/formula/decision.hpp"
#include "proofs/formula/simplex_object.hpp"
#include "proofs/formula/type_check.hpp"
#include "properties/instances/instance_class.hpp"
#include "support/error.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

SizingObject two_cones() {
  return {Rational::power_of_two(-1),
          {{{Rational(0), Rational(0)}, Rational(1)}, {{Rational(4), Rational(0)}, Rational(2)}}};
}

Verdict verdict(const std::string& formula) {
  Bindings bindings;
  bindings["f"] = ObjectPointer(std::make_shared<SizingObject>(two_cones()));
  bindings["a"] = ObjectPointer(std::make_shared<PointObject>(std::vector<Rational>{Rational(1), Rational(1)}));
  bindings["b"] = ObjectPointer(std::make_shared<PointObject>(std::vector<Rational>{Rational(4), Rational(5)}));
  const Signature signature{{"f", types::sizing}, {"a", types::point}, {"b", types::point}};
  const auto statement = type_checked(parse_formula(formula), full_vocabulary(), signature, types::truth);
  Scene scene(bindings);
  return decide_statement(*statement, scene);
}

TEST(Sizing, is_the_least_of_its_cones) {
  EXPECT_EQ(verdict("sizing(f, a) = 1 + sqrt(2)/2"), Verdict::proved);
  EXPECT_EQ(verdict("sizing(f, b) = 1 + sqrt(41)/2"), Verdict::proved);
  EXPECT_EQ(verdict("sizing(f, b) < 42/10"), Verdict::refuted);
  EXPECT_EQ(verdict("point_distance(a, b) = 5"), Verdict::proved);
}

TEST(Sizing, reads_back_what_it_wrote_and_refuses_the_rest) {
  const SizingObject f = two_cones();
  EXPECT_EQ(SizingObject::read(f.json())->json(), f.json());
  EXPECT_THROW(SizingObject(Rational(-1), {{{Rational(0)}, Rational(1)}}), InputError);
  EXPECT_THROW(SizingObject(Rational(1), {}), InputError);
  EXPECT_THROW(SizingObject(Rational(1), {{{Rational(0)}, Rational(0)}}), InputError);
  EXPECT_THROW(SizingObject(Rational(1), {{{Rational(0)}, Rational(1)}, {{Rational(0), Rational(0)}, Rational(1)}}),
               InputError);
  EXPECT_THROW((void)SizingObject::read(nlohmann::ordered_json::parse(R"({"slope": 1})")), InputError);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
