#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "kernel/chart/model_space.hpp"
#include "kernel/manifold/quotient/invariant_form.hpp"

namespace delcert {

/// Elements of a discrete group that acts freely on a model space, numbered: exactly, and enclosed in the standard
/// basis. As the group acts freely, γ is known by γo, and two of these are at least the least displacement apart; so
/// products are found by enclosures of their centres, and what is found is proved.
template <int m>
class ElementTable {
 public:
  /// The identity comes first whatever the order, the others follow in the order of representations, each once.
  /// `least_displacement`: a lower bound, > 0, of d(x, γx) for all x and all γ ≠ 1.
  ElementTable(const InvariantForm& form, std::vector<FieldMatrix> elements, const Rational& least_displacement);

  [[nodiscard]] std::size_t size() const { return elements_.size(); }
  [[nodiscard]] const std::vector<FieldMatrix>& elements() const { return elements_; }
  /// In the standard basis (for curvature 0: the frame of the Gram matrix).
  [[nodiscard]] const ModelMatrix<Interval, m>& matrix(std::uint32_t number) const { return matrices_[number]; }
  /// The same at the working precision.
  [[nodiscard]] ModelMatrix<BigInterval, m> big_matrix(std::uint32_t number) const;
  /// γo.
  [[nodiscard]] ModelPoint<Interval, m> centre(std::uint32_t number) const;

  /// The number of this element; throws std::out_of_range if it is not in the table.
  [[nodiscard]] std::uint32_t number_of(const FieldMatrix& element) const;
  /// The number of γ_a γ_b, and of γ_a⁻¹; throw std::out_of_range if it is not in the table. They need no guard, and
  /// one that is alive does no harm.
  [[nodiscard]] std::uint32_t product(std::uint32_t a, std::uint32_t b) const;
  [[nodiscard]] std::uint32_t inverse(std::uint32_t a) const;

 private:
  /// The element with this centre, if there is one. Precondition: it is the centre of an element of the group.
  [[nodiscard]] std::optional<std::uint32_t> with_centre(const ModelPoint<Interval, m>& centre) const;

  InvariantForm form_;
  MetricOn<Interval, m> metric_;
  Interval least_squared_chord_;
  std::vector<FieldMatrix> elements_;
  std::vector<ModelMatrix<Interval, m>> matrices_;
  std::vector<ModelMatrix<BigInterval, m>> precise_;
  std::vector<std::optional<std::uint32_t>> inverses_;
  /// Numbers by a coordinate of the centre, and that coordinate.
  std::vector<std::pair<double, std::uint32_t>> by_coordinate_;
};

/// The metric of charts: Cartesian, for curvature 0 the (rational) Gram matrix of the form.
template <int m>
[[nodiscard]] FrameMetric<m> chart_metric(const InvariantForm& form);

}  // namespace delcert
