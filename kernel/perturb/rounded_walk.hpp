#pragma once

#include "kernel/perturb/rounded_frame.hpp"
#include "kernel/perturb/simplex_walk.hpp"
#include "kernel/simplex/sphere_form.hpp"

namespace delcert {

/// What a visitor of a rounded walk knows of a simplex.
enum class RoundedAnswer {
  go_on,   ///< to the simplices that contain it
  stop,    ///< these are not asked for
  unsure,  ///< the doubles cannot tell: the walk on intervals visits it, and what contains it
};

/// A simplex of dimension below m.
template <class S, int m>
struct FaceForm {
  SphereForm<S, m> sphere;
  S base{};  ///< the weight is `base` times the squared altitude of the last vertex
};

/// Bounds of all that a rounded walk computes, by the formulas themselves.
template <int m>
struct RoundedBounds {
  using Bound = RoundingBound;
  Vector<Bound, m> place{};  ///< of a point of the view
  Vector<Bound, m> edge{};
  Bound squared_edge;
  double most_squared_edge = 0;  ///< the bounds hold for edges whose computed square is below this
  std::array<FaceForm<Bound, m>, static_cast<std::size_t>(m)> face{};  ///< by dimension
  double slope_error = 0;                                              ///< of an apex

  /// Every coordinate of a place is at most `size`, known up to `error`; edges are about as long as the root of
  /// `most_squared` at most.
  RoundedBounds(double size, double error, double most_squared) {
    place.fill(Bound::of(size + error, error));
    edge = difference(place, place);
    for (Bound& coordinate : edge) coordinate = coordinate.at_most(std::sqrt(most_squared) * (1 + 0x1p-20));
    squared_edge = pairing(edge, edge).at_most(most_squared);
    most_squared_edge = (most_squared - squared_edge.error()) * (1 - 0x1p-40);
    face[0].sphere = point_form<Bound, m>();
    if constexpr (m > 1) face[1] = {edge_form<Bound, m>(edge), Bound(1)};
    if constexpr (m > 2) face[2] = {triangle_form<Bound, m>(edge, squared_edge, edge, squared_edge), squared_edge};
    slope_error = apex().slope.error();
  }
  [[nodiscard]] FacetForm<Bound, m> facet() const {
    std::array<Vector<Bound, m>, static_cast<std::size_t>(m)> edges;
    edges.fill(edge);
    return FacetForm<Bound, m>(face[m - 1].sphere, edges);
  }
  [[nodiscard]] ApexForm<Bound> apex() const { return ApexForm<Bound>(facet(), edge, squared_edge); }
};

/// The walk of `SimplexWalk` in doubles with a bound of their errors that is known beforehand; what they leave open
/// goes to that walk. 1 ≤ m ≤ 3.
///
/// Visitor, besides what `SimplexWalk` asks for:
///   void start_rounded(const Vector<double, m>& place) – the first vertex of what follows;
///   RoundedAnswer enter_rounded(const FaceForm<double, m>&, std::span<const std::uint32_t> vertices)
///   void facet_rounded(const FacetForm<double, m>&) – the facet of those that follow;
///   RoundedAnswer over_rounded(const FacetForm<double, m>&, const ApexForm<double>&,
///                              std::span<const std::uint32_t> vertices)
///   void count_over(std::uint64_t count) – of so many it was not unsure
/// and if `visits_top`, where `over_rounded` says to go on,
///   bool top_rounded(const SphereForm<double, m>&, const Vector<double, m>& edge, double squared_edge)
///     – an m-simplex and one further vertex: whether the doubles can tell.
template <int m, class Visitor>
class RoundedWalk {
 public:
  /// References are kept. `places`: those of the positions of the view; `bounds` holds for them. Preconditions: those
  /// of the other walk.
  RoundedWalk(const PatchView<m>& view, const std::vector<Vector<double, m>>& places, const RoundedBounds<m>& bounds,
              SimplexWalk<m, Visitor>& thorough, Visitor& visitor)
      : view_(&view), places_(&places), thorough_(&thorough), visitor_(&visitor) {
    most_squared_edge_ = bounds.most_squared_edge;
    squared_edge_error_ = bounds.squared_edge.error();
    for (std::size_t k = 0; k < m; ++k) weight_error_[k] = bounds.face[k].sphere.weight.error();
    slope_error_ = bounds.slope_error;
  }

  /// All simplices whose first vertex is this one.
  void from(std::uint32_t origin) {
    const auto row = view_->later_neighbours(origin);
    edges_.resize(view_->size());
    squared_edges_.resize(view_->size());
    const Vector<double, m>& home = (*places_)[origin];
    for_each_bit(row, [&](std::uint32_t other) {
      edges_[other] = difference((*places_)[other], home);
      squared_edges_[other] = pairing(edges_[other], edges_[other]);
    });
    vertices_[0] = origin;
    masks_[0].assign(row.begin(), row.end());
    for (BitRow* mask = &masks_[0] + 1; mask != &masks_[0] + m; ++mask) mask->resize(view_->words());
    top_mask_.resize(view_->words());
    visitor_->start_rounded(home);
    extend<1>(FaceForm<double, m>{point_form<double, m>(), 1});
  }

 private:
  [[nodiscard]] std::span<const std::uint32_t> vertices(std::size_t count) const { return {vertices_.data(), count}; }
  [[gnu::noinline]] void leave_open(std::size_t count, std::uint32_t next) { thorough_->extend(vertices(count), next); }

  /// What contains the face of the first `count` vertices. Nearly all of the time goes here.
  template <std::size_t count>
  [[gnu::flatten]] void extend(const FaceForm<double, m>& face) {
    if constexpr (count == m) {
      walk_over(FacetForm<double, m>(face.sphere, facet_edges()));
    } else {
      for_each_bit(masks_[count - 1], [&](std::uint32_t next) { step<count>(next); });
    }
  }

  [[nodiscard]] std::array<Vector<double, m>, static_cast<std::size_t>(m)> facet_edges() const {
    std::array<Vector<double, m>, static_cast<std::size_t>(m)> result{};
    for (std::size_t at = 1; at < m; ++at) result[at - 1] = edges_[vertices_[at]];
    return result;
  }

  template <std::size_t count>
  void step(std::uint32_t next) {
    const Vector<double, m>& edge = edges_[next];
    const double squared = squared_edges_[next];
    FaceForm<double, m> face;
    if constexpr (count == 1) {
      face = {edge_form<double, m>(edge), 1};
      if (!(squared > squared_edge_error_ && squared < most_squared_edge_)) return leave_open(count, next);
    } else {
      const std::uint32_t first = vertices_[1];
      face = {triangle_form<double, m>(edges_[first], squared_edges_[first], edge, squared), squared_edges_[first]};
      if (!(face.sphere.weight > weight_error_[count] && squared < most_squared_edge_)) return leave_open(count, next);
    }
    vertices_[count] = next;
    const RoundedAnswer answer = visitor_->enter_rounded(face, vertices(count + 1));
    if (answer == RoundedAnswer::unsure) return leave_open(count, next);
    if (answer == RoundedAnswer::stop) return;
    if (narrow(masks_[count - 1], next, masks_[count]) != 0) extend<count + 1>(face);
  }

  /// What of this comes after a vertex.
  std::uint64_t narrow(const BitRow& mask, std::uint32_t vertex, BitRow& narrowed) const {
    const auto row = view_->later_neighbours(vertex);
    std::uint64_t any = 0;
    for (std::size_t word = 0; word < row.size(); ++word) any |= narrowed[word] = mask[word] & row[word];
    return any;
  }

  void walk_over(const FacetForm<double, m>& facet) {
    visitor_->facet_rounded(facet);
    std::uint64_t sure = 0;
    for_each_bit(masks_[m - 1], [&](std::uint32_t next) {
      const double squared = squared_edges_[next];
      const ApexForm<double> apex(facet, edges_[next], squared);
      vertices_[m] = next;
      const RoundedAnswer answer = std::fabs(apex.slope) > slope_error_ && squared < most_squared_edge_
                                       ? visitor_->over_rounded(facet, apex, vertices(m + 1))
                                       : RoundedAnswer::unsure;
      if (answer == RoundedAnswer::unsure) {
        leave_open(m, next);
        return;
      }
      ++sure;
      if constexpr (Visitor::visits_top) {
        if (answer == RoundedAnswer::go_on && narrow(masks_[m - 1], next, top_mask_) != 0)
          look_at_tops(apex.form(facet));
      }
    });
    visitor_->count_over(sure);
  }

  void look_at_tops(const SphereForm<double, m>& form) {
    for_each_bit(top_mask_, [&](std::uint32_t apex) {
      const double squared = squared_edges_[apex];
      if (!(squared < most_squared_edge_) || !visitor_->top_rounded(form, edges_[apex], squared))
        thorough_->look_at_top(vertices(m + 1), apex);
    });
  }

  const PatchView<m>* view_;
  const std::vector<Vector<double, m>>* places_;
  SimplexWalk<m, Visitor>* thorough_;
  Visitor* visitor_;
  double most_squared_edge_ = 0;
  double squared_edge_error_ = 0;
  std::array<double, static_cast<std::size_t>(m)> weight_error_{};  // by dimension
  double slope_error_ = 0;
  std::array<BitRow, static_cast<std::size_t>(m)> masks_;
  BitRow top_mask_;
  std::vector<Vector<double, m>> edges_;
  std::vector<double> squared_edges_;
  ViewSimplex<m> vertices_{};
};

}  // namespace delcert
