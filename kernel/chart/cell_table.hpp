#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace delcert {

/// A number below 2³² − 1 for each of some 64-bit keys, in one array: a key that is missing is found to be so after a
/// look or two, which is what queries of a grid in space mostly ask.
class CellTable {
 public:
  static constexpr std::uint32_t none = 0xffffffffU;

  CellTable() : slots_(64) {}

  /// That of the key; `none` for a key that is new.
  [[nodiscard]] std::uint32_t& at(std::uint64_t key) {
    if (2 * (used_ + 1) > slots_.size()) grow();
    Slot& slot = slots_[place_of(key)];
    if (slot.number == none) {
      slot.key = key;
      ++used_;
    }
    return slot.number;
  }
  /// That of the key, or `none`.
  [[nodiscard]] std::uint32_t find(std::uint64_t key) const { return slots_[place_of(key)].number; }

 private:
  struct Slot {
    std::uint64_t key = 0;
    std::uint32_t number = none;
  };

  /// Where the key is, or would be.
  [[nodiscard]] std::size_t place_of(std::uint64_t key) const {
    const std::size_t mask = slots_.size() - 1;
    // Fibonacci hashing: the upper bits of a product depend on all bits of the key.
    std::size_t place = static_cast<std::size_t>((key * 0x9e3779b97f4a7c15U) >> 32U) & mask;
    while (slots_[place].number != none && slots_[place].key != key) place = (place + 1) & mask;
    return place;
  }

  void grow() {
    std::vector<Slot> old(2 * slots_.size());
    std::swap(old, slots_);
    for (const Slot& slot : old) {
      if (slot.number != none) slots_[place_of(slot.key)] = slot;
    }
  }

  std::vector<Slot> slots_;
  std::size_t used_ = 0;
};

}  // namespace delcert
