#include "proofs/replay/product.hpp"

#include <algorithm>
#include <cstdlib>

namespace delcert::replay {

Sign sign_of(const Product& product, const std::function<Sign(std::size_t factor)>& sign_of_factor) {
  const auto vanishes_nowhere = [&](std::size_t factor) {
    const Sign sign = sign_of_factor(factor);
    return sign && std::abs(*sign) == 2;
  };
  for (const std::size_t divisor : product.divisors) {
    if (!vanishes_nowhere(divisor)) return std::nullopt;
  }
  int result = 2 * product.constant.sign();
  for (const auto& [factor, exponent] : product.powers) {
    if (exponent < 0 && !vanishes_nowhere(factor)) return std::nullopt;
    if (result == 0) continue;
    Sign sign = sign_of_factor(factor);
    if (exponent % 2 == 0) sign = sign ? std::abs(*sign) : 1;
    if (!sign) return std::nullopt;
    const bool negative = (result < 0) != (*sign < 0);
    const int size = *sign == 0 ? 0 : std::min(std::abs(result), std::abs(*sign));
    result = negative ? -size : size;
  }
  return result;
}

}  // namespace delcert::replay
