#pragma once

#include <filesystem>
#include <string>

namespace delcert {

/// The bytes of a file, decompressed if it is compressed by zstd. Throws InputError with the file and what is wrong.
[[nodiscard]] std::string read_text(const std::filesystem::path& path);

}  // namespace delcert
