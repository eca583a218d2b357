#pragma once

#include <string>

#include "proofs/constants/ledger.hpp"

namespace delcert {

/// The ledger for reading: a table with one line per constant, exactly, as an enclosure, and as a power of 2.
[[nodiscard]] std::string ledger_table(const Ledger& ledger);
/// The same as a JSON document: numbers are strings, enclosures are decimal and rounded outwards.
[[nodiscard]] std::string ledger_json(const Ledger& ledger);
/// The same as a tabular of LaTeX's booktabs.
[[nodiscard]] std::string ledger_latex(const Ledger& ledger);

}  // namespace delcert
