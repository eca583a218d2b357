#pragma once

#include <compare>
#include <concepts>
#include <cstdint>
#include <functional>

namespace delcert {

/// An integer with a meaning: built explicitly, comparable to its own kind only, no arithmetic.
template <class Tag, std::integral Representation>
struct Strong {
  Representation value = 0;

  constexpr Strong() = default;
  template <std::integral T>
  constexpr explicit Strong(T v) : value(static_cast<Representation>(v)) {}
  friend constexpr auto operator<=>(const Strong&, const Strong&) = default;
};

using Label = Strong<struct LabelTag, std::uint32_t>;
using Dimension = Strong<struct DimensionTag, int>;
using PrecisionBits = Strong<struct PrecisionBitsTag, unsigned>;

}  // namespace delcert

template <class Tag, class Representation>
struct std::hash<delcert::Strong<Tag, Representation>> {
  std::size_t operator()(const delcert::Strong<Tag, Representation>& strong) const {
    return std::hash<Representation>{}(strong.value);
  }
};
