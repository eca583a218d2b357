#include "proofs/certificate/star_file.hpp"

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

PureComplex complex_of(const Json& stars) {
  std::vector<std::uint32_t> labels;
  std::size_t dimension = 0;
  std::uint32_t centre = 0;
  for (const Json& star : stars) {
    for (const Json& others : star) {
      const auto simplex = others.get<std::vector<std::uint32_t>>();
      if (dimension == 0) dimension = simplex.size();
      if (simplex.empty() || simplex.size() != dimension)
        throw InputError("stars[" + std::to_string(centre) + "] has a simplex with " + std::to_string(simplex.size()) +
                         " other labels, not " + std::to_string(dimension));
      labels.push_back(centre);
      for (const std::uint32_t label : simplex) {
        if (label >= stars.size())
          throw InputError("stars[" + std::to_string(centre) + "] has label " + std::to_string(label) + " of " +
                           std::to_string(stars.size()));
        labels.push_back(label);
      }
    }
    ++centre;
  }
  if (labels.empty()) throw InputError("has no simplex in its stars");
  return {Dimension(static_cast<int>(dimension)), labels};
}

}  // namespace

PureComplex read_star_complex(const std::filesystem::path& path) {
  const std::string text = read_text(path);
  try {
    return complex_of(only("stars", text));
  } catch (const Json::exception& error) {
    throw InputError(path.string() + ": " + error.what());
  } catch (const InputError& error) {
    throw InputError(path.string() + ": " + error.what());
  }
}

}  // namespace delcert
