#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <iostream>
#include <stdexcept>

#include "proofs/checker/input.hpp"
#include "proofs/checker/library_self_test.hpp"
#include "proofs/checker/limits.hpp"
#include "proofs/checker/report.hpp"
#include "proofs/checker/run.hpp"
#include "proofs/checker/self_test.hpp"

namespace {

constexpr int unreadable_file = 3, usage_error = 64, internal_error = 70;

constexpr const char* description =
    "Re-verifies a delcert certificate, independently of the program that made it.\n"
    "Prints one line for each level; only if every checked level holds is the word \"verified\" printed.";

constexpr const char* examples =
    "Examples:\n"
    "  delcert-check torus.json.zst                 every level that is claimed\n"
    "  delcert-check torus.json --levels 0,1        levels 0 and 1, and 2, on which level 1 rests\n"
    "  delcert-check torus.json --expect-manifold other.json   verified only if both speak of the same manifold\n"
    "  delcert-check unknown.json --time-limit 60 --memory-limit 1024\n"
    "  delcert-check torus.json --json | jq .status the outcome for a program\n\n"
    "Exit status: 0 verified, 1 a check failed, 2 a check could not be decided, 3 malformed certificate or\n"
    "unreadable file, 64 wrong usage, 70 internal error (among them: the self-test of the arithmetic fails).";

/// What is wrong with this file is no fault of the certificate.
std::string read_expected(const std::string& file) {
  using namespace delcert::checker;
  try {
    const std::string document = decompressed(read_bytes(file));
    if (document.empty()) throw std::invalid_argument(file + ": is empty");
    return document;
  } catch (const Malformed& reason) {
    throw std::invalid_argument(file + ": " + reason.what());
  }
}

int run(int argc, char** argv) {
  using namespace delcert::checker;
  CLI::App app{description, "delcert-check"};
  app.footer(examples);
  app.set_version_flag("--version", DELCERT_CHECK_VERSION);
  std::string file;
  std::vector<std::string> levels;
  std::string expected_file;
  bool json = false, quiet = false;
  double seconds = 0, mebibytes = 0;
  app.add_option("FILE", file, "the certificate, plain or compressed with zstd")->required();
  app.add_option("--levels", levels, "check these levels only, and those on which they rest")
      ->delimiter(',')
      ->allow_extra_args(false);
  app.add_option("--expect-manifold", expected_file, "reject the certificate unless its manifold is that of this one")
      ->type_name("FILE");
  app.add_option("--time-limit", seconds, "end undecided after so many seconds")->check(CLI::PositiveNumber);
  app.add_option("--memory-limit", mebibytes, "end undecided where more than so many MiB would be in use")
      ->check(CLI::Range(16.0, 0x1p40));
  app.add_flag("--json", json, "print one JSON object");
  app.add_flag("--quiet", quiet, "print nothing; the exit status tells");
#ifdef DELCERT_CHECK_TESTING
  app.add_option("--without-rule", Report::without_rule, "leave out a rule, to test the tests");
#endif
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : usage_error;
  }
  const auto print = [&](const Outcome& outcome) {
    return quiet ? std::string() : json ? as_json(file, outcome) : as_text(outcome);
  };
  try {
    const auto words = [&](const std::string& what) {
      Outcome limit;
      limit.status = 2;
      limit.levels.push_back({"limit", 2, what, {}, seconds});
      return print(limit);
    };
    if (mebibytes > 0)
      limit_memory(static_cast<std::uint64_t>(mebibytes * 0x1p20), words("the limit of memory was reached"));
    if (seconds > 0) limit_time(seconds, words("the limit of time was reached"));
    std::string fault = self_test();
    if (fault.empty()) fault = library_self_test();
    if (!fault.empty()) {
      std::cerr << "delcert-check: refusing to check anything: " << fault << "\n";
      return internal_error;
    }
    Outcome outcome;
    try {
      const std::string expected = expected_file.empty() ? "" : read_expected(expected_file);
      std::string bytes = read_bytes(file);
      const std::string digest = sha256(bytes);
      outcome = check(decompressed(std::move(bytes)), levels, expected);
      if (outcome.identity) outcome.identity->file_digest = digest;
    } catch (const Malformed& reason) {
      outcome.status = 3;
      outcome.malformed = Finding{reason.rule, reason.what()};
    }
    lift_time_limit();
    std::cout << print(outcome);
    return outcome.status;
  } catch (const Unreadable& reason) {
    std::cerr << "delcert-check: error: " << reason.what() << "\n";
    return unreadable_file;
  } catch (const std::invalid_argument& reason) {
    std::cerr << "delcert-check: " << reason.what() << "\n";
    return usage_error;
  } catch (const std::exception& error) {
    std::cerr << "delcert-check: internal error: " << error.what() << "\n";
    return internal_error;
  }
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (...) {
    return 70;
  }
}
