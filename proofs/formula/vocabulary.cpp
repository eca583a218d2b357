#include "proofs/formula/vocabulary.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "kernel/formula/formula_error.hpp"
#include "kernel/formula/parser.hpp"
#include "kernel/formula/token.hpp"
#include "proofs/formula/type_check.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

bool is_item(const Type& type) { return !type.is_set && type != types::number && type != types::truth; }

/// Evaluation relies on it that what does not depend on the rung is made of what does not.
bool types_fit(const Function& function) {
  const bool is_item_function = std::holds_alternative<ItemFunction>(function.value);
  const bool is_set_function = std::holds_alternative<SetFunction>(function.value);
  const auto is_argument = [&](const Type& type) {
    return is_item(type) || (type == types::number && !is_item_function && !is_set_function);
  };
  if (!std::all_of(function.parameters.begin(), function.parameters.end(), is_argument)) return false;
  if (function.is_variadic && function.parameters.size() != 1) return false;
  if (is_item_function) return is_item(function.result);
  if (is_set_function) return function.result.is_set;
  return function.result == (std::holds_alternative<NumberFunction>(function.value) ? types::number : types::truth);
}

}  // namespace

void Vocabulary::require_free(const std::string& name) const {
  if (!is_name_of_formula(name)) throw std::logic_error(name + " is no name of a formula");
  if (function(name) != nullptr || definition(name) != nullptr) {
    throw std::logic_error("the vocabulary has " + name + " twice");
  }
}

void Vocabulary::add(Function function) {
  require_free(function.name);
  if (!types_fit(function)) throw std::logic_error("the types of " + function.name + " do not fit");
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
