#include "properties/instances/instance_class.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "support/error.hpp"
#include "tests/properties/attack/small_claims.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

using test::triangle_bindings;

TEST(InstanceClass, classes_are_in_alphabetical_order_and_found_by_name) {
  ASSERT_GE(instance_classes().size(), 2U);
  EXPECT_TRUE(std::is_sorted(instance_classes().begin(), instance_classes().end(),
                             [](const auto* a, const auto* b) { return a->name() < b->name(); }));
  for (const InstanceClass* each : instance_classes()) {
    EXPECT_EQ(&instance_class(each->name()), each);
    EXPECT_FALSE(each->shapes().empty()) << each->name();
    EXPECT_FALSE(each->meaning().empty()) << each->name();
    for (const Shape& shape : each->shapes()) {
      EXPECT_GE(each->cost(shape), 1U) << each->name();
      EXPECT_TRUE(each->has(shape)) << each->name();
    }
  }
}

TEST(InstanceClass, an_unknown_class_gets_a_suggestion) {
  try {
    (void)instance_class("simplx");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("did you mean simplex?"), std::string::npos) << error.what();
  }
}

TEST(InstanceClass, shapes_go_beyond_those_listed_but_not_where_there_is_none) {
  const InstanceClass& simplices = instance_class("simplex");
  EXPECT_TRUE(simplices.has({2, 3}));
  EXPECT_TRUE(simplices.has({8, 9}));
  EXPECT_FALSE(simplices.has({9, 9}));
  EXPECT_FALSE(simplices.has({7, 11}));
  EXPECT_FALSE(simplices.has({3, 2}));
  EXPECT_FALSE(simplices.has({0, 2}));
  EXPECT_FALSE(simplices.has({1, 0}));
  EXPECT_FALSE(simplices.has({-1, -1}));
}

TEST(InstanceClass, a_shape_beyond_those_listed_can_be_drawn) {
  for (const InstanceClass* each : instance_classes()) {
    const Shape largest = each->shapes().back();
    const Shape beyond{largest.k + 1, largest.m + 1};
    if (!each->has(beyond)) continue;
    RandomChoices choices(1, 2, 3);
    const auto instance = each->draw(beyond, {}, NoLimits(), choices);
    if (!instance) continue;
    EXPECT_NO_THROW(each->require(instance->bindings)) << each->name();
  }
}

TEST(InstanceClass, names_and_types_are_those_of_the_signature) {
  const InstanceClass& simplices = instance_class("simplex");
  Bindings good = triangle_bindings(0, 1);
  EXPECT_NO_THROW(require_signature(simplices, good));
  good["eta"] = Rational(1);
  EXPECT_NO_THROW(require_signature(simplices, good));

  Bindings missing = triangle_bindings(0, 1);
  missing.erase("s");
  EXPECT_THROW(require_signature(simplices, missing), InputError);
  Bindings number = triangle_bindings(0, 1);
  number["s"] = Rational(1);
  EXPECT_THROW(require_signature(simplices, number), InputError);
  Bindings rational = triangle_bindings(0, 1);
  rational["k"] = Rational(2);
  EXPECT_THROW(require_signature(simplices, rational), InputError);
  Bindings object = triangle_bindings(0, 1);
  object["t"] = object["s"];
  EXPECT_THROW(require_signature(simplices, object), InputError);
}

TEST(InstanceClass, the_vocabulary_knows_the_kinds_that_classes_bind) {
  for (const InstanceClass* each : instance_classes()) {
    for (const auto& [name, type] : each->signature()) {
      if (type == types::number || type == types::integer) continue;
      try {
        (void)full_vocabulary().read(type.name, nlohmann::ordered_json(nullptr));
        ADD_FAILURE() << "null is no " << type.name;
      } catch (const std::exception& error) {
        EXPECT_EQ(std::string(error.what()).find("no kind of object"), std::string::npos)
            << type.name << ": " << error.what();
      }
    }
  }
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
