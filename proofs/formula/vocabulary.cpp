#include "proofs/formula/vocabulary.hpp"

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "kernel/error.hpp"
#include "proofs/formula/formula_error.hpp"
#include "proofs/formula/parser.hpp"
#include "proofs/formula/type_check.hpp"

namespace delcert {

void Vocabulary::require_free(const std::string& name) const {
  if (function(name) != nullptr || definition(name) != nullptr) {
    throw std::logic_error("the vocabulary has " + name + " twice");
  }
}

void Vocabulary::add(Function function) {
  require_free(function.name);
  const std::string name = function.name;
  functions_.emplace(name, std::move(function));
}

void Vocabulary::add_definition(const std::string& name, std::vector<std::string> parameters, const std::string& text,
                                const std::string& meaning, const std::string& latex) {
  require_free(name);
  // Exponents are integers: a parameter that an exponent uses is one.
  Signature signature;
  for (const std::string& parameter : parameters) {
    signature[parameter] = parameter == "k" || parameter == "m" ? types::integer : types::number;
  }
  try {
    auto body = type_checked(parse_formula(text), *this, signature, types::number);
    definitions_[name] = {name, std::move(parameters), text, meaning, latex, std::move(body)};
  } catch (const FormulaError& error) {
    throw std::logic_error("the definition of " + name + ": " + error.what());
  }
}

void Vocabulary::add_kind(const std::string& kind, Reader reader) {
  if (!kinds_.emplace(kind, std::move(reader)).second) throw std::logic_error("the kind " + kind + " is there twice");
}

const Function* Vocabulary::function(const std::string& name) const {
  const auto found = functions_.find(name);
  return found == functions_.end() ? nullptr : &found->second;
}

const Definition* Vocabulary::definition(const std::string& name) const {
  const auto found = definitions_.find(name);
  return found == definitions_.end() ? nullptr : &found->second;
}

ObjectPointer Vocabulary::read(const std::string& kind, const nlohmann::ordered_json& json) const {
  const auto found = kinds_.find(kind);
  if (found == kinds_.end()) {
    std::vector<std::string> known;
    for (const auto& [name, reader] : kinds_) known.push_back(name);
    throw InputError("no kind of object is called " + kind + suggestion(kind, known));
  }
  return found->second(json);
}

std::vector<std::string> Vocabulary::names() const {
  std::vector<std::string> result;
  for (const auto& [name, function] : functions_) result.push_back(name);
  for (const auto& [name, definition] : definitions_) result.push_back(name);
  return result;
}

}  // namespace delcert
