#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "proofs/checker/arithmetic/decide.hpp"
#include "proofs/checker/parts/chunk_items.hpp"
#include "proofs/checker/parts/separate_process.hpp"
#include "proofs/checker/parts/share.hpp"
#include "proofs/checker/report/report.hpp"

namespace delcert::checker {

/// In how many processes a check divides its work.
inline unsigned most_parts = 1;

/// Of the decisions, those in loops that are divided.
inline Decisions in_ranges;

/// Whether a rule that is not divided, and on which no others rest, is looked at here: that is recorded in the report.
bool is_done_here(std::string_view rule, Report& report);

/// While there is one, loops are not divided among parts: every part needs their outcome.
class Undivided {
 public:
  Undivided() { own_share = {}; }
  Undivided(const Undivided&) = delete;
  Undivided& operator=(const Undivided&) = delete;
  ~Undivided() {
    own_share = share_;
    in_ranges = in_ranges_;
  }

 private:
  const Share share_ = own_share;
  const Decisions in_ranges_ = in_ranges;
};

/// Work that records what it finds and returns in words or numbers what it looked at.
using Work = std::function<std::string(Report& report)>;

/// A part of a check in a process of its own, with the state of this one.
class Elsewhere {
 public:
  explicit Elsewhere(Work work);

  /// Adds what it found, its decisions and the budget that it spent, and returns its words, as if the work were done
  /// here now. It is done here if it did not come to its end there, or if the budget does not suffice, so that
  /// exceptions are the same too. Precondition: once, with nothing changed on which the work depends.
  std::string result(Report& report);

 private:
  const Work work_;
  SeparateProcess process_;
};

/// What a loop counts, for its summary.
using Counts = std::array<std::int64_t, 2>;

/// Calls work(begin, end, report) for blocks of this share of 0 ... size - 1, here and elsewhere, whoever is ready for
/// the next one, and adds up what they return. The outcome is that of one call for the whole share, and those of all
/// shares add up to that of one call for 0 ... size - 1. The range is recorded in the report, with the rules that it is
/// about and the counts that have names; a summary has "{name}" for such a count. Precondition: what the work does for
/// a number depends on nothing that it has done for others, and a loop has other rules than the other loops of its
/// level. In the check of a chunk (chunk_items.hpp) it is called for the items of the chunk. A process for fewer items
/// than `least` would take longer than they do.
using LoopBody = std::function<Counts(std::size_t begin, std::size_t end, Report& report)>;
Counts in_parts(std::string_view rules, Items items, std::size_t size, Report& report, const LoopBody& work,
                const std::vector<std::string>& names = {}, std::size_t least = 64);
inline Counts in_parts(std::string_view rules, std::size_t size, Report& report, const LoopBody& work,
                       const std::vector<std::string>& names = {}, std::size_t least = 64) {
  return in_parts(rules, Items::others, size, report, work, names, least);
}

}  // namespace delcert::checker
