#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "proofs/replay/number.hpp"

namespace delcert::replay {

/// left − right of a comparison = constant·Π factor^exponent, where no divisor vanishes.
struct Product {
  Number constant;
  std::vector<std::pair<std::size_t, long>> powers;
  std::vector<std::size_t> divisors;
};

/// −2 and 2: negative and positive; −1 and 1: not positive and not negative; 0: zero; none: unknown.
using Sign = std::optional<int>;

/// The sign of a product, given the signs of its factors. None where a divisor may vanish.
[[nodiscard]] Sign sign_of(const Product& product, const std::function<Sign(std::size_t factor)>& sign_of_factor);

}  // namespace delcert::replay
