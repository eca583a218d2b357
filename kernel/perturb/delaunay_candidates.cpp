#include "kernel/perturb/delaunay_candidates.hpp"

#include <algorithm>

#include "kernel/simplex/dimensions.hpp"

namespace delcert {

template <int m>
DelaunayCandidates<m>::DelaunayCandidates(const Atlas<m>& atlas, const PointSet<m>& points, const PlacedLabels& placed,
                                          const PerturbationParameters& parameters)
    : atlas_(atlas), points_(points), placed_(placed), parameters_(parameters), metric_([&] {
        const FilterGuard guard;
        return atlas.metric().template on<Filter>();
      }()) {}

template <int m>
void DelaunayCandidates<m>::prepare(Label i, const CandidateTest<m>& test) {
  const Rational& unit = atlas_.sampling_radius(i);
  atlas_.sightings(i, approximate_double(reach_of_delaunay_candidates(parameters_) * unit), seen_);
  struct Other {
    Vector<Filter, m> position;
    bool is_placed;
  };
  std::vector<Other> others;
  for (const Sighting<m>& seen : seen_) {
    const Label label = label_of<m>(seen);
    if (label == i) continue;
    const bool is_placed = placed_[label.value] != 0;
    others.push_back({atlas_.carry(i, seen, (is_placed ? points_ : atlas_.net()).enclosure(label)), is_placed});
  }
  const Filter clearance = scalar_from<Filter>(parameters_.clearance * unit);
  const Filter drift = scalar_from<Filter>(parameters_.perturbation * unit);
  const double largest = scalar_from<Filter>(Rational(2) * parameters_.circumradius_bound * unit).upper();
  spheres_.clear();
  for (const Candidate<m>& candidate : test.candidates()) {
    if (!candidate.in_filter || candidate.vertex_count != m + 1) continue;
    const Sphere sphere{sum(test.view().position(candidate.vertices[0]), candidate.centre),
                        square_root(candidate.squared_radius)};
    if (!(sphere.radius.upper() <= largest)) continue;  // nothing is known of it
    // Vertices of the simplex are on the sphere, so none of them is inside by the clearance unless that is tiny.
    const Filter least = sphere.radius * Filter::exactly(0x1p-20);
    const auto is_inside = [&](const Other& other) {
      const Filter allowed = other.is_placed ? clearance : clearance + drift;
      const Filter squared = metric_.squared_norm(difference(other.position, sphere.centre));
      // Most points are far outside: for these no root is taken.
      if (squared.lower() > sphere.radius.upper() * sphere.radius.upper()) return false;
      return is_proved(less(maximum(allowed, least), sphere.radius - square_root(squared)));
    };
    // A point that was inside of one sphere often is inside of the next one: it is asked first.
    const auto inside = std::find_if(others.begin(), others.end(), is_inside);
    if (inside == others.end()) {
      spheres_.push_back(sphere);
    } else {
      std::iter_swap(others.begin(), inside);
    }
  }
}

template <int m>
double DelaunayCandidates<m>::clearance(const Vector<Rational, m>& x) const {
  Vector<Filter, m> at;
  for (std::size_t axis = 0; axis < m; ++axis) at[axis] = scalar_from<Filter>(x[axis]);
  return clearance(at);
}

template <int m>
double DelaunayCandidates<m>::clearance(const Vector<Filter, m>& x) const {
  double result = std::numeric_limits<double>::infinity();
  for (const Sphere& sphere : spheres_) {
    result = std::min(result, absolute(distance(x, sphere.centre) - sphere.radius).lower());
  }
  return result;
}

#define DELCERT_INSTANTIATE(m) template class DelaunayCandidates<m>;
DELCERT_FOR_EACH_DIMENSION(DELCERT_INSTANTIATE)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
