#include "support/latex_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include "support/utf8.hpp"

namespace delcert {

namespace {

/// What titles of claims and names of manifolds are written with, in increasing order of code points.
constexpr std::array<std::pair<std::uint32_t, std::string_view>, 68> letters_in_latex{{
    {0xb2, R"($^2$)"},
    {0xb3, R"($^3$)"},
    {0xb7, R"($\cdot$)"},
    {0xb9, R"($^1$)"},
    {0xd7, R"($\times$)"},
    {0x393, R"($\Gamma$)"},
    {0x394, R"($\Delta$)"},
    {0x398, R"($\Theta$)"},
    {0x39b, R"($\Lambda$)"},
    {0x39e, R"($\Xi$)"},
    {0x3a0, R"($\Pi$)"},
    {0x3a3, R"($\Sigma$)"},
    {0x3a5, R"($\Upsilon$)"},
    {0x3a6, R"($\Phi$)"},
    {0x3a8, R"($\Psi$)"},
    {0x3a9, R"($\Omega$)"},
    {0x3b1, R"($\alpha$)"},
    {0x3b2, R"($\beta$)"},
    {0x3b3, R"($\gamma$)"},
    {0x3b4, R"($\delta$)"},
    {0x3b5, R"($\epsilon$)"},
    {0x3b6, R"($\zeta$)"},
    {0x3b7, R"($\eta$)"},
    {0x3b8, R"($\theta$)"},
    {0x3b9, R"($\iota$)"},
    {0x3ba, R"($\kappa$)"},
    {0x3bb, R"($\lambda$)"},
    {0x3bc, R"($\mu$)"},
    {0x3bd, R"($\nu$)"},
    {0x3be, R"($\xi$)"},
    {0x3bf, R"(o)"},
    {0x3c0, R"($\pi$)"},
    {0x3c1, R"($\rho$)"},
    {0x3c2, R"($\varsigma$)"},
    {0x3c3, R"($\sigma$)"},
    {0x3c4, R"($\tau$)"},
    {0x3c5, R"($\upsilon$)"},
    {0x3c6, R"($\phi$)"},
    {0x3c7, R"($\chi$)"},
    {0x3c8, R"($\psi$)"},
    {0x3c9, R"($\omega$)"},
    {0x2013, R"(--)"},
    {0x2018, R"(`)"},
    {0x2019, R"(')"},
    {0x201c, R"(``)"},
    {0x201d, R"('')"},
    {0x2026, R"(\dots{})"},
    {0x2080, R"($_0$)"},
    {0x2081, R"($_1$)"},
    {0x2082, R"($_2$)"},
    {0x2083, R"($_3$)"},
    {0x2084, R"($_4$)"},
    {0x2085, R"($_5$)"},
    {0x2086, R"($_6$)"},
    {0x2087, R"($_7$)"},
    {0x2088, R"($_8$)"},
    {0x2089, R"($_9$)"},
    {0x211d, R"($\mathbf{R}$)"},
    {0x2124, R"($\mathbf{Z}$)"},
    {0x2192, R"($\to$)"},
    {0x2208, R"($\in$)"},
    {0x2212, R"($-$)"},
    {0x221a, R"($\surd$)"},
    {0x221e, R"($\infty$)"},
    {0x2248, R"($\approx$)"},
    {0x2260, R"($\ne$)"},
    {0x2264, R"($\le$)"},
    {0x2265, R"($\ge$)"},
}};

}  // namespace

std::string latex_text(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const auto [length, code] = first_code_point(text);
    text.remove_prefix(length);
    if (code < 0x20 || code >= 0x7f) {
      const auto* known = std::find_if(letters_in_latex.begin(), letters_in_latex.end(),
                                       [code = code](const auto& letter) { return letter.first == code; });
      result += known == letters_in_latex.end() ? fmt::format("U+{:04X}", code) : std::string(known->second);
      continue;
    }
    const char c = static_cast<char>(code);
    if (c == '\\') {
      result += "\\textbackslash{}";
    } else if (c == '~' || c == '^') {
      result += std::string("\\") + c + "{}";
    } else {
      if (std::string_view("#$%&_{}").find(c) != std::string_view::npos) result += '\\';
      result += c;
    }
  }
  return result;
}

std::string latex_breakable(std::string_view word, std::size_t group) {
  std::string result;
  for (std::size_t letters = 0; !word.empty(); ++letters) {
    const std::size_t length = first_code_point(word).first;
    if (letters > 0 && letters % group == 0) result += "\\allowbreak ";
    result += latex_text(word.substr(0, length));
    word.remove_prefix(length);
  }
  return result;
}

}  // namespace delcert
