#include "proofs/formula/scene.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace delcert {
namespace DELCERT_THIS_FILE {

class Box : public Object {
 public:
  explicit Box(long number) : number_(number) {}
  [[nodiscard]] nlohmann::ordered_json json() const override { return number_; }

 private:
  long number_;
};

TEST(Scene, finds_what_the_instance_binds) {
  const Bindings bindings{{"k", 3L}, {"xi", Rational(2)}};
  const Scene scene(bindings);
  ASSERT_NE(scene.find("k"), nullptr);
  EXPECT_EQ(std::get<long>(*scene.find("k")), 3);
  EXPECT_EQ(std::get<Rational>(*scene.find("xi")), Rational(2));
  EXPECT_EQ(scene.find("m"), nullptr);
}

TEST(Scene, a_derived_object_is_made_once_for_the_same_arguments) {
  int made = 0;
  const Function box{
      "box", {types::integer}, {"box", false}, "", "", false, ItemFunction([&made](std::span<const Item> a) -> Item {
        ++made;
        return std::make_shared<Box>(std::get<long>(a[0]));
      })};
  const Bindings bindings;
  Scene scene(bindings);
  const Item first = scene.item(box, {Item(1L)});
  EXPECT_EQ(scene.item(box, {Item(1L)}), first);
  EXPECT_EQ(made, 1);
  EXPECT_NE(scene.item(box, {Item(2L)}), first);
  EXPECT_EQ(made, 2);
  // Another scene has objects of its own.
  Scene other(bindings);
  EXPECT_NE(other.item(box, {Item(1L)}), first);
}

TEST(Scene, a_set_is_made_once_so_that_its_objects_have_one_address) {
  int made = 0;
  const Function boxes{
      "boxes", {types::integer}, {"box", true}, "", "", false, SetFunction([&made](std::span<const Item> a) {
        ++made;
        std::vector<Item> result;
        for (long i = 0; i < std::get<long>(a[0]); ++i) result.emplace_back(std::make_shared<Box>(i));
        return result;
      })};
  const Bindings bindings;
  Scene scene(bindings);
  const auto first = scene.set(boxes, {Item(2L)});
  EXPECT_EQ(first.size(), 2U);
  EXPECT_EQ(scene.set(boxes, {Item(2L)}), first);
  EXPECT_EQ(made, 1);
  EXPECT_EQ(scene.set(boxes, {Item(0L)}).size(), 0U);
}

TEST(Scene, functions_are_told_apart_though_arguments_agree) {
  const auto plus = [](long number) {
    return Function{"plus",
                    {types::integer},
                    types::integer,
                    "",
                    "",
                    false,
                    ItemFunction([number](std::span<const Item> a) -> Item { return std::get<long>(a[0]) + number; })};
  };
  const Function one = plus(1);
  const Function two = plus(2);
  const Bindings bindings;
  Scene scene(bindings);
  EXPECT_EQ(scene.item(one, {Item(1L)}), Item(2L));
  EXPECT_EQ(scene.item(two, {Item(1L)}), Item(3L));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
