#pragma once

#include <cstddef>
#include <vector>

namespace delcert {

/// Runs through the subsets of {0 … count−1} with `size` elements, each in increasing order, in lexicographic order:
/// the (size−1)-faces of a simplex with `count` vertices.
class Faces {
 public:
  /// Precondition: 1 ≤ size ≤ count.
  Faces(std::size_t count, std::size_t size) : count_(count) {
    for (std::size_t i = 0; i < size; ++i) vertices_.push_back(i);
  }

  [[nodiscard]] bool has_face() const { return !vertices_.empty(); }
  /// Precondition: has_face().
  [[nodiscard]] const std::vector<std::size_t>& vertices() const { return vertices_; }
  void advance() {
    std::size_t position = vertices_.size();
    while (position > 0 && vertices_[position - 1] == count_ - vertices_.size() + position - 1) --position;
    if (position == 0) {
      vertices_.clear();
      return;
    }
    ++vertices_[position - 1];
    for (std::size_t i = position; i < vertices_.size(); ++i) vertices_[i] = vertices_[i - 1] + 1;
  }

 private:
  std::size_t count_;
  std::vector<std::size_t> vertices_;
};

}  // namespace delcert
