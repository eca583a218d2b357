#include "proofs/certificate/simplex_file.hpp"

#include <nlohmann/json.hpp>

#include "proofs/certificate/file_text.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

using Json = nlohmann::ordered_json;

/// The value of this key of the whole, as the only one that is kept.
Json only(const char* key, const std::string& text) {
  bool is_kept = false;
  const Json result = Json::parse(text, [&](int depth, Json::parse_event_t event, const Json& parsed) {
    if (depth == 1 && event == Json::parse_event_t::key) is_kept = parsed == key;
    return depth == 0 || is_kept;
  });
  if (!result.is_object() || !result.contains(key)) throw InputError(std::string("has no key \"") + key + "\"");
  return result.at(key);
}

/// Of 2m + 1 integers the first m + 1 are labels.
PureComplex complex_of(const Json& simplices) {
  std::vector<std::uint32_t> labels;
  std::size_t size = 0;
  for (const Json& row : simplices) {
    const auto integers = row.get<std::vector<std::uint32_t>>();
    const std::string name = "simplices[" + std::to_string(&row - &simplices[0]) + "]";
    if (size == 0) size = integers.size();
    if (integers.size() % 2 == 0 || integers.size() < 3 || integers.size() > 9)
      throw InputError(name + " has " + std::to_string(integers.size()) + " integers, not 3, 5, 7 or 9");
    if (integers.size() != size)
      throw InputError(name + " has " + std::to_string(integers.size()) + " integers, not " + std::to_string(size));
    labels.insert(labels.end(), integers.begin(), integers.begin() + static_cast<std::ptrdiff_t>(size / 2 + 1));
  }
  if (labels.empty()) throw InputError("has no simplices");
  return {Dimension(static_cast<int>(size / 2)), labels};
}

}  // namespace

PureComplex read_simplices(const std::filesystem::path& path) {
  const std::string text = read_text(path);
  try {
    return complex_of(only("simplices", text));
  } catch (const Json::exception& error) {
    throw InputError(path.string() + ": " + error.what());
  } catch (const InputError& error) {
    throw InputError(path.string() + ": " + error.what());
  }
}

}  // namespace delcert
