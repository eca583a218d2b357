#include "proofs/publication/bundle.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "delcert_version.hpp"
#include "proofs/certificate/certificate_facts.hpp"
#include "proofs/certificate/sha256.hpp"
#include "proofs/certificate/summary_json.hpp"
#include "proofs/drawing/drawing.hpp"
#include "proofs/drawing/formats/export_format.hpp"
#include "proofs/publication/citation.hpp"
#include "support/error.hpp"
#include "support/utc_time.hpp"

namespace delcert {

namespace {

using BundleJson = nlohmann::ordered_json;

/// Names that shells and archives take as they are.
bool is_plain_name(const std::string& name) {
  return !name.empty() && name[0] != '.' && name[0] != '-' &&
         name.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789._-") ==
             std::string::npos;
}

std::string stem_of(std::string file) {
  for (const char* ending : {".zst", ".json"}) {
    if (file.ends_with(ending)) file.resize(file.size() - std::string_view(ending).size());
  }
  return file;
}

std::string digest_of_bytes(const std::string& bytes) {
  Sha256 hash;
  hash.update(bytes);
  return hash.digest();
}

std::string json_file(const BundleJson& json) { return ascii_text(json, 2) + "\n"; }

/// A string for YAML: JSON's are.
std::string yaml_string(const std::string& text) { return ascii_text(BundleJson(text)); }

std::pair<std::string, std::string> parts_of_author(const std::string& author) {
  const std::size_t comma = author.find(", ");
  if (comma == std::string::npos) return {author, ""};
  return {author.substr(0, comma), author.substr(comma + 2)};
}

void require_facts(const std::vector<BundledCertificate>& certificates, const BundleFacts& facts) {
  if (facts.title.empty()) throw InputError("a bundle needs a title");
  if (facts.authors.empty()) throw InputError("a bundle needs an author");
  if (certificates.empty()) throw InputError("a bundle needs a certificate");
  try {
    (void)parse_utc(facts.date + "T00:00:00Z");
  } catch (const InputError&) {
    throw InputError("a bundle needs a day of publication such as 2026-05-31, and not \"" + facts.date + "\"");
  }
  std::set<std::string> stems;
  for (const BundledCertificate& each : certificates) {
    if (!is_plain_name(each.file)) {
      throw InputError(each.file +
                       ": the name of a certificate in a bundle has only letters of ASCII, digits, \".\", "
                       "\"_\" and \"-\", and begins with a letter or a digit");
    }
    if (!stems.insert(stem_of(each.file)).second)
      throw InputError(each.file + ": there is another certificate of this name");
    try {
      require_seal(each.certificate);
    } catch (const InputError& error) {
      throw InputError(each.file + ": " + error.what());
    }
  }
}

void add_exports(std::vector<ArchiveFile>& files, const BundledCertificate& each) {
  const int m = each.certificate.manifold.dimension.value;
  std::vector<const char*> names;
  if (m <= 3) names.push_back("vtu");
  if (m == 2) names.push_back("off");
  if (names.empty()) return;
  const Drawing drawing = drawing_of(each.certificate, {});
  for (const char* name : names) {
    const ExportFormat& format = export_format(name);
    const ExportContent content{.certificate = each.certificate, .drawing = &drawing};
    files.push_back({fmt::format("exports/{}.{}", stem_of(each.file), name), format.text(content)});
  }
}

/// How the checker in the bundle is built.
constexpr const char* text_about_checker =
    "\n`checker/` is the source of delcert-check and builds with nothing else of delcert. Its packages on Debian are "
    "cmake, g++, pkg-config, "
    "libflint-dev (on Debian 12 also libflint-arb-dev), libgmp-dev, libzstd-dev, nettle-dev and nlohmann-json3-dev:\n\n"
    "    cmake -S checker/proofs/checker -B build && cmake --build build && export PATH=$PWD/build:$PATH\n";

std::string readme_text(const std::vector<BundledCertificate>& certificates, const BundleFacts& facts,
                        bool has_checker) {
  std::string text =
      "# " + ascii_text(BundleJson(facts.title)) + "\n\nCertificates of Delaunay triangulations, made with delcert " +
      version +
      ".\n\n"
      "* `certificates/`: what is claimed, exactly.\n"
      "* `manifolds/`: the manifold that each of them is about, for comparison.\n"
      "* `exports/`: the complexes in approximate coordinates, for other programs. They prove nothing.\n"
      "* `references.bib`: how to cite them.\n\n"
      "| certificate | manifold | points | simplices | SHA-256 of its content |\n|---|---|--:|--:|---|\n";
  for (const BundledCertificate& each : certificates) {
    std::string name = ascii_text(BundleJson(each.certificate.manifold.name));
    std::replace(name.begin(), name.end(), '|', '/');
    text += fmt::format("| `{}` | {} | {} | {} | `{}` |\n", each.file, name, each.certificate.points.size(),
                        each.certificate.simplices.size(), each.certificate.seal);
  }
  if (has_checker) text += text_about_checker;
  text +=
      "\nWhether the files are as they were, and whether the certificates hold:\n\n```console\n"
      "$ sha256sum -c SHA256SUMS\n";
  for (const BundledCertificate& each : certificates) {
    text += fmt::format("$ delcert-check --expect-manifold manifolds/{}.json certificates/{}\n", stem_of(each.file),
                        each.file);
  }
  return text + "```\n";
}

std::string citation_text(const BundleFacts& facts) {
  std::string text =
      "cff-version: 1.2.0\nmessage: \"If these certificates matter to your work, please cite them.\"\n"
      "type: dataset\ntitle: " +
      yaml_string(facts.title) + "\nauthors:\n";
  for (const std::string& author : facts.authors) {
    const auto [family, given] = parts_of_author(author);
    text += given.empty()
                ? "  - name: " + yaml_string(family) + "\n"
                : "  - family-names: " + yaml_string(family) + "\n    given-names: " + yaml_string(given) + "\n";
  }
  text += "date-released: " + yaml_string(facts.date) + "\n";
  if (!facts.license.empty()) text += "license: " + yaml_string(facts.license) + "\n";
  return text;
}

std::string description_of(const std::vector<BundledCertificate>& certificates) {
  std::string text = fmt::format("Certificates of Delaunay triangulations, made with delcert {}, of:", version);
  for (const BundledCertificate& each : certificates)
    text += (text.ends_with(':') ? " " : ", ") + each.certificate.manifold.name;
  return text;
}

BundleJson zenodo_json(const std::vector<BundledCertificate>& certificates, const BundleFacts& facts) {
  BundleJson json{{"title", facts.title},
                  {"upload_type", "dataset"},
                  {"description", description_of(certificates)},
                  {"publication_date", facts.date},
                  {"creators", BundleJson::array()},
                  {"keywords", {"Delaunay triangulation", "manifold", "certified computation"}}};
  for (const std::string& author : facts.authors) json["creators"].push_back({{"name", author}});
  if (!facts.license.empty()) json["license"] = facts.license;
  return json;
}

std::string license_address(const BundleFacts& facts) { return "https://spdx.org/licenses/" + facts.license; }

BundleJson person_json(const std::string& author) {
  const auto [family, given] = parts_of_author(author);
  if (given.empty()) return {{"@type", "Organization"}, {"name", family}};
  return {{"@type", "Person"}, {"familyName", family}, {"givenName", given}};
}

BundleJson codemeta_json(const std::vector<BundledCertificate>& certificates, const BundleFacts& facts) {
  BundleJson json{{"@context", "https://doi.org/10.5063/schema/codemeta-2.0"},
                  {"@type", "Dataset"},
                  {"name", facts.title},
                  {"description", description_of(certificates)},
                  {"datePublished", facts.date},
                  {"author", BundleJson::array()}};
  for (const std::string& author : facts.authors) json["author"].push_back(person_json(author));
  if (!facts.license.empty()) json["license"] = license_address(facts);
  json["softwareRequirements"] = std::string("delcert ") + version;
  return json;
}

std::string media_type(const std::string& name) {
  for (const auto& [ending, type] : {std::pair{".zst", "application/zstd"},
                                     {".json", "application/json"},
                                     {".md", "text/markdown"},
                                     {".vtu", "application/xml"}}) {
    if (name.ends_with(ending)) return type;
  }
  return "text/plain";
}

/// By https://w3id.org/ro/crate/1.1: the root has a name, a description, a date and a license.
BundleJson crate_json(const std::vector<ArchiveFile>& files, const std::vector<BundledCertificate>& certificates,
                      const BundleFacts& facts) {
  BundleJson parts = BundleJson::array();
  BundleJson entities = BundleJson::array();
  for (const ArchiveFile& file : files) {
    parts.push_back({{"@id", file.name}});
    entities.push_back({{"@id", file.name},
                        {"@type", "File"},
                        {"name", file.name},
                        {"encodingFormat", media_type(file.name)},
                        {"contentSize", std::to_string(file.bytes.size())}});
  }
  BundleJson root{{"@id", "./"},
                  {"@type", "Dataset"},
                  {"name", facts.title},
                  {"description", description_of(certificates)},
                  {"datePublished", facts.date},
                  {"license", "No license is stated."},
                  {"author", BundleJson::array()},
                  {"hasPart", parts}};
  for (std::size_t at = 0; at < facts.authors.size(); ++at) {
    const std::string id = "#author-" + std::to_string(at + 1);
    root["author"].push_back({{"@id", id}});
    BundleJson person = person_json(facts.authors[at]);
    person["@id"] = id;
    entities.push_back(person);
  }
  if (!facts.license.empty()) {
    root["license"] = {{"@id", license_address(facts)}};
    entities.push_back({{"@id", license_address(facts)},
                        {"@type", "CreativeWork"},
                        {"name", facts.license},
                        {"description", "The license of this identifier in the list of SPDX."}});
  }
  BundleJson graph = BundleJson::array({{{"@id", "ro-crate-metadata.json"},
                                         {"@type", "CreativeWork"},
                                         {"conformsTo", {{"@id", "https://w3id.org/ro/crate/1.1"}}},
                                         {"about", {{"@id", "./"}}}},
                                        root});
  for (const BundleJson& entity : entities) graph.push_back(entity);
  return {{"@context", "https://w3id.org/ro/crate/1.1/context"}, {"@graph", graph}};
}

}  // namespace

std::vector<ArchiveFile> bundle_files(const std::vector<BundledCertificate>& certificates, const BundleFacts& facts,
                                      const std::vector<ArchiveFile>& checker) {
  require_facts(certificates, facts);
  std::vector<ArchiveFile> files{{"README.md", readme_text(certificates, facts, !checker.empty())},
                                 {"CITATION.cff", citation_text(facts)},
                                 {".zenodo.json", json_file(zenodo_json(certificates, facts))},
                                 {"codemeta.json", json_file(codemeta_json(certificates, facts))}};
  std::string references = bibtex_of(reference_of_paper()) + "\n" + bibtex_of(reference_of_software());
  for (const BundledCertificate& each : certificates) references += "\n" + bibtex_of(reference_of(each.certificate));
  files.push_back({"references.bib", references});
  for (const BundledCertificate& each : certificates) {
    files.push_back({"certificates/" + each.file, each.bytes});
    files.push_back({"manifolds/" + stem_of(each.file) + ".json", each.certificate.manifold_text + "\n"});
    try {
      add_exports(files, each);
    } catch (const InputError& error) {
      throw InputError(each.file + ": " + error.what());
    }
  }
  files.insert(files.end(), checker.begin(), checker.end());
  files.push_back({"ro-crate-metadata.json", json_file(crate_json(files, certificates, facts))});
  std::string sums;
  for (const ArchiveFile& file : files) sums += digest_of_bytes(file.bytes) + "  " + file.name + "\n";
  files.push_back({"SHA256SUMS", sums});
  return files;
}

}  // namespace delcert
