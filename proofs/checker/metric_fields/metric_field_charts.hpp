#pragma once

#include <array>
#include <vector>

#include "proofs/checker/charts/affine_charts.hpp"

namespace delcert::checker {

/// Points of R^m known by enclosures, with all their translates by integer vectors, in the cells of the unit cube.
class TorusCells {
 public:
  /// `widths`: about how wide the boxes are that will be asked for. Throws Undecided for points that are not known well
  /// enough, or are too far away.
  TorusCells(std::size_t m, const std::vector<Vector<Interval>>& points, const std::array<double, 4>& widths);

  /// Calls f(vertex) for all translates of points that may be in the box, and for some others. Throws Undecided if the
  /// box meets more than 10^7 cells.
  template <class F>
  void visit(const Vector<Interval>& centre, const std::array<double, 4>& half_widths, const F& f) const;

 private:
  static constexpr double slack = 0x1p-20;  // above the widths of points, in the torus
  std::size_t m_;
  std::array<std::int64_t, 4> cells_{1, 1, 1, 1};
  std::vector<std::size_t> begin_;  // of the vertices of each cell
  std::vector<Vertex> vertices_;    // each at the lift that is in the unit cube
};

/// The affine charts of a metric field, with all lifts of points.
class FieldCharts : public AffineCharts {
 public:
  explicit FieldCharts(const Certificate& c);

  /// A_i (p'_j + lift - p_i).
  template <class N>
  Vector<N> seen(Label i, const Vertex& v) const {
    return in_chart<N>(i, lifted<N>(point<N>(v.label), v));
  }
  /// A_i (p_j + lift - p_i).
  template <class N>
  Vector<N> seen_original(Label i, const Vertex& v) const {
    return in_chart<N>(i, c_.net.position<N>(v));
  }

  /// The perturbed points, the original ones, at distance <= radius of p_i in chart i, perhaps some that are a little
  /// farther; sorted.
  Vertices around(Label i, double radius) const;
  Vertices originals_around(Label i, double radius) const;

  ShownPoints<Rational> shown(Label i, const Quantity& radius) const override;
  std::string fault_of_patches(Level level) const override;

 private:
  template <class N>
  Vector<N> lifted(Vector<N> x, const Vertex& v) const {
    for (std::size_t k = 0; k < c_.m_size(); ++k) x[k] = x[k] + N(v.lift[k]);
    return x;
  }
  std::array<double, 4> cell_widths() const;
  Vertices within(const TorusCells& cells, Label i, double radius, bool perturbed) const;

  std::vector<Vector<Interval>> originals_;
  std::vector<TorusCells> cells_;  // of perturbed and of original points
};

template <class F>
void TorusCells::visit(const Vector<Interval>& centre, const std::array<double, 4>& half_widths, const F& f) const {
  std::array<std::int64_t, 4> first{}, last{};
  double number = 1;
  for (std::size_t k = 0; k < m_; ++k) {
    const Interval box = centre[k] + Interval::between(-half_widths[k] - slack, half_widths[k] + slack);
    const auto cells = static_cast<double>(cells_[k]);
    const double low = std::floor(box.lower() * cells), high = std::floor(box.upper() * cells);
    number *= high - low + 1;
    if (!(number <= 1e7 && low > -0x1p30 && high < 0x1p30)) throw Undecided("a box meets too many cells");
    first[k] = static_cast<std::int64_t>(low);
    last[k] = static_cast<std::int64_t>(high);
  }
  std::array<std::int64_t, 4> at = first;
  while (true) {
    std::size_t cell = 0;
    std::array<std::int64_t, 4> turns{};
    for (std::size_t k = 0; k < m_; ++k) {
      turns[k] = (at[k] >= 0 ? at[k] : at[k] - cells_[k] + 1) / cells_[k];
      cell = cell * static_cast<std::size_t>(cells_[k]) + static_cast<std::size_t>(at[k] - turns[k] * cells_[k]);
    }
    for (std::size_t v = begin_[cell]; v < begin_[cell + 1]; ++v) {
      Vertex vertex = vertices_[v];
      for (std::size_t k = 0; k < m_; ++k) vertex.lift[k] += static_cast<std::int32_t>(turns[k]);
      f(vertex);
    }
    std::size_t k = 0;
    while (k < m_ && ++at[k] > last[k]) {
      at[k] = first[k];
      ++k;
    }
    if (k == m_) return;
  }
}

}  // namespace delcert::checker
