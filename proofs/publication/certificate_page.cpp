#include "proofs/publication/certificate_page.hpp"

#include <fstream>
#include <nlohmann/json.hpp>

#include "proofs/certificate/sha256.hpp"
#include "proofs/publication/ledger_text.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

/// Which Hypotheses 2 level 0 names.
ParameterConstraints constraints_of(const CertificateSummary& certificate) {
  for (const auto& [level, entries] : certificate.levels) {
    if (level != "0") continue;
    for (const auto& [key, text] : entries) {
      if (key == "hypotheses" && text == name_of(ParameterConstraints::sharper)) return ParameterConstraints::sharper;
    }
  }
  return ParameterConstraints::printed;
}

/// The paper's constants for the parameters of a certificate; null where the paper does not speak of such parameters.
nlohmann::ordered_json ledger_of(const CertificateSummary& certificate) {
  try {
    const Ledger ledger = constants_for(
        certificate.manifold.dimension, certificate.parameter("separation"), certificate.parameter("perturbation"),
        certificate.parameter("radius_variation"), certificate.parameter("distortion"), constraints_of(certificate));
    return nlohmann::ordered_json::parse(ledger_json(ledger)).at("constants");
  } catch (const InputError&) {
    return nullptr;
  }
}

}  // namespace

ShownFile shown_file(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw InputError(path.string() + ": cannot be read");
  Sha256 hash;
  std::string part(1U << 20U, '\0');
  while (stream.read(part.data(), static_cast<std::streamsize>(part.size())), stream.gcount() > 0)
    hash.update(std::string_view(part).substr(0, static_cast<std::size_t>(stream.gcount())));
  if (stream.bad()) throw InputError(path.string() + ": cannot be read");
  return {path.filename().string(), hash.digest()};
}

PageItem certificate_page_item(const std::filesystem::path& path, const std::function<CheckRecord()>& check) {
  const CertificateSummary certificate = read_certificate(path);
  PageItem item =
      certificate_item(certificate, shown_file(path), check ? std::optional(check()) : std::optional<CheckRecord>());
  item.data["ledger"] = ledger_of(certificate);
  return item;
}

}  // namespace delcert
