#pragma once

#include <algorithm>
#include <cstddef>
#include <exception>
#include <optional>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "kernel/number/big_interval.hpp"
#include "kernel/number/ladder.hpp"
#include "kernel/number/nearest_rounding.hpp"
#include "kernel/parallel/threads.hpp"
#include "support/progress.hpp"

namespace delcert {

/// How many pieces of work follow each other in one thread, usually.
inline constexpr std::size_t usual_part_size = 16;

/// Does the work 0 … count − 1 in parallel, with the outcome of doing it in order, whatever the number of threads.
///
/// `work(first, last)` does the work first … last − 1, in any thread. It may read what is shared and write what no
/// other work reads or writes, and returns what it found. `take(found)` gets that in this thread, in order. Threads
/// have passed the self-test; in `work` rounding is to nearest and the working precision of big intervals that of this
/// thread, and the decisions that it counts are counted here. `progress` is called in this thread, between rounds.
///
/// Where `work` throws, the exception of the first part that does is thrown on, after all before it has been taken; of
/// what comes after it some may have been done. Precondition: rounding to nearest; `work` asks for no parallel work.
template <std::size_t part_size = usual_part_size, class Work, class Take>
void in_parts(std::string_view stage, std::size_t count, const Progress& progress, const Work& work, const Take& take) {
  static_assert(part_size > 0);
  constexpr std::size_t round_size = 64 * part_size;
  using Found = std::invoke_result_t<const Work&, std::size_t, std::size_t>;
  struct Outcome {
    std::optional<Found> found;
    std::exception_ptr error;
    LadderStatistics decisions;
  };
  const PrecisionBits precision = BigInterval::working_precision();
  for (std::size_t begin = 0; begin < count; begin += round_size) {
    progress(stage, begin, count);
    const std::size_t end = std::min(count, begin + round_size);
    std::vector<Outcome> outcomes((end - begin + part_size - 1) / part_size);
    run_parts(outcomes.size(), [&](std::size_t part) {
      Outcome& outcome = outcomes[part];
      const std::size_t first = begin + part * part_size;
      const LadderStatistics before = ladder_statistics();
      try {
        const BigInterval::Precision same(precision);
        const NearestRounding nearest;
        require_fit_thread();
        outcome.found.emplace(work(first, std::min(end, first + part_size)));
      } catch (...) {
        outcome.error = std::current_exception();
      }
      outcome.decisions = ladder_statistics() - before;
      ladder_statistics() = before;
    });
    for (Outcome& outcome : outcomes) {
      ladder_statistics() += outcome.decisions;
      if (outcome.error) std::rethrow_exception(outcome.error);
      take(std::move(*outcome.found));
    }
  }
  progress(stage, count, count);
}

}  // namespace delcert
