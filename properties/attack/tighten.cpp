#include "properties/attack/tighten.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <nlopt.hpp>
#include <stdexcept>

#include "kernel/error.hpp"

namespace delcert {

namespace {

/// Of an instance that is made of more choices, the first ones are searched and the others stay.
constexpr std::size_t most_choices = 160;
constexpr double worthless = -1;

/// Random choices that are written down.
class RecordedChoices : public Choices {
 public:
  RecordedChoices(std::uint64_t seed, std::uint32_t stream, std::uint64_t number) : random_(seed, stream, number) {}
  [[nodiscard]] double unit() override {
    values_.push_back(random_.unit());
    return values_.back();
  }
  [[nodiscard]] const std::vector<double>& values() const { return values_; }

 private:
  RandomChoices random_;
  std::vector<double> values_;
};

struct Scored {
  double score = worthless;
  std::vector<double> choices;
};

Claim of_one_conclusion(Claim claim, std::size_t conclusion) {
  claim.conclusions = {claim.conclusions.at(conclusion)};
  return claim;
}

class Search {
 public:
  Search(const Claim& claim, std::size_t conclusion, const Shape& shape, std::uint64_t evaluations,
         const Progress& progress)
      : claim_(of_one_conclusion(claim, conclusion)),
        conclusion_(conclusion),
        limits_(claim),
        shape_(shape),
        budget_(evaluations),
        progress_(progress) {}

  void random_start(std::uint64_t count, std::uint64_t seed) {
    const std::uint32_t stream = stream_of("tighten " + claim_.name + " " + std::to_string(conclusion_) + " " +
                                           std::to_string(shape_.k) + " " + std::to_string(shape_.m));
    for (std::uint64_t number = 0; number < count; ++number) {
      RecordedChoices choices(seed, stream, number);
      const double score = score_of(draw_instance(claim_, limits_, shape_, choices));
      if (score > worthless) pool_.push_back({score, choices.values()});
    }
    std::stable_sort(pool_.begin(), pool_.end(), [](const Scored& a, const Scored& b) { return a.score > b.score; });
  }

  void climb(std::size_t starts) {
    const std::size_t count = std::min(starts, pool_.size());
    for (std::size_t at = 0; at < count && used_ < budget_; ++at)
      climb_from(pool_[at], (budget_ - used_) / (count - at));
    if (count > 0)
      best_ = *std::max_element(pool_.begin(), pool_.begin() + static_cast<std::ptrdiff_t>(count),
                                [](const Scored& a, const Scored& b) { return a.score < b.score; });
  }

  [[nodiscard]] std::uint64_t used() const { return used_; }
  [[nodiscard]] std::optional<Instance> best() const {
    if (best_.score <= worthless) return std::nullopt;
    GivenChoices choices(best_.choices);
    return draw_instance(claim_, limits_, shape_, choices);
  }

 private:
  double score_of(const std::optional<Instance>& instance) {
    progress_("tighten", std::min(++used_, budget_), budget_);
    if (!instance) return worthless;
    const Attempt result = attempt(claim_, instance->bindings);
    if (!is_proved(result.hypotheses)) return worthless;
    const auto& ratio = result.conclusions.front().ratio;
    if (!ratio || !std::isfinite(ratio->lower) || !std::isfinite(ratio->upper)) return worthless;
    return (ratio->lower + ratio->upper) / 2;
  }

  double score_of(const std::vector<double>& values) {
    GivenChoices choices(values);
    return score_of(draw_instance(claim_, limits_, shape_, choices));
  }

  void climb_from(Scored& start, std::uint64_t budget) {
    std::vector<double> x(start.choices.begin(), start.choices.begin() + static_cast<std::ptrdiff_t>(std::min(
                                                                             start.choices.size(), most_choices)));
    if (x.empty() || budget == 0) return;
    nlopt::opt optimiser(nlopt::LN_SBPLX, static_cast<unsigned>(x.size()));
    optimiser.set_lower_bounds(0);
    optimiser.set_upper_bounds(1);
    // 0 would mean without end.
    optimiser.set_maxeval(static_cast<int>(std::min<std::uint64_t>(budget, std::numeric_limits<int>::max())));
    optimiser.set_xtol_abs(0x1p-40);
    optimiser.set_initial_step(0.05);
    Context context{this, &start, start.choices, nullptr};
    optimiser.set_max_objective(&Search::objective, &context);
    double value = 0;
    try {
      optimiser.optimize(x, value);
    } catch (const std::runtime_error&) {
      // Limited by rounding, a failure, or stopped by the objective, which keeps the best so far.
    }
    if (context.failure) std::rethrow_exception(context.failure);
  }

  struct Context {
    Search* search;
    Scored* best;
    std::vector<double> choices;
    std::exception_ptr failure;
  };
  /// Exceptions do not pass through the library.
  static double objective(const std::vector<double>& x, std::vector<double>&, void* data) {
    auto& context = *static_cast<Context*>(data);
    try {
      std::copy(x.begin(), x.end(), context.choices.begin());
      const double score = context.search->score_of(context.choices);
      if (score > context.best->score) *context.best = {score, context.choices};
      return score;
    } catch (...) {
      context.failure = std::current_exception();
      throw nlopt::forced_stop();
    }
  }

  Claim claim_;
  std::size_t conclusion_;
  HypothesisLimits limits_;
  Shape shape_;
  std::uint64_t budget_;
  const Progress& progress_;
  std::uint64_t used_ = 0;
  std::vector<Scored> pool_;
  Scored best_;
};

}  // namespace

std::optional<Tightest> judged(const Claim& claim, std::size_t conclusion, const Bindings& bindings) {
  Scene scene(bindings);
  const Expression& statement = *claim.conclusions.at(conclusion).formula;
  const auto ratio = ratio_bounds(statement, scene, true);
  if (!ratio) return std::nullopt;
  Tightest result;
  result.ratio = *ratio;
  result.verdict = decide_statement(statement, scene);
  result.is_equality = is_proved(result.verdict) && ratio->upper >= 1 &&
                       is_refuted(decide_statement(*made_strict(claim.conclusions[conclusion].formula), scene));
  result.bindings = bindings;
  return result;
}

std::optional<Tightest> tighten(const Claim& claim, std::size_t conclusion, const Shape& shape,
                                std::uint64_t evaluations, std::uint64_t seed, const Progress& progress) {
  constexpr std::size_t starts = 6;
  Search search(claim, conclusion, shape, evaluations, progress);
  search.random_start(std::max<std::uint64_t>(1, evaluations / 4), seed);
  search.climb(starts);
  const auto instance = search.best();
  auto result = instance ? judged(claim, conclusion, instance->bindings) : std::nullopt;
  if (result) result->evaluations = search.used();
  return result;
}

}  // namespace delcert
