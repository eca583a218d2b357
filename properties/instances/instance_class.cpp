#include "properties/instances/instance_class.hpp"

#include <algorithm>

#include "kernel/formula/formula_error.hpp"
#include "proofs/formula/arithmetic_vocabulary.hpp"
#include "proofs/formula/measure_vocabulary.hpp"
#include "proofs/formula/simplex_vocabulary.hpp"
#include "support/error.hpp"

namespace delcert {

void InstanceClass::extend(Vocabulary&) const {}

std::string InstanceClass::manifold(const Bindings&) const { return "ℝᵐ"; }

std::uint64_t InstanceClass::cost(const Shape&) const { return 1; }

bool InstanceClass::has_structure(const Shape&) const { return false; }

std::optional<Instance> InstanceClass::draw_structured(const Shape&, const Bindings&, const Limits&, Choices&) const {
  return std::nullopt;
}

const InstanceClass& instance_class(const std::string& name) {
  for (const InstanceClass* candidate : instance_classes()) {
    if (candidate->name() == name) return *candidate;
  }
  std::vector<std::string> known;
  for (const InstanceClass* candidate : instance_classes()) known.push_back(candidate->name());
  throw InputError("no instance class is called " + name + suggestion(name, known));
}

const Vocabulary& full_vocabulary() {
  static const Vocabulary vocabulary = [] {
    Vocabulary result;
    add_arithmetic(result);
    add_constants_of_the_paper(result);
    add_simplex_quantities(result);
    add_simplex_measures(result);
    for (const InstanceClass* each : instance_classes()) each->extend(result);
    return result;
  }();
  return vocabulary;
}

bool InstanceClass::has(const Shape& shape) const {
  constexpr int highest = 8;
  int highest_listed = 0;
  bool can_spare = false;
  for (const Shape& listed : shapes()) {
    if (listed == shape) return true;
    highest_listed = std::max(highest_listed, listed.k);
    can_spare = can_spare || (listed.k > 0 && listed.m - listed.k == shape.m - shape.k);
  }
  return can_spare && highest_listed < shape.k && shape.k <= highest;
}

void require_signature(const InstanceClass& instance_class, const Bindings& bindings) {
  for (const auto& [name, type] : instance_class.signature()) {
    const auto found = bindings.find(name);
    if (found == bindings.end()) throw InputError(instance_class.name() + ": " + name + " is missing");
    const bool fits = type == types::number    ? std::holds_alternative<Rational>(found->second)
                      : type == types::integer ? std::holds_alternative<long>(found->second)
                                               : std::holds_alternative<ObjectPointer>(found->second);
    if (!fits) throw InputError(instance_class.name() + ": " + name + " is not a " + type.text());
  }
  const Signature signature = instance_class.signature();
  for (const auto& [name, binding] : bindings) {
    if (!signature.contains(name) && !std::holds_alternative<Rational>(binding)) {
      throw InputError(instance_class.name() + " has no " + name + ", and a parameter of a claim is a number");
    }
  }
}

std::string text_of(const Shape& shape) {
  const std::string m = "m=" + std::to_string(shape.m);
  return shape.k == 0 ? m : "k=" + std::to_string(shape.k) + " " + m;
}

}  // namespace delcert
