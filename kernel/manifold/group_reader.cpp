#include "kernel/manifold/group_reader.hpp"

#include "kernel/manifold/quotient/polynomial_text.hpp"
#include "kernel/number/exact_text.hpp"

namespace delcert {

InvariantForm GroupReader::form(const toml::table& table, const FieldElement::Field& field) const {
  const auto m = static_cast<std::size_t>(integer(table, "dimension", 2, 3));
  const int curvature = integer(table, "curvature", -1, 1);
  FieldElement time(curvature);
  if (table.contains("time")) time = element(field, required(table, "time"), "key \"time\"");
  if (time.sign() != curvature)
    fail(required(table, "time"), "key \"time\"",
         "a number with the sign of the curvature, " + std::to_string(curvature));
  FieldMatrix gram = FieldMatrix::identity(m);
  if (table.contains("gram")) gram = matrix(field, required(table, "gram"), m, "key \"gram\"");
  try {
    return {time, gram};
  } catch (const InputError& error) {
    fail(required(table, "gram").source(), error.what());
  }
}

FieldElement::Field GroupReader::field(const toml::table& table) const {
  if (!table.contains("field")) return nullptr;
  const toml::node& node = required(table, "field");
  const auto polynomial = of_text(node, "key \"field\"", [](const std::string& x) { return parse_polynomial(x); });
  const toml::node& root = required(table, "root");
  const auto* ends = root.as_array();
  if (ends == nullptr || ends->size() != 2) fail(root, "key \"root\"", "an array of two exact numbers");
  const auto end = [&](std::size_t at) {
    return of_text((*ends)[at], "key \"root\"", [](const std::string& x) { return parse_exact(x); });
  };
  try {
    return std::make_shared<const NumberField>(polynomial, end(0), end(1));
  } catch (const InputError& error) {
    fail(node.source(), error.what());
  }
}

FieldMatrix GroupReader::matrix(const FieldElement::Field& field, const toml::node& node, std::size_t order,
                                const std::string& what) const {
  FieldMatrix result(order);
  for_each_entry(node, order, what,
                 [&](std::size_t row, std::size_t column, const toml::node& entry, const std::string& name) {
                   result(row, column) = element(field, entry, name);
                 });
  return result;
}

FieldElement GroupReader::element(const FieldElement::Field& field, const toml::node& node,
                                  const std::string& what) const {
  const auto coefficients = of_text(node, what, [](const std::string& x) { return parse_polynomial(x); });
  if (!field && coefficients.size() > 1) fail(node, what, "a rational number, as there is no key \"field\"");
  return field ? FieldElement(field, coefficients) : FieldElement(coefficients.front());
}

}  // namespace delcert
