#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace delcert {

/// What a page shows: a certificate or a witness.
struct PageItem {
  nlohmann::ordered_json data;  ///< as report/src/main.js reads it, with the key `kind`
  std::string block;            ///< of the drawing, base64; empty for none
};

/// One HTML document that shows the items and asks nothing of any network: script and style are in it, and its content
/// security policy allows these two alone, by their hashes. Whatever the texts of the items hold, they stay data: no
/// text ends an element of the page.
[[nodiscard]] std::string html_page(const std::vector<PageItem>& items);

/// The same with another script and style. Precondition: neither holds "</".
[[nodiscard]] std::string html_page(const std::vector<PageItem>& items, std::string_view script,
                                    std::string_view style);

}  // namespace delcert
