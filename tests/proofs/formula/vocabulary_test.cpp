#include "proofs/formula/vocabulary.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "proofs/formula/arithmetic_vocabulary.hpp"
#include "proofs/formula/evaluation.hpp"
#include "support/error.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

class Blob : public Object {
 public:
  [[nodiscard]] nlohmann::ordered_json json() const override { return "blob"; }
};

Function constant(const std::string& name) {
  return number_function(name, {}, "One.", "1",
                         []<class S>(Evaluation<S>&, Arguments<S>) -> Partial<S> { return S(1); });
}

Function item_function(const std::string& name, std::vector<Type> parameters, Type result) {
  return {
      name, std::move(parameters), std::move(result), "", "", false, ItemFunction([](std::span<const Item>) -> Item {
        return 1L;
      })};
}

Function set_function(const std::string& name, std::vector<Type> parameters, Type result) {
  return {name, std::move(parameters), std::move(result), "", "", false, SetFunction([](std::span<const Item>) {
            return std::vector<Item>{};
          })};
}

TEST(Vocabulary, what_was_added_is_found) {
  Vocabulary vocabulary;
  vocabulary.add(constant("one"));
  vocabulary.add_definition("twice", {"x"}, "2*x", "Twice x.", "2x");
  ASSERT_NE(vocabulary.function("one"), nullptr);
  EXPECT_EQ(vocabulary.function("one")->meaning, "One.");
  EXPECT_EQ(vocabulary.function("two"), nullptr);
  ASSERT_NE(vocabulary.definition("twice"), nullptr);
  EXPECT_EQ(vocabulary.definition("one"), nullptr);
  EXPECT_EQ(vocabulary.names(), (std::vector<std::string>{"one", "twice"}));
}

TEST(Vocabulary, a_name_is_taken_once) {
  Vocabulary vocabulary;
  vocabulary.add(constant("one"));
  vocabulary.add_definition("two", {}, "2", "Two.", "2");
  EXPECT_THROW(vocabulary.add(constant("one")), std::logic_error);
  EXPECT_THROW(vocabulary.add(constant("two")), std::logic_error);
  EXPECT_THROW(vocabulary.add_definition("one", {}, "1", "", ""), std::logic_error);
  for (const char* name : {"", "and", "a-b", "1a"}) EXPECT_THROW(vocabulary.add(constant(name)), std::logic_error);
}

TEST(Vocabulary, a_definition_is_a_correct_term_of_its_parameters) {
  Vocabulary vocabulary;
  EXPECT_THROW(vocabulary.add_definition("f", {}, "x", "", ""), std::logic_error);
  EXPECT_THROW(vocabulary.add_definition("f", {"x"}, "x +", "", ""), std::logic_error);
  EXPECT_THROW(vocabulary.add_definition("f", {"x"}, "x < 1", "", ""), std::logic_error);
  // k and m are integers, so they can be exponents; other parameters are numbers.
  EXPECT_NO_THROW(vocabulary.add_definition("f", {"k", "x"}, "x^k", "", ""));
  EXPECT_THROW(vocabulary.add_definition("g", {"j", "x"}, "x^j", "", ""), std::logic_error);
  // A definition cannot use itself.
  EXPECT_THROW(vocabulary.add_definition("h", {"x"}, "h(x)", "", ""), std::logic_error);
}

TEST(Vocabulary, what_does_not_depend_on_the_rung_is_made_of_what_does_not) {
  Vocabulary vocabulary;
  EXPECT_NO_THROW(vocabulary.add(item_function("a", {types::integer}, types::integer)));
  EXPECT_NO_THROW(vocabulary.add(set_function("b", {types::integer}, types::integers)));
  EXPECT_THROW(vocabulary.add(item_function("c", {types::number}, types::integer)), std::logic_error);
  EXPECT_THROW(vocabulary.add(item_function("c", {types::integer}, types::number)), std::logic_error);
  EXPECT_THROW(vocabulary.add(item_function("c", {types::integer}, types::integers)), std::logic_error);
  EXPECT_THROW(vocabulary.add(set_function("c", {types::integer}, types::integer)), std::logic_error);
  EXPECT_THROW(vocabulary.add(set_function("c", {types::integers}, types::integers)), std::logic_error);
  Function wrong_result = constant("c");
  wrong_result.result = types::integer;
  EXPECT_THROW(vocabulary.add(wrong_result), std::logic_error);
  Function wrong_variadic = constant("c");
  wrong_variadic.is_variadic = true;
  EXPECT_THROW(vocabulary.add(wrong_variadic), std::logic_error);
}

TEST(Vocabulary, objects_are_read_by_their_kind) {
  Vocabulary vocabulary;
  vocabulary.add_kind("blob", [](const nlohmann::ordered_json&) { return std::make_shared<Blob>(); });
  EXPECT_NE(vocabulary.read("blob", nlohmann::ordered_json()), nullptr);
  EXPECT_THROW(vocabulary.add_kind("blob", nullptr), std::logic_error);
  try {
    (void)vocabulary.read("blop", nlohmann::ordered_json());
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "no kind of object is called blop, did you mean blob?");
  }
}

TEST(Vocabulary, the_standard_functions_are_complete_and_documented) {
  Vocabulary vocabulary;
  add_arithmetic(vocabulary);
  add_constants_of_the_paper(vocabulary);
  for (const auto& [name, function] : vocabulary.functions()) {
    EXPECT_FALSE(function.meaning.empty()) << name;
    EXPECT_FALSE(function.latex.empty()) << name;
  }
  for (const char* name : {"sqrt", "abs", "log2", "min", "max", "range"}) EXPECT_NE(vocabulary.function(name), nullptr);
  EXPECT_NE(vocabulary.definition("constant_c"), nullptr);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
