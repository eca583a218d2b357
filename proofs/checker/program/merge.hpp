#pragma once

#include <string>
#include <vector>

#include "proofs/checker/program/receipt.hpp"

namespace delcert::checker {

/// Receipts are not those of one whole check: the rule, and the exit status.
struct Refused : Finding {
  int status = 1;
};

/// A receipt and the name of its file.
struct NamedReceipt {
  std::string file;
  Receipt receipt;
};

/// The outcome of the whole of which these are the parts, as one check would say it but for the seconds, which add up;
/// or that of one part that is not verified, the worst. Throws Refused unless (docs/parts-of-a-check.md)
///   merge.version      all are of this version of the checker,
///   merge.certificate  of the same certificate,
///   merge.rules        and of the same rules;
///   merge.doubled      no part, and no undivided rule, is there twice;
///   merge.overlap      parts do not overlap;
///   merge.missing      together they are all that there is;
///   merge.chunks       chunks have each label and each simplex once,
///   merge.connected    and are connected with each other;
///   merge.count        simplices and Euler characteristic add up to what the certificate states.
/// `content`: the SHA-256 in the seal of the certificate, if it is known; empty otherwise.
Outcome merged(std::vector<NamedReceipt> receipts, const std::string& checker, const std::string& content);

}  // namespace delcert::checker
