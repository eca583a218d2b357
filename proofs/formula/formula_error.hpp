#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "kernel/error.hpp"

namespace delcert {

/// A formula that cannot be read or makes no sense, with the place in its text.
class FormulaError : public InputError {
 public:
  FormulaError(std::size_t offset, const std::string& message) : InputError(message), offset_(offset) {}

  /// The offset in the text of the formula, counted from 0, of what is wrong.
  [[nodiscard]] std::size_t offset() const { return offset_; }

 private:
  std::size_t offset_;
};

/// ", did you mean x?" for the candidate that is nearest to the word, empty if none is near.
template <class Words>
[[nodiscard]] std::string suggestion(std::string_view word, const Words& candidates);

/// The number of characters to insert, delete or replace to make one word of the other.
[[nodiscard]] std::size_t edit_distance(std::string_view a, std::string_view b);

template <class Words>
std::string suggestion(std::string_view word, const Words& candidates) {
  std::string best;
  std::size_t least = word.size() / 3 + 2;
  for (const std::string& candidate : candidates) {
    const std::size_t distance = edit_distance(word, candidate);
    if (distance < least) {
      least = distance;
      best = candidate;
    }
  }
  return best.empty() ? "" : ", did you mean " + best + "?";
}

}  // namespace delcert
