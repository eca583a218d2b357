#include "properties/instances/net_kinds_class.hpp"

#include <gtest/gtest.h>

#include "properties/instances/choices.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

/// A class that only notes for which kind of net it was asked.
class Asked : public NetKindsClass {
 public:
  std::string name() const override { return "asked"; }
  std::string meaning() const override { return ""; }
  Signature signature() const override { return {}; }
  void extend(Vocabulary&) const override {}
  std::vector<Shape> shapes() const override { return {{0, 2}}; }
  void require(const Bindings&) const override {}

  mutable std::vector<NetKind> kinds;

 private:
  std::optional<Instance> draw_of(NetKind kind, const Shape&, const Bindings&, const Limits&, Choices&) const override {
    kinds.push_back(kind);
    return std::nullopt;
  }
};

TEST(NetKindsClass, attacks_draw_any_net_and_searches_begin_with_degenerate_ones) {
  const Asked asked;
  const NoLimits limits;
  RandomChoices choices(1, 0, 0);
  EXPECT_FALSE(asked.draw({0, 2}, {}, limits, choices));
  EXPECT_FALSE(asked.draw_structured({0, 2}, {}, limits, choices));
  EXPECT_EQ(asked.kinds, (std::vector{NetKind::any, NetKind::nearly_degenerate}));
  EXPECT_TRUE(asked.has_structure({0, 2}));
  EXPECT_TRUE(asked.simpler({}).empty());
}

TEST(NetKindsClass, are_those_of_stars_in_two_charts_and_not_of_one) {
  for (const char* name : {"stable-net", "curved-net"})
    EXPECT_NE(dynamic_cast<const NetKindsClass*>(&instance_class(name)), nullptr) << name;
  EXPECT_EQ(dynamic_cast<const NetKindsClass*>(&instance_class("local-net")), nullptr);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
