#include "kernel/manifold/space_form_file.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>

#include "kernel/manifold/quotient/polynomial_text.hpp"
#include "kernel/manifold/quotient/space_form_families.hpp"
#include "kernel/number/exact_text.hpp"
#include "support/error.hpp"
#include "support/toml_reader.hpp"

namespace delcert {

namespace {

constexpr std::array<std::string_view, 5> families{"space-form", "sphere", "projective-space", "lens-space",
                                                   "regular-polygon-surface"};

class SpaceFormReader : TomlReader {
 public:
  SpaceFormReader(const toml::table& table, const std::string& source) : TomlReader(table, source) {}

  SpaceFormDescription read() const {
    const std::string family = text("family");
    SpaceFormDescription result = of_family(family);
    result.name = text("name");
    return result;
  }

 private:
  SpaceFormDescription of_family(const std::string& family) const {
    if (family == "space-form") {
      allow(table(), {"name", "family", "dimension", "curvature", "field", "root", "time", "gram", "generators",
                      "first_homology", "order"});
      return general();
    }
    if (family == "sphere" || family == "projective-space") {
      allow(table(), {"name", "family", "dimension"});
      const int m = integer("dimension", 2, 3);
      return family == "sphere" ? sphere(m) : projective_space(m);
    }
    if (family == "lens-space") {
      allow(table(), {"name", "family", "p", "q"});
      const int p = integer("p", 3, 1000);
      return lens_space(p, integer("q", 1, p - 1));
    }
    if (family == "regular-polygon-surface") {
      allow(table(), {"name", "family", "genus"});
      return regular_polygon_surface(integer("genus", 2, 50));
    }
    fail(node("family"), "key \"family\"",
         "\"space-form\", \"sphere\", \"projective-space\", \"lens-space\" or \"regular-polygon-surface\"");
  }

  SpaceFormDescription general() const {
    const auto m = static_cast<std::size_t>(integer("dimension", 2, 3));
    const int curvature = integer("curvature", -1, 1);
    const FieldElement::Field field = this->field();
    FieldElement time(curvature);
    if (table().contains("time")) time = element(field, node("time"), "key \"time\"");
    if (time.sign() != curvature)
      fail(node("time"), "key \"time\"", "a number with the sign of the curvature, " + std::to_string(curvature));
    FieldMatrix gram = FieldMatrix::identity(m);
    if (table().contains("gram")) gram = matrix(field, node("gram"), m, "key \"gram\"");
    SpaceFormDescription result{"", form(time, gram), generators(field, m + 1), {}, {}};
    result.first_homology = text("first_homology");
    if (table().contains("order")) result.order = static_cast<std::size_t>(integer("order", 1, 100000));
    return result;
  }

  InvariantForm form(const FieldElement& time, const FieldMatrix& gram) const {
    try {
      return {time, gram};
    } catch (const InputError& error) {
      fail_at(node("gram"), error.what());
    }
  }

  FieldElement::Field field() const {
    if (!table().contains("field")) return nullptr;
    const toml::node& node = this->node("field");
    const auto polynomial = of_text(node, "key \"field\"", [](const std::string& x) { return parse_polynomial(x); });
    const toml::node& root = this->node("root");
    const auto* ends = root.as_array();
    if (ends == nullptr || ends->size() != 2) fail(root, "key \"root\"", "an array of two exact numbers");
    const auto end = [&](std::size_t at) {
      return of_text((*ends)[at], "key \"root\"", [](const std::string& x) { return parse_exact(x); });
    };
    try {
      return std::make_shared<const NumberField>(polynomial, end(0), end(1));
    } catch (const InputError& error) {
      fail_at(node, error.what());
    }
  }

  std::vector<FieldMatrix> generators(const FieldElement::Field& field, std::size_t order) const {
    const toml::node& node = this->node("generators");
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
      fail_at(node, what + ": " + error.what());
    }
  }
};

}  // namespace

SpaceFormDescription parse_space_form(std::string_view text, const std::string& source) {
  return read_toml<SpaceFormReader>(text, source);
}

SpaceFormDescription read_space_form(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream || std::filesystem::is_directory(path)) throw InputError("cannot read " + path.string());
  return parse_space_form(std::string(std::istreambuf_iterator<char>(stream), {}), path.string());
}

std::optional<SpaceFormDescription> space_form_if_one(const std::string& name_or_path) {
  const auto& known = builtin_space_forms();
  if (std::any_of(known.begin(), known.end(), [&](const auto& builtin) { return builtin.name == name_or_path; }))
    return find_space_form(name_or_path);
  try {
    const toml::table table = toml::parse_file(name_or_path);
    const auto family = table["family"].value<std::string_view>();
    if (!family || std::find(families.begin(), families.end(), *family) == families.end()) return std::nullopt;
  } catch (const toml::parse_error&) {
    return std::nullopt;
  }
  return read_space_form(name_or_path);
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
