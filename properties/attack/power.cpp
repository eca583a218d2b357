#include "properties/attack/power.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "kernel/formula/formula_text.hpp"
#include "proofs/formula/decision.hpp"
#include "proofs/formula/substitution.hpp"
#include "properties/attack/directed_search.hpp"
#include "properties/attack/hypothesis_limits.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

constexpr int steps_per_octave = 64;

bool all_hold(const Claim& claim, Scene& scene, std::optional<std::size_t> but_for = std::nullopt) {
  for (std::size_t at = 0; at < claim.hypotheses.size(); ++at) {
    if (at != but_for && !is_proved(decide_statement(*claim.hypotheses[at].formula, scene))) return false;
  }
  return true;
}

/// A lower bound of the ratio. A comparison that has none is refuted (infinity) or of no use (nothing).
std::optional<double> least_ratio(const Expression& statement, Scene& scene) {
  constexpr double sharp_enough = 0x1p-20;
  auto ratio = ratio_bounds(statement, scene, false);
  const bool is_sharp = ratio && ratio->upper - ratio->lower <= sharp_enough * ratio->upper;
  if (!is_sharp) ratio = ratio_bounds(statement, scene, true);
  if (ratio && std::isfinite(ratio->lower)) return ratio->lower;
  if (is_refuted(decide_statement(statement, scene))) return std::numeric_limits<double>::infinity();
  return std::nullopt;
}

/// The least level for which it is true, and which is not below `first`, if it is true from there on and for `last`.
template <class Test>
int least_level(int first, int last, const Test& is_true) {
  while (first < last) {
    const int middle = (first + last) / 2;
    if (is_true(middle)) {
      last = middle;
    } else {
      first = middle + 1;
    }
  }
  return first;
}

/// The conclusion with the place changed by so many steps.
class Changes {
 public:
  Changes(const ExpressionPointer& formula, const Place& place)
      : formula_(formula), place_(place), scaled_(last_power_step + 1) {}
  explicit Changes(const FocusedStatement& focused) : Changes(focused.formula, focused.place) {}

  [[nodiscard]] Rational scale(int level) const {
    const Rational step = power_step(level);
    return place_.stronger_if_smaller ? Rational(1) / step : step;
  }
  [[nodiscard]] const ExpressionPointer& scaled(int level) {
    auto& result = scaled_[static_cast<std::size_t>(level)];
    if (!result) result = level == 0 ? formula_ : with_place_scaled(formula_, place_, scale(level));
    return result;
  }
  [[nodiscard]] const ExpressionPointer& unchanged() const { return formula_; }
  [[nodiscard]] ExpressionPointer deleted() const { return without_place(formula_, place_); }
  [[nodiscard]] const Place& place() const { return place_; }

 private:
  ExpressionPointer formula_;
  Place place_;
  std::vector<ExpressionPointer> scaled_;
};

std::string stream_name(const PowerTarget& target) {
  std::string result = "power " + target.claim.name + (target.place.is_hypothesis ? " hypothesis " : " conclusion ") +
                       std::to_string(target.place.part) + " " + std::to_string(target.conclusion) + " " +
                       std::to_string(target.shape.k) + " " + std::to_string(target.shape.m);
  for (const std::size_t child : target.place.place.path) result += " " + std::to_string(child);
  return result + " " + name_of(target.place.place.kind);
}

class ConclusionPower {
 public:
  explicit ConclusionPower(const PowerTarget& target)
      : target_(target),
        changes_(
            focused(without_definitions(target.claim.conclusions.at(target.place.part).formula), target.place.place)),
        deleted_(changes_.deleted()) {
    const PlaceKind kind = changes_.place().kind;
    can_be_scaled_ = kind != PlaceKind::factor;
    can_be_deleted_ = kind == PlaceKind::factor || (kind == PlaceKind::summand && changes_.place().stronger_if_smaller);
  }

  Power run(std::uint64_t seed, const Progress& progress) {
    const HypothesisLimits limits(target_.claim);
    const DrawScore score = [&](const LimitedDraw& draw, double) {
      ++used_;
      const auto instance = draw(limits);
      return instance ? score_of(instance->bindings) : worthless_score;
    };
    const auto best =
        directed_search(target_.claim, target_.shape, stream_name(target_), score, target_.evaluations, seed, progress);
    Power result;
    result.can_be_deleted = can_be_deleted_;
    result.evaluations = used_;
    result.has_instance = has_instance_;
    const auto instance = best ? best->draw(limits) : std::nullopt;
    if (instance) decide(instance->bindings, result);
    result.is_weaker = !can_be_scaled_ && !result.is_deletion_refuted && has_instance_ && !says_more_;
    return result;
  }

 private:
  [[nodiscard]] bool exceeds(int level, Scene& scene) { return least_ratio(*changes_.scaled(level), scene) > 1.0; }

  double score_of(const Bindings& bindings) {
    Scene scene(bindings);
    if (!all_hold(target_.claim, scene)) return worthless_score;
    has_instance_ = true;
    if (!can_be_scaled_) return score_of_deletion(scene);
    const auto far = least_ratio(*changes_.scaled(last_power_step), scene);
    if (far && *far > 1) {
      const int level = least_level(0, last_power_step, [&](int at) { return exceeds(at, scene); });
      double exact = level;
      if (level > 0) {
        // Between two steps, so that the search sees a slope.
        const auto below = least_ratio(*changes_.scaled(level - 1), scene);
        const auto above = least_ratio(*changes_.scaled(level), scene);
        if (below && above && std::isfinite(*above) && *above > *below) exact -= (*above - 1) / (*above - *below);
      }
      return 2 + (last_power_step - exact) / last_power_step;
    }
    if (!can_be_deleted_) return far ? std::max(0.0, *far) : 0;
    const auto without = least_ratio(*deleted_, scene);
    if (!without) return 0;
    return std::clamp(*without, 0.0, 1.5);
  }

  double score_of_deletion(Scene& scene) {
    constexpr std::uint64_t compared = 400;
    const auto ratio = least_ratio(*deleted_, scene);
    if (!ratio) return 0;
    if (!says_more_ && used_ <= compared) {
      const auto before = ratio_bounds(*changes_.unchanged(), scene, true);
      says_more_ = before && *ratio > before->upper;
    }
    return std::clamp(*ratio, 0.0, 0x1p100);
  }

  void decide(const Bindings& bindings, Power& result) {
    Scene scene(bindings);
    if (!all_hold(target_.claim, scene)) return;
    const auto refutes = [&](const ExpressionPointer& statement) {
      return is_refuted(decide_statement(*statement, scene));
    };
    const auto refutes_scaled = [&](int level) { return refutes(changes_.scaled(level)); };
    if (can_be_deleted_ && refutes(deleted_)) {
      result.is_deletion_refuted = true;
      result.witness = bindings;
      result.changed = formula_text(*deleted_);
    }
    if (!can_be_scaled_ || !refutes_scaled(last_power_step)) return;
    const int level = least_level(0, last_power_step, refutes_scaled);
    // The search by halves takes for granted what the form of the formula suggests.
    if (!refutes_scaled(level)) return;
    result.scale = changes_.scale(level);
    result.witness = bindings;
    result.changed = formula_text(*changes_.scaled(level));
  }

  const PowerTarget& target_;
  Changes changes_;
  ExpressionPointer deleted_;
  bool can_be_scaled_ = true;
  bool can_be_deleted_ = false;
  bool has_instance_ = false;
  bool says_more_ = false;
  std::uint64_t used_ = 0;
};

/// The limits of a claim, one of them scaled.
class ScaledLimits : public Limits {
 public:
  ScaledLimits(const Limits& limits, std::string name, Rational scale)
      : limits_(limits), name_(std::move(name)), scale_(std::move(scale)) {}
  [[nodiscard]] std::optional<Rational> most(const std::string& name, const Bindings& bound,
                                             bool exact) const override {
    auto result = limits_.most(name, bound, exact);
    if (result && name == name_) *result *= scale_;
    return result;
  }

 private:
  const Limits& limits_;
  std::string name_;
  Rational scale_;
};

class HypothesisPower {
 public:
  explicit HypothesisPower(const PowerTarget& target)
      : target_(target),
        limits_(target.claim),
        changes_(without_definitions(target.claim.hypotheses.at(target.place.part).formula), wider(target)),
        name_(bounded_name(*changes_.unchanged())) {}

  Power run(std::uint64_t seed, const Progress& progress) {
    const DrawScore score = [&](const LimitedDraw& draw, double) {
      ++used_;
      const auto level = first_violation(draw);
      return level ? 1 + double(last_power_step - *level) / last_power_step : has_instance_ ? 0.0 : worthless_score;
    };
    const auto best =
        directed_search(target_.claim, target_.shape, stream_name(target_), score, target_.evaluations, seed, progress);
    Power result;
    result.evaluations = used_;
    result.has_instance = has_instance_;
    const auto level = best && best->score >= 1 ? first_violation(best->draw) : std::nullopt;
    const auto instance = level ? drawn(best->draw, *level) : std::nullopt;
    if (!instance || !violates(instance->bindings)) return result;
    Scene scene(instance->bindings);
    const auto is_met = [&](int at) { return is_proved(decide_statement(*changes_.scaled(at), scene)); };
    const int least = least_level(0, last_power_step, is_met);
    if (!is_met(least)) return result;
    result.scale = changes_.scale(least);
    result.witness = instance->bindings;
    result.changed = formula_text(*changes_.scaled(least));
    return result;
  }

 private:
  /// The bound of a hypothesis grows: fewer instances are excluded, and the claim says more.
  static Place wider(const PowerTarget& target) {
    Place result = target.place.place;
    result.stronger_if_smaller = !result.stronger_if_smaller;
    return result;
  }
  static std::string bounded_name(const Expression& comparison) {
    const bool turned = comparison.operation == Operation::greater || comparison.operation == Operation::greater_equal;
    return comparison.children[turned ? 1 : 0]->text;
  }

  [[nodiscard]] std::optional<Instance> drawn(const LimitedDraw& draw, int level) const {
    return draw(ScaledLimits(limits_, name_, power_step(level)));
  }

  /// The hypotheses first: where they fail, the conclusion may ask for what there is not. Where a wider hypothesis lets
  /// in instances of which the claim cannot be asked at all, they violate nothing.
  [[nodiscard]] bool violates(const Bindings& bindings) {
    Scene scene(bindings);
    try {
      return others_hold(scene) &&
             is_refuted(decide_statement(*target_.claim.conclusions[target_.conclusion].formula, scene));
    } catch (const InputError&) {
      return false;
    }
  }

  [[nodiscard]] bool can_be_asked(const Bindings& bindings) {
    Scene scene(bindings);
    try {
      return others_hold(scene);
    } catch (const InputError&) {
      return false;
    }
  }

  [[nodiscard]] bool others_hold(Scene& scene) {
    const bool result = all_hold(target_.claim, scene, target_.place.part);
    has_instance_ = has_instance_ || result;
    return result;
  }

  /// Where on the way the conclusion first fails, if it fails at one of some levels.
  std::optional<int> first_violation(const LimitedDraw& draw) {
    constexpr std::array<int, 7> octaves = {40, 24, 12, 6, 3, 1, 0};
    for (const int octave : octaves) {
      const int last = octave * steps_per_octave;
      const auto instance = drawn(draw, last);
      if (!instance) continue;
      if (violates(instance->bindings)) {
        const auto fails = [&](int level) {
          const auto other = drawn(draw, level);
          return other && violates(other->bindings);
        };
        return least_level(0, last, fails);
      }
      // On the same way, what is nearer violates nothing either.
      if (can_be_asked(instance->bindings)) return std::nullopt;
    }
    return std::nullopt;
  }

  const PowerTarget& target_;
  HypothesisLimits limits_;
  Changes changes_;
  std::string name_;
  bool has_instance_ = false;
  std::uint64_t used_ = 0;
};

}  // namespace

std::vector<PowerPlace> power_places(const Claim& claim) {
  std::vector<PowerPlace> result;
  for (std::size_t part = 0; part < claim.conclusions.size(); ++part) {
    for (Place& place : places_in(*without_definitions(claim.conclusions[part].formula))) {
      result.push_back({false, part, std::move(place)});
    }
  }
  for (std::size_t part = 0; part < claim.hypotheses.size(); ++part) {
    const Hypothesis& hypothesis = claim.hypotheses[part];
    if (!hypothesis.no_twin.empty() || !is_comparison(hypothesis.formula->operation)) continue;
    for (Place& place : places_in(*without_definitions(hypothesis.formula))) {
      // The larger side, where the other is a name.
      const auto& other = *hypothesis.formula->children[1 - place.path[0]];
      if (place.kind != PlaceKind::bound || !place.stronger_if_smaller || other.operation != Operation::name) continue;
      result.push_back({true, part, std::move(place)});
    }
  }
  return result;
}

Rational power_step(int level) {
  const long octave = level / steps_per_octave;
  const Rational within = Rational(steps_per_octave + level % steps_per_octave) / Rational(steps_per_octave);
  return within * Rational::power_of_two(octave);
}

Power power_of(const PowerTarget& target, std::uint64_t seed, const Progress& progress) {
  return target.place.is_hypothesis ? HypothesisPower(target).run(seed, progress)
                                    : ConclusionPower(target).run(seed, progress);
}

}  // namespace delcert
