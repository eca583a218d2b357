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

std::array<Rational, 2> exact_interval(const TomlReader& reader, const toml::node& node, const std::string& what) {
  const auto* ends = node.as_array();
  if (ends == nullptr || ends->size() != 2) reader.fail(node, what, "a pair of numbers");
  const Rational from = exact_number(reader, (*ends)[0], what + ", from");
  const Rational to = exact_number(reader, (*ends)[1], what + ", to");
  if (to <= from) reader.fail((*ends)[1], what + ", to", "a number above " + exact_text(from));
  return {from, to};
}

}  // namespace delcert
