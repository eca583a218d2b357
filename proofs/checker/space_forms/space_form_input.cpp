#include "proofs/checker/core/chunk_view.hpp"
#include "proofs/checker/levels/levels.hpp"
#include "proofs/checker/parts/parts.hpp"
#include "proofs/checker/space_forms/space_form_levels.hpp"

namespace delcert::checker {

/// Separation of the original points; density by that of the perturbed ones.
std::string check_input_on_space_form(const Certificate& c, Lifts& lifts, Report& report) {
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
  // Of the distance mu epsilon, the square of the chord.
  const auto chord_squared = [&] { return Ball(2) * versed_sine(K, Ball(c.mu.exact * c.epsilon.exact)); };
  const Interval filter = in_balls(128, [&] { return chord_squared().enclosure(); });
  const auto check = [&](std::size_t begin, std::size_t end, Report& found) {
    for (auto i = static_cast<Label>(begin); i < end; ++i) {
      for (const Seen& seen : lifts.around(i, (c.mu.exact + c.rho.exact) * c.epsilon.exact)) {
        // A pair is looked at from its lesser label.
        if (seen.label < i || (seen.label == i && seen.element == 0)) continue;
        const bool apart = decide_enclosed([&]<class N>(In<N>) {
          const N chord = lifts.form<N>().squared(lifts.net_point<N>(seen) - lifts.net_point<N>({i, 0}));
          if constexpr (std::is_same_v<N, Interval>) {
            return less_equal(filter, chord);
          } else {
            return less_equal(chord_squared(), chord);
          }
        });
        if (apart) continue;
        found.reject("0.separation", [&] {
          return "labels " + name_of(i) + " and " + name_of(seen.label) + " are closer than separation epsilon";
        });
      }
    }
    return Counts{};
  };
  in_parts("0.separation", Items::labels, c.n, report, check);
  return std::to_string(c.chunk == nullptr ? c.n : c.chunk->chunks().points()) +
         " points, separation >= " + rounded_down(c.mu.exact * c.epsilon.exact) +
         ", density <= " + rounded_up(c.density.exact) +
         (less(c.density.exact, c.epsilon.exact) == Verdict::proved ? ", below" : ", not below") +
         " the sampling radius, distortion <= " + rounded_up(c.transition_distortion.exact) +
         ", against M <= " + rounded_up(c.metric_distortion.exact);
}

}  // namespace delcert::checker
