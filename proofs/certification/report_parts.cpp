#include "proofs/certification/report_parts.hpp"

#include <fmt/format.h>
#include <sys/resource.h>

#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "kernel/number/decimal_bounds.hpp"
#include "kernel/number/exact_text.hpp"
#include "kernel/number/filter.hpp"

namespace delcert {

namespace {

constexpr std::array<const char*, rung_count> rung_names{"interval", "big interval", "rational", "algebraic"};

constexpr int digits_of_bounds = 4;

/// A decimal of four digits at most in the layout of the reports. It is what the nearest double prints as again.
std::string in_scientific_notation(const std::string& decimal) {
  const double value = std::strtod(decimal.c_str(), nullptr);
  const bool is_in_range = std::isnormal(value) || decimal == "0";
  return is_in_range ? fmt::format("{:.{}e}", value, digits_of_bounds - 1) : decimal;
}

/// The greatest double that is not above x, or the least that is not below it.
double safe_double(const Rational& x, Margin::Side side) {
  const FilterGuard guard;
  const Filter enclosure = scalar_from<Filter>(x);
  return side == Margin::Side::lower ? enclosure.lower() : enclosure.upper();
}

}  // namespace

std::string decimal_lower(const Rational& x) { return in_scientific_notation(decimal_lower(x, digits_of_bounds)); }
std::string decimal_upper(const Rational& x) { return in_scientific_notation(decimal_upper(x, digits_of_bounds)); }

nlohmann::ordered_json bound_json(const Margin& margin, const Rational& sampling_radius) {
  nlohmann::ordered_json json{{"exact", exact_text(margin.value)},
                              {"value", safe_double(margin.value, margin.side)},
                              {"bound", margin.side == Margin::Side::lower ? "lower" : "upper"},
                              {"unit", "1"}};
  if (margin.unit == Margin::Unit::one) return json;
  const bool is_length = margin.unit == Margin::Unit::length;
  json["unit"] = is_length ? "length" : "length^2";
  json["in_sampling_radii"] =
      safe_double(margin.value / (is_length ? sampling_radius : square(sampling_radius)), margin.side);
  return json;
}
nlohmann::ordered_json lower_json(const Rational& x, Margin::Unit unit, const Rational& sampling_radius) {
  return bound_json({x, Margin::Side::lower, unit}, sampling_radius);
}
nlohmann::ordered_json upper_json(const Rational& x, Margin::Unit unit, const Rational& sampling_radius) {
  return bound_json({x, Margin::Side::upper, unit}, sampling_radius);
}

std::vector<std::string> homology_texts(const ManifoldClaim& manifold) {
  std::vector<std::string> result;
  for (const AbelianGroup& group : manifold.homology) result.push_back(group_text(group));
  return result;
}

std::string tries_text(const PerturbationStatistics& statistics) {
  const double placements = static_cast<double>(statistics.placements == 0 ? 1 : statistics.placements);
  return fmt::format("{:.2f} candidates a point (most {}), {:.3f} tries (most {}), {:.0f} simplices looked at",
                     static_cast<double>(statistics.candidates) / placements, statistics.most_candidates,
                     static_cast<double>(statistics.tries) / placements, statistics.most_tries,
                     static_cast<double>(statistics.visited) / placements);
}

std::string stages_text(const std::vector<StageClock::Stage>& stages) {
  std::string out = "stages\n";
  double total = 0;
  LadderStatistics decisions;
  for (const StageClock::Stage& stage : stages) {
    out += fmt::format("  {:<34} {:8.3f} s   {:>12} decisions\n", stage.name, stage.seconds, stage.decisions.total());
    total += stage.seconds;
    decisions += stage.decisions;
  }
  out += fmt::format("  {:<34} {:8.3f} s   {:>12} decisions\n", "all", total, decisions.total());
  for (std::size_t rung = 0; rung < rung_count; ++rung) {
    if (decisions.settled[rung] == 0) continue;
    out += fmt::format("  settled by {:<23} {:10.6f} %\n", rung_names[rung],
                       100.0 * static_cast<double>(decisions.settled[rung]) / static_cast<double>(decisions.total()));
  }
  return out;
}

nlohmann::ordered_json stages_json(const std::vector<StageClock::Stage>& stages) {
  nlohmann::ordered_json result;
  for (const StageClock::Stage& stage : stages) {
    nlohmann::ordered_json rungs;
    for (std::size_t rung = 0; rung < rung_count; ++rung) rungs[rung_names[rung]] = stage.decisions.settled[rung];
    rungs["undecided"] = stage.decisions.undecided;
    result.push_back({{"stage", stage.name}, {"seconds", stage.seconds}, {"decisions", rungs}});
  }
  return result;
}

double peak_memory_in_mib() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

}  // namespace delcert
