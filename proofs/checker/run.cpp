#include "proofs/checker/run.hpp"

#include <algorithm>
#include <chrono>
#include <optional>
#include <stdexcept>

#include "proofs/checker/atlases/glued_charts.hpp"
#include "proofs/checker/certificate/expectation.hpp"
#include "proofs/checker/core/chunk_view.hpp"
#include "proofs/checker/core/core.hpp"
#include "proofs/checker/levels/levels.hpp"
#include "proofs/checker/metric_fields/metric_field_levels.hpp"
#include "proofs/checker/parts/parts.hpp"
#include "proofs/checker/space_forms/group.hpp"
#include "proofs/checker/space_forms/space_form_levels.hpp"
#include "proofs/checker/space_forms/space_form_stars.hpp"
#include "proofs/checker/submanifolds/tangent_charts.hpp"

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

/// `check` takes a Report and returns in words what it looked at.
template <class Check>
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
  result.ranges = report.ranges;
  result.done = report.done;
  result.left = report.left;
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return result;
}

/// The checks of a certificate, one after the other, and what they share.
class Run {
 public:
  Run(const Certificate& certificate, const Levels& chosen, Outcome& outcome)
      : c_(certificate), chosen_(chosen), outcome_(outcome) {}

  void check_all() {
    if (c_.metric_field) {
      outcome_.levels.push_back(run_check("field", [&](Report& report) {
        charts_.emplace(c_);
        return check_metric_field(*charts_, report);
      }));
      if (outcome_.levels.back().status != 0) return list_levels();
    }
    if (c_.gluing) {
      outcome_.levels.push_back(run_check("atlas", [&](Report& report) {
        glued_charts_.emplace(c_);
        return glued_charts_->check(report);
      }));
      if (outcome_.levels.back().status != 0) return list_levels();
    }
    if (c_.submanifold) {
      outcome_.levels.push_back(run_check("charts", [&](Report& report) {
        tangent_charts_.emplace(c_);
        return tangent_charts_->check(report);
      }));
      if (outcome_.levels.back().status != 0) return list_levels();
    }
    for (const std::size_t level : order()) {
      if (!chosen_[level] || !stands(level) || (needs_group(level) && !has_group())) continue;
      results_[level] = run_check(level_names[level], [&](Report& report) { return check(level, report); });
      holds_[level] = results_[level]->status == 0;
      if (level == level_2 && !has_core(c_.kind()))
        holds_[level_of_stars(c_.kind())] = holds_[level_2] = holds_[level_of_stars(c_.kind())] && holds_[level_2];
    }
    list_levels();
  }

  Identity identity() const {
    Identity result = identify(c_);
    if (own_share.number != 1) return result;  // the first part looks at what follows
    if ((c_.submanifold || c_.gluing) && holds_[level_5] && !c_.homology.empty()) {
      // The top group has a Z for each component that is orientable, the first one for each that there is.
      result.orientability = c_.homology.back() == c_.homology.front() ? "orientable" : "not orientable";
      result.first_homology = c_.homology[1];
      result.homology_of = "the complex";
    }
    if (!c_.space_form) return result;
    // A matrix that is no isometry neither keeps nor changes an orientation.
    if (holds_[level_2]) result.orientability = keeps_orientation(*c_.space_form) ? "orientable" : "not orientable";
    if (group_holds_) {
      result.size = group_.size;
      result.first_homology = first_homology(group_);
    } else if ((holds_[level_4] || holds_[level_5]) && !c_.homology.empty()) {
      result.first_homology = c_.homology[1];
      result.homology_of = "the complex";
    }
    return result;
  }

  /// Those that were claimed and not looked at, if nothing was.
  void list_levels() {
    if (group_result_) outcome_.levels.push_back(std::move(*group_result_));
    for (std::size_t level = 0; level < level_names.size(); ++level) {
      if (results_[level]) {
        outcome_.levels.push_back(std::move(*results_[level]));
      } else if (c_.claimed[level]) {
        outcome_.unchecked.emplace_back(level_names[level]);
      }
    }
  }

 private:
  std::vector<std::size_t> order() const {
    if (c_.space_form) return {level_2, level_1, level_2s, level_4, level_5, level_6, level_0};
    if (c_.torus) return {level_0, level_2, level_1, level_2s, level_3, level_4, level_5, level_6};
    if (c_.submanifold) return {level_1, level_1f, level_2, level_2s, level_5, level_5i, level_4, level_6};
    return {level_0, level_1, level_1f, level_2, level_2s, level_3, level_4, level_5, level_5i, level_6};
  }

  /// Where levels 1 and 2 rest on each other they are looked at together.
  bool stands(std::size_t level) const {
    if (!has_core(c_.kind()) && (level == level_1 || level == level_1f || level == level_2)) return true;
    const std::vector<Level> bases = rests_on(level, c_.kind());
    return std::all_of(bases.begin(), bases.end(), [&](Level base) { return holds_[base]; });
  }

  /// Its injectivity radius.
  bool needs_group(std::size_t level) const {
    return c_.space_form &&
           (level == level_0 || level == level_1 || level == level_2s || (level == level_5 && c_.riemannian_simplices));
  }
  bool has_group() {
    if (!group_result_) {
      group_result_ = run_check("group", [&](Report& report) {
        if (is_done_here("group", report)) group_ = check_group(*c_.space_form, report);
        return group_.summary;
      });
      group_holds_ = group_result_->status == 0;
    }
    return group_holds_;
  }

  std::string check(std::size_t level, Report& report) {
    if (level == level_2 && has_core(c_.kind())) return check_manifold(report);
    if (level == level_2) {
      const std::string text = check_count(c_, nullptr, report);
      const bool is_next = holds_[level_of_stars(c_.kind())] && report.findings.empty() && owes_homology(report);
      return is_next ? text + check_homology(c_, report) : text;
    }
    if (core_ && level == level_4) return core_->check_delaunay(report);
    if (core_ && level == level_5) return core_->check_triangulation(report);
    if (core_ && level == level_6) return core_->check_metric(report);
    if (c_.space_form) {
      if (!lifts_) {
        core_->check_quotient(report);
        if (!report.findings.empty()) return "";
        lifts_.emplace(c_, core_->complex(), core_->is_delaunay());
      }
      if (level == level_0) return check_input_on_space_form(c_, *lifts_, report);
      if (!stars_) stars_.emplace(c_, core_->complex(), *lifts_);
      return level == level_1 ? stars_->check_stars(report) : stars_->check_stable_stars(report);
    }
    if (tangent_charts_) {
      if (level == level_1) return check_stars(*tangent_charts_, report);
      if (level == level_2s) return check_stable_stars(*tangent_charts_, report);
      if (!is_done_here("all of level " + std::string(level_names[level]), report)) return "";
      if (level == level_5) return triangulation_.emplace(*tangent_charts_).check(report);
      if (level == level_4) return check_restricted_delaunay(*tangent_charts_, *triangulation_, report);
      return level == level_5i  ? triangulation_->check_embedding(report)
             : level == level_6 ? triangulation_->check_metric(report)
                                : check_given_stars(c_, report);
    }
    if (glued_charts_) {
      if (level == level_1) return check_stars(*glued_charts_, report);
      if (level == level_2s) return check_stable_stars(*glued_charts_, report);
      return is_done_here("all of level 5", report) ? check_blended_triangulation(*glued_charts_, report) : "";
    }
    if (charts_) {
      if (level == level_1) return check_stars(*charts_, report);
      if (level == level_2s) return check_stable_stars(*charts_, report);
      if (level == level_5) return "follows from levels 1 and 2 in small patches of affine charts";
      return is_done_here("all of level 4", report) ? check_delaunay_of_metric_field(*charts_, report) : "";
    }
    return level == level_0    ? check_level_0(c_, report)
           : level == level_1  ? check_level_1(c_, core_ ? &*core_ : nullptr, report)
           : level == level_2s ? check_level_2s(c_, report)
           : level == level_3  ? check_level_3(c_, report)
                               : "follows from levels 1 and 2";
  }

  bool owes_homology(Report& report) const { return !c_.homology.empty() && is_done_here("2.homology", report); }

  /// Level 2 where there is a core. The homology is that of a manifold, which mostly it is; what is no manifold can
  /// have any homology, and that can take any time to find.
  std::string check_manifold(Report& report) {
    std::optional<Elsewhere> homology;
    const bool owed = owes_homology(report);
    if (owed && most_parts > 1) homology.emplace([this](Report& found) { return check_homology(c_, found); });
    core_.emplace(c_).check_manifold(report);
    const std::string text = check_count(c_, &*core_, report);
    if (!owed || !report.findings.empty()) return text;
    return text + (homology ? homology->result(report) : check_homology(c_, report));
  }

  const Certificate& c_;
  const Levels& chosen_;
  Outcome& outcome_;
  Levels holds_{};
  std::array<std::optional<LevelResult>, level_names.size()> results_;
  std::optional<LevelResult> group_result_;
  Group group_;
  bool group_holds_ = false;
  std::optional<core::Core> core_;
  std::optional<Lifts> lifts_;
  std::optional<SpaceFormStars> stars_;
  std::optional<FieldCharts> charts_;
  std::optional<GluedCharts> glued_charts_;
  std::optional<TangentCharts> tangent_charts_;
  std::optional<GraphTriangulation> triangulation_;
};

}  // namespace

namespace {

/// `read` makes a Certificate.
template <class Read>
Outcome check_what_is_read(const Read& read, const std::vector<std::string>& selected, std::string_view expected) {
  Outcome outcome;
  outcome.share = own_share;
  decisions = in_ranges = {};
  Budget::open(0);
  try {
    const std::unique_ptr<const Certificate> whole = read();
    const Certificate& certificate = *whole;
    outcome.share = own_share;  // which chunk it is, the header says
    const Levels chosen = selection(certificate, selected);
    outcome.identity = identify(certificate);
    outcome.content = certificate.content;
    outcome.points = certificate.n;
    outcome.simplices = certificate.simplices;
    outcome.euler_characteristic = certificate.euler_characteristic;
    bool is_expected = true;
    if (!expected.empty()) {
      outcome.levels.push_back(run_check("manifold", [&](Report& report) -> std::string {
        const std::string key = difference_from_expected(expected, certificate.manifold_text);
        if (!key.empty()) report.reject("manifold.expected", [&] { return "the manifold has another " + key; });
        return "the one that is expected";
      }));
      is_expected = outcome.levels.back().status == 0;
    }
    Run run(certificate, chosen, outcome);
    is_expected ? run.check_all() : run.list_levels();
    outcome.identity = run.identity();
  } catch (const Malformed& reason) {
    outcome.status = 3;
    outcome.malformed = Finding{reason.rule, reason.what()};
  } catch (const Undecided& reason) {
    outcome.levels.push_back({"form", 2, reason.what(), {}, 0, {}, {}, {}});
  }
  for (const LevelResult& result : outcome.levels) {
    if (result.status != 0 && outcome.status != 1) outcome.status = result.status;
  }
  outcome.decisions = own_share.number == 1 ? decisions : in_ranges;
  return outcome;
}

}  // namespace

Outcome check(std::string_view text, const std::vector<std::string>& selected, std::string_view expected,
              const KnownDigest& known) {
  chunk_items.reset();
  return check_what_is_read([&] { return std::make_unique<const Certificate>(text, known); }, selected, expected);
}

Outcome check_chunk(const std::string& folder, std::size_t number) {
  // What is so far is read first; where it does not suffice, more.
  constexpr unsigned first_edges = 6, most_edges = 96;
  own_share = {number + 1, number + 2};  // no whole, whatever happens
  Chunks chunks(folder);
  ChunkView view(chunks, number);
  for (unsigned edges = first_edges;; edges *= 2) {
    try {
      Outcome outcome = check_what_is_read([&] { return std::make_unique<const Certificate>(view, edges); }, {}, {});
      if (outcome.malformed || !outcome.identity) return outcome;
      outcome.points = chunks.points();
      outcome.chunk = {chunks.root(),
                       chunks.first(number),
                       chunks.end(number),
                       chunks.simplices_before(number),
                       chunks.simplices_before(number + 1),
                       view.trees(),
                       view.joins()};
      return outcome;
    } catch (const NotRead&) {
      if (edges < most_edges) continue;
      Outcome outcome;
      outcome.status = 2;
      outcome.levels.push_back({"chunk", 2, "what a level looks at is too far from the chunk", {}, 0, {}, {}, {}});
      return outcome;
    }
  }
}

}  // namespace delcert::checker
