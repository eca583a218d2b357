#include "proofs/checker/arithmetic/ball.hpp"
#include "proofs/checker/certificate/certificate.hpp"
#include "proofs/checker/report/report.hpp"

namespace delcert::checker {

Rational Certificate::reach_1() const {
  return rho.exact * epsilon.exact + Rational(2) * circumradius.exact + protection.exact;
}

Rational Certificate::reach() const {
  Rational result = claimed[level_1] ? reach_1() : Rational(0);
  if (claimed[level_2s]) result = maximum(result, reach_2s.exact);
  if (claimed[level_0]) result = maximum(result, (mu.exact + rho.exact) * epsilon.exact);
  return result;
}

/// Without the last two no level can be looked at.
void Certificate::require_space_form() const {
  const auto require = [](bool holds, const char* what) { Report::require("form.ranges", holds, what); };
  const auto positive = [](const Quantity& x) { return x.exact.sign() > 0; };
  require(!claimed[level_0] || positive(density), "density is not positive");
  require(transition_distortion.exact.sign() >= 0 && metric_distortion.exact.sign() >= 0, "a distortion is negative");
  require(!claimed[level_2s] || positive(reach_2s), "reach is not positive");
  require(!claimed[level_4] || (empty_margin.exact.sign() >= 0 && positive(ball_radius)),
          "the protection of level 4 is negative or its circumradius not positive");
  require(!riemannian_simplices || (positive(riemannian_thickness) && positive(riemannian_radius)),
          "thickness or radius of level 5 is not positive");
  require(weight.exact.sign() >= 0, "weight is negative");
  require(!claimed[level_6] || (positive(least_stretch) && positive(greatest_stretch)),
          "a bound of bilipschitz is not positive");
  Report::require("form.family", !theory, "the mode theory is not for space forms");
  Report::require("form.family", !claimed[level_6] || !self_delaunay || m == 2, "self_delaunay is for surfaces");
  if (claimed[level_3]) throw Malformed("form.family", "level 3 is not for space forms");
  const bool small = space_form->K <= 0 || decide_with_balls([&] {
                       Ball pi;
                       arb_const_pi(pi.raw(), Ball::precision);
                       return less(Ball(2) * Ball(reach()), pi);
                     });
  if (!small) throw Malformed("form.ranges", "what a chart has to show is not in an open half-sphere");
}

}  // namespace delcert::checker
