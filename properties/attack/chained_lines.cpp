#include "properties/attack/chained_lines.hpp"

#include <fstream>
#include <nlohmann/json.hpp>

#include "proofs/certificate/sha256.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view before_sum = ",\"sum\":\"";
constexpr std::string_view after_sum = "\"}";
constexpr std::size_t digits = 64;
constexpr std::size_t length_of_ending = before_sum.size() + digits + after_sum.size();

std::string sum_of(const std::string& previous, const std::string& object) {
  Sha256 hash;
  hash.update(previous);
  hash.update(object);
  return hash.digest();
}

}  // namespace

std::string Chain::seal(const Json& object) {
  std::string text = object.dump();
  sum_ = sum_of(sum_, text);
  text.pop_back();
  text.append(before_sum).append(sum_).append(after_sum);
  return text;
}

Json Chain::open(const std::string& line) {
  const std::size_t end = line.size() < length_of_ending ? 0 : line.size() - length_of_ending;
  const std::string_view ending = std::string_view(line).substr(end);
  if (end == 0 || !ending.starts_with(before_sum) || !ending.ends_with(after_sum)) {
    throw InputError("there is no sum at its end: it is cut off, or no line of a log");
  }
  const std::string object = line.substr(0, end) + "}";
  std::string sum = sum_of(sum_, object);
  if (ending.substr(before_sum.size(), digits) != sum) {
    throw InputError(
        "its sum is not that of this line after those before it: a line was changed, doubled, left out or put in");
  }
  sum_ = std::move(sum);
  return Json::parse(object);
}

ChainedFile read_chained_lines(const std::filesystem::path& path, const std::string& kind, Chain& chain,
                               const std::function<void(const Json&, std::size_t)>& read) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw InputError(path.string() + ": cannot be read");
  ChainedFile result;
  for (std::string line; std::getline(stream, line);) {
    if (stream.eof()) {
      result.torn = std::move(line);
      break;
    }
    const std::string where = path.string() + ":" + std::to_string(++result.lines) + ": ";
    try {
      read(chain.open(line), result.lines);
    } catch (const nlohmann::json::exception& error) {
      throw InputError(where + "not a line of " + kind + ": " + error.what());
    } catch (const InputError& error) {
      throw InputError(where + error.what());
    }
    result.whole += line.size() + 1;
  }
  if (stream.bad()) throw InputError(path.string() + ": cannot be read");
  return result;
}

}  // namespace delcert
