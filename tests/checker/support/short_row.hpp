#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

namespace delcert::checker_tests {

/// At most four numbers, which need no memory of their own. Throws std::out_of_range if more are asked for.
class ShortRow {
 public:
  ShortRow() = default;
  explicit ShortRow(std::size_t size, double value = 0) : size_(size) {
    for (std::size_t k = 0; k < size; ++k) values_.at(k) = value;
  }

  void push_back(double value) {
    values_.at(size_) = value;
    ++size_;
  }
  std::size_t size() const { return size_; }
  double& operator[](std::size_t k) { return values_[k]; }
  double operator[](std::size_t k) const { return values_[k]; }
  const double* begin() const { return values_.data(); }
  const double* end() const { return values_.data() + size_; }
  friend bool operator==(const ShortRow& a, const ShortRow& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end());
  }

 private:
  std::array<double, 4> values_{};
  std::size_t size_ = 0;
};

}  // namespace delcert::checker_tests
