#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "kernel/topology/abelian_group.hpp"
#include "kernel/topology/pure_complex.hpp"
#include "proofs/certificate/delaunay_margin.hpp"
#include "proofs/constants/ledger.hpp"

namespace delcert {

/// Level 0. A flat torus or a ball states the first part, a space form the second.
struct InputClaim {
  struct Density {
    Rational density;            ///< no point of M is farther than this from the net
    Rational distortion;         ///< ξ₀ of the transitions between patches
    Rational metric_distortion;  ///< η of the charts against M
  };
  std::optional<bool> hypotheses_2;  ///< Hypotheses 1 hold; the value: Hypotheses 2 too
  std::optional<Density> density;
  /// Which Hypotheses 2, if they are claimed.
  ParameterConstraints constraints = ParameterConstraints::printed;
};

/// Level 2.
struct ManifoldClaim {
  std::size_t simplices = 0;
  long euler_characteristic = 0;
  bool closed = true;
  std::vector<AbelianGroup> homology;  ///< H₀ … H_m over ℤ; of the stars alone
};

/// Level 2s.
struct StableStarsClaim {
  std::optional<Rational> reach;  ///< how far charts have to show; flat tori and balls state none
};

/// Level 4. Flat tori and balls state no margin.
struct DelaunayClaim {
  struct Balls {
    Rational protection;  ///< every other lift is farther than this from each circumball; 0 if only emptiness is known
    Rational circumradius;  ///< no circumball in M is larger
  };
  struct Stability {
    Rational edge;    ///< a lower bound of the longest edge of every simplex
    Rational margin;  ///< of stability, in squares of lengths
  };
  struct Restricted {
    bool extrinsic = false;  ///< for the distance in the space around
    bool intrinsic = false;  ///< for the length of curves in M
    Rational density;        ///< no point of M is farther from the vertices
  };
  std::optional<Balls> balls = {};            ///< of space forms
  std::optional<Stability> stability = {};    ///< of metric fields
  std::optional<Restricted> restricted = {};  ///< of submanifolds
};

/// Level 5.
struct TriangulationClaim {
  struct RiemannianSimplices {
    Rational thickness;  ///< of the simplices in the charts at perturbed points
    Rational radius;     ///< all vertices of a star are nearer than this to its label
  };
  struct Graph {
    Rational contraction;   ///< γ: in charts the map to M differs from the identity by a map with this Lipschitz
                            ///< constant at most; on an atlas, or the map keeps (1 − γ)ᵐ of all volumes
    Rational displacement;  ///< no point is moved farther
  };
  std::string route;
  std::optional<RiemannianSimplices> riemannian = {};  ///< by this second route as well
  std::optional<Graph> graph = {};                     ///< of submanifolds and atlases
};

/// Level 5i: the complex is embedded, and isotopic to M. It states one of these.
struct IsotopyClaim {
  std::optional<Rational> margin;       ///< by so much stars are wider than what points are moved sideways
  std::optional<Rational> cosine = {};  ///< of the angle between normals of simplices and gradients along them
};

/// Level 1f: stars are embedded and full, whether or not they are Delaunay.
struct FullStarsClaim {};

/// Level 6: flat simplices of the same edges, against M.
struct MetricClaim {
  bool self_delaunay = false;
  std::optional<Rational> weight;  ///< of surfaces: cotangents opposite to an edge sum to more than this ≥ 0
  Rational least_stretch{1}, greatest_stretch{1};
  std::optional<Rational> normal = {};  ///< of submanifolds: the sine of the angle between simplices and tangent spaces
};

/// The levels of docs/certificate-format.md that a run reaches, with their margins: lengths, not in units of ε.
struct Claims {
  std::optional<InputClaim> input;                  ///< level 0
  std::optional<StarMargins> stars;                 ///< level 1
  std::optional<FullStarsClaim> full_stars;         ///< level 1f
  std::optional<ManifoldClaim> manifold;            ///< level 2
  std::optional<StableStarsClaim> stable_stars;     ///< level 2s
  std::optional<std::string> no_forbidden;          ///< level 3: what was looked at
  std::optional<DelaunayClaim> delaunay;            ///< level 4
  std::optional<TriangulationClaim> triangulation;  ///< level 5
  std::optional<IsotopyClaim> isotopy;              ///< level 5i
  std::optional<MetricClaim> metric;                ///< level 6
  /// What decided level 4 of a metric field, wherever it was asked for and straight simplices triangulate the torus.
  std::optional<DelaunayMargin> delaunay_margin;

  /// The names of the levels claimed, in order.
  [[nodiscard]] std::vector<std::string> names() const;
};

/// A bound that a level states.
struct Margin {
  enum class Side { lower, upper };
  enum class Unit { one, length, squared_length };
  Rational value;
  Side side;
  Unit unit;
};

/// What a certificate states under a key of a level: a bound, or two of them, or something else, as JSON.
struct LevelEntry {
  std::string key;
  std::vector<Margin> margins;
  std::string json;
};

/// A level that is claimed, with its entries in the order of the format.
struct ClaimedLevel {
  std::string name;
  std::vector<LevelEntry> entries;
};
[[nodiscard]] std::vector<ClaimedLevel> claimed_levels(const Claims& claims);

/// Level 2 of a complex, from its labels. `simplices`: how many m-simplices there are.
[[nodiscard]] ManifoldClaim manifold_claim(const PureComplex& complex, std::size_t simplices, bool closed);

/// Which levels may be claimed at most, by name.
using LevelSelection = std::vector<std::string>;
/// All of them.
[[nodiscard]] const LevelSelection& all_levels();
[[nodiscard]] bool selects(const LevelSelection& selection, std::string_view level);

}  // namespace delcert
