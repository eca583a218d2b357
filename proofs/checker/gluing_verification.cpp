#include "proofs/checker/gluing_verification.hpp"

#include <algorithm>

namespace delcert::checker {
namespace {

constexpr std::size_t most_halvings = 12;

std::string place_of(std::size_t chart, const Cell& cell) {
  std::string text = "chart " + std::to_string(chart) + " about (";
  for (std::size_t k = 0; k < cell.size(); ++k) text += (k == 0 ? "" : ", ") + about(cell[k]);
  return text + ")";
}

class GluingChecker {
 public:
  GluingChecker(const Gluing& gluing, const std::vector<Passage>& passages, Report& report)
      : gluing_(gluing), passages_(passages), report_(report) {
    for (const Passage& passage : passages) values_.emplace_back(passage);
  }

  std::string check() {
    for (std::size_t s = 0; s < passages_.size(); ++s) {
      for (std::size_t t = 0; t < passages_.size(); ++t) {
        if (passages_[t].from == passages_[s].to && t != (s ^ 1U)) check_chain(s, t);
      }
    }
    for (std::size_t t = 0; t < passages_.size(); t += 2) check_limits(t);
    for (std::size_t chart = 0; chart < gluing_.charts.size(); ++chart) check_cores(chart);
    return std::to_string(gluing_.charts.size()) + " charts, " + std::to_string(gluing_.transitions.size()) +
           " transitions, in " + std::to_string(cells_) + " cells";
  }

 private:
  /// Where s and then t are defined, so is a passage that does the same.
  void check_chain(std::size_t s, std::size_t t) {
    const Passage &first = passages_[s], &second = passages_[t];
    const auto map = composed(*second.written, first.map);
    const auto conditions = composed(second.conditions, first.map);
    if (!map || !conditions) throw std::logic_error("functions with inverses cannot be composed");
    if (first.from == second.to && *map == identity_map(gluing_.m)) return;
    std::vector<PassageValues*> same;
    for (std::size_t r = 0; r < passages_.size(); ++r) {
      if (passages_[r].from != first.from || passages_[r].to != second.to || !(passages_[r].map == *map)) continue;
      if (passages_[r].positive.empty()) return;
      same.push_back(&values_[r]);
    }
    std::vector<Polynomial> positive = first.positive;
    for (const RationalFunction& condition : *conditions) positive.push_back(condition.sign());
    const Passage chain(gluing_.m, first.from, second.to, *second.box, *map, positive, {}, nullptr);
    PassageValues both(chain);
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
      for (PassageValues* r : same) {
        if (r->on(cell).positive == Verdict::proved) return CellState::settled;
      }
      if (there.has_image && values_[t].on(there.image).excluded) return CellState::settled;
      const Cell middle = middle_of(cell);
      const bool none_there = std::all_of(same.begin(), same.end(),
                                          [&](PassageValues* r) { return r->on(middle).positive == Verdict::refuted; });
      return none_there && is_inside_open(middle, gluing_.charts[first.from].domain) && is_defined_at(middle)
                 ? CellState::broken
                 : CellState::open;
    };
    settle("atlas.cocycle",
           "transitions " + std::to_string(s / 2) + " and " + std::to_string(t / 2) +
               " do, one after the other, what none does",
           first.from, state);
  }

  /// Cells about which points that are glued may come apart in the limit.
  Division doubtful(std::size_t t) {
    return divided(cell_of(gluing_.charts[passages_[t].from].domain), most_halvings, true, [&](const Cell& cell) {
      ++cells_;
      const OnCell found = values_[t].on(cell);
      return found.regular || found.excluded ? CellState::settled : CellState::open;
    });
  }
  /// Whether D y = N has no solution with N/D the passage on the one cell and y in the other.
  bool are_unrelated(std::size_t t, const Cell& here, const Cell& there) {
    const OnCell found = values_[t].on(here);
    for (std::size_t k = 0; k < gluing_.m; ++k) {
      const Interval rest = found.denominators[k] * there[k] - found.numerators[k];
      if (rest.lower() > 0 || rest.upper() < 0) return true;
    }
    return false;
  }
  void check_limits(std::size_t t) {
    const Division here = doubtful(t);
    if (here.left.empty()) return;
    const Division there = doubtful(t + 1);
    for (const Cell& one : here.left) {
      for (const Cell& other : there.left) {
        if (are_unrelated(t, one, other) || are_unrelated(t + 1, other, one)) continue;
        return report_.reject("atlas.hausdorff", [&, s = &one, e = &other] {
          return "limits of points that are glued by transition " + std::to_string(t / 2) +
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
      for (std::size_t t = 0; t < passages_.size(); ++t) {
        if (passages_[t].from != chart) continue;
        const OnCell found = values_[t].on(cell);
        const Sides& core = gluing_.charts[passages_[t].to].core;
        if (certainly_not) {
          result = result && (found.excluded || (found.has_image && is_outside(found.image, core)));
        } else {
          result = result || (found.regular && is_inside_closed(found.image, core));
        }
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
    const Division division = divided(cell_of(gluing_.charts[chart].domain), most_halvings, false, state);
    if (division.left.empty()) return;
    const std::string text = what + ", " + place_of(chart, division.left.front());
    if (!division.broken) throw Undecided(std::string(rule) + ": whether " + text);
    report_.reject(rule, [&] { return text; });
  }

  const Gluing& gluing_;
  const std::vector<Passage>& passages_;
  Report& report_;
  std::vector<PassageValues> values_;
  std::size_t cells_ = 0;
};

}  // namespace

std::string check_gluing(const Gluing& gluing, const std::vector<Passage>& passages, Report& report) {
  return GluingChecker(gluing, passages, report).check();
}

}  // namespace delcert::checker
