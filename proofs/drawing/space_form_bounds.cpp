#include "proofs/drawing/space_form_bounds.hpp"

#include <algorithm>
#include <stdexcept>

#include "kernel/manifold/quotient/patch_size.hpp"
#include "kernel/run/chart_run.hpp"
#include "proofs/drawing/chart_bounds.hpp"
#include "proofs/drawing/manifold/space_form_json.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

/// How far charts are looked at, in halves of ε: centres of circumscribed balls and the points next to these are
/// nearer.
constexpr int half_radii = 7;

template <int m>
PointSet<m> point_set(const std::vector<std::vector<Rational>>& points) {
  std::vector<Vector<Rational, m>> result;
  for (const std::vector<Rational>& point : points) {
    if (point.size() != m) throw InputError("net, points: one has another number of coordinates than the dimension");
    std::copy(point.begin(), point.end(), result.emplace_back().begin());
  }
  return PointSet<m>(std::move(result));
}

template <int m>
std::vector<Vector<Rational, m>> exact_points(const PointSet<m>& points) {
  std::vector<Vector<Rational, m>> result;
  for (std::uint32_t label = 0; label < points.size(); ++label) result.push_back(points.exact(Label(label)));
  return result;
}

template <int m>
class ChartsOfSpaceForm {
 public:
  ChartsOfSpaceForm(const CertificateSummary& certificate, const SpaceForm& form, const Rational& epsilon)
      : certificate_(certificate),
        points_(point_set<m>(certificate.points)),
        atlas_(form, exact_points<m>(point_set<m>(certificate.net())), epsilon, fitting_patch_factor(form, m, epsilon)),
        stars_(points_.size()) {
    if (points_.size() != atlas_.size()) throw InputError("points: not as many as the net has");
    for (const FieldMatrix& element : elements_of(certificate, form.description))
      elements_.push_back(atlas_.number_of(element));
    for (std::size_t at = 0; at < certificate.simplices.size(); ++at) {
      const std::vector<std::uint32_t>& row = certificate.simplices[at];
      if (row.size() != 2 * m + 1) throw InputError("simplices: a row of another length than the format says");
      for (std::size_t corner = 0; corner <= m; ++corner) {
        if (row[corner] >= points_.size() || (corner > 0 && row[m + corner] >= elements_.size()))
          throw InputError("simplices: there is no such label or element");
        stars_[row[corner]].push_back(at);
      }
    }
  }

  /// Neither inlined nor specialised: it switches the rounding mode.
  [[nodiscard, gnu::noipa]] SimplexBounds bounds() const {
    const RoundingGuard guard;
    const auto epsilon = scalar_from<Interval>(atlas_.sampling_radius());
    SimplexBounds result = unmeasured(certificate_.simplices.size());
    SymmetricMatrix<Interval> metric(m);
    for (std::size_t row = 0; row < m; ++row) {
      for (std::size_t column = 0; column <= row; ++column)
        metric(row, column) = scalar_from<Interval>(atlas_.metric().gram()[row][column]);
    }
    ChartView<m> view(atlas_, points_, geometry_of<m>(atlas_));
    for (std::uint32_t label = 0; label < points_.size(); ++label) {
      view.look_by_halves(Label(label), half_radii);
      for (const std::size_t at : stars_[label])
        add(measures_in_chart(shown(view, Label(label), certificate_.simplices[at]), metric, epsilon), at, result);
    }
    return result;
  }

 private:
  /// The simplex about the lift of its vertex `label` that is the centre of the chart.
  [[nodiscard]] ShownSimplex shown(const ChartView<m>& view, Label label, const std::vector<std::uint32_t>& row) const {
    const auto own = static_cast<std::size_t>(std::find(row.begin(), row.begin() + m, label.value) - row.begin());
    const auto element = [&](std::size_t corner) { return corner == 0 ? 0 : elements_[row[m + corner]]; };
    const std::uint32_t back = atlas_.inverse(element(own));
    std::array<Sighting<m>, static_cast<std::size_t>(m) + 1> vertices;
    for (std::size_t corner = 0; corner <= m; ++corner)
      vertices[corner] = {row[corner], {}, atlas_.product(back, element(corner))};
    ShownSimplex result;
    result.vertices.resize(vertices.size());
    result.complete_radius = view.complete_radius(LocalCoordinates::chart);
    for (std::size_t at = 0; at < view.size(); ++at) {
      const Vector<Filter, m>& position = view.position(LocalCoordinates::chart, at);
      std::vector<Interval> place;
      for (const Filter& x : position) place.push_back(Interval::between(x.lower(), x.upper()));
      const auto vertex = std::find(vertices.begin(), vertices.end(), view.sighting(at));
      (vertex == vertices.end() ? result.others.emplace_back()
                                : result.vertices[static_cast<std::size_t>(vertex - vertices.begin())]) = place;
    }
    for (std::size_t corner = 0; corner <= m; ++corner) {
      if (result.vertices[corner].empty())
        throw InputError("simplices: label " + std::to_string(row[corner]) + " of one with label " +
                         std::to_string(label.value) + " is far from it");
    }
    return result;
  }

  const CertificateSummary& certificate_;
  PointSet<m> points_;
  SpaceFormAtlas<m> atlas_;
  std::vector<std::uint32_t> elements_;  ///< the atlas's numbers of those of the certificate
  std::vector<std::vector<std::size_t>> stars_;
};

template <int m>
SimplexBounds bounds_of(const CertificateSummary& certificate) {
  const SpaceForm form = verify_space_form(space_form_of(certificate));
  const Rational epsilon = certificate.parameter("sampling_radius");
  try {
    return ChartsOfSpaceForm<m>(certificate, form, epsilon).bounds();
  } catch (const std::out_of_range&) {
    throw InputError("simplices: the vertices of one are far from each other, or the list `elements` is too short");
  }
}

}  // namespace

SimplexBounds space_form_bounds(const CertificateSummary& certificate) {
  switch (certificate.manifold.dimension.value) {
    case 2:
      return bounds_of<2>(certificate);
    case 3:
      return bounds_of<3>(certificate);
    default:
      throw InputError("manifold: the dimension of a space form is 2 or 3");
  }
}

}  // namespace delcert
