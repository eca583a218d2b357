#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

namespace delcert {

/// Matrices of isometries in doubles, without error bounds: each kept once, by its number; 0 is the identity. Of a
/// group that acts freely and is discrete, so that two elements are never nearly the same.
class Motions {
 public:
  static constexpr std::size_t most_rows = 5;
  /// Row by row.
  using Matrix = std::array<double, most_rows * most_rows>;
  using Vector = std::array<double, most_rows>;

  /// Matrices have this order, at most `most_rows`.
  explicit Motions(std::size_t order);

  /// The matrix of a letter s > 0, its inverse that of −s. Letters are added in the order 1, 2, ….
  void add_letter(const Matrix& letter, const Matrix& inverse);
  /// x ↦ x + γ in homogeneous coordinates (1, x); without a word.
  [[nodiscard]] std::uint32_t translation(const std::vector<std::int32_t>& shift);

  /// The number of a letter, which is not 0. Precondition: |letter| ≤ letter_count().
  [[nodiscard]] std::uint32_t letter(std::int32_t letter) const;
  [[nodiscard]] std::size_t letter_count() const { return letters_.size() / 2; }
  [[nodiscard]] std::uint32_t product(std::uint32_t a, std::uint32_t b);
  [[nodiscard]] std::uint32_t inverse(std::uint32_t a) const { return motions_[a].inverse; }
  [[nodiscard]] std::size_t size() const { return motions_.size(); }
  [[nodiscard]] const Matrix& matrix(std::uint32_t a) const { return motions_[a].matrix; }
  /// A word in the letters, some one of those that stand for the motion.
  [[nodiscard]] const std::vector<std::int32_t>& word(std::uint32_t a) const { return motions_[a].word; }
  [[nodiscard]] Vector apply(std::uint32_t a, const Vector& x) const;

 private:
  struct Motion {
    Matrix matrix;
    std::vector<std::int32_t> word;
    std::uint32_t inverse;
  };
  [[nodiscard]] Matrix times(const Matrix& a, const Matrix& b) const;
  /// Its number; it and its inverse are kept if they are new.
  [[nodiscard]] std::uint32_t kept(const Matrix& matrix, const Matrix& inverse, std::vector<std::int32_t> word);
  [[nodiscard]] std::uint32_t find(const Matrix& matrix) const;
  /// 1 more than the number of the product; 0 if it has not been computed.
  [[nodiscard]] std::uint32_t& known_product(std::uint32_t a, std::uint32_t b);

  /// Products of those with lower numbers are in a table, row by row; nearly all that are asked for are.
  static constexpr std::uint32_t most_in_table = 1024;

  std::size_t order_;
  std::vector<Motion> motions_;
  std::vector<std::uint32_t> letters_;  ///< those of 1, −1, 2, −2, …
  std::vector<std::vector<std::uint32_t>> products_;
  std::unordered_map<std::uint64_t, std::uint32_t> other_products_;
};

}  // namespace delcert
