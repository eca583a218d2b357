#include <algorithm>

#include "proofs/checker/faces.hpp"
#include "proofs/checker/levels.hpp"
#include "proofs/checker/simplex.hpp"

namespace delcert::checker {
namespace {

/// The convex hull of the face is at distance >= radius from the origin: it lies beyond the plane through y
/// perpendicular to y, where y is the foot of the perpendicular to the affine hull of some subface. The radius is
/// positive, so that y is not 0. Rational only: few faces are on the boundary.
bool beyond_radius(const Certificate& c, const Vertices& face) {
  for (const Vertices& subface : faces_of(face)) {
    std::vector<Vector<Rational>> corners = c.net.positions<Rational>(subface);
    Vector<Rational> foot = corners[0];
    const std::size_t k = corners.size() - 1;
    Matrix<Rational> gram{};
    for (std::size_t i = 0; i <= k; ++i) corners[i] = corners[i] - foot;
    for (std::size_t i = 0; i < k; ++i) {
      for (std::size_t j = 0; j < k; ++j) gram[i][j] = c.metric.product(corners[i + 1], corners[j + 1]);
    }
    if (invert(gram, static_cast<int>(k)) != Verdict::proved) continue;
    const Vector<Rational> corner = foot;
    for (std::size_t i = 0; i < k; ++i) {
      for (std::size_t j = 0; j < k; ++j) {
        const Rational weight = gram[i][j] * c.metric.product(corners[j + 1], corner);
        for (std::size_t a = 0; a < foot.size(); ++a) foot[a] = foot[a] - weight * corners[i + 1][a];
      }
    }
    const Rational height = c.metric.squared_length(foot);
    bool beyond = less_equal(square(c.radius.exact), height) == Verdict::proved;
    for (const Vertex& v : face) {
      beyond = beyond && less_equal(height, c.metric.product(c.net.position<Rational>(v), foot)) == Verdict::proved;
    }
    if (beyond) return true;
  }
  return false;
}

/// A facet of a net simplex: its labels in increasing order, with the sign that it has in the boundary.
struct Facet {
  std::array<Label, 4> labels{};
  int sign = 1;
};

Facet facet_opposite(const Label* labels, int size, int omitted) {
  Facet facet;
  facet.sign = omitted % 2 == 0 ? 1 : -1;
  std::size_t length = 0;
  for (int k = 0; k < size; ++k) {
    if (k == omitted) continue;
    std::size_t place = length++;
    for (; place > 0 && facet.labels[place - 1] > labels[k]; --place) {
      facet.labels[place] = facet.labels[place - 1];
      facet.sign = -facet.sign;
    }
    facet.labels[place] = labels[k];
  }
  return facet;
}

}  // namespace

void check_cycle(const Certificate& c, Report& report) {
  const int size = c.m + 1;
  std::vector<Facet> facets;
  facets.reserve(c.document.net_simplices.size());
  for (std::size_t s = 0; s < c.document.net_simplices.size(); s += static_cast<std::size_t>(size)) {
    for (int k = 0; k < size; ++k) facets.push_back(facet_opposite(&c.document.net_simplices[s], size, k));
  }
  std::sort(facets.begin(), facets.end(), [](const Facet& a, const Facet& b) { return a.labels < b.labels; });
  for (std::size_t begin = 0, end = 0; begin < facets.size(); begin = end) {
    int sum = 0;
    for (; end < facets.size() && facets[end].labels == facets[begin].labels; ++end) sum += facets[end].sign;
    if (sum == 0) continue;
    const std::vector<Label> labels(facets[begin].labels.begin(), facets[begin].labels.begin() + c.m);
    Vertices face;
    for (const Label label : labels) face.push_back({label, {}});
    if (!c.torus && beyond_radius(c, face)) continue;
    report.reject("0.cycle", [&] {
      return "the net simplices have the boundary face " + label_set(labels) + " with multiplicity " +
             std::to_string(sum);
    });
  }
}

}  // namespace delcert::checker
