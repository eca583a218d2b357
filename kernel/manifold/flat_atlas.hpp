#pragma once

#include <memory>
#include <optional>

#include "kernel/chart/atlas.hpp"
#include "kernel/chart/near_lists.hpp"
#include "kernel/chart/sampling_radii.hpp"

namespace delcert {

/// The flat manifolds whose charts are pieces of one frame: a torus ℝᵐ/Λ in lattice coordinates (Λ = ℤᵐ, rational
/// Gram matrix), or a closed ball about the origin of ℝᵐ that a finite net covers.
template <int m>
struct FlatSpace {
  FrameMetric<m> metric = FrameMetric<m>::cartesian();
  /// The radius of the ball; none for a torus.
  std::optional<Rational> ball_radius;

  [[nodiscard]] bool is_torus() const { return !ball_radius.has_value(); }
  /// Half the side of a box about the ball, for grids; none for a torus.
  [[nodiscard]] std::optional<double> box_radius() const {
    return is_torus() ? std::nullopt : std::optional(approximate_double(*ball_radius));
  }
};

/// U_i = B(p_i, bε_i), b = 9(1 + ε₀), N_i = the labels seen there, transition functions = translations by lattice
/// vectors. This is an atlas in the sense of the paper when every lattice vector has length at least (2b + 6)ε
/// (docs/levels/0-input.md), which `check_input` certifies; nothing here assumes it. On a ball radii do not vary.
template <int m>
class FlatAtlas final : public Atlas<m> {
 public:
  /// `radius_variation`: ε₀ of these radii.
  FlatAtlas(FlatSpace<m> space, PointSet<m> net, SamplingRadii radii, Rational radius_variation = Rational(0));

  [[nodiscard]] const FlatSpace<m>& space() const { return space_; }
  [[nodiscard]] const SamplingRadii& radii() const { return radii_; }
  /// The greatest.
  [[nodiscard]] const Rational& sampling_radius() const { return radii_.greatest(); }
  /// ε₀.
  [[nodiscard]] const Rational& radius_variation() const { return radius_variation_; }
  /// b: of how many sampling radii patches are.
  [[nodiscard]] Rational patch_factor() const { return Rational(9) * (Rational(1) + radius_variation_); }

  [[nodiscard]] std::size_t size() const override { return net_.size(); }
  [[nodiscard]] const FrameMetric<m>& metric() const override { return space_.metric; }
  [[nodiscard]] const Rational& sampling_radius(Label i) const override { return radii_.of(i.value); }
  [[nodiscard]] bool is_interior(Label i) const override { return interior_[i.value]; }
  [[nodiscard]] const PointSet<m>& net() const override { return net_; }
  [[nodiscard]] std::vector<Sighting<m>> neighbours(Label i) const override;
  void sightings(Label i, double distance, std::vector<Sighting<m>>& out) const override;
  [[nodiscard]] Vector<Filter, m> carry(Label i, const Sighting<m>& seen, const Vector<Filter, m>& home) const override;
  [[nodiscard]] Vector<BigInterval, m> carry(Label i, const Sighting<m>& seen,
                                             const Vector<BigInterval, m>& home) const override;
  [[nodiscard]] std::optional<Vector<Rational, m>> carry(Label i, const Sighting<m>& seen,
                                                         const Vector<Rational, m>& home) const override;
  [[nodiscard]] bool has_exact_transitions() const override { return true; }

 private:
  /// What is within a distance of a point, sorted: 8 bytes for each.
  struct NearShifts {
    struct Entry {
      std::uint32_t index = 0;
      std::array<std::int8_t, static_cast<std::size_t>(m)> shift{};
    };
    double distance = 0;
    std::vector<Entry> entries;
    [[nodiscard]] std::size_t size() const { return entries.size(); }
  };
  void find_near(Label i, double distance, std::vector<Sighting<m>>& out) const;
  /// For no distance where the shifts are too long to be listed.
  [[nodiscard]] static NearShifts listed(const std::vector<Sighting<m>>& seen, double distance);

  FlatSpace<m> space_;
  PointSet<m> net_;
  SamplingRadii radii_;
  Rational radius_variation_;
  PointGrid<m> grid_;
  std::unique_ptr<NearLists<NearShifts>> near_;
  double most_listed_;  // lists are kept of what is within this distance
  std::vector<bool> interior_;
};

}  // namespace delcert
