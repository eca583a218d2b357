#include "kernel/manifold/manifold_file.hpp"

// toml++ 3.3.0 asserts what a file can break ("[#"), and where assertions are off it lets clang assume it. Neither:
// what follows reports the error.
#undef NDEBUG
#define TOML_ASSERT(condition) static_cast<void>(0)
#include <toml++/toml.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <iterator>
#include <optional>
#include <sstream>
#include <system_error>

#include "kernel/manifold/builtin_manifolds.hpp"
#include "kernel/manifold/metric_field_file.hpp"
#include "kernel/manifold/space_form_file.hpp"
#include "kernel/number/exact_text.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

using Matrix = std::vector<std::vector<Rational>>;

constexpr std::string_view number_expected = "an exact number: an integer, or a string such as \"3/4\" or \"0x3p-2\"";

std::string on_one_line(std::string_view text) {
  std::string result;
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    result += code < 0x20 || code == 0x7f ? '?' : c;
  }
  return result;
}

// Texts come from files: what is quoted stays short, on one line.
std::string in_quotes(std::string_view text) {
  constexpr std::size_t longest = 80;
  return "\"" + on_one_line(text.substr(0, longest)) + (text.size() > longest ? "…\"" : "\"");
}

/// What a value is, for "found …".
std::string description_of(const toml::node& node) {
  std::ostringstream stream;
  switch (node.type()) {
    case toml::node_type::table:
      return "a table";
    case toml::node_type::array:
      return "an array of length " + std::to_string(node.as_array()->size());
    case toml::node_type::string:
      return in_quotes(node.as_string()->get());
    case toml::node_type::integer:
      stream << *node.as_integer();
      return "the integer " + stream.str();
    case toml::node_type::floating_point:
      stream << *node.as_floating_point();
      return "the floating-point number " + stream.str();
    case toml::node_type::boolean:
      stream << *node.as_boolean();
      return "the boolean " + stream.str();
    default:
      return "a date or a time";
  }
}

class Reader {
 public:
  Reader(const toml::table& table, const std::string& source) : table_(table), source_(source) {}

  ManifoldDescription read() const {
    ManifoldDescription result;
    result.family = family();
    refuse_unknown_keys(result.family);
    result.name = name();
    result.dimension = dimension();
    if (result.family == ManifoldFamily::flat_torus) {
      result.gram = gram(result.dimension);
    } else {
      result.radius = radius();
      result.gram = identity(result.dimension);
    }
    return result;
  }

 private:
  [[noreturn]] void fail(const toml::source_region& where, const std::string& message) const {
    throw InputError(source_ + ":" + std::to_string(where.begin.line) + ":" + std::to_string(where.begin.column) +
                     ": " + message);
  }

  [[noreturn]] void fail(const toml::node& node, std::string_view what, std::string_view expected) const {
    fail(node.source(), std::string(what) + ": found " + description_of(node) + ", expected " + std::string(expected));
  }

  const toml::node& required(std::string_view key, std::string_view expected) const {
    const toml::node* node = table_.get(key);
    if (node == nullptr)
      throw InputError(source_ + ": key " + in_quotes(key) + " is missing, expected " + std::string(expected));
    return *node;
  }

  ManifoldFamily family() const {
    const std::string expected = "\"flat-torus\" or \"euclidean-ball\"";
    const toml::node& node = required("family", expected);
    const auto value = node.value_exact<std::string>();
    for (const ManifoldFamily family : {ManifoldFamily::flat_torus, ManifoldFamily::euclidean_ball})
      if (value && *value == name_of(family)) return family;
    fail(node, "key \"family\"", expected);
  }

  void refuse_unknown_keys(ManifoldFamily family) const {
    const bool torus = family == ManifoldFamily::flat_torus;
    const std::vector<std::string_view> known =
        torus ? std::vector<std::string_view>{"name", "family", "dimension", "gram", "basis"}
              : std::vector<std::string_view>{"name", "family", "dimension", "radius"};
    std::string expected;
    for (const std::string_view key : known) expected += (expected.empty() ? "" : ", ") + std::string(key);
    for (const auto& [key, node] : table_)
      if (std::find(known.begin(), known.end(), key.str()) == known.end())
        fail(key.source(), "unknown key " + in_quotes(key.str()) + ", expected for family " +
                               in_quotes(name_of(family)) + ": " + expected);
  }

  std::string name() const {
    constexpr std::string_view expected = "a string of 1 to 64 letters, digits, \".\", \"_\" or \"-\"";
    const toml::node& node = required("name", expected);
    const auto value = node.value_exact<std::string>();
    const auto allowed = [](char c) {
      return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' || c == '_' ||
             c == '-';
    };
    if (!value || value->empty() || value->size() > 64 || !std::all_of(value->begin(), value->end(), allowed))
      fail(node, "key \"name\"", expected);
    return *value;
  }

  Dimension dimension() const {
    constexpr std::string_view expected = "an integer from 1 to 4";
    const toml::node& node = required("dimension", expected);
    const auto value = node.value_exact<std::int64_t>();
    if (!value || *value < 1 || *value > 4) fail(node, "key \"dimension\"", expected);
    return Dimension{*value};
  }

  Rational number(const toml::node& node, const std::string& what) const {
    if (const auto* integer = node.as_integer()) return Rational(integer->get());
    if (const auto* text = node.as_string()) {
      try {
        return parse_exact(text->get());
      } catch (const ExactTextError& error) {
        fail(node.source(), what + ": " + error.what());
      }
    }
    if (node.is_floating_point())
      fail(node, what, std::string(number_expected) + "; a floating-point number would be rounded before it is read");
    fail(node, what, number_expected);
  }

  Rational radius() const {
    const toml::node& node = required("radius", number_expected);
    Rational value = number(node, "key \"radius\"");
    if (value <= Rational(0)) fail(node, "key \"radius\"", "a number above 0");
    return value;
  }

  /// m rows of m numbers.
  Matrix square_matrix(const toml::node& node, const std::string& key, Dimension dimension) const {
    const std::string m = std::to_string(dimension.value);
    const auto size = static_cast<std::size_t>(dimension.value);
    const auto rows_expected = "an array of " + m + " rows of " + m + " numbers, as the dimension is " + m;
    const auto* rows = node.as_array();
    if (rows == nullptr || rows->size() != size) fail(node, "key " + in_quotes(key), rows_expected);
    Matrix result(size);
    for (std::size_t row = 0; row < size; ++row) {
      const std::string row_name = "key " + in_quotes(key) + ", row " + std::to_string(row + 1);
      const auto* entries = (*rows)[row].as_array();
      if (entries == nullptr || entries->size() != size) fail((*rows)[row], row_name, "an array of " + m + " numbers");
      for (std::size_t column = 0; column < size; ++column)
        result[row].push_back(number((*entries)[column], row_name + ", entry " + std::to_string(column + 1)));
    }
    return result;
  }

  Matrix gram(Dimension dimension) const {
    const toml::node* given_gram = table_.get("gram");
    const toml::node* given_basis = table_.get("basis");
    if (given_gram == nullptr && given_basis == nullptr)
      throw InputError(source_ + ": key \"gram\" (inner products) or \"basis\" (lattice basis, by rows) is missing");
    if (given_gram != nullptr && given_basis != nullptr)
      fail(given_basis->source(), "both \"gram\" and \"basis\" are given, expected one of them");
    if (given_gram != nullptr) {
      Matrix result = square_matrix(*given_gram, "gram", dimension);
      require_symmetric(*given_gram, result);
      require_positive_definite(*given_gram, result);
      return result;
    }
    return gram_of_basis(*given_basis, square_matrix(*given_basis, "basis", dimension));
  }

  void require_symmetric(const toml::node& node, const Matrix& matrix) const {
    for (std::size_t row = 0; row < matrix.size(); ++row)
      for (std::size_t column = 0; column < row; ++column)
        if (matrix[row][column] != matrix[column][row]) {
          const auto entry = [](std::size_t i, std::size_t j) {
            return "row " + std::to_string(i + 1) + ", entry " + std::to_string(j + 1);
          };
          fail((*(*node.as_array())[row].as_array())[column].source(),
               "key \"gram\", " + entry(row, column) + ": found " + exact_text(matrix[row][column]) + ", expected " +
                   exact_text(matrix[column][row]) + " as in " + entry(column, row) + ": the matrix is symmetric");
        }
  }

  struct Minor {
    std::size_t size;
    Rational determinant;
  };

  /// The first leading principal minor of a symmetric matrix that is not positive.
  static std::optional<Minor> first_minor_not_positive(Matrix matrix) {
    Rational determinant(1);
    for (std::size_t k = 0; k < matrix.size(); ++k) {
      determinant *= matrix[k][k];
      if (determinant <= Rational(0)) return Minor{k + 1, determinant};
      for (std::size_t row = k + 1; row < matrix.size(); ++row) {
        const Rational factor = matrix[row][k] / matrix[k][k];
        for (std::size_t column = k; column < matrix.size(); ++column)
          matrix[row][column] -= factor * matrix[k][column];
      }
    }
    return std::nullopt;
  }

  void require_positive_definite(const toml::node& node, const Matrix& matrix) const {
    if (const auto minor = first_minor_not_positive(matrix)) {
      const std::string size = std::to_string(minor->size);
      fail(node.source(), "key \"gram\": found a leading " + size + " × " + size + " minor of " +
                              exact_text(minor->determinant) + ", expected above 0: the matrix is positive definite");
    }
  }

  Matrix gram_of_basis(const toml::node& node, const Matrix& basis) const {
    Matrix result(basis.size(), std::vector<Rational>(basis.size()));
    for (std::size_t i = 0; i < basis.size(); ++i)
      for (std::size_t j = 0; j < basis.size(); ++j)
        for (std::size_t k = 0; k < basis.size(); ++k) result[i][j] += basis[i][k] * basis[j][k];
    if (const auto minor = first_minor_not_positive(result))
      fail((*node.as_array())[minor->size - 1].source(),
           "key \"basis\", row " + std::to_string(minor->size) +
               ": found a linear combination of the rows before, expected linearly independent rows");
    return result;
  }

  static Matrix identity(Dimension dimension) {
    const auto size = static_cast<std::size_t>(dimension.value);
    Matrix result(size, std::vector<Rational>(size));
    for (std::size_t i = 0; i < size; ++i) result[i][i] = Rational(1);
    return result;
  }

  const toml::table& table_;
  const std::string& source_;
};

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

std::string_view name_of(ManifoldFamily family) {
  return family == ManifoldFamily::flat_torus ? "flat-torus" : "euclidean-ball";
}

ManifoldDescription parse_manifold(std::string_view text, const std::string& source) {
  try {
    const toml::table table = toml::parse(text, source);
    return Reader(table, source).read();
  } catch (const toml::parse_error& error) {
    const auto& where = error.source().begin;
    throw InputError(source + ":" + std::to_string(where.line) + ":" + std::to_string(where.column) +
                     ": not TOML: " + on_one_line(error.description()));
  }
}

ManifoldDescription read_manifold(const std::filesystem::path& path) {
  return parse_manifold(content_of(path), path.string());
}

ManifoldDescription find_manifold(const std::string& name_or_path) {
  std::string names;
  for (const BuiltinManifold& builtin : builtin_manifolds()) {
    if (builtin.name == name_or_path) return parse_manifold(builtin.text, builtin.name);
    names += (names.empty() ? "" : ", ") + builtin.name;
  }
  if (!std::filesystem::exists(name_or_path)) {
    std::string forms;
    for (const BuiltinManifold& builtin : builtin_space_forms()) forms += (forms.empty() ? "" : ", ") + builtin.name;
    std::string fields;
    for (const BuiltinManifold& builtin : builtin_metric_fields())
      fields += (fields.empty() ? "" : ", ") + builtin.name;
    throw InputError("no manifold \"" + name_or_path + "\": neither a file nor one of " + names +
                     ", or of the space forms " + forms + ", or of the metric fields " + fields);
  }
  return read_manifold(name_or_path);
}

}  // namespace delcert
