#pragma once

#include <array>
#include <vector>

#include "kernel/simplex/simplex_form.hpp"
#include "kernel/stars/chart_stars.hpp"

namespace delcert {

/// Compares simplices of a chart view with margins that are known already, in doubles with a bound of their errors:
/// most simplices are clearly better than the worst, and only these count (docs/rounded-balls.md). 2 ≤ m ≤ 3.
template <int m>
class RoundedBalls {
 public:
  /// Looks at the view as it is now, in chart coordinates, with these margins to compare with, which have no units.
  void look(const ChartView<m>& view, const LocalMargins& margins);

  /// Other margins to compare with from now on.
  void compare_with(const LocalMargins& margins);

  /// Whether this is certain: the simplex is not degenerate, all of the margins hold for it, every point closer than
  /// its protection beyond the circumball is in the view, and no point of the view but its vertices is there. Where
  /// this is false, nothing is known.
  [[nodiscard]] bool are_met_by(const PlaceSimplex<m>& simplex) const;

 private:
  static constexpr std::size_t rows = 16;

  /// What the doubles compare with, in the unit of length.
  template <class S>
  struct Limits {
    S doubled_radius{};
    S doubled_reach{};
    S power{};              // of points as far beyond a ball of that radius as the protection says
    S squared_thickness{};  // m² times
  };
  /// What is above 0 if the ball and the shape of a simplex are as the limits say.
  template <class S>
  struct Room;

  /// For all places up to a size, with an error.
  struct Bounds {
    double size = -1;
    double error = -1;
    double most_squared_edge = 0;
    double least_weight = 0;
    double of_radius = 0;
    double of_reach = 0;
    double of_shape = 0;
    double of_power = 0;
  };

  void take_places(const ChartView<m>& view);
  void take_bounds(double size, double error);
  void sort_places();
  [[nodiscard]] std::size_t row_of(double coordinate) const;
  [[nodiscard]] std::size_t count_beyond(const SphereForm<double, m>& sphere, const Vector<double, m>& first,
                                         std::size_t begin, std::size_t end) const;

  bool is_usable_ = false;      // the places
  bool is_comparable_ = false;  // the margins
  double scale_ = 1;            // the unit of length is 1/scale_, a power of two
  double complete_ = 0;         // every point closer than this to the centre is in the view
  std::vector<Vector<double, m>> place_;
  double size_ = 0;
  double rows_per_unit_ = 0;
  Bounds bounds_;
  double protection_ = 0;
  Limits<double> limits_;
  // The places in rows by their first coordinates, in each row by their second ones.
  std::array<std::uint32_t, rows * rows + 1> first_in_cell_{};
  std::array<std::vector<double>, static_cast<std::size_t>(m)> sorted_;
  std::vector<std::uint16_t> cell_;
};

}  // namespace delcert
