#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "kernel/run/run.hpp"
#include "kernel/topology/abelian_group.hpp"
#include "proofs/certificate/run_parameters.hpp"

namespace delcert {

/// What a certificate claims at level 2.
struct ManifoldClaim {
  std::size_t simplices = 0;
  long euler_characteristic = 0;
  bool closed = true;
  std::vector<AbelianGroup> homology;  ///< H₀ … H_m over ℤ; of the stars alone
};

/// The levels of docs/certificate-format.md that a run reaches, with their margins.
struct Claims {
  std::optional<bool> input;                ///< level 0; the value: Hypotheses 2 too
  std::optional<StarMargins> stars;         ///< level 1
  std::optional<ManifoldClaim> manifold;    ///< level 2
  bool stable_stars = false;                ///< level 2s
  std::optional<std::string> no_forbidden;  ///< level 3: what was looked at
  bool delaunay = false;                    ///< level 4
  bool triangulation = false;               ///< level 5
  bool metric = false;                      ///< level 6

  /// The names of the levels claimed, in order.
  [[nodiscard]] std::vector<std::string> names() const;
};

/// Which levels may be claimed at most, by name.
using LevelSelection = std::vector<std::string>;
/// All of them.
[[nodiscard]] const LevelSelection& all_levels();
[[nodiscard]] bool selects(const LevelSelection& selection, std::string_view level);

/// Derives the levels from a certified run, checking the inequalities of the format on the way; reasons for levels
/// that are not reached are appended to `reasons`. Level 3 is searched only if selected. Precondition: the input items
/// of `atlas` hold, and the run is certified.
template <int m>
[[nodiscard]] Claims derive_claims(const FlatAtlas<m>& atlas, const RunParameters& parameters, const RunResult<m>& run,
                                   const LevelSelection& selection, const Progress& progress,
                                   std::vector<std::string>& reasons);

}  // namespace delcert
