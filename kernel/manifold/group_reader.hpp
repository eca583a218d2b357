#pragma once

#include <string>
#include <vector>

#include "kernel/manifold/quotient/invariant_form.hpp"
#include "support/error.hpp"
#include "support/toml_reader.hpp"

namespace delcert {

/// Reads what all files about groups of isometries of a model space have in common: the form, and matrices over a
/// number field (docs/space-forms.md).
class GroupReader : public TomlReader {
 public:
  using TomlReader::TomlReader;

  /// The keys `dimension` (2 or 3), `curvature`, `time` and `gram`.
  [[nodiscard]] InvariantForm form(const toml::table& table, const FieldElement::Field& field) const;
  /// The keys `field` and `root`; none if they are missing.
  [[nodiscard]] FieldElement::Field field(const toml::table& table) const;
  /// A square matrix of this order; messages call it `what`.
  [[nodiscard]] FieldMatrix matrix(const FieldElement::Field& field, const toml::node& node, std::size_t order,
                                   const std::string& what) const;
  [[nodiscard]] FieldElement element(const FieldElement::Field& field, const toml::node& node,
                                     const std::string& what) const;

  /// What a parser makes of a string, or of an integer's digits.
  template <class Parse>
  auto of_text(const toml::node& node, const std::string& what, const Parse& parse) const
      -> decltype(parse(std::string())) {
    std::string text;
    if (const auto* integer = node.as_integer()) {
      text = std::to_string(integer->get());
    } else if (const auto* string = node.as_string()) {
      text = string->get();
    } else {
      fail(node, what, "an exact number: an integer, or a string such as \"3/4\" or \"1/2*t^2 - t\"");
    }
    try {
      return parse(text);
    } catch (const InputError& error) {
      fail(node.source(), what + ": " + error.what());
    }
  }
};

}  // namespace delcert
