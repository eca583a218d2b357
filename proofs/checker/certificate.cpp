#include "proofs/checker/certificate.hpp"

#include <algorithm>
#include <cstdio>

#include "proofs/checker/input.hpp"

namespace delcert::checker {
namespace {

Quantity quantity(std::string_view text) { return text.empty() ? Quantity() : Quantity(exact_value(text)); }

/// The document, after the checks without which nothing else can be looked at.
Document well_formed(std::string_view text) {
  Document d = parse_document(text);
  Report::require("seal", sha256(d.sealed) == d.sha256, "the SHA-256 of the content is not the one it is sealed with");
  const std::size_t n = d.number_of_points();
  const auto lengths = [](bool holds, const std::string& what) {
    if (!holds) throw Malformed("form.lengths", what);
  };
  lengths(n >= 1, "there are no points");
  lengths(n < UINT32_MAX, "there are more points than labels");
  lengths(d.net.size() == d.points.size() || (d.net.empty() && d.torus && !d.claimed[level_0]),
          "net and points have different lengths");
  lengths(d.star_begin.size() == n + 1,
          "stars has " + std::to_string(d.star_begin.size() - 1) + " entries for " + std::to_string(n) + " points");
  for (const std::vector<Label>* labels : {&d.net_simplices, &d.star_labels}) {
    for (const Label j : *labels) {
      if (j >= n) throw Malformed("form.labels", "label " + std::to_string(j) + " is not below " + std::to_string(n));
    }
  }
  return d;
}

}  // namespace

Certificate::Certificate(std::string_view text)
    : document(well_formed(text)),
      torus(document.torus),
      m(document.dimension),
      n(static_cast<Label>(document.number_of_points())),
      metric(m, document.gram),
      epsilon(quantity(document.sampling_radius)),
      mu(quantity(document.separation)),
      rho(quantity(document.perturbation)),
      flake_squared(quantity(document.flake_parameter_squared)),
      tolerance(quantity(document.tolerance)),
      radius(quantity(document.radius)),
      protection(quantity(document.protection)),
      thickness(quantity(document.thickness)),
      circumradius(quantity(document.circumradius)),
      net(metric, torus, document.net),
      points(metric, torus, document.points),
      interior(interior_labels()) {
  require_parameters();
  require_levels();
  require_net();
  require_stars();
}

std::vector<bool> Certificate::interior_labels() const {
  std::vector<bool> result(n, torus);
  for (Label i = 0; i < n && !torus; ++i) {
    // |p| <= radius - 8 epsilon
    result[i] = decide([&]<class N>(In<N>) {
      const N room = radius.as<N>() - N(8) * epsilon.as<N>();
      return conjunction(less_equal(N(0), room),
                         less_equal(metric.squared_length(net.position<N>({i, {}})), square(room)));
    });
  }
  return result;
}

void Certificate::require_parameters() const {
  const auto require = [](bool holds, const std::string& what) { Report::require("form.ranges", holds, what); };
  const auto at_most = [](const Rational& a, const Rational& b) { return less_equal(a, b) == Verdict::proved; };
  const Rational one(1), four(4);
  require(torus || radius.exact.sign() > 0, "radius is not positive");
  require(epsilon.exact.sign() > 0, "sampling_radius is not positive");
  require(mu.exact.sign() > 0 && at_most(mu.exact, one), "separation is not in (0, 1]");
  require(quantity(document.radius_variation).exact.sign() == 0, "radius_variation is not 0");
  require(quantity(document.distortion).exact.sign() == 0, "distortion is not 0");
  require(rho.exact.sign() >= 0 && at_most(rho.exact * four, mu.exact), "perturbation is not in [0, separation/4]");
  require(flake_squared.exact.sign() > 0 && at_most(flake_squared.exact, one),
          "flake_parameter_squared is not in (0, 1]");
  require(tolerance.exact.sign() >= 0, "tolerance is negative");
  if (!document.claimed[level_1]) return;
  require(protection.exact.sign() > 0, "protection is not positive");
  require(thickness.exact.sign() > 0, "thickness is not positive");
  require(circumradius.exact.sign() > 0, "circumradius is not positive");
}

void Certificate::require_levels() const {
  const auto& claimed = document.claimed;
  Report::require("form.levels", std::find(claimed.begin(), claimed.end(), true) != claimed.end(),
                  "no level is claimed");
  for (std::size_t level = 0; level < level_names.size(); ++level) {
    for (const Level base : rests_on(static_cast<Level>(level))) {
      Report::require(
          "form.levels", !claimed[level] || claimed[base],
          "level " + std::string(level_names[level]) + " is claimed without level " + std::string(level_names[base]));
    }
  }
  Report::require("form.family", torus || !(claimed[level_5] || claimed[level_6]), "levels 5 and 6 are for flat tori");
}

void Certificate::require_net() const {
  const auto size = static_cast<std::size_t>(m) + 1;
  Report::require("form.net-simplices", document.net_simplices.empty() || document.claimed[level_0],
                  "net_simplices is not empty although level 0 is not claimed");
  for (auto s = document.net_simplices.begin(); s != document.net_simplices.end(); s += m + 1) {
    std::vector<Label> labels(s, s + m + 1);
    std::sort(labels.begin(), labels.end());
    const bool distinct = std::adjacent_find(labels.begin(), labels.end()) == labels.end();
    Report::require("form.net-simplices", distinct,
                    "net simplex " + label_set({s, s + static_cast<std::ptrdiff_t>(size)}) + " repeats a label");
  }
}

void Certificate::require_stars() const {
  for (Label i = 0; i < n; ++i) {
    const std::string name = "star of " + std::to_string(i);
    Report::require("form.interior", interior[i] == (star_size(i) > 0),
                    name + (interior[i] ? " is empty" : " is not empty although the label is not interior"));
    for (std::size_t s = 0; s < star_size(i); ++s) {
      const Label* labels = star_simplex(i, s);
      bool increasing = std::find(labels, labels + m, i) == labels + m;
      for (int k = 1; k < m; ++k) increasing = increasing && labels[k - 1] < labels[k];
      if (!increasing)
        Report::require("form.star-labels", false,
                        name + " has " + label_set({labels, labels + m}) + ": not increasing, or not other labels");
      const bool follows = s == 0 || std::lexicographical_compare(labels - m, labels, labels, labels + m);
      if (!follows)
        Report::require("form.star-order", false, name + ": " + label_set({labels, labels + m}) + " is out of order");
    }
  }
}

std::vector<Level> rests_on(Level level) {
  switch (level) {
    case level_0:
      return {};
    case level_1:
      return {level_2};
    case level_2:
      return {level_1};
    case level_2s:
      return {level_0, level_2};
    case level_3:
      return {level_0};
    default:
      return {level == level_4 ? level_2 : static_cast<Level>(level - 1)};
  }
}

std::string label_set(std::vector<Label> labels) {
  std::string text;
  for (const Label j : labels) text += (text.empty() ? "{" : ", ") + std::to_string(j);
  return text + "}";
}

std::string about(const Interval& x) {
  char text[64];
  std::snprintf(text, sizeof text, "%.6g", x.lower() / 2 + x.upper() / 2);
  return text;
}

}  // namespace delcert::checker
