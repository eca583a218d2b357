#include "proofs/report/page.hpp"

#include <fmt/format.h>
#include <nettle/base64.h>
#include <nettle/sha2.h>

#include <array>

#include "delcert_version.hpp"
#include "proofs/report/page_sources.hpp"

namespace delcert {

namespace {

/// As content security policies have it: "sha256-…".
std::string hash_source(std::string_view text) {
  sha256_ctx hash{};
  sha256_init(&hash);
  sha256_update(&hash, text.size(), reinterpret_cast<const std::uint8_t*>(text.data()));
  std::array<std::uint8_t, SHA256_DIGEST_SIZE> digest{};
  sha256_digest(&hash, digest.size(), digest.data());
  std::string result(BASE64_ENCODE_RAW_LENGTH(digest.size()), '\0');
  base64_encode_raw(result.data(), digest.size(), digest.data());
  return "sha256-" + result;
}

/// JSON that no parser of HTML takes for anything else: ASCII, and without "<".
std::string inert_text(const nlohmann::ordered_json& json) {
  std::string result;
  for (const char letter : json.dump(-1, ' ', true, nlohmann::ordered_json::error_handler_t::replace)) {
    if (letter == '<')
      result += "\\u003c";
    else
      result += letter;
  }
  return result;
}

}  // namespace

std::string html_page(const std::vector<PageItem>& items) { return html_page(items, page_script(), page_style()); }

std::string html_page(const std::vector<PageItem>& items, std::string_view script, std::string_view style) {
  nlohmann::ordered_json data{{"version", version}, {"items", nlohmann::ordered_json::array()}};
  std::string blocks;
  for (std::size_t at = 0; at < items.size(); ++at) {
    data["items"].push_back(items[at].data);
    if (items[at].block.empty()) continue;
    blocks += fmt::format("<script type=\"text/plain\" id=\"delcert-block-{}\">{}</script>\n", at, items[at].block);
  }
  return fmt::format(
      R"(<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; script-src '{}'; style-src '{}'; base-uri 'none'; form-action 'none'">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="generator" content="delcert {}">
<title>delcert report</title>
<style>{}</style>
</head>
<body>
<header><h1>delcert report</h1></header>
<main><p>The page is being made; it needs JavaScript, and no network.</p></main>
<footer></footer>
<script type="application/json" id="delcert-data">{}</script>
{}<script>{}</script>
</body>
</html>
)",
      hash_source(script), hash_source(style), version, style, inert_text(data), blocks, script);
}

}  // namespace delcert
