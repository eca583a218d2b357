#include "proofs/certificate/document.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "kernel/number/exact_text.hpp"

namespace delcert {

namespace {
constexpr std::size_t buffer_size = std::size_t{1} << 16U;
}

std::string quoted(const std::string& text) { return nlohmann::json(text).dump(); }

std::string number(const Rational& x) { return '"' + exact_text(x) + '"'; }

void Document::add(std::string_view text) {
  buffer_ += text;
  if (buffer_.size() >= buffer_size) flush();
}

void Document::seal() {
  flush();
  add(fmt::format(",\"sha256\":\"{}\"}}\n", sink_.digest()));
  flush();
  report();
  sink_.commit();
}

void Document::flush() {
  sink_.write(buffer_);
  buffer_.clear();
}

}  // namespace delcert
