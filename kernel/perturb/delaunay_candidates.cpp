#include "kernel/perturb/delaunay_candidates.hpp"

#include <algorithm>
#include <cmath>

#include "kernel/simplex/dimensions.hpp"

namespace delcert {

template <int m>
void DelaunayCandidates<m>::prepare(const Rational& sampling_radius, const CandidateTest<m>& test) {
  frame_ = &test.frame();
  const double scaled_unit = approximate_double(sampling_radius) * frame_->scale();
  others_ = test.around();
  // Spheres pass near the point at hand, so points inside of them are mostly near it, too.
  const double far = 3 * scaled_unit;
  const auto is_within = [](double distance) {
    return
        [squared = distance * distance](const PointAround<m>& other) { return pairing(other.at, other.at) < squared; };
  };
  const auto far_begin = std::partition(others_.begin(), others_.end(), is_within(far));
  std::partition(others_.begin(), far_begin, is_within(2 * scaled_unit));
  const double clearance = approximate_double(parameters_.clearance) * scaled_unit;
  const double drift = approximate_double(parameters_.perturbation) * scaled_unit;
  const double largest = 2 * approximate_double(parameters_.circumradius_bound) * scaled_unit;
  spheres_.clear();
  for (const Candidate<m>& candidate : test.candidates()) {
    const SphereForm<double, m>& form = candidate.sphere;
    if (candidate.vertex_count != m + 1 || !(form.weight > 0)) continue;
    const Vector<double, m>& first = test.places()[candidate.vertices[0]];
    // A near point that was inside of one sphere often is inside of the next one: it is asked first, and in the unit of
    // the form, without quotients. If it clearly is, it would be found below.
    if (far_begin != others_.begin()) {
      const PointAround<m>& other = others_.front();
      const double allowed = other.is_placed ? clearance : clearance + drift;
      const double inside = form.norm - 2 * form.weight * allowed;
      const auto offset = difference(scaled(2 * form.weight, difference(other.at, first)), form.normal);
      constexpr double clearly = 1 - 0x1p-16;
      if (inside > 0x1p-10 * form.norm && pairing(offset, offset) < clearly * inside * inside) continue;
    }
    Sphere sphere;
    sphere.radius = form.norm / (2 * form.weight);
    if (!(sphere.radius <= largest)) continue;  // nothing is known of it
    for (std::size_t axis = 0; axis < m; ++axis)
      sphere.centre[axis] = first[axis] + form.normal[axis] / (2 * form.weight);
    // Vertices of the simplex are on the sphere, so none of them is inside by the clearance unless that is tiny.
    const double least = sphere.radius * 0x1p-20;
    const auto squared_inside = [&](double allowed) {
      const double inside = sphere.radius - std::max(allowed, least);
      return inside > 0 ? inside * inside : 0;
    };
    const double squared_placed = squared_inside(clearance);
    const double squared_unplaced = squared_inside(clearance + drift);
    const auto is_inside = [&](const PointAround<m>& other) {
      const auto offset = difference(other.at, sphere.centre);
      return pairing(offset, offset) < (other.is_placed ? squared_placed : squared_unplaced);
    };
    // No ball goes farther than its centre and its radius do: where that is near, so are all points inside.
    const double room = far * (1 - 0x1p-20) - sphere.radius;
    const bool is_near = room > 0 && pairing(sphere.centre, sphere.centre) < room * room;
    const auto end = is_near ? far_begin : others_.end();
    const auto inside = std::find_if(others_.begin(), end, is_inside);
    if (inside == end) {
      spheres_.push_back(sphere);
    } else if (inside < far_begin) {
      std::iter_swap(others_.begin(), inside);
    }
  }
}

template <int m>
double DelaunayCandidates<m>::clearance(const Vector<Filter, m>& x) const {
  double result = std::numeric_limits<double>::infinity();
  const Vector<double, m> at = frame_->at(x);
  for (const Sphere& sphere : spheres_) {
    const auto offset = difference(at, sphere.centre);
    result = std::min(result, std::fabs(std::sqrt(pairing(offset, offset)) - sphere.radius));
  }
  return result / frame_->scale();
}

#define DELCERT_INSTANTIATE(m) template class DelaunayCandidates<m>;
DELCERT_FOR_EACH_DIMENSION(DELCERT_INSTANTIATE)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
