#pragma once

#include <string>

#include "kernel/formula/toml_formula_reader.hpp"
#include "proofs/formula/step.hpp"
#include "proofs/formula/vocabulary.hpp"

namespace delcert {

/// Reads TOML files of claims.
class FormulaReader : public TomlFormulaReader {
 public:
  using TomlFormulaReader::TomlFormulaReader;

  /// Names of claims and their parts: small letters, digits, '-', '.', '_'.
  void require_name(const toml::node& node, const std::string& name) const;

  [[nodiscard]] Statement formula(const toml::node& node, const std::string& name, const Vocabulary& vocabulary,
                                  const Signature& signature, const Type& type) const;
  /// The same of any type.
  [[nodiscard]] Statement formula(const toml::node& node, const std::string& name, const Vocabulary& vocabulary,
                                  const Signature& signature) const;
};

}  // namespace delcert
