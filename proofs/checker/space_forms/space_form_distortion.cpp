#include <vector>

#include "proofs/checker/space_forms/space_form_levels.hpp"

// Transitions between charts, and charts against the space: docs/distortion.md. All in balls.

namespace delcert::checker {
namespace {

constexpr int most_boxes = 20000;

/// sin a / a, 1, sinh a / a; 1 at a = 0. Precondition: a >= 0.
Ball ratio(int K, const Rational& a) { return a.sign() == 0 ? Ball(1) : sine(K, Ball(a)) / Ball(a); }

/// 4 sin^2(x/2), 4 sinh^2(x/2).
Ball squared_chord_of(int K, const Rational& x) { return Ball(2) * versed_sine(K, Ball(x)); }

/// The points at distances a and b from the centres of two charts.
struct Box {
  Rational a0, a1, b0, b1;
};

/// Whether no transition between charts with centres at a distance of at most d stretches vectors by more than a
/// factor, at the points of a box; undecided if the box is too large to tell.
class Stretch {
 public:
  Stretch(int K, const Rational& d, const Ball& factor)
      : K_(K), d_(d), squared_chord_(squared_chord_of(K, d)), squared_factor_(square(factor)) {}

  Verdict is_bounded(const Box& box) const {
    const Rational apart = maximum(maximum(box.a0 - box.b1, box.b0 - box.a1), Rational(0));
    if (less(d_, apart) == Verdict::proved) return Verdict::proved;
    // The greatest of each in the box.
    const Ball G = square(ratio(K_, K_ > 0 ? box.a0 : box.a1)),
               H = Ball(1) / square(ratio(K_, K_ > 0 ? box.b1 : box.b0));
    const Ball bent = squared_sine(box.a0, box.b0, apart) * maximum((G - Ball(1)) * (Ball(1) - H), Ball(0));
    // Both roots of x^2 - (1 + GH + bent) x + GH, the squares of the singular values, are at most the squared factor.
    const Ball room = (squared_factor_ - Ball(1)) * (squared_factor_ - G * H);
    return conjunction(less_equal(G * H, squared_factor_), less_equal(squared_factor_ * bent, room));
  }

 private:
  /// sin^2 of the angle at points at least a and b from the centres that differ by at least `apart`, at most.
  Ball squared_sine(const Rational& a, const Rational& b, const Rational& apart) const {
    if (a.sign() == 0 || b.sign() == 0) return Ball(1);
    const Ball sides = Ball(4) * sine(K_, Ball(a)) * sine(K_, Ball(b));
    const Ball half = maximum((squared_chord_ - squared_chord_of(K_, apart)) / sides, Ball(0));
    if (less(half, Ball(1) / Ball(2)) != Verdict::proved) return Ball(1);
    return Ball(4) * half * (Ball(1) - half);
  }

  int K_;
  Rational d_;
  Ball squared_chord_, squared_factor_;
};

/// Divides the box until every part is decided.
bool is_bounded_on(const Stretch& stretch, const Box& all) {
  std::vector<Box> boxes{all};
  for (int looked_at = 0; !boxes.empty(); ++looked_at) {
    Budget::spend(2000);
    if (looked_at == most_boxes) throw Undecided("whether distortion bounds that of all transitions");
    const Box box = boxes.back();
    boxes.pop_back();
    if (stretch.is_bounded(box) == Verdict::proved) continue;
    const Rational a = (box.a0 + box.a1) / Rational(2), b = (box.b0 + box.b1) / Rational(2);
    for (const auto& [a0, a1] : {std::pair(box.a0, a), std::pair(a, box.a1)}) {
      boxes.push_back({a0, a1, box.b0, b});
      boxes.push_back({a0, a1, b, box.b1});
    }
  }
  return true;
}

/// Every transition between patches of radius 9 epsilon with centres at most 6 epsilon apart changes distances by
/// `distortion`, relatively, or less.
bool bounds_transitions(int K, const Rational& epsilon, const Rational& distortion) {
  const Rational R = Rational(9) * epsilon, d = Rational(6) * epsilon;
  const Ball factor = Ball(1) + Ball(distortion), near = ratio(K, R - d), far = ratio(K, R);
  // So much it is between the two centres' line and the rim of a patch, and never more than that of both charts.
  if (less(factor, K > 0 ? near / far : far / near) == Verdict::proved) return false;
  if (less_equal(K > 0 ? Ball(1) / far : far, factor) == Verdict::proved) return true;
  // Segments of a chart between points of both patches stay within R, and within B of the other centre.
  const Rational rest = Rational(1) - R * R / Rational(6);
  if ((K > 0 && less(Rational(6) / Rational(5), R) == Verdict::proved) || rest.sign() <= 0) return false;
  const Rational B = K > 0 ? R : R / rest;
  return is_bounded_on(Stretch(K, d, factor), {Rational(0), R, Rational(0), B});
}

void check_distortion_by_balls(const Certificate& c, Report& report) {
  const int K = c.space_form->K;
  const Rational& epsilon = c.epsilon.exact;
  Ball pi;
  arb_const_pi(pi.raw(), Ball::precision);
  if (K > 0 && less(Ball(Rational(18) * epsilon), pi) != Verdict::proved) return;  // 0.patch
  if (!bounds_transitions(K, epsilon, c.transition_distortion.exact)) {
    report.reject("0.distortion", [] { return "distortion is no bound of what transitions do to distances"; });
  }
  const Ball at_rim = ratio(K, Rational(6) * epsilon);
  const Ball eta = K > 0 ? Ball(1) - at_rim : at_rim - Ball(1);
  if (less_equal(eta, Ball(c.metric_distortion.exact)) != Verdict::proved) {
    report.reject("0.metric-distortion", [] { return "metric_distortion is no bound of what charts do to distances"; });
  }
}

}  // namespace

void check_distortion(const Certificate& c, Report& report) {
  if (c.space_form->K != 0) in_balls(128, [&] { check_distortion_by_balls(c, report); });
}

}  // namespace delcert::checker
