#include "proofs/checker/parts/parts.hpp"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <iostream>
#include <list>
#include <sstream>

#include "proofs/checker/arithmetic/decide.hpp"
#include "proofs/checker/parts/shared_array.hpp"

namespace delcert::checker {
namespace {

/// Writes what the work did: its decisions and what it spent, then words and findings, each with a zero at its end.
int do_elsewhere(const Work& work) {
  const std::uint64_t left = Budget::left();
  decisions = {};
  Report found;
  std::string words;
  try {
    words = work(found);
  } catch (const std::exception&) {
    return no_outcome;
  }
  std::cout << decisions.filtered << ' ' << decisions.exact << ' ' << decisions.enclosed << ' ' << left - Budget::left()
            << ' ' << words << '\0';
  for (const Finding& finding : found.findings) std::cout << finding.rule << '\0' << finding.what << '\0';
  return 0;
}

}  // namespace

std::pair<std::uint64_t, std::uint64_t> range_of(const Share& share, std::uint64_t size) {
  // The product with a number of parts has no 64 bits.
  const auto at = [&](std::uint64_t k) { return size / share.of * k + size % share.of * k / share.of; };
  return {at(share.number - 1), at(share.number)};
}

Elsewhere::Elsewhere(Work work) : work_(std::move(work)), process_([this] { return do_elsewhere(work_); }) {}

std::string Elsewhere::result(Report& report) {
  const Ended ended = process_.end();
  std::istringstream in(ended.output);
  Decisions made;
  std::uint64_t spent = 0;
  in >> made.filtered >> made.exact >> made.enclosed >> spent;
  std::string words;
  const bool whole = ended.status == 0 && ended.signal == 0 && in.get() == ' ' && std::getline(in, words, '\0');
  if (!whole || spent > Budget::left()) return work_(report);
  Budget::spend(spent);
  decisions.filtered += made.filtered;
  decisions.exact += made.exact;
  decisions.enclosed += made.enclosed;
  for (Finding finding; std::getline(in, finding.rule, '\0') && std::getline(in, finding.what, '\0');)
    report.reject(finding.rule, [&] { return finding.what; });
  return words;
}

bool is_done_here(std::string_view rule, Report& report) {
  (own_share.number == 1 ? report.done : report.left).emplace_back(rule);
  return own_share.number == 1;
}

namespace {

/// Which items of a loop are looked at: from which to which one, and where the first is in the whole, of how many.
ChunkItems::Part own_part(Items items, std::uint64_t size) {
  if (!chunk_items || items == Items::others) {
    const auto [begin, end] = range_of(own_share, size);
    return {begin, end, begin, size};
  }
  if (items == Items::facets) return {0, size, 0, chunk_items->facets};
  return items == Items::labels ? chunk_items->labels : chunk_items->simplices;
}

/// Where blocks of first ... last - 1 begin, and the end. The later, the smaller: processes that take one after the
/// other end at about the same time.
std::vector<std::uint64_t> blocks(std::uint64_t first, std::uint64_t last, std::size_t parts) {
  const std::uint64_t smallest = (last - first) / (16 * parts) + 1;
  std::vector<std::uint64_t> begin{first};
  while (begin.back() < last)
    begin.push_back(std::min(last, begin.back() + std::max(smallest, (last - begin.back()) / (2 * parts))));
  return begin;
}

void add(Counts& sum, const Counts& counts) {
  for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += counts[k];
}

}  // namespace

Counts in_parts(std::string_view rules, Items items, std::size_t size, Report& report, const LoopBody& work,
                const std::vector<std::string>& names, std::size_t least) {
  const ChunkItems::Part own = own_part(items, size);
  const std::uint64_t first = own.begin, last = own.end;
  const Decisions before = decisions;
  const std::uint64_t left = Budget::left();
  const std::size_t length = last - first;
  const std::size_t parts = std::max<std::size_t>(1, std::min<std::size_t>(most_parts, length / least));
  Counts sum{};
  const auto do_parts = [&] {
    const std::vector<std::uint64_t> begin = blocks(first, last, parts);
    SharedArray<std::atomic<std::size_t>> taken(1);
    const auto do_some = [&](Report& found) {
      Counts counts{};
      for (std::size_t block = taken[0]++; block + 1 < begin.size(); block = taken[0]++)
        add(counts, work(begin[block], begin[block + 1], found));
      return counts;
    };
    std::list<Elsewhere> others;
    for (std::size_t part = 1; part < parts; ++part) {
      others.emplace_back([&do_some, here = ::getpid()](Report& found) {
        if (::getpid() == here) throw Undecided("blocks were taken, and not looked at to the end");
        const Counts counts = do_some(found);
        return std::to_string(counts[0]) + ' ' + std::to_string(counts[1]);
      });
    }
    Report found;
    sum = do_some(found);
    for (Elsewhere& other : others) {
      Counts counts{};
      std::istringstream(other.result(found)) >> counts[0] >> counts[1];
      add(sum, counts);
    }
    return found.findings.empty();
  };
  bool is_done = false;
  try {
    is_done = parts > 1 && do_parts();
  } catch (const Undecided&) {
  }
  // What is wrong is said by one process, in order.
  if (!is_done) {
    decisions = before;
    Budget::restore(left);
    sum = work(first, last, report);
  }
  Range range{std::string(rules), own.of, own.first, own.first + length, {}};
  for (std::size_t k = 0; k < names.size(); ++k) range.counts.emplace_back(names[k], sum[k]);
  report.ranges.push_back(std::move(range));
  in_ranges.filtered += decisions.filtered - before.filtered;
  in_ranges.exact += decisions.exact - before.exact;
  in_ranges.enclosed += decisions.enclosed - before.enclosed;
  return sum;
}

}  // namespace delcert::checker
