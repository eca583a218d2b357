#pragma once

#include <optional>
#include <vector>

#include "kernel/stars/star_complex.hpp"
#include "support/progress.hpp"

namespace delcert {

/// What the simplices of a star complex are certified to have, or why not.
struct ProtectionReport {
  /// None if there are failures.
  std::optional<StarMargins> margins;
  std::vector<StarFailure> failures;
};

/// Certifies the simplices of all stars against all lifts of the points: non-degenerate, and every other lift farther
/// from the circumcentre than the circumradius plus a margin. Margins have 12 significant binary digits. The protection
/// is the best such number, but is not looked for beyond half a sampling radius; thickness and circumradius are what
/// the filter's bounds give. Where radii vary, lengths are multiples of the greatest: for a simplex they count as many
/// times as the least radius of its vertices is of that (`LengthUnits`). A tie is decided (as a failure), and a
/// protection that the filter cannot tell from 0 is a failure too. With `required_protection`, simplices whose
/// protection is not above it are failures as well; throws InputError if that is more than half a sampling radius.
template <int m>
[[nodiscard]] ProtectionReport certify_protection(const FlatAtlas<m>& atlas, const PointSet<m>& points,
                                                  const StarComplex<m>& complex,
                                                  const std::optional<Rational>& required_protection,
                                                  const Progress& progress);

}  // namespace delcert
