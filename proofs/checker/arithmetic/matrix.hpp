#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "proofs/checker/arithmetic/ball.hpp"

namespace delcert::checker {

/// A matrix of any shape; with one column, a vector.
template <class N>
class Matrix {
 public:
  Matrix() = default;
  Matrix(std::size_t rows, std::size_t columns) : rows_(rows), columns_(columns) {
    if (size() > few) many_.resize(size());
  }

  std::size_t rows() const { return rows_; }
  std::size_t columns() const { return columns_; }
  N& operator()(std::size_t i, std::size_t k) { return data()[i * columns_ + k]; }
  const N& operator()(std::size_t i, std::size_t k) const { return data()[i * columns_ + k]; }
  /// The i-th entry, row by row.
  N& operator[](std::size_t i) { return data()[i]; }
  const N& operator[](std::size_t i) const { return data()[i]; }
  std::size_t size() const { return rows_ * columns_; }

  /// The columns first … first + number - 1.
  Matrix columns_from(std::size_t first, std::size_t number) const {
    Matrix result(rows_, number);
    for (std::size_t i = 0; i < rows_; ++i) {
      for (std::size_t k = 0; k < number; ++k) result(i, k) = (*this)(i, first + k);
    }
    return result;
  }
  friend Matrix operator*(const Matrix& a, const Matrix& b) {
    Matrix result(a.rows_, b.columns_);
    for (std::size_t i = 0; i < a.rows_; ++i) {
      for (std::size_t k = 0; k < b.columns_; ++k) {
        N sum = a(i, 0) * b(0, k);
        for (std::size_t j = 1; j < a.columns_; ++j) sum = sum + a(i, j) * b(j, k);
        result(i, k) = sum;
      }
    }
    return result;
  }
  Matrix transposed() const {
    Matrix result(columns_, rows_);
    for (std::size_t i = 0; i < rows_; ++i) {
      for (std::size_t k = 0; k < columns_; ++k) result(k, i) = (*this)(i, k);
    }
    return result;
  }
  /// The transposed of a, times b.
  friend Matrix transposed_times(const Matrix& a, const Matrix& b) {
    Matrix result(a.columns_, b.columns_);
    for (std::size_t i = 0; i < a.columns_; ++i) {
      for (std::size_t k = 0; k < b.columns_; ++k) {
        N sum = a(0, i) * b(0, k);
        for (std::size_t j = 1; j < a.rows_; ++j) sum = sum + a(j, i) * b(j, k);
        result(i, k) = sum;
      }
    }
    return result;
  }
  friend Matrix operator*(const N& a, Matrix b) {
    for (std::size_t k = 0; k < b.size(); ++k) b[k] = a * b[k];
    return b;
  }
  friend Matrix operator+(Matrix a, const Matrix& b) {
    for (std::size_t k = 0; k < a.size(); ++k) a[k] = a[k] + b[k];
    return a;
  }
  friend Matrix operator-(Matrix a, const Matrix& b) {
    for (std::size_t k = 0; k < a.size(); ++k) a[k] = a[k] - b[k];
    return a;
  }
  /// 1 - a, for a square.
  friend Matrix one_less(const Matrix& a) {
    Matrix result = N(-1) * a;
    for (std::size_t k = 0; k < a.rows_; ++k) result(k, k) = N(1) + result(k, k);
    return result;
  }
  /// The sum of the squares of the entries.
  friend N squared_norm(const Matrix& a) {
    N sum(0);
    for (std::size_t k = 0; k < a.size(); ++k) sum = sum + square(a[k]);
    return sum;
  }
  /// Gauss and Jordan without a search for pivots: of a with |1 - a| < 1 no leading minor is 0, nor of 1 + a for a
  /// skew.
  friend Matrix solution(Matrix a, Matrix b) {
    for (std::size_t k = 0; k < a.rows_; ++k) {
      const N unit = N(1) / a(k, k);
      for (std::size_t j = 0; j < a.columns_; ++j) a(k, j) = unit * a(k, j);
      for (std::size_t j = 0; j < b.columns_; ++j) b(k, j) = unit * b(k, j);
      for (std::size_t i = 0; i < a.rows_; ++i) {
        if (i == k) continue;
        const N factor = a(i, k);
        for (std::size_t j = 0; j < a.columns_; ++j) a(i, j) = a(i, j) - factor * a(k, j);
        for (std::size_t j = 0; j < b.columns_; ++j) b(i, j) = b(i, j) - factor * b(k, j);
      }
    }
    return b;
  }

 private:
  static constexpr std::size_t few = 12;  // entries need no memory of their own
  N* data() { return many_.empty() ? few_.data() : many_.data(); }
  const N* data() const { return many_.empty() ? few_.data() : many_.data(); }

  std::size_t rows_ = 0, columns_ = 0;
  std::array<N, few> few_{};
  std::vector<N> many_;
};

/// An upper bound of the root of the sum of the squares, and so of the spectral norm. Precondition: rounding upwards.
inline double norm_above(const Matrix<Interval>& a) { return upper_root(squared_norm(a)); }

/// An upper bound of the spectral norm, not above that one, and greater than it by less than a hundredth for up to four
/// rows or columns: G = a a^T or a^T a has the trace t and the greatest eigenvalue |a|^2, and the trace of (G / t)^64
/// is at least (|a|^2 / t)^64. Precondition: rounding upwards.
inline double spectral_norm_above(const Matrix<Interval>& a) {
  constexpr int squarings = 6;
  Matrix<Interval> power = a.rows() < a.columns() ? a * a.transposed() : transposed_times(a, a);
  const double trace = squared_norm(a).upper();
  if (power.rows() == 1 || !(trace > 0 && trace < std::numeric_limits<double>::infinity())) return norm_above(a);
  power = (Interval(1) / Interval::between(trace, trace)) * power;
  for (int step = 0; step < squarings; ++step) power = power * power;
  Interval sum(0);
  for (std::size_t k = 0; k < power.rows(); ++k) sum = sum + power(k, k);
  double root = sum.upper();
  for (int step = 0; step < squarings; ++step) root = std::sqrt(root);  // rounded upwards
  return std::min(std::sqrt(root * trace), norm_above(a));
}

template <class N>
Matrix<N> as_numbers(const Matrix<Rational>& a) {
  Matrix<N> result(a.rows(), a.columns());
  for (std::size_t k = 0; k < a.size(); ++k) {
    if constexpr (std::is_same_v<N, Interval>) {
      result[k] = enclosure(a[k]);
    } else {
      result[k] = N(a[k]);
    }
  }
  return result;
}

}  // namespace delcert::checker
