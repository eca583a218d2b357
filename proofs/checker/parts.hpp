#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>

#include "proofs/checker/report.hpp"
#include "proofs/checker/separate_process.hpp"

namespace delcert::checker {

/// In how many processes a check divides its work.
inline unsigned most_parts = 1;

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
using Counts = std::array<std::uint64_t, 2>;

/// Calls work(begin, end, report) for parts of 0 ... size - 1, all but the first one elsewhere, and adds up what they
/// return. The outcome is that of one call for 0 ... size - 1. Precondition: what the work does for a number depends on
/// nothing that it has done for others.
Counts in_parts(std::size_t size, Report& report,
                const std::function<Counts(std::size_t begin, std::size_t end, Report& report)>& work);

}  // namespace delcert::checker
