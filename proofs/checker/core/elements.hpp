#pragma once

#include <map>
#include <memory>
#include <unordered_map>

#include "proofs/checker/core/data.hpp"

namespace delcert::checker::core {

/// An isometry of the space: x -> linear x + shift.
template <class N>
struct Motion {
  SquareMatrix<N> linear{0};
  Vector<N> shift{};
  bool turns = true, shifts = true;

  Vector<N> direction(const Vector<N>& x) const { return turns ? linear * x : x; }
  Vector<N> point(const Vector<N>& x) const { return shifts ? add(direction(x), N(1), shift) : direction(x); }
};

/// The group elements of a certificate, compared exactly: each has one number, the identity 0.
class Elements {
 public:
  using Id = std::uint32_t;

  /// Keeps a reference. Precondition: the generators are isometries, parents and letters in range.
  explicit Elements(const Data& data);

  /// Of element number k of the certificate.
  Id of(std::size_t k) const { return table_[k]; }
  Id find(const FieldMatrix& g);
  Id inverse(Id a);
  /// a^-1 b.
  Id relative(Id a, Id b) { return a == 0 ? b : a == b ? 0 : computed_relative(a, b); }
  Id product(Id a, Id b) { return a == 0 ? b : b == 0 ? a : relative(inverse(a), b); }
  /// The sign of the determinant.
  int orientation(Id a);

  template <class N>
  Vector<N> moved(Id g, const Vector<N>& point) {
    return g == 0 ? point : with_motion<N>(g, [&](const Motion<N>& f) { return f.point(point); });
  }
  template <class N>
  Vector<N> turned(Id g, const Vector<N>& direction) {
    return g == 0 ? direction : with_motion<N>(g, [&](const Motion<N>& f) { return f.direction(direction); });
  }

 private:
  Id computed_relative(Id a, Id b);
  template <class N, class F>
  Vector<N> with_motion(Id g, const F& f) {
    if constexpr (std::is_same_v<N, Interval>) {
      return f(filter(g));
    } else {
      return f(motion<N>(g));
    }
  }
  const Motion<Interval>& filter(Id g);
  template <class N>
  Motion<N> motion(Id g) const;

  static constexpr Id unknown = UINT32_MAX;
  const Data& data_;
  std::vector<Id> table_;
  std::map<FieldMatrix, Id> ids_;
  std::vector<const FieldMatrix*> exact_;  // by number
  std::vector<Id> inverse_;
  std::vector<int> orientation_;
  std::vector<std::unique_ptr<Motion<Interval>>> filter_;
  std::unordered_map<std::uint64_t, Id> relative_;
};

}  // namespace delcert::checker::core
