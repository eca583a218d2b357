#include "kernel/manifold/manifold_file.hpp"

#include <algorithm>
#include <optional>

#include "kernel/manifold/exact_entry.hpp"
#include "kernel/number/exact_text.hpp"
#include "support/error.hpp"
#include "support/toml_reader.hpp"

namespace delcert {

namespace {

using Matrix = std::vector<std::vector<Rational>>;

class FlatReader : TomlReader {
 public:
  FlatReader(std::string_view text, const std::string& source) : TomlReader(text, source), table_(parse()) {}

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
  ManifoldFamily family() const {
    const std::string expected = "\"flat-torus\" or \"euclidean-ball\"";
    const toml::node& node = required(table_, "family", expected);
    const auto value = node.value_exact<std::string>();
    for (const ManifoldFamily family : {ManifoldFamily::flat_torus, ManifoldFamily::euclidean_ball})
      if (value && *value == name_of(family)) return family;
    fail(node, "key \"family\"", expected);
  }

  void refuse_unknown_keys(ManifoldFamily family) const {
    if (family == ManifoldFamily::flat_torus) {
      refuse_unknown(table_, {"name", "family", "dimension", "gram", "basis"});
    } else {
      refuse_unknown(table_, {"name", "family", "dimension", "radius"});
    }
  }

  std::string name() const {
    constexpr std::string_view expected = "a string of 1 to 64 letters, digits, \".\", \"_\" or \"-\"";
    const toml::node& node = required(table_, "name", expected);
    const auto value = node.value_exact<std::string>();
    const auto allowed = [](char c) {
      return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' || c == '_' ||
             c == '-';
    };
    if (!value || value->empty() || value->size() > 64 || !std::all_of(value->begin(), value->end(), allowed))
      fail(node, "key \"name\"", expected);
    return *value;
  }

  Dimension dimension() const { return Dimension{integer(table_, "dimension", 1, 4)}; }

  Rational radius() const {
    const toml::node& node = required(table_, "radius", exact_number_expected);
    Rational value = exact_number(*this, node, "key \"radius\"");
    if (value <= Rational(0)) fail(node, "key \"radius\"", "a number above 0");
    return value;
  }

  /// m rows of m numbers.
  Matrix square_matrix(const toml::node& node, const std::string& key, Dimension dimension) const {
    const auto size = static_cast<std::size_t>(dimension.value);
    Matrix result(size);
    for_each_entry(node, size, key_in_words(key),
                   [&](std::size_t row, std::size_t, const toml::node& entry, const std::string& what) {
                     result[row].push_back(exact_number(*this, entry, what));
                   });
    return result;
  }

  Matrix gram(Dimension dimension) const {
    const toml::node* given_gram = table_.get("gram");
    const toml::node* given_basis = table_.get("basis");
    if (given_gram == nullptr && given_basis == nullptr)
      fail(table_.source(), "key \"gram\" (inner products) or \"basis\" (lattice basis, by rows) is missing");
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

  toml::table table_;
};

}  // namespace

std::string_view name_of(ManifoldFamily family) {
  return family == ManifoldFamily::flat_torus ? "flat-torus" : "euclidean-ball";
}

ManifoldDescription parse_manifold(std::string_view text, const std::string& source) {
  return FlatReader(text, source).read();
}

}  // namespace delcert
