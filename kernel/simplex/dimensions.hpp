#pragma once

#include <cstddef>
#include <stdexcept>

#include "kernel/number/strong.hpp"

/// Instantiates X(m) for every dimension that the runs support.
#define DELCERT_FOR_EACH_DIMENSION(X) X(1) X(2) X(3) X(4)

namespace delcert {

inline constexpr int largest_run_dimension = 4;

/// How many vertices an m-simplex has.
template <int m>
inline constexpr std::size_t corners = static_cast<std::size_t>(m) + 1;

/// Calls `action.template operator()<m>()` for the dimension at hand.
/// Throws std::out_of_range unless 1 ≤ dimension ≤ largest_run_dimension.
template <class Action>
decltype(auto) with_dimension(Dimension dimension, const Action& action) {
  switch (dimension.value) {
    case 1:
      return action.template operator()<1>();
    case 2:
      return action.template operator()<2>();
    case 3:
      return action.template operator()<3>();
    case 4:
      return action.template operator()<4>();
    default:
      throw std::out_of_range("runs are for dimensions 1 to 4");
  }
}

}  // namespace delcert
