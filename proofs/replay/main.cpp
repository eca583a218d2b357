#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <set>
#include <string>
#include <vector>

#include "proofs/replay/digest.hpp"
#include "proofs/replay/number.hpp"
#include "proofs/replay/replay.hpp"

namespace {

constexpr int accepted = 0;
constexpr int rejected = 1;
constexpr int malformed = 3;
constexpr int usage = 64;
constexpr int internal = 70;

constexpr const char* help =
    "Usage: delcert-replay [--claims FILE|FOLDER]... LOG...\n\n"
    "Checks logs that delcert prove --log has written, with arithmetic of its own, against the steps that the claims'\n"
    "files state, which it reads itself. It has the files of the library; --claims adds others, TOML files or all\n"
    "files of a folder, which take precedence over those of the same name. Without --claims, a log of a claim that is\n"
    "not in the library is compared with the text of the claim that it carries.\n"
    "Exit status: 0 accepted, 1 rejected, 3 no log or no claim, 64 usage, 70 internal.\n";

std::string content_of(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::string text{std::istreambuf_iterator<char>(file), {}};
  if (!file || text.empty()) throw delcert::replay::Malformed(path.string() + ": cannot be read");
  return text;
}

void add_claims_of(delcert::replay::StatedClaims& claims, const std::filesystem::path& path) {
  if (!std::filesystem::is_directory(path)) return add_claim(claims, content_of(path), path.string());
  std::set<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(path)) {
    if (entry.path().extension() == ".toml") files.insert(entry.path());
  }
  for (const auto& file : files) add_claim(claims, content_of(file), file.string());
}

/// "3 of 7 steps of proofs/claims/x.toml", or of what the log itself states.
std::string share_text(const delcert::replay::Totals& totals) {
  return std::to_string(totals.proved.size()) + " of " + std::to_string(totals.stated.steps.size()) + " steps of " +
         (totals.by_its_own_text ? totals.claim + " as the text in the log states it (SHA-256 " + totals.stated.sha256 +
                                       "; --claims compares with a file)"
                                 : totals.stated.source);
}

/// Of a log that was compared with no file: whether the one that it was written for is here, with another text.
bool has_changed_since(const delcert::replay::Totals& totals) {
  if (!totals.by_its_own_text || !std::filesystem::is_regular_file(totals.file)) return false;
  std::ifstream file(totals.file);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  return delcert::replay::sha256_of(text) != totals.stated.sha256;
}

int replay_file(const std::string& path, const delcert::replay::StatedClaims& claims,
                delcert::replay::UnknownClaim unknown) {
  using namespace delcert::replay;
  std::ifstream file(path);
  if (!file) {
    std::cerr << "delcert-replay: error: " << path << ": cannot be read\n";
    return malformed;
  }
  try {
    const Totals totals = replay(file, claims, unknown);
    std::cout << "accepted " << path << ": " << share_text(totals) << ", " << totals.goals << " goals, "
              << totals.leaves << " leaves\n";
    if (has_changed_since(totals)) std::cout << totals.file << " has changed since " << path << " was written\n";
    return accepted;
  } catch (const Rejected& error) {
    std::cout << "rejected " << path << ":" << error.line() << ": " << error.what() << "\n";
    return rejected;
  } catch (const Malformed& error) {
    std::cerr << "delcert-replay: error: " << path << ": " << error.what() << "\n";
    return malformed;
  } catch (const std::exception& error) {
    std::cerr << "delcert-replay: error: internal: " << path << ": " << error.what() << "\n";
    return internal;
  }
}

int run(const std::vector<std::string>& arguments) {
  std::vector<std::string> logs;
  std::vector<std::string> files;
  for (std::size_t at = 0; at < arguments.size(); ++at) {
    const std::string& argument = arguments[at];
    if (argument == "--help" || argument == "-h") {
      std::cout << help;
      return accepted;
    }
    if (argument == "--claims") {
      if (++at == arguments.size()) break;
      files.push_back(arguments[at]);
    } else {
      logs.push_back(argument);
    }
  }
  if (logs.empty()) {
    std::cerr << help;
    return usage;
  }
  delcert::replay::StatedClaims claims = delcert::replay::builtin_claims_as_stated();
  try {
    for (const std::string& file : files) add_claims_of(claims, file);
  } catch (const delcert::replay::Malformed& error) {
    std::cerr << "delcert-replay: error: " << error.what() << "\n";
    return malformed;
  }
  // Whoever names files says what is to be proved; else a log says it.
  using delcert::replay::UnknownClaim;
  const UnknownClaim unknown = files.empty() ? UnknownClaim::by_the_log : UnknownClaim::rejected;
  int worst = accepted;
  for (const std::string& log : logs) worst = std::max(worst, replay_file(log, claims, unknown));
  return worst;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run({argv + 1, argv + argc});
  } catch (const std::exception& error) {
    std::cerr << "delcert-replay: error: internal: " << error.what() << "\n";
    return internal;
  }
}
