#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "proofs/checker/exact_number.hpp"
#include "proofs/checker/metric.hpp"

namespace delcert::checker {

using Label = std::uint32_t;
using Lift = std::array<std::int32_t, 4>;

/// A label at one of its lifts: at its point + lift.
struct Vertex {
  Label label = 0;
  Lift lift{};
  friend auto operator<=>(const Vertex&, const Vertex&) = default;
};
using Vertices = std::vector<Vertex>;

/// "17 + (0, -1)".
std::string to_string(const Vertex& v, int dimension);

/// Finitely many points of a frame and, on a flat torus, all their lifts. On a Euclidean ball only the lift 0 occurs.
class PointSet {
 public:
  PointSet() = default;
  /// `coordinates` has m exact numbers for each point. Keeps references to both.
  PointSet(const Metric& metric, bool periodic, const std::vector<std::string_view>& coordinates);

  const Metric& metric() const { return *metric_; }
  bool periodic() const { return periodic_; }
  Label size() const { return static_cast<Label>(filter_.size() / dimension_); }

  template <class N>
  Vector<N> position(const Vertex& v) const {
    Vector<N> x{};
    for (std::size_t k = 0; k < dimension_; ++k) {
      if constexpr (std::is_same_v<N, Interval>) {
        x[k] = filter_[v.label * dimension_ + k] + N(v.lift[k]);
      } else {
        x[k] = N(exact_value((*coordinates_)[v.label * dimension_ + k])) + N(v.lift[k]);
      }
    }
    return x;
  }
  template <class N>
  std::vector<Vector<N>> positions(const Vertices& vertices) const {
    std::vector<Vector<N>> result;
    for (const Vertex& v : vertices) result.push_back(position<N>(v));
    return result;
  }
  /// The squared distance.
  template <class N>
  N between(const Vertex& v, const Vertex& w) const {
    return metric_->squared_length(position<N>(w) - position<N>(v));
  }

  /// The lifts of the label at distance <= a (closed) or < a from v.
  std::vector<Lift> lifts_within(const Vertex& v, Label label, const Quantity& a, bool closed) const;
  /// A lattice vector other than 0 of length <= a (closed) or < a, or 0 if there is none.
  Lift lattice_vector_within(const Quantity& a, bool closed) const;

 private:
  const Metric* metric_ = nullptr;
  const std::vector<std::string_view>* coordinates_ = nullptr;
  bool periodic_ = false;
  std::size_t dimension_ = 1;
  std::vector<Interval> filter_;
};

}  // namespace delcert::checker
