#include "proofs/checker/run.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <optional>
#include <stdexcept>

#include "proofs/checker/core/levels.hpp"
#include "proofs/checker/expectation.hpp"
#include "proofs/checker/metric_field_levels.hpp"
#include "proofs/checker/space_form_levels.hpp"

namespace delcert::checker {
namespace {

using Levels = std::array<bool, level_names.size()>;

void select(Levels& chosen, std::size_t level, Kind kind) {
  if (chosen[level]) return;
  chosen[level] = true;
  for (const Level base : rests_on(level, kind)) select(chosen, base, kind);
}

Levels selection(const Certificate& certificate, const std::vector<std::string>& selected) {
  if (selected.empty()) return certificate.claimed;
  Levels chosen{};
  for (const std::string& name : selected) {
    const auto level =
        static_cast<std::size_t>(std::find(level_names.begin(), level_names.end(), name) - level_names.begin());
    if (level == level_names.size() || !certificate.claimed[level])
      throw std::invalid_argument("level " + name + " is not claimed");
    select(chosen, level, certificate.kind());
  }
  return chosen;
}

using Check = std::function<std::string(Report&)>;

LevelResult run_check(const std::string_view name, const Check& check) {
  const auto begin = std::chrono::steady_clock::now();
  LevelResult result;
  result.level = name;
  Report report;
  try {
    result.summary = check(report);
  } catch (const Undecided& reason) {
    result.status = 2;
    result.summary = reason.what();
  }
  if (!report.findings.empty()) result.status = 1;
  result.findings = report.findings;
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return result;
}

Check check_of_level(const AffineCharts& charts, std::size_t level) {
  return [&charts, level](Report& report) -> std::string {
    if (level == level_1) return check_stars_of_metric_field(charts, report);
    if (level == level_2s) return check_stable_stars_of_metric_field(charts, report);
    if (level == level_4) return check_delaunay_of_metric_field(charts, report);
    if (level == level_5) return "follows from levels 1 and 2 in small patches of affine charts";
    throw std::logic_error("a level that metric fields do not have");
  };
}

Check check_of_level(const Certificate& c, std::size_t level, const Lifts* lifts) {
  using Flat = std::string (*)(const Certificate&, Report&);
  using Curved = std::string (*)(const Certificate&, const Lifts&, Report&);
  const Flat follows = [](const Certificate&, Report&) -> std::string { return "follows from levels 1 and 2"; };
  const std::array<Flat, level_names.size()> flat = {check_level_0, check_level_1, nullptr, check_level_2s,
                                                     check_level_3, follows,       follows, follows};
  const std::array<Curved, level_names.size()> curved = {check_input_on_space_form,
                                                         check_stars_in_charts,
                                                         nullptr,
                                                         check_stable_stars_in_charts,
                                                         nullptr,
                                                         check_delaunay_on_space_form,
                                                         check_triangulation_of_space_form,
                                                         check_metric_of_space_form};
  if (lifts != nullptr && curved[level] != nullptr)
    return [&c, lifts, check = curved[level]](Report& report) { return check(c, *lifts, report); };
  return [&c, check = flat[level]](Report& report) { return check(c, report); };
}

using CheckOfLevel = std::function<Check(std::size_t)>;

/// Each level after those on which it rests: level 0 of a space form is the last, and elsewhere the first. Levels 1 and
/// 2 are claimed together, and looked at together. Without `check_of` no level is looked at.
void check_levels(const Certificate& c, const Levels& chosen, const CheckOfLevel* check_of, Outcome& outcome) {
  std::vector<std::size_t> order = {level_0, level_1, level_2, level_2s, level_3, level_4, level_5, level_6};
  if (c.kind() == Kind::space_form) std::rotate(order.begin(), order.begin() + 1, order.end());
  Levels holds{};
  std::array<std::optional<LevelResult>, level_names.size()> results;
  for (const std::size_t level : order) {
    if (!chosen[level] || check_of == nullptr) continue;
    const std::vector<Level> bases = rests_on(level, c.kind());
    const auto stands = [&](Level base) {
      const bool both = holds[level_1] && holds[level_2];
      return level == level_1 || level == level_2 || (base == level_1 || base == level_2 ? both : holds[base]);
    };
    if (!std::all_of(bases.begin(), bases.end(), stands)) continue;
    const Check check = level == level_2 ? [&](Report& report) { return check_level_2(c, holds[level_1], report); }
                                         : (*check_of)(level);
    results[level] = run_check(level_names[level], check);
    holds[level] = results[level]->status == 0;
  }
  for (std::size_t level = 0; level < level_names.size(); ++level) {
    if (results[level]) {
      outcome.levels.push_back(std::move(*results[level]));
    } else if (c.claimed[level]) {
      outcome.unchecked.emplace_back(level_names[level]);
    }
  }
}

/// Around the greatest distance of a point from o, halved: with the precision of balls.
Interval greatest_distance(const Certificate& c) {
  const SpaceForm& form = *c.space_form;
  Ball most(0);
  for (Label i = 0; i < c.n; ++i) {
    Vector<Ball> a = c.net.position<Ball>({i, {}});
    if (form.K == 0) {
      const SquareMatrix<Ball> T = form.basis();
      Vector<Ball> linear{};
      for (std::size_t k = 0; k < form.m; ++k) linear[k + 1] = a[k];
      linear = T * linear;
      for (std::size_t k = 0; k < form.m; ++k) a[k] = linear[k + 1];
    }
    most = maximum(most, squared(a, form.m));
  }
  const Ball half = square_root(most) / Ball(2), distance = half * logarithm_factor(form.K, square(half));
  return distance.enclosure();
}

/// An upper bound of the distances from o of all points.
Rational spread(const Certificate& c) {
  const SpaceForm& form = *c.space_form;
  if (form.K > 0) return Rational(4);
  const Interval distance = in_balls(128, [&] { return greatest_distance(c); });
  const double sixteenths = 32 * distance.upper();
  if (!(sixteenths < 1e6)) throw Undecided("a point of the net is too far from the origin");
  return Rational(static_cast<int>(std::ceil(sixteenths)) + 1) / Rational(16) + c.rho.exact * c.epsilon.exact;
}

}  // namespace

Outcome check(std::string_view text, const std::vector<std::string>& selected, std::string_view expected) {
  Outcome outcome;
  decisions = {};
  Budget::open(0);
  try {
    const Certificate certificate(text);
    const Levels chosen = selection(certificate, selected);
    outcome.identity = identify(certificate, nullptr);
    bool is_expected = true;
    if (!expected.empty()) {
      outcome.levels.push_back(run_check("manifold", [&](Report& report) -> std::string {
        const std::string key = difference_from_expected(expected, certificate.manifold_text);
        if (!key.empty()) report.reject("manifold.expected", [&] { return "the manifold has another " + key; });
        return "the one that is expected";
      }));
      is_expected = outcome.levels.back().status == 0;
    }
    Group group;
    std::optional<Lifts> lifts;
    if (certificate.space_form && is_expected) {
      outcome.levels.push_back(run_check("group", [&](Report& report) {
        const Rational far = spread(certificate), reach = certificate.reach();
        group = check_group(*certificate.space_form, reach, far, report);
        if (report.findings.empty()) lifts.emplace(certificate, group, reach, far);
        return group.summary;
      }));
    }
    std::optional<AffineCharts> charts;
    outcome.identity = identify(certificate, lifts ? &group : nullptr);
    bool ready = is_expected && (!certificate.space_form || lifts);
    if (certificate.metric_field && is_expected) {
      outcome.levels.push_back(run_check("field", [&](Report& report) {
        charts.emplace(certificate);
        return check_metric_field(*charts, report);
      }));
      ready = outcome.levels.back().status == 0;
    }
    if (chosen[level_2] && is_expected && !certificate.has_boundary() && !certificate.metric_field) {
      outcome.levels.push_back(
          run_check("core", [&](Report& report) { return core::check_levels(certificate, chosen, report); }));
    }
    const CheckOfLevel check_of = [&](std::size_t level) {
      return charts ? check_of_level(*charts, level) : check_of_level(certificate, level, lifts ? &*lifts : nullptr);
    };
    check_levels(certificate, chosen, ready ? &check_of : nullptr, outcome);
  } catch (const Malformed& reason) {
    outcome.status = 3;
    outcome.malformed = Finding{reason.rule, reason.what()};
  } catch (const Undecided& reason) {
    outcome.levels.push_back({"form", 2, reason.what(), {}, 0});
  }
  for (const LevelResult& result : outcome.levels) {
    if (result.status != 0 && outcome.status != 1) outcome.status = result.status;
  }
  outcome.decisions = decisions;
  return outcome;
}

}  // namespace delcert::checker
