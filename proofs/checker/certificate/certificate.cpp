#include "proofs/checker/certificate/certificate.hpp"

#include <algorithm>

#include "proofs/checker/arithmetic/exact_number.hpp"
#include "proofs/checker/certificate/input.hpp"
#include "proofs/checker/parts/chunk_items.hpp"
#include "proofs/checker/report/budget.hpp"
#include "proofs/checker/report/report.hpp"

namespace delcert::checker {

Certificate::Certificate(std::string_view text, const KnownDigest& known) {
  Cursor cursor(text);
  parse(cursor);
  const DigestOfBeginning sealed = known ? known() : DigestOfBeginning();
  content = cursor.passed().size() == sealed.length ? sealed.digest : sha256(cursor.passed());
  cursor.expect(",\"sha256\":");
  Report::require("seal", content == cursor.string(), "the SHA-256 of the content is not the one it is sealed with");
  cursor.expect("}");
  cursor.expect_end();
  take();
}

/// What was read, understood.
void Certificate::take() {
  n = static_cast<Label>(points_text.size() / static_cast<std::size_t>(m));
  require_lengths();
  Budget::open(n);
  metric = Metric(m, gram);
  if (!submanifold) net = PointSet(metric, torus, net_text, std::move(net_read_));
  points = PointSet(metric, torus, points_text, std::move(points_read_));
  for (Label i = 0; i < n; ++i) interior.push_back(is_interior(i));
  take_radii();
  require_parameters();
  require_mode();
  require_levels();
  if (space_form) require_space_form();
  if (metric_field || gluing) require_affine_charts();
  if (metric_field) require_metric_field();
  if (gluing) require_gluing();
  if (submanifold) require_submanifold();
  require_elements();
  require_loops();
  derive_stars();
  require_simplices();
}

/// On a Euclidean ball |p_i| <= radius - 8 epsilon.
bool Certificate::is_interior(Label i) const {
  return !has_boundary() || decide([&]<class N>(In<N>) {
    const N room = radius.as<N>() - N(8) * epsilon.as<N>();
    return conjunction(less_equal(N(0), room),
                       less_equal(metric.squared_length(net.position<N>({i, {}})), square(room)));
  });
}

/// Without these no level can be looked at: no switch leaves them out.
void Certificate::require_lengths() const {
  const auto require = [](const char* rule, bool holds, const std::string& what) {
    if (!holds) throw Malformed(rule, what);
  };
  require("form.lengths", !points_text.empty() && points_text.size() / static_cast<std::size_t>(m) < UINT32_MAX,
          "too few or too many points");
  require(
      "form.lengths",
      net_text.size() / net_size() == points_text.size() / m_size() || (net_text.empty() && torus && !claimed[level_0]),
      "net and points have different lengths");
  require("form.lengths", chart_size() == 0 || chart_text.size() / chart_size() == points_text.size() / m_size(),
          "charts and points have different lengths");
  require("form.lengths", radii_text.empty() || radii_text.size() == points_text.size() / m_size(),
          "radii and points have different lengths");
  for (const std::vector<Label>* labels : {&net_simplices, &simplex_labels}) {
    const auto place = std::find_if(labels->begin(), labels->end(), [this](Label j) { return j >= n; });
    if (place != labels->end())
      require("form.labels", false, "label " + std::to_string(*place) + " is not below " + std::to_string(n));
  }
}

void Certificate::require_parameters() const {
  const auto require = [](bool holds, const char* what) { Report::require("form.ranges", holds, what); };
  const auto at_most = [](const Rational& a, const Rational& b) { return less_equal(a, b) == Verdict::proved; };
  const auto positive = [](const Quantity& x) { return x.exact.sign() > 0; };
  require(!has_boundary() || positive(radius), "radius is not positive");
  require(positive(epsilon), "sampling_radius is not positive");
  require(positive(mu) && at_most(mu.exact, Rational(1)), "separation is not in (0, 1]");
  require(radius_variation.exact.sign() == 0 || (!units.empty() && positive(radius_variation)),
          "radius_variation is not 0, nor positive and with radii");
  const bool undistorted = distortion.exact.sign() == 0;
  require(undistorted || (gluing && positive(distortion)) ||
              ((metric_field || submanifold) && positive(distortion) &&
               less(distortion.exact, Rational(1)) == Verdict::proved),
          "distortion is not 0, nor, on a metric field or a submanifold, in (0, 1), nor, on an atlas, positive");
  require(rho.exact.sign() >= 0 && at_most(rho.exact * Rational(4), mu.exact),
          "perturbation is not in [0, separation/4]");
  require(positive(flake_squared) && at_most(flake_squared.exact, Rational(1)),
          "flake_parameter_squared is not in (0, 1]");
  require(tolerance.exact.sign() >= 0, "tolerance is negative");
  require(!claimed[level_1] || positive(protection), "protection is not positive");
  require(!claimed[level_1] || positive(thickness), "thickness is not positive");
  require(!claimed[level_1] || positive(circumradius), "circumradius is not positive");
}

/// Without them no length is known: no switch leaves them out.
void Certificate::take_radii() {
  for (const std::string_view text : radii_text) {
    const Rational value = exact_value(text);
    if (value.sign() <= 0 || epsilon.exact.sign() <= 0) throw Malformed("form.ranges", "a radius is not positive");
    if (torus && less(epsilon.exact, value) == Verdict::proved)
      throw Malformed("form.ranges", "a radius exceeds sampling_radius");
    units.emplace_back(value / epsilon.exact);
    greatest_unit_ =
        units.size() == 1 ? units[0].filter.upper() : std::max(greatest_unit_, units.back().filter.upper());
  }
}

Quantity Certificate::at_least(const Label* begin, const Label* end, const Quantity& length) const {
  if (units.empty()) return length;
  const Label* least = std::min_element(
      begin, end, [&](Label i, Label j) { return less(units[i].exact, units[j].exact) == Verdict::proved; });
  return at(*least, length);
}

void Certificate::require_mode() const {
  if (!unperturbed) return;
  Report::require("form.mode", rho.exact.sign() == 0, "the mode is none, but perturbation is not 0");
  if (!points_are_moves() && net_text.empty()) return;
  for (std::size_t k = 0; k < points_text.size(); ++k) {
    const Rational original = points_are_moves() ? Rational(0) : exact_value(net_text[k]);
    if (exact_value(points_text[k]) == original) continue;
    Report::require("form.mode", false,
                    "the mode is none, but label " + name_of(static_cast<Label>(k / m_size())) + " is moved");
  }
}

void Certificate::require_levels() const {
  bool any = false;
  for (std::size_t level = 0; level < claimed.size(); ++level) {
    any = any || claimed[level];
    for (const Level base : rests_on(level, kind())) {
      Report::require(
          "form.levels", !claimed[level] || claimed[base],
          "level " + std::string(level_names[level]) + " is claimed without level " + std::string(level_names[base]));
    }
  }
  Report::require("form.levels", any, "no level is claimed");
  Report::require("form.family", !has_boundary() || !(claimed[level_5] || claimed[level_6]),
                  "levels 5 and 6 are for closed manifolds");
  Report::require("form.net-simplices", net_simplices.empty() || (claimed[level_0] && !points_are_moves()),
                  "net_simplices is not empty although no level 0 looks at it");
  const auto size = static_cast<std::size_t>(m) + 1;
  for (std::size_t s = 0; s < net_simplices.size(); s += size) {
    const Label* labels = &net_simplices[s];
    bool distinct = true;
    for (std::size_t k = 1; k < size; ++k)
      distinct = distinct && std::find(labels, labels + k, labels[k]) == labels + k;
    if (!distinct) Report::require("form.net-simplices", false, label_set(labels, labels + size) + " repeats a label");
  }
}

std::vector<Level> rests_on(std::size_t level, Kind kind) {
  switch (level) {
    case level_0:
      return kind == Kind::space_form ? std::vector{level_1, level_4} : std::vector<Level>{};
    case level_1:
    case level_1f:
      return {level_2};
    case level_2:
      return has_core(kind) ? std::vector<Level>{} : std::vector{level_of_stars(kind)};
    case level_2s:
      return kind == Kind::ball || kind == Kind::torus ? std::vector{level_0, level_1} : std::vector{level_1};
    case level_3:
      return {level_0};
    case level_5i:
      return {level_5};
    case level_4:
      return kind == Kind::submanifold ? std::vector{level_5} : std::vector{level_2};
    case level_6:
      return kind == Kind::torus ? std::vector{level_4, level_5} : std::vector{level_5};
    default:
      return {level_2};
  }
}

std::string label_set(const Label* begin, const Label* end) {
  std::string text = "{";
  for (const Label* j = begin; j != end; ++j) text += (j == begin ? "" : ", ") + name_of(*j);
  return text + "}";
}

}  // namespace delcert::checker
