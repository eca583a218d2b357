#include <algorithm>

#include "proofs/checker/grid.hpp"
#include "proofs/checker/run.hpp"

namespace delcert::checker {
namespace {

/// Every non-zero lattice vector has length >= 24 epsilon; on a Euclidean ball some label is interior.
void check_patch_size(const Certificate& c, Report& report) {
  if (std::find(c.interior.begin(), c.interior.end(), true) == c.interior.end()) {
    report.reject("0.patch", [] { return "no label is interior"; });
  }
  const Lift shorter = c.net.lattice_vector_within(Quantity(Rational(24) * c.epsilon.exact), false);
  if (shorter == Lift{}) return;
  report.reject("0.patch", [&] {
    return "label " + to_string({0, shorter}, c.m) + " is at distance < 24 epsilon from label 0";
  });
}

/// |p_i + lift - p_j| >= mu epsilon for different lifts of the net.
void check_separation(const Certificate& c, Report& report) {
  const Grid grid(c.net);
  const Quantity least(c.mu.exact * c.epsilon.exact);
  for (Label i = 0; i < c.n; ++i) {
    const Vertex base{i, {}};
    grid.visit(c.net.position<Interval>(base), least.filter.upper(), [&](const Vertex& q) {
      if (q.label < i || q == base) return;
      if (decide([&]<class N>(In<N>) { return less_equal(square(least.as<N>()), c.net.between<N>(base, q)); })) return;
      report.reject("0.separation", [&] {
        return "net points " + std::to_string(i) + " and " + to_string(q, c.m) + " have a squared distance of about " +
               about(c.net.between<Interval>(base, q)) + ", less than the square of " + rounded_up(least.exact);
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
      return "point " + std::to_string(i) + " is farther than " + rounded_up(largest.exact) + " from its net point";
    });
  }
}

/// The parameters are those of Hypotheses 2 at distortion and radius variation 0. With e = 4m^2 + 5m + 21 they say
/// m^3 Gamma_0^2 = (rho (mu/2)^e)^2, so that m^(3/2) drops out of 2 alpha~_0 = 2^17 m^(3/2) Gamma_0 / mu^3.
void check_hypotheses_2(const Certificate& c, Report& report) {
  const auto require = [&](bool holds, const char* what) {
    if (!holds) report.reject("0.hypotheses-2", [&] { return what; });
  };
  const Rational root = c.rho.exact * power(c.mu.exact / Rational(2), 4 * c.m * c.m + 5 * c.m + 21);
  const Rational least = Rational(1 << 17) * root / power(c.mu.exact, 3);
  require(c.theory, "mode is not theory");
  require(power(Rational(c.m), 3) * c.flake_squared.exact == square(root), "flake_parameter_squared is not (rho/C)^2");
  require(less_equal(least, c.tolerance.exact) == Verdict::proved, "tolerance is less than 2 alpha~_0");
}

}  // namespace

std::string check_level_0(const Certificate& c, Report& report) {
  check_patch_size(c, report);
  if (!report.findings.empty()) return "";  // of lifts there may be any number
  check_separation(c, report);
  check_perturbation(c, report);
  if (c.hypotheses_2) check_hypotheses_2(c, report);
  check_cycle(c, report);
  check_density(c, report);
  return std::to_string(c.n) + " points, sampling radius " + rounded_up(c.epsilon.exact) +
         ", separation >= " + rounded_down(c.mu.exact) + ", perturbation <= " + rounded_up(c.rho.exact) +
         (c.hypotheses_2 ? ", Hypotheses 1 and 2" : ", Hypotheses 1");
}

}  // namespace delcert::checker
