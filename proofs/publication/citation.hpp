#pragma once

#include <string>
#include <vector>

#include "proofs/certificate/reader.hpp"

namespace delcert {

/// Something that a paper refers to.
struct Reference {
  std::string key;   ///< for \cite
  std::string type;  ///< of BibTeX: "article", "misc"
  /// Of BibTeX, name → plain text. Authors are separated by " and ", family name first.
  std::vector<std::pair<std::string, std::string>> fields;
};

/// The article of Boissonnat, Dyer and Ghosh, as CITATION.cff has it.
[[nodiscard]] Reference reference_of_paper();
/// delcert, of this version.
[[nodiscard]] Reference reference_of_software();
/// A certificate: its manifold, size, levels as claimed, the version that made it, its SHA-256. The key is of the
/// digest. Throws InputError where the seal is wrong.
[[nodiscard]] Reference reference_of(const CertificateSummary& certificate);

/// An entry for BibTeX; letters that it would change stand in braces.
[[nodiscard]] std::string bibtex_of(const Reference& reference);
/// One line for a list of references in plain text, with a line feed.
[[nodiscard]] std::string text_of(const Reference& reference);

}  // namespace delcert
