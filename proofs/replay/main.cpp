#include <algorithm>
#include <fstream>
#include <iostream>
#include <string>

#include "proofs/replay/number.hpp"
#include "proofs/replay/replay.hpp"

namespace {

constexpr int accepted = 0;
constexpr int rejected = 1;
constexpr int malformed = 3;
constexpr int usage = 64;
constexpr int internal = 70;

constexpr const char* help =
    "Usage: delcert-replay LOG...\n\n"
    "Checks logs that delcert prove --log has written, with arithmetic of its own.\n"
    "Exit status: 0 accepted, 1 rejected, 3 no log, 64 usage, 70 internal.\n";

int replay_file(const std::string& path) {
  using namespace delcert::replay;
  std::ifstream file(path);
  if (!file) {
    std::cerr << "delcert-replay: error: " << path << ": cannot be read\n";
    return malformed;
  }
  try {
    const Totals totals = replay(file);
    std::cout << "accepted " << path << ": " << totals.steps << " steps, " << totals.goals << " goals, "
              << totals.leaves << " leaves\n";
    return accepted;
  } catch (const Rejected& error) {
    std::cout << "rejected " << path << ": " << error.what() << "\n";
    return rejected;
  } catch (const Malformed& error) {
    std::cerr << "delcert-replay: error: " << path << ": " << error.what() << "\n";
    return malformed;
  } catch (const std::exception& error) {
    std::cerr << "delcert-replay: error: internal: " << path << ": " << error.what() << "\n";
    return internal;
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::cerr << help;
    return usage;
  }
  int worst = accepted;
  for (int at = 1; at < argc; ++at) {
    const std::string argument = argv[at];
    if (argument == "--help" || argument == "-h") {
      std::cout << help;
      return accepted;
    }
    worst = std::max(worst, replay_file(argument));
  }
  return worst;
}
