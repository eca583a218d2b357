#include "kernel/manifold/space_form_file.hpp"

#include "kernel/manifold/quotient/polynomial_text.hpp"
#include "kernel/manifold/quotient/space_form_families.hpp"
#include "kernel/number/exact_text.hpp"
#include "support/error.hpp"
#include "support/toml_reader.hpp"

namespace delcert {

namespace {

class SpaceFormReader : TomlReader {
 public:
  SpaceFormReader(std::string_view text, const std::string& source) : TomlReader(text, source), table_(parse()) {}

  SpaceFormDescription read() const {
    const std::string family = short_string(table_, "family");
    SpaceFormDescription result = of_family(family);
    result.name = short_string(table_, "name");
    return result;
  }

 private:
  SpaceFormDescription of_family(const std::string& family) const {
    if (family == "space-form") {
      refuse_unknown(table_, {"name", "family", "dimension", "curvature", "field", "root", "time", "gram", "generators",
                              "first_homology", "order"});
      return general();
    }
    if (family == "sphere" || family == "projective-space") {
      refuse_unknown(table_, {"name", "family", "dimension"});
      const int m = integer(table_, "dimension", 2, 3);
      return family == "sphere" ? sphere(m) : projective_space(m);
    }
    if (family == "lens-space") {
      refuse_unknown(table_, {"name", "family", "p", "q"});
      const int p = integer(table_, "p", 3, 1000);
      return lens_space(p, integer(table_, "q", 1, p - 1));
    }
    if (family == "regular-polygon-surface") {
      refuse_unknown(table_, {"name", "family", "genus"});
      return regular_polygon_surface(integer(table_, "genus", 2, 50));
    }
    if (family == "product-with-circle") {
      refuse_unknown(table_, {"name", "family", "surface", "length"});
      const Rational length =
          of_text(required(table_, "length"), "key \"length\"", [](const std::string& x) { return parse_exact(x); });
      try {
        return product_with_circle(find_space_form(short_string(table_, "surface")), length);
      } catch (const InputError& error) {
        fail(required(table_, "surface").source(), error.what());
      }
    }
    fail(required(table_, "family"), "key \"family\"",
         "\"space-form\", \"sphere\", \"projective-space\", \"lens-space\", \"regular-polygon-surface\" or "
         "\"product-with-circle\"");
  }

  SpaceFormDescription general() const {
    const auto m = static_cast<std::size_t>(integer(table_, "dimension", 2, 3));
    const int curvature = integer(table_, "curvature", -1, 1);
    const FieldElement::Field field = this->field();
    FieldElement time(curvature);
    if (table_.contains("time")) time = element(field, required(table_, "time"), "key \"time\"");
    if (time.sign() != curvature)
      fail(required(table_, "time"), "key \"time\"",
           "a number with the sign of the curvature, " + std::to_string(curvature));
    FieldMatrix gram = FieldMatrix::identity(m);
    if (table_.contains("gram")) gram = matrix(field, required(table_, "gram"), m, "key \"gram\"");
    SpaceFormDescription result{"", form(time, gram), generators(field, m + 1), {}, {}};
    result.first_homology = short_string(table_, "first_homology");
    if (table_.contains("order")) result.order = static_cast<std::size_t>(integer(table_, "order", 1, 100000));
    return result;
  }

  InvariantForm form(const FieldElement& time, const FieldMatrix& gram) const {
    try {
      return {time, gram};
    } catch (const InputError& error) {
      fail(required(table_, "gram").source(), error.what());
    }
  }

  FieldElement::Field field() const {
    if (!table_.contains("field")) return nullptr;
    const toml::node& node = required(table_, "field");
    const auto polynomial = of_text(node, "key \"field\"", [](const std::string& x) { return parse_polynomial(x); });
    const toml::node& root = required(table_, "root");
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

  std::vector<FieldMatrix> generators(const FieldElement::Field& field, std::size_t order) const {
    const toml::node& node = required(table_, "generators");
    const auto* list = node.as_array();
    if (list == nullptr) fail(node, "key \"generators\"", "an array of matrices");
    std::vector<FieldMatrix> result;
    for (const toml::node& entry : *list)
      result.push_back(matrix(field, entry, order, "generator " + std::to_string(result.size() + 1)));
    return result;
  }

  FieldMatrix matrix(const FieldElement::Field& field, const toml::node& node, std::size_t order,
                     const std::string& what) const {
    FieldMatrix result(order);
    for_each_entry(node, order, what,
                   [&](std::size_t row, std::size_t column, const toml::node& entry, const std::string& name) {
                     result(row, column) = element(field, entry, name);
                   });
    return result;
  }

  FieldElement element(const FieldElement::Field& field, const toml::node& node, const std::string& what) const {
    const auto coefficients = of_text(node, what, [](const std::string& x) { return parse_polynomial(x); });
    if (!field && coefficients.size() > 1) fail(node, what, "a rational number, as there is no key \"field\"");
    return field ? FieldElement(field, coefficients) : FieldElement(coefficients.front());
  }

  /// What a reader makes of a string, or of an integer's digits.
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

  toml::table table_;
};

}  // namespace

SpaceFormDescription parse_space_form(std::string_view text, const std::string& source) {
  return SpaceFormReader(text, source).read();
}

SpaceFormDescription find_space_form(const std::string& name) {
  std::string names;
  for (const BuiltinManifold& builtin : builtin_space_forms()) {
    if (builtin.name == name) return parse_space_form(builtin.text, builtin.name);
    names += (names.empty() ? "" : ", ") + builtin.name;
  }
  throw InputError("no space form \"" + name + "\", expected one of " + names);
}

}  // namespace delcert
