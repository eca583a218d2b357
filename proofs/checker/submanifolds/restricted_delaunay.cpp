#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <optional>

#include "proofs/checker/geometry/simplex.hpp"
#include "proofs/checker/submanifolds/chord_bend.hpp"
#include "proofs/checker/submanifolds/polyhedron.hpp"

namespace delcert::checker {
namespace {

constexpr int most_halvings = 12, halvings_at_ease = 5;
// It is looked at how M bends about the chords from boxes that are halved so often; the second, where the changes of
// slopes say nothing.
constexpr int halvings_of_bends = 5, halvings_of_first_bends = 3;
constexpr std::size_t most_boxes_of_label = std::size_t{1} << 16;

Interval exactly_at(double x) { return Interval::between(x, x); }

/// A label that may be as near to a point x of M as label i is; w = p'_k - p'_i.
struct Rival {
  Label label;
  Vector<Interval> along{};                               // E_i^T w
  std::array<Interval, FormulaMap::most_variables> up{};  // N_i^T w
  Interval squared{0};                                    // |w|^2
  double height = 0;                                      // |N_i^T w|, from above
  bool shown = false;                                     // by chart i, certainly
  bool only_straight = false;                             // distances in M from it are known to be greater than from i
};

/// Over a place of the chart M is at such heights, both relative to p'_i, up to an error.
struct Anchor {
  std::array<double, 4> place{};
  std::array<double, FormulaMap::most_variables> height{};
  double error = 0;
};

/// How M bends about the chords from a box to a label.
struct Bend {
  const Rival* to;  // none: label i itself
  std::optional<ChordBend> chords;
};

/// A box of places of the chart, relative to that of p'_i, and the labels that may be as near as i somewhere over it.
struct DiscBox {
  Vector<Interval> place{};
  Anchor anchor;
  int halvings = 0;
  std::vector<const Rival*> open;
  std::shared_ptr<const std::vector<Bend>> bends;  // of a box around it, if any
};

/// M is so steep at most where it is no farther than this from the origin of a chart: less near it (sub.graph), but for
/// meshes.
Interval slope_within(const TangentCharts& charts, Label i, double distance) {
  const Interval& slope = charts.manifold().slope.filter;
  if (charts.polyhedron() != nullptr) return slope;
  const Interval share = exactly_at(distance) / charts.patch(i).radius.filter;
  const Interval here = slope * (Interval(1) + Interval(7) * share) / Interval(8);
  return exactly_at(std::min(slope.upper(), here.upper()));
}

/// The rule 4.cover for one label i; reach: the radius of the disc.
class CoveredDisc {
 public:
  CoveredDisc(const TangentCharts& charts, Label i, double reach, FormulaValues<Interval>& values)
      : charts_(charts),
        c_(charts.certificate()),
        i_(i),
        m_(charts.manifold().m),
        q_(charts.manifold().q),
        values_(values),
        radius_(exactly_at(reach)),
        slope_(charts.manifold().slope.filter.upper()),
        bend_{upper_root(Interval(1) + square(charts.manifold().slope.filter))},
        height_(transposed_times(charts.chart(i).normal, charts.point(i) - charts.chart(i).centre)),
        home_(upper_root(
            squared_norm(transposed_times(charts.chart(i).tangent, charts.point(i) - charts.chart(i).centre)))),
        wide_(reach_of_bends(radius_.upper(), (charts.patch(i).radius.filter - exactly_at(home_)).lower())) {
    find_rivals();
    if (c_.intrinsic) bound_changes();
  }

  /// Whether all boxes are near or in a star; false if some edge is missing from the complex, even if other boxes are
  /// too small to be divided.
  bool check(std::size_t& boxes) {
    std::vector<DiscBox> open(1);
    for (std::size_t k = 0; k < m_; ++k) open[0].place[k] = Interval::between(-radius_.upper(), radius_.upper());
    for (const Rival& rival : rivals_) open[0].open.push_back(&rival);
    std::optional<DiscBox> unsettled;
    for (std::size_t looked_at = 0; !open.empty(); ++looked_at, ++boxes) {
      DiscBox box = std::move(open.back());
      open.pop_back();
      Budget::spend(20 + 5 * box.open.size());
      if (is_outside(box) || is_settled(box)) continue;
      if (c_.intrinsic && !is_sharp_ && box.halvings == halvings_at_ease) {
        sharpen();
        if (is_settled(box)) continue;
      }
      if (are_bends_due(box) && is_settled_by_bends(box)) continue;
      if (is_edge_missing(box)) return false;
      if (looked_at == most_boxes_of_label) undecided(unsettled ? *unsettled : box);
      if (box.halvings < most_halvings) {
        halve(box, open);
      } else if (!unsettled) {
        unsettled = std::move(box);
      }
    }
    if (unsettled) undecided(*unsettled);
    return true;
  }

 private:
  void find_rivals() {
    const TangentChart<Interval>& chart = charts_.chart(i_);
    const TangentPatch& patch = charts_.patch(i_);
    // All points over the disc are so far from p'_i, along M as well.
    const double reach = bend_.stretch * radius_.upper();
    const Interval home = square_root(squared_norm(transposed_times(chart.tangent, charts_.point(i_) - chart.centre)));
    const bool is_wide = (patch.radius.filter - home - radius_).lower() > reach;
    charts_.points().visit(charts_.point(i_), 2 * reach, [&](Label k) {
      if (k == i_) return;
      const Matrix<Interval> offset = charts_.point(k) - charts_.point(i_),
                             along = transposed_times(chart.tangent, offset),
                             up = transposed_times(chart.normal, offset);
      Rival rival;
      rival.label = k;
      rival.squared = squared_norm(offset);
      if (square_root(rival.squared).lower() > 2 * reach) return;
      for (std::size_t a = 0; a < m_; ++a) rival.along[a] = along[a];
      for (std::size_t a = 0; a < q_; ++a) rival.up[a] = up[a];
      rival.height = norm_above(up);
      if (c_.intrinsic) {
        const Matrix<Interval> from_centre = charts_.point(k) - chart.centre;
        Verdict shown =
            less(square_root(squared_norm(transposed_times(chart.tangent, from_centre))), patch.radius.filter);
        const Matrix<Interval> heights = transposed_times(chart.normal, from_centre);
        for (std::size_t a = 0; a < q_; ++a) {
          shown = conjunction(
              shown, conjunction(less(heights[a], patch.height.filter), less(-heights[a], patch.height.filter)));
        }
        rival.shown = shown == Verdict::proved && norm_above(along) <= wide_;
        rival.only_straight = shown == Verdict::refuted && is_wide;
        if (rival.only_straight && !c_.extrinsic) return;
      }
      rivals_.push_back(rival);
    });
  }

  /// How slopes of M change, along segments of the chart as far from p'_i as labels are said to be near.
  void bound_changes() {
    if (charts_.polyhedron() != nullptr) {
      const auto change = charts_.polyhedron()->slope_change(i_, charts_.point(i_), wide_);
      bend_.rate = change.rate;
      bend_.size = change.size;
      return;
    }
    bend_.rate = bend_about(charts_.point(i_), 0, wide_, slope_within(charts_, i_, home_ + wide_).upper());
  }

  /// The same for a zero set, cell by cell of the square around; once some box asks for it.
  void sharpen() {
    is_sharp_ = true;
    if (charts_.polyhedron() != nullptr) return;
    constexpr std::size_t parts = 4;
    const TangentChart<Interval>& chart = charts_.chart(i_);
    const double side = 2 * wide_ / parts, corner = side * upper_root(Interval(static_cast<int>(m_))) / 2;
    std::size_t cells = 1;
    for (std::size_t a = 0; a < m_; ++a) cells *= parts;
    double rate = 0;
    for (std::size_t code = 0; code < cells; ++code) {
      Vector<Interval> middle{};
      std::size_t rest = code;
      for (std::size_t a = 0; a < m_; ++a, rest /= parts)
        middle[a] = exactly_at(side * (static_cast<double>(2 * (rest % parts)) - (parts - 1)) / 2);
      const Interval away = square_root(squared_length(middle));
      if (away.lower() > wide_ + corner) continue;
      // M is looked for over the middle, or over a place that is nearer to the origin, inside of the disc.
      double reach = corner;
      const double inwards = std::min(1.0, 0.875 * wide_ / away.upper());
      Interval moved(0);
      for (std::size_t a = 0; a < m_; ++a) {
        const Interval nearer = exactly_at(inwards * middle[a].upper());
        moved = moved + square(nearer - middle[a]);
        middle[a] = nearer;
      }
      reach += upper_root(moved);
      Anchor anchor;
      if (!find_anchor(middle, DiscBox().anchor, anchor)) return;
      Matrix<Interval> place(m_, 1), z(q_, 1);
      for (std::size_t a = 0; a < m_; ++a) place[a] = middle[a];
      for (std::size_t a = 0; a < q_; ++a) z[a] = exactly_at(anchor.height[a]);
      const double farthest = upper_root(squared_length(middle)) + reach;
      rate = std::max(rate, bend_about(charts_.point(i_) + chart.tangent * place + chart.normal * z, anchor.error,
                                       reach, slope_within(charts_, i_, home_ + farthest).upper()));
    }
    bend_.rate = std::min(bend_.rate, rate);
  }

  /// A bound of the second derivative of the heights of M over the places within a distance of that of a point; over
  /// the place M is within the error of the point, and nowhere steeper than the slope.
  double bend_about(const Matrix<Interval>& point, double error, double wide, double slope) {
    const TangentChart<Interval>& chart = charts_.chart(i_);
    const std::size_t N = m_ + q_;
    const double high = error + slope * wide;
    values_.evaluate(point, 1);
    double theta = norm_above(one_less(chart.Y * values_.jacobian() * chart.normal));
    Matrix<Interval> box = point;
    for (std::size_t a = 0; a < N; ++a) {
      Interval tangent(0), normal(0);
      for (std::size_t k = 0; k < m_; ++k) tangent = tangent + square(chart.tangent(a, k));
      for (std::size_t k = 0; k < q_; ++k) normal = normal + square(chart.normal(a, k));
      const double half = wide * upper_root(tangent) + high * upper_root(normal);
      box[a] = box[a] + Interval::between(-half, half);
    }
    values_.evaluate(box, 2);
    Interval flat(0), mixed(0), steep(0);  // of Y D^2 f, the squared norms in tangent and normal directions
    for (std::size_t g = 0; g < q_; ++g) {
      Matrix<Interval> second(N, N);
      for (std::size_t f = 0; f < q_; ++f) {
        for (std::size_t a = 0; a < N; ++a) {
          for (std::size_t b = 0; b < N; ++b) second(a, b) = second(a, b) + chart.Y(g, f) * values_.second(f, a, b);
        }
      }
      const Matrix<Interval> tangent = second * chart.tangent, normal = second * chart.normal;
      flat = flat + squared_norm(transposed_times(chart.tangent, tangent));
      mixed = mixed + squared_norm(transposed_times(chart.tangent, normal));
      steep = steep + squared_norm(transposed_times(chart.normal, normal));
    }
    theta += upper_root(mixed) * wide + upper_root(steep) * high;
    const double above = upper_root(flat) + 2 * slope * upper_root(mixed) + slope * slope * upper_root(steep);
    return theta < 1 ? (Interval::between(0, above) / (Interval(1) - exactly_at(theta))).upper()
                     : std::numeric_limits<double>::infinity();
  }

  Interval squared_length(const Vector<Interval>& x) const { return dot(x, x, m_); }

  bool is_outside(const DiscBox& box) const { return squared_length(box.place).lower() > square(radius_).upper(); }

  /// |x - p'_k|^2 - |x - p'_i|^2 for the points of M over the box.
  Interval lead(const DiscBox& box, const Rival& rival) const {
    Interval result = rival.squared, off(0);
    for (std::size_t a = 0; a < m_; ++a) {
      result = result - Interval(2) * box.place[a] * rival.along[a];
      off = off + square(box.place[a] - exactly_at(box.anchor.place[a]));
    }
    for (std::size_t a = 0; a < q_; ++a) result = result - Interval(2) * exactly_at(box.anchor.height[a]) * rival.up[a];
    const double error = 2 * rival.height * (box.anchor.error + slope_ * upper_root(off));
    return result + Interval::between(-error, error);
  }

  /// From p'_i to the points of M over the box, in R^N.
  Matrix<Interval> offset(const DiscBox& box) const {
    Matrix<Interval> along(m_, 1), up(q_, 1);
    Interval off(0);
    for (std::size_t a = 0; a < m_; ++a) {
      along[a] = box.place[a];
      off = off + square(box.place[a] - exactly_at(box.anchor.place[a]));
    }
    const double error = box.anchor.error + slope_ * upper_root(off);
    for (std::size_t a = 0; a < q_; ++a) up[a] = exactly_at(box.anchor.height[a]) + Interval::between(-error, error);
    return charts_.chart(i_).tangent * along + charts_.chart(i_).normal * up;
  }

  /// How far a label is from the points of M over the box; no rival: label i itself.
  Distance distance(const DiscBox& box, const Rival* rival) const {
    Interval squared(0);
    for (std::size_t a = 0; a < m_; ++a)
      squared = squared + square(rival == nullptr ? box.place[a] : box.place[a] - rival->along[a]);
    Distance result = bend_.distance(squared, rival == nullptr || rival->shown);
    if (!box.bends) return result;
    for (const Bend& bend : *box.bends) {
      if (bend.to != rival || !bend.chords) continue;
      Matrix<Interval> chord = Interval(-1) * offset(box);
      if (rival != nullptr) chord = chord + (charts_.point(rival->label) - charts_.point(i_));
      const ChordExcess excess = bend.chords->excess(chord);
      result.chord = std::min(result.chord, norm_above(chord));
      result.excess.most = std::min(result.excess.most, excess.most);
      result.excess.least = excess.least;
    }
    return result;
  }

  bool is_nearer(const DiscBox& box, const Rival& rival, const Interval& lead) const {
    if (!(lead.upper() < 0)) return false;
    return !c_.intrinsic || -lead.upper() > least_lead(distance(box, &rival), distance(box, nullptr).excess);
  }
  bool is_farther(const DiscBox& box, const Rival& rival, const Interval& lead, const Distance& own) const {
    if (!(lead.lower() > 0)) return false;
    if (!c_.intrinsic || rival.only_straight || lead.lower() > least_lead(own, {})) return true;
    return box.bends && lead.lower() > least_lead(own, distance(box, &rival).excess);
  }

  bool are_bends_due(const DiscBox& box) const {
    if (!c_.intrinsic || charts_.polyhedron() != nullptr || q_ != 1) return false;
    const bool is_change_known = !is_sharp_ || bend_.excess(radius_.upper()) < radius_.upper();
    return box.halvings == halvings_of_bends || (!is_change_known && box.halvings == halvings_of_first_bends);
  }
  /// By the chords to p'_i, then by those to labels that are still open.
  bool is_settled_by_bends(DiscBox& box) {
    const Matrix<Interval> from = charts_.point(i_) + offset(box);
    const auto bend_to = [&](const Rival* rival) {
      const Label label = rival == nullptr ? i_ : rival->label;
      return Bend{rival, bend_about_chords(charts_.manifold().box, values_, from, charts_.point(label))};
    };
    std::vector<Bend> bends = {bend_to(nullptr)};
    if (!bends[0].chords) return false;
    box.bends = std::make_shared<const std::vector<Bend>>(bends);
    if (is_settled(box)) return true;
    for (const Rival* rival : box.open) bends.push_back(bend_to(rival));
    box.bends = std::make_shared<const std::vector<Bend>>(std::move(bends));
    return is_settled(box);
  }

  /// Keeps of the open labels of the box those that may be as near as i.
  bool is_settled(DiscBox& box) const {
    const Distance own = distance(box, nullptr);
    std::vector<const Rival*> open;
    for (const Rival* rival : box.open) {
      const Interval ahead = lead(box, *rival);
      if (is_nearer(box, *rival, ahead)) return true;
      if (!is_farther(box, *rival, ahead, own)) open.push_back(rival);
    }
    box.open = std::move(open);
    for (std::size_t s = 0; s < c_.star_size(i_); ++s) {
      const Label* others = c_.star_simplex(i_, s);
      if (std::all_of(box.open.begin(), box.open.end(),
                      [&](const Rival* rival) { return std::find(others, others + m_, rival->label) != others + m_; }))
        return true;
    }
    return false;
  }

  /// Whether i and one other label, of no simplex at i, are somewhere in the box as near as each other, and all others
  /// farther: then the two are an edge of the Delaunay complex.
  bool is_edge_missing(const DiscBox& box) const {
    if (box.open.size() != 1 || !(squared_length(box.place).upper() < square(radius_).lower())) return false;
    const Rival& rival = *box.open[0];
    for (std::size_t s = 0; s < c_.star_size(i_); ++s) {
      const Label* others = c_.star_simplex(i_, s);
      if (std::find(others, others + m_, rival.label) != others + m_) return false;
    }
    DiscBox near = box, far = box;
    for (std::size_t a = 0; a < m_; ++a) {
      const bool rising = NearPoints::middle(rival.along[a]) > 0;
      near.place[a] = exactly_at(rising ? box.place[a].upper() : box.place[a].lower());
      far.place[a] = exactly_at(rising ? box.place[a].lower() : box.place[a].upper());
    }
    return is_nearer(near, rival, lead(near, rival)) &&
           is_farther(far, rival, lead(far, rival), distance(far, nullptr));
  }

  /// The parts have an anchor near to them.
  void halve(DiscBox& box, std::vector<DiscBox>& open) {
    Vector<Interval> middle{};
    Interval half(0), off(0);
    for (std::size_t a = 0; a < m_; ++a) {
      middle[a] = exactly_at(NearPoints::middle(box.place[a]));
      half = half + square(box.place[a] - middle[a]);
      off = off + square(middle[a] - exactly_at(box.anchor.place[a]));
    }
    if (off.lower() > 4 * half.upper() && squared_length(middle).upper() < square(exactly_at(wide_)).lower()) {
      const Anchor from = box.anchor;
      find_anchor(middle, from, box.anchor);
    }
    for (std::size_t part = 0; part < std::size_t{1} << m_; ++part) {
      open.push_back(box);
      ++open.back().halvings;
      for (std::size_t a = 0; a < m_; ++a) {
        const double at = middle[a].upper();
        open.back().place[a] = (part >> a & 1U) != 0 ? Interval::between(at, box.place[a].upper())
                                                     : Interval::between(box.place[a].lower(), at);
      }
    }
  }

  /// What is over a place of the disc, if it is found in the cylinder.
  bool find_anchor(const Vector<Interval>& middle, const Anchor& from, Anchor& result) {
    Budget::spend(200);
    const TangentChart<Interval>& chart = charts_.chart(i_);
    Anchor anchor;
    Matrix<Interval> place(m_, 1), z(q_, 1);
    for (std::size_t a = 0; a < m_; ++a) {
      place[a] = middle[a];
      anchor.place[a] = middle[a].upper();
    }
    const Matrix<Interval> foot = charts_.point(i_) + chart.tangent * place;
    for (std::size_t a = 0; a < q_; ++a) z[a] = exactly_at(from.height[a]);
    if (charts_.polyhedron() != nullptr) find_height_of_mesh(from, place, z[0], anchor);
    for (int step = 0; charts_.polyhedron() == nullptr; ++step) {
      values_.evaluate(foot + chart.normal * z, 0);
      const Matrix<Interval> error = chart.Y * values_.value();
      if (step == 3) {
        anchor.error = (square_root(squared_norm(error)) / (Interval(1) - exactly_at(charts_.theta(i_)))).upper();
        break;
      }
      for (std::size_t a = 0; a < q_; ++a) z[a] = exactly_at(NearPoints::middle(z[a] - error[a]));
    }
    const Interval lid = charts_.patch(i_).height.filter;
    for (std::size_t a = 0; a < q_; ++a) {
      const Interval height = height_[a] + z[a];
      if (conjunction(less(height, lid), less(-height, lid)) != Verdict::proved) return false;
      anchor.height[a] = z[a].upper();
    }
    if (!(anchor.error < std::numeric_limits<double>::infinity())) return false;
    result = anchor;
    return true;
  }

  /// As far from that of the last anchor as the slope allows, at most.
  void find_height_of_mesh(const Anchor& from, const Matrix<Interval>& place, Interval& z, Anchor& anchor) const {
    const TangentChart<Interval>& chart = charts_.chart(i_);
    Interval off(0);
    for (std::size_t a = 0; a < m_; ++a) off = off + square(place[a] - exactly_at(from.place[a]));
    const double reach = from.error + slope_ * upper_root(off);
    const Matrix<Interval> from_centre = transposed_times(chart.tangent, charts_.point(i_) - chart.centre) + place;
    const Interval found = charts_.polyhedron()->height_over(i_, from_centre, height_[0] + z, reach) - height_[0];
    z = exactly_at(NearPoints::middle(found));
    const Interval error = found - z;
    anchor.error = std::max(error.upper(), -error.lower());
  }

  [[noreturn]] void undecided(const DiscBox& box) const {
    std::string text = "which labels are nearest in the chart of label " + std::to_string(i_) + ", from it at ";
    for (std::size_t a = 0; a < m_; ++a) {
      text += (a == 0 ? "[" : " x [") + about(exactly_at(box.place[a].lower())) + ", " +
              about(exactly_at(box.place[a].upper())) + "]";
    }
    throw Undecided(text);
  }

  const TangentCharts& charts_;
  const Certificate& c_;
  Label i_;
  std::size_t m_, q_;
  FormulaValues<Interval>& values_;
  Interval radius_;
  double slope_;
  ChartBend bend_;
  Matrix<Interval> height_;  // of p'_i
  std::vector<Rival> rivals_;
  double home_;  // how far p'_i is from the origin of the chart
  double wide_;  // in the intrinsic case labels that are farther in the chart are not said to be near
  bool is_sharp_ = false;
};

/// How far what is over a simplex is from its vertices, at most: by its circumradius, and what it is moved by, in the
/// chart of the best of them.
double reach_over(const TangentCharts& charts, const GraphTriangulation& triangulation, std::size_t s) {
  const Certificate& c = charts.certificate();
  const Label* labels = c.simplex(s);
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k <= c.m; ++k) {
    const TangentChart<Interval>& chart = charts.chart(labels[k]);
    std::vector<Vector<Interval>> vertices(c.m_size() + 1);
    for (std::size_t v = 1; v <= c.m_size(); ++v) {
      const Matrix<Interval> place = transposed_times(chart.tangent, charts.point(labels[v]) - charts.point(labels[0]));
      for (std::size_t a = 0; a < c.m_size(); ++a) vertices[v][a] = place[a];
    }
    const Simplex<Interval> simplex(c.metric, vertices);
    if (simplex.complete != Verdict::proved) continue;
    const double moved = triangulation.movement_in(labels[k], s);
    double farthest = 0;  // what is over the simplex, from the origin of the chart
    for (std::size_t v = 0; v <= c.m_size(); ++v)
      farthest =
          std::max(farthest, norm_above(transposed_times(chart.tangent, charts.point(labels[v]) - chart.centre)));
    const Interval steepest = slope_within(charts, labels[k], farthest + moved);
    least = std::min(least, (square_root(Interval(1) + square(steepest)) *
                             Interval::between(0, upper_root(simplex.radius_squared) + moved))
                                .upper());
  }
  return least;
}

/// 4.density. How far points of M may be from each label that is nearest to them: as what is over some simplex near it.
std::vector<double> check_dense(const TangentCharts& charts, const GraphTriangulation& triangulation, Report& report) {
  const Certificate& c = charts.certificate();
  const Interval stretch = square_root(Interval(1) + square(charts.manifold().slope.filter));
  std::vector<double> reaches(c.n, 0);
  for (std::size_t s = 0; s < c.simplex_count(); ++s) {
    const Label *begin = c.simplex(s), *end = begin + c.m + 1;
    const double least = reach_over(charts, triangulation, s);
    const double around = ((Interval(1) + stretch) * exactly_at(least)).upper();
    bool small = true;
    for (const Label* v = begin; v != end; ++v) {
      reaches[*v] = std::max(reaches[*v], least);
      small = small && least <= c.at(*v, c.density).filter.lower();
      if (!(least < std::numeric_limits<double>::infinity())) continue;
      charts.points().visit(charts.point(*v), around, [&](Label i) {
        if (least <= reaches[i]) return;
        const Matrix<Interval> offset = charts.point(i) - charts.point(*v);
        if (square_root(squared_norm(offset)).lower() > around) return;
        reaches[i] = least;
        small = small && least <= c.at(i, c.density).filter.lower();
      });
    }
    if (small) continue;
    report.reject("4.density", [&] {
      return "points over simplex " + label_set(begin, end) + " may be " + about(exactly_at(least)) +
             " away from its vertices";
    });
  }
  // As far as the certificate says, where that is refuted.
  for (Label i = 0; i < c.n; ++i) reaches[i] = std::min(reaches[i], c.at(i, c.density).filter.upper());
  return reaches;
}

/// 4.patch: what is within reach of a point is over the disc around it, and below the lid.
void check_patch(const TangentCharts& charts, Label i, double reach, Report& report) {
  const Certificate& c = charts.certificate();
  const TangentChart<Interval>& chart = charts.chart(i);
  const Matrix<Interval> offset = charts.point(i) - chart.centre;
  Verdict inside = less(square_root(squared_norm(transposed_times(chart.tangent, offset))) + exactly_at(reach),
                        charts.patch(i).radius.filter);
  const Matrix<Interval> heights = transposed_times(chart.normal, offset);
  for (std::size_t a = 0; c.extrinsic && a < heights.size(); ++a) {
    const Interval room = charts.patch(i).height.filter - exactly_at(reach);
    inside = conjunction(inside, conjunction(less(heights[a], room), less(-heights[a], room)));
  }
  if (inside == Verdict::proved) return;
  report.reject("4.patch", [&] {
    return "points over no disc of the patch of label " + std::to_string(i) + " may be nearest to it";
  });
}

/// 4.clear: no simplex of the component about k, but its own, is above the place of k.
bool is_clear(const TangentCharts& charts, const GraphTriangulation& triangulation, Label k,
              const std::vector<Label>& component) {
  const Certificate& c = charts.certificate();
  const double stretch = upper_root(Interval(1) + square(charts.manifold().slope.filter));
  std::vector<bool> near(c.n);
  charts.points().visit(charts.point(k), (1 + stretch) * c.at(k, c.density).filter.upper(),
                        [&](Label v) { near[v] = true; });
  for (std::size_t s = 0; s < c.simplex_count(); ++s) {
    const Label *begin = c.simplex(s), *end = begin + c.m + 1;
    Budget::spend(1);
    if (component[*begin] != component[k] || std::find(begin, end, k) != end) continue;
    if (std::none_of(begin, end, [&](Label v) { return near[v]; })) continue;
    if (!triangulation.is_beside(k, k, s, 0)) return false;
  }
  return true;
}

}  // namespace

std::string check_restricted_delaunay(const TangentCharts& charts, const GraphTriangulation& triangulation,
                                      Report& report) {
  const Certificate& c = charts.certificate();
  FormulaValues<Interval> values(charts.manifold().map);
  std::size_t boxes = 0;
  const std::vector<double> reaches = check_dense(charts, triangulation, report);
  for (Label i = 0; i < c.n; ++i) check_patch(charts, i, reaches[i], report);
  require_clear_labels(
      c, "4.clear",
      [&](Label k, const std::vector<Label>& component) { return is_clear(charts, triangulation, k, component); },
      report);
  for (Label i = 0; i < c.n; ++i) {
    if (CoveredDisc(charts, i, reaches[i], values).check(boxes)) continue;
    report.reject("4.cover", [&] {
      return "label " + std::to_string(i) + " and one of no simplex with it are together nearest to a point";
    });
  }
  const char* of = !c.extrinsic  ? "distances in the manifold"
                   : c.intrinsic ? "distances in R^N, and in the manifold"
                                 : "distances in R^N";
  return "the complex is the Delaunay complex of the points by " + std::string(of) + ", in " + std::to_string(boxes) +
         " boxes; density <= " + rounded_up(c.density.exact) + c.of_lengths();
}

}  // namespace delcert::checker
