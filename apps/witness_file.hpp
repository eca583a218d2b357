#pragma once

#include <string>
#include <vector>

#include "proofs/drawing/figure/figure.hpp"
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

/// A figure of the first witness of such a file, whose description has what the claim says of it, decided anew. Throws
/// as `witness_items`, and InputError where there is nothing to draw.
[[nodiscard]] Figure witness_figure(const std::string& path);

}  // namespace delcert
