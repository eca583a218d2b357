#pragma once

#include <string>
#include <vector>

#include "proofs/report/certificate_item.hpp"

namespace delcert {

/// What a file is, by how it begins: a witness file, what `delcert attack --json` printed, or something else; that too
/// if it cannot be read.
enum class WitnessFile { witness, attack, other };
[[nodiscard]] WitnessFile witness_file(const std::string& path);

/// The witnesses of a file of the first two kinds for a page, each decided anew. Throws InputError, naming the file,
/// where it goes on differently, and if there is no refutation in it. delcert, which has no claims, hands over to
/// delcert-claims instead.
[[nodiscard]] std::vector<PageItem> witness_items(const std::string& path, const ShownFile& file);

}  // namespace delcert
