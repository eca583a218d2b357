#include "kernel/number/ladder.hpp"

#include <numeric>

namespace delcert {

std::uint64_t LadderStatistics::total() const { return std::accumulate(settled.begin(), settled.end(), undecided); }

LadderStatistics& LadderStatistics::operator+=(const LadderStatistics& other) {
  for (std::size_t rung = 0; rung < rung_count; ++rung) settled[rung] += other.settled[rung];
  undecided += other.undecided;
  return *this;
}

LadderStatistics operator-(const LadderStatistics& a, const LadderStatistics& b) {
  LadderStatistics result = a;
  for (std::size_t rung = 0; rung < rung_count; ++rung) result.settled[rung] -= b.settled[rung];
  result.undecided -= b.undecided;
  return result;
}

LadderStatistics& ladder_statistics() {
  thread_local LadderStatistics statistics;
  return statistics;
}

}  // namespace delcert
