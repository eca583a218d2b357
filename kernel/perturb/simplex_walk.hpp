#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "kernel/perturb/patch_view.hpp"
#include "kernel/simplex/sphere_stack.hpp"

namespace delcert {

/// The vertices of a simplex as positions in a patch view.
template <int m>
using ViewSimplex = std::array<std::uint32_t, static_cast<std::size_t>(m) + 2>;

/// Calls `visit` with the positions of the bits that are set, in increasing order.
template <class Visit>
[[gnu::always_inline]] inline void for_each_bit(std::span<const std::uint64_t> words, const Visit& visit) {
  for (std::size_t word = 0; word < words.size(); ++word) {
    for (std::uint64_t rest = words[word]; rest != 0; rest &= rest - 1) {
      visit(static_cast<std::uint32_t>(word * 64 + static_cast<std::size_t>(std::countr_zero(rest))));
    }
  }
}

/// Visits the non-degenerate simplices of dimension 1 … m whose vertices are pairwise adjacent in a patch view, with
/// their diametric spheres, depth first. In the filter; where that cannot tell a simplex from a degenerate one, that
/// branch is walked in rationals.
///
/// Visitor:
///   template <class S> void start(const Vector<S, m>& origin) – the first vertex of what follows;
///   template <class S> bool enter(const SphereStack<S, m>&, std::span<const std::uint32_t> vertices)
///     – a simplex; whether to go on to the simplices that contain it and whose other vertices come later;
///   void degenerate(std::span<const std::uint32_t> vertices)
///     – exactly degenerate; nothing that contains it is visited;
/// and if `visits_top`, which asks for sets of m + 2 points too,
///   template <class S> void top(const SphereStack<S, m>&, std::span<const std::uint32_t> vertices, std::uint32_t apex,
///                               const Vector<S, m>& edge, const S& squared_edge)
///     – an m-simplex entered and one further vertex adjacent to all of its vertices;
/// otherwise the m-simplices are told in the filter as apexes over their facet, which is faster:
///   void facet(const SphereStack<Filter, m>&) – the facet of those that follow;
///   void over(const SphereStack<Filter, m>&, const typename SphereStack<Filter, m>::Apex&,
///             std::span<const std::uint32_t> vertices).
template <int m, class Visitor>
class SimplexWalk {
 public:
  SimplexWalk(const PatchView<m>& view, const MetricOn<Filter, m>& filter, const MetricOn<Rational, m>& exact,
              Visitor& visitor)
      : view_(&view), filter_(&filter), exact_(&exact), visitor_(&visitor), masks_(static_cast<std::size_t>(m) + 2) {}

  /// All simplices whose first vertex is this one. Precondition: a `FilterGuard` is alive.
  void from(std::uint32_t origin) {
    prepare(origin);
    visitor_->template start<Filter>(view_->position(origin));
    SphereStack<Filter, m> stack(*filter_);
    walk(stack, 1);
  }

  /// Of these, the simplices with this vertex next after those given, which have been visited and are not degenerate.
  /// Precondition: that of `from`; all of these vertices are pairwise adjacent, in increasing order, at most m.
  void extend(std::span<const std::uint32_t> vertices, std::uint32_t next) {
    if (vertices_[0] != vertices[0] || !is_prepared_) prepare(vertices[0]);
    std::copy(vertices.begin(), vertices.end(), vertices_.begin());
    const std::size_t count = vertices.size();
    for (std::size_t at = 1; at < count; ++at) narrow(at, vertices[at]);
    visitor_->template start<Filter>(view_->position(vertices[0]));
    SphereStack<Filter, m> stack(*filter_);
    for (std::size_t at = 1; at < count; ++at) {
      if (!is_proved(stack.push(edges_[vertices[at]], squared_edges_[vertices[at]]))) {
        step_exactly(count, next);
        return;
      }
    }
    if constexpr (!Visitor::visits_top) {
      if (stack.dimension() == m - 1) {
        visitor_->facet(stack);
        step_over(stack, count, next);
        return;
      }
    }
    step(stack, count, next);
  }

  /// Of these, the set of an m-simplex that has been entered and a further vertex. Precondition: as for `extend`.
  void look_at_top(std::span<const std::uint32_t> vertices, std::uint32_t apex) {
    if (vertices_[0] != vertices[0] || !is_prepared_) prepare(vertices[0]);
    std::copy(vertices.begin(), vertices.end(), vertices_.begin());
    if (!look_at_top_in<Filter>(SphereStack<Filter, m>(*filter_), vertices, apex))
      look_at_top_in<Rational>(SphereStack<Rational, m>(*exact_), vertices, apex);
  }

 private:
  /// Whether the simplex is certainly not degenerate.
  template <class S>
  bool look_at_top_in(SphereStack<S, m> stack, std::span<const std::uint32_t> vertices, std::uint32_t apex) {
    for (const std::uint32_t vertex : vertices.subspan(1)) {
      const auto vector = edge<S>(vertex);
      if (!is_proved(stack.push(vector, squared<S>(vertex, vector)))) return false;
    }
    const auto apex_edge = edge<S>(apex);
    visitor_->top(stack, vertices, apex, apex_edge, squared<S>(apex, apex_edge));
    return true;
  }

  void prepare(std::uint32_t origin) {
    const std::size_t count = view_->size();
    edges_.resize(count);
    squared_edges_.resize(count);
    const auto row = view_->later_neighbours(origin);
    for_each_bit(row, [&](std::uint32_t other) {
      edges_[other] = difference(view_->position(other), view_->position(origin));
      squared_edges_[other] = filter_->squared_norm(edges_[other]);
    });
    vertices_[0] = origin;
    masks_[0].assign(row.begin(), row.end());
    is_prepared_ = true;
  }

  /// What may come after this vertex, the one with this number.
  void narrow(std::size_t at, std::uint32_t vertex) {
    const auto row = view_->later_neighbours(vertex);
    masks_[at].resize(view_->words());
    for (std::size_t word = 0; word < view_->words(); ++word) masks_[at][word] = masks_[at - 1][word] & row[word];
  }

  template <class S>
  [[nodiscard]] Vector<S, m> edge(std::uint32_t other) const {
    if constexpr (std::same_as<S, Filter>) {
      return edges_[other];
    } else {
      return difference(view_->template position_in<S>(other), view_->template position_in<S>(vertices_[0]));
    }
  }
  template <class S>
  [[nodiscard]] S squared(std::uint32_t other, const Vector<S, m>& vector) const {
    if constexpr (std::same_as<S, Filter>) {
      return squared_edges_[other];
    } else {
      return exact_->squared_norm(vector);
    }
  }

  /// `count` vertices are on the stack; masks_[count − 1] holds what may come next.
  template <class S>
  void walk(SphereStack<S, m>& stack, std::size_t count) {
    if constexpr (std::same_as<S, Filter> && !Visitor::visits_top) {
      if (stack.dimension() == m - 1) {
        walk_over(stack, count);
        return;
      }
    }
    for (std::size_t word = 0; word < view_->words(); ++word) {
      for (std::uint64_t rest = masks_[count - 1][word]; rest != 0; rest &= rest - 1) {
        const auto next = static_cast<std::uint32_t>(word * 64 + static_cast<std::size_t>(std::countr_zero(rest)));
        step(stack, count, next);
      }
    }
  }

  // Nearly all of the time goes here: everything inlined but the exact way out.
  [[gnu::flatten]] void walk_over(SphereStack<Filter, m>& stack, std::size_t count) {
    visitor_->facet(stack);
    for_each_bit(masks_[count - 1], [&](std::uint32_t next) { step_over(stack, count, next); });
  }

  void step_over(SphereStack<Filter, m>& stack, std::size_t count, std::uint32_t next) {
    const std::span<const std::uint32_t> vertices(vertices_.data(), count + 1);
    const auto apex = stack.apex(edges_[next], squared_edges_[next]);
    vertices_[count] = next;
    if (is_proved(apex.non_degenerate)) {
      visitor_->over(stack, apex, vertices);
    } else if (is_refuted(apex.non_degenerate)) {
      visitor_->degenerate(vertices);
    } else {
      ladder_statistics().count(Rung::rational);
      step_exactly(count, next);
    }
  }

  template <class S>
  void step(SphereStack<S, m>& stack, std::size_t count, std::uint32_t next) {
    const Vector<S, m> vector = edge<S>(next);
    vertices_[count] = next;
    const std::span<const std::uint32_t> vertices(vertices_.data(), count + 1);
    const Verdict non_degenerate = stack.push(vector, squared<S>(next, vector));
    if (is_refuted(non_degenerate)) {
      visitor_->degenerate(vertices);
      return;
    }
    if (is_undecided(non_degenerate)) {
      if constexpr (std::same_as<S, Filter>) {
        ladder_statistics().count(Rung::rational);
        step_exactly(count, next);
      }
      return;
    }
    if (visitor_->enter(stack, vertices)) {
      narrow(count, next);
      if (stack.dimension() < m) {
        walk(stack, count + 1);
      } else if constexpr (Visitor::visits_top) {
        for_each_bit(masks_[count], [&](std::uint32_t apex) {
          const Vector<S, m> apex_edge = edge<S>(apex);
          visitor_->top(stack, vertices, apex, apex_edge, squared<S>(apex, apex_edge));
        });
      }
    }
    stack.pop();
  }

  [[gnu::noinline]] void step_exactly(std::size_t count, std::uint32_t next) {
    SphereStack<Rational, m> stack(*exact_);
    for (std::size_t at = 1; at < count; ++at) {
      const auto vector = edge<Rational>(vertices_[at]);
      (void)stack.push(vector, exact_->squared_norm(vector));  // entered before, so not degenerate
    }
    visitor_->template start<Rational>(view_->template position_in<Rational>(vertices_[0]));
    step(stack, count, next);
  }

  const PatchView<m>* view_;
  const MetricOn<Filter, m>* filter_;
  const MetricOn<Rational, m>* exact_;
  Visitor* visitor_;
  std::vector<BitRow> masks_;
  std::vector<Vector<Filter, m>> edges_;
  std::vector<Filter> squared_edges_;
  ViewSimplex<m> vertices_{};
  bool is_prepared_ = false;
};

}  // namespace delcert
