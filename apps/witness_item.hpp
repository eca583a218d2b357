#pragma once

#include "proofs/report/certificate_item.hpp"
#include "properties/attack/replay.hpp"

namespace delcert {

/// The witnesses of a witness file, or those of the refutations that `delcert attack --json` printed into a file. None
/// if the file begins as neither does. Throws InputError, naming the file, where it goes on differently, and if there
/// is no refutation in it.
[[nodiscard]] std::vector<Witness> witnesses_in(const std::string& path);

/// A witness for a page: what it names, the instance in exact numbers, and what the replay decided.
[[nodiscard]] PageItem witness_item(const Witness& witness, const Replay& replay, const ShownFile& file);

}  // namespace delcert
