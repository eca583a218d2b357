#include "proofs/checker/space_forms/dirichlet.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace delcert::checker {
namespace {

/// The vector of the minors of m rows of length m + 1: what all rows annihilate, if they are independent.
FieldVector common_kernel(const std::vector<FieldVector>& rows) {
  FieldVector result;
  const std::size_t m = rows.size();
  for (std::size_t omitted = 0; omitted <= m; ++omitted) {
    FieldMatrix minor(m);
    for (std::size_t i = 0; i < m; ++i) {
      for (std::size_t k = 0; k < m; ++k) minor(i, k) = rows[i][k < omitted ? k : k + 1];
    }
    const FieldElement value = minor.leading_minor(m);
    result.push_back(omitted % 2 == 0 ? value : FieldElement(0) - value);
  }
  return result;
}

FieldElement pairing(const FieldVector& covector, const FieldVector& x) {
  FieldElement sum;
  for (std::size_t k = 0; k < x.size(); ++k) sum = sum + covector[k] * x[k];
  return sum;
}

}  // namespace

Dirichlet::Dirichlet(const SpaceForm& form) : form_(form), J_(form.form()) {
  std::set<FieldMatrix> elements;
  for (const FieldMatrix& generator : form.generators) {
    elements.insert(generator);
    elements.insert(inverse_of(generator));
  }
  for (const FieldMatrix& element : elements) {
    Side side{element, {}, {}, 0};
    for (std::size_t k = 0; k <= form.m; ++k) side.normal.push_back(element(k, 0) - FieldElement(k == 0 ? 1 : 0));
    sides.push_back(side);
  }
  fault = find_vertices();
  if (fault.empty()) fault = find_sides();
  if (fault.empty()) fault = in_balls(128, [&] { return check_cycles(); });
}

FieldElement Dirichlet::product(const FieldVector& x, const FieldVector& y) const { return pairing(x, J_ * y); }

/// The extreme rays of the cone over P. All have to be inside of the light cone, those of the opposite cone are none.
std::string Dirichlet::find_vertices() {
  std::vector<FieldVector> covectors;
  for (const Side& side : sides) {
    if (std::all_of(side.normal.begin() + 1, side.normal.end(), [](const FieldElement& x) { return x.is_zero(); }))
      return "a generator fixes o";
    covectors.push_back(J_ * side.normal);
  }
  std::set<FieldVector> found;
  std::vector<std::size_t> chosen(form_.m);
  for (std::size_t k = 0; k < form_.m; ++k) chosen[k] = k;
  while (chosen.back() < sides.size()) {
    Budget::spend(1000 * covectors.size());
    std::vector<FieldVector> rows;
    for (const std::size_t s : chosen) rows.push_back(covectors[s]);
    FieldVector ray = common_kernel(rows);
    if (!std::all_of(ray.begin(), ray.end(), [](const FieldElement& x) { return x.is_zero(); })) {
      if (!ray[0].is_zero()) {
        const FieldElement unit = FieldElement(1) / ray[0];
        for (FieldElement& x : ray) x = x * unit;
      }
      bool in = true, opposite_in = true;
      for (const FieldVector& covector : covectors) {
        const int sign = in || opposite_in ? pairing(covector, ray).sign() : 0;
        in = in && sign <= 0;
        opposite_in = opposite_in && sign >= 0;
      }
      if (opposite_in || (in && (ray[0].is_zero() || product(ray, ray).sign() >= 0)))
        return "the polyhedron about o is not bounded";
      if (in && found.insert(ray).second) vertices.push_back(ray);
    }
    // The next choice in lexicographic order.
    std::size_t k = form_.m;
    while (k > 0 && ++chosen[k - 1] + (form_.m - k) >= sides.size() && k > 1) --k;
    for (; k < form_.m; ++k) chosen[k] = chosen[k - 1] + 1;
  }
  return vertices.empty() ? "the polyhedron about o is not bounded" : "";
}

std::string Dirichlet::find_sides() {
  for (Side& side : sides) {
    const FieldVector covector = J_ * side.normal;
    for (std::size_t v = 0; v < vertices.size(); ++v) {
      if (pairing(covector, vertices[v]).is_zero()) side.vertices.push_back(v);
    }
    if (side.vertices.size() < form_.m) return "a generator has no side of the polyhedron about o";
  }
  for (std::size_t s = 0; s < sides.size(); ++s) {
    const FieldMatrix inverse = inverse_of(sides[s].element);
    while (!(sides[sides[s].inverse].element == inverse)) ++sides[s].inverse;
    std::vector<std::size_t> images;
    for (const std::size_t v : sides[s].vertices) images.push_back(image(inverse, v));
    std::sort(images.begin(), images.end());
    if (images != sides[sides[s].inverse].vertices) return "a generator does not take a side to that of its inverse";
    for (std::size_t t = 0; t < s; ++t) {
      if (sides[s].vertices == sides[t].vertices) return "two generators have the same side";
    }
  }
  return "";
}

std::size_t Dirichlet::image(const FieldMatrix& a, std::size_t vertex) const {
  FieldVector x(vertices[vertex].size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    for (std::size_t k = 0; k < x.size(); ++k) x[i] = x[i] + a(i, k) * vertices[vertex][k];
  }
  const FieldElement unit = FieldElement(1) / x[0];  // isometries keep x_0 > 0
  for (FieldElement& entry : x) entry = entry * unit;
  return static_cast<std::size_t>(std::find(vertices.begin(), vertices.end(), x) - vertices.begin());
}

Ball Dirichlet::angle(const Side& s, const Side& t) const {
  const Ball lengths = square_root((product(s.normal, s.normal) * product(t.normal, t.normal)).enclosure());
  return Ball::apply(arb_acos, -(product(s.normal, t.normal).enclosure() / lengths));
}

/// Around every ridge the tiles that one meets by crossing sides close up after one turn: the product of the elements
/// becomes 1 for the first time when the sum of the angles, then a multiple of 2 pi, is 2 pi. With the precision of
/// balls.
std::string Dirichlet::check_cycles() {
  std::map<std::vector<std::size_t>, std::vector<std::size_t>> ridges;  // by vertices: their sides
  for (std::size_t s = 0; s < sides.size(); ++s) {
    for (std::size_t t = 0; t < s; ++t) {
      std::vector<std::size_t> common;
      std::set_intersection(sides[s].vertices.begin(), sides[s].vertices.end(), sides[t].vertices.begin(),
                            sides[t].vertices.end(), std::back_inserter(common));
      if (common.size() + 1 < form_.m) continue;
      std::vector<std::size_t>& of_ridge = ridges[common];
      of_ridge.push_back(t);
      of_ridge.push_back(s);
      if (of_ridge.size() > 2) return "three sides of the polyhedron about o meet in a ridge";
    }
  }
  Ball pi;
  arb_const_pi(pi.raw(), Ball::precision);
  const FieldMatrix identity = FieldMatrix::identity(form_.m + 1);
  for (const auto& [first, of_first] : ridges) {
    std::vector<std::size_t> ridge = first, between = of_first;
    FieldMatrix crossed = identity;
    Ball sum(0);
    std::size_t next = between[0];
    std::vector<std::size_t>& cycle = cycles.emplace_back();
    do {
      cycle.push_back(next);
      sum = sum + angle(sides[between[0]], sides[between[1]]);
      if (less(sum, Ball(3) * pi) != Verdict::proved) return "the angles in a cycle of ridges are more than 2 pi";
      const Side& side = sides[next];
      crossed = crossed * side.element;
      for (std::size_t& v : ridge) v = image(sides[side.inverse].element, v);
      std::sort(ridge.begin(), ridge.end());
      const auto place = ridges.find(ridge);
      if (place == ridges.end()) return "a generator takes a ridge to none";
      between = place->second;
      if (between[0] != side.inverse && between[1] != side.inverse) return "a generator takes a ridge to one elsewhere";
      next = between[0] == side.inverse ? between[1] : between[0];
    } while (!(crossed == identity));
    if (less(pi, sum) != Verdict::proved) return "the angles in a cycle of ridges are less than 2 pi";
  }
  return "";
}

Ball Dirichlet::farthest_vertex() const {
  Ball result(1);
  for (const FieldVector& x : vertices) result = maximum(result, square_root((form_.time / product(x, x)).enclosure()));
  return result;
}

}  // namespace delcert::checker
