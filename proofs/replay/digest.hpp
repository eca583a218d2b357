#pragma once

#include <string>
#include <string_view>

namespace delcert::replay {

/// The SHA-256 of a text, as 64 lower-case hexadecimal digits: what sha256sum prints of a file with this text.
std::string sha256_of(std::string_view text);

}  // namespace delcert::replay
