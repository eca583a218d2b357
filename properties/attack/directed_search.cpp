#include "properties/attack/directed_search.hpp"

#include <algorithm>
#include <exception>
#include <limits>
#include <nlopt.hpp>
#include <stdexcept>
#include <vector>

namespace delcert {

namespace {

/// Of an instance that is made of more choices, the first ones are searched and the others stay.
constexpr std::size_t most_choices = 160;
/// How many instances a local search begins with, for each so many evaluations.
constexpr std::size_t starts = 6;
constexpr std::uint64_t evaluations_for_starts = 20000;
constexpr std::size_t most_starts = 48;

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
  double score = worthless_score;
  std::vector<double> choices;
  bool is_structured = false;
};

class Search {
 public:
  Search(const Claim& claim, const Shape& shape, const DrawScore& score, std::uint64_t evaluations,
         const Progress& progress)
      : claim_(claim),
        class_(instance_class(claim.instance)),
        shape_(shape),
        score_(score),
        budget_(evaluations),
        progress_(progress) {}

  void start(std::uint64_t count, std::uint64_t seed, const std::string& stream) {
    const std::size_t most = std::min<std::uint64_t>(most_starts, starts * (1 + budget_ / evaluations_for_starts));
    if (!class_.has_structure(shape_)) {
      draw_starts(count, most, seed, stream_of(stream), false);
      return;
    }
    // Half of the starts each, so that neither kind crowds out the other.
    draw_starts(count - count / 2, most - most / 2, seed, stream_of(stream), false);
    draw_starts(count / 2, most / 2, seed, stream_of(stream + " structured"), true);
    std::stable_sort(pool_.begin(), pool_.end(), is_better);
  }

  void climb() {
    const std::size_t count = pool_.size();
    for (std::size_t at = 0; at < count && used_ < budget_; ++at) {
      climb_from(pool_[at], (budget_ - used_) / (count - at));
    }
  }

  [[nodiscard]] std::optional<SearchResult> best() const {
    const auto best = std::max_element(pool_.begin(), pool_.end(),
                                       [](const Scored& a, const Scored& b) { return a.score < b.score; });
    if (best == pool_.end() || best->score <= worthless_score) return std::nullopt;
    const auto draw = [&claim = claim_, shape = shape_, best = *best](const Limits& limits) {
      GivenChoices choices(best.choices);
      return draw_one(claim, limits, shape, choices, best.is_structured);
    };
    return SearchResult{best->score, draw, used_};
  }

 private:
  static bool is_better(const Scored& a, const Scored& b) { return a.score > b.score; }

  static std::optional<Instance> draw_one(const Claim& claim, const Limits& limits, const Shape& shape,
                                          Choices& choices, bool is_structured) {
    return is_structured ? draw_structured_instance(claim, limits, shape, choices)
                         : draw_instance(claim, limits, shape, choices);
  }

  void draw_starts(std::uint64_t count, std::size_t most, std::uint64_t seed, std::uint32_t stream,
                   bool is_structured) {
    // Only the best of them are gone on from: the others need not be known sharply, nor kept.
    std::vector<Scored> kept;
    for (std::uint64_t number = 0; number < count; ++number) {
      // With other limits the choices may be asked for more numbers: the longest list is kept.
      std::vector<double> values;
      const LimitedDraw draw = [&](const Limits& limits) {
        RecordedChoices choices(seed, stream, number);
        auto instance = draw_one(claim_, limits, shape_, choices, is_structured);
        if (choices.values().size() > values.size()) values = choices.values();
        return instance;
      };
      const double known = kept.size() < most ? worthless_score : kept.back().score;
      const double score = scored(draw, known);
      if (score <= known) continue;
      const Scored candidate{score, std::move(values), is_structured};
      kept.insert(std::upper_bound(kept.begin(), kept.end(), candidate, is_better), candidate);
      if (kept.size() > most) kept.pop_back();
    }
    pool_.insert(pool_.end(), kept.begin(), kept.end());
  }

  double scored(const LimitedDraw& draw, double known) {
    progress_("search", std::min(++used_, budget_), budget_);
    return score_(draw, known);
  }

  double scored(const std::vector<double>& values, bool is_structured, double known) {
    return scored(
        [&](const Limits& limits) {
          GivenChoices choices(values);
          return draw_one(claim_, limits, shape_, choices, is_structured);
        },
        known);
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
      const double score = context.search->scored(context.choices, context.best->is_structured, context.best->score);
      if (score > context.best->score) {
        context.best->score = score;
        context.best->choices = context.choices;
      }
      return score;
    } catch (...) {
      context.failure = std::current_exception();
      throw nlopt::forced_stop();
    }
  }

  const Claim& claim_;
  const InstanceClass& class_;
  Shape shape_;
  const DrawScore& score_;
  std::uint64_t budget_;
  const Progress& progress_;
  std::uint64_t used_ = 0;
  std::vector<Scored> pool_;
};

}  // namespace

std::optional<SearchResult> directed_search(const Claim& claim, const Shape& shape, const std::string& stream,
                                            const DrawScore& score, std::uint64_t evaluations, std::uint64_t seed,
                                            const Progress& progress) {
  Search search(claim, shape, score, evaluations, progress);
  search.start(std::max<std::uint64_t>(1, evaluations / 4), seed, stream);
  search.climb();
  return search.best();
}

}  // namespace delcert
