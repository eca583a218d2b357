#include "proofs/drawing/torus_bounds.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "kernel/number/exact_text.hpp"
#include "kernel/number/rounding_guard.hpp"
#include "kernel/number/scalar.hpp"
#include "proofs/drawing/chart_bounds.hpp"
#include "proofs/drawing/manifold/manifold_json.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

using Shift = std::vector<std::int32_t>;

/// A lift of a point of the torus: the point, moved by a vector of the lattice ℤᵐ.
struct Lift {
  std::uint32_t label;
  Shift shift;
  friend auto operator<=>(const Lift&, const Lift&) = default;
};

Shift sum_of(const Shift& a, const Shift& b, std::int32_t sign) {
  Shift result(a.size());
  for (std::size_t axis = 0; axis < a.size(); ++axis) result[axis] = a[axis] + sign * b[axis];
  return result;
}

class TorusOfIntervals {
 public:
  explicit TorusOfIntervals(const CertificateSummary& certificate)
      : certificate_(certificate),
        m_(static_cast<std::size_t>(certificate.manifold.dimension.value)),
        metric_(m_),
        radius_(scalar_from<Interval>(certificate.parameter("sampling_radius"))) {
    read_metric();
    for (const std::vector<Rational>& point : certificate.points) {
      if (point.size() != m_) throw InputError("points: a point has another number of coordinates than the dimension");
      points_.emplace_back();
      for (const Rational& coordinate : point) points_.back().push_back(scalar_from<Interval>(coordinate));
    }
    for (const std::vector<std::uint32_t>& row : certificate.simplices) simplices_.push_back(lifts_of(row));
    find_neighbours();
  }

  [[nodiscard]] std::size_t simplex_count() const { return simplices_.size(); }

  void measure(std::size_t simplex, SimplexBounds& result) const {
    const std::vector<Lift>& vertices = simplices_[simplex];
    ShownSimplex shown;
    for (const Lift& vertex : vertices) {
      shown.vertices.push_back(from_origin(vertex, vertices[0]));
      for (const Lift& neighbour : neighbours_[vertex.label]) {
        const Lift other{neighbour.label, sum_of(neighbour.shift, vertex.shift, 1)};
        if (std::find(vertices.begin(), vertices.end(), other) == vertices.end())
          shown.others.push_back(from_origin(other, vertices[0]));
      }
    }
    add(measures_in_chart(shown, metric_, radius_), simplex, result);
  }

 private:
  void read_metric() {
    const nlohmann::ordered_json json = manifold_json(certificate_);
    const auto& gram = json.at("gram");
    if (gram.size() != m_) throw InputError("manifold.gram has another order than the dimension");
    for (std::size_t row = 0; row < m_; ++row) {
      if (gram.at(row).size() != m_) throw InputError("manifold.gram is not square");
      for (std::size_t column = 0; column <= row; ++column)
        metric_(row, column) = scalar_from<Interval>(parse_exact(gram.at(row).at(column).get<std::string>()));
    }
  }

  [[nodiscard]] std::vector<Lift> lifts_of(const std::vector<std::uint32_t>& row) const {
    if (row.size() != 2 * m_ + 1) throw InputError("simplices: a row of another length than the format says");
    std::vector<Lift> result;
    for (std::size_t vertex = 0; vertex <= m_; ++vertex) {
      const std::uint32_t element = vertex == 0 ? 0 : row[m_ + vertex];
      if (row[vertex] >= points_.size() || element > certificate_.elements.size())
        throw InputError("simplices: there is no such label or element");
      result.push_back({row[vertex], element == 0 ? Shift(m_) : certificate_.elements[element - 1]});
      if (result.back().shift.size() != m_) throw InputError("elements: a vector of another length than the dimension");
    }
    return result;
  }

  void find_neighbours() {
    neighbours_.resize(points_.size());
    for (const std::vector<Lift>& vertices : simplices_) {
      for (const Lift& from : vertices) {
        for (const Lift& to : vertices) {
          if (&from != &to) neighbours_[from.label].push_back({to.label, sum_of(to.shift, from.shift, -1)});
        }
      }
    }
    for (std::vector<Lift>& list : neighbours_) {
      std::sort(list.begin(), list.end());
      list.erase(std::unique(list.begin(), list.end()), list.end());
    }
  }

  [[nodiscard]] std::vector<Interval> from_origin(const Lift& lift, const Lift& origin) const {
    std::vector<Interval> result;
    for (std::size_t axis = 0; axis < m_; ++axis)
      result.push_back((points_[lift.label][axis] - points_[origin.label][axis]) +
                       Interval(lift.shift[axis] - origin.shift[axis]));
    return result;
  }

  const CertificateSummary& certificate_;
  std::size_t m_;
  SymmetricMatrix<Interval> metric_;
  Interval radius_;
  std::vector<std::vector<Interval>> points_;
  std::vector<std::vector<Lift>> simplices_;
  std::vector<std::vector<Lift>> neighbours_;  ///< of the lift of each label that is not moved
};

// Neither inlined nor specialised: the caller switches the rounding mode.
[[gnu::noipa]] SimplexBounds bounds_in_directed_rounding(const CertificateSummary& certificate) {
  const TorusOfIntervals torus(certificate);
  SimplexBounds result = unmeasured(torus.simplex_count());
  for (std::size_t simplex = 0; simplex < torus.simplex_count(); ++simplex) torus.measure(simplex, result);
  return result;
}

}  // namespace

SimplexBounds torus_bounds(const CertificateSummary& certificate) {
  const RoundingGuard guard;
  return bounds_in_directed_rounding(certificate);
}

}  // namespace delcert
