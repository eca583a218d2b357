#pragma once

#include <cstddef>
#include <cstdint>

namespace delcert {

/// The labels first … last − 1: those of one process, where several make a triangulation together.
struct LabelRange {
  std::uint32_t first = 0;
  std::uint32_t last = 0;

  [[nodiscard]] std::size_t size() const { return last - first; }
  [[nodiscard]] bool contains(std::uint32_t label) const { return first <= label && label < last; }
  friend bool operator==(const LabelRange&, const LabelRange&) = default;
};

/// All labels of something that has a size.
template <class Sized>
[[nodiscard]] LabelRange all_labels_of(const Sized& sized) {
  return {0, static_cast<std::uint32_t>(sized.size())};
}

}  // namespace delcert
