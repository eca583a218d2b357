#include <algorithm>

#include "proofs/checker/run.hpp"
#include "proofs/checker/space_form_levels.hpp"

namespace delcert::checker {
namespace {

/// A function of a stated length, in the filter and in balls.
class OfLength {
 public:
  OfLength(Ball (*function)(int, const Ball&), int K, const Quantity& length)
      : function_(function), K_(K), length_(length) {
    filter_ = in_balls(128, [&] { return as<Ball>().enclosure(); });
  }
  template <class N>
  N as() const {
    if constexpr (std::is_same_v<N, Interval>) {
      return filter_;
    } else {
      return function_(K_, length_.as<N>());
    }
  }

 private:
  Ball (*function_)(int, const Ball&);
  int K_;
  const Quantity& length_;
  Interval filter_;
};

class DelaunayChecker {
 public:
  DelaunayChecker(const Certificate& c, Report& report)
      : c_(c),
        report_(report),
        tangent_(tangent, c.space_form->K, c.ball_radius),
        sine_(sine, c.space_form->K, c.empty_margin),
        versed_sine_(versed_sine, c.space_form->K, c.empty_margin) {}

  void check(const Chart& chart, const ChartSimplex& simplex, Label i, const Label* others) {
    ++simplices;
    const std::size_t first = simplex.vertices()[0];
    // tan rho = R/w <= tan r. (With K < 0 this makes the ball one of the hyperbolic space: R < w.)
    const bool small = simplex.decide([&]<class N>(const Simplex<N>& s) {
      const ConformalBall<N> ball(c_, s, chart.position<N>(first));
      return conjunction(less(N(0), ball.weight),
                         less_equal(ball.radius_squared, square(tangent_.as<N>() * ball.weight)));
    });
    if (!small)
      report_.reject("4.ball", [&] { return simplex_of_star(c_, i, others) + " has no circumball so small"; });
    for (std::size_t q = 0; q < chart.size(); ++q) {
      if (simplex.is_vertex(q) ||
          simplex.decide([&]<class N>(const Simplex<N>& s) { return is_outside(chart, s, first, q); }))
        continue;
      report_.reject("4.empty", [&] {
        return simplex_of_star(c_, i, others) + " has label " + std::to_string(chart.label(q)) +
               " within protection of its circumball";
      });
    }
  }
  std::size_t simplices = 0;

 private:
  /// d(C, q) > rho + delta: (|q - c|^2 - R^2) / (2 + 2D) > (1 - cos delta) w + R sin delta.
  template <class N>
  Verdict is_outside(const Chart& chart, const Simplex<N>& s, std::size_t first, std::size_t q) const {
    const Vector<N> x = chart.position<N>(q), v = chart.position<N>(first);
    const ConformalBall<N> ball(c_, s, v);
    const N power = s.power(x - v) / (N(2) + N(2) * bend(c_.space_form->K, c_.m_size(), x));
    return negation(
        at_most_root(power - versed_sine_.as<N>() * ball.weight, ball.radius_squared * square(sine_.as<N>())));
  }

  const Certificate& c_;
  Report& report_;
  OfLength tangent_, sine_, versed_sine_;
};

}  // namespace

std::string for_each_simplex(const Certificate& c, const Lifts& lifts,
                             const std::function<void(const Chart&, const ChartSimplex&, Label, const Label*)>& f) {
  std::string left_out;
  for (Label i = 0; i < c.n; ++i) {
    const Chart chart(c, lifts, i, c.reach_4(), Coordinates::conformal);
    for (std::size_t s = 0; s < c.star_size(i); ++s) {
      const Label* others = c.star_simplex(i, s);
      if (*std::min_element(others, others + c.m) < i) continue;
      Label missing = 0;
      std::vector<std::size_t> vertices = chart.find(i, others, missing);
      if (vertices.empty()) {
        left_out = simplex_of_star(c, i, others) + " has no lift of " + std::to_string(missing) + " in reach";
      } else {
        f(chart, ChartSimplex(c, chart, std::move(vertices)), i, others);
      }
    }
  }
  return left_out;
}

std::string check_delaunay_on_space_form(const Certificate& c, const Lifts& lifts, Report& report) {
  if (less(c.reach_4(), c.space_form->injectivity_radius.exact) != Verdict::proved) {
    report.reject("4.lifts",
                  [] { return "perturbation + 2 circumradius + protection is not below the injectivity radius"; });
  }
  DelaunayChecker checker(c, report);
  const auto check = [&](const Chart& chart, const ChartSimplex& simplex, Label i, const Label* others) {
    checker.check(chart, simplex, i, others);
  };
  const std::string left_out = for_each_simplex(c, lifts, check);
  if (!left_out.empty()) report.reject("4.lifts", [&] { return left_out; });
  return std::to_string(checker.simplices) + " empty circumballs, radius <= " + rounded_up(c.ball_radius.exact) +
         ", all other points farther than " + rounded_down(c.empty_margin.exact);
}

/// Separation of the original points; density by that of the perturbed ones.
std::string check_input_on_space_form(const Certificate& c, const Lifts& lifts, Report& report) {
  const int K = c.space_form->K;
  const Rational twelve = Rational(12) * c.epsilon.exact;
  const bool fits = K <= 0 || decide_with_balls([&] {
                      Ball pi;
                      arb_const_pi(pi.raw(), Ball::precision);
                      return less(Ball(18) * c.epsilon.as<Ball>(), pi);
                    });
  if (less(c.space_form->injectivity_radius.exact, twelve) == Verdict::proved || !fits) {
    report.reject("0.patch", [] {
      return "12 epsilon is not at most the injectivity radius, or 9 epsilon not below a quarter of a great circle";
    });
  }
  if (less(c.density.exact, c.ball_radius.exact + c.rho.exact * c.epsilon.exact) == Verdict::proved)
    report.reject("0.density", [] { return "density is less than circumradius + perturbation epsilon"; });
  check_distortion(c, report);
  for (Label i = 0; i < c.n; ++i) {
    for (const Seen& seen : lifts.around(i, (c.mu.exact + c.rho.exact) * c.epsilon.exact)) {
      if (seen.label == i && seen.element == 0) continue;
      const bool apart = decide_enclosed([&]<class N>(In<N>) {
        return less_equal(square(c.mu.as<N>() * c.epsilon.as<N>()),
                          squared_distance(K, c.m_size(), Vector<N>{}, lifts.net_about<N>(i, seen)));
      });
      if (apart) continue;
      report.reject("0.separation", [&] {
        return "labels " + std::to_string(i) + " and " + std::to_string(seen.label) +
               " are closer than separation epsilon";
      });
    }
  }
  return std::to_string(c.n) + " points, separation >= " + rounded_down(c.mu.exact * c.epsilon.exact) +
         ", density <= " + rounded_up(c.density.exact) +
         (less(c.density.exact, c.epsilon.exact) == Verdict::proved ? ", below" : ", not below") +
         " the sampling radius, distortion <= " + rounded_up(c.transition_distortion.exact) +
         ", against M <= " + rounded_up(c.metric_distortion.exact);
}

}  // namespace delcert::checker
