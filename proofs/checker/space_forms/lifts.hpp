#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "proofs/checker/certificate/certificate.hpp"
#include "proofs/checker/core/circumball.hpp"

namespace delcert::checker {

/// A lift of a label: moved by this element.
struct Seen {
  Label label = 0;
  core::Elements::Id element = 0;
};

/// The lifts of the points of a space form, found by walking from neighbour to neighbour (docs/levels/core.md, Lifts
/// near a point). All points are in the coordinates of the core.
class Lifts {
 public:
  /// Keeps references. Precondition: the rules of Theorem C5 hold, and those of Theorem C4 if it is Delaunay. Throws
  /// Undecided for edges of a sphere that are too long.
  Lifts(const Certificate& c, core::Complex& complex, bool is_delaunay);

  bool are_delaunay() const { return is_delaunay_; }
  /// All lifts at distance <= radius of the original point p_i, perhaps some that are a little farther; sorted by
  /// label. Precondition: radius < pi/2 on a sphere.
  std::vector<Seen> around(Label i, const Rational& radius);
  /// All lifts whose chords from a point have squares <= `squared`, perhaps some that are a little longer; none of
  /// those to start from, which the walk goes from. Precondition: it is Delaunay, the point is the circumcentre of a
  /// simplex with those vertices, and squared < 2 on a sphere.
  struct Near {
    Seen seen;
    double chord_squared = 0;  // at least
  };
  std::vector<Near> around_circumcentre(const Vector<Interval>& centre, const std::vector<Seen>& vertices,
                                        double squared);

  template <class N>
  decltype(auto) form() const {
    if constexpr (std::is_same_v<N, Interval>) {
      return (form_);
    } else {
      return core::Form<N>(complex_.data);
    }
  }
  template <class N>
  Vector<N> point(const Seen& seen) const {
    return complex_.elements.moved(seen.element, complex_.point<N>(seen.label));
  }
  /// The same lift of the original point.
  template <class N>
  Vector<N> net_point(const Seen& seen) const {
    Vector<N> x = c_.net.position<N>({seen.label, {}});
    if (c_.space_form->K != 0) x = linear(c_.space_form->K, c_.m_size(), x);
    return complex_.elements.moved(seen.element, x);
  }

 private:
  /// Goes on from a lift to its neighbours if go_on(lift) says so, which is asked once for each lift met.
  template <class F>
  void walk(std::vector<Seen> front, const F& go_on);
  /// Whether the lift has not been met in this walk.
  bool is_new(const Seen& seen);

  const Certificate& c_;
  core::Complex& complex_;
  const core::Form<Interval> form_;
  const bool is_delaunay_;
  double room_ = 0;  // how much farther than the lifts that are asked for the walk about p_i goes
  /// What was asked for last, and the squares of the chords of it and of how far the walk goes.
  struct Reach {
    Rational radius;
    double near = 0, far = 0;
  };
  Reach squared_chords(const Rational& radius) const;
  std::optional<Reach> reach_;
  struct Met {
    std::uint32_t walk = 0;
    core::Elements::Id element = 0;
  };
  std::vector<Met> met_;  // of each label, where it was met last
  std::uint32_t walks_ = 0;
  std::vector<Seen> met_again_;  // in this walk, of labels with several lifts
};

/// The charts of a space form: exp^-1 about the original points, in orthonormal coordinates. In one arithmetic.
template <class N>
class SpaceFormCharts {
 public:
  explicit SpaceFormCharts(const Certificate& c) : c_(&c), K_(c.space_form->K), m_(c.m_size()), frame_(m_) {
    const auto fill = [this] {
      const SquareMatrix<Ball> T = c_->space_form->basis();
      for (std::size_t i = 0; i < m_; ++i) {
        for (std::size_t k = 0; k < m_; ++k) {
          if constexpr (std::is_same_v<N, Interval>) {
            frame_(i, k) = T(i + 1, k + 1).enclosure();
          } else {
            frame_(i, k) = T(i + 1, k + 1);
          }
        }
      }
    };
    if constexpr (std::is_same_v<N, Interval>) {
      in_balls(160, fill);
    } else {
      fill();
    }
  }

  /// Where an original point is: what its chart needs.
  struct Base {
    Vector<N> given, linear;
  };
  Base base(Label i) const {
    Base result{c_->net.position<N>({i, {}}), {}};
    if (K_ != 0) result.linear = linear(K_, m_, result.given);
    return result;
  }
  /// Of a point in the coordinates of the core. Precondition: it is less than pi from the original point.
  Vector<N> place(const Base& base, const Vector<N>& x) const {
    if (K_ == 0) return frame_ * (x - base.given);
    const Vector<N> a = conformal(m_, seen_from(K_, m_, base.given, base.linear, x));
    return add(Vector<N>{}, logarithm_factor(K_, squared(a, m_) / N(4)), a);
  }
  /// What the label's point is moved by in its own chart.
  Vector<N> home(Label i) const {
    const Vector<N> v = c_->points.position<N>({i, {}});
    return K_ == 0 ? frame_ * v : v;
  }

 private:
  const Certificate* c_;
  int K_;
  std::size_t m_;
  SquareMatrix<N> frame_;  // from flat coordinates
};

}  // namespace delcert::checker
