#include "properties/attack/witness.hpp"

#include <fstream>
#include <nlohmann/json.hpp>

#include "kernel/error.hpp"
#include "kernel/number/exact_text.hpp"

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

Binding binding_from(const std::string& name, const Json& json, const Vocabulary& vocabulary) {
  if (!json.is_object() || json.size() != 1) {
    throw InputError(name + " wants one kind and its value, such as {\"number\": \"1/2\"}");
  }
  const auto& [kind, value] = *json.items().begin();
  if (kind == "number") {
    if (!value.is_string()) throw InputError(name + ": a number wants an exact number in quotes");
    return parse_exact(value.get<std::string>());
  }
  if (kind == "integer") {
    if (!value.is_number_integer()) throw InputError(name + ": an integer was expected");
    return value.get<long>();
  }
  return vocabulary.read(kind, value);
}

std::string text_at(const Json& json, const std::string& key) {
  if (!json.contains(key) || !json.at(key).is_string()) throw InputError("the key " + key + " wants a string");
  return json.at(key).get<std::string>();
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

Bindings bindings_from(const Json& json, const Vocabulary& vocabulary) {
  if (!json.is_object()) throw InputError("bindings want an object of names");
  Bindings result;
  for (const auto& [name, value] : json.items()) result[name] = binding_from(name, value, vocabulary);
  return result;
}

std::string witness_text(const Witness& witness) {
  Json json;
  json["delcert_witness"] = 1;
  json["claim"] = witness.claim;
  json["conclusion"] = witness.conclusion;
  json["twin"] = witness.twin;
  json["instance"] = witness.instance_class;
  json["bindings"] = bindings_json(witness.bindings, instance_class(witness.instance_class).signature());
  return json.dump(1) + "\n";
}

Witness parse_witness(const std::string& text, const std::string& file) {
  try {
    const Json json = parse(text);
    if (!json.is_object() || !json.contains("delcert_witness") || json.at("delcert_witness") != 1) {
      throw InputError("not a witness of version 1 (key delcert_witness)");
    }
    for (const auto& [key, value] : json.items()) {
      if (key != "delcert_witness" && key != "claim" && key != "conclusion" && key != "twin" && key != "instance" &&
          key != "bindings") {
        throw InputError("unknown key " + key);
      }
    }
    Witness witness{
        text_at(json, "claim"), text_at(json, "conclusion"), text_at(json, "twin"), text_at(json, "instance"), {}};
    if (!json.contains("bindings")) throw InputError("the key bindings is missing");
    witness.bindings = bindings_from(json.at("bindings"), full_vocabulary());
    instance_class(witness.instance_class).require(witness.bindings);
    return witness;
  } catch (const nlohmann::json::exception& error) {
    throw InputError(file + ": " + error.what());
  } catch (const InputError& error) {
    throw InputError(file + ": " + error.what());
  }
}

Witness read_witness(const std::string& file) {
  std::ifstream stream(file, std::ios::binary | std::ios::ate);
  if (!stream) throw InputError(file + ": cannot be read");
  const auto size = static_cast<std::size_t>(std::max<std::streamoff>(stream.tellg(), 0));
  if (size > largest_file) throw InputError(file + ": larger than 64 MiB");
  std::string text(size, '\0');
  stream.seekg(0);
  stream.read(text.data(), static_cast<std::streamsize>(size));
  return parse_witness(text, file);
}

}  // namespace delcert
