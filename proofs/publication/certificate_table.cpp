#include "proofs/publication/certificate_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "kernel/number/decimal_bounds.hpp"
#include "kernel/number/exact_text.hpp"
#include "proofs/certificate/stated_levels.hpp"
#include "proofs/publication/citation.hpp"
#include "proofs/publication/exact_latex.hpp"
#include "proofs/publication/latex_table.hpp"
#include "support/latex_text.hpp"
#include "support/spelling.hpp"

namespace delcert {

namespace {

constexpr int digits_of_decimals = 4;
/// Longer words of a file may be broken.
constexpr std::size_t longest_word = 18;

std::string words_latex(const std::string& key) {
  std::string text = shortened(key);
  std::replace(text.begin(), text.end(), '_', ' ');
  return text.size() > longest_word && text.find(' ') == std::string::npos ? latex_breakable(text, 6)
                                                                           : latex_text(text);
}

/// Groups as `group_text` writes them: "Z^2 + Z/3", "(Z/2)^3".
std::string group_latex(const std::string& group) {
  std::string result;
  for (std::size_t at = 0; at < group.size(); ++at) {
    const char c = group[at];
    if (c == 'Z') {
      result += "\\mathbf{Z}";
    } else if (c == '+') {
      result += "\\oplus{}";
    } else if (c == '^') {
      const std::size_t end = std::min(group.find_first_not_of("0123456789", at + 1), group.size());
      result += "^{" + group.substr(at + 1, end - at - 1) + "}";
      at = end - 1;
    } else {
      result += c;
    }
  }
  return result;
}

std::string fact_latex(const LevelEntry& entry) {
  const auto value = nlohmann::ordered_json::parse(entry.json);
  if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
  if (value.is_number()) return "$" + value.dump() + "$";
  if (value.is_string()) return words_latex(value.get<std::string>());
  std::string groups;
  for (const auto& group : value) {
    const std::string text = group.get<std::string>();
    const bool is_group = text.find_first_not_of("Z0123456789/+^() ") == std::string::npos;
    groups += (groups.empty() ? "" : ", ") + (is_group ? "$" + group_latex(text) + "$" : words_latex(text));
  }
  return groups;
}

std::string whole_line(const std::string& text) {
  return "\\multicolumn{5}{@{}p{335pt}@{}}{\\raggedright " + text + "} \\\\\n";
}

}  // namespace

std::string safe_decimal(const Rational& x, Margin::Side side) {
  return side == Margin::Side::lower ? decimal_lower(x, digits_of_decimals) : decimal_upper(x, digits_of_decimals);
}

std::string safe_decimal_in_radii(const Margin& margin, const Rational& sampling_radius) {
  if (margin.unit == Margin::Unit::one) return "";
  const bool is_length = margin.unit == Margin::Unit::length;
  return safe_decimal(margin.value / (is_length ? sampling_radius : square(sampling_radius)), margin.side);
}

std::string certificate_latex(const CertificateSummary& certificate) {
  const Rational radius = certificate.parameter("sampling_radius");
  std::string text =
      "% As the certificate claims it; delcert check verifies it. Package: booktabs. References: delcert cite.\n"
      "{\\small\\setlength{\\tabcolsep}{4pt}%\n"
      "\\begin{tabular}{@{}lp{76pt}p{80pt}ll@{}}\n\\toprule\n";
  text +=
      whole_line(fmt::format("{}, dimension {}, $n = {}$ points, ${}$ simplices, $\\varepsilon = {}$",
                             latex_label(shortened(certificate.manifold.name)), certificate.manifold.dimension.value,
                             certificate.points.size(), certificate.simplices.size(), exact_latex(radius)));
  text += whole_line(fmt::format("\\cite{{{}}}, by \\cite{{{}}} with the algorithm of \\cite{{{}}}",
                                 reference_of(certificate).key, reference_of_software().key, reference_of_paper().key));
  text += "\\midrule\nlevel & claim & exactly & decimal & in $\\varepsilon$ \\\\\n\\midrule\n";
  for (const ClaimedLevel& level : stated_levels(certificate)) {
    std::string name = words_latex(level.name);
    if (level.entries.empty()) text += name + " & & & & \\\\\n";
    for (const LevelEntry& entry : level.entries) {
      const std::string key = "\\raggedright " + words_latex(entry.key);
      if (entry.margins.empty()) {
        text += fmt::format("{} & {} & \\multicolumn{{3}}{{p{{205pt}}@{{}}}}{{\\raggedright {}}} \\\\\n", name, key,
                            fact_latex(entry));
      }
      for (const Margin& margin : entry.margins) {
        const char* relation = margin.side == Margin::Side::lower ? "\\ge" : "\\le";
        std::string in_radii = safe_decimal_in_radii(margin, radius);
        if (!in_radii.empty()) {
          in_radii = fmt::format("${} {}{}$", relation, decimal_latex(in_radii),
                                 margin.unit == Margin::Unit::squared_length ? "\\,\\varepsilon^2" : "");
        }
        text += fmt::format("{} & {} & \\raggedright ${} {}$ & ${} {}$ & {} \\\\\n", name, key, relation,
                            exact_latex(margin.value), relation, decimal_latex(safe_decimal(margin.value, margin.side)),
                            in_radii);
        name.clear();
      }
      name.clear();
    }
  }
  text += "\\midrule\n" + whole_line("SHA-256 \\texttt{" + latex_breakable(certificate.seal, 8) + "}");
  return text + "\\bottomrule\n\\end{tabular}}\n";
}

}  // namespace delcert
