#pragma once

#include <string>
#include <vector>

#include "apps/exit_status.hpp"
#include "apps/search_options.hpp"

namespace delcert {

/// Along which quantity `tighten` searches, and for which values of it; not for k, whose values are those of the
/// shapes.
struct AlongOptions {
  std::string quantity;
  std::vector<Rational> values;
};

/// Searches for the worst ratio of each conclusion at each value, fits its exponent, and prints both exponents, the one
/// in the bound and the one found. Throws InputError where a claim has no such quantity, or there are fewer than three
/// values.
[[nodiscard]] ExitStatus run_growth(const SearchOptions& options, const AlongOptions& along);

}  // namespace delcert
