#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace delcert {

/// ", did you mean x?" for the candidate that is nearest to the word; if none is near, ", did you mean x, y or z?" for
/// those of which the word is the first part, as long as these are at most three. Else empty, also if the word is
/// longer than any that we use.
template <class Words>
[[nodiscard]] std::string suggestion(std::string_view word, const Words& candidates);

/// A text of a user for messages: on one line, without control characters, at most 60 bytes, never half a character.
[[nodiscard]] std::string shortened(std::string_view text);

/// The number of characters to insert, delete or replace to make one word of the other.
[[nodiscard]] std::size_t edit_distance(std::string_view a, std::string_view b);

/// The second kind of suggestion; the word has at least three characters.
template <class Words>
[[nodiscard]] std::string completion(std::string_view word, const Words& candidates) {
  std::vector<std::string_view> completed;
  for (const std::string_view candidate : candidates)
    if (word.size() >= 3 && candidate.starts_with(word)) completed.push_back(candidate);
  if (completed.empty() || completed.size() > 3) return "";
  std::string list(completed[0]);
  for (std::size_t i = 1; i < completed.size(); ++i) {
    list += i + 1 == completed.size() ? " or " : ", ";
    list += completed[i];
  }
  return ", did you mean " + list + "?";
}

template <class Words>
std::string suggestion(std::string_view word, const Words& candidates) {
  constexpr std::size_t longest = 64;
  if (word.size() > longest) return "";
  std::string best;
  // A word of which nothing would be left is no guess.
  std::size_t least = std::min(word.size() / 3 + 2, word.size());
  for (const std::string_view candidate : candidates) {
    const std::size_t distance = edit_distance(word, candidate);
    if (distance < least) {
      least = distance;
      best = candidate;
    }
  }
  return best.empty() ? completion(word, candidates) : ", did you mean " + best + "?";
}

}  // namespace delcert
