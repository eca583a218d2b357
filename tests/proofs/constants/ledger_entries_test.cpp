#include "proofs/constants/ledger_entries.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>
#include <string>

#include "kernel/number/exact_text.hpp"
#include "tests/proofs/constants/ball.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

Ledger surface() { return constants_for(Dimension{2}, Rational(1), Rational(1) / Rational(4)); }

LedgerEntry entry_named(const std::vector<LedgerEntry>& entries, const std::string& name) {
  const auto found = std::find_if(entries.begin(), entries.end(), [&](const auto& e) { return e.name == name; });
  if (found == entries.end()) throw std::out_of_range(name);
  return *found;
}

TEST(LedgerEntries, have_distinct_names_and_ordered_bounds) {
  std::set<std::string> names;
  for (const LedgerEntry& entry : ledger_entries(surface())) {
    EXPECT_TRUE(names.insert(entry.name).second) << entry.name;
    EXPECT_LE(entry.value.lower, entry.value.upper) << entry.name;
    EXPECT_FALSE(entry.source.empty()) << entry.name;
    EXPECT_EQ(entry.exact.empty(), entry.exact_latex.empty()) << entry.name;
    if (entry.log2) {
      EXPECT_LE(entry.log2->lower, entry.log2->upper) << entry.name;
    }
  }
}

TEST(LedgerEntries, of_the_sharper_lemmas_say_so_and_have_one_more_radius) {
  const auto printed = ledger_entries(surface());
  const auto sharper = ledger_entries(constants_for(Dimension{2}, Rational(1), Rational(1) / Rational(4), Rational(0),
                                                    Rational(0), ParameterConstraints::sharper));
  std::set<std::string> changed;
  ASSERT_EQ(sharper.size(), printed.size() + 1);
  std::size_t more = 0;
  for (std::size_t k = 0; k < printed.size(); ++k) {
    if (sharper[k + more].name == "self_delaunay_sampling_radius") ++more;
    EXPECT_EQ(sharper[k + more].name, printed[k].name);
    if (sharper[k + more].source != printed[k].source) changed.insert(printed[k].name);
  }
  EXPECT_EQ(more, 1U);
  EXPECT_EQ(changed,
            (std::set<std::string>{"flake_divisor", "hoop_bound_tilde", "distortion_bound", "hoop_distortion_bound",
                                   "chart_sampling_radius", "riemannian_flake_divisor", "riemannian_sampling_radius",
                                   "piecewise_flat_distortion"}));
}

TEST(LedgerEntries, show_products_of_powers_and_fractions) {
  const auto entries = ledger_entries(surface());
  const LedgerEntry flake = entry_named(entries, "flake_parameter");
  EXPECT_EQ(flake.exact, "2^(-101/2)");
  EXPECT_EQ(flake.exact_latex, "2^{-101/2}");
  EXPECT_LT(flake.value.lower, flake.value.upper);
  const LedgerEntry separation = entry_named(entries, "perturbed_separation");
  EXPECT_EQ(separation.exact, "2/5");
  EXPECT_EQ(separation.exact_latex, "\\frac{2}{5}");
  EXPECT_EQ(separation.value.lower, separation.value.upper);
  EXPECT_FALSE(entry_named(entries, "distortion").log2.has_value());
}

TEST(LedgerEntries, are_exact_where_they_are_no_product_of_powers) {
  const auto entries = ledger_entries(surface());
  const LedgerEntry edge = entry_named(entries, "longest_edge");
  EXPECT_EQ(edge.exact, "5/2 + 2^(-307/2)·5");
  EXPECT_EQ(edge.exact_latex, "\\frac{5}{2} + 2^{-307/2} \\cdot 5");
  EXPECT_GT(edge.value.lower, Rational(5) / Rational(2));
  EXPECT_LT((edge.value.upper - Rational(5) / Rational(2)) * Rational::power_of_two(151), Rational(5));
  const LedgerEntry size = entry_named(entries, "sphere_sample_size_at_least");
  EXPECT_EQ(size.exact, "2^539·5^10");
  const auto in_space = ledger_entries(constants_for(Dimension{3}, Rational(1), Rational(1) / Rational(4)));
  EXPECT_EQ(entry_named(in_space, "sphere_sample_size_at_least").exact.rfind("π·2^", 0), 0U);
}

TEST(LedgerEntries, estimate_the_sample_size_where_it_was_measured_only) {
  const auto has_estimate = [](int dimension) {
    const auto entries = ledger_entries(constants_for(Dimension{dimension}, Rational(1), Rational(1) / Rational(4)));
    return std::any_of(entries.begin(), entries.end(),
                       [](const auto& e) { return e.name == "sphere_sample_size_estimate"; });
  };
  EXPECT_FALSE(has_estimate(1));
  EXPECT_TRUE(has_estimate(2));
  EXPECT_TRUE(has_estimate(3));
  EXPECT_FALSE(has_estimate(4));
}

using test::Ball;

struct Parameters {
  long m;
  Rational separation, perturbation, radius_variation, distortion;
};

/// The constants once more, from the formulas of the paper in Arb. The last argument is added to the exponent of 2/μ₀
/// in C and C̃: 21 in the paper.
std::map<std::string, Ball> recomputed(const Parameters& p, long exponent = 21) {
  const Ball m(p.m);
  const Ball mu(p.separation);
  const Ball rho(p.perturbation);
  const Ball eps(p.radius_variation);
  const Ball xi(p.distortion);
  const Ball one(1);
  const Ball two(2);
  const Ball half = one / two;
  const Ball root = power(m, Ball(3) / two);
  const Ball tilde = rho * (one + eps) * (one + xi);
  const Ball c = root * power(two / mu, Ball(4 * p.m * p.m + 5 * p.m + exponent));
  const Ball c_tilde = root * power(two / mu, Ball(5 * p.m * p.m + 5 * p.m + exponent));
  const Ball gamma0 = rho / c;
  const Ball delta0 = power(gamma0, m + one);
  const Ball mu_prime = (mu - two * tilde) / (one + tilde);
  const Ball alpha = power(two, 13) * gamma0 / power(mu, 3);
  const Ball alpha_tilde = power(two, 16) * root * gamma0 / power(mu, 3);
  const Ball odd = power(gamma0, two * m + one);
  const Ball rho_3 = minimum(rho, mu / Ball(5));
  const Ball radius = power(rho_3 / c_tilde, two * m + one) / Ball(64);
  // Volumes of the unit sphere of dimension m and of the unit ball of the same dimension.
  const Ball sphere = two * power(Ball::pi(), (m + one) * half) / gamma((m + one) * half);
  const Ball unit_ball = power(Ball::pi(), m * half) / gamma(m * half + one);
  return {{"dimension", m},
          {"separation", mu},
          {"perturbation", rho},
          {"radius_variation", eps},
          {"distortion", xi},
          {"perturbation_tilde", tilde},
          {"perturbed_separation", mu_prime},
          {"perturbed_radius_ratio", one + tilde},
          {"flake_divisor", c},
          {"flake_parameter", gamma0},
          {"flake_parameter_squared", gamma0 * gamma0},
          {"protection_parameter", delta0},
          {"protection_parameter_squared", delta0 * delta0},
          {"protection", delta0 * mu_prime * (one + tilde)},
          {"hoop_bound", alpha},
          {"hoop_bound_squared", alpha * alpha},
          {"hoop_bound_tilde", alpha_tilde},
          {"tolerance", two * alpha_tilde},
          {"longest_edge", Ball(5) * half * (one + half * delta0 * mu)},
          {"candidates_bound", power(Ball(14) / mu, m * m + m)},
          {"radius_variation_bound", (one - xi) / (one + xi)},
          {"perturbation_tilde_bound", mu / Ball(4)},
          {"flake_parameter_bound", two * mu * mu / Ball(75)},
          {"distortion_bound", power(gamma0, Ball(4) * m + two) / Ball(16)},
          {"stable_stars_distortion_bound", odd * mu * mu / Ball(4096)},
          {"hoop_distortion_bound", odd * odd / Ball(16)},
          {"metric_distortion_bound", mu * mu / Ball(4096) * odd},
          {"chart_sampling_radius", odd / Ball(64)},
          {"riemannian_perturbation", rho_3},
          {"riemannian_flake_divisor", c_tilde},
          {"riemannian_flake_parameter", rho_3 / c_tilde},
          {"riemannian_sampling_radius", radius},
          {"piecewise_flat_distortion", Ball(256) * power(c_tilde / rho_3, two * m) * radius * radius},
          {"sphere_sample_size_at_least", sphere / (unit_ball * power(radius, m))}};
}

/// What an exact form of the ledger says: terms with "+", factors with "·", each π, a fraction, or an integer to a
/// power.
Ball value_of_factor(const std::string& factor) {
  if (factor == "π") return Ball::pi();
  const auto caret = factor.find('^');
  if (caret == std::string::npos) return Ball(parse_exact(factor));
  std::string exponent = factor.substr(caret + 1);
  if (exponent.front() == '(') exponent = exponent.substr(1, exponent.size() - 2);
  return power(Ball(parse_exact(factor.substr(0, caret))), Ball(parse_exact(exponent)));
}

Ball value_of_exact(const std::string& text) {
  const auto plus = text.find(" + ");
  if (plus != std::string::npos) return value_of_exact(text.substr(0, plus)) + value_of_exact(text.substr(plus + 3));
  const std::string dot = "·";
  const auto at = text.find(dot);
  if (at == std::string::npos) return value_of_factor(text);
  return value_of_factor(text.substr(0, at)) * value_of_exact(text.substr(at + dot.size()));
}

/// The names of the entries that are not what was recomputed; with an empty name for each that was not found.
std::set<std::string> disagreements(const Parameters& p, const std::map<std::string, Ball>& expected) {
  const auto entries = ledger_entries(
      constants_for(Dimension{static_cast<int>(p.m)}, p.separation, p.perturbation, p.radius_variation, p.distortion));
  std::set<std::string> names;
  for (const LedgerEntry& entry : entries) {
    if (entry.is_estimate) continue;
    const auto found = expected.find(entry.name);
    if (found == expected.end()) {
      names.insert("not recomputed: " + entry.name);
      continue;
    }
    const Ball value = hull(Ball(entry.value.lower), Ball(entry.value.upper));
    const bool logarithm_agrees = !entry.log2 || entry.log2->lower == Rational(0) ||
                                  agree(hull(Ball(entry.log2->lower), Ball(entry.log2->upper)), log2(found->second));
    if (!agree(value, found->second) || !agree(value_of_exact(entry.exact), found->second) || !logarithm_agrees)
      names.insert(entry.name);
  }
  return names;
}

std::vector<Parameters> grid_of_parameters() {
  const auto fraction = [](long a, long b) { return Rational(a) / Rational(b); };
  std::vector<Parameters> grid;
  for (const long m : {1, 2, 3, 4, 5, 6, 9}) {
    for (const auto& separation : {Rational(1), fraction(1, 2), fraction(1, 4), fraction(7, 10), fraction(999, 1000)}) {
      grid.push_back({m, separation, separation / Rational(4), Rational(0), Rational(0)});
      grid.push_back({m, separation, separation / Rational(17), fraction(1, 3), fraction(1, 7)});
    }
  }
  return grid;
}

TEST(LedgerEntries, agree_with_the_formulas_of_the_paper_in_arb) {
  for (const Parameters& p : grid_of_parameters())
    for (const std::string& name : disagreements(p, recomputed(p)))
      ADD_FAILURE() << name << " for m = " << p.m << ", separation " << exact_text(p.separation);
}

TEST(LedgerEntries, disagree_with_wrong_formulas) {
  const Parameters p{2, Rational(1), Rational(1) / Rational(4), Rational(0), Rational(0)};
  const auto wrong = disagreements(p, recomputed(p, 20));
  for (const char* name : {"flake_divisor", "tolerance", "distortion_bound", "riemannian_sampling_radius",
                           "longest_edge", "protection", "sphere_sample_size_at_least"})
    EXPECT_TRUE(wrong.contains(name)) << name;
  EXPECT_FALSE(wrong.contains("perturbation_tilde"));
  EXPECT_FALSE(wrong.contains("candidates_bound"));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
