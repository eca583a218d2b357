#pragma once

#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "tests/checker/support/model.hpp"

namespace delcert::checker_tests {

using Json = nlohmann::ordered_json;

/// What a certificate of the model claims.
struct Claims {
  std::set<std::string> levels;
  Margins margins;  // as they are claimed
  bool hypotheses_2 = false;
};

/// Margins that hold with room to spare: half the protection and thickness that were measured, 1.2 times the radius.
Margins roomy(const Margins& measured);

/// The document without its seal.
Json certificate(const Model& model, const Claims& claims);

/// The bytes of the certificate, with a seal that is right for the content.
std::string sealed(const Json& document);

/// The text with the seal that is right for the bytes before it.
std::string resealed(const std::string& text);

std::string sha256_of(const std::string& text);

std::string zstd_compressed(const std::string& text);

}  // namespace delcert::checker_tests
