#include "properties/attack/claim_text.hpp"

#include <nlohmann/json.hpp>

#include "kernel/number/fraction_text.hpp"
#include "proofs/certificate/file_text.hpp"
#include "proofs/formula/builtin_claims.hpp"

namespace delcert {

namespace {

/// A basic string of TOML, which what JSON makes of a text is.
std::string quoted(const std::string& text) { return nlohmann::json(text).dump(); }

std::string range_text(const ParameterRange& range) {
  return (range.has_lower ? "[" : "(") + (range.lower ? fraction_text(*range.lower) : "-infinity") + ", " +
         (range.upper ? fraction_text(*range.upper) : "infinity") + (range.has_upper ? "]" : ")");
}

std::string statement_text(const Statement& statement) {
  return "name = " + quoted(statement.name) + "\nclaim = " + quoted(statement.text) + "\n";
}

}  // namespace

std::string claim_text(const Claim& claim) {
  std::string result = "name = " + quoted(claim.name) + "\n";
  if (!claim.source.empty() || claim.status != ClaimStatus::user) {
    result += "source = " + quoted(claim.source) + "\nstatus = " + quoted(std::string(name_of(claim.status))) + "\n";
  }
  result += "instance = " + quoted(claim.instance) + "\n";
  if (!claim.parameters.empty()) result += "\n[forall]\n";
  for (const auto& [name, range] : claim.parameters) result += name + " = " + quoted(range_text(range)) + "\n";
  if (claim.points) result += "\n[points]\n" + point_rules_text(*claim.points);
  for (const Statement& abbreviation : claim.abbreviations) {
    result += "\n[[let]]\nname = " + quoted(abbreviation.name) + "\nis = " + quoted(abbreviation.text) + "\n";
  }
  for (const Hypothesis& hypothesis : claim.hypotheses) {
    if (!hypothesis.is_constraint) result += "\n[[given]]\n" + statement_text(hypothesis);
  }
  for (const Conclusion& conclusion : claim.conclusions) result += "\n[[show]]\n" + statement_text(conclusion);
  return result;
}

std::string file_text_of(const Claim& claim) {
  for (const auto& [name, text] : builtin_claims()) {
    if (claim.file == "proofs/claims/" + name + ".toml") return text;
  }
  return read_text(claim.file);
}

}  // namespace delcert
