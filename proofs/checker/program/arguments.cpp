#include "proofs/checker/program/arguments.hpp"

#include <getopt.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <string_view>

#include "proofs/checker/report/report.hpp"

namespace delcert::checker {
namespace {

constexpr const char* help =
    R"(Re-verifies delcert certificates, independently of the program that made them.
Prints one line for each level; only if every checked level holds is the word "verified" printed.

Usage: delcert-check [OPTIONS] FILE…
       delcert-check --part K/N --receipt RECEIPT FILE
       delcert-check --chunk K --receipt RECEIPT FOLDER
       delcert-check --merge RECEIPT… [FILE]

  FILE                    certificates, plain or compressed with zstd
  -h, --help              print this page and end
  --version               print the version and end
  --levels LEVELS         check these levels only, and those on which they rest
  --expect-manifold FILE  reject a certificate unless its manifold is that of this one
  --time-limit SECONDS    end undecided after so many seconds, for each FILE
  --memory-limit MIB      end undecided where more than so many MiB would be in use, for each FILE
  --threads N             divide the work among so many processes; says the same (default 1)
  --part K/N              check part K of N, 1 <= K <= N
  --chunk K               check chunk K of the certificate in chunks in FOLDER
  --receipt RECEIPT       write what the part or the chunk has found to this file
  --merge                 put the receipts of all parts together: say what a check of the whole would have said.
                          Whoever merges receipts trusts those who made them. With FILE: they are of this certificate
  --json                  print one JSON object for each FILE, each in one line
  --quiet                 print nothing; the exit status tells
  --report FILE           write the outcome of all, the checker's version, the host and the time to this file, as JSON

Examples:
  delcert-check torus.json.zst                 every level that is claimed
  delcert-check *.json.zst --quiet             0 only if all are verified
  delcert-check torus.json --levels 0,1        levels 0 and 1, and 2, on which level 1 rests
  delcert-check torus.json --expect-manifold other.json   verified only if both speak of the same manifold
  delcert-check unknown.json --time-limit 60 --memory-limit 1024
  for k in 1 2 3 4; do delcert-check torus.json --part $k/4 --receipt $k.receipt; done
  delcert-check --merge *.receipt torus.json   verified only if all parts are there, and found nothing wrong
  delcert-check torus.json --json | jq .status the outcome for a program

Exit status: 0 verified, 1 a check failed, 2 a check could not be decided, 3 malformed certificate or
unreadable file, 64 wrong usage, 70 internal error (among them: the self-test of the arithmetic fails).
With --part, 0 says that this part found nothing wrong. With --merge, 1 also says that receipts are there twice,
overlap or do not add up; 2 that one is missing; 3 that one is broken or of another certificate or checker.
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
  part,
  receipt,
  merge,
  chunk,
  version,
  without_rule
};

constexpr std::array<option, 16> known = {{{"help", no_argument, nullptr, 'h'},
                                           {"version", no_argument, nullptr, version},
                                           {"levels", required_argument, nullptr, levels},
                                           {"expect-manifold", required_argument, nullptr, expect_manifold},
                                           {"time-limit", required_argument, nullptr, time_limit},
                                           {"memory-limit", required_argument, nullptr, memory_limit},
                                           {"threads", required_argument, nullptr, threads},
                                           {"json", no_argument, nullptr, json},
                                           {"quiet", no_argument, nullptr, quiet},
                                           {"report", required_argument, nullptr, report},
                                           {"part", required_argument, nullptr, part},
                                           {"receipt", required_argument, nullptr, receipt},
                                           {"merge", no_argument, nullptr, merge},
                                           {"chunk", required_argument, nullptr, chunk},
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

/// "K/N".
Share share_of(std::string_view text) {
  constexpr std::uint64_t most = 1'000'000;
  Share share{0, 0};
  const char* const end = text.data() + text.size();
  const auto [slash, error] = std::from_chars(text.data(), end, share.number);
  const bool begun = error == std::errc() && slash != end && *slash == '/';
  const auto [last, fault] = std::from_chars(begun ? slash + 1 : end, end, share.of);
  if (!begun || fault != std::errc() || last != end || share.number < 1 || share.number > share.of || share.of > most)
    throw std::invalid_argument("--part: expected K/N with 1 <= K <= N <= 1000000, found " + std::string(text));
  return share;
}

std::uint64_t chunk_of(std::string_view text) {
  std::uint64_t result = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), result);
  if (error != std::errc() || end != text.data() + text.size() || result < 1 || result > 1'000'000)
    throw std::invalid_argument("--chunk: expected a number from 1 to 1000000, found " + std::string(text));
  return result;
}

/// Throws std::invalid_argument unless the options go together.
void require_together(const Arguments& arguments, bool has_part) {
  const auto require = [](bool holds, const char* what) {
    if (!holds) throw std::invalid_argument(what);
  };
  require(!arguments.files.empty(), "FILE is required");
  const bool selects = !arguments.levels.empty() || !arguments.expected.empty();
  const bool has_chunk = arguments.chunk > 0;
  require(!has_part || !has_chunk, "--part and --chunk exclude one another");
  require((has_part || has_chunk) == !arguments.receipt.empty(),
          has_chunk ? "--chunk needs --receipt" : "--part and --receipt need one another");
  require(!has_chunk || arguments.files.size() == 1, "--chunk is for one FOLDER");
  require(!has_chunk || !selects, "--chunk checks all levels: without --levels and --expect-manifold");
  require(!has_part || arguments.files.size() == 1, "--part is for one FILE");
  require(!has_part || !selects, "--part checks all levels: without --levels and --expect-manifold");
  require(!arguments.merge || (!has_part && !has_chunk && !selects && arguments.seconds == 0 &&
                               arguments.mebibytes == 0 && arguments.threads == 1),
          "--merge checks nothing: of the options only --json, --quiet and --report go with it");
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
  bool has_part = false;
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
      case part:
        arguments.part = share_of(::optarg);
        has_part = true;
        break;
      case chunk:
        arguments.chunk = chunk_of(::optarg);
        break;
      case receipt:
        arguments.receipt = ::optarg;
        break;
      case merge:
        arguments.merge = true;
        break;
#ifdef DELCERT_CHECK_TESTING
      case without_rule:
        rule_left_out() = ::optarg;
        break;
#endif
      case ':':
        throw std::invalid_argument(std::string(argv[::optind - 1]) + ": expected a value");
      default:
        throw std::invalid_argument(std::string(argv[::optind - 1]) + ": no such option");
    }
  }
  arguments.files.assign(argv + ::optind, argv + argc);
  require_together(arguments, has_part);
  return arguments;
}

}  // namespace delcert::checker
