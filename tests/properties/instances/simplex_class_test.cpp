#include "properties/instances/simplex_class.hpp"

#include "proofs/formula/simplex_object.hpp"
#include "tests/properties/instances/class_checks.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

ObjectPointer simplex_of(SimplexObject::Points points) { return std::make_shared<SimplexObject>(std::move(points)); }

TEST(SimplexClass, DrawsWhatItPromisesInEveryShape) {
  const auto traits = check_draws(simplex_class(), NoLimits(), 20);
  EXPECT_GT(traits.at(Trait::nearly_degenerate), 50);
}

TEST(SimplexClass, ProposesSimplerInstances) {
  for (const Shape& shape : {Shape{1, 2}, Shape{3, 4}}) {
    check_simpler(simplex_class(), some_instance(simplex_class(), shape, NoLimits()));
  }
}

TEST(SimplexClass, RefusesWhatIsNoInstance) {
  const Bindings good = some_instance(simplex_class(), {2, 2}, NoLimits());
  Bindings bad = good;
  bad["k"] = 3L;
  EXPECT_THROW(simplex_class().require(bad), InputError);
  bad = good;
  bad["s"] = simplex_of({{Rational(0), Rational(0)}, {Rational(1), Rational(1)}, {Rational(2), Rational(2)}});
  EXPECT_THROW(simplex_class().require(bad), InputError);
  bad = good;
  bad.erase("m");
  EXPECT_THROW(simplex_class().require(bad), InputError);
  bad = good;
  bad["s"] = Rational(1);
  EXPECT_THROW(simplex_class().require(bad), InputError);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
