#pragma once

#include <array>
#include <string>
#include <string_view>

#include "kernel/number/rational.hpp"
#include "support/toml_reader.hpp"

namespace delcert {

/// What messages say of numbers in manifold files.
inline constexpr std::string_view exact_number_expected =
    "an exact number: an integer, or a string such as \"3/4\" or \"0x3p-2\"";

/// A number in a manifold file; messages call it `what`. Fails, at its place in the file, for what is not exact.
[[nodiscard]] Rational exact_number(const TomlReader& reader, const toml::node& node, const std::string& what);

/// The two ends of an interval, a pair of such numbers, the second above the first.
[[nodiscard]] std::array<Rational, 2> exact_interval(const TomlReader& reader, const toml::node& node,
                                                     const std::string& what);

}  // namespace delcert
