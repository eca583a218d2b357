#pragma once

#include "kernel/stars/approximate_delaunay.hpp"

namespace delcert {

// What the dimensions of GrowingDelaunay have in common. Each defines its Triangulation, with `add` and `simplices`,
// and instantiates the class.

template <int m>
GrowingDelaunay<m>::GrowingDelaunay() : triangulation_(std::make_unique<Triangulation>()) {}

template <int m>
GrowingDelaunay<m>::~GrowingDelaunay() = default;

template <int m>
void GrowingDelaunay<m>::add(const std::vector<Vector<double, m>>& points) {
  triangulation_->add(points);
}

template <int m>
std::vector<IndexSimplex<m>> GrowingDelaunay<m>::simplices() const {
  return triangulation_->simplices();
}

/// A triangulation that is made anew of all points: for dimensions where one that grows is not worth it.
template <int m>
class RemadeDelaunay {
 public:
  void add(const std::vector<Vector<double, m>>& points) {
    points_.insert(points_.end(), points.begin(), points.end());
  }
  [[nodiscard]] std::vector<IndexSimplex<m>> simplices() const { return approximate_delaunay<m>(points_); }

 private:
  std::vector<Vector<double, m>> points_;
};

}  // namespace delcert
