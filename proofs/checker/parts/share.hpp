#pragma once

#include <cstdint>
#include <utility>

namespace delcert::checker {

/// Which part of a check is done here, and of how many: of each loop, the items from (number - 1) / of to number / of
/// of it. What is not divided is done in every part if others rest on it, and counted in the first one only.
struct Share {
  std::uint64_t number = 1, of = 1;
  bool is_whole() const { return of == 1; }
};
inline Share own_share;
/// The first item of that share, and the one after the last. Precondition: below 2^32 parts.
std::pair<std::uint64_t, std::uint64_t> range_of(const Share& share, std::uint64_t size);

}  // namespace delcert::checker
