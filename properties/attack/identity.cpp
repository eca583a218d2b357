#include "properties/attack/identity.hpp"

#include <delcert_version.hpp>

#include "kernel/number/exact_text.hpp"

namespace delcert {

namespace {

/// FNV-1a in 64 bits.
std::uint64_t digest_of(const std::string& text) {
  std::uint64_t hash = 14695981039346656037U;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211U;
  return hash;
}

}  // namespace

std::string contents_of(const Claim& claim, const Shape& shape) {
  std::string result =
      claim.name + "\n" + claim.instance + "\n" + std::to_string(shape.k) + " " + std::to_string(shape.m) + "\n";
  for (const auto& [name, range] : claim.parameters) {
    result += name + (range.has_lower ? " [" : " (") + (range.lower ? exact_text(*range.lower) : "-infinity") + ", " +
              (range.upper ? exact_text(*range.upper) : "infinity") + (range.has_upper ? "]\n" : ")\n");
  }
  for (const Statement& abbreviation : claim.abbreviations) {
    result += "let " + abbreviation.name + " " + abbreviation.text + "\n";
  }
  for (const Hypothesis& hypothesis : claim.hypotheses) result += "given " + hypothesis.text + "\n";
  for (const Conclusion& conclusion : claim.conclusions) {
    result += "show " + conclusion.name + " " + conclusion.text + "\n";
  }
  return result;
}

std::string identity_of(const std::string& contents, std::uint64_t seed) {
  return std::string("delcert ") + version + ", seed " + std::to_string(seed) + ", digest " +
         std::to_string(digest_of(contents));
}

}  // namespace delcert
