#include "kernel/theorems/blend_volume.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <vector>

#include "kernel/manifold/gluing/interval_matrix.hpp"
#include "kernel/manifold/gluing/second_derivatives.hpp"
#include "kernel/number/middle.hpp"
#include "kernel/theorems/barycentric_form.hpp"

namespace delcert {

namespace {

/// Further operations on it are certain not to overflow.
bool is_bounded(const Interval& x) { return x.lower() > -0x1p100 && x.upper() < 0x1p100; }

template <int m>
class BlendVolume {
 public:
  BlendVolume(const TwoHomes<m>& simplex, FormulaEvaluation<Interval>& map) : simplex_(simplex), map_(map) {
    IntervalMatrix<n> edges_here;
    IntervalMatrix<n> edges_there;
    for (std::size_t v = 1; v <= n; ++v) {
      for (std::size_t row = 0; row < n; ++row) {
        edges_here[row][v - 1] = simplex.here[v][row] - simplex.here[0][row];
        edges_there[row][v - 1] = simplex.there[v][row] - simplex.there[0][row];
      }
    }
    const IntervalMatrix<n> weights = inverse_of(edges_there);
    back_ = product(edges_here, weights);
    for (std::size_t v = 1; v <= n; ++v) {
      const int step = (simplex.is_first[v] ? 1 : 0) - (simplex.is_first[0] ? 1 : 0);
      for (std::size_t axis = 0; axis < n; ++axis) gradient_[axis] += Interval(step) * weights[v - 1][axis];
    }
  }

  [[nodiscard]] double below(double enough) {
    const bool is_known = std::all_of(gradient_.begin(), gradient_.end(), is_bounded) &&
                          std::all_of(back_.begin(), back_.end(),
                                      [](const auto& row) { return std::all_of(row.begin(), row.end(), is_bounded); });
    if (!is_known) return 0;
    Part whole{};
    for (std::size_t v = 0; v <= n; ++v) whole.corners[v][v] = 1;
    std::vector<Part> parts{whole};
    double least = std::numeric_limits<double>::infinity();
    while (!parts.empty()) {
      const Part part = parts.back();
      parts.pop_back();
      const double here = bound_on(part);
      if (here >= enough) {
        least = std::min(least, here);
      } else if (part.halvings == most_halvings_) {
        return 0;
      } else {
        halve(part, parts);
      }
    }
    return least;
  }

 private:
  static constexpr auto n = static_cast<std::size_t>(m);
  using Place = Vector<Interval, m>;
  using Corners = std::array<Place, n + 1>;
  static constexpr std::size_t most_halvings_ = 15;
  /// A part of the simplex: the barycentric coordinates of its corners, which are exact.
  struct Part {
    std::array<std::array<double, n + 1>, n + 1> corners;
    std::size_t halvings;
  };

  [[nodiscard]] static Place combined(const std::array<double, n + 1>& t, const Corners& x) {
    Place result{};
    for (std::size_t v = 0; v <= n; ++v) result = sum(result, scaled(Interval::exactly(t[v]), x[v]));
    return result;
  }

  /// Through the middle of the longest edge.
  void halve(const Part& part, std::vector<Part>& parts) const {
    std::size_t from = 0;
    std::size_t to = 1;
    double longest = -1;
    for (std::size_t k = 0; k <= n; ++k) {
      for (std::size_t l = k + 1; l <= n; ++l) {
        const Place edge =
            difference(combined(part.corners[k], simplex_.here), combined(part.corners[l], simplex_.here));
        const double length = length_above(edge);
        if (length <= longest) continue;
        longest = length;
        from = k;
        to = l;
      }
    }
    std::array<double, n + 1> middle{};
    for (std::size_t v = 0; v <= n; ++v) middle[v] = (part.corners[from][v] + part.corners[to][v]) / 2;
    for (const std::size_t replaced : {from, to}) {
      parts.push_back(part);
      parts.back().corners[replaced] = middle;
      ++parts.back().halvings;
    }
  }

  /// What the straight map misses at a corner: 0 at vertices of the simplex.
  [[nodiscard]] std::optional<Place> miss(const std::array<double, n + 1>& t, const Place& here) {
    if (std::find(t.begin(), t.end(), 1) != t.end()) return Place{};
    Place carried;
    if (!map_.value(here.data(), carried.data())) return std::nullopt;
    return difference(carried, combined(t, simplex_.there));
  }

  /// A lower bound of det F on the part; minus infinity where there is none.
  [[nodiscard]] double bound_on(const Part& part) {
    constexpr double nothing = -std::numeric_limits<double>::infinity();
    Corners here;
    Corners missed;
    std::array<Interval, n + 1> share;
    for (std::size_t k = 0; k <= n; ++k) {
      here[k] = combined(part.corners[k], simplex_.here);
      const auto found = miss(part.corners[k], here[k]);
      if (!found) return nothing;
      missed[k] = *found;
      double first = 0;  // of few digits
      for (std::size_t v = 0; v <= n; ++v) first += simplex_.is_first[v] ? part.corners[k][v] : 0;
      share[k] = Interval::exactly(first);
    }
    Cell box;
    Cell middle;
    for (std::size_t axis = 0; axis < n; ++axis) {
      box[axis] = here[0][axis];
      for (const Place& x : here)
        box[axis] = Interval::between(std::min(box[axis].lower(), x[axis].lower()),
                                      std::max(box[axis].upper(), x[axis].upper()));
      middle[axis] = Interval::exactly(middle_of(box[axis]));
    }
    std::array<Interval, n> ignored;
    std::array<Interval, n * n> first;
    std::array<Interval, n * n * n> second;
    if (!map_.first(middle.data(), ignored.data(), first.data()) || !second_derivatives<m>(map_, box, 2, second) ||
        !std::all_of(second.begin(), second.end(), is_bounded))
      return nothing;

    // Between the corners, h is a quadratic form, from the mean of D², and not more than `rest`.
    std::array<Interval, n * n * n> mean;
    Place rest{};
    for (std::size_t row = 0; row < n; ++row) {
      for (std::size_t a = 0; a < n; ++a) {
        for (std::size_t b = 0; b < n; ++b) {
          const std::size_t at = (row * n + a) * n + b;
          mean[at] = Interval::exactly(middle_of(second[at]));
          const Interval off = (second[at] - mean[at]) * width_of(box[a]) * width_of(box[b]) / Interval(8);
          rest[row] += Interval::between(std::min(off.lower(), -off.upper()), std::max(off.upper(), -off.lower()));
        }
      }
    }
    const auto turned = [&](const Place& edge) {
      Place result{};
      for (std::size_t row = 0; row < n; ++row) {
        for (std::size_t a = 0; a < n; ++a) {
          for (std::size_t b = 0; b < n; ++b) result[row] += mean[(row * n + a) * n + b] * edge[a] * edge[b];
        }
      }
      return result;
    };
    // J M − 1 at the corners.
    std::array<IntervalMatrix<n>, n + 1> beyond;
    for (std::size_t k = 0; k <= n; ++k) {
      IntervalMatrix<n> derivative;
      for (std::size_t row = 0; row < n; ++row) {
        for (std::size_t a = 0; a < n; ++a) {
          derivative[row][a] = first[row * n + a];
          for (std::size_t b = 0; b < n; ++b)
            derivative[row][a] += second[(row * n + a) * n + b] * (here[k][b] - middle[b]);
        }
      }
      beyond[k] = product(derivative, back_);
      for (std::size_t row = 0; row < n; ++row) beyond[k][row][row] -= Interval(1);
    }
    FormMatrix<m> blend(n * n, BarycentricForm<m>(2));
    for (std::size_t k = 0; k <= n; ++k) {
      for (std::size_t l = k; l <= n; ++l) {
        Place h = sum(missed[k], missed[l]);
        if (k != l) h = difference(h, scaled(Interval(1) / Interval(2), turned(difference(here[k], here[l]))));
        h = sum(scaled(Interval(1) / Interval(2), h), rest);
        for (std::size_t row = 0; row < n; ++row) {
          for (std::size_t column = 0; column < n; ++column) {
            Interval control = (share[k] * beyond[l][row][column] + share[l] * beyond[k][row][column]) / Interval(2) +
                               h[row] * gradient_[column];
            if (row == column) control += Interval(1);
            blend[row * n + column].of_pair(k, l) = Interval(k == l ? 1 : 2) * control;
          }
        }
      }
    }
    return determinant<m>(blend).least_control();
  }

  [[nodiscard]] static Interval width_of(const Interval& x) {
    return Interval::exactly(x.upper()) - Interval::exactly(x.lower());
  }

  const TwoHomes<m>& simplex_;
  FormulaEvaluation<Interval>& map_;
  IntervalMatrix<n> back_;  // M
  Place gradient_{};        // of T
};

}  // namespace

template <int m>
double blend_volume_below(const TwoHomes<m>& simplex, FormulaEvaluation<Interval>& map, double enough) {
  return BlendVolume<m>(simplex, map).below(enough);
}

template double blend_volume_below<2>(const TwoHomes<2>&, FormulaEvaluation<Interval>&, double);
template double blend_volume_below<3>(const TwoHomes<3>&, FormulaEvaluation<Interval>&, double);

}  // namespace delcert
