#include "proofs/checker/atlases/gluing_verification.hpp"

#include <algorithm>

namespace delcert::checker {
namespace {

constexpr std::size_t most_halvings_of_domain = 12;

std::string place_of(std::size_t chart, const Cell& cell) {
  std::string text = "chart " + std::to_string(chart) + " about (";
  for (std::size_t k = 0; k < cell.size(); ++k) text += (k == 0 ? "" : ", ") + about(cell[k]);
  return text + ")";
}

class GluingChecker {
 public:
  GluingChecker(const Gluing& gluing, const std::vector<Passage>& passages, Report& report)
      : gluing_(gluing), passages_(passages), pieces_(by_number(passages)), report_(report) {
    for (const Passage& passage : passages) values_.emplace_back(passage);
  }

  std::string check() {
    for (std::size_t s = 0; s < passages_.size(); ++s) {
      for (std::size_t t = 0; t < passages_.size(); ++t) {
        if (passages_[t].from == passages_[s].to && passages_[t].number != (passages_[s].number ^ 1U))
          check_chain(s, t);
      }
    }
    for (std::size_t t = 0; t < pieces_.size(); t += 2) {
      for (const std::size_t here : pieces_[t]) {
        for (const std::size_t there : pieces_[t + 1]) check_limits(here, there);
      }
    }
    for (std::size_t chart = 0; chart < gluing_.charts.size(); ++chart) check_cores(chart);
    return std::to_string(gluing_.charts.size()) + " charts, " + std::to_string(gluing_.transitions.size()) +
           " transitions, in " + std::to_string(cells_) + " cells";
  }

 private:
  /// A transition that does what a chain does, in some of its pieces.
  struct Match {
    std::vector<std::size_t> same, other;
  };

  /// Where s and then t are defined, so is a transition that does the same.
  void check_chain(std::size_t s, std::size_t t) {
    const Passage &first = passages_[s], &second = passages_[t];
    const auto both_maps = composed_pieces({first.map, first.region}, {second.map, second.region});
    if (!both_maps) throw std::logic_error("functions with inverses cannot be composed");
    const MapPiece& whole = *both_maps;
    if (!may_be_positive_together(whole.nonnegative)) return;
    if (first.from == second.to && whole.map == identity_map(gluing_.m)) return;
    std::vector<Match> matches;
    for (const std::vector<std::size_t>& pieces : pieces_) {
      if (passages_[pieces[0]].from != first.from || passages_[pieces[0]].to != second.to) continue;
      Match match;
      for (const std::size_t r : pieces) {
        std::vector<Polynomial> region = whole.nonnegative;
        region.insert(region.end(), passages_[r].region.begin(), passages_[r].region.end());
        if (may_be_positive_together(region)) (passages_[r].map == whole.map ? match.same : match.other).push_back(r);
      }
      if (match.same.empty()) continue;
      if (match.other.empty() && passages_[pieces[0]].positive.empty()) return;
      matches.push_back(match);
    }
    std::vector<Polynomial> positive = first.positive;
    for (const Polynomial& condition : signs_after(second.positive, first.map)) positive.push_back(condition);
    const Passage chain(gluing_.m, first.from, second.to, *second.box, whole, positive, {}, std::nullopt);
    PassageValues both(chain);
    const auto fits = [&](const Match& match, const Cell& cell) {
      return std::all_of(match.same.begin(), match.same.end(),
                         [&](std::size_t r) {
                           const OnCell found = values_[r].on(cell);
                           return found.positive == Verdict::proved || found.here == Verdict::refuted;
                         }) &&
             std::all_of(match.other.begin(), match.other.end(),
                         [&](std::size_t r) { return values_[r].on(cell).here == Verdict::refuted; });
    };
    const auto cannot_fit = [&](const Match& match, const Cell& cell) {
      return std::all_of(match.same.begin(), match.same.end(), [&](std::size_t r) {
        const OnCell found = values_[r].on(cell);
        return found.positive == Verdict::refuted || found.here == Verdict::refuted;
      });
    };
    const auto is_defined_at = [&](const Cell& point) {
      const OnCell there = values_[s].on(point);
      if (!there.regular || !is_inside_open(there.image, *first.box)) return false;
      const OnCell beyond = values_[t].on(there.image);
      return beyond.regular && is_inside_open(beyond.image, *second.box);
    };
    const auto state = [&](const Cell& cell) {
      ++cells_;
      const OnCell there = values_[s].on(cell);
      if (there.excluded || both.on(cell).excluded) return CellState::settled;
      if (std::any_of(matches.begin(), matches.end(), [&](const Match& match) { return fits(match, cell); }))
        return CellState::settled;
      if (there.has_image && values_[t].on(there.image).excluded) return CellState::settled;
      const Cell middle = middle_of(cell);
      // In the interior of the region, so that what is another function there is another one nearby.
      const bool none_there =
          std::all_of(matches.begin(), matches.end(), [&](const Match& match) { return cannot_fit(match, middle); }) &&
          is_strictly_in(whole.nonnegative, middle);
      return none_there && is_inside_open(middle, gluing_.charts[first.from].domain) && is_defined_at(middle)
                 ? CellState::broken
                 : CellState::open;
    };
    settle("atlas.cocycle",
           "transitions " + std::to_string(first.number / 2) + " and " + std::to_string(second.number / 2) +
               " do, one after the other, what none does",
           first.from, state);
  }

  bool is_strictly_in(const std::vector<Polynomial>& region, const Cell& point) const {
    const FormulaMap borders = formulas_of(gluing_.m, region);
    FormulaValues<Interval> values(borders);
    const Cell found = enclosed_values(values, point);
    Verdict result = Verdict::proved;
    for (std::size_t k = 0; k < region.size(); ++k) result = conjunction(result, less(Interval(0), found[k]));
    return result == Verdict::proved;
  }

  /// Cells about which points that are glued may come apart in the limit.
  Division doubtful(std::size_t t) {
    return divided(cell_of(gluing_.charts[passages_[t].from].domain), most_halvings_of_domain, true,
                   [&](const Cell& cell) {
                     ++cells_;
                     const OnCell found = values_[t].on(cell);
                     return found.regular || found.excluded ? CellState::settled : CellState::open;
                   });
  }
  /// Whether D y = N has no solution with N/D the passage on the one cell and y in the other.
  bool are_unrelated(std::size_t t, const Cell& here, const Cell& there) {
    const OnCell found = values_[t].on(here);
    if (found.here == Verdict::refuted) return true;
    for (std::size_t k = 0; k < gluing_.m; ++k) {
      const Interval rest = found.denominators[k] * there[k] - found.numerators[k];
      if (rest.lower() > 0 || rest.upper() < 0) return true;
    }
    return false;
  }
  void check_limits(std::size_t t, std::size_t back) {
    const Division here = doubtful(t);
    if (here.left.empty()) return;
    const Division there = doubtful(back);
    for (const Cell& one : here.left) {
      for (const Cell& other : there.left) {
        if (are_unrelated(t, one, other) || are_unrelated(back, other, one)) continue;
        return report_.reject("atlas.hausdorff", [&, s = &one, e = &other] {
          return "limits of points that are glued by transition " + std::to_string(passages_[t].number / 2) +
                 " are not certainly glued, " + place_of(passages_[t].from, *s) + " and " +
                 place_of(passages_[t].to, *e);
        });
      }
    }
  }

  void check_cores(std::size_t chart) {
    const Gluing::Chart& here = gluing_.charts[chart];
    /// Whether the point is certainly in no core, or the cell in one.
    const auto is_covered = [&](const Cell& cell, bool certainly_not) {
      bool result = certainly_not ? is_outside(cell, here.core) : is_inside_closed(cell, here.core);
      for (const std::vector<std::size_t>& pieces : pieces_) {
        if (passages_[pieces[0]].from != chart) continue;
        const Sides& core = gluing_.charts[passages_[pieces[0]].to].core;
        bool all = true;
        for (const std::size_t t : pieces) {
          const OnCell found = values_[t].on(cell);
          all = all && (certainly_not
                            ? found.excluded || (found.has_image && is_outside(found.image, core))
                            : found.here == Verdict::refuted || (found.regular && is_inside_closed(found.image, core)));
        }
        result = certainly_not ? result && all : result || all;
      }
      return result;
    };
    settle("atlas.compact", "no core holds a point", chart, [&](const Cell& cell) {
      ++cells_;
      if (is_covered(cell, false)) return CellState::settled;
      const Cell middle = middle_of(cell);
      return is_inside_open(middle, here.domain) && is_covered(middle, true) ? CellState::broken : CellState::open;
    });
  }

  void settle(const char* rule, const std::string& what, std::size_t chart,
              const std::function<CellState(const Cell&)>& state) {
    const Division division = divided(cell_of(gluing_.charts[chart].domain), most_halvings_of_domain, false, state);
    if (division.left.empty()) return;
    const std::string text = what + ", " + place_of(chart, division.left.front());
    if (!division.broken) throw Undecided(std::string(rule) + ": whether " + text);
    report_.reject(rule, [&] { return text; });
  }

  const Gluing& gluing_;
  const std::vector<Passage>& passages_;
  std::vector<std::vector<std::size_t>> pieces_;  // by number
  Report& report_;
  std::vector<PassageValues> values_;
  std::size_t cells_ = 0;
};

}  // namespace

std::string check_gluing(const Gluing& gluing, const std::vector<Passage>& passages, Report& report) {
  return GluingChecker(gluing, passages, report).check();
}

}  // namespace delcert::checker
