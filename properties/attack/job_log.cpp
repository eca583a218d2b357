#include "properties/attack/job_log.hpp"

#include <nlohmann/json.hpp>
#include <sstream>

#include "support/error.hpp"

namespace delcert {

namespace {
using Json = nlohmann::ordered_json;
}

JobLog::JobLog(const std::filesystem::path& path, std::string what, const std::string& identity, const ReadLine& read)
    : what_(std::move(what)) {
  if (path.empty()) return;
  std::error_code unknown;
  if (std::filesystem::is_directory(path, unknown)) throw InputError(path.string() + ": a folder, not a log");
  const bool is_new = !std::filesystem::exists(path, unknown) || read_lines(path, identity, read) == 0;
  out_.open(path, std::ios::binary | std::ios::app);
  if (is_new) out_ << first_line(identity) << std::endl;
  if (!out_) throw InputError(path.string() + ": the log of the " + what_ + " cannot be written");
}

std::string JobLog::first_line(const std::string& identity) const {
  return Json{{"delcert_" + what_, identity}}.dump();
}

std::size_t JobLog::read_lines(const std::filesystem::path& path, const std::string& identity,
                               const ReadLine& read) const {
  std::ifstream stream(path, std::ios::binary);
  std::stringstream buffer;
  buffer << stream.rdbuf();
  if (!stream) throw InputError(path.string() + ": cannot be read");
  const std::string text = buffer.str();
  std::size_t whole = 0;  // the end of the last whole line
  std::size_t number = 0;
  for (std::size_t end = text.find('\n'); end != std::string::npos; end = text.find('\n', whole)) {
    const std::string line = text.substr(whole, end - whole);
    whole = end + 1;
    const std::string where = path.string() + ":" + std::to_string(++number) + ": ";
    try {
      const Json json = Json::parse(line);
      if (number > 1) {
        read(json);
      } else if (json.at("delcert_" + what_) != identity) {
        throw InputError("the log of another " + what_ + ": other claims, other numbers or another version");
      }
    } catch (const nlohmann::json::exception& error) {
      throw InputError(where + "not a line of the log of a " + what_ + ": " + error.what());
    } catch (const InputError& error) {
      throw InputError(where + error.what());
    }
  }
  // What a crash cut off; but nothing is cut off from a file that was no log.
  const std::string rest = text.substr(whole);
  if (number == 0 && !first_line(identity).starts_with(rest)) {
    throw InputError(path.string() + ":1: not the first line of the log of this " + what_);
  }
  if (!rest.empty()) std::filesystem::resize_file(path, whole);
  return whole;
}

void JobLog::append(const Json& line) {
  if (!out_.is_open()) return;
  out_ << line.dump() << std::endl;
  if (!out_) throw std::runtime_error("the log of the " + what_ + " cannot be written");
}

}  // namespace delcert
