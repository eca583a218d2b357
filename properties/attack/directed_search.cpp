#include "properties/attack/directed_search.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
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
         CounterRandom random, const Progress& progress)
      : claim_(claim),
        class_(instance_class(claim.instance)),
        shape_(shape),
        score_(score),
        budget_(evaluations),
        random_(random),
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

  /// In rounds: after each the better half of the starts goes on, with twice as many evaluations each.
  void climb() {
    std::vector<Scored*> active;
    for (Scored& start : pool_) active.push_back(&start);
    const auto rounds = static_cast<std::uint64_t>(std::bit_width(active.size()));
    for (std::uint64_t round = 0; round < rounds && used_ < budget_; ++round) {
      const std::uint64_t end = used_ + (budget_ - used_) / (rounds - round);
      for (std::size_t at = 0; at < active.size() && used_ < end; ++at) {
        climb_from(*active[at], (end - used_) / (active.size() - at), round);
      }
      std::stable_sort(active.begin(), active.end(),
                       [](const Scored* x, const Scored* y) { return is_better(*x, *y); });
      active.resize((active.size() + 1) / 2);
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

  /// A quarter at random, the rest by Subplex, which begins anew where it ends early.
  void climb_from(Scored& start, std::uint64_t budget, std::uint64_t round) {
    const std::uint64_t end = used_ + budget;
    if (start.choices.empty()) return;
    change_at_random(start, budget / 4);
    // Every other time wider, so that it leaves where it has ended.
    for (std::uint64_t at = round; used_ < end; ++at) {
      constexpr std::array<double, 4> steps = {0.05, 0.01, 0.2, 0.002};
      const std::uint64_t before = used_;
      climb_by_subplex(start, end - used_, steps[at % steps.size()]);
      if (used_ == before) return;
      change_at_random(start, std::min((end - used_) / 4, used_ - before));
    }
  }

  /// Changes a few of the choices, each to any number or to one nearby, and keeps what is better. Most choices of an
  /// instance are about kinds, and have no slope.
  void change_at_random(Scored& best, std::uint64_t count) {
    for (std::uint64_t at = 0; at < count; ++at) {
      std::vector<double> choices = best.choices;
      do {
        double& choice = choices[below(searched(best))];
        constexpr std::size_t finest = 20;
        const double size = std::ldexp(1.0, -static_cast<int>(below(finest)));
        choice = random_.next_unit() < 0.5 ? random_.next_unit()
                                           : std::clamp(choice + size * (random_.next_unit() - 0.5), 0.0, 1.0);
      } while (random_.next_unit() < 0.5);
      keep_better(best, choices);
    }
  }

  /// 0 … count − 1.
  std::size_t below(std::size_t count) {
    return std::min(count - 1, static_cast<std::size_t>(random_.next_unit() * static_cast<double>(count)));
  }

  static std::size_t searched(const Scored& start) { return std::min(start.choices.size(), most_choices); }

  double keep_better(Scored& best, const std::vector<double>& choices) {
    const double score = scored(choices, best.is_structured, best.score);
    if (score > best.score) {
      best.score = score;
      best.choices = choices;
    }
    return score;
  }

  void climb_by_subplex(Scored& start, std::uint64_t budget, double step) {
    const auto count = static_cast<std::ptrdiff_t>(searched(start));
    std::vector<double> x(start.choices.begin(), start.choices.begin() + count);
    if (x.empty() || budget == 0) return;
    nlopt::opt optimiser(nlopt::LN_SBPLX, static_cast<unsigned>(x.size()));
    optimiser.set_lower_bounds(0);
    optimiser.set_upper_bounds(1);
    // 0 would mean without end.
    optimiser.set_maxeval(static_cast<int>(std::min<std::uint64_t>(budget, std::numeric_limits<int>::max())));
    optimiser.set_xtol_abs(0x1p-40);
    optimiser.set_initial_step(step);
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
      return context.search->keep_better(*context.best, context.choices);
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
  CounterRandom random_;
  const Progress& progress_;
  std::uint64_t used_ = 0;
  std::vector<Scored> pool_;
};

}  // namespace

std::optional<SearchResult> directed_search(const Claim& claim, const Shape& shape, const std::string& stream,
                                            const DrawScore& score, std::uint64_t evaluations, std::uint64_t seed,
                                            const Progress& progress) {
  constexpr std::uint32_t changes = 0xffffffff;
  Search search(claim, shape, score, evaluations,
                CounterRandom(seed, RandomPurpose::instances, stream_of(stream + " changes"), changes), progress);
  search.start(std::max<std::uint64_t>(1, evaluations / 4), seed, stream);
  search.climb();
  return search.best();
}

}  // namespace delcert
