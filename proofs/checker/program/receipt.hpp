#pragma once

#include <string>
#include <string_view>

#include "proofs/checker/run.hpp"

namespace delcert::checker {

/// What a part of a check found, for those who put the parts together: docs/parts-of-a-check.md. A receipt is no proof,
/// and its seal detects accidents only.
struct Receipt {
  std::string checker;  // the version of the program
  Outcome outcome;      // not of a malformed certificate
};

/// One line of JSON with a seal. Seconds are rounded to microseconds.
std::string receipt_text(const Receipt& receipt);

/// Throws Malformed (merge.receipt) unless the bytes are the text of a receipt whose ranges are those of its part.
Receipt receipt_of(std::string_view bytes);

/// Whether the file may be one, by how it begins.
bool looks_like_receipt(std::string_view bytes);

}  // namespace delcert::checker
