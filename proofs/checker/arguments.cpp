#include "proofs/checker/arguments.hpp"

#include <getopt.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <string_view>

#include "proofs/checker/report.hpp"

namespace delcert::checker {
namespace {

constexpr const char* help =
    R"(Re-verifies delcert certificates, independently of the program that made them.
Prints one line for each level; only if every checked level holds is the word "verified" printed.

Usage: delcert-check [OPTIONS] FILE…

  FILE                    certificates, plain or compressed with zstd
  -h, --help              print this page and end
  --version               print the version and end
  --levels LEVELS         check these levels only, and those on which they rest
  --expect-manifold FILE  reject a certificate unless its manifold is that of this one
  --time-limit SECONDS    end undecided after so many seconds, for each FILE
  --memory-limit MIB      end undecided where more than so many MiB would be in use, for each FILE
  --threads N             divide the work among so many processes; says the same (default 1)
  --json                  print one JSON object for each FILE, each in one line
  --quiet                 print nothing; the exit status tells
  --report FILE           write the outcome of all, the checker's version, the host and the time to this file, as JSON

Examples:
  delcert-check torus.json.zst                 every level that is claimed
  delcert-check *.json.zst --quiet             0 only if all are verified
  delcert-check torus.json --levels 0,1        levels 0 and 1, and 2, on which level 1 rests
  delcert-check torus.json --expect-manifold other.json   verified only if both speak of the same manifold
  delcert-check unknown.json --time-limit 60 --memory-limit 1024
  delcert-check torus.json --json | jq .status the outcome for a program

Exit status: 0 verified, 1 a check failed, 2 a check could not be decided, 3 malformed certificate or
unreadable file, 64 wrong usage, 70 internal error (among them: the self-test of the arithmetic fails).
Of several files the worst counts: an internal error, then a check that failed, then a malformed certificate,
then one that is undecided.
)";

enum Option : int {
  levels,
  expect_manifold,
  time_limit,
  memory_limit,
  threads,
  json,
  quiet,
  report,
  version,
  without_rule
};

constexpr std::array<option, 12> known = {{{"help", no_argument, nullptr, 'h'},
                                           {"version", no_argument, nullptr, version},
                                           {"levels", required_argument, nullptr, levels},
                                           {"expect-manifold", required_argument, nullptr, expect_manifold},
                                           {"time-limit", required_argument, nullptr, time_limit},
                                           {"memory-limit", required_argument, nullptr, memory_limit},
                                           {"threads", required_argument, nullptr, threads},
                                           {"json", no_argument, nullptr, json},
                                           {"quiet", no_argument, nullptr, quiet},
                                           {"report", required_argument, nullptr, report},
#ifdef DELCERT_CHECK_TESTING
                                           {"without-rule", required_argument, nullptr, without_rule},
#else
                                           {nullptr, 0, nullptr, 0},
#endif
                                           {nullptr, 0, nullptr, 0}}};

double number(const char* name, std::string_view text, double least) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value) || value < least || value == 0)
    throw std::invalid_argument(std::string(name) + ": expected a number" +
                                (least > 0 ? " of at least " + std::to_string(static_cast<int>(least)) : " above 0") +
                                ", found " + std::string(text));
  return value;
}

void append_parts(std::vector<std::string>& parts, std::string_view text) {
  while (true) {
    const std::size_t comma = text.find(',');
    parts.emplace_back(text.substr(0, comma));
    if (comma == std::string_view::npos) return;
    text.remove_prefix(comma + 1);
  }
}

}  // namespace

Arguments parse_arguments(int argc, char** argv) {
  Arguments arguments;
  ::opterr = 0;
  for (int found = 0; (found = ::getopt_long(argc, argv, ":h", known.data(), nullptr)) != -1;) {
    switch (found) {
      case 'h':
        arguments.answer = help;
        return arguments;
      case version:
        arguments.answer = DELCERT_CHECK_VERSION "\n";
        return arguments;
      case levels:
        append_parts(arguments.levels, ::optarg);
        break;
      case expect_manifold:
        arguments.expected = ::optarg;
        break;
      case time_limit:
        arguments.seconds = number("--time-limit", ::optarg, 0);
        break;
      case memory_limit:
        arguments.mebibytes = number("--memory-limit", ::optarg, 16);
        break;
      case threads:
        arguments.threads = static_cast<unsigned>(std::min(number("--threads", ::optarg, 1), 1024.0));
        break;
      case json:
        arguments.json = true;
        break;
      case quiet:
        arguments.quiet = true;
        break;
      case report:
        arguments.report = ::optarg;
        break;
#ifdef DELCERT_CHECK_TESTING
      case without_rule:
        Report::without_rule = ::optarg;
        break;
#endif
      case ':':
        throw std::invalid_argument(std::string(argv[::optind - 1]) + ": expected a value");
      default:
        throw std::invalid_argument(std::string(argv[::optind - 1]) + ": no such option");
    }
  }
  arguments.files.assign(argv + ::optind, argv + argc);
  if (arguments.files.empty()) throw std::invalid_argument("FILE is required");
  return arguments;
}

}  // namespace delcert::checker
