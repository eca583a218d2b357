#include "proofs/publication/bundle.hpp"

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <memory>

#include "apps/checker_source.hpp"
#include "apps/other_programs.hpp"
#include "support/atomic_file.hpp"
#include "support/error.hpp"
#include "support/utc_time.hpp"

namespace delcert {

namespace {

struct BundleOptions {
  std::vector<std::string> files;
  std::string output;
  BundleFacts facts;
  bool has_checker = true;
};

std::string bytes_of_file(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string bytes((std::istreambuf_iterator<char>(stream)), {});
  if (!stream) throw InputError(file + ": cannot be read");
  return bytes;
}

/// Today, in UTC; with SOURCE_DATE_EPOCH in the environment the day of that second (reproducible-builds.org).
std::string default_date() {
  auto time = std::chrono::system_clock::now();
  if (const char* epoch = std::getenv("SOURCE_DATE_EPOCH")) {
    char* end = nullptr;
    const long long seconds = std::strtoll(epoch, &end, 10);
    if (end == epoch || *end != 0 || seconds < 0 || seconds > 253402300799)
      throw InputError(std::string("SOURCE_DATE_EPOCH: \"") + epoch + "\" is no number of seconds since 1970");
    time = std::chrono::system_clock::time_point(std::chrono::seconds(seconds));
  }
  return utc_text(time).substr(0, 10);
}

ExitStatus write_bundle(const BundleOptions& options) {
  if (std::filesystem::exists(std::filesystem::symlink_status(options.output)))
    throw InputError(options.output + ": the file exists and is not replaced");
  std::vector<BundledCertificate> certificates;
  for (const std::string& file : options.files)
    certificates.push_back(
        {std::filesystem::path(file).filename().string(), bytes_of_file(file), read_certificate(file)});
  const std::vector<ArchiveFile> checker = options.has_checker ? checker_source() : std::vector<ArchiveFile>();
  BundleFacts facts = options.facts;
  if (facts.date.empty()) facts.date = default_date();
  const std::vector<ArchiveFile> files = bundle_files(certificates, facts, checker);
  write_file_atomically(options.output, zip_archive(files));
  std::cout << options.output << ": " << files.size() << " files, " << certificates.size()
            << (certificates.size() == 1 ? " certificate" : " certificates") << ", not verified"
            << (checker.empty() ? "" : ", and the source of the checker") << "\n";
  return ExitStatus::verified;
}

}  // namespace

void add_bundle(CLI::App& program, Action& chosen) {
  const auto options = std::make_shared<BundleOptions>();
  CLI::App* command = add_named(program, about_bundle);
  command->add_option("CERTIFICATE", options->files, "Certificates, plain or compressed")->required();
  command->add_option("--output", options->output, "The archive to write")->type_name("FILE")->required();
  command->add_option("--title", options->facts.title, "The title of the supplement")->required();
  command->add_option("--author", options->facts.authors, "\"Family, Given\"; may be repeated")
      ->required()
      ->allow_extra_args(false);
  command->add_option("--license", options->facts.license, "An SPDX identifier, for example CC-BY-4.0 (default: none)");
  command
      ->add_option("--date", options->facts.date,
                   "The day of publication (default: today, or that of $SOURCE_DATE_EPOCH)")
      ->type_name("YYYY-MM-DD");
  command->add_flag(
      "--checker,!--no-checker", options->has_checker,
      "Put the source of delcert-check into the archive, so that it can be built from there (the default)");
  command->footer(
      "Certificates, their manifolds, exports, checksums, references, and descriptions for Zenodo, CodeMeta and "
      "RO-Crate.\n"
      "The same files and the same day give the same bytes. Nothing is verified: run delcert check first.\n\n"
      "Examples:\n"
      "  delcert bundle torus.json.zst bolza.json.zst --title \"Supplement\" --author \"Doe, Jane\" --output "
      "supplement.zip");
  command->callback([options, &chosen] { chosen = [options] { return write_bundle(*options); }; });
}

}  // namespace delcert
