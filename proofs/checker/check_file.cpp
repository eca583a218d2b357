#include "proofs/checker/check_file.hpp"

#include <csignal>
#include <iostream>
#include <stdexcept>

#include "proofs/checker/input.hpp"
#include "proofs/checker/library_self_test.hpp"
#include "proofs/checker/limits.hpp"
#include "proofs/checker/parts.hpp"
#include "proofs/checker/run.hpp"
#include "proofs/checker/self_test.hpp"
#include "proofs/checker/separate_process.hpp"

namespace delcert::checker {
namespace {

constexpr int unreadable_file = 3, usage_error = 64, internal_error = 70;

/// The words of an outcome come out of its process as one text: for a person, a zero, for a program. An error is what
/// follows two zeros.
std::string both(const std::string& file, const Outcome& outcome) {
  return as_text(outcome) + '\0' + as_json(file, outcome);
}
int fail(int status, const std::string& reason) {
  std::cout << std::string(2, '\0') << reason;
  return status;
}

/// What is wrong with this file is no fault of the certificate.
std::string read_expected(const std::string& file) {
  try {
    const std::string document = decompressed(read_bytes(file));
    if (document.empty()) throw std::invalid_argument(file + ": is empty");
    return document;
  } catch (const Malformed& reason) {
    throw std::invalid_argument(file + ": " + reason.what());
  }
}

void set_limits(const std::string& file, const Arguments& arguments) {
  const auto words = [&](const std::string& what) {
    Outcome limit;
    limit.status = 2;
    limit.levels.push_back({"limit", 2, what, {}, arguments.seconds});
    return both(file, limit);
  };
  if (arguments.mebibytes > 0)
    limit_memory(static_cast<std::uint64_t>(arguments.mebibytes * 0x1p20), words("the limit of memory was reached"));
  if (arguments.seconds > 0) limit_time(arguments.seconds, words("the limit of time was reached"));
}

int check_here(const std::string& file, const Arguments& arguments) {
  try {
    set_limits(file, arguments);
    most_parts = arguments.threads;
    std::string fault = self_test();
    if (fault.empty()) fault = library_self_test();
    if (!fault.empty()) return fail(internal_error, "refusing to check anything: " + fault);
    Outcome outcome;
    try {
      const std::string expected = arguments.expected.empty() ? "" : read_expected(arguments.expected);
      std::string bytes = read_bytes(file);
      const std::string digest = sha256(bytes);
      outcome = check(decompressed(std::move(bytes)), arguments.levels, expected);
      if (outcome.identity) outcome.identity->file_digest = digest;
    } catch (const Malformed& reason) {
      outcome.status = 3;
      outcome.malformed = Finding{reason.rule, reason.what()};
    }
    lift_time_limit();
    std::cout << both(file, outcome);
    return outcome.status;
  } catch (const Unreadable& reason) {
    return fail(unreadable_file, reason.what());
  } catch (const std::invalid_argument& reason) {
    return fail(usage_error, reason.what());
  } catch (const std::exception& error) {
    return fail(internal_error, std::string("internal: ") + error.what());
  }
}

}  // namespace

FileOutcome check_file(const std::string& file, const Arguments& arguments) {
  const Ended ended = SeparateProcess([&] { return check_here(file, arguments); }).end();
  FileOutcome outcome;
  outcome.status = ended.status;
  if (ended.signal != 0) {
    outcome.error = file + ": the check was ended by signal " + std::to_string(ended.signal);
    return outcome;
  }
  const std::size_t zero = ended.output.find('\0');
  if (zero == std::string::npos) {
    outcome.status = internal_error;
    outcome.error = file + ": the check ended without an outcome";
  } else if (zero == 0) {
    outcome.error = ended.output.substr(2);
  } else {
    outcome.text = ended.output.substr(0, zero);
    outcome.json = ended.output.substr(zero + 1);
  }
  return outcome;
}

}  // namespace delcert::checker
