#include "properties/attack/claim_library.hpp"

#include <filesystem>

#include "kernel/formula/formula_error.hpp"
#include "proofs/formula/builtin_claims.hpp"
#include "properties/instances/instance_class.hpp"
#include "support/error.hpp"

namespace delcert {

void require_names_of(const Claim& claim, const Bindings& bindings) {
  const InstanceClass& its_class = instance_class(claim.instance);
  require_signature(its_class, bindings);
  for (const auto& [name, range] : claim.parameters) {
    const auto found = bindings.find(name);
    if (found == bindings.end()) throw InputError("the parameter " + name + " of " + claim.name + " is missing");
    const Rational& value = std::get<Rational>(found->second);
    const bool is_in_range = (range.lower < value || (range.has_lower && value == range.lower)) &&
                             (value < range.upper || (range.has_upper && value == range.upper));
    if (!is_in_range) throw InputError("the parameter " + name + " of " + claim.name + " is out of its range");
  }
  const Signature signature = its_class.signature();
  for (const auto& [name, binding] : bindings) {
    if (!signature.contains(name) && !claim.parameters.contains(name)) {
      throw InputError("neither the class " + its_class.name() + " nor " + claim.name + " has a name " + name);
    }
  }
}

const Signatures& all_signatures() {
  static const Signatures signatures = [] {
    Signatures result;
    for (const InstanceClass* each : instance_classes()) result[each->name()] = each->signature();
    return result;
  }();
  return signatures;
}

const std::vector<Claim>& builtin_files() {
  static const std::vector<Claim> claims = [] {
    std::vector<Claim> result;
    for (const auto& [name, text] : builtin_claims()) {
      result.push_back(parse_claim(text, "proofs/claims/" + name + ".toml", full_vocabulary(), all_signatures()));
    }
    return result;
  }();
  return claims;
}

const std::vector<Claim>& builtin_claim_list() {
  static const std::vector<Claim> claims = [] {
    std::vector<Claim> result;
    for (const Claim& claim : builtin_files()) {
      if (!claim.instance.empty()) result.push_back(claim);
    }
    return result;
  }();
  return claims;
}

Claim find_claim(const std::string& name_or_file) {
  std::vector<std::string> known;
  for (const auto& [name, text] : builtin_claims()) {
    if (name == name_or_file) {
      return parse_claim(text, "proofs/claims/" + name + ".toml", full_vocabulary(), all_signatures());
    }
    known.push_back(name);
  }
  // Not even whether a file exists is known of a name that is too long.
  std::error_code unknown;
  const bool is_file = name_or_file.ends_with(".toml") || name_or_file.find('/') != std::string::npos ||
                       std::filesystem::exists(name_or_file, unknown);
  if (is_file) return read_claim(name_or_file, full_vocabulary(), all_signatures());
  throw InputError("no claim is called " + name_or_file + suggestion(name_or_file, known) +
                   " (delcert claims lists them)");
}

}  // namespace delcert
