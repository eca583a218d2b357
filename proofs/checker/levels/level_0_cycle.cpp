#include <algorithm>

#include "proofs/checker/geometry/simplex.hpp"
#include "proofs/checker/levels/levels.hpp"

namespace delcert::checker {
namespace {

/// A facet of a net simplex: its labels in increasing order, and its sign in the boundary.
struct Facet {
  std::array<Label, 4> labels{};
  int sign = 1;
};

/// The sign is (-1)^omitted times that of the permutation that sorts the remaining labels (here by insertion).
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

/// The convex hull of the net points is at distance >= radius from the origin: it lies beyond the plane through y
/// perpendicular to y, where y is the foot of the perpendicular to the affine hull of some subset. (The radius is
/// positive, so that y is not 0.) In rational numbers only, since few faces are on the boundary.
bool is_beyond_radius(const Certificate& c, const Label* labels) {
  for (unsigned subset = 1; subset < 1u << c.m; ++subset) {
    Vertices face;
    for (int k = 0; k < c.m; ++k) {
      if ((subset >> k & 1) != 0) face.push_back({labels[k], {}});
    }
    const std::vector<Vector<Rational>> corners = c.net.positions<Rational>(face);
    const Simplex<Rational> simplex(c.metric, corners);
    if (simplex.complete != Verdict::proved) continue;
    const Vector<Rational> y = simplex.perpendicular(corners[0]);
    const Rational height = c.metric.squared_length(y);
    bool beyond = less_equal(square(c.radius.exact), height) == Verdict::proved;
    for (int k = 0; k < c.m; ++k) {
      const Rational along = c.metric.product(c.net.position<Rational>({labels[k], {}}), y);
      beyond = beyond && less_equal(height, along) == Verdict::proved;
    }
    if (beyond) return true;
  }
  return false;
}

}  // namespace

void check_cycle(const Certificate& c, Report& report) {
  const int size = c.m + 1;
  const auto for_facets = [&](const auto& f) {
    for (std::size_t s = 0; s < c.net_simplices.size(); s += static_cast<std::size_t>(size)) {
      for (int k = 0; k < size; ++k) f(facet_opposite(&c.net_simplices[s], size, k));
    }
  };
  // In order; first those of each least label together.
  std::vector<std::size_t> place(std::size_t{c.n} + 1, 0);
  for_facets([&](const Facet& facet) { ++place[facet.labels[0] + 1]; });
  for (Label i = 0; i < c.n; ++i) place[i + 1] += place[i];
  std::vector<Facet> facets(place.back());
  for_facets([&](const Facet& facet) { facets[place[facet.labels[0]]++] = facet; });
  for (Label i = 0; i < c.n; ++i) {
    const auto begin = facets.begin() + std::ptrdiff_t(i == 0 ? 0 : place[i - 1]);
    std::sort(begin, facets.begin() + std::ptrdiff_t(place[i]),
              [](const Facet& a, const Facet& b) { return a.labels < b.labels; });
  }
  for (auto begin = facets.begin(), end = begin; begin != facets.end(); begin = end) {
    int sum = 0;
    for (; end != facets.end() && end->labels == begin->labels; ++end) sum += end->sign;
    if (sum == 0 || (!c.torus && is_beyond_radius(c, begin->labels.data()))) continue;
    report.reject("0.cycle", [&] {
      return "the net simplices have the face " + label_set(begin->labels.data(), begin->labels.data() + c.m) +
             " in their boundary, " + std::to_string(sum) + " times";
    });
  }
}

}  // namespace delcert::checker
