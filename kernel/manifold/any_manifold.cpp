#include "kernel/manifold/any_manifold.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <fstream>
#include <iterator>
#include <optional>
#include <system_error>
#include <vector>

#include "kernel/manifold/atlas_file.hpp"
#include "kernel/manifold/metric_field_file.hpp"
#include "kernel/manifold/space_form_file.hpp"
#include "kernel/manifold/submanifold_file.hpp"
#include "support/error.hpp"
#include "support/spelling.hpp"
#include "support/toml_reader.hpp"

namespace delcert {

namespace {

using Parse = AnyManifold (*)(std::string_view text, const std::string& source);

AnyManifold parsed_as_flat(std::string_view text, const std::string& source) { return parse_manifold(text, source); }

/// The flat torus that a quotient of Euclidean space by translations alone is. None if the file says another homology
/// or an order: that is left to the verification of groups, which refuses it.
std::optional<ManifoldDescription> flat_torus_of(const SpaceFormDescription& form) {
  const auto m = static_cast<std::size_t>(form.form.dimension());
  const bool is_torus = form.form.curvature() == Curvature::zero && form.generators.empty() && !form.order &&
                        form.first_homology == "Z^" + std::to_string(m);
  if (!is_torus) return std::nullopt;
  ManifoldDescription result{form.name, ManifoldFamily::flat_torus, Dimension(form.form.dimension()), {}, Rational(0)};
  for (std::size_t row = 0; row < m; ++row) {
    auto& entries = result.gram.emplace_back();
    for (std::size_t column = 0; column < m; ++column) {
      const FieldElement& entry = form.form.gram()(row, column);
      if (!entry.is_rational()) return std::nullopt;
      entries.push_back(entry.rational());
    }
  }
  return result;
}

AnyManifold parsed_as_space_form(std::string_view text, const std::string& source) {
  SpaceFormDescription form = parse_space_form(text, source);
  if (auto torus = flat_torus_of(form)) return *std::move(torus);
  return form;
}
AnyManifold parsed_as_metric_field(std::string_view text, const std::string& source) {
  return parse_metric_field(text, source);
}
AnyManifold parsed_as_atlas(std::string_view text, const std::string& source) { return parse_atlas(text, source); }
AnyManifold parsed_as_submanifold(std::string_view text, const std::string& source) {
  return parse_submanifold(text, source);
}

struct Family {
  std::string_view name;
  Parse parse;
};

constexpr std::array<Family, 11> families{{{"flat-torus", parsed_as_flat},
                                           {"euclidean-ball", parsed_as_flat},
                                           {"space-form", parsed_as_space_form},
                                           {"sphere", parsed_as_space_form},
                                           {"projective-space", parsed_as_space_form},
                                           {"lens-space", parsed_as_space_form},
                                           {"regular-polygon-surface", parsed_as_space_form},
                                           {"product-with-circle", parsed_as_space_form},
                                           {"metric-field", parsed_as_metric_field},
                                           {"atlas", parsed_as_atlas},
                                           {"submanifold", parsed_as_submanifold}}};

std::string listed(const std::vector<std::string_view>& names) {
  std::string result;
  for (const std::string_view name : names) result += (result.empty() ? "" : ", ") + std::string(name);
  return result;
}

/// The reader of the family that the text names.
Parse reader_for(std::string_view text, const std::string& source) {
  const TomlReader reader(text, source);
  const toml::table table = reader.parse();
  std::vector<std::string_view> names;
  for (const Family& family : families) names.push_back(family.name);
  const std::string expected = "one of " + listed(names);
  const toml::node& node = reader.required(table, "family", expected);
  const auto value = node.value_exact<std::string>();
  if (!value) reader.fail(node, key_in_words("family"), expected);
  for (const Family& family : families)
    if (*value == family.name) return family.parse;
  reader.fail(node, key_in_words("family"), expected + suggestion(*value, names));
}

std::string content_of(const std::filesystem::path& path) {
  std::error_code reason;
  if (std::filesystem::is_directory(path, reason)) {
    reason = std::make_error_code(std::errc::is_a_directory);
  } else {
    errno = 0;
    std::ifstream stream(path, std::ios::binary);
    if (stream) return {std::istreambuf_iterator<char>(stream), {}};
    reason = std::error_code(errno, std::generic_category());
  }
  throw InputError("cannot read " + path.string() + ": " + reason.message());
}

}  // namespace

AnyManifold parse_any_manifold(std::string_view text, const std::string& source) {
  return reader_for(text, source)(text, source);
}

AnyManifold read_any_manifold(const std::filesystem::path& path) {
  return parse_any_manifold(content_of(path), path.string());
}

std::array<BuiltinKind, 5> builtin_kinds() {
  return {{{"flat", "flat manifolds", &builtin_manifolds()},
           {"space form", "space forms", &builtin_space_forms()},
           {"metric field", "metric fields", &builtin_metric_fields()},
           {"atlas", "atlases", &builtin_atlases()},
           {"submanifold", "submanifolds", &builtin_submanifolds()}}};
}

AnyManifold find_any_manifold(const std::string& name_or_path) {
  std::vector<std::string_view> all;
  std::string listing;
  for (const BuiltinKind& kind : builtin_kinds()) {
    std::vector<std::string_view> known;
    for (const BuiltinManifold& builtin : *kind.manifolds) {
      if (builtin.name == name_or_path) return parse_any_manifold(builtin.text, builtin.name);
      known.emplace_back(builtin.name);
    }
    listing += (listing.empty() ? "" : ", or of the " + std::string(kind.plural) + " ") + listed(known);
    all.insert(all.end(), known.begin(), known.end());
  }
  if (!std::filesystem::exists(name_or_path)) {
    throw InputError("no manifold \"" + name_or_path + "\": neither a file nor one of " + listing +
                     suggestion(name_or_path, all));
  }
  return read_any_manifold(name_or_path);
}

ManifoldDescription find_manifold(const std::string& name_or_path) {
  AnyManifold found = find_any_manifold(name_or_path);
  if (auto* flat = std::get_if<ManifoldDescription>(&found)) return std::move(*flat);
  throw InputError(
      name_or_path +
      ": a space form, a metric field, an atlas or a submanifold, expected a flat torus or a Euclidean ball");
}

}  // namespace delcert
