#include "proofs/prover/search.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>

namespace delcert {

namespace {

/// A factor on a box: its sign if that is strict, which holds for all parts, or its coefficients.
struct FactorState {
  Sign sign = Sign::unknown;
  std::shared_ptr<const BernsteinTensor> tensor;  ///< nullptr where the sign is strict, or there are too many
};

struct OpenBox {
  Box box;
  std::vector<FactorState> factors;
  std::vector<Verdict> verdicts;  ///< of comparisons; decided ones stay decided
  std::vector<std::size_t> cuts;  ///< how often each side has been cut
  std::size_t node = 0;
};

std::vector<OpenEnds> open_ends(const Box& box) {
  std::vector<OpenEnds> result;
  for (const BoxSide& side : box) result.push_back(side.unit_open());
  // The ring of constants has a variable of its own.
  if (result.empty()) result.emplace_back();
  return result;
}

class Search {
 public:
  Search(Goal& goal, const DecideAt& decide_at, const SearchLimits& limits)
      : goal_(goal), decide_at_(decide_at), limits_(limits) {}

  /// Depth first, so that there are few boxes at a time; but not to the bottom of the first place that resists while
  /// there may be a counterexample elsewhere.
  SearchResult run() {
    for (const std::size_t cuts : {std::size_t{3}, std::size_t{9}}) {
      if (cuts >= limits_.cuts_of_a_side) break;
      cuts_of_a_side_ = cuts;
      most_left_ = limits_.boxes;
      SearchResult found = run_once();
      if (!is_undecided(found.verdict)) return found;
    }
    cuts_of_a_side_ = limits_.cuts_of_a_side;
    most_left_ = limits_.left;
    return run_once();
  }

 private:
  SearchResult run_once() {
    const std::size_t boxes_before = result_.boxes;
    result_ = SearchResult();
    result_.boxes = boxes_before;
    std::vector<OpenBox> waiting;
    for (const Box& box : boxes_of(goal_.ranges, goal_.is_squared)) {
      result_.roots.push_back(new_node());
      waiting.push_back(whole(box, result_.roots.back()));
    }
    std::reverse(waiting.begin(), waiting.end());
    while (!waiting.empty()) {
      OpenBox here = std::move(waiting.back());
      waiting.pop_back();
      ++result_.boxes;
      decide(here);
      const Verdict verdict = goal_.value(here.verdicts);
      if (is_proved(verdict)) continue;
      if (is_counterexample_in(here)) return finished(Verdict::refuted);
      if (is_point(here.box) && is_proved(decide_at_(simplest_point(here.box)))) {
        result_.nodes[here.node].is_exact = true;
        continue;
      }
      const auto side = side_to_cut(here);
      if (!side || result_.boxes >= limits_.boxes) {
        result_.left.push_back(here.box);
        if (result_.left.size() < most_left_ && result_.boxes < limits_.boxes) continue;
        for (auto next = waiting.rbegin(); next != waiting.rend(); ++next) result_.left.push_back(next->box);
        result_.left.resize(std::min(result_.left.size(), limits_.left));
        return finished(Verdict::undecided);
      }
      cut_in_two(std::move(here), *side, waiting);
    }
    return finished(result_.left.empty() ? Verdict::proved : Verdict::undecided);
  }

  OpenBox whole(const Box& box, std::size_t node) {
    OpenBox result;
    result.box = box;
    result.verdicts.assign(goal_.atoms.size(), Verdict::undecided);
    result.cuts.assign(box.size(), 0);
    result.node = node;
    std::vector<UnitMap> maps;
    for (const BoxSide& side : box) maps.push_back(side.map);
    if (maps.empty()) maps.push_back({Rational(0), Rational(0)});
    for (const Polynomial& factor : goal_.factors) {
      FactorState state;
      try {
        state.tensor = std::make_shared<const BernsteinTensor>(factor, maps, limits_.coefficients);
      } catch (const std::length_error&) {
        // Its sign remains unknown.
      }
      result.factors.push_back(std::move(state));
    }
    return result;
  }

  void decide(OpenBox& here) {
    const auto open = open_ends(here.box);
    for (FactorState& factor : here.factors) {
      if (!factor.tensor) continue;
      factor.sign = factor.tensor->sign(open);
      if (is_strict(factor.sign)) factor.tensor.reset();
    }
    std::optional<ParameterBox> box;
    for (std::size_t i = 0; i < goal_.atoms.size(); ++i) {
      if (!is_undecided(here.verdicts[i])) continue;
      const Atom& atom = goal_.atoms[i];
      if (atom.polynomial) {
        here.verdicts[i] = verdict_of(atom.relation, sign_of(*atom.polynomial, here.factors));
        continue;
      }
      if (!box) box = parameter_box(here.box, enclosure_precision);
      if (atom.is_about_definedness) {
        goal_.tape.evaluate(*box);
        here.verdicts[i] = goal_.tape.value(atom.enclosure) ? Verdict::proved : Verdict::undecided;
      } else {
        here.verdicts[i] = verdict_of(atom.relation, goal_.tape.sign(atom.enclosure, *box));
      }
    }
  }

  static Sign sign_of(const PolynomialForm& form, const std::vector<FactorState>& factors) {
    for (const std::size_t divisor : form.divisors) {
      if (!is_strict(factors[divisor].sign)) return Sign::unknown;
    }
    if (form.constant == Rational(0)) return Sign::zero;
    Sign result = form.constant < Rational(0) ? Sign::negative : Sign::positive;
    for (const auto& power : form.powers) {
      const Sign sign = factors[power.factor].sign;
      result = product(result, power.exponent % 2 != 0 ? sign : even_power(sign));
    }
    return result;
  }

  std::size_t new_node() {
    result_.nodes.emplace_back();
    return result_.nodes.size() - 1;
  }

  SearchResult finished(Verdict verdict) {
    result_.verdict = verdict;
    return std::move(result_);
  }

  static bool is_point(const Box& box) {
    return std::all_of(box.begin(), box.end(), [](const BoxSide& side) { return side.is_point(); });
  }

  static std::vector<Rational> simplest_point(const Box& box) {
    std::vector<Rational> result;
    for (const BoxSide& side : box) result.push_back(simplest_in(side));
    return result;
  }

  bool refutes(const std::vector<Rational>& point) {
    if (!is_refuted(decide_at_(point))) return false;
    result_.counterexample = point;
    return true;
  }

  /// Looks at the simplest point of a box, and at the corners that belong to it while there are few boxes.
  bool is_counterexample_in(const OpenBox& here) {
    constexpr std::size_t many = 3000;
    constexpr std::size_t few = 64;
    if (result_.boxes > many && result_.boxes % 8 != 0) return false;
    if (refutes(simplest_point(here.box))) return true;
    if (result_.boxes > few) return false;
    for (std::size_t corner = 0; corner < std::size_t{1} << std::min<std::size_t>(here.box.size(), 6); ++corner) {
      for (const long far : {10L, 58L, 200L}) {
        std::vector<Rational> point;
        bool is_far = false;
        for (std::size_t i = 0; i < here.box.size(); ++i) {
          point.push_back(near_end(here.box[i], (corner >> i & 1U) != 0, far, is_far));
        }
        if (refutes(point)) return true;
        if (!is_far) break;
      }
    }
    return false;
  }

  /// The end of a side, or a number of it near the end.
  static Rational near_end(const BoxSide& side, bool upper, long far, bool& is_far) {
    const Rational inside = simplest_in(side);
    const auto& end = upper ? side.upper : side.lower;
    const bool open = upper ? side.open.upper : side.open.lower;
    if (end && !open) return *end;
    is_far = true;
    if (end) return *end + (inside - *end) * Rational::power_of_two(-far);
    return upper ? inside + Rational::power_of_two(far) : inside - Rational::power_of_two(far);
  }

  /// The side along which what is undecided varies most; nothing if none may be cut further.
  std::optional<std::size_t> side_to_cut(const OpenBox& here) {
    std::optional<std::size_t> best;
    double best_score = -1;
    for (std::size_t side = 0; side < here.box.size(); ++side) {
      if (here.box[side].is_point() || here.cuts[side] >= cuts_of_a_side_) continue;
      const double score = score_of(here, side);
      if (score > best_score) {
        best_score = score;
        best = side;
      }
    }
    return best;
  }

  double score_of(const OpenBox& here, std::size_t side) {
    double score = 0;
    for (std::size_t i = 0; i < goal_.atoms.size(); ++i) {
      if (!is_undecided(here.verdicts[i])) continue;
      const Atom& atom = goal_.atoms[i];
      if (atom.polynomial) {
        const auto add = [&](std::size_t factor) {
          const auto& tensor = here.factors[factor].tensor;
          if (tensor) score = std::max(score, tensor->approximate_variation(side));
        };
        for (const auto& power : atom.polynomial->powers) add(power.factor);
        for (const std::size_t divisor : atom.polynomial->divisors) add(divisor);
      } else {
        score = std::max(score, reduction(here, atom.enclosure, side));
      }
    }
    // Of sides that are as good, the one that is widest; and none is forgotten for ever.
    const double fraction = std::exp2(-static_cast<double>(here.cuts[side]));
    return score * std::sqrt(fraction) + fraction / 1024;
  }

  /// How much narrower an enclosure gets when one side shrinks to a point in it, between 0 and 1.
  double reduction(const OpenBox& here, std::size_t term, std::size_t side) {
    ParameterBox box = parameter_box(here.box, enclosure_precision);
    goal_.tape.evaluate(box);
    const auto& before = goal_.tape.value(term);
    const double width = before ? before->approximate_width() : HUGE_VAL;
    box[side] = ExtendedInterval(simplest_in(here.box[side]), enclosure_precision);
    goal_.tape.evaluate(box);
    const auto& after = goal_.tape.value(term);
    const double rest = after ? after->approximate_width() : HUGE_VAL;
    if (std::isinf(width)) return std::isinf(rest) ? 0 : 1;
    return width > 0 ? std::clamp(1 - rest / width, 0.0, 1.0) : 0;
  }

  void cut_in_two(OpenBox here, std::size_t side, std::vector<OpenBox>& waiting) {
    const BoxCut where = middle_cut(here.box, side);
    const CutBox parts = cut(here.box, where);
    ++here.cuts[side];
    const Rational begin = here.box[side].unit_lower;
    const Rational width = here.box[side].unit_upper - begin;
    const Rational lower_ends = (parts.lower_part_ends - begin) / width;
    const Rational upper_begins = (parts.upper_part_begins - begin) / width;
    const std::size_t lower = new_node();
    const std::size_t upper = new_node();
    result_.nodes[here.node].cut = where;
    result_.nodes[here.node].lower = lower;
    result_.nodes[here.node].upper = upper;
    OpenBox other = here;
    other.box = parts.upper;
    other.node = upper;
    for (FactorState& factor : other.factors) {
      if (factor.tensor) {
        factor.tensor = std::make_shared<const BernsteinTensor>(factor.tensor->right_of(side, upper_begins));
      }
    }
    waiting.push_back(std::move(other));
    here.box = parts.lower;
    here.node = lower;
    for (FactorState& factor : here.factors) {
      if (factor.tensor) {
        factor.tensor = std::make_shared<const BernsteinTensor>(factor.tensor->left_of(side, lower_ends));
      }
    }
    waiting.push_back(std::move(here));
  }

  Goal& goal_;
  const DecideAt& decide_at_;
  const SearchLimits& limits_;
  std::size_t cuts_of_a_side_ = 0;
  std::size_t most_left_ = 0;
  SearchResult result_;
};

}  // namespace

SearchResult search(Goal& goal, const DecideAt& decide_at, const SearchLimits& limits) {
  return Search(goal, decide_at, limits).run();
}

}  // namespace delcert
