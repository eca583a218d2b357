#include "proofs/checker/program/check_report.hpp"

#include <flint/flint.h>
#include <gmp.h>
#include <sys/utsname.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <system_error>

namespace delcert::checker {
namespace {

constexpr std::array<int, 6> from_worst = {70, 64, 1, 3, 2, 0};

std::string time_of_day() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  std::array<char, 32> text{};
  if (::gmtime_r(&now, &parts) == nullptr) return "";
  return {text.data(), std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &parts)};
}

nlohmann::ordered_json host() {
  utsname names{};
  if (::uname(&names) != 0) return nullptr;
  return {{"name", names.nodename}, {"system", names.sysname}, {"release", names.release}, {"machine", names.machine}};
}

}  // namespace

int worst_status(const std::vector<FileOutcome>& outcomes) {
  for (const int status : from_worst) {
    if (std::any_of(outcomes.begin(), outcomes.end(), [&](const FileOutcome& one) { return one.status == status; }))
      return status;
  }
  return from_worst.front();
}

std::string report_text(const std::vector<std::string>& files, const std::vector<FileOutcome>& outcomes) {
  nlohmann::ordered_json certificates = nlohmann::ordered_json::array();
  for (std::size_t k = 0; k < outcomes.size(); ++k) {
    const FileOutcome& outcome = outcomes[k];
    if (outcome.error.empty()) {
      certificates.push_back(nlohmann::ordered_json::parse(outcome.json));
    } else {
      certificates.push_back(
          {{"file", files[k]}, {"status", "error"}, {"exit", outcome.status}, {"error", outcome.error}});
    }
  }
  const nlohmann::ordered_json report = {{"format", "delcert-check-report"},
                                         {"version", 1},
                                         {"checker",
                                          {{"version", DELCERT_CHECK_VERSION},
                                           {"flint", std::string(::flint_version)},
                                           {"gmp", std::string(::gmp_version)}}},
                                         {"host", host()},
                                         {"time", time_of_day()},
                                         {"exit", worst_status(outcomes)},
                                         {"certificates", certificates}};
  return report.dump(2, ' ', true, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

void write_whole(const std::string& path, const std::string& text) {
  const std::string temporary = path + "." + std::to_string(::getpid()) + ".part";
  std::ofstream file(temporary, std::ios::binary);
  file << text;
  file.close();
  if (file.good() && std::rename(temporary.c_str(), path.c_str()) == 0) return;
  const std::string reason = std::generic_category().message(errno);
  std::remove(temporary.c_str());
  throw std::runtime_error(path + ": cannot be written: " + reason);
}

}  // namespace delcert::checker
