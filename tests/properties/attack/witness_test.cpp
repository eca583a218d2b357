#include "properties/attack/witness.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "properties/attack/tally.hpp"
#include "support/error.hpp"
#include "tests/properties/attack/small_claims.hpp"
#include "tests/support/temporary_folder.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

using test::triangle_bindings;
using Json = nlohmann::ordered_json;

Witness good_witness() {
  Witness witness{"thickness-and-singular-value", "dual-basis", "", "simplex",
                  triangle_bindings(Rational(1) / Rational(3), 1)};
  witness.bindings["eta"] = Rational::power_of_two(-100);
  witness.text = "name = \"thickness-and-singular-value\"\n";
  return witness;
}

Json good_json() { return Json::parse(witness_text(good_witness())); }

std::string error_of(const std::string& text) {
  try {
    (void)parse_witness(text, "some.json");
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Witness, a_file_reads_back_to_the_same_file) {
  const std::string text = witness_text(good_witness());
  const Witness back = parse_witness(text, "some.json");
  EXPECT_EQ(witness_text(back), text);
  EXPECT_EQ(back.claim, "thickness-and-singular-value");
  EXPECT_TRUE(std::get<Rational>(back.bindings.at("eta")) == Rational::power_of_two(-100));
}

TEST(Witness, of_version_1_has_no_text) {
  Witness witness = good_witness();
  witness.text.clear();
  Json json = Json::parse(witness_text(witness));
  EXPECT_EQ(json["delcert_witness"], 1);
  EXPECT_FALSE(json.contains("sha256"));
  EXPECT_EQ(parse_witness(json.dump(), "some.json").text, "");
  json["text"] = "name = \"a\"";
  EXPECT_EQ(error_of(json.dump()), "some.json: unknown key text");
}

TEST(Witness, with_another_text_than_its_hash_says_is_an_error) {
  Json json = good_json();
  EXPECT_EQ(json["delcert_witness"], 2);
  EXPECT_EQ(error_of(json.dump()), "no error");
  json["text"] = json["text"].get<std::string>() + " ";
  EXPECT_TRUE(error_of(json.dump()).starts_with("some.json: the key sha256 is ")) << error_of(json.dump());
}

TEST(Witness, drawn_instances_of_every_class_read_back) {
  for (const InstanceClass* each : instance_classes()) {
    const Shape shape = each->shapes().front();
    for (std::uint64_t number = 0; number < 5; ++number) {
      RandomChoices choices(1, 2, number);
      const auto instance = each->draw(shape, {}, NoLimits(), choices);
      if (!instance) continue;
      const std::string text = witness_text({"a", "b", "c", each->name(), instance->bindings});
      EXPECT_EQ(witness_text(parse_witness(text, "some.json")), text) << each->name();
    }
  }
}

TEST(Witness, every_missing_key_is_an_error_that_names_the_file) {
  const Json good = good_json();
  for (const auto& [key, value] : good.items()) {
    Json json = good;
    json.erase(key);
    const std::string error = error_of(json.dump());
    EXPECT_TRUE(error.starts_with("some.json: ")) << error;
    EXPECT_NE(error.find(key), std::string::npos) << error;
  }
  for (const char* name : {"s", "k", "m"}) {
    Json json = good_json();
    json["bindings"].erase(name);
    EXPECT_NE(error_of(json.dump()).find(std::string(name) + " is missing"), std::string::npos) << name;
  }
}

TEST(Witness, every_value_of_a_wrong_kind_is_an_error_that_names_the_file) {
  const Json good = good_json();
  for (const Json& wrong : {Json(nullptr), Json(7), Json(1.5), Json(true), Json::array(), Json::object(), Json("")}) {
    for (const auto& [key, value] : good.items()) {
      if (wrong.is_string() && value.is_string() && key != "instance") continue;
      Json json = good_json();
      json[key] = wrong;
      EXPECT_TRUE(error_of(json.dump()).starts_with("some.json: ")) << json.dump();
    }
    for (const auto& [name, value] : good["bindings"].items()) {
      Json json = good_json();
      json["bindings"][name] = wrong;
      EXPECT_TRUE(error_of(json.dump()).starts_with("some.json: ")) << json.dump();
      json["bindings"][name] = Json{{value.begin().key(), wrong}};
      EXPECT_TRUE(error_of(json.dump()).starts_with("some.json: ")) << json.dump();
    }
  }
}

TEST(Witness, a_known_kind_in_the_wrong_place_is_an_error) {
  Json point = good_json();
  point["bindings"]["s"] = Json{{"point", {"0", "1"}}};
  EXPECT_NE(error_of(point.dump()).find("bindings, s: a simplex was expected"), std::string::npos);
  Json number = good_json();
  number["bindings"]["k"] = Json{{"number", "2"}};
  EXPECT_NE(error_of(number.dump()).find("bindings, k: a integer was expected"), std::string::npos);
  Json extra = good_json();
  extra["bindings"]["t"] = extra["bindings"]["s"];
  EXPECT_NE(error_of(extra.dump()).find("bindings, t: a number was expected"), std::string::npos);
}

TEST(Witness, text_that_is_no_witness_is_an_error_that_names_the_file) {
  const std::string good = witness_text(good_witness());
  std::string twice = good;
  twice.insert(twice.find("\"claim\""), "\"claim\": \"a\", ");
  const std::string deep(200000, '[');
  std::string unknown = good;
  unknown.insert(unknown.find("\"claim\""), "\"clam\": 1, ");
  std::vector<std::string> wrong = {"",
                                    " ",
                                    "{}",
                                    "[]",
                                    "null",
                                    "1",
                                    good + "x",
                                    good + good,
                                    deep,
                                    deep + std::string(200000, ']'),
                                    twice,
                                    unknown,
                                    std::string(1, '\0'),
                                    "\xff\xfe"};
  for (std::size_t length = 1; length < good.size() - 2; length += 7) wrong.push_back(good.substr(0, length));
  for (const std::string& text : wrong) {
    EXPECT_TRUE(error_of(text).starts_with("some.json: ")) << text.substr(0, 300);
  }
  EXPECT_NE(error_of(twice).find("twice"), std::string::npos);
  EXPECT_NE(error_of(unknown).find("unknown key clam"), std::string::npos);
}

TEST(Witness, numbers_that_are_no_exact_text_are_errors) {
  for (const char* text : {"", "0.5", "1/0", " 1", "1e3", "nan", "0x1p999999", "1/2/3", "+1"}) {
    Json json = good_json();
    json["bindings"]["s"]["simplex"]["points"][0][0] = text;
    EXPECT_TRUE(error_of(json.dump()).starts_with("some.json: bindings, s: ")) << text;
    json = good_json();
    json["bindings"]["eta"]["number"] = text;
    EXPECT_TRUE(error_of(json.dump()).starts_with("some.json: bindings, eta: ")) << text;
  }
  Json json = good_json();
  json["bindings"]["k"]["integer"] = std::uint64_t{1} << 63U;
  EXPECT_NE(error_of(json.dump()).find("bindings, k: an integer below 2^63"), std::string::npos);
}

TEST(Witness, an_instance_that_breaks_the_promise_of_its_class_is_an_error) {
  Json flat = good_json();
  flat["bindings"]["s"]["simplex"]["points"][2] = {"2", "0"};
  EXPECT_NE(error_of(flat.dump()).find("non-degenerate"), std::string::npos);
  Json ragged = good_json();
  ragged["bindings"]["s"]["simplex"]["points"][2] = {"2"};
  EXPECT_TRUE(error_of(ragged.dump()).starts_with("some.json: ")) << error_of(ragged.dump());
  Json dimension = good_json();
  dimension["bindings"]["k"]["integer"] = 3;
  EXPECT_TRUE(error_of(dimension.dump()).starts_with("some.json: "));
}

TEST(Witness, files_that_cannot_be_read_are_errors_that_name_them) {
  const test::TemporaryFolder folder;
  EXPECT_THROW((void)read_witness((folder / "none.json").string()), InputError);
  EXPECT_THROW((void)read_witness(folder.path().string()), InputError);
  const auto file = folder / "good.json";
  std::ofstream(file) << witness_text(good_witness());
  EXPECT_EQ(witness_text(read_witness(file.string())), witness_text(good_witness()));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
