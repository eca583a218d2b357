#pragma once

#include <vector>

#include "proofs/checker/certificate.hpp"
#include "proofs/checker/core/complex.hpp"

namespace delcert::checker {

/// A lift of a perturbed point near an original one: of label `label`, moved by this element.
struct Seen {
  Label label = 0;
  core::Elements::Id element = 0;
  Vector<Interval> conformal{};  // about the original point near which it was found
};

/// The lifts of the points of a space form, found by walking from neighbour to neighbour (docs/levels/core.md, Lifts
/// near a point).
class Lifts {
 public:
  /// Keeps references. Precondition: the rules of Theorem C5 hold, and those of Theorem C4 if it is Delaunay. Throws
  /// Undecided for edges of a sphere that are too long.
  Lifts(const Certificate& c, core::Complex& complex, bool is_delaunay);

  /// All lifts at distance <= radius of the original point p_i, perhaps some that are a little farther; sorted by
  /// label. Precondition: radius < pi/2 on a sphere.
  std::vector<Seen> around(Label i, const Rational& radius) const;

  /// Conformal coordinates about p_i of the lift, or of that lift of the original point.
  template <class N>
  Vector<N> conformal_about(Label i, const Seen& seen) const {
    if constexpr (std::is_same_v<N, Interval>) {
      return seen.conformal;
    } else {
      return conformal<N>(m(), about(i, seen.element, complex_.point<N>(seen.label)));
    }
  }
  template <class N>
  Vector<N> net_about(Label i, const Seen& seen) const {
    Vector<N> x = c_.net.position<N>({seen.label, {}});
    if (K() != 0) x = linear(K(), m(), x);
    return conformal<N>(m(), about(i, seen.element, x));
  }
  /// v_i in the standard basis: the exponential coordinates of p'_i about p_i.
  template <class N>
  Vector<N> vector_of(Label i) const {
    return in_standard<N>(c_.points.position<N>({i, {}}));
  }

 private:
  int K() const { return c_.space_form->K; }
  std::size_t m() const { return c_.m_size(); }
  /// The image of x, a point in the coordinates of the core, in the linear model with p_i at o.
  template <class N>
  Vector<N> about(Label i, core::Elements::Id element, const Vector<N>& x) const {
    const Vector<N> y = complex_.elements.moved(element, x), p = c_.net.position<N>({i, {}});
    if (K() != 0) return seen_from(K(), m(), p, y);
    const Vector<N> z = in_standard<N>(y - p);
    Vector<N> result{N(1)};
    for (std::size_t k = 0; k < m(); ++k) result[k + 1] = z[k];
    return result;
  }
  /// Curved points are given in the standard basis; flat ones in the frame of the lattice.
  template <class N>
  Vector<N> in_standard(const Vector<N>& x) const {
    if (K() != 0) return x;
    if constexpr (std::is_same_v<N, Interval>) {
      return frame_ * x;
    } else {
      const SquareMatrix<Ball> T = c_.space_form->basis();
      Vector<Ball> y{};
      for (std::size_t i = 0; i < m(); ++i) {
        for (std::size_t k = i; k < m(); ++k) y[i] = y[i] + T(i + 1, k + 1) * x[k];
      }
      return y;
    }
  }

  const Certificate& c_;
  core::Complex& complex_;
  SquareMatrix<Interval> frame_;
  double room_ = 0;  // how much farther than the lifts that are asked for the walk goes
};

}  // namespace delcert::checker
