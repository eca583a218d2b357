#pragma once

#include <optional>
#include <string>
#include <vector>

#include "proofs/constants/ledger.hpp"
#include "proofs/constants/power_product.hpp"

namespace delcert {

/// One line of the ledger, ready to be shown.
struct LedgerEntry {
  /// The English name, for JSON keys and tables.
  std::string name;
  /// The paper's letter, in plain text and in LaTeX's math mode.
  std::string symbol;
  std::string latex_symbol;
  /// Exact, in plain text and in LaTeX's math mode; empty where there is only an enclosure.
  std::string exact;
  std::string exact_latex;
  /// Where the value lies.
  Bounds value;
  /// Where its binary logarithm lies; empty for 0 and where the exact form is no product of powers.
  std::optional<Bounds> log2;
  /// The paper's label, or how the value came about.
  std::string source;
  /// True where the value is an estimate that nothing is proved about: then the bounds only bound the arithmetic.
  bool is_estimate = false;
};

/// The lines of the ledger in the order of the paper's argument: input, parameters, hypotheses, Theorem 3. Those of the
/// sharper hypotheses have one more, self_delaunay_sampling_radius.
[[nodiscard]] std::vector<LedgerEntry> ledger_entries(const Ledger& ledger);

}  // namespace delcert
