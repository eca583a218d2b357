#pragma once

#include <string>
#include <vector>

#include "proofs/constants/sweep.hpp"

namespace delcert {

/// Names of constants as in LedgerEntry::name; no names mean all constants.
using ConstantNames = std::vector<std::string>;

/// The names that a ledger can have.
[[nodiscard]] ConstantNames all_constant_names();

/// The ledger for reading: a table with one line per constant, exactly, as an enclosure, and as a power of 2.
[[nodiscard]] std::string ledger_table(const Ledger& ledger, const ConstantNames& only = {});
/// The same as a JSON document: numbers are strings, enclosures are decimal and rounded outwards.
[[nodiscard]] std::string ledger_json(const Ledger& ledger, const ConstantNames& only = {});
/// The same as a longtable of LaTeX with the rules of booktabs, at most 345 pt wide.
[[nodiscard]] std::string ledger_latex(const Ledger& ledger, const ConstantNames& only = {});

/// Several ledgers for comparing: for each constant a block with one line per ledger; then what was left out.
/// Precondition here and below: there is a ledger.
[[nodiscard]] std::string sweep_table(const SweptLedgers& swept, const ConstantNames& only = {});
/// The same as {"ledgers": […], "left_out": […]}, each ledger as ledger_json has it.
[[nodiscard]] std::string sweep_json(const SweptLedgers& swept, const ConstantNames& only = {});
/// The same as a longtable of LaTeX with the rules of booktabs, at most 345 pt wide.
[[nodiscard]] std::string sweep_latex(const SweptLedgers& swept, const ConstantNames& only = {});

}  // namespace delcert
