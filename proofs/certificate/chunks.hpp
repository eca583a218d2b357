#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace delcert {

/// Divides a certificate of a space form into so many chunks of consecutive labels, and writes them to a folder, which
/// is made, with a header that has all else (docs/certificate-in-chunks.md). What `homology` states is left out. Chunks
/// have as many labels as each other, or one less. Nothing is verified, only copied. The header comes last, so that a
/// folder with a header is complete. Returns the root of the tree of digests.
///
/// Throws InputError if the text is no certificate of a space form of version 2, or has fewer labels than chunks, or
/// there are fewer than 2; or if the folder has a header.
std::string write_chunks(const std::string& certificate, std::size_t chunks, const std::filesystem::path& folder);

}  // namespace delcert
