#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "kernel/number/filter.hpp"
#include "kernel/number/rounding_guard.hpp"
#include "kernel/number/strong.hpp"
#include "kernel/simplex/vector.hpp"

namespace delcert {

/// Points known exactly, each in the home patch of its label, with their enclosures for the filter. Of a point whose
/// coordinates are doubles nothing else is kept: a rational number takes several times as much memory.
template <int m>
class PointSet {
 public:
  PointSet() = default;
  explicit PointSet(std::vector<Vector<Rational, m>> points) : enclosure_(points.size()), apart_(points.size()) {
    const FilterGuard guard;
    for (std::size_t index = 0; index < points.size(); ++index) keep(index, std::move(points[index]));
  }

  [[nodiscard]] std::size_t size() const { return enclosure_.size(); }
  [[nodiscard]] Vector<Rational, m> exact(Label label) const {
    if (const Exact* apart = apart_[label.value].get()) return *apart;
    Exact result;
    for (std::size_t axis = 0; axis < m; ++axis)
      result[axis] = Rational::exactly(enclosure_[label.value][axis].lower());
    return result;
  }
  [[nodiscard]] const Vector<Filter, m>& enclosure(Label label) const { return enclosure_[label.value]; }

  /// Precondition: a `FilterGuard` is alive.
  void place(Label label, Vector<Rational, m> point) { keep(label.value, std::move(point)); }

  /// The coordinates on a rung of the ladder.
  template <class S>
  [[nodiscard]] Vector<S, m> coordinates(Label label) const {
    if constexpr (std::same_as<S, Filter>) {
      return enclosure(label);
    } else if constexpr (std::same_as<S, Rational>) {
      return exact(label);
    } else {
      const Exact point = exact(label);
      Vector<S, m> result;
      for (std::size_t axis = 0; axis < m; ++axis) result[axis] = scalar_from<S>(point[axis]);
      return result;
    }
  }

  /// Within 2⁻⁵² relative of the exact coordinates.
  [[nodiscard]] Vector<double, m> approximate(Label label) const {
    Vector<double, m> result;
    for (std::size_t axis = 0; axis < m; ++axis) result[axis] = enclosure_[label.value][axis].lower();
    return result;
  }
  [[nodiscard]] std::vector<Vector<double, m>> approximate_all() const {
    std::vector<Vector<double, m>> result;
    result.reserve(size());
    for (std::uint32_t index = 0; index < size(); ++index) result.push_back(approximate(Label(index)));
    return result;
  }

 private:
  using Exact = Vector<Rational, m>;

  /// What is there at most once, and copied with what has it.
  class Apart {
   public:
    Apart() = default;
    explicit Apart(Exact point) : point_(std::make_unique<const Exact>(std::move(point))) {}
    Apart(const Apart& other) : point_(other.point_ ? std::make_unique<const Exact>(*other.point_) : nullptr) {}
    Apart(Apart&&) noexcept = default;
    Apart& operator=(const Apart& other) { return *this = Apart(other); }
    Apart& operator=(Apart&&) noexcept = default;
    ~Apart() = default;
    [[nodiscard]] const Exact* get() const { return point_.get(); }

   private:
    std::unique_ptr<const Exact> point_;
  };

  void keep(std::size_t index, Exact point) {
    bool are_doubles = true;
    for (std::size_t axis = 0; axis < m; ++axis) {
      const Filter enclosure = scalar_from<Filter>(point[axis]);
      enclosure_[index][axis] = enclosure;
      are_doubles = are_doubles && is_exactly(enclosure, point[axis]);
    }
    apart_[index] = are_doubles ? Apart() : Apart(std::move(point));
  }
  static bool is_exactly(const Filter& enclosure, const Rational& x) {
    return filter_is_rigorous ? enclosure.lower() == enclosure.upper() : Rational::exactly(enclosure.lower()) == x;
  }

  std::vector<Vector<Filter, m>> enclosure_;
  std::vector<Apart> apart_;  // the points that have other coordinates than doubles
};

}  // namespace delcert
