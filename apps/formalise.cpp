#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>

#include "apps/claim_options.hpp"
#include "apps/other_programs.hpp"
#include "kernel/number/exact_text.hpp"
#include "proofs/formal/step_lemma.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

struct FormaliseOptions {
  ClaimOptions claims;
  std::vector<std::string> steps;
  std::vector<std::string> constants;
  std::string folder = ".";
};

/// A name with hyphens and dots, or with a digit first, as a name in Coq.
std::string coq_module(std::string name) {
  std::replace_if(
      name.begin(), name.end(), [](char c) { return c == '-' || c == '.'; }, '_');
  return std::isdigit(static_cast<unsigned char>(name.front())) != 0 ? "step_" + name : name;
}

/// The constants of a step, changed as the command line says. Throws InputError for what is no NAME=VALUE.
std::map<std::string, Rational> constants_of(const Step& step, const FormaliseOptions& options) {
  std::map<std::string, Rational> result = step.constants;
  for (const std::string& setting : options.constants) {
    const std::size_t equals = setting.find('=');
    if (equals == std::string::npos) throw InputError("--constant " + setting + ": expected NAME=VALUE");
    const auto found = result.find(setting.substr(0, equals));
    if (found == result.end()) throw InputError("--constant " + setting + ": " + step.name + " has no such constant");
    found->second = parse_exact(setting.substr(equals + 1));
  }
  return result;
}

void write(const std::filesystem::path& file, const std::string& text) {
  std::error_code error;
  std::filesystem::create_directories(file.parent_path(), error);
  if (error) throw InputError(file.parent_path().string() + ": the folder cannot be created: " + error.message());
  std::ofstream stream(file);
  stream << text;
  if (!stream.flush()) throw InputError(file.string() + ": cannot be written");
}

ExitStatus formalise(const FormaliseOptions& options) {
  std::size_t found = 0;
  for (const Claim& claim : claims_of(options.claims)) {
    for (const Step& step : claim.steps) {
      const auto& wanted = options.steps;
      if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), step.name) == wanted.end()) continue;
      ++found;
      const std::string module = coq_module(claim.name) + "__" + coq_module(step.name);
      const auto lemma = step_lemma(step, constants_of(step, options), coq_module(step.name));
      if (lemma) write(std::filesystem::path(options.folder) / (module + ".v"), lemma->file);
      const std::string_view method = lemma ? name_of(lemma->method) : "none";
      std::cout << module << " " << claim.name << "/" << step.name << " " << method << "\n";
    }
  }
  if (found == 0 && !options.steps.empty())
    throw InputError("no step of the claims named is called " + options.steps.front());
  return ExitStatus::verified;
}

}  // namespace

void add_formalise(CLI::App& program, Action& chosen) {
  CLI::App* command = add_named(program, about_formalise);
  const auto options = std::make_shared<FormaliseOptions>();
  add_claim_options(*command, options->claims);
  command->add_option("--step", options->steps, "Only the steps of this name; may be repeated");
  command->add_option("--constant", options->constants, "NAME=VALUE: another value for a constant of the steps");
  command->add_option("--into", options->folder, "The folder for the files")->capture_default_str();
  command->footer(
      "Writes a file for each step, a lemma about real numbers with its proof, and prints a line: the file's stem,\n"
      "the step, and the kind of proof: a certificate that Coq checks, a search by Coq's tactics, a refutation of a\n"
      "false step by the prover's counterexample, or none if Coq has no such formulas.\n"
      "Nothing is proved before coqc has accepted the files: proofs/formal/check.sh compiles them.\n\n"
      "Examples:\n"
      "  delcert formalise thickness-under-distortion --into build/coq\n"
      "  delcert formalise --all --into build/coq\n"
      "  delcert formalise circumcentres-under-distortion --step forty-two --constant c=41 --into build/coq");
  command->callback([options, &chosen] { chosen = [options] { return formalise(*options); }; });
}

}  // namespace delcert
