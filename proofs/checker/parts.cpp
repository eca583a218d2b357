#include "proofs/checker/parts.hpp"

#include <algorithm>
#include <iostream>
#include <list>
#include <sstream>

#include "proofs/checker/decide.hpp"

namespace delcert::checker {
namespace {

constexpr std::size_t least_part = 64;

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

Counts in_parts(std::size_t size, Report& report,
                const std::function<Counts(std::size_t begin, std::size_t end, Report& report)>& work) {
  const std::size_t parts = std::max<std::size_t>(1, std::min<std::size_t>(most_parts, size / least_part));
  const auto begin = [=](std::size_t part) { return part * size / parts; };
  std::list<Elsewhere> others;
  for (std::size_t part = 1; part < parts; ++part) {
    others.emplace_back([&work, first = begin(part), end = begin(part + 1)](Report& found) {
      const Counts counts = work(first, end, found);
      return std::to_string(counts[0]) + ' ' + std::to_string(counts[1]);
    });
  }
  Counts sum = work(0, begin(1), report);
  for (Elsewhere& other : others) {
    Counts counts{};
    std::istringstream(other.result(report)) >> counts[0] >> counts[1];
    for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += counts[k];
  }
  return sum;
}

}  // namespace delcert::checker
