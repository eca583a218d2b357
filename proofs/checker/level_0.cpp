#include <algorithm>

#include "proofs/checker/grid.hpp"
#include "proofs/checker/levels.hpp"

namespace delcert::checker {
namespace {

/// Every non-zero lattice vector has length >= 24 epsilon; on a Euclidean ball some label is interior.
void check_patch(const Certificate& c, Report& report) {
  if (!c.torus) {
    if (std::find(c.interior.begin(), c.interior.end(), true) != c.interior.end()) return;
    return report.reject("0.patch", [] { return "no label is interior"; });
  }
  const auto shorter = c.metric.lattice_vector_within(Quantity(Rational(24) * c.epsilon.exact), false);
  if (shorter) {
    report.reject("0.patch",
                  [&] { return "the lattice vector " + to_string(*shorter, c.m) + " is shorter than 24 epsilon"; });
  }
}

/// |p_i + lift - p_j| >= mu epsilon for different lifts of the net.
void check_separation(const Certificate& c, Report& report) {
  const Grid grid(c.net);
  const Quantity least(c.mu.exact * c.epsilon.exact);
  for (Label i = 0; i < c.n; ++i) {
    const Vertex base{i, {}};
    const Vector<Interval> centre = c.net.position<Interval>(base);
    grid.visit(centre, least.filter.upper(), [&](const Vertex& q) {
      if (q.label < i || (q.label == i && q.lift == Lift{})) return;
      const auto far = [&]<class N>(In<N>) {
        const N length = c.metric.squared_length(c.net.position<N>(q) - c.net.position<N>(base));
        return less_equal(square(least.as<N>()), length);
      };
      if (decide(far)) return;
      report.reject("0.separation", [&] {
        const Vector<Interval> offset = c.net.position<Interval>(q) - centre;
        return "net points " + std::to_string(i) + " and " + std::to_string(q.label) + " + " + to_string(q.lift, c.m) +
               " have squared distance " + about(c.metric.squared_length(offset)) + ", less than the square of " +
               about(least.filter);
      });
    });
  }
}

/// |p'_i - p_i| <= rho epsilon, at the lifts that are written.
void check_perturbation(const Certificate& c, Report& report) {
  const Quantity largest(c.rho.exact * c.epsilon.exact);
  for (Label i = 0; i < c.n; ++i) {
    const auto near = [&]<class N>(In<N>) {
      const Vector<N> offset = c.points.position<N>({i, {}}) - c.net.position<N>({i, {}});
      return less_equal(c.metric.squared_length(offset), square(largest.as<N>()));
    };
    if (decide(near)) continue;
    report.reject("0.perturbation", [&] {
      return "point " + std::to_string(i) + " is farther than " + about(largest.filter) + " from its net point";
    });
  }
}

/// The parameters are those of Hypotheses 2 at distortion and radius variation 0. Then C rho^-1 Gamma_0 = 1 makes
/// 2 alpha~_0 = 2^17 m^(3/2) rho (mu/2)^e / (m^(3/2) mu^3), e = 4m^2 + 5m + 21, a rational number.
void check_hypotheses_2(const Certificate& c, Report& report) {
  const auto require = [&](bool holds, const char* what) {
    if (!holds) report.reject("0.hypotheses-2", [&] { return what; });
  };
  const Rational root = c.rho.exact * power(c.mu.exact / Rational(2), 4 * c.m * c.m + 5 * c.m + 21);
  const Rational least = Rational(1 << 17) * root / power(c.mu.exact, 3);
  const Rational cubed = power(Rational(c.m), 3);
  require(c.document.mode == "theory", "mode is not theory");
  require(fmpq_equal((c.flake_squared.exact * cubed).raw(), square(root).raw()) != 0,
          "flake_parameter_squared is not (rho / C)^2");
  require(less_equal(least, c.tolerance.exact) == Verdict::proved, "tolerance is less than 2 alpha~_0");
}

}  // namespace

std::string check_level_0(const Certificate& c, Report& report) {
  check_patch(c, report);
  check_separation(c, report);
  check_perturbation(c, report);
  if (c.document.hypotheses_2) check_hypotheses_2(c, report);
  check_cycle(c, report);
  check_density(c, report);
  return std::to_string(c.n) + " points are a (" + about(c.mu.filter) + ", " + about(c.epsilon.filter) +
         ")-net, perturbed by <= " + about(c.rho.filter) + " epsilon" +
         (c.document.hypotheses_2 ? ", Hypotheses 2 hold" : "");
}

}  // namespace delcert::checker
