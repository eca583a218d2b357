#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace delcert::checker {

/// A broken rule of the format page ("form.gram", "1.facets") with the labels and values that break it.
struct Finding {
  std::string rule, what;
};

/// Of a loop over `size` items: from which to which one they were looked at, for which rules, and what was counted.
struct Range {
  std::string rules;
  std::uint64_t size = 0, begin = 0, end = 0;
  std::vector<std::pair<std::string, std::int64_t>> counts;
};

/// The file is not a certificate of this format: exit status 3.
struct Malformed : std::runtime_error {
  Malformed(std::string_view broken_rule, const std::string& what) : std::runtime_error(what), rule(broken_rule) {}
  std::string rule;
};

/// A check is too large for this reader: exit status 2.
struct Undecided : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// What is wrong with a level: the first case of each broken rule. And which share of it was looked at.
class Report {
 public:
  /// Records that the rule is broken; `describe` returns how, and is called for the first case only.
  template <class Describe>
  void reject(std::string_view rule, const Describe& describe) {
    if (disabled(rule)) return;
    for (const Finding& finding : findings) {
      if (finding.rule == rule) return;
    }
    findings.push_back({std::string(rule), describe()});
  }

  /// What another report has found.
  void add(const Report& other) {
    findings.insert(findings.end(), other.findings.begin(), other.findings.end());
    ranges.insert(ranges.end(), other.ranges.begin(), other.ranges.end());
  }

  /// Throws Malformed unless the rule of the form holds.
  static void require(std::string_view rule, bool holds, const std::string& what) {
    if (!holds && !disabled(rule)) throw Malformed(rule, what);
  }

  std::vector<Finding> findings;
  std::vector<Range> ranges;
  std::vector<std::string> done, left;  // rules that are not divided: looked at here, or left to the first part

  /// Whether a rule is left out: none ever is, but in the program that tests the tests (report.cpp).
  static bool disabled(std::string_view rule);
};

#ifdef DELCERT_CHECK_TESTING
/// Set by the option --without-rule of the program that tests the tests.
[[nodiscard]] std::string& rule_left_out();
#endif

}  // namespace delcert::checker
