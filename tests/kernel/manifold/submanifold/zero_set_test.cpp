#include "kernel/manifold/submanifold/zero_set.hpp"

#include "support/error.hpp"
#include "tests/kernel/manifold/submanifold/samples.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

TEST(ZeroSet, has_the_dimension_that_equations_leave) {
  const ZeroSet torus = clifford_torus();
  EXPECT_EQ(torus.dimension(), 2U);
  EXPECT_EQ(torus.ambient(), 4U);
  EXPECT_EQ(torus.codimension(), 2U);
  // A copy shares the map.
  const ZeroSet copy = torus;
  EXPECT_EQ(&copy.map(), &torus.map());
}

TEST(ZeroSet, refuses_what_does_not_fit) {
  const auto refusal = [](const auto& change) {
    SubmanifoldDescription description = unit_sphere_in_space().description();
    change(description);
    return message_of<InputError>([&] { (void)ZeroSet(description); });
  };
  EXPECT_TRUE(
      mentions(refusal([](auto& d) { d.dimension = Dimension(1); }), "its dimension is 1, with 3 variables and 1"));
  EXPECT_TRUE(mentions(refusal([](auto& d) { d.box.pop_back(); }), "the box has 2 sides"));
  EXPECT_TRUE(mentions(refusal([](auto& d) { d.box[1] = {Rational(1), Rational(1)}; }), "the box for y is empty"));
  EXPECT_TRUE(mentions(refusal([](auto& d) { d.variables = {"x"}; }), "there are 1 variables"));
  EXPECT_TRUE(mentions(refusal([](auto& d) { d.equations[0] = "x + w"; }), "w"));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
