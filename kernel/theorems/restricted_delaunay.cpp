#include "kernel/theorems/restricted_delaunay.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <optional>

#include "kernel/chart/ambient_grid.hpp"
#include "kernel/manifold/submanifold/chord_bend.hpp"
#include "kernel/number/rounding_guard.hpp"
#include "kernel/parallel/parts.hpp"

namespace delcert {

namespace {

constexpr std::size_t labels_at_a_time = 64;
constexpr long digits_of_density = 12;
/// Readers bound changes of slopes otherwise, and less well.
const Interval room_for_readers = Interval::exactly(1.25);
/// Bounds by Lemma 3 of what curves are longer than their chords by: readers have others, a little wider.
constexpr double room_of_bends = 1.0625;
/// Boxes are halved so often, and so often before it is looked at how M bends about the chords from a box.
constexpr int most_halvings = 12;
constexpr int halvings_of_bends = 5;
/// The same where it is not known how slopes change.
constexpr int halvings_of_first_bends = 3;

/// √(1 + L²): how much longer than in a chart a curve in M is.
Interval stretch_of(const Rational& slope) { return square_root(Interval(1) + square(scalar_from<Interval>(slope))); }

/// L at most, of M over places of a chart as far from 0 as this: on zero sets patches are the less steep the nearer to
/// their centres (sub.graph).
Interval slope_within(const GraphVertices& vertices, std::uint32_t j, const Interval& distance, const Interval& slope) {
  if (!vertices.manifold.is_smooth()) return slope;
  const Interval share = distance / scalar_from<Interval>(vertices.charts[j].data().radius);
  return Interval::exactly(
      std::min(slope.upper(), (slope * (Interval(1) + Interval(7) * share) / Interval(8)).upper()));
}

/// How far, along M, a point over the simplex is from a vertex, at most: by the simplex's circumradius in the chart of
/// its vertex number `at`, and what is moved sideways.
template <int m>
Interval reach_of_simplex(const GraphVertices& vertices, const GraphSimplexCheck<m>& check,
                          const LabelSimplex<m>& simplex, std::size_t at, double shift, const Interval& slope) {
  const std::uint32_t j = simplex[at];
  const auto gradients = check.gradients(j, simplex);
  if (!gradients) return Interval::exactly(std::numeric_limits<double>::infinity());
  Vector<Interval, m> centre{};
  Interval farthest_squared(0);
  for (std::size_t k = 0; k <= m; ++k) {
    Interval squared(0);
    Interval from_zero(0);
    for (std::size_t row = 0; row < m; ++row) {
      squared += square(check.coordinate(j, simplex[k], row) - check.coordinate(j, simplex[0], row));
      from_zero += square(check.coordinate(j, simplex[k], row));
    }
    farthest_squared = maximum(farthest_squared, from_zero);
    for (std::size_t row = 0; k > 0 && row < m; ++row) centre[row] += squared / Interval(2) * (*gradients)[k][row];
  }
  double side = 0;
  for (const std::uint32_t v : simplex) side = std::max(side, check.lateral(j, v));
  const Interval moved = Interval::exactly(side) * Interval::exactly(shift);
  const Interval steepest = slope_within(vertices, j, square_root(farthest_squared) + moved, slope);
  return square_root(Interval(1) + square(steepest)) * (square_root(pairing(centre, centre)) + moved);
}

/// What there is around a label.
struct Around {
  std::uint32_t label;
  bool is_shown;                 ///< certainly, by the chart
  std::vector<Interval> offset;  ///< u_k − u_i in the frame of the chart, N coordinates
  Interval power;                ///< |u_k|² − |u_i|²
};

/// Of the vertices, for lengths that are this for the unit 1.
AmbientGrid grid_of(const GraphVertices& vertices, double length) {
  AmbientGrid grid(vertices.manifold.ambient(), length * middle_unit(vertices.units));
  for (std::uint32_t label = 0; label < vertices.charts.size(); ++label) {
    std::array<double, most_ambient_dimensions> place{};
    for (std::size_t axis = 0; axis < vertices.manifold.ambient(); ++axis)
      place[axis] = vertices.position(label)[axis].lower();
    grid.insert(place.data());
  }
  return grid;
}

/// The discs of labels, one after the other.
template <int m>
class DiscCover {
 public:
  DiscCover(const GraphVertices& vertices, const std::vector<std::vector<LabelSimplex<m>>>& stars,
            const AmbientGrid& grid, const Rational& slope, const std::vector<double>& reaches, GraphMetric metric)
      : vertices_(vertices),
        stars_(stars),
        grid_(grid),
        n_(vertices.manifold.ambient()),
        q_(vertices.manifold.codimension()),
        slope_(scalar_from<Interval>(slope)),
        reaches_(reaches),
        stretch_(stretch_of(slope)),
        metric_(metric),
        evaluation_(vertices.manifold.evaluation()),
        check_(vertices) {}

  /// Whether the disc is certainly covered.
  bool covers(std::uint32_t i) {
    label_ = i;
    radius_ = Interval::exactly(reaches_[i]);
    chart_ = &vertices_.charts[i].enclosed();
    patch_ = scalar_from<Interval>(vertices_.charts[i].data().radius);
    for (std::size_t column = 0; column < n_; ++column) own_[column] = check_.coordinate(i, i, column);
    if (!is_in_patch()) return false;
    // All of the disc, however little the chart shows beyond it.
    wide_ =
        maximum(radius_, minimum(Interval(2) * radius_, (patch_ - own_distance()) * Interval::exactly(1 - 0x1p-10)));
    change_ = {};
    is_change_known_ = metric_ == GraphMetric::extrinsic || find_change();
    // Where curves may be longer than their chords by more than this nothing is certain, but for what bends say.
    if (!is_change_known_ || !is_proved(less(excess(radius_), radius_))) {
      is_change_known_ = false;
      if (!vertices_.manifold.is_smooth() || q_ != 1) return false;
    }
    gather();
    std::vector<std::size_t> all(around_.size());
    for (std::size_t k = 0; k < all.size(); ++k) all[k] = k;
    Vector<double, m> centre{};
    for (std::size_t row = 0; row < m; ++row) centre[row] = own_[row].lower();
    return covers_box(centre, (radius_ * Interval::exactly(1 + 0x1p-40)).upper(), all, {}, 0);
  }
  [[nodiscard]] std::size_t boxes() const { return boxes_; }

 private:
  /// How M bends about the chords from a box to labels.
  using Bends = std::map<std::uint32_t, ChordBend>;

  /// |φ_i(p′_i)|.
  [[nodiscard]] Interval own_distance() const {
    Interval squared(0);
    for (std::size_t row = 0; row < m; ++row) squared += square(own_[row]);
    return square_root(squared);
  }
  /// 4.patch.
  [[nodiscard]] bool is_in_patch() const {
    if (!is_proved(less(own_distance() + radius_, patch_))) return false;
    const Interval height = scalar_from<Interval>(vertices_.charts[label_].data().height);
    for (std::size_t column = m; metric_ == GraphMetric::extrinsic && column < n_; ++column) {
      if (!is_proved(less(absolute(own_[column]) + radius_, height))) return false;
    }
    return true;
  }

  /// How slopes change where segments run that `excess` is asked of: in the disc of radius `wide_` about the own place.
  /// On smooth manifolds the square around it is divided into cells.
  bool find_change() {
    const unsigned parts = vertices_.manifold.is_smooth() ? 4 : 1;
    const double side = (Interval(2) * wide_ / Interval(static_cast<int>(parts))).upper();
    const Interval corner = square_root(Interval(m)) * Interval::exactly(side) / Interval(2);
    Vector<unsigned, m> at{};
    while (true) {
      Vector<double, m> centre{};
      Interval squared(0);
      for (std::size_t row = 0; row < m; ++row) {
        centre[row] = own_[row].lower() + side * (at[row] - 0.5 * (parts - 1));
        squared += square(Interval::exactly(centre[row]) - own_[row]);
      }
      // Cells beyond the disc do not count.
      const Interval away = square_root(squared);
      if (!is_proved(less(wide_ + corner, away))) {
        const auto change = change_in(centre, away, side / 2 * (1 + 0x1p-30));
        if (!change) return false;
        change_.rate = maximum(change_.rate, change->rate * room_for_readers);
        change_.size = maximum(change_.size, change->size * room_for_readers);
      }
      std::size_t row = 0;
      while (row < m && ++at[row] == parts) at[row++] = 0;
      if (row == m) return true;
    }
  }

  /// In a cell, whose centre is so far from the own place.
  std::optional<SlopeChange> change_in(const Vector<double, m>& centre, const Interval& away, double half) {
    std::array<Interval, most_ambient_dimensions> place;
    for (std::size_t row = 0; row < m; ++row)
      place[row] = Interval::exactly(centre[row]) + Interval::between(-half, half);
    if (!vertices_.manifold.is_smooth())
      return evaluation_->slope_change(vertices_.charts[label_], place.data(), slope_);
    // M is looked for over the centre, or over a place that is nearer to the own one, inside of the disc.
    Vector<double, m> foot = centre;
    Interval reach = square_root(Interval(m)) * Interval::exactly(half);
    if (const double inwards = (wide_ * Interval::exactly(0.875) / away).lower(); inwards < 1) {
      Interval squared(0);
      for (std::size_t row = 0; row < m; ++row) {
        foot[row] = own_[row].lower() + inwards * (centre[row] - own_[row].lower());
        squared += square(Interval::exactly(centre[row]) - Interval::exactly(foot[row]));
      }
      reach += square_root(squared);
    }
    if (!heights(foot, reach, place)) return std::nullopt;
    return evaluation_->slope_change(vertices_.charts[label_], place.data(), slope_);
  }

  /// The labels that may be as near to a point over the disc as its own.
  void gather() {
    around_.clear();
    const Interval far = stretch_ * radius_;
    const double reach = (Interval(2) * far).upper() * (1 + 0x1p-20);
    std::array<double, most_ambient_dimensions> place{};
    for (std::size_t axis = 0; axis < n_; ++axis) place[axis] = vertices_.position(label_)[axis].lower();
    std::vector<std::uint32_t> labels;
    grid_.visit(place.data(), reach, [&](std::uint32_t k, double) {
      if (k != label_) labels.push_back(k);
      return false;
    });
    std::sort(labels.begin(), labels.end());
    const Interval height = scalar_from<Interval>(vertices_.charts[label_].data().height);
    for (const std::uint32_t k : labels) {
      Around one{k, true, {}, Interval(0)};
      Interval squared(0);
      for (std::size_t column = 0; column < n_; ++column) {
        const Interval u = check_.coordinate(label_, k, column);
        one.offset.push_back(u - own_[column]);
        one.power += (u - own_[column]) * (u + own_[column]);
        if (column < m) {
          squared += square(u);
        } else if (!is_proved(less(absolute(u), height))) {
          one.is_shown = false;
        }
      }
      if (!is_proved(less(squared, square(patch_)))) one.is_shown = false;
      Interval away(0);
      for (std::size_t row = 0; row < m; ++row) away += square(one.offset[row]);
      if (!is_proved(less(away, square(wide_)))) one.is_shown = false;
      around_.push_back(std::move(one));
    }
  }

  /// d(ad/√12 + b)²/2: by how much a curve in M over a segment of length d may be longer than its chord, where slopes
  /// change by a rate a and a size b.
  [[nodiscard]] Interval excess(const Interval& d) const {
    return d * square(change_.rate * d / square_root(Interval(12)) + change_.size) / Interval(2);
  }

  /// `outer`: of a box around it.
  bool covers_box(const Vector<double, m>& centre, double half, const std::vector<std::size_t>& labels,
                  const Bends& outer, int halvings) {
    ++boxes_;
    std::array<Interval, most_ambient_dimensions> x;
    Interval from_own(0);
    Interval from_zero(0);
    for (std::size_t row = 0; row < m; ++row) {
      x[row] = Interval::exactly(centre[row]) + Interval::between(-half, half);
      from_own += square(x[row] - own_[row]);
      from_zero += square(Interval::exactly(centre[row]));
    }
    if (is_proved(less(square(radius_), from_own))) return true;
    std::vector<std::size_t> near;
    const Interval reach = square_root(Interval(m)) * Interval::exactly(half);
    Bends found;
    const Bends* bends = &outer;
    if (is_proved(less(from_zero, square(patch_))) && heights(centre, reach, x)) {
      if (settles(x, labels, outer, near)) return true;
      const bool is_due = halvings == halvings_of_bends || (!is_change_known_ && halvings == halvings_of_first_bends);
      if (is_due && metric_ == GraphMetric::intrinsic) {
        if (settles_by_bends(x, near, found)) return true;
        if (!found.empty()) bends = &found;
      }
    }
    if (halvings == most_halvings) return false;
    const std::vector<std::size_t>& left = near.empty() ? labels : near;
    for (unsigned corner = 0; corner < 1U << m; ++corner) {
      Vector<double, m> part = centre;
      for (std::size_t row = 0; row < m; ++row) part[row] += (corner >> row & 1U) != 0 ? half / 2 : -half / 2;
      // What rounding may leave between two parts.
      if (!covers_box(part, half / 2 * (1 + 0x1p-30), left, *bends, halvings + 1)) return false;
    }
    return true;
  }

  /// z within a distance of a place of the chart: that over the place, and as much as the slope allows.
  bool heights(const Vector<double, m>& centre, const Interval& reach,
               std::array<Interval, most_ambient_dimensions>& x) {
    std::array<Interval, most_ambient_dimensions> y;
    for (std::size_t row = 0; row < m; ++row) y[row] = Interval::exactly(centre[row]);
    const auto z = evaluation_->heights(vertices_.charts[label_], y.data());
    if (!z) return false;
    const double away = (slope_ * reach).upper();
    const Interval height = scalar_from<Interval>(vertices_.charts[label_].data().height);
    for (std::size_t k = 0; k < q_; ++k) {
      if (!is_proved(less(absolute((*z)[k]), height))) return false;
      x[m + k] = (*z)[k] + Interval::between(-away, away);
    }
    return true;
  }

  /// Whether a box is settled once it is known how M bends about the chords from it: to its own label, then to others
  /// that may still be as near.
  bool settles_by_bends(const std::array<Interval, most_ambient_dimensions>& x, std::vector<std::size_t>& near,
                        Bends& bends) {
    std::array<Interval, most_ambient_dimensions> from;
    vertices_.charts[label_].enclosed().position(x.data(), from.data());
    const auto find = [&](std::uint32_t label) {
      if (auto bend = evaluation_->chord_bend(from.data(), vertices_.position(label)))
        bends.emplace(label, std::move(*bend));
    };
    find(label_);
    if (bends.empty()) return false;
    if (settles(x, std::vector(near), bends, near)) return true;
    for (const std::size_t k : near) find(around_[k].label);
    return settles(x, std::vector(near), bends, near);
  }

  /// How far a label is from a point: in ℝᴺ, and by how much more along M.
  struct Distance {
    Interval chord;
    ChordExcess more;
  };
  /// `chord`: N coordinates, in the frame of the chart.
  [[nodiscard]] Distance distance(std::uint32_t label, bool is_shown, const Interval* chord, const Bends& bends) const {
    Interval in_chart(0);
    Interval squared(0);
    for (std::size_t column = 0; column < n_; ++column) {
      squared += square(chord[column]);
      if (column + 1 == m) in_chart = squared;
    }
    Distance result{square_root(squared), {}};
    if (is_shown) {
      const Interval d = square_root(in_chart);
      result.more.most = metric_ == GraphMetric::extrinsic ? 0 : (stretch_ * d - result.chord).upper();
      if (is_change_known_) result.more.most = std::min(result.more.most, excess(d).upper());
    }
    if (const auto bend = bends.find(label); bend != bends.end()) {
      std::array<Interval, most_ambient_dimensions> turned;
      for (std::size_t axis = 0; axis < n_; ++axis) {
        turned[axis] = Interval(0);
        for (std::size_t column = 0; column < n_; ++column) turned[axis] += chart_->at(axis, column) * chord[column];
      }
      const ChordExcess more = bend->second.excess(turned.data());
      result.more.least = more.least / room_of_bends;
      result.more.most = std::min(result.more.most, more.most * room_of_bends);
    }
    return result;
  }
  /// Whether p is nearer to x than q along M, and in ℝᴺ: if |x − q|² − |x − p|² > e(2|x − p| + e), e how much more than
  /// chords the distance of p is, less that of q.
  [[nodiscard]] static bool is_nearer(const Distance& p, const ChordExcess& q, const Interval& lead) {
    if (!(p.more.most < std::numeric_limits<double>::infinity())) return false;
    const Interval e = maximum(Interval(0), Interval::exactly(p.more.most) - Interval::exactly(q.least));
    return is_proved(less(e * (Interval(2) * p.chord + e), lead));
  }

  /// Whether a label is certainly nearer than the own one to all points over the box, or only vertices of one simplex
  /// of the star may be as near. `near`: the labels that are not certainly farther.
  bool settles(const std::array<Interval, most_ambient_dimensions>& x, const std::vector<std::size_t>& labels,
               const Bends& bends, std::vector<std::size_t>& near) {
    near.clear();
    std::array<Interval, most_ambient_dimensions> to_own;
    for (std::size_t column = 0; column < n_; ++column) to_own[column] = x[column] - own_[column];
    const Distance own = distance(label_, true, to_own.data(), bends);
    for (const std::size_t k : labels) {
      const Around& other = around_[k];
      // |x − p_k|² − |x − p_i|².
      Interval power = other.power;
      for (std::size_t column = 0; column < n_; ++column) power -= Interval(2) * x[column] * other.offset[column];
      if (is_nearer(own, {}, power)) continue;
      const bool is_nearer_in_space = is_proved(less(power, Interval(0)));
      if (is_nearer_in_space && metric_ == GraphMetric::extrinsic) {
        near.push_back(k);
        return true;
      }
      if (!bends.empty() || (is_nearer_in_space && other.is_shown)) {
        std::array<Interval, most_ambient_dimensions> chord;
        for (std::size_t column = 0; column < n_; ++column) chord[column] = to_own[column] - other.offset[column];
        const Distance there = distance(other.label, other.is_shown, chord.data(), bends);
        if (is_nearer(own, there.more, power)) continue;
        near.push_back(k);
        if (is_nearer(there, own.more, -power)) return true;
      } else {
        near.push_back(k);
      }
    }
    if (near.size() > m) return false;
    return std::any_of(stars_[label_].begin(), stars_[label_].end(), [&](const LabelSimplex<m>& simplex) {
      return std::all_of(near.begin(), near.end(), [&](std::size_t k) {
        return std::find(simplex.begin(), simplex.end(), around_[k].label) != simplex.end();
      });
    });
  }

  const GraphVertices& vertices_;
  const std::vector<std::vector<LabelSimplex<m>>>& stars_;
  const AmbientGrid& grid_;
  std::size_t n_;
  std::size_t q_;
  Interval slope_;
  const std::vector<double>& reaches_;
  Interval stretch_;
  GraphMetric metric_;
  std::unique_ptr<GraphEvaluation> evaluation_;
  GraphSimplexCheck<m> check_;
  // Of the label at hand.
  std::uint32_t label_ = 0;
  const EnclosedChart<Interval>* chart_ = nullptr;
  Interval patch_, radius_;
  Interval wide_;  // labels that are farther in the chart are not said to be near by lengths of curves
  bool is_change_known_ = true;
  SlopeChange change_;
  std::array<Interval, most_ambient_dimensions> own_;
  std::vector<Around> around_;
  std::size_t boxes_ = 0;
};

/// 4.clear: whether the point of k is certainly outside of all simplices of its component near by that do not have it,
/// in its chart.
template <int m>
bool is_alone(const GraphVertices& vertices, const GraphSimplexCheck<m>& check,
              const std::vector<LabelSimplex<m>>& simplices, const std::vector<std::uint32_t>& component,
              std::uint32_t k, const Interval& reach) {
  const auto is_near = [&](std::uint32_t v) {
    Interval squared(0);
    for (std::size_t axis = 0; axis < vertices.manifold.ambient(); ++axis)
      squared += square(vertices.position(v)[axis] - vertices.position(k)[axis]);
    return !is_proved(less(square(reach), squared));
  };
  for (const LabelSimplex<m>& simplex : simplices) {
    if (component[simplex[0]] != component[k]) continue;
    if (std::find(simplex.begin(), simplex.end(), k) != simplex.end()) continue;
    if (std::none_of(simplex.begin(), simplex.end(), is_near)) continue;
    const auto gradients = check.gradients(k, simplex);
    if (!gradients) return false;
    bool is_outside = false;
    for (std::size_t v = 0; v <= m && !is_outside; ++v) {
      Interval weight(v == 0 ? 1 : 0);
      for (std::size_t row = 0; row < m; ++row)
        weight += (*gradients)[v][row] * (check.coordinate(k, k, row) - check.coordinate(k, simplex[0], row));
      is_outside = is_proved(less(weight, Interval(0)));
    }
    if (!is_outside) return false;
  }
  return true;
}

}  // namespace

template <int m>
GraphDensity graph_density(const GraphVertices& vertices, const std::vector<LabelSimplex<m>>& simplices,
                           const GraphTriangulation<m>& triangulation, const Rational& slope) {
  // For readers, who enclose it otherwise.
  const Rational room(Integer(65), Integer(64));
  double edge = 0;
  for (std::size_t s = 0; s < simplices.size(); ++s)
    edge = std::max(edge, triangulation.simplices[s].edge / vertices.unit(simplices[s]));
  const AmbientGrid grid = grid_of(vertices, 2 * edge);
  GraphDensity result{std::vector<double>(vertices.charts.size(), 0), Rational(0)};
  double farthest = 0;
  {
    const RoundingGuard guard;
    const GraphSimplexCheck<m> check(vertices);
    const Interval stretch = stretch_of(slope);
    for (std::size_t s = 0; s < simplices.size(); ++s) {
      double least = std::numeric_limits<double>::infinity();
      for (std::size_t at = 0; at <= m; ++at) {
        const double shift = triangulation.simplices[s].shift;
        const Interval reach =
            reach_of_simplex<m>(vertices, check, simplices[s], at, shift, scalar_from<Interval>(slope));
        least = std::min(least, reach.upper());
      }
      // What is over the simplex may be nearest to labels that are not much farther from one of its vertices.
      const double around = ((Interval(1) + stretch) * Interval::exactly(least)).upper() * (1 + 0x1p-20);
      for (const std::uint32_t v : simplices[s]) {
        result.reaches[v] = std::max(result.reaches[v], least);
        if (!(least < 0x1p100)) continue;
        grid.visit(grid[v], around, [&](std::uint32_t k, double) {
          result.reaches[k] = std::max(result.reaches[k], least);
          return false;
        });
      }
    }
    for (std::uint32_t k = 0; k < result.reaches.size(); ++k) {
      const Interval reach = Interval::exactly(result.reaches[k]);
      farthest = std::max(farthest, (reach / Interval::exactly(vertices.unit(k))).upper());
      result.reaches[k] = (reach * scalar_from<Interval>(room)).upper();
    }
  }
  const Rational wider = Rational::exactly(farthest) * room;
  result.density = rounded_up(wider, binary_exponent(wider) - digits_of_density + 1);
  return result;
}

template <int m>
RestrictedDelaunay check_restricted_delaunay(const GraphVertices& vertices,
                                             const std::vector<LabelSimplex<m>>& simplices,
                                             const GraphTriangulation<m>& triangulation, const Rational& slope,
                                             const GraphDensity& density, GraphMetric metric,
                                             const Progress& progress) {
  const std::size_t n = vertices.charts.size();
  std::vector<std::vector<LabelSimplex<m>>> stars(n);
  for (const LabelSimplex<m>& simplex : simplices) {
    for (const std::uint32_t v : simplex) stars[v].push_back(simplex);
  }
  const AmbientGrid grid = grid_of(vertices, 2 * approximate_double(density.density));
  struct Part {
    std::vector<Label> failures;
    std::size_t boxes;
  };
  RestrictedDelaunay result;
  in_parts<labels_at_a_time>(
      metric == GraphMetric::extrinsic ? "cover discs" : "cover discs by curves", n, progress,
      [&](std::size_t first, std::size_t last) {
        const RoundingGuard guard;
        DiscCover<m> cover(vertices, stars, grid, slope, density.reaches, metric);
        Part part{{}, 0};
        for (std::size_t i = first; i < last; ++i) {
          const Label label(static_cast<std::uint32_t>(i));
          if (!cover.covers(label.value)) part.failures.push_back(label);
        }
        part.boxes = cover.boxes();
        return part;
      },
      [&](const Part& part) {
        result.failures.insert(result.failures.end(), part.failures.begin(), part.failures.end());
        result.boxes += part.boxes;
      });
  const RoundingGuard guard;
  const GraphSimplexCheck<m> check(vertices);
  const Interval reach = (Interval(1) + stretch_of(slope)) * scalar_from<Interval>(density.density);
  std::vector<bool> is_settled(n);
  for (std::uint32_t k = 0; k < n; ++k) {
    const std::uint32_t component = triangulation.component[k];
    if (!is_settled[component] && is_alone<m>(vertices, check, simplices, triangulation.component, k,
                                              reach * Interval::exactly(vertices.unit(k))))
      is_settled[component] = true;
  }
  for (std::uint32_t k = 0; k < n; ++k) {
    if (triangulation.component[k] == k && !is_settled[k]) result.unclear.emplace_back(k);
  }
  return result;
}

#define DELCERT_INSTANTIATE(m)                                                                                        \
  template GraphDensity graph_density<m>(const GraphVertices&, const std::vector<LabelSimplex<m>>&,                   \
                                         const GraphTriangulation<m>&, const Rational&);                              \
  template RestrictedDelaunay check_restricted_delaunay<m>(const GraphVertices&, const std::vector<LabelSimplex<m>>&, \
                                                           const GraphTriangulation<m>&, const Rational&,             \
                                                           const GraphDensity&, GraphMetric, const Progress&);
DELCERT_INSTANTIATE(1)
DELCERT_INSTANTIATE(2)
DELCERT_INSTANTIATE(3)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
