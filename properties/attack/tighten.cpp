#include "properties/attack/tighten.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <nlopt.hpp>
#include <stdexcept>

#include "properties/attack/attempt.hpp"
#include "properties/attack/claim_variants.hpp"
#include "properties/attack/hypothesis_limits.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

/// Of an instance that is made of more choices, the first ones are searched and the others stay.
constexpr std::size_t most_choices = 160;
constexpr double worthless = -1;
/// How many instances a local search begins with.
constexpr std::size_t starts = 6;

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

class Search {
 public:
  Search(const Claim& claim, std::size_t conclusion, const Shape& shape, std::uint64_t evaluations,
         const Progress& progress)
      : claim_(claim),
        conclusion_(conclusion),
        limits_(claim),
        shape_(shape),
        budget_(evaluations),
        progress_(progress) {}

  void random_start(std::uint64_t count, std::uint64_t seed) {
    const std::uint32_t stream = stream_of("tighten " + claim_.name + " " + std::to_string(conclusion_) + " " +
                                           std::to_string(shape_.k) + " " + std::to_string(shape_.m));
    // Only the best of them are gone on from: the others need not be known sharply, nor kept.
    const auto is_better = [](const Scored& a, const Scored& b) { return a.score > b.score; };
    for (std::uint64_t number = 0; number < count; ++number) {
      RecordedChoices choices(seed, stream, number);
      const double known = pool_.size() < starts ? worthless : pool_.back().score;
      const double score = score_of(draw_instance(claim_, limits_, shape_, choices), known);
      if (score <= known) continue;
      const Scored scored{score, choices.values()};
      pool_.insert(std::upper_bound(pool_.begin(), pool_.end(), scored, is_better), scored);
      if (pool_.size() > starts) pool_.pop_back();
    }
  }

  void climb() {
    const std::size_t count = pool_.size();
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
  /// Worthless where the hypotheses do not hold. Sharp where it is above what is known.
  double score_of(const std::optional<Instance>& instance, double known) {
    progress_("tighten", std::min(++used_, budget_), budget_);
    if (!instance) return worthless;
    const auto ratio = attempted_ratio(claim_, conclusion_, instance->bindings, known);
    // What is certified counts: bounds that stay wide would attract the search otherwise.
    return ratio && std::isfinite(ratio->lower) ? ratio->lower : worthless;
  }

  double score_of(const std::vector<double>& values, double known) {
    GivenChoices choices(values);
    return score_of(draw_instance(claim_, limits_, shape_, choices), known);
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
      const double score = context.search->score_of(context.choices, context.best->score);
      if (score > context.best->score) *context.best = {score, context.choices};
      return score;
    } catch (...) {
      context.failure = std::current_exception();
      throw nlopt::forced_stop();
    }
  }

  const Claim& claim_;
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
  Search search(claim, conclusion, shape, evaluations, progress);
  search.random_start(std::max<std::uint64_t>(1, evaluations / 4), seed);
  search.climb();
  const auto instance = search.best();
  auto result = instance ? judged(claim, conclusion, instance->bindings) : std::nullopt;
  if (result) result->evaluations = search.used();
  return result;
}

}  // namespace delcert
