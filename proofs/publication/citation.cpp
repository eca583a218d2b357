#include "proofs/publication/citation.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "delcert_version.hpp"
#include "proofs/certificate/certificate_facts.hpp"
#include "support/latex_text.hpp"
#include "support/spelling.hpp"

namespace delcert {

namespace {

constexpr std::size_t digits_of_key = 12;

std::string field_of(const Reference& reference, const std::string& name) {
  const auto field = std::find_if(reference.fields.begin(), reference.fields.end(),
                                  [&](const auto& each) { return each.first == name; });
  return field == reference.fields.end() ? "" : field->second;
}

/// "A and B and C" as "A, B, C".
std::string list_of_authors(std::string authors) {
  constexpr std::string_view separator = " and ";
  for (std::size_t at = 0; (at = authors.find(separator)) != std::string::npos;)
    authors.replace(at, separator.size(), "; ");
  return authors;
}

std::string made_by(const CertificateSummary& certificate) {
  for (const auto& [name, version_text] : certificate.software) {
    if (name == "delcert") return " by delcert " + shortened(version_text);
  }
  return "";
}

}  // namespace

Reference reference_of_paper() {
  return {"boissonnat2018delaunay",
          "article",
          {{"author", "Boissonnat, Jean-Daniel and Dyer, Ramsay and Ghosh, Arijit"},
           {"title", "Delaunay triangulation of manifolds"},
           {"journal", "Foundations of Computational Mathematics"},
           {"volume", "18"},
           {"number", "2"},
           {"pages", "399-431"},
           {"year", "2018"},
           {"doi", "10.1007/s10208-017-9344-1"}}};
}

Reference reference_of_software() {
  return {"delcert",
          "misc",
          {{"author", "The delcert developers"},
           {"title", "delcert"},
           {"howpublished", "Software"},
           {"note", std::string("Version ") + version + ", GPL-3.0-or-later"}}};
}

Reference reference_of(const CertificateSummary& certificate) {
  require_seal(certificate);
  std::vector<std::string> levels;
  for (const auto& [level, margins] : certificate.levels) levels.push_back(shortened(level));
  const std::string title = "Certificate of a Delaunay triangulation of " + shortened(certificate.manifold.name);
  return {"delcert-" + certificate.seal.substr(0, digits_of_key),
          "misc",
          {{"key", "delcert certificate"},
           {"title", title},
           {"howpublished", fmt::format("Data, made{}", made_by(certificate))},
           {"note", fmt::format("{} points, {} simplices of dimension {}, levels {}; SHA-256 {}",
                                certificate.points.size(), certificate.simplices.size(),
                                certificate.manifold.dimension.value, fmt::join(levels, ", "), certificate.seal)}}};
}

std::string bibtex_of(const Reference& reference) {
  std::string result = fmt::format("@{}{{{}", reference.type, reference.key);
  for (const auto& [name, value] : reference.fields) {
    std::string text = latex_text(value);
    const std::size_t digest = text.find("SHA-256 ");
    if (digest != std::string::npos) {
      const std::size_t start = digest + 8;
      text = text.substr(0, start) + "\\texttt{" + latex_breakable(text.substr(start), 8) + "}";
    }
    // What is one name, and what has capitals of its own, stays as it is.
    const bool is_protected = name == "title" || (name == "author" && text.find(", ") == std::string::npos);
    if (is_protected) text = "{" + text + "}";
    if (name == "pages") text.replace(text.find('-'), 1, "--");
    result += fmt::format(",\n  {} = {{{}}}", name, text);
  }
  return result + "\n}\n";
}

std::string text_of(const Reference& reference) {
  std::string result = list_of_authors(field_of(reference, "author"));
  const auto add = [&](const std::string& text, const char* separator) {
    if (!text.empty()) result += (result.empty() ? "" : separator) + text;
  };
  add(field_of(reference, "title"), ": ");
  add(field_of(reference, "howpublished"), ". ");
  add(field_of(reference, "note"), ". ");
  if (const std::string journal = field_of(reference, "journal"); !journal.empty()) {
    add(fmt::format("{} {}({}), {}, {}", journal, field_of(reference, "volume"), field_of(reference, "number"),
                    field_of(reference, "pages"), field_of(reference, "year")),
        ". ");
  }
  if (const std::string doi = field_of(reference, "doi"); !doi.empty()) add("doi:" + doi, ". ");
  return result + ".\n";
}

}  // namespace delcert
