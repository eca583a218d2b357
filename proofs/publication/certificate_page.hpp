#pragma once

#include <filesystem>
#include <optional>

#include "proofs/report/certificate_item.hpp"

namespace delcert {

/// The name and the digest of a file. Throws InputError if it cannot be read.
[[nodiscard]] ShownFile shown_file(const std::filesystem::path& path);

/// The certificate in a file, for a page: with what the checker said, if it was asked, and with the paper's constants
/// for its parameters (null where the paper does not speak of such parameters). Throws InputError if it cannot be read.
[[nodiscard]] PageItem certificate_page_item(const std::filesystem::path& path,
                                             const std::optional<CheckRecord>& check);

}  // namespace delcert
