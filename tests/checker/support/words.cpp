#include "tests/checker/support/words.hpp"

#include <map>

namespace delcert::checker_tests {
namespace {

using Translation = std::vector<int>;

/// The number of the word for a translation; it is appended if there is none yet, and before it the one a step nearer
/// to the identity.
int word_for(const Translation& shift, std::map<Translation, int>& numbers, Json& words) {
  if (const auto found = numbers.find(shift); found != numbers.end()) return found->second;
  std::size_t axis = 0;
  while (shift[axis] == 0) ++axis;
  const int sign = shift[axis] > 0 ? 1 : -1;
  Translation nearer = shift;
  nearer[axis] -= sign;
  const int parent = word_for(nearer, numbers, words);
  words.push_back({parent, sign * static_cast<int>(axis + 1)});
  return numbers[shift] = static_cast<int>(words.size());
}

}  // namespace

void write_elements_as_words(Json& document) {
  const std::size_t m = document["manifold"]["dimension"].get<std::size_t>();
  std::map<Translation, int> numbers{{Translation(m, 0), 0}};
  Json words = Json::array();
  std::vector<int> renumbered{0};
  for (const Json& shift : document["elements"])
    renumbered.push_back(word_for(shift.get<Translation>(), numbers, words));
  document["elements"] = words;
  for (Json& simplex : document["simplices"]) {
    for (std::size_t k = m + 1; k <= 2 * m; ++k) simplex[k] = renumbered[simplex[k].get<std::size_t>()];
  }
}

}  // namespace delcert::checker_tests
