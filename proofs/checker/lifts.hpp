#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "proofs/checker/certificate.hpp"
#include "proofs/checker/curved.hpp"
#include "proofs/checker/group.hpp"

namespace delcert::checker {

/// A lift of a perturbed point near an original one: of label `label`, moved by element number `element`.
struct Seen {
  Label label = 0;
  std::uint32_t element = 0;
  Vector<Interval> conformal{};  // about the original point near which it was found
};

/// The lifts of the perturbed points in the linear model, in the standard basis, in cells.
class Lifts {
 public:
  /// Keeps references. `reach` < pi/2 on a sphere; `spread`: no point is farther from o. Throws Undecided if positions
  /// are not known well enough for cells.
  Lifts(const Certificate& c, const Group& group, const Rational& reach, const Rational& spread);

  /// All lifts at distance <= radius of the original point p_i, perhaps some that are a little farther; sorted by
  /// label. Precondition: radius <= reach.
  std::vector<Seen> around(Label i, const Rational& radius) const;

  /// Conformal coordinates about p_i of the lift, or of that lift of the original point.
  template <class N>
  Vector<N> conformal_about(Label i, const Seen& seen) const {
    if constexpr (std::is_same_v<N, Interval>) {
      return seen.conformal;
    } else {
      return conformal<N>(c_.m_size(), seen_from(K(), c_.m_size(), centre<N>(i), moved(seen, position(seen.label))));
    }
  }
  template <class N>
  Vector<N> net_about(Label i, const Seen& seen) const {
    const Vector<N> x = linear(K(), c_.m_size(), centre<N>(seen.label));
    if constexpr (std::is_same_v<N, Interval>) {
      return conformal<N>(c_.m_size(), seen_from(K(), c_.m_size(), centre<N>(i), elements_[seen.element] * x));
    } else {
      return conformal<N>(c_.m_size(), seen_from(K(), c_.m_size(), centre<N>(i), moved(seen, x)));
    }
  }
  /// v_i in the standard basis: the exponential coordinates of p'_i about p_i.
  template <class N>
  Vector<N> vector_of(Label i) const {
    return in_standard<N>(c_.points.position<N>({i, {}}));
  }

 private:
  int K() const { return c_.space_form->K; }
  /// Conformal coordinates of p_i.
  template <class N>
  Vector<N> centre(Label i) const {
    return in_standard<N>(c_.net.position<N>({i, {}}));
  }
  /// Curved points are given in the standard basis; flat ones in the frame of the lattice.
  template <class N>
  Vector<N> in_standard(const Vector<N>& x) const {
    if (K() != 0) return x;
    if constexpr (std::is_same_v<N, Interval>) {
      return frame_ * x;
    } else {
      const SquareMatrix<Ball> T = c_.space_form->basis();
      Vector<N> y{};
      for (std::size_t i = 0; i < c_.m_size(); ++i) {
        for (std::size_t k = i; k < c_.m_size(); ++k) y[i] = y[i] + T(i + 1, k + 1) * x[k];
      }
      return y;
    }
  }
  /// p'_j in the linear model.
  Vector<Ball> position(Label j) const;
  Vector<Ball> moved(const Seen& seen, const Vector<Ball>& x) const;
  /// Where the distances of a space are at least those of its picture.
  std::array<double, 4> picture(const Vector<Interval>& x) const;

  using Cell = std::array<std::int32_t, 4>;
  struct Stored {
    Cell cell;
    std::uint32_t label, element;
    Vector<Interval> x;
  };
  Cell cell_of(const Vector<Interval>& x) const;

  const Certificate& c_;
  const Group& group_;
  double width_;
  SquareMatrix<Interval> frame_;
  std::vector<SquareMatrix<Interval>> elements_;
  std::vector<Vector<Interval>> centres_;
  std::vector<Stored> stored_;  // sorted by cell
};

}  // namespace delcert::checker
