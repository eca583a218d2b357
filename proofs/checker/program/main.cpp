#include <cstdio>
#include <exception>
#include <iostream>
#include <stdexcept>

#include "proofs/checker/program/arguments.hpp"
#include "proofs/checker/program/check_file.hpp"
#include "proofs/checker/program/check_report.hpp"

namespace {

constexpr int usage_error = 64, internal_error = 70;

void name(const delcert::checker::FileOutcome& outcome, const delcert::checker::Arguments& arguments,
          const std::string& file) {
  if (outcome.error.empty() && !arguments.quiet && !arguments.json) std::cout << file << "\n";
}

void print(const delcert::checker::FileOutcome& outcome, const delcert::checker::Arguments& arguments) {
  if (!outcome.error.empty()) {
    std::cerr << "delcert-check: error: " << outcome.error << "\n";
  } else if (arguments.quiet) {
    return;
  } else if (arguments.json) {
    std::cout << outcome.json << std::flush;
  } else {
    std::cout << outcome.text << std::flush;
  }
}

int run(int argc, char** argv) {
  using namespace delcert::checker;
  const Arguments arguments = parse_arguments(argc, argv);
  if (!arguments.answer.empty()) {
    std::cout << arguments.answer;
    return 0;
  }
  std::vector<FileOutcome> outcomes;
  if (arguments.merge) {
    outcomes.push_back(merge_files(arguments.files));
    print(outcomes.back(), arguments);
  } else {
    for (const std::string& file : arguments.files) {
      outcomes.push_back(check_file(file, arguments));
      if (arguments.files.size() > 1) name(outcomes.back(), arguments, file);
      print(outcomes.back(), arguments);
    }
  }
  if (!outcomes.back().receipt.empty()) write_whole(arguments.receipt, outcomes.back().receipt);
  if (!arguments.report.empty()) write_whole(arguments.report, report_text(arguments.files, outcomes));
  return worst_status(outcomes);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::invalid_argument& reason) {
    std::cerr << "delcert-check: error: " << reason.what() << "\nRun with --help for more information.\n";
    return usage_error;
  } catch (const std::exception& error) {
    std::cerr << "delcert-check: error: internal: " << error.what() << "\n";
    return internal_error;
  }
}
