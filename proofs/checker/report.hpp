#pragma once

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

/// The file is not a certificate of this format: exit status 3.
struct Malformed : std::runtime_error {
  Malformed(std::string_view broken_rule, const std::string& what) : std::runtime_error(what), rule(broken_rule) {}
  std::string rule;
};

/// A check is too large for this reader: exit status 2.
struct Undecided : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// What is wrong with a level: the first case of each broken rule.
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

  /// Throws Malformed unless the rule of the form holds.
  static void require(std::string_view rule, bool holds, const std::string& what) {
    if (!holds && !disabled(rule)) throw Malformed(rule, what);
  }

  std::vector<Finding> findings;

#ifdef DELCERT_CHECK_TESTING
  /// The rule that is left out, in the program that tests the tests; the real one cannot leave out any.
  static inline std::string without_rule;
  static bool disabled(std::string_view rule) { return rule == without_rule; }
#else
  static constexpr bool disabled(std::string_view) { return false; }
#endif
};

}  // namespace delcert::checker
