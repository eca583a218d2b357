#include "properties/attack/witness.hpp"

#include <array>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

#include "kernel/number/exact_text.hpp"
#include "proofs/certificate/sha256.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t largest_file = std::size_t{64} << 20U;

Json binding_json(const Binding& binding, const std::string& kind) {
  Json result;
  if (const Rational* number = std::get_if<Rational>(&binding)) {
    result["number"] = exact_text(*number);
  } else if (const long* integer = std::get_if<long>(&binding)) {
    result["integer"] = *integer;
  } else {
    result[kind] = std::get<ObjectPointer>(binding)->json();
  }
  return result;
}

Binding binding_from(const Json& json, const std::string& wanted, const Vocabulary& vocabulary) {
  if (!json.is_object() || json.size() != 1) {
    throw InputError("one kind and its value were expected, such as {\"number\": \"1/2\"}");
  }
  const std::string& kind = json.begin().key();
  const Json& value = json.begin().value();
  if (kind != wanted) throw InputError("a " + wanted + " was expected, not a " + kind);
  if (kind == types::number.name) {
    if (!value.is_string()) throw InputError("a number expects an exact number in quotes");
    return parse_exact(value.get<std::string>());
  }
  if (kind == types::integer.name) {
    constexpr std::uint64_t largest = std::numeric_limits<long>::max();
    const bool is_too_large = value.is_number_unsigned() && value.get<std::uint64_t>() > largest;
    if (!value.is_number_integer() || is_too_large) throw InputError("an integer below 2^63 was expected");
    return value.get<long>();
  }
  try {
    return vocabulary.read(kind, value);
  } catch (const std::logic_error& error) {
    // What constructors say of data that make no object.
    throw InputError(error.what());
  }
}

std::string text_at(const Json& json, const std::string& key) {
  if (!json.contains(key) || !json.at(key).is_string()) throw InputError("the key " + key + " expects a string");
  return json.at(key).get<std::string>();
}

std::string sha256_of(const std::string& text) {
  Sha256 hash;
  hash.update(text);
  return hash.digest();
}

/// Not twice the same key, which the library would take silently.
Json parse(const std::string& text) {
  std::vector<std::set<std::string>> open;
  const Json::parser_callback_t refuse_duplicates = [&](int, Json::parse_event_t event, Json& parsed) {
    if (event == Json::parse_event_t::object_start) open.emplace_back();
    if (event == Json::parse_event_t::object_end) open.pop_back();
    if (event == Json::parse_event_t::key && !open.back().insert(parsed.get<std::string>()).second) {
      throw InputError("the key " + parsed.get<std::string>() + " is there twice");
    }
    return true;
  };
  return Json::parse(text, refuse_duplicates);
}

}  // namespace

Json bindings_json(const Bindings& bindings, const Signature& signature) {
  Json result = Json::object();
  for (const auto& [name, binding] : bindings) {
    const auto type = signature.find(name);
    result[name] = binding_json(binding, type == signature.end() ? "number" : type->second.name);
  }
  return result;
}

Bindings bindings_from(const Json& json, const Vocabulary& vocabulary, const Signature& signature) {
  if (!json.is_object()) throw InputError("bindings: an object of names was expected");
  Bindings result;
  for (const auto& [name, value] : json.items()) {
    const auto known = signature.find(name);
    try {
      const Type& type = known == signature.end() ? types::number : known->second;
      result[name] = binding_from(value, type.name, vocabulary);
    } catch (const InputError& error) {
      throw InputError("bindings, " + name + ": " + error.what());
    }
  }
  return result;
}

std::string witness_text(const Witness& witness) {
  Json json;
  json["delcert_witness"] = witness.text.empty() ? 1 : 2;
  json["claim"] = witness.claim;
  json["conclusion"] = witness.conclusion;
  json["twin"] = witness.twin;
  json["instance"] = witness.instance_class;
  if (!witness.text.empty()) {
    json["text"] = witness.text;
    json["sha256"] = sha256_of(witness.text);
  }
  json["bindings"] = bindings_json(witness.bindings, instance_class(witness.instance_class).signature());
  return json.dump(1) + "\n";
}

Witness parse_witness(const std::string& text, const std::string& file) {
  try {
    const Json json = parse(text);
    const bool has_version = json.is_object() && json.contains("delcert_witness");
    const bool has_text = has_version && json.at("delcert_witness") == 2;
    if (!has_text && !(has_version && json.at("delcert_witness") == 1)) {
      throw InputError("not a witness of version 1 or 2 (key delcert_witness)");
    }
    for (const auto& [key, value] : json.items()) {
      if (key != "delcert_witness" && key != "claim" && key != "conclusion" && key != "twin" && key != "instance" &&
          key != "bindings" && !(has_text && (key == "text" || key == "sha256"))) {
        throw InputError("unknown key " + key);
      }
    }
    Witness witness{
        text_at(json, "claim"), text_at(json, "conclusion"), text_at(json, "twin"), text_at(json, "instance"), {}};
    if (has_text) {
      witness.text = text_at(json, "text");
      const std::string sum = text_at(json, "sha256");
      if (witness.text.empty()) throw InputError("the key text expects the text of a claim");
      if (sum != sha256_of(witness.text)) {
        throw InputError("the key sha256 is " + sum + ", the SHA-256 of the key text " + sha256_of(witness.text));
      }
    }
    if (!json.contains("bindings")) throw InputError("the key bindings is missing");
    const InstanceClass& its_class = instance_class(witness.instance_class);
    witness.bindings = bindings_from(json.at("bindings"), full_vocabulary(), its_class.signature());
    require_signature(its_class, witness.bindings);
    its_class.require(witness.bindings);
    return witness;
  } catch (const nlohmann::json::exception& error) {
    throw InputError(file + ": " + error.what());
  } catch (const InputError& error) {
    throw InputError(file + ": " + error.what());
  }
}

Witness read_witness(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw InputError(file + ": cannot be read");
  std::string text;
  std::array<char, 1U << 16U> part{};
  while (text.size() <= largest_file && stream) {
    stream.read(part.data(), part.size());
    text.append(part.data(), static_cast<std::size_t>(stream.gcount()));
  }
  if (stream.bad()) throw InputError(file + ": cannot be read");
  if (text.size() > largest_file) throw InputError(file + ": larger than 64 MiB");
  return parse_witness(text, file);
}

}  // namespace delcert
