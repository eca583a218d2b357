#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numeric>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// Triangulations whose homology is known, as plain lists of labels: written down, or built from a polygon or polyhedron
// whose sides are identified, or from a grid and its symmetries.
namespace delcert::test {

/// m + 1 labels for each m-simplex.
struct LabelComplex {
  int dimension = 0;
  std::vector<std::uint32_t> labels;

  [[nodiscard]] std::size_t corners() const { return static_cast<std::size_t>(dimension) + 1; }
  [[nodiscard]] std::size_t size() const { return labels.size() / corners(); }
};

/// The label of each class of indices, the least of them, after any number of identifications.
class Classes {
 public:
  explicit Classes(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0U); }
  std::uint32_t of(std::size_t index) const {
    while (parent_[index] != index) index = parent_[index];
    return static_cast<std::uint32_t>(index);
  }
  void identify(std::size_t one, std::size_t other) {
    const std::uint32_t first = of(one), second = of(other);
    parent_[std::max(first, second)] = std::min(first, second);
  }

 private:
  std::vector<std::uint32_t> parent_;
};

inline LabelComplex smallest_sphere(int m) {
  LabelComplex result{m, {}};
  const auto corners = static_cast<std::uint32_t>(m) + 2;
  for (std::uint32_t omitted = 0; omitted < corners; ++omitted) {
    for (std::uint32_t label = 0; label < corners; ++label) {
      if (label != omitted) result.labels.push_back(label);
    }
  }
  return result;
}

inline LabelComplex seven_vertex_torus() {
  LabelComplex result{2, {}};
  for (std::uint32_t i = 0; i < 7; ++i) {
    for (const std::uint32_t step : {0U, 1U, 3U, 0U, 2U, 3U}) result.labels.push_back((i + step) % 7);
  }
  return result;
}

/// Half of an icosahedron: a vertex 5, five around it.
inline LabelComplex six_vertex_projective_plane() {
  LabelComplex result{2, {}};
  for (std::uint32_t i = 0; i < 5; ++i) {
    for (const std::uint32_t label : {5U, i, (i + 1) % 5, i, (i + 1) % 5, (i + 3) % 5}) result.labels.push_back(label);
  }
  return result;
}

/// A polygon whose sides are named by letters: equal letters are identified, in the same direction or, one small and
/// one capital, in opposite directions. Each side is divided into three, so that no two triangles have the same labels.
inline LabelComplex glued_polygon(const std::string& word) {
  const auto sides = static_cast<std::uint32_t>(word.size()), rim = 3 * sides;
  Classes classes(2 * std::size_t{rim} + 1);  // the rim, a ring inside it, the centre
  for (std::uint32_t one = 0; one < sides; ++one) {
    for (std::uint32_t other = one + 1; other < sides; ++other) {
      if ((word[one] | 32) != (word[other] | 32)) continue;
      for (std::uint32_t step = 0; step <= 3; ++step) {
        const std::uint32_t there = word[one] == word[other] ? step : 3 - step;
        classes.identify((3 * one + step) % rim, (3 * other + there) % rim);
      }
    }
  }
  LabelComplex result{2, {}};
  for (std::uint32_t i = 0; i < rim; ++i) {
    const std::uint32_t next = (i + 1) % rim;
    for (const std::uint32_t corner : {i, next, rim + i, next, rim + i, rim + next, rim + i, rim + next, 2 * rim}) {
      result.labels.push_back(classes.of(corner));
    }
  }
  return result;
}

/// The sides of a polyhedron in pairs, each side given by its vertices in cyclic order: from[i] is identified with
/// to[i].
struct SidePairing {
  std::vector<int> from, to;
};

/// The polyhedron with its sides identified, as a simplicial complex. Its flags (vertex, edge, side, inside) are the
/// tetrahedra of the first barycentric subdivision, in the quotient of which no simplex meets itself; the faces of that
/// are the labels here, the second subdivision.
inline LabelComplex glued_polyhedron(const std::vector<SidePairing>& pairings) {
  std::map<std::pair<int, int>, int> edges;
  const auto edge = [&edges](int one, int other) {
    return edges.try_emplace(std::minmax(one, other), static_cast<int>(edges.size())).first->second;
  };
  using Cells = std::array<int, 4>;  // vertex, edge, side, inside
  std::vector<Cells> flags;
  std::vector<std::pair<std::size_t, std::size_t>> identified;  // flags in the sides
  int side = 0;
  for (const SidePairing& pairing : pairings) {
    const std::size_t length = pairing.from.size();
    for (std::size_t i = 0; i < length; ++i) {
      for (const std::size_t neighbour : {(i + 1) % length, (i + length - 1) % length}) {
        identified.emplace_back(flags.size(), flags.size() + 1);
        flags.push_back({pairing.from[i], edge(pairing.from[i], pairing.from[neighbour]), side, 0});
        flags.push_back({pairing.to[i], edge(pairing.to[i], pairing.to[neighbour]), side + 1, 0});
      }
    }
    side += 2;
  }
  std::map<Cells, std::size_t> faces;  // a cell that is left out is −1
  const auto face = [&](std::size_t flag, unsigned subset) {
    Cells cells = flags[flag];
    for (std::size_t cell = 0; cell < 4; ++cell) {
      if ((subset >> cell & 1U) == 0) cells[cell] = -1;
    }
    return faces.try_emplace(cells, faces.size()).first->second;
  };
  Classes classes(15 * flags.size());
  for (const auto& [one, other] : identified) {
    for (unsigned subset = 1; subset < 8; ++subset) classes.identify(face(one, subset), face(other, subset));
  }
  LabelComplex result{3, {}};
  for (std::size_t flag = 0; flag < flags.size(); ++flag) {
    std::array<unsigned, 4> order{0, 1, 2, 3};
    do {
      unsigned subset = 0;
      for (const unsigned cell : order) {
        subset |= 1U << cell;
        result.labels.push_back(classes.of(face(flag, subset)));
      }
    } while (std::next_permutation(order.begin(), order.end()));
  }
  return result;
}

/// The lens space: the upper sides of a bipyramid on p (or 3p) points, turned by q/p and laid upon the lower ones.
inline LabelComplex lens_space(int p, int q) {
  const int parts = p < 3 ? 3 : 1, n = p * parts, north = n, south = n + 1;
  std::vector<SidePairing> pairings;
  for (int i = 0; i < n; ++i) {
    const int turned = i + q * parts;
    pairings.push_back({{north, i, (i + 1) % n}, {south, turned % n, (turned + 1) % n}});
  }
  return glued_polyhedron(pairings);
}

/// A dodecahedron, each side identified with the opposite one, after −x turned by −72° `turns` times: by three tenths
/// of a full turn for 1 (the Seifert–Weber space), by one tenth for 2 (the Poincaré sphere), a half for 0 (ℝP³).
inline LabelComplex glued_dodecahedron(std::size_t turns) {
  // Rings of five vertices from the top: a, below each of them b, between these c, below each of them d.
  const auto a = [](int i) { return (i + 5) % 5; };
  const auto b = [](int i) { return 5 + (i + 5) % 5; };
  const auto c = [](int i) { return 10 + (i + 5) % 5; };
  const auto d = [](int i) { return 15 + (i + 5) % 5; };
  const auto opposite = [&](int vertex) {
    const int i = vertex % 5;
    const std::array<int, 4> rings{d(i + 2), c(i + 2), b(i + 3), a(i + 3)};
    return rings[static_cast<std::size_t>(vertex / 5)];
  };
  std::vector<std::vector<int>> sides{{a(0), a(1), a(2), a(3), a(4)}};  // counterclockwise from outside
  for (int i = 0; i < 5; ++i) sides.push_back({a(i), b(i), c(i), b(i + 1), a(i + 1)});
  std::vector<SidePairing> pairings;
  for (const std::vector<int>& side : sides) {
    SidePairing pairing{side, {}};
    for (std::size_t i = 0; i < 5; ++i) pairing.to.push_back(opposite(side[(i + turns) % 5]));
    pairings.push_back(pairing);
  }
  return glued_polyhedron(pairings);
}

/// A cube, each side identified with the opposite one, turned by 90° `turns` times: the torus for 0, the quaternion
/// space for 1.
inline LabelComplex glued_cube(std::size_t turns) {
  std::vector<SidePairing> pairings;
  for (int axis = 0; axis < 3; ++axis) {
    const int one = 1 << axis, next = 1 << (axis + 1) % 3, last = 1 << (axis + 2) % 3;
    const std::array<int, 4> around{0, next, next | last, last};
    SidePairing pairing;
    for (std::size_t i = 0; i < 4; ++i) {
      pairing.from.push_back(around[i]);
      pairing.to.push_back(around[(i + turns) % 4] | one);
    }
    pairings.push_back(pairing);
  }
  return glued_polyhedron(pairings);
}

/// x ↦ (sign_k x_{from_k} + shift_k)_k.
struct GridSymmetry {
  std::vector<std::size_t> from;
  std::vector<int> sign, shift;
};

/// The barycentric subdivision of the cubes of (ℝ/nℤ)^m modulo symmetries, which are given in halves of a cube. The
/// group they generate must act freely and move every vertex farther than to a common neighbour.
inline LabelComplex grid_quotient(int m, int n, const std::vector<GridSymmetry>& symmetries) {
  const auto dimension = static_cast<std::size_t>(m);
  using Point = std::vector<int>;
  const int period = 2 * n;
  const auto index = [&](const Point& x) {
    std::size_t result = 0;
    for (const int coordinate : x) {
      result =
          result * static_cast<std::size_t>(period) + static_cast<std::size_t>((coordinate % period + period) % period);
    }
    return result;
  };
  std::vector<Point> points{{}};
  for (std::size_t axis = 0; axis < dimension; ++axis) {
    std::vector<Point> longer;
    for (const Point& x : points) {
      for (int coordinate = 0; coordinate < period; ++coordinate) {
        longer.push_back(x);
        longer.back().push_back(coordinate);
      }
    }
    points = longer;
  }
  Classes classes(points.size());
  for (const GridSymmetry& symmetry : symmetries) {
    for (const Point& x : points) {
      Point image;
      for (std::size_t k = 0; k < dimension; ++k)
        image.push_back(symmetry.sign[k] * x[symmetry.from[k]] + symmetry.shift[k]);
      classes.identify(index(x), index(image));
    }
  }
  std::set<std::vector<std::uint32_t>> simplices;
  for (const Point& centre : points) {
    if (std::any_of(centre.begin(), centre.end(), [](int coordinate) { return coordinate % 2 == 0; })) continue;
    for (unsigned signs = 0; signs < 1U << dimension; ++signs) {
      std::vector<std::size_t> order(dimension);
      std::iota(order.begin(), order.end(), std::size_t{0});
      do {
        Point x = centre;
        std::vector<std::uint32_t> labels{classes.of(index(x))};
        for (const std::size_t axis : order) {
          x[axis] += (signs >> axis & 1U) != 0 ? 1 : -1;
          labels.push_back(classes.of(index(x)));
        }
        simplices.insert(labels);
      } while (std::next_permutation(order.begin(), order.end()));
    }
  }
  LabelComplex result{m, {}};
  for (const auto& simplex : simplices) result.labels.insert(result.labels.end(), simplex.begin(), simplex.end());
  return result;
}

/// The complex with two more vertices, each joined to all of it.
inline LabelComplex suspension(const LabelComplex& base) {
  LabelComplex result{base.dimension + 1, {}};
  const std::uint32_t apex = *std::max_element(base.labels.begin(), base.labels.end()) + 1;
  for (const std::uint32_t pole : {apex, apex + 1}) {
    for (std::size_t at = 0; at < base.labels.size(); ++at) {
      if (at % base.corners() == 0) result.labels.push_back(pole);
      result.labels.push_back(base.labels[at]);
    }
  }
  return result;
}

/// Both, without a common label.
inline LabelComplex disjoint_union(const LabelComplex& one, const LabelComplex& other) {
  if (one.dimension != other.dimension) throw std::invalid_argument("a union of different dimensions");
  LabelComplex result = one;
  const std::uint32_t beyond = *std::max_element(one.labels.begin(), one.labels.end()) + 1;
  for (const std::uint32_t label : other.labels) result.labels.push_back(label + beyond);
  return result;
}

inline LabelComplex without_simplex(LabelComplex complex, std::size_t at) {
  const auto first = complex.labels.begin() + static_cast<std::ptrdiff_t>(at * complex.corners());
  complex.labels.erase(first, first + static_cast<std::ptrdiff_t>(complex.corners()));
  return complex;
}

/// A complex with what is known of it.
struct KnownComplex {
  std::string name;
  LabelComplex complex;
  std::vector<std::string> homology;  // H₀ … H_m
  bool closed_manifold = true;
  bool orientable = true;
};

/// Closed manifolds and other complexes. H₁ of the flat manifolds: Wolf, "Spaces of constant curvature", 3.5.
inline std::vector<KnownComplex> known_complexes() {
  const std::vector<std::size_t> straight{0, 1, 2};
  std::vector<KnownComplex> result{
      {"S1", smallest_sphere(1), {"Z", "Z"}},
      {"S2", smallest_sphere(2), {"Z", "0", "Z"}},
      {"S3", smallest_sphere(3), {"Z", "0", "0", "Z"}},
      {"S4", smallest_sphere(4), {"Z", "0", "0", "0", "Z"}},
      {"T2 with 7 vertices", seven_vertex_torus(), {"Z", "Z^2", "Z"}},
      {"T2", glued_polygon("abAB"), {"Z", "Z^2", "Z"}},
      {"RP2 with 6 vertices", six_vertex_projective_plane(), {"Z", "Z/2", "0"}, true, false},
      {"RP2", glued_polygon("aa"), {"Z", "Z/2", "0"}, true, false},
      {"Klein bottle", glued_polygon("abAb"), {"Z", "Z + Z/2", "0"}, true, false},
      {"Klein bottle as a quotient",
       grid_quotient(2, 8, {{{0, 1}, {1, -1}, {8, 0}}}),
       {"Z", "Z + Z/2", "0"},
       true,
       false},
      {"genus 2", glued_polygon("abABcdCD"), {"Z", "Z^4", "Z"}},
      {"genus 4", glued_polygon("abcdefghABCDEFGH"), {"Z", "Z^8", "Z"}},
      {"three crosscaps", glued_polygon("aabbcc"), {"Z", "Z^2 + Z/2", "0"}, true, false},
      {"dunce hat", glued_polygon("aaA"), {"Z", "0", "0"}, false},
      {"a circle wound 3 times", glued_polygon("aaa"), {"Z", "Z/3", "0"}, false},
      {"a circle wound 12 times", glued_polygon("aaaaaaaaaaaa"), {"Z", "Z/12", "0"}, false},
      {"two circles wound together", glued_polygon("aabbaabb"), {"Z", "Z + Z/4", "0"}, false},
      {"two circles wound 3 times", glued_polygon("aaabbb"), {"Z", "Z + Z/3", "0"}, false},
      {"disc", without_simplex(smallest_sphere(2), 1), {"Z", "0", "0"}, false},
      {"S2 and T2", disjoint_union(smallest_sphere(2), seven_vertex_torus()), {"Z^2", "Z^2", "Z^2"}},
      {"RP2 twice",
       disjoint_union(six_vertex_projective_plane(), glued_polygon("aa")),
       {"Z^2", "(Z/2)^2", "0"},
       true,
       false},
      {"circles wound 4 and 6 times",
       disjoint_union(glued_polygon("aaaa"), glued_polygon("aaaaaa")),
       {"Z^2", "Z/2 + Z/12", "0"},
       false},
      {"suspension of RP2", suspension(six_vertex_projective_plane()), {"Z", "0", "Z/2", "0"}, false, false},
      {"T3", grid_quotient(3, 2, {}), {"Z", "Z^3", "Z^3", "Z"}},
      {"T3 from a cube", glued_cube(0), {"Z", "Z^3", "Z^3", "Z"}},
      {"quaternion space", glued_cube(1), {"Z", "(Z/2)^2", "0", "Z"}},
      {"half-turn manifold", grid_quotient(3, 4, {{straight, {-1, -1, 1}, {0, 0, 4}}}), {"Z", "Z + (Z/2)^2", "Z", "Z"}},
      {"quarter-turn manifold", grid_quotient(3, 8, {{{1, 0, 2}, {-1, 1, 1}, {0, 0, 4}}}), {"Z", "Z + Z/2", "Z", "Z"}},
      {"Hantzsche-Wendt manifold",
       grid_quotient(3, 4, {{straight, {1, -1, -1}, {4, 4, 0}}, {straight, {-1, 1, -1}, {0, 4, 4}}}),
       {"Z", "(Z/4)^2", "0", "Z"}},
      {"Klein bottle times a circle",
       grid_quotient(3, 4, {{straight, {1, 1, -1}, {4, 0, 0}}}),
       {"Z", "Z^2 + Z/2", "Z + Z/2", "0"},
       true,
       false},
      {"glide along a diagonal mirror",
       grid_quotient(3, 4, {{{0, 2, 1}, {1, 1, 1}, {4, 0, 0}}}),
       {"Z", "Z^2", "Z + Z/2", "0"},
       true,
       false},
      {"RP3 from a dodecahedron", glued_dodecahedron(0), {"Z", "Z/2", "0", "Z"}},
      {"Seifert-Weber space", glued_dodecahedron(1), {"Z", "(Z/5)^3", "0", "Z"}},
      {"Poincare sphere", glued_dodecahedron(2), {"Z", "0", "0", "Z"}},
      {"T4", grid_quotient(4, 2, {}), {"Z", "Z^4", "Z^6", "Z^4", "Z"}},
      {"suspension of L(3,1)", suspension(lens_space(3, 1)), {"Z", "0", "Z/3", "0", "Z"}, false},
  };
  for (int p = 1; p <= 7; ++p) {
    for (int q = 1; q <= std::max(p / 2, 1); ++q) {
      if (std::gcd(p, q) != 1) continue;
      const std::string group = p == 1 ? "0" : "Z/" + std::to_string(p);
      const std::string name = "L(" + std::to_string(p) + "," + std::to_string(q) + ")";
      result.push_back({name, lens_space(p, q), {"Z", group, "0", "Z"}});
    }
  }
  return result;
}

}  // namespace delcert::test
