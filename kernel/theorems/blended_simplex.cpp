#include "kernel/theorems/blended_simplex.hpp"

#include <algorithm>

#include "kernel/manifold/gluing/interval_matrix.hpp"
#include "kernel/manifold/gluing/second_derivatives.hpp"
#include "kernel/number/scalar.hpp"
#include "kernel/theorems/blend_volume.hpp"

namespace delcert {

namespace {

/// A number about the middle.
Interval central(const Interval& x) {
  return Interval::exactly(std::clamp(x.lower() / 2 + x.upper() / 2, x.lower(), x.upper()));
}

/// The least γ of few digits with (1 − γ)ᵐ ≤ volume. Precondition: 0 < volume ≤ 1.
template <int m>
double contraction_of_volume(double volume) {
  constexpr int parts = 64;
  const auto is_below = [&](int left) {
    double power = 1;  // exact
    for (int k = 0; k < m; ++k) power *= static_cast<double>(left) / parts;
    return power <= volume;
  };
  int left = parts;
  while (!is_below(left)) --left;
  return static_cast<double>(parts - left) / parts;
}

}  // namespace

std::string_view description_of(BlendCause cause) {
  switch (cause) {
    case BlendCause::place:
      return "the home chart of a vertex does not show all others";
    case BlendCause::box:
      return "it is too near to the rim of the home chart of a vertex";
    case BlendCause::transition:
      return "no transition between the home charts of its vertices is certainly defined on all of it";
    case BlendCause::fold:
      return "what transitions do to it may fold it";
  }
  return "";
}

/// Bounds of one blend, from a home chart to the next.
template <int m>
struct BlendedSimplexCheck<m>::Step {
  double kappa;     // of |J M − 1|
  double factor;    // N, of |J|
  double change;    // r, of |J − J̄|
  double back;      // of |M|
  double residual;  // η
  double slope;     // of T
  bool is_smooth;   // the transition has one piece
};

template <int m>
BlendedSimplexCheck<m>::BlendedSimplexCheck(const FormulaAtlas<m>& atlas, const GluedPlaces<m>& places)
    : atlas_(atlas), places_(places) {
  for (const auto& transition : atlas.gluing().transitions()) {
    on_cells_.emplace_back(transition.pieces);
    maps_.emplace_back(transition.pieces);
  }
}

template <int m>
std::vector<std::size_t> BlendedSimplexCheck<m>::homes_of(const LabelSimplex<m>& simplex) const {
  std::vector<std::size_t> homes;
  for (const std::uint32_t v : simplex) homes.push_back(places_.home(v));
  std::sort(homes.begin(), homes.end());
  homes.erase(std::unique(homes.begin(), homes.end()), homes.end());
  return homes;
}

template <int m>
std::uint32_t BlendedSimplexCheck<m>::representative(const LabelSimplex<m>& simplex, std::size_t home) const {
  return *std::find_if(simplex.begin(), simplex.end(), [&](std::uint32_t v) { return places_.home(v) == home; });
}

template <int m>
bool BlendedSimplexCheck<m>::is_open_box(const Cell& cell, std::size_t chart) const {
  const Sides& box = atlas_.gluing().chart(chart).domain;
  for (std::size_t axis = 0; axis < m; ++axis) {
    if (!(cell[axis].lower() > scalar_from<Interval>(box[axis][0]).upper()) ||
        !(cell[axis].upper() < scalar_from<Interval>(box[axis][1]).lower()))
      return false;
  }
  return true;
}

/// The box around the vertices in a home chart, and around what is moved from between them by so much in the chart of
/// the representative.
template <int m>
Cell BlendedSimplexCheck<m>::box_about(const LabelSimplex<m>& simplex, std::size_t chart, double displacement) const {
  const Vector<double, m>& stretch = atlas_.enclosed(Label(representative(simplex, chart))).stretch;
  Cell result;
  for (std::size_t axis = 0; axis < m; ++axis) {
    Interval side = (*places_.place(chart, simplex[0]))[axis];
    for (const std::uint32_t v : simplex) {
      const Interval& x = (*places_.place(chart, v))[axis];
      side = Interval::between(std::min(side.lower(), x.lower()), std::max(side.upper(), x.upper()));
    }
    const double more = (Interval::exactly(displacement) * Interval::exactly(stretch[axis])).upper();
    result[axis] = side + Interval::between(-more, more);
  }
  return result;
}

template <int m>
std::optional<std::size_t> BlendedSimplexCheck<m>::transition_on(const Cell& box, std::size_t from, std::size_t to) {
  const auto& transitions = atlas_.gluing().transitions();
  for (std::size_t t = 0; t < transitions.size(); ++t) {
    if (transitions[t].from != from || transitions[t].to != to) continue;
    const MapOnCell found = on_cells_[t].on(box);
    if (found.is_regular && is_open_box(found.image, to)) return t;
  }
  return std::nullopt;
}

/// The derivatives of a transition on a box, in the charts of two representatives: each is `middle`, one of the convex
/// hull of `changes` (one for each vertex of the simplex, or for each piece of the transition), and a rest.
template <int m>
struct BlendedSimplexCheck<m>::Derivatives {
  using Square = IntervalMatrix<static_cast<std::size_t>(m)>;
  Square middle;
  std::vector<Square> changes;
  Interval rest{0};
  /// D², as a matrix for each direction; none of a transition that may have several pieces on the box.
  std::optional<std::array<Square, static_cast<std::size_t>(m)>> bend;
};

template <int m>
std::optional<typename BlendedSimplexCheck<m>::Derivatives> BlendedSimplexCheck<m>::derivatives(
    const LabelSimplex<m>& simplex, std::size_t from, std::size_t to, std::size_t transition, const Cell& box,
    double displacement) {
  constexpr auto n = static_cast<std::size_t>(m);
  const auto& here = atlas_.enclosed(Label(representative(simplex, from)));
  const auto& there = atlas_.enclosed(Label(representative(simplex, to)));
  PiecewiseValues<Interval>& map = maps_[transition];
  const std::vector<std::size_t> pieces = map.pieces_at(box.data());
  Cell middle;
  for (std::size_t axis = 0; axis < n; ++axis) middle[axis] = central(box[axis]);
  std::array<Interval, n> ignored;
  std::array<Interval, n * n> at_middle;
  const auto in_charts = [&](const auto& entry) {
    IntervalMatrix<n> raw;
    for (std::size_t row = 0; row < n; ++row) {
      for (std::size_t k = 0; k < n; ++k) raw[row][k] = entry(row, k);
    }
    return product(there.matrix, product(raw, here.inverse));
  };
  const auto derivative_of = [&](std::size_t piece) -> std::optional<IntervalMatrix<n>> {
    if (!map.formulas(piece).first(middle.data(), ignored.data(), at_middle.data())) return std::nullopt;
    return in_charts([&](std::size_t row, std::size_t k) { return at_middle[row * n + k]; });
  };
  Derivatives result;
  if (pieces.size() > 1) {
    // Several pieces are affine.
    for (const std::size_t piece : pieces) result.changes.push_back(*derivative_of(piece));
    for (std::size_t row = 0; row < n; ++row) {
      for (std::size_t k = 0; k < n; ++k) {
        Interval sum(0);
        for (const IntervalMatrix<n>& linear : result.changes) sum += linear[row][k];
        result.middle[row][k] = central(sum / Interval(static_cast<int>(pieces.size())));
        for (IntervalMatrix<n>& linear : result.changes) linear[row][k] = linear[row][k] - result.middle[row][k];
      }
    }
    return result;
  }
  // The derivative about the middle, and the second ones everywhere.
  std::array<Interval, n * n * n> second;
  const auto derivative = derivative_of(pieces.front());
  if (!derivative || !second_derivatives<m>(map.formulas(pieces.front()), box, 4, second)) return std::nullopt;
  result.middle = *derivative;
  std::array<IntervalMatrix<n>, n> raw;
  for (std::size_t axis = 0; axis < n; ++axis)
    raw[axis] = in_charts([&](std::size_t row, std::size_t k) { return second[(row * n + k) * n + axis]; });
  std::array<IntervalMatrix<n>, n>& bend = result.bend.emplace();
  std::array<IntervalMatrix<n>, n> mean;
  Interval squared_size(0);
  Interval squared_spread(0);
  for (std::size_t direction = 0; direction < n; ++direction) {
    for (std::size_t row = 0; row < n; ++row) {
      for (std::size_t k = 0; k < n; ++k) {
        Interval& entry = bend[direction][row][k];
        entry = raw[0][row][k] * here.inverse[0][direction];
        for (std::size_t axis = 1; axis < n; ++axis) entry += raw[axis][row][k] * here.inverse[axis][direction];
        mean[direction][row][k] = central(entry);
        squared_size += square(entry);
        squared_spread += square(entry - mean[direction][row][k]);
      }
    }
  }
  const double size = square_root(squared_size).upper();
  const double spread = square_root(squared_spread).upper();
  double reach = 0;
  for (const std::uint32_t v : simplex) {
    const Vector<Interval, m>& x = *places_.place(from, v);
    Vector<Interval, m> offset;
    for (std::size_t axis = 0; axis < n; ++axis) offset[axis] = x[axis] - middle[axis];
    const Vector<Interval, m> from_middle = applied(here.matrix, offset);
    reach = std::max(reach, length_above(from_middle));
    IntervalMatrix<n>& change = result.changes.emplace_back();
    for (std::size_t row = 0; row < n; ++row) {
      for (std::size_t k = 0; k < n; ++k) {
        change[row][k] = mean[0][row][k] * from_middle[0];
        for (std::size_t axis = 1; axis < n; ++axis) change[row][k] += mean[axis][row][k] * from_middle[axis];
      }
    }
  }
  result.rest =
      Interval::exactly(spread) * Interval::exactly(reach) + Interval::exactly(size) * Interval::exactly(displacement);
  return result;
}

template <int m>
std::optional<typename BlendedSimplexCheck<m>::Step> BlendedSimplexCheck<m>::step(const LabelSimplex<m>& simplex,
                                                                                  std::size_t from, std::size_t to,
                                                                                  std::size_t transition,
                                                                                  const Cell& box,
                                                                                  double displacement) {
  constexpr auto n = static_cast<std::size_t>(m);
  const auto found = derivatives(simplex, from, to, transition, box, displacement);
  if (!found) return std::nullopt;
  const auto edge = [&](std::size_t chart, std::size_t v, std::size_t w) {
    return applied(atlas_.enclosed(Label(representative(simplex, chart))).matrix,
                   difference(*places_.place(chart, simplex[v]), *places_.place(chart, simplex[w])));
  };
  IntervalMatrix<n> edges_here;
  IntervalMatrix<n> edges_there;
  for (std::size_t v = 1; v <= n; ++v) {
    const Vector<Interval, m> edge_here = edge(from, v, 0);
    const Vector<Interval, m> edge_there = edge(to, v, 0);
    for (std::size_t row = 0; row < n; ++row) {
      edges_here[row][v - 1] = edge_here[row];
      edges_there[row][v - 1] = edge_there[row];
    }
  }
  const IntervalMatrix<n> weights = inverse_of(edges_there);
  const IntervalMatrix<n> back = product(edges_here, weights);

  Step result{};
  result.back = norm_above(back);
  for (const IntervalMatrix<n>& change : found->changes) {
    IntervalMatrix<n> whole;
    for (std::size_t row = 0; row < n; ++row) {
      for (std::size_t k = 0; k < n; ++k) whole[row][k] = found->middle[row][k] + change[row][k];
    }
    result.change = std::max(result.change, norm_above(change));
    result.factor = std::max(result.factor, norm_above(whole));
    IntervalMatrix<n> beyond = product(whole, back);
    for (std::size_t row = 0; row < n; ++row) beyond[row][row] = beyond[row][row] - Interval(1);
    result.kappa = std::max(result.kappa, norm_above(beyond));
  }
  double longest = 0;
  double turn = 0;
  for (std::size_t v = 0; v <= n; ++v) {
    for (std::size_t w = 0; w < v; ++w) {
      const Vector<Interval, m> side = edge(from, v, w);
      longest = std::max(longest, length_above(side));
      if (!found->bend) continue;
      Vector<Interval, m> turned{};
      for (std::size_t axis = 0; axis < n; ++axis)
        turned = sum(turned, scaled(side[axis], applied((*found->bend)[axis], side)));
      turn = std::max(turn, length_above(turned));
    }
  }
  result.kappa = (Interval::exactly(result.kappa) + Interval::exactly(result.back) * found->rest).upper();
  result.factor = (Interval::exactly(result.factor) + found->rest).upper();
  result.change = (Interval::exactly(result.change) + found->rest).upper();
  const Interval share = Interval(m) / Interval(m + 1);
  result.residual =
      (Interval::exactly(result.change) * square_root(share / Interval(2)) * Interval::exactly(longest)).upper();
  if (found->bend) result.residual = std::min(result.residual, (share / Interval(4) * Interval::exactly(turn)).upper());
  // The weights of what comes up to here sum to T, the others to 1 − T.
  const bool with_first = places_.home(simplex[0]) <= from;
  Vector<Interval, m> gradient{};
  for (std::size_t v = 1; v <= n; ++v) {
    if ((places_.home(simplex[v]) <= from) != with_first) gradient = sum(gradient, weights[v - 1]);
  }
  result.slope = length_above(gradient);
  result.is_smooth = found->bend.has_value();
  const double largest = std::max({result.kappa, result.factor, result.residual, result.slope, result.back});
  if (!(largest < 0x1p100)) return std::nullopt;
  return result;
}

/// γ of a lower bound for the determinant of the derivative, of a blend of two homes; 1 if there is none.
template <int m>
double BlendedSimplexCheck<m>::contraction_by_volume(const LabelSimplex<m>& simplex, std::size_t from, std::size_t to,
                                                     std::size_t transition, const Cell& box) {
  constexpr double enough = 0.25;
  TwoHomes<m> blend;
  for (std::size_t v = 0; v <= m; ++v) {
    blend.here[v] = *places_.place(from, simplex[v]);
    blend.there[v] = *places_.place(to, simplex[v]);
    blend.is_first[v] = places_.home(simplex[v]) == from;
  }
  PiecewiseValues<Interval>& map = maps_[transition];
  const double volume = blend_volume_below<m>(blend, map.formulas(map.pieces_at(box.data()).front()), enough);
  return volume < enough ? 1 : contraction_of_volume<m>(std::min(volume, 1.0));
}

template <int m>
BlendedSimplex BlendedSimplexCheck<m>::measure(const LabelSimplex<m>& simplex) {
  const std::vector<std::size_t> homes = homes_of(simplex);
  BlendedSimplex result;
  if (homes.size() == 1) return result;
  result.is_seam = true;
  for (const std::size_t chart : homes) {
    for (const std::uint32_t v : simplex) {
      if (!places_.place(chart, v)) {
        result.cause = BlendCause::place;
        return result;
      }
    }
  }
  const auto fail = [&](BlendCause cause) {
    result.cause = cause;
    return result;
  };
  for (std::size_t l = 1; l < homes.size(); ++l) {
    const Cell box = box_about(simplex, homes[l - 1], result.displacement);
    if (!is_open_box(box, homes[l - 1])) return fail(BlendCause::box);
    const auto transition = transition_on(box, homes[l - 1], homes[l]);
    if (!transition) return fail(BlendCause::transition);
    const auto found = step(simplex, homes[l - 1], homes[l], *transition, box, result.displacement);
    if (!found) return fail(BlendCause::fold);
    const Interval before = Interval::exactly(result.displacement);
    const Interval residual = Interval::exactly(found->residual);
    const Interval factor = Interval::exactly(found->factor);
    result.displacement = (residual + factor * before).upper();
    result.contraction =
        (Interval::exactly(found->kappa) +
         factor * Interval::exactly(found->back) * Interval::exactly(result.contraction) +
         Interval::exactly(found->slope) * (residual + Interval(2) * Interval::exactly(found->change) * before))
            .upper();
    const bool is_injective = found->kappa < 1 && result.contraction < 1;
    if (homes.size() == 2 && found->is_smooth && !(is_injective && result.contraction <= most_contraction)) {
      const double by_volume = contraction_by_volume(simplex, homes[0], homes[1], *transition, box);
      if (by_volume < 1) result.contraction = by_volume;
      if (!(by_volume < 1) && !is_injective) return fail(BlendCause::fold);
    } else if (!is_injective) {
      return fail(BlendCause::fold);
    }
  }
  const Cell box = box_about(simplex, homes.back(), result.displacement);
  if (!is_open_box(box, homes.back())) return fail(BlendCause::box);
  for (std::size_t l = 0; l + 1 < homes.size(); ++l) {
    if (!transition_on(box, homes.back(), homes[l])) return fail(BlendCause::transition);
  }
  return result;
}

template class BlendedSimplexCheck<2>;
template class BlendedSimplexCheck<3>;

}  // namespace delcert
