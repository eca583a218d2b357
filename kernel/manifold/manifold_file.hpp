#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "kernel/number/rational.hpp"
#include "kernel/number/strong.hpp"

namespace delcert {

enum class ManifoldFamily { flat_torus, euclidean_ball };

/// "flat-torus" or "euclidean-ball", as in files and certificates.
[[nodiscard]] std::string_view name_of(ManifoldFamily family);

/// A manifold as a file describes it (docs/cli.md, "Manifold files").
struct ManifoldDescription {
  std::string name;
  ManifoldFamily family = ManifoldFamily::flat_torus;
  /// 1 to 4.
  Dimension dimension{1};
  /// The inner products of the frame's basis: symmetric and positive definite. The identity for a Euclidean ball.
  std::vector<std::vector<Rational>> gram;
  /// Of a Euclidean ball: above 0. Of a flat torus: 0, without meaning.
  Rational radius;
};

/// Reads a description in TOML; `source` is the file's name for messages. Throws InputError with file, line, column,
/// key, what was found and what was expected.
[[nodiscard]] ManifoldDescription parse_manifold(std::string_view text, const std::string& source);

}  // namespace delcert
