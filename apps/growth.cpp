#include "apps/growth.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>

#include "apps/interruption.hpp"
#include "apps/progress_line.hpp"
#include "kernel/number/exact_text.hpp"
#include "properties/attack/attack_report.hpp"
#include "properties/attack/growth.hpp"
#include "properties/attack/job_pool.hpp"
#include "properties/attack/twins.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

constexpr std::size_t fewest_values = 3;

/// Ends a job of a pool that is told to stop; seen by nobody.
struct SeriesStopped {};

/// The searches of one line of the table.
struct Series {
  std::vector<GrowthTarget> targets;
  std::optional<BoundExponent> bound;
  std::string shape;
};

bool is_along_k(const AlongOptions& along) { return along.quantity == "k"; }

void add_claim(const Claim& claim, const SearchOptions& options, const AlongOptions& along,
               std::vector<Series>& result) {
  const std::vector<Shape> shapes = shapes_of(options.claims, claim);
  const ExpressionPointer quantity = quantity_in(claim, along.quantity);
  for (std::size_t at = 0; at < claim.conclusions.size(); ++at) {
    const auto target = [&](const Shape& shape, const Rational& value) {
      return GrowthTarget{claim, at, shape, along.quantity, value, evaluations_of(options, claim, shape)};
    };
    if (is_along_k(along)) {
      Series series{{}, exponent_in_bound(claim, at, *quantity, shapes.front()), "all"};
      for (const Shape& shape : shapes) series.targets.push_back(target(shape, Rational(shape.k)));
      if (series.targets.size() < fewest_values) {
        throw InputError("--along k takes three shapes or more: --shape 1,1 --shape 2,2 --shape 3,3");
      }
      result.push_back(std::move(series));
      continue;
    }
    for (const Shape& shape : shapes) {
      Series series{{}, exponent_in_bound(claim, at, *quantity, shape), text_of(shape)};
      for (const Rational& value : along.values) series.targets.push_back(target(shape, value));
      result.push_back(std::move(series));
    }
  }
}

std::vector<Series> series_of(const SearchOptions& options, const AlongOptions& along) {
  if (!is_along_k(along) && along.values.size() < fewest_values) {
    throw InputError("--along takes three values or more: --values 1/4,1/8,1/16");
  }
  for (const Rational& value : along.values) {
    if (value <= Rational(0)) throw InputError("--values takes numbers above 0");
  }
  std::vector<Series> result;
  for (const Claim& claim : claims_about_instances(options.claims)) add_claim(claim, options, along, result);
  return result;
}

using Points = std::vector<std::optional<GrowthPoint>>;

std::vector<Points> searched(const std::vector<Series>& series, const SearchOptions& options,
                             const Progress& progress) {
  // The claims' functions live in it: made before the threads ask for it.
  (void)full_vocabulary();
  std::vector<std::pair<std::size_t, std::size_t>> places;
  std::vector<Points> results;
  for (std::size_t line = 0; line < series.size(); ++line) {
    results.emplace_back(series[line].targets.size());
    for (std::size_t at = 0; at < series[line].targets.size(); ++at) places.emplace_back(line, at);
  }
  std::atomic<std::size_t> done = 0;
  const Job job = [&](std::size_t number, const std::atomic<bool>& stopping) {
    const auto [line, at] = places[number];
    results[line][at] =
        worst_at(series[line].targets[at], options.seed, [&stopping](std::string_view, std::size_t, std::size_t) {
          if (stopping) throw SeriesStopped();
        });
    ++done;
  };
  run_jobs(places.size(), threads_of(options), job, [&] { progress("tighten", done, places.size()); });
  return results;
}

/// Through the logarithms; points without a ratio above 0 are left out.
std::optional<LineFit> fit_of(const Points& points) {
  std::vector<std::pair<double, double>> logarithms;
  for (const auto& point : points) {
    if (!point || !(point->worst.ratio.lower > 0) || !(point->quantity.lower > 0)) continue;
    logarithms.emplace_back(std::log2(point->quantity.lower), std::log2(point->worst.ratio.lower));
  }
  return line_through(logarithms);
}

/// The exponent of what was found: the ratio is that of the smaller side to the bound, or of the bound to the larger.
double exponent_found(const BoundExponent& bound, const LineFit& fit) {
  const double printed = approximate_double(bound.exponent);
  return bound.is_from_above ? printed + fit.slope : printed - fit.slope;
}

void print_table(const std::vector<Series>& series, const std::vector<Points>& results, const AlongOptions& along) {
  std::cout
      << "| claim / conclusion | shape | along | exponent in the bound | exponent of the worst found | residual | "
         "values |\n|---|---|---|--:|--:|--:|--:|\n";
  for (std::size_t line = 0; line < series.size(); ++line) {
    const GrowthTarget& target = series[line].targets.front();
    const auto fit = fit_of(results[line]);
    const auto& bound = series[line].bound;
    const auto found = std::count_if(results[line].begin(), results[line].end(), [](const auto& p) { return !!p; });
    std::cout << fmt::format(
        "| {} / {} | {} | `{}` | {} | {} | {} | {} of {} |\n", target.claim.name,
        target.claim.conclusions[target.conclusion].name, series[line].shape, along.quantity,
        bound ? exact_text(bound->exponent) : "other",
        fit && bound ? fmt::format("{:.2f} ± {:.2f}", exponent_found(*bound, *fit), fit->error) : "–",
        fit ? fmt::format("{:.2f}", fit->residual) : "–", found, results[line].size());
  }
}

void print_json(const std::vector<Series>& series, const std::vector<Points>& results, const AlongOptions& along) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (std::size_t line = 0; line < series.size(); ++line) {
    const GrowthTarget& first = series[line].targets.front();
    nlohmann::ordered_json one{{"claim", first.claim.name},
                               {"conclusion", first.claim.conclusions[first.conclusion].name},
                               {"along", along.quantity}};
    if (!is_along_k(along)) {
      one["k"] = first.shape.k;
      one["m"] = first.shape.m;
    }
    const auto fit = fit_of(results[line]);
    if (series[line].bound) one["exponent_in_bound"] = exact_text(series[line].bound->exponent);
    if (fit && series[line].bound) {
      one["exponent_found"] = exponent_found(*series[line].bound, *fit);
      one["error"] = fit->error;
      one["residual"] = fit->residual;
    }
    one["points"] = nlohmann::ordered_json::array();
    for (std::size_t at = 0; at < results[line].size(); ++at) {
      nlohmann::ordered_json point{{"value", exact_text(series[line].targets[at].value)}};
      if (const auto& found = results[line][at]) {
        point["quantity_lower"] = found->quantity.lower;
        point["quantity_upper"] = found->quantity.upper;
        point["ratio_lower"] = found->worst.ratio.lower;
        point["ratio_upper"] = found->worst.ratio.upper;
        point["evaluations"] = found->worst.evaluations;
      }
      one["points"].push_back(std::move(point));
    }
    list.push_back(std::move(one));
  }
  std::cout << list.dump(1) << "\n";
}

void write_witnesses(const std::vector<Series>& series, const std::vector<Points>& results,
                     const SearchOptions& options) {
  for (std::size_t line = 0; line < series.size(); ++line) {
    for (std::size_t at = 0; at < results[line].size(); ++at) {
      if (!results[line][at]) continue;
      const GrowthTarget& target = series[line].targets[at];
      write_witness(
          options,
          fmt::format("{}.{}.{}-{}.value-{}.json", target.claim.name, target.claim.conclusions[target.conclusion].name,
                      target.shape.k, target.shape.m, at + 1),
          witness_of(target.claim, target.conclusion, results[line][at]->worst.bindings));
    }
  }
}

bool is_any_refuted(const std::vector<Points>& results) {
  return std::any_of(results.begin(), results.end(), [](const Points& points) {
    return std::any_of(points.begin(), points.end(),
                       [](const auto& point) { return point && is_refuted(point->worst.verdict); });
  });
}

}  // namespace

ExitStatus run_growth(const SearchOptions& options, const AlongOptions& along) {
  require_evaluations(options);
  const std::vector<Series> series = series_of(options, along);
  std::vector<Points> results;
  {
    const InterruptionDeadline deadline;
    ProgressLine line;
    results = searched(series, options, line.callback());
  }
  if (!options.witnesses.empty()) write_witnesses(series, results, options);
  options.json ? print_json(series, results, along) : print_table(series, results, along);
  return is_any_refuted(results) ? ExitStatus::rejected : ExitStatus::verified;
}

}  // namespace delcert
