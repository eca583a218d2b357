#include "kernel/manifold/exact_entry.hpp"

#include "kernel/number/exact_text.hpp"

namespace delcert {

Rational exact_number(const TomlReader& reader, const toml::node& node, const std::string& what) {
  if (const auto* integer = node.as_integer()) return Rational(integer->get());
  if (const auto* text = node.as_string()) {
    try {
      return parse_exact(text->get());
    } catch (const ExactTextError& error) {
      reader.fail(node.source(), what + ": " + error.what());
    }
  }
  if (node.is_floating_point()) {
    reader.fail(node, what,
                std::string(exact_number_expected) + "; a floating-point number would be rounded before it is read");
  }
  reader.fail(node, what, exact_number_expected);
}

}  // namespace delcert
