#pragma once

#include <filesystem>
#include <functional>

#include "proofs/report/certificate_item.hpp"

namespace delcert {

/// The name and the digest of a file. Throws InputError if it cannot be read.
[[nodiscard]] ShownFile shown_file(const std::filesystem::path& path);

/// The certificate in a file, for a page: with the answer of `check`, which is asked once the file has been read (if it
/// is empty, the checker was not asked), and with the paper's constants for its parameters (null where the paper does
/// not speak of such parameters). Throws InputError if the file cannot be read.
[[nodiscard]] PageItem certificate_page_item(const std::filesystem::path& path,
                                             const std::function<CheckRecord()>& check);

}  // namespace delcert
