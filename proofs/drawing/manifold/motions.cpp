#include "proofs/drawing/manifold/motions.hpp"

#include <algorithm>
#include <cmath>

namespace delcert {

namespace {

/// Far above rounding, far below what two elements of a discrete group differ by.
constexpr double same_motion = 1e-6;

std::vector<std::int32_t> reduced_word(std::vector<std::int32_t> first, const std::vector<std::int32_t>& second) {
  for (const std::int32_t letter : second) {
    if (!first.empty() && first.back() == -letter) {
      first.pop_back();
    } else {
      first.push_back(letter);
    }
  }
  return first;
}

std::vector<std::int32_t> inverse_word(std::vector<std::int32_t> word) {
  std::reverse(word.begin(), word.end());
  for (std::int32_t& letter : word) letter = -letter;
  return word;
}

}  // namespace

Motions::Motions(std::size_t order) : order_(order) {
  Matrix identity{};
  for (std::size_t k = 0; k < order_; ++k) identity[k * order_ + k] = 1;
  motions_.push_back({identity, {}, 0});
}

void Motions::add_letter(const Matrix& letter, const Matrix& inverse) {
  const auto name = static_cast<std::int32_t>(letter_count() + 1);
  const std::uint32_t at = kept(letter, inverse, {name});
  letters_.push_back(at);
  letters_.push_back(motions_[at].inverse);
}

std::uint32_t Motions::translation(const std::vector<std::int32_t>& shift) {
  Matrix matrix = motions_[0].matrix;
  Matrix inverse = matrix;
  for (std::size_t k = 0; k < shift.size(); ++k) {
    matrix[(k + 1) * order_] = shift[k];
    inverse[(k + 1) * order_] = -shift[k];
  }
  return kept(matrix, inverse, {});
}

std::uint32_t Motions::letter(std::int32_t letter) const {
  const std::size_t pair = 2 * static_cast<std::size_t>(std::abs(letter) - 1);
  return letters_[letter < 0 ? pair + 1 : pair];
}

std::uint32_t Motions::product(std::uint32_t a, std::uint32_t b) {
  if (a == 0) return b;
  if (b == 0) return a;
  std::uint32_t& known = known_product(a, b);
  if (known != 0) return known - 1;
  const Motion& first = motions_[a];
  const Motion& second = motions_[b];
  const std::uint32_t result =
      kept(times(first.matrix, second.matrix), times(motions_[second.inverse].matrix, motions_[first.inverse].matrix),
           reduced_word(first.word, second.word));
  known = result + 1;
  return result;
}

std::uint32_t& Motions::known_product(std::uint32_t a, std::uint32_t b) {
  if (a >= most_in_table || b >= most_in_table) return other_products_[(std::uint64_t{a} << 32U) | b];
  if (a >= products_.size()) products_.resize(a + 1);
  if (products_[a].empty()) products_[a].resize(most_in_table);
  return products_[a][b];
}

Motions::Vector Motions::apply(std::uint32_t a, const Vector& x) const {
  if (a == 0) return x;
  Vector result{};
  const Matrix& matrix = motions_[a].matrix;
  for (std::size_t row = 0; row < order_; ++row) {
    for (std::size_t column = 0; column < order_; ++column) result[row] += matrix[row * order_ + column] * x[column];
  }
  return result;
}

Motions::Matrix Motions::times(const Matrix& a, const Matrix& b) const {
  Matrix result{};
  for (std::size_t row = 0; row < order_; ++row) {
    for (std::size_t column = 0; column < order_; ++column) {
      double sum = 0;
      for (std::size_t k = 0; k < order_; ++k) sum += a[row * order_ + k] * b[k * order_ + column];
      result[row * order_ + column] = sum;
    }
  }
  return result;
}

std::uint32_t Motions::find(const Matrix& matrix) const {
  const auto differs = [this, &matrix](const Motion& motion) {
    for (std::size_t k = 0; k < order_ * order_; ++k) {
      if (std::fabs(motion.matrix[k] - matrix[k]) > same_motion * (1 + std::fabs(matrix[k]))) return true;
    }
    return false;
  };
  const auto found = std::find_if_not(motions_.begin(), motions_.end(), differs);
  return static_cast<std::uint32_t>(found - motions_.begin());
}

std::uint32_t Motions::kept(const Matrix& matrix, const Matrix& inverse, std::vector<std::int32_t> word) {
  const std::uint32_t found = find(matrix);
  if (found < motions_.size()) return found;
  const auto at = static_cast<std::uint32_t>(motions_.size());
  motions_.push_back({matrix, std::move(word), at});
  // An element may be its own inverse.
  const std::uint32_t other = find(inverse);
  if (other == motions_.size()) motions_.push_back({inverse, inverse_word(motions_[at].word), at});
  motions_[at].inverse = other;
  return at;
}

}  // namespace delcert
