#include "kernel/manifold/quotient/dirichlet_polyhedron.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>

#include "kernel/number/rounding_guard.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

using Covectors = std::vector<FieldVector>;

/// Vertices are found exactly; enclosures in doubles pass over most choices of sides that meet outside.
class Enclosures {
 public:
  explicit Enclosures(const Covectors& covectors) {
    for (const FieldVector& covector : covectors) {
      Row row;
      for (const FieldElement& entry : covector) row.push_back(in_doubles(entry.enclosure()));
      rows_.push_back(scaled(std::move(row)));
    }
  }

  /// Whether both rays on which these sides meet are certainly beyond some side.
  [[nodiscard]] bool certainly_outside(const std::vector<std::size_t>& choice) const {
    const RoundingGuard guard;
    const std::vector<Interval> ray = kernel(choice);
    bool forward = true;
    bool backward = true;
    for (const auto& row : rows_) {
      Interval value = row[0] * ray[0];
      for (std::size_t k = 1; k < row.size(); ++k) value += row[k] * ray[k];
      forward = forward && !is_proved(less(Interval(0), value));
      backward = backward && !is_proved(less(value, Interval(0)));
      if (!forward && !backward) return true;
    }
    return false;
  }

 private:
  using Row = std::vector<Interval>;

  /// With entries of at most about 1: a covector and its multiples have the same side.
  static Row scaled(Row row) {
    const RoundingGuard guard;
    Interval largest(0);
    for (const Interval& entry : row) largest = maximum(largest, absolute(entry));
    for (Interval& entry : row) entry = entry / largest;
    return row;
  }

  static Interval determinant_2(const Row& a, const Row& b, std::size_t i, std::size_t j) {
    return a[i] * b[j] - a[j] * b[i];
  }

  [[nodiscard]] Row kernel(const std::vector<std::size_t>& choice) const {
    const Row& a = rows_[choice[0]];
    const Row& b = rows_[choice[1]];
    if (choice.size() == 2) return {determinant_2(a, b, 1, 2), -determinant_2(a, b, 0, 2), determinant_2(a, b, 0, 1)};
    const Row& c = rows_[choice[2]];
    const auto minor = [&](std::size_t i, std::size_t j, std::size_t k) {
      return a[i] * determinant_2(b, c, j, k) - a[j] * determinant_2(b, c, i, k) + a[k] * determinant_2(b, c, i, j);
    };
    return {minor(1, 2, 3), -minor(0, 2, 3), minor(0, 1, 3), -minor(0, 1, 2)};
  }

  std::vector<Row> rows_;
};

template <class Visit>
void for_each_choice(std::size_t count, std::size_t size, const Visit& visit) {
  std::vector<std::size_t> choice(size);
  for (std::size_t k = 0; k < size; ++k) choice[k] = k;
  while (count >= size) {
    visit(choice);
    std::size_t k = size;
    while (k > 0 && choice[k - 1] == count - size + k - 1) --k;
    if (k == 0) return;
    ++choice[k - 1];
    for (; k < size; ++k) choice[k] = choice[k - 1] + 1;
  }
}

bool is_zero(const FieldVector& x) {
  return std::all_of(x.begin(), x.end(), [](const FieldElement& entry) { return entry.is_zero(); });
}

FieldVector negated(FieldVector x) {
  for (FieldElement& entry : x) entry = -entry;
  return x;
}

FieldVector with_first_coordinate_1(const FieldVector& ray) {
  const FieldElement scale = FieldElement(1) / ray[0];
  FieldVector result;
  for (const FieldElement& entry : ray) result.push_back(entry * scale);
  return result;
}

bool is_inside(const Covectors& covectors, const FieldVector& ray) {
  return std::all_of(covectors.begin(), covectors.end(),
                     [&](const FieldVector& covector) { return pairing(covector, ray).sign() <= 0; });
}

/// All vertices, each once.
std::vector<FieldVector> vertices_of(const InvariantForm& form, const Covectors& covectors) {
  const Enclosures enclosures(covectors);
  std::set<FieldVector, Precedes> found;
  for_each_choice(covectors.size(), static_cast<std::size_t>(form.dimension()), [&](const auto& choice) {
    if (enclosures.certainly_outside(choice)) return;
    std::vector<FieldVector> rows;
    for (const std::size_t at : choice) rows.push_back(covectors[at]);
    const FieldVector line = common_kernel(rows);
    if (is_zero(line)) return;
    for (const FieldVector& ray : {line, negated(line)}) {
      if (!is_inside(covectors, ray)) continue;
      if (ray[0].sign() <= 0 ||
          (form.curvature() == Curvature::negative && pairing(ray, form.matrix() * ray).sign() >= 0))
        throw Rejection("the polyhedron of the generators is not bounded: sides do not meet inside the space");
      found.insert(with_first_coordinate_1(ray));
    }
  });
  if (found.empty()) throw Rejection("the polyhedron of the generators is not bounded: it has no vertex");
  return {found.begin(), found.end()};
}

/// For each element the number of its inverse.
std::vector<std::size_t> inverses_of(const InvariantForm& form, const std::vector<FieldMatrix>& elements,
                                     const std::vector<std::string>& names) {
  std::map<FieldMatrix, std::size_t, Precedes> number;
  for (std::size_t at = 0; at < elements.size(); ++at) {
    if (!number.emplace(elements[at], at).second)
      throw Rejection(names[number.at(elements[at])] + " and " + names[at] + " are the same element");
  }
  std::vector<std::size_t> result;
  for (std::size_t at = 0; at < elements.size(); ++at) {
    result.push_back(number.at(form.inverse_of(elements[at])));
    if (result.back() == at) throw Rejection(names[at] + " is its own inverse: it fixes a point");
  }
  return result;
}

std::vector<std::size_t> common(const std::vector<std::size_t>& a, const std::vector<std::size_t>& b) {
  std::vector<std::size_t> result;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(result));
  return result;
}

}  // namespace

std::size_t DirichletPolyhedron::vertex_on(const FieldVector& ray) const {
  const FieldVector wanted = with_first_coordinate_1(ray);
  const auto position = std::lower_bound(vertices.begin(), vertices.end(), wanted, Precedes{});
  if (position == vertices.end() || *position != wanted) return vertices.size();
  return static_cast<std::size_t>(position - vertices.begin());
}

DirichletPolyhedron dirichlet_polyhedron(const InvariantForm& form, const std::vector<FieldMatrix>& elements,
                                         const std::vector<std::string>& names, ElementsWithoutSide without_side) {
  const std::vector<std::size_t> inverses = inverses_of(form, elements, names);
  Covectors covectors;
  for (std::size_t at = 0; at < elements.size(); ++at) {
    covectors.push_back(form.bisector(elements[at]));
    if (is_zero(covectors.back())) throw Rejection(names[at] + " fixes the origin");
  }
  DirichletPolyhedron result;
  result.vertices = vertices_of(form, covectors);
  const auto least_vertices = static_cast<std::size_t>(form.dimension());
  std::vector<std::size_t> side_of(elements.size(), elements.size());
  std::map<std::vector<std::size_t>, std::size_t> known;
  for (std::size_t at = 0; at < elements.size(); ++at) {
    std::vector<std::size_t> on_side;
    for (std::size_t vertex = 0; vertex < result.vertices.size(); ++vertex) {
      if (pairing(covectors[at], result.vertices[vertex]).is_zero()) on_side.push_back(vertex);
    }
    if (on_side.size() < least_vertices) {
      if (without_side == ElementsWithoutSide::are_left_out) continue;
      throw Rejection("the bisector of " + names[at] +
                      " is no side of the polyhedron: " + std::to_string(on_side.size()) +
                      " vertices on it, expected at least " + std::to_string(least_vertices));
    }
    const auto [position, is_new] = known.emplace(on_side, at);
    if (!is_new) throw Rejection(names[position->second] + " and " + names[at] + " have the same side");
    side_of[at] = result.sides.size();
    result.sides.push_back({elements[at], at, 0, covectors[at], std::move(on_side)});
  }
  for (auto& side : result.sides) {
    side.opposite = side_of[inverses[side.number]];
    if (side.opposite == elements.size())
      throw Rejection("the bisector of the inverse of " + names[side.number] + " is no side of the polyhedron");
  }
  for (std::size_t first = 0; first < result.sides.size(); ++first) {
    for (std::size_t second = first + 1; second < result.sides.size(); ++second) {
      auto shared = common(result.sides[first].vertices, result.sides[second].vertices);
      if (shared.size() + 1 == least_vertices) result.ridges.push_back({first, second, std::move(shared)});
    }
  }
  return result;
}

BigInterval circumradius(const InvariantForm& form, const DirichletPolyhedron& polyhedron) {
  BigInterval result(0);
  for (const FieldVector& vertex : polyhedron.vertices)
    result = maximum(result, form.distance_from(form.displacement_of_ray(vertex)));
  return result;
}

}  // namespace delcert
