#pragma once

#include <vector>

#include "kernel/number/filter.hpp"
#include "kernel/number/rounding_guard.hpp"
#include "kernel/number/strong.hpp"
#include "kernel/simplex/vector.hpp"

namespace delcert {

/// Points known exactly, each in the home patch of its label, with their enclosures for the filter.
template <int m>
class PointSet {
 public:
  PointSet() = default;
  explicit PointSet(std::vector<Vector<Rational, m>> points) : exact_(std::move(points)), enclosure_(exact_.size()) {
    const FilterGuard guard;
    for (std::size_t index = 0; index < exact_.size(); ++index) enclose(index);
  }

  [[nodiscard]] std::size_t size() const { return exact_.size(); }
  [[nodiscard]] const Vector<Rational, m>& exact(Label label) const { return exact_[label.value]; }
  [[nodiscard]] const Vector<Filter, m>& enclosure(Label label) const { return enclosure_[label.value]; }

  /// Precondition: a `FilterGuard` is alive.
  void place(Label label, Vector<Rational, m> point) {
    exact_[label.value] = std::move(point);
    enclose(label.value);
  }

  /// The coordinates on a rung of the ladder.
  template <class S>
  [[nodiscard]] Vector<S, m> coordinates(Label label) const {
    if constexpr (std::same_as<S, Filter>) {
      return enclosure(label);
    } else if constexpr (std::same_as<S, Rational>) {
      return exact(label);
    } else {
      Vector<S, m> result;
      for (std::size_t axis = 0; axis < m; ++axis) result[axis] = scalar_from<S>(exact(label)[axis]);
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
  void enclose(std::size_t index) {
    for (std::size_t axis = 0; axis < m; ++axis) enclosure_[index][axis] = scalar_from<Filter>(exact_[index][axis]);
  }

  std::vector<Vector<Rational, m>> exact_;
  std::vector<Vector<Filter, m>> enclosure_;
};

}  // namespace delcert
