#include "kernel/manifold/space_form_file.hpp"

#include "kernel/manifold/group_reader.hpp"
#include "kernel/manifold/quotient/space_form_families.hpp"
#include "kernel/number/exact_text.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

class SpaceFormReader : GroupReader {
 public:
  SpaceFormReader(std::string_view text, const std::string& source) : GroupReader(text, source), table_(parse()) {}

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
    const FieldElement::Field field = this->field(table_);
    const InvariantForm form = this->form(table_, field);
    SpaceFormDescription result{"", form, generators(field, form.matrix().order()), {}, {}};
    result.first_homology = short_string(table_, "first_homology");
    if (table_.contains("order")) result.order = static_cast<std::size_t>(integer(table_, "order", 1, 100000));
    return result;
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
