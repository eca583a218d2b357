#include "kernel/manifold/quotient/poincare.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

#include "support/error.hpp"

namespace delcert {

namespace {

using Vertices = std::vector<std::size_t>;

/// Classes of numbers, joined two by two.
class Partition {
 public:
  explicit Partition(std::size_t size) : parent_(size) { std::iota(parent_.begin(), parent_.end(), 0U); }
  std::size_t representative(std::size_t x) const {
    while (parent_[x] != x) x = parent_[x];
    return x;
  }
  void join(std::size_t a, std::size_t b) { parent_[representative(a)] = representative(b); }

 private:
  std::vector<std::size_t> parent_;
};

std::string decimal(const BigInterval& x) {
  const double value = mpfr_get_d(&x.mpfi()->left, MPFR_RNDN);
  return std::to_string(value);
}

class Conditions {
 public:
  Conditions(const InvariantForm& form, const DirichletPolyhedron& polyhedron, const std::vector<std::string>& names)
      : form_(form), polyhedron_(polyhedron), names_(names), classes_(polyhedron.vertices.size()) {}

  PoincareResult verify() {
    map_sides();
    for (std::size_t at = 0; at < polyhedron_.ridges.size(); ++at) {
      ridge_at_.emplace(polyhedron_.ridges[at].vertices, at);
      angles_.push_back(dihedral_angle(polyhedron_.ridges[at]));
    }
    class_of_ridge_.assign(polyhedron_.ridges.size(), polyhedron_.ridges.size());
    PoincareResult result;
    for (std::size_t at = 0; at < polyhedron_.ridges.size(); ++at) {
      if (class_of_ridge_[at] == polyhedron_.ridges.size()) result.cycles.push_back(cycle_around(at, result.cycles));
    }
    if (form_.dimension() == 3) require_spherical_links();
    result.abelianisation = abelianisation(result.cycles);
    result.euler_characteristic = euler_characteristic(result.cycles.size());
    return result;
  }

 private:
  const std::string& name(std::size_t side) const { return names_[polyhedron_.sides[side].number]; }

  std::string word(const std::vector<std::size_t>& sides) const {
    std::string result;
    for (const std::size_t side : sides) result += (result.empty() ? "" : " · ") + name(side);
    return result;
  }

  /// Where the element of each side takes the vertices of the opposite side, all of which must be vertices of the side.
  void map_sides() {
    for (std::size_t at = 0; at < polyhedron_.sides.size(); ++at) {
      const auto& side = polyhedron_.sides[at];
      const auto& opposite = polyhedron_.sides[side.opposite];
      std::map<std::size_t, std::size_t> image;
      Vertices reached;
      for (const std::size_t vertex : opposite.vertices) {
        const std::size_t target = polyhedron_.vertex_on(side.element * polyhedron_.vertices[vertex]);
        if (!std::binary_search(side.vertices.begin(), side.vertices.end(), target))
          throw Rejection(name(at) + " does not map the side of its inverse onto its own side: vertex " +
                          std::to_string(vertex) + " goes to no vertex of it");
        image.emplace(vertex, target);
        reached.push_back(target);
        classes_.join(vertex, target);
      }
      if (reached.size() != side.vertices.size())
        throw Rejection(name(at) + " maps the side of its inverse, with " + std::to_string(reached.size()) +
                        " vertices, into its own side, with " + std::to_string(side.vertices.size()));
      image_.push_back(std::move(image));
    }
  }

  BigInterval dihedral_angle(const DirichletPolyhedron::Ridge& ridge) const {
    const FieldVector& a = polyhedron_.sides[ridge.first_side].covector;
    const FieldVector& b = polyhedron_.sides[ridge.second_side].covector;
    const BigInterval squares = (form_.dual_product(a, a) * form_.dual_product(b, b)).enclosure();
    return arccosine(-form_.dual_product(a, b).enclosure() / square_root(squares));
  }

  RidgeCycle cycle_around(std::size_t start, const std::vector<RidgeCycle>& earlier) {
    RidgeCycle cycle{{}, BigInterval(0)};
    FieldMatrix product = FieldMatrix::identity(form_.matrix().order());
    std::size_t ridge = start;
    std::size_t side = polyhedron_.ridges[start].first_side;
    do {
      if (class_of_ridge_[ridge] != polyhedron_.ridges.size())
        throw Rejection("an element other than 1 maps a ridge onto itself, where " + name(side) + " follows " +
                        word(cycle.sides));
      class_of_ridge_[ridge] = earlier.size();
      cycle.sides.push_back(side);
      cycle.angle_sum += angles_[ridge];
      product = product * polyhedron_.sides[side].element;
      // Seen from the tile across the side, the ridge is where the inverse takes it.
      const std::size_t entered = polyhedron_.sides[side].opposite;
      Vertices moved;
      for (const std::size_t vertex : polyhedron_.ridges[ridge].vertices) moved.push_back(image_[entered].at(vertex));
      std::sort(moved.begin(), moved.end());
      const auto next = ridge_at_.find(moved);
      if (next == ridge_at_.end()) throw Rejection(name(entered) + " maps a ridge of its side to none");
      ridge = next->second;
      const auto& reached = polyhedron_.ridges[ridge];
      side = reached.first_side == entered ? reached.second_side : reached.first_side;
    } while (ridge != start || side != polyhedron_.ridges[start].first_side);
    if (!is_identity(product))
      throw Rejection("ridge cycle " + word(cycle.sides) + ": the product is not 1; the dihedral angles sum up to " +
                      decimal(cycle.angle_sum) + ", expected 2π");
    const BigInterval pi = half_turn();
    if (!is_proved(less(pi, cycle.angle_sum)) || !is_proved(less(cycle.angle_sum, BigInterval(3) * pi)))
      throw Rejection("ridge cycle " + word(cycle.sides) + ": the dihedral angles sum up to " +
                      decimal(cycle.angle_sum) + ", expected 2π");
    return cycle;
  }

  /// The polygons that the tiles cut out of a small sphere about a vertex must close up to one sphere.
  void require_spherical_links() const {
    std::map<std::size_t, int> characteristic_twice;  // twice V − E + F, a class of vertices
    for (std::size_t v = 0; v < polyhedron_.vertices.size(); ++v) characteristic_twice[classes_.representative(v)] += 2;
    for (const auto& side : polyhedron_.sides) {
      for (const std::size_t vertex : side.vertices) --characteristic_twice[classes_.representative(vertex)];
    }
    std::set<std::size_t> counted;
    for (std::size_t at = 0; at < polyhedron_.ridges.size(); ++at) {
      if (!counted.insert(class_of_ridge_[at]).second) continue;
      for (const std::size_t vertex : polyhedron_.ridges[at].vertices)
        characteristic_twice[classes_.representative(vertex)] += 2;
    }
    for (const auto& [vertex, twice] : characteristic_twice) {
      if (twice != 4)
        throw Rejection("the link of vertex " + std::to_string(vertex) + " has twice the Euler characteristic " +
                        std::to_string(twice) + ", expected 4: an element fixes the vertex");
    }
  }

  AbelianGroup abelianisation(const std::vector<RidgeCycle>& cycles) const {
    std::vector<std::size_t> generator(polyhedron_.sides.size());
    std::size_t generators = 0;
    for (std::size_t side = 0; side < generator.size(); ++side) {
      if (side < polyhedron_.sides[side].opposite) generator[side] = generators++;
    }
    std::vector<std::vector<std::int64_t>> relations;
    for (const RidgeCycle& cycle : cycles) {
      std::vector<std::int64_t> relation(generators);
      for (const std::size_t side : cycle.sides) {
        const std::size_t opposite = polyhedron_.sides[side].opposite;
        relation[generator[std::min(side, opposite)]] += side < opposite ? 1 : -1;
      }
      relations.push_back(std::move(relation));
    }
    return abelian_group(generators, relations);
  }

  int euler_characteristic(std::size_t ridge_classes) const {
    std::set<std::size_t> vertex_classes;
    for (std::size_t v = 0; v < polyhedron_.vertices.size(); ++v) vertex_classes.insert(classes_.representative(v));
    const int vertices = static_cast<int>(vertex_classes.size());
    const int sides = static_cast<int>(polyhedron_.sides.size() / 2);
    if (form_.dimension() == 2) return vertices - sides + 1;
    return vertices - static_cast<int>(ridge_classes) + sides - 1;
  }

  const InvariantForm& form_;
  const DirichletPolyhedron& polyhedron_;
  const std::vector<std::string>& names_;
  Partition classes_;
  std::vector<std::map<std::size_t, std::size_t>> image_;
  std::map<Vertices, std::size_t> ridge_at_;
  std::vector<BigInterval> angles_;
  std::vector<std::size_t> class_of_ridge_;
};

}  // namespace

PoincareResult verify_poincare(const InvariantForm& form, const DirichletPolyhedron& polyhedron,
                               const std::vector<std::string>& names) {
  return Conditions(form, polyhedron, names).verify();
}

}  // namespace delcert
