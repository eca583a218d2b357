#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "proofs/checker/failure.hpp"

namespace delcert::checker {

/// A broken rule with the labels and values that break it; only the first case of each rule is kept.
struct Finding {
  std::string rule;
  std::string what;
};

/// Collects what is wrong with a level.
class Report {
 public:
  /// Records that the rule is broken, unless it is already known; `describe` returns the text.
  template <class Describe>
  void reject(std::string_view rule, const Describe& describe) {
    if (disabled(rule)) return;
    for (const Finding& finding : findings) {
      if (finding.rule == rule) return;
    }
    findings.push_back({std::string(rule), describe()});
  }

  /// Throws Malformed unless the rule of the form holds.
  static void require(std::string_view rule, bool holds, const std::string& what) {
    if (!holds && !disabled(rule)) throw Malformed(std::string(rule), what);
  }

  std::vector<Finding> findings;

#ifdef DELCERT_CHECK_TESTING
  /// The rule left out, in the program that tests the tests; the real program cannot leave out any.
  static inline std::string without_rule;
  static bool disabled(std::string_view rule) { return rule == without_rule; }
#else
  static constexpr bool disabled(std::string_view) { return false; }
#endif
};

}  // namespace delcert::checker
