#include <gtest/gtest.h>

#include <random>

#include "proofs/checker/levels/configuration.hpp"
#include "proofs/checker/levels/levels.hpp"
#include "tests/checker/support/samples.hpp"
#include "tests/checker/upwards.hpp"

namespace delcert::checker_tests {
namespace {

using namespace checker;

/// Whether any set of 3 … m + 2 lifts near a point is a forbidden configuration, by looking at all in exact arithmetic.
bool has_forbidden_configuration(const Certificate& c) {
  const ConfigurationBounds bounds(c);
  const Quantity reach(Rational(4) * c.radius_factor().exact * c.epsilon.exact);
  bool found = false;
  for (Label first = 0; first < c.n && !found; ++first) {
    Vertices near;
    for (Label j = first + 1; j < c.n; ++j) {
      for (const Lift& lift : c.points.lifts_within({first, {}}, j, reach, true)) near.push_back({j, lift});
    }
    const auto grow = [&](const auto& self, const Vertices& chosen, std::size_t from) -> void {
      if (chosen.size() >= 3) found = found || is_forbidden<Rational>(c, bounds, chosen) == Verdict::proved;
      for (std::size_t k = from; chosen.size() < static_cast<std::size_t>(c.m) + 2 && k < near.size() && !found; ++k) {
        if (near[k].label == chosen.back().label) continue;
        Vertices longer = chosen;
        longer.push_back(near[k]);
        bool all_short = true;
        for (const Vertex& v : chosen)
          all_short = all_short && is_short<Rational>(bounds, bounds.edge_unit.exact,
                                                      c.points.between<Rational>(v, near[k])) == Verdict::proved;
        if (all_short) self(self, longer, k + 1);
      }
    };
    grow(grow, {{first, {}}}, 0);
  }
  return found;
}

/// Few points in a small torus (only the form and level 3 are looked at), some of them in special position.
Model small_model(int m, int n, std::mt19937_64& random) {
  Model model;
  model.m = m;
  for (int i = 0; i < m; ++i) {
    model.gram.emplace_back(m, 0);
    model.gram.back()[static_cast<std::size_t>(i)] = 1;
  }
  model.epsilon = {1, 6};
  model.mu = {1, 1};
  model.rho = {1, 4};
  for (int i = 0; i < n; ++i) {
    auto& point = model.net.emplace_back();
    // A coarse raster makes cospherical sets, repeated and collinear points.
    const long long raster = random() % 3 == 0 ? 1000 : 8;
    for (int k = 0; k < m; ++k)
      point.push_back(Fraction{static_cast<long long>(random() % static_cast<unsigned long long>(raster)), raster} +
                      Fraction{});
  }
  model.points = model.net;
  model.stars.assign(static_cast<std::size_t>(n), {Labels(static_cast<std::size_t>(m))});
  for (int i = 0; i < n; ++i) {
    for (int k = 0, j = 0; k < m; ++k, ++j) {
      if (j == i) ++j;
      model.stars[static_cast<std::size_t>(i)][0][static_cast<std::size_t>(k)] = j;
    }
  }
  model.interior.assign(static_cast<std::size_t>(n), true);
  return model;
}

/// The same with radii between five eighths of the sampling radius and all of it.
Json with_radii(const Json& document, std::mt19937_64& random) {
  Json result = Json::object();
  for (const auto& [key, value] : document.items()) {
    result[key] = value;
    if (key != "net") continue;
    for (std::size_t i = 0; i < value.size(); ++i)
      result["radii"].push_back(Fraction{static_cast<long long>(5 + random() % 4), 48}.text());
  }
  result["parameters"]["radius_variation"] = "1/4";
  return result;
}

TEST(Level3, finds_a_forbidden_configuration_exactly_if_looking_at_all_sets_does) {
  const test::Upwards upwards;
  std::mt19937_64 random(1);
  int found[2][2] = {}, without_by_radii = 0;
  for (int k = 0; k < 1800; ++k) {
    const int m = 1 + k % 3;
    const Model model = small_model(m, m == 1 ? 5 : m == 2 ? 11 : 13, random);
    Json document = certificate(model, {{"0"}, {}, false});
    const char* flakes[] = {"0x1p-100", "0x1p-60", "0x1p-40", "1/10000000000"};
    document["parameters"]["flake_parameter_squared"] = flakes[random() % 4];
    const bool vary = random() % 2 == 0;
    if (vary) document = with_radii(document, random);
    const std::string text = sealed(document);
    const Certificate c(text);
    Report report;
    check_level_3(c, report);
    const bool expected = has_forbidden_configuration(c);
    EXPECT_EQ(!report.findings.empty(), expected) << "case " << k;
    ++found[vary][expected];
    if (!vary || !expected) continue;
    // With the greatest radius everywhere there are more of them; with the least fewer.
    for (Json& radius : document["radii"]) radius = "1/6";
    Report more;
    const std::string uniform = sealed(document);
    check_level_3(Certificate(uniform), more);
    EXPECT_FALSE(more.findings.empty());
    for (Json& radius : document["radii"]) radius = "1/600";
    Report fewer;
    const std::string tiny = sealed(document);
    check_level_3(Certificate(tiny), fewer);
    without_by_radii += fewer.findings.empty() ? 1 : 0;
  }
  for (const auto& counts : found) {
    EXPECT_GT(counts[0], 20);
    EXPECT_GT(counts[1], 20);
  }
  EXPECT_GT(without_by_radii, 10);
}

TEST(Level3, decides_P3_at_its_irrational_bound) {
  const test::Upwards upwards;
  // m = 2, Gamma_0^2 = 2^-3: delta_0 = 2^-4.5, and the bound (5/2)(1 + delta_0/2) epsilon is irrational.
  Json document = wide_torus().document();
  document["parameters"]["flake_parameter_squared"] = "1/8";
  document["parameters"]["separation"] = "1";
  document["parameters"]["sampling_radius"] = "2/5";
  const std::string text = sealed(document);
  const Certificate c(text);
  const ConfigurationBounds bounds(c);
  // (1 + 2^-5.5)^2 = 1.04468245507415922027505277263…
  const std::string digits = "10446824550741592202750527726";
  const std::string scale = "/1" + std::string(28, '0');
  EXPECT_EQ(is_short<Rational>(bounds, bounds.edge_unit.exact, exact_value(digits + "3" + "/1" + std::string(29, '0'))),
            Verdict::proved);
  EXPECT_EQ(is_short<Rational>(bounds, bounds.edge_unit.exact, exact_value(digits + scale)), Verdict::proved);
  EXPECT_EQ(is_short<Rational>(bounds, bounds.edge_unit.exact, exact_value("10446824550741592202750527727" + scale)),
            Verdict::refuted);
  EXPECT_EQ(is_short<Rational>(bounds, bounds.edge_unit.exact, Rational(2)), Verdict::refuted);
  EXPECT_EQ(is_short<Interval>(bounds, bounds.edge_unit.filter, enclosure(exact_value(digits + scale))),
            Verdict::undecided);
}

}  // namespace
}  // namespace delcert::checker_tests
