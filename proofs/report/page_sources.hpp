#pragma once

#include <string_view>

namespace delcert {

/// report/page.js and report/page.css, as they are in the library. The definitions are generated
/// (cmake/EmbedFiles.cmake).
[[nodiscard]] std::string_view page_script();
[[nodiscard]] std::string_view page_style();

}  // namespace delcert
