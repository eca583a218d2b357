#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "apps/commands.hpp"
#include "proofs/certificate/chunks.hpp"
#include "proofs/certificate/file_text.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

struct SplitOptions {
  std::string file;
  std::string folder;
  std::size_t chunks = 0;
};

ExitStatus split_certificate(const SplitOptions& options) {
  std::string root;
  try {
    root = write_chunks(read_text(options.file), options.chunks, options.folder);
  } catch (const InputError& error) {
    const std::string what = error.what();
    throw InputError(what.starts_with(options.file) || what.starts_with(options.folder) ? what
                                                                                        : options.file + ": " + what);
  }
  std::cout << "chunks  " << options.chunks << "\nroot    " << root << "\nfolder  " << options.folder << "\n";
  return ExitStatus::verified;
}

}  // namespace

void add_split(CLI::App& program, Action& chosen) {
  const auto options = std::make_shared<SplitOptions>();
  CLI::App* command =
      program.add_subcommand("split", "Divide a certificate into chunks, each of which a machine can check on its own");
  command->add_option("CERTIFICATE", options->file, "A certificate of a space form, plain or compressed")->required();
  command->add_option("--chunks", options->chunks, "How many, at least 2")->required()->type_name("N");
  command->add_option("--output", options->folder, "The folder of the chunks, which is made")
      ->required()
      ->type_name("FOLDER");
  command->footer(
      "The folder has a header and N files, each with consecutive labels and all simplices that have one of them.\n"
      "delcert-check --chunk K reads what it needs of it (docs/certificate-in-chunks.md).\n\n"
      "Examples:\n"
      "  delcert split sphere.json.zst --chunks 64 --output sphere\n"
      "  delcert-check --chunk 1 --receipt 1.receipt sphere");
  command->callback([options, &chosen] { chosen = [options] { return split_certificate(*options); }; });
}

}  // namespace delcert
