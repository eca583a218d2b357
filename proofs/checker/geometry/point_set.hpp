#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "proofs/checker/arithmetic/exact_number.hpp"
#include "proofs/checker/geometry/metric.hpp"
#include "proofs/checker/report/report.hpp"

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
  /// `coordinates` has m exact numbers for each point, `read` their enclosures, as far as read_enclosures has them.
  /// Keeps references to the metric and the coordinates.
  PointSet(const Metric& metric, bool periodic, const std::vector<std::string_view>& coordinates,
           std::vector<Interval> read);
  PointSet(const Metric& metric, bool periodic, const std::vector<std::string_view>& coordinates)
      : PointSet(metric, periodic, coordinates, read_enclosures(coordinates)) {}

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
    result.reserve(vertices.size());
    for (const Vertex& v : vertices) result.push_back(position<N>(v));
    return result;
  }
  /// The squared distance.
  template <class N>
  N between(const Vertex& v, const Vertex& w) const {
    return metric_->squared_length(position<N>(w) - position<N>(v));
  }

  /// Calls f(lift) for the lifts of the label at distance <= a (closed) or < a from v.
  template <class F>
  void for_lifts_within(const Vertex& v, Label label, const Quantity& a, bool closed, const F& f) const;
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

template <class F>
void PointSet::for_lifts_within(const Vertex& v, Label label, const Quantity& a, bool closed, const F& f) const {
  const Vector<Interval> offset = position<Interval>({label, {}}) - position<Interval>(v);
  std::array<Lift, 2> range{};  // first and last
  double number = 1;
  for (std::size_t k = 0; periodic_ && k < dimension_; ++k) {
    const double reach = a.filter.upper() * metric_->stretch(k);
    const Interval box = Interval::between(-reach, reach) - offset[k];
    const double first = std::ceil(box.lower()), last = std::floor(box.upper());
    if (first > last) return;
    number *= last - first + 1;
    if (!(number <= 1e7 && first > -0x1p30 && last < 0x1p30)) throw Undecided("too many lifts to look at");
    Budget::spend(static_cast<std::uint64_t>(number));
    range[0][k] = static_cast<std::int32_t>(first);
    range[1][k] = static_cast<std::int32_t>(last);
  }
  Lift lift;
  for (lift[3] = range[0][3]; lift[3] <= range[1][3]; ++lift[3]) {
    for (lift[2] = range[0][2]; lift[2] <= range[1][2]; ++lift[2]) {
      for (lift[1] = range[0][1]; lift[1] <= range[1][1]; ++lift[1]) {
        for (lift[0] = range[0][0]; lift[0] <= range[1][0]; ++lift[0]) {
          const auto within = [&]<class N>(In<N>) {
            const N squared = between<N>(v, {label, lift}), bound = square(a.as<N>());
            return closed ? less_equal(squared, bound) : less(squared, bound);
          };
          if (decide(within)) f(lift);
        }
      }
    }
  }
}

}  // namespace delcert::checker
