#include <algorithm>
#include <optional>

#include "proofs/checker/geometry/grid.hpp"
#include "proofs/checker/levels/levels.hpp"
#include "proofs/checker/parts/parts.hpp"

namespace delcert::checker {
namespace {

/// Patches have a radius of 9 (1 + epsilon_0) epsilon_i. Every non-zero lattice vector has length >= 2 (9 (1 +
/// epsilon_0)) epsilon + 6 epsilon; on a Euclidean ball some label is interior.
void check_patch_size(const Certificate& c, Report& report) {
  if (std::find(c.interior.begin(), c.interior.end(), true) == c.interior.end()) {
    report.reject("0.patch", [] { return "no label is interior"; });
  }
  const Rational factor = Rational(18) * c.radius_factor().exact + Rational(6);
  const Lift shorter = c.net.lattice_vector_within(Quantity(factor * c.epsilon.exact), false);
  if (shorter == Lift{}) return;
  report.reject("0.patch", [&] {
    return "label " + to_string({0, shorter}, c.m) +
           " is at distance < (24 + 18 radius_variation) epsilon from label 0";
  });
}

/// Calls check(i, report) for every label; `least` as for in_parts.
template <class Check>
void for_labels(const char* rule, const Certificate& c, std::size_t least, Report& report, const Check& check) {
  const auto check_all = [&](std::size_t begin, std::size_t end, Report& found) {
    for (auto i = static_cast<Label>(begin); i < end; ++i) check(i, found);
    return Counts{};
  };
  in_parts(rule, c.n, report, check_all, {}, least);
}

/// Of lifts of the net closer than 9 (1 + epsilon_0) times the greater radius, that is at most 1 + epsilon_0 times the
/// lesser one.
void check_radii(const Certificate& c, Report& report) {
  const Grid grid(c.net);
  const Quantity factor = c.radius_factor();
  for_labels("0.radii", c, 64, report, [&](Label i, Report& found) {
    const Vertex base{i, {}};
    const Quantity reach = c.at(i, Quantity(Rational(9) * factor.exact * c.epsilon.exact));
    const Quantity& own = c.units[i];
    grid.visit(c.net.position<Interval>(base), reach.filter.upper(), [&](const Vertex& q) {
      const Quantity& other = c.units[q.label];
      if (decide([&]<class N>(In<N>) { return less_equal(own.as<N>(), factor.as<N>() * other.as<N>()); })) return;
      if (!decide([&]<class N>(In<N>) { return less(c.net.between<N>(base, q), square(reach.as<N>())); })) return;
      found.reject("0.radii", [&] {
        return "the radius of label " + std::to_string(i) + " is more than 1 + radius_variation times that of " +
               to_string(q, c.m);
      });
    });
  });
}

/// |p_i + lift - p_j| >= mu (1 + epsilon_0) times the lesser radius for different lifts of the net.
void check_separation(const Certificate& c, Report& report) {
  const Grid grid(c.net);
  const Quantity apart(c.mu.exact * c.radius_factor().exact * c.epsilon.exact);
  for_labels("0.separation", c, 1U << 12, report, [&](Label i, Report& found) {
    const Vertex base{i, {}};
    const Quantity farthest = c.at(i, apart);
    grid.visit(c.net.position<Interval>(base), farthest.filter.upper(), [&](const Vertex& q) {
      if (q.label < i || q == base) return;
      const std::array<Label, 2> both{i, q.label};
      Quantity memory;
      const Quantity& least = c.at_least(both.data(), both.data() + 2, apart, memory);
      if (decide([&]<class N>(In<N>) { return less_equal(square(least.as<N>()), c.net.between<N>(base, q)); })) return;
      found.reject("0.separation", [&] {
        return "net points " + std::to_string(i) + " and " + to_string(q, c.m) + " have a squared distance of about " +
               about(c.net.between<Interval>(base, q)) + ", less than the square of " + rounded_up(least.exact);
      });
    });
  });
}

/// |p'_i - p_i| <= rho epsilon_i, at the lifts that are written; (1 + epsilon_0) rho <= mu/4.
void check_perturbation(const Certificate& c, Report& report) {
  if (!c.units.empty() && less(c.mu.exact, Rational(4) * c.radius_factor().exact * c.rho.exact) == Verdict::proved)
    report.reject("0.perturbation", [] { return "(1 + radius_variation) perturbation exceeds separation/4"; });
  const Quantity shift(c.rho.exact * c.epsilon.exact);
  for_labels("0.perturbation", c, 1U << 16, report, [&](Label i, Report& found) {
    const Quantity largest = c.at(i, shift);
    const auto near = [&]<class N>(In<N>) {
      const Vector<N> offset = c.points.position<N>({i, {}}) - c.net.position<N>({i, {}});
      return less_equal(c.metric.squared_length(offset), square(largest.as<N>()));
    };
    if (decide(near)) return;
    found.reject("0.perturbation", [&] {
      return "point " + std::to_string(i) + " is farther than " + rounded_up(largest.exact) + " from its net point";
    });
  });
}

/// The parameters are those of Hypotheses 2 at distortion 0; 0.perturbation has another part of them. With e = 4m^2 +
/// 5m + 21 they say m^3 Gamma_0^2 = (rho (mu/2)^e)^2, so that m^(3/2) drops out of 2 alpha~_0 = 2^17 m^(3/2) Gamma_0 /
/// mu^3. The sharper ones: Gamma_0 = rho (mu/2)^e and alpha~_0 = 17410 Gamma_0/mu^3.
void check_hypotheses_2(const Certificate& c, Report& report) {
  const auto require = [&](bool holds, const char* what) {
    if (!holds) report.reject("0.hypotheses-2", [&] { return what; });
  };
  const Rational root = c.rho.exact * power(c.mu.exact / Rational(2), 4 * c.m * c.m + 5 * c.m + 21);
  const Rational least = Rational(2 * (c.sharper ? 17410 : 1 << 16)) * root / power(c.mu.exact, 3);
  const Rational cubed_dimension = c.sharper ? Rational(1) : power(Rational(c.m), 3);
  require(c.theory, "mode is not theory");
  require(less_equal(c.radius_variation.exact, Rational(1)) == Verdict::proved, "radius_variation exceeds 1");
  require(cubed_dimension * c.flake_squared.exact == square(root), "flake_parameter_squared is not (rho/C)^2");
  require(less_equal(least, c.tolerance.exact) == Verdict::proved, "tolerance is less than 2 alpha~_0");
}

}  // namespace

std::string check_level_0(const Certificate& c, Report& report) {
  check_patch_size(c, report);
  if (!report.findings.empty()) return "";  // of lifts there may be any number
  if (!c.units.empty()) check_radii(c, report);
  check_separation(c, report);
  check_perturbation(c, report);
  if (c.hypotheses_2) check_hypotheses_2(c, report);
  std::optional<Elsewhere> degree;
  if (most_parts > 1 && own_share.number == 1) {
    degree.emplace([&c](Report& found) {
      check_degree(c, found);
      return "";
    });
  }
  if (is_done_here("0.cycle", report)) check_cycle(c, report);
  check_balls(c, report);
  if (is_done_here("0.degree", report)) degree ? void(degree->result(report)) : check_degree(c, report);
  return std::to_string(c.n) + " points, sampling radius " + (c.units.empty() ? "" : "at most ") +
         rounded_up(c.epsilon.exact) + ", separation >= " + rounded_down(c.mu.exact) +
         ", perturbation <= " + rounded_up(c.rho.exact) +
         (!c.hypotheses_2 ? ", Hypotheses 1"
          : c.sharper     ? ", Hypotheses 1 and the sharper Hypotheses 2"
                          : ", Hypotheses 1 and 2");
}

}  // namespace delcert::checker
