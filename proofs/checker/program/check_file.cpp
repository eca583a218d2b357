#include "proofs/checker/program/check_file.hpp"

#include <algorithm>
#include <csignal>
#include <future>
#include <iostream>
#include <stdexcept>

#include "proofs/checker/certificate/input.hpp"
#include "proofs/checker/parts/meanwhile.hpp"
#include "proofs/checker/parts/parts.hpp"
#include "proofs/checker/parts/separate_process.hpp"
#include "proofs/checker/program/library_self_test.hpp"
#include "proofs/checker/program/limits.hpp"
#include "proofs/checker/program/merge.hpp"
#include "proofs/checker/program/receipt.hpp"
#include "proofs/checker/program/self_test.hpp"
#include "proofs/checker/run.hpp"

namespace delcert::checker {
namespace {

constexpr int unreadable_file = 3, usage_error = 64, internal_error = 70;

constexpr std::string_view seal_key = R"(,"sha256":")";

/// The words of an outcome come out of its process as one text: for a person, a zero, for a program, and, of a part, a
/// zero and the receipt. An error is what follows two zeros.
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

/// The SHA-256 with which a certificate is sealed.
std::string content_of(const std::string& text) {
  const std::size_t seal = text.rfind(seal_key);
  const bool is_certificate =
      text.starts_with(R"({"format":"delcert-certificate",)") || text.starts_with(R"({"format":"delcert-chunks",)");
  if (!is_certificate || seal == std::string::npos)
    throw Malformed("merge.receipt", "is neither a receipt nor a certificate");
  const std::string content = sha256(std::string_view(text).substr(0, seal));
  Report::require("seal", text.substr(seal) == R"(,"sha256":")" + content + "\"}\n",
                  "the SHA-256 of the content is not the one it is sealed with");
  return content;
}

void set_limits(const std::string& file, const Arguments& arguments) {
  const auto words = [&](const std::string& what) {
    Outcome limit;
    limit.status = 2;
    limit.levels.push_back({"limit", 2, what, {}, arguments.seconds, {}, {}, {}});
    return both(file, limit);
  };
  if (arguments.mebibytes > 0) {
    limit_memory(static_cast<std::uint64_t>(arguments.mebibytes * 0x1p20), words("the limit of memory was reached"));
  } else {
    keep_memory();
  }
  if (arguments.seconds > 0) limit_time(arguments.seconds, words("the limit of time was reached"));
}

int print(const std::string& file, const Arguments& arguments, const Outcome& outcome) {
  lift_time_limit();
  std::cout << both(file, outcome);
  if (!arguments.receipt.empty() && outcome.identity)
    std::cout << '\0' << receipt_text({DELCERT_CHECK_VERSION, outcome});
  return outcome.status;
}

int check_here(const std::string& file, const Arguments& arguments) {
  try {
    set_limits(file, arguments);
    most_parts = arguments.threads;
    own_share = arguments.part;
    std::string fault = self_test();
    if (fault.empty()) fault = library_self_test();
    if (!fault.empty()) return fail(internal_error, "refusing to check anything: " + fault);
    Outcome outcome;
    try {
      if (arguments.chunk > 0) return print(file, arguments, check_chunk(file, arguments.chunk - 1));
      const std::string expected = arguments.expected.empty() ? "" : read_expected(arguments.expected);
      const std::string bytes = read_bytes(file);
      const bool is_text = bytes.starts_with('{');
      std::string digest;
      std::future<DigestOfBeginning> sealed = meanwhile([&] {
        DigestOfBeginning beginning;  // in a text, what is sealed
        digest = sha256(bytes, is_text ? std::min(bytes.rfind(seal_key), bytes.size()) : 0, beginning);
        return beginning;
      });
      const std::string unpacked = is_text ? "" : decompressed(bytes);
      outcome = check(is_text ? bytes : unpacked, arguments.levels, expected, [&] { return sealed.get(); });
      if (outcome.identity) outcome.identity->file_digest = digest;
    } catch (const Malformed& reason) {
      outcome.status = 3;
      outcome.malformed = Finding{reason.rule, reason.what()};
    }
    return print(file, arguments, outcome);
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
    const std::size_t second = std::min(ended.output.find('\0', zero + 1), ended.output.size());
    outcome.json = ended.output.substr(zero + 1, second - zero - 1);
    if (second < ended.output.size()) outcome.receipt = ended.output.substr(second + 1);
  }
  return outcome;
}

FileOutcome merge_files(const std::vector<std::string>& files) {
  FileOutcome result;
  const auto fail = [&](int status, const std::string& what) {
    result.status = status;
    result.error = what;
    return result;
  };
  std::vector<NamedReceipt> receipts;
  std::string certificate, content, digest;
  for (const std::string& file : files) {
    try {
      std::string bytes = read_bytes(file);
      if (looks_like_receipt(bytes)) {
        receipts.push_back({file, receipt_of(bytes)});
        continue;
      }
      if (!certificate.empty())
        return fail(unreadable_file, file + ": merge.receipt: is no receipt; nor is " + certificate);
      certificate = file;
      digest = sha256(bytes);
      content = content_of(decompressed(std::move(bytes)));
    } catch (const Malformed& reason) {
      return fail(unreadable_file, file + ": " + reason.rule + ": " + reason.what());
    } catch (const Unreadable& reason) {
      return fail(unreadable_file, reason.what());
    }
  }
  if (receipts.empty()) return fail(unreadable_file, certificate + ": merge.receipt: is no receipt");
  try {
    Outcome outcome = merged(std::move(receipts), DELCERT_CHECK_VERSION, content);
    if (!digest.empty()) outcome.identity->file_digest = digest;
    const std::string& name = certificate.empty() ? files.front() : certificate;
    result.status = outcome.status;
    result.text = as_text(outcome);
    result.json = as_json(name, outcome);
    return result;
  } catch (const Refused& reason) {
    return fail(reason.status, reason.rule + ": " + reason.what);
  }
}

}  // namespace delcert::checker
