#pragma once

#include <string_view>
#include <vector>

#include "proofs/checker/document.hpp"
#include "proofs/checker/exact_number.hpp"
#include "proofs/checker/metric.hpp"

namespace delcert::checker {

/// A label at one of its lifts.
struct Vertex {
  Label label = 0;
  Lift lift{};
};

/// Finitely many points of a frame and, on a flat torus, all their lifts.
class PointSet {
 public:
  /// `coordinates` has m exact numbers for each point.
  PointSet(const Metric& metric, bool periodic, const std::vector<std::string_view>& coordinates);

  const Metric& metric() const { return *metric_; }
  int dimension() const { return metric_->dimension(); }
  bool periodic() const { return periodic_; }
  Label size() const { return static_cast<Label>(filter_.size() / dimension_); }

  template <class N>
  Vector<N> position(const Vertex& v) const {
    Vector<N> x{};
    for (std::size_t k = 0; k < dimension_; ++k) {
      if constexpr (std::is_same_v<N, Interval>) {
        x[k] = filter_[v.label * dimension_ + k] + N(v.lift[k]);
      } else {
        x[k] = exact_value((*coordinates_)[v.label * dimension_ + k]) + N(v.lift[k]);
      }
    }
    return x;
  }
  template <class N>
  std::vector<Vector<N>> positions(const std::vector<Vertex>& vertices) const {
    std::vector<Vector<N>> result;
    for (const Vertex& v : vertices) result.push_back(position<N>(v));
    return result;
  }

  /// The lifts of the label at distance <= a (closed) or < a from v.
  std::vector<Lift> lifts_within(const Vertex& v, Label label, const Quantity& a, bool closed) const;

 private:
  const Metric* metric_;
  const std::vector<std::string_view>* coordinates_;
  bool periodic_;
  std::size_t dimension_;
  std::vector<Interval> filter_;
};

template <class N>
Vector<N> operator-(const Vector<N>& x, const Vector<N>& y) {
  Vector<N> result{};
  for (std::size_t k = 0; k < result.size(); ++k) result[k] = x[k] - y[k];
  return result;
}

}  // namespace delcert::checker
