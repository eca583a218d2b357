#include "kernel/manifold/gluing/gluing_check.hpp"

#include <deque>
#include <functional>
#include <stdexcept>
#include <utility>

#include "kernel/formula/map_piece.hpp"
#include "kernel/manifold/gluing/piecewise_cells.hpp"
#include "kernel/number/decimal_bounds.hpp"
#include "kernel/number/rounding_guard.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

constexpr std::size_t most_cells = 1U << 18;
constexpr std::size_t most_large_cells = 1U << 11;
/// How often a side is halved.
constexpr std::size_t most_halvings = 12;

/// Where a rule fails, or is not decided.
struct Complaint {
  std::string rule;
  std::string what;
  bool is_certain = false;
  std::vector<std::pair<std::size_t, Cell>> places;  // a chart and a cell of it
};

/// What is known of a cell: nothing is left to do, the rule certainly fails, or it is to be divided.
enum class CellState { settled, wrong, open };

/// Halved across its longest side, relative to the whole: side after side.
std::pair<Cell, Cell> halves(const Cell& cell, std::size_t axis) {
  const double middle = cell[axis].lower() / 2 + cell[axis].upper() / 2;
  std::pair<Cell, Cell> result{cell, cell};
  result.first[axis] = Interval::between(cell[axis].lower(), middle);
  result.second[axis] = Interval::between(middle, cell[axis].upper());
  return result;
}

struct Leaf {
  Cell cell;
  CellState state;
};

/// Divides until every cell is settled. Returns the cells that are not, as small as they get; the first of them only,
/// if `all` is false; what is wrong at once and alone. Counts cells, and gives up, with the one at hand, if there are
/// too many.
std::vector<Leaf> unsettled(const Cell& whole, std::size_t m, bool all, std::size_t& count,
                            const std::function<CellState(const Cell&)>& state_of) {
  struct Entry {
    Cell cell;
    std::size_t depth;
  };
  std::vector<Leaf> result;
  std::deque<Entry> waiting{{whole, 0}};
  std::size_t looked_at = 0;
  while (!waiting.empty()) {
    // First the large ones, among which something wrong is found soon; then what remains of one after the other.
    const bool is_early = looked_at < most_large_cells;
    const Entry entry = is_early ? waiting.front() : waiting.back();
    if (is_early) {
      waiting.pop_front();
    } else {
      waiting.pop_back();
    }
    ++count;
    const CellState state = state_of(entry.cell);
    if (state == CellState::settled) continue;
    if (state == CellState::wrong) return {{entry.cell, state}};
    const bool is_last = ++looked_at >= most_cells;
    if (is_last || entry.depth == most_halvings * m) {
      result.push_back({entry.cell, state});
      if (is_last || !all) return result;
      continue;
    }
    const auto [one, other] = halves(entry.cell, entry.depth % m);
    waiting.push_back({other, entry.depth + 1});
    waiting.push_back({one, entry.depth + 1});
  }
  return result;
}

/// A listed transition that is the same function as a chain, in these pieces of it; in others it is another function.
struct Fitting {
  std::size_t transition;
  std::vector<std::size_t> same;
  std::vector<std::size_t> other;
};

/// One chain of two transitions, s and then t, on one piece of its region, and the listed ones that are the same
/// function somewhere there.
struct Chain {
  std::size_t first;
  std::size_t second;
  CellMap composed_map;
  std::vector<Fitting> fitting;
};

class GluingCheck {
 public:
  explicit GluingCheck(const ChartGluing& gluing)
      : gluing_(gluing), transitions_(gluing.transitions()), m_(gluing.dimension()) {}

  /// What is exact: to be done in rounding to nearest.
  void list_chains() {
    for (std::size_t s = 0; s < transitions_.size(); ++s) {
      for (std::size_t t = 0; t < transitions_.size(); ++t) {
        if (transitions_[t].from == transitions_[s].to && t != ChartGluing::opposite(s)) list_chain(s, t);
      }
    }
  }

  std::optional<Complaint> run() {
    for (const auto& transition : transitions_) evaluations_.emplace_back(transition.pieces);
    for (const Chain& chain : chains_) {
      if (auto complaint = check_chain(chain)) return complaint;
    }
    for (std::size_t t = 0; t < transitions_.size(); t += 2) {
      if (auto complaint = check_limits(t)) return complaint;
    }
    for (std::size_t chart = 0; chart < gluing_.chart_count(); ++chart) {
      if (auto complaint = check_cores(chart)) return complaint;
    }
    return std::nullopt;
  }

  [[nodiscard]] const GluingReport& report() const { return report_; }

 private:
  void list_chain(std::size_t s, std::size_t t) {
    for (const CellMap& first : transitions_[s].pieces) {
      for (const CellMap& second : transitions_[t].pieces) list_chain(s, first, t, second);
    }
  }

  /// A piece of the one and then a piece of the other.
  void list_chain(std::size_t s, const CellMap& first, std::size_t t, const CellMap& second) {
    auto pieces = composed({{second.nonnegative(), second.map()}}, {{first.nonnegative(), first.map()}});
    // Rational functions with an inverse can be composed.
    if (!pieces) throw std::logic_error("a composition of transitions is nowhere defined");
    if (pieces->empty()) return;
    MapPiece& both = pieces->front();
    const std::size_t from = transitions_[s].from;
    const std::size_t to = transitions_[t].to;
    if (from == to && is_identity(both.map)) return;
    std::vector<Fitting> fitting;
    for (std::size_t r = 0; r < transitions_.size(); ++r) {
      if (transitions_[r].from != from || transitions_[r].to != to) continue;
      Fitting found = compared(r, both);
      if (found.same.empty()) continue;
      if (found.other.empty() && transitions_[r].pieces.front().positive().empty()) return;
      fitting.push_back(std::move(found));
    }
    std::vector<Polynomial> positive = first.positive();
    for (const Polynomial& p : second.positive()) positive.push_back(sign_after(p, first.map()));
    chains_.push_back(
        {s, t,
         CellMap(std::move(both.map), second.box(), std::move(positive), {}, std::nullopt, std::move(both.nonnegative)),
         std::move(fitting)});
  }

  /// The pieces of a transition that may meet the region of a piece in its interior.
  [[nodiscard]] Fitting compared(std::size_t r, const MapPiece& both) const {
    Fitting result{r, {}, {}};
    for (std::size_t k = 0; k < transitions_[r].pieces.size(); ++k) {
      const CellMap& piece = transitions_[r].pieces[k];
      std::vector<Polynomial> region = both.nonnegative;
      region.insert(region.end(), piece.nonnegative().begin(), piece.nonnegative().end());
      if (may_be_positive_together(region)) (are_same(piece.map(), both.map) ? result.same : result.other).push_back(k);
    }
    return result;
  }

  [[nodiscard]] Cell whole_of(std::size_t chart) const { return cell_around(gluing_.chart(chart).domain); }

  std::optional<Complaint> check_chain(const Chain& chain) {
    const auto& s = transitions_[chain.first];
    const auto& t = transitions_[chain.second];
    CellMapEvaluation both(chain.composed_map);
    const auto state_of = [&](const Cell& cell) {
      const MapOnCell on_first = evaluations_[chain.first].on(cell);
      if (on_first.is_excluded) return CellState::settled;
      const MapOnCell on_both = both.on(cell);
      if (on_both.is_excluded) return CellState::settled;
      bool may_fit = false;
      for (const Fitting& fitting : chain.fitting) {
        PiecewiseCells& listed = evaluations_[fitting.transition];
        bool fits = true;
        for (const std::size_t piece : fitting.same) {
          const MapOnCell found = listed.on(piece, cell);
          fits = fits && (found.is_positive || found.is_elsewhere);
          may_fit = may_fit || !found.is_excluded;
        }
        for (const std::size_t piece : fitting.other) fits = fits && listed.on(piece, cell).is_elsewhere;
        if (fits) return CellState::settled;
      }
      if (!on_first.has_image) return CellState::open;
      const MapOnCell on_second = evaluations_[chain.second].on(on_first.image);
      if (on_second.is_excluded) return CellState::settled;
      const bool is_defined = on_both.is_here && on_first.is_regular &&
                              is_inside(on_first.image, s.pieces.front().box()) && on_second.is_regular &&
                              is_inside(on_second.image, t.pieces.front().box());
      return is_defined && !may_fit ? CellState::wrong : CellState::open;
    };
    const auto left = unsettled(whole_of(s.from), m_, false, report_.cocycle_cells, state_of);
    if (left.empty()) return std::nullopt;
    const bool is_wrong = left.front().state == CellState::wrong;
    return Complaint{"atlas.cocycle",
                     s.name + ", then " + t.name + ": " +
                         (is_wrong ? "no transition does the same" : "that a transition does the same is not certain"),
                     is_wrong,
                     {{s.from, left.front().cell}}};
  }

  /// The cells on which points that are glued might come apart in the limit.
  std::vector<Leaf> doubtful_cells(std::size_t t) {
    return unsettled(whole_of(transitions_[t].from), m_, true, report_.hausdorff_cells,
                     [&](const Cell& cell) { return state_of_limits(t, cell); });
  }
  CellState state_of_limits(std::size_t t, const Cell& cell) {
    const MapOnCell found = evaluations_[t].on(cell);
    return found.is_regular || found.is_excluded ? CellState::settled : CellState::open;
  }

  std::optional<Complaint> check_limits(std::size_t t) {
    const std::size_t back = ChartGluing::opposite(t);
    const auto here = doubtful_cells(t);
    if (here.empty()) return std::nullopt;
    const auto there = doubtful_cells(back);
    std::size_t pairs = 0;
    for (const Leaf& one : here) {
      for (const Leaf& other : there) {
        if (++pairs < most_cells && (evaluations_[t].are_unrelated(one.cell, other.cell) ||
                                     evaluations_[back].are_unrelated(other.cell, one.cell)))
          continue;
        return Complaint{"atlas.hausdorff",
                         transitions_[t].name + ": that limits of glued points are glued is not certain",
                         false,
                         {{transitions_[t].from, one.cell}, {transitions_[t].to, other.cell}}};
      }
    }
    return std::nullopt;
  }

  std::optional<Complaint> check_cores(std::size_t chart) {
    const Sides& core = gluing_.chart(chart).core;
    const auto state_of = [&](const Cell& cell) {
      if (is_inside(cell, core)) return CellState::settled;
      bool is_wrong = is_outside(cell, core);
      for (std::size_t t = 0; t < transitions_.size(); ++t) {
        if (transitions_[t].from != chart) continue;
        const MapOnCell found = evaluations_[t].on(cell);
        const Sides& other = gluing_.chart(transitions_[t].to).core;
        if (found.is_regular && is_inside(found.image, other)) return CellState::settled;
        is_wrong = is_wrong && (found.is_excluded || (found.has_image && is_outside(found.image, other)));
      }
      return is_wrong ? CellState::wrong : CellState::open;
    };
    const auto left = unsettled(whole_of(chart), m_, false, report_.compact_cells, state_of);
    if (left.empty()) return std::nullopt;
    const bool is_wrong = left.front().state == CellState::wrong;
    return Complaint{"atlas.compact",
                     is_wrong ? "no core holds these points" : "that a core holds these points is not certain",
                     is_wrong,
                     {{chart, left.front().cell}}};
  }

  const ChartGluing& gluing_;
  const std::vector<ChartGluing::Transition>& transitions_;
  std::size_t m_;
  std::vector<Chain> chains_;
  std::vector<PiecewiseCells> evaluations_;
  GluingReport report_;
};

std::string place_in_words(const ChartGluing& gluing, std::size_t chart, const Cell& cell) {
  std::string result = "chart " + gluing.chart(chart).name;
  for (std::size_t axis = 0; axis < gluing.dimension(); ++axis)
    result += (axis == 0 ? ": " : ", ") + gluing.chart(chart).variables[axis] + " in [" +
              decimal_lower(Rational::exactly(cell[axis].lower()), 6) + ", " +
              decimal_upper(Rational::exactly(cell[axis].upper()), 6) + "]";
  return result;
}

}  // namespace

GluingReport check_gluing(const ChartGluing& gluing) {
  GluingCheck check(gluing);
  try {
    check.list_chains();
  } catch (const std::length_error& error) {
    throw InputError(gluing.description().name +
                     ": atlas.cocycle: two transitions, one after the other: " + error.what());
  }
  const auto complaint = [&] {
    const RoundingGuard guard;
    return check.run();
  }();
  if (!complaint) return check.report();
  std::string message = gluing.description().name + ": " + complaint->rule + ": " + complaint->what;
  for (const auto& [chart, cell] : complaint->places) message += "; " + place_in_words(gluing, chart, cell);
  if (complaint->is_certain) throw Rejection(message);
  throw Undecided(message);
}

}  // namespace delcert
