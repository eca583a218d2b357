#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "kernel/manifold/quotient/invariant_form.hpp"

namespace delcert {

/// A triangulation with group elements, as a file gives it (docs/complex-file.md): nothing of it is believed.
struct ComplexDescription {
  /// The lift w·p of a point p. Letter s > 0 is the s-th generator, −s its inverse; for curvature 0 the letters after
  /// those of the generators are the m translations by the basis of the lattice.
  struct Vertex {
    std::uint32_t label = 0;
    std::vector<std::int32_t> word;
  };

  std::string name;
  InvariantForm form;
  std::vector<std::string> generator_names;
  std::vector<FieldMatrix> generators;
  std::vector<std::string> point_names;
  std::vector<std::vector<Rational>> points;   ///< conformal coordinates
  std::vector<std::vector<Vertex>> simplices;  ///< m + 1 vertices each, by increasing labels

  /// "a", "e1".
  [[nodiscard]] std::string letter_name(std::size_t letter) const;
};

/// Reads such a file in TOML; `source` is its name for messages. Every point is in some simplex, the points of a
/// simplex are different, and different simplices have different sets of points. Throws InputError with file, line,
/// column, name, what was found and what was expected.
[[nodiscard]] ComplexDescription parse_complex(std::string_view text, const std::string& source);

}  // namespace delcert
