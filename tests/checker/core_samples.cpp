#include "tests/checker/core_samples.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <random>
#include <set>

#include "proofs/checker/arithmetic/exact_number.hpp"

namespace delcert::checker_tests::by_hand {
namespace {

using namespace checker;
using core::Complex;
using core::Data;
using Real = std::array<double, 4>;

Rational exactly(double x) {
  Rational result;
  fmpz_t mantissa;
  fmpz_init(mantissa);
  fmpz_set_d(mantissa, std::ldexp(x, 40));
  fmpz_set(fmpq_numref(result.raw()), mantissa);
  fmpz_clear(mantissa);
  for (int k = 0; k < 40; ++k) result = result / Rational(2);
  return result;
}

Data space(int K, std::size_t m) {
  Data data;
  data.K = K;
  data.m = m;
  data.form = FieldMatrix::identity(K == 0 ? m : m + 1);
  if (K != 0) data.form(0, 0) = FieldElement(K);
  data.in_standard_basis = [](const FieldMatrix& a) {
    SquareMatrix<Ball> result(a.order());
    for (std::size_t i = 0; i < a.order(); ++i) {
      for (std::size_t k = 0; k < a.order(); ++k) result(i, k) = a(i, k).enclosure();
    }
    return result;
  };
  return data;
}

FieldMatrix translation(std::size_t m, std::size_t axis, int length) {
  FieldMatrix g = FieldMatrix::identity(m + 1);
  g(axis + 1, 0) = FieldElement(length);
  return g;
}

/// The number of a lattice translation in the table.
std::uint32_t number_of(Data& data, const Lift& lift) {
  if (lift == Lift{}) return 0;
  const auto place = std::find(data.translations.begin(), data.translations.end(), lift);
  const auto at = static_cast<std::uint32_t>(place - data.translations.begin());
  if (place == data.translations.end()) data.translations.push_back(lift);
  return at + 1;
}

/// `counts` boxes along the axes, 1 / sides long; the lattice has the periods counts / sides.
CoreSample grid(const std::vector<int>& counts, int sides) {
  const std::size_t m = counts.size();
  CoreSample sample;
  sample.data = space(0, m);
  for (std::size_t i = 0; i < m; ++i) {
    sample.data.generators.push_back(translation(m, i, 1));
    for (std::size_t k = 0; k < m; ++k) sample.data.form(i, k) = FieldElement(i == k ? static_cast<int>(m) : -1);
  }
  const int number = std::accumulate(counts.begin(), counts.end(), 1, std::multiplies<>());
  for (int cell = 0; cell < number; ++cell) {
    std::vector<int> corner(m), order(m);
    int rest = cell;
    auto& x = sample.coordinates.emplace_back();
    for (std::size_t k = 0; k < m; ++k, rest /= counts[k - 1]) {
      corner[k] = rest % counts[k];
      order[k] = static_cast<int>(k);
      x[k] = Rational(corner[k]) / Rational(sides);
    }
    do {
      std::vector<std::pair<Label, Lift>> vertices;
      std::vector<int> at = corner;
      for (std::size_t step = 0; step <= m; ++step) {
        Label label = 0;
        Lift lift{};
        for (std::size_t k = m; k-- > 0;) {
          label = label * static_cast<Label>(counts[k]) + static_cast<Label>(at[k] % counts[k]);
          lift[k] = at[k] / counts[k] * counts[k] / sides;
        }
        vertices.emplace_back(label, lift);
        if (step < m) ++at[static_cast<std::size_t>(order[step])];
      }
      std::sort(vertices.begin(), vertices.end());
      std::vector<Label> labels;
      std::vector<std::uint32_t> elements;
      for (const auto& [label, lift] : vertices) {
        Lift relative{};
        for (std::size_t k = 0; k < m; ++k) relative[k] = lift[k] - vertices[0].second[k];
        labels.push_back(label);
        elements.push_back(number_of(sample.data, relative));
      }
      sample.add(labels, elements);
    } while (std::next_permutation(order.begin(), order.end()));
  }
  sample.place_points();
  sample.find_loops();
  return sample;
}

double squared_chord(int K, const Real& x, const Real& y) {
  double sum = K * (x[0] - y[0]) * (x[0] - y[0]);
  for (std::size_t k = 1; k < 4; ++k) sum += (x[k] - y[k]) * (x[k] - y[k]);
  return sum;
}

struct RealLift {
  Label label;
  std::uint32_t element;
  Real x;
};

/// All simplices of lifts of increasing labels, the first one with the identity, any two of which are near.
void add_cliques(CoreSample& sample, const std::vector<RealLift>& lifts, double near) {
  std::vector<const RealLift*> chosen;
  const std::function<void()> extend = [&] {
    if (chosen.size() == sample.m() + 1) {
      std::vector<Label> labels;
      std::vector<std::uint32_t> elements;
      for (const RealLift* lift : chosen) {
        labels.push_back(lift->label);
        elements.push_back(lift->element);
      }
      return sample.add(labels, elements);
    }
    for (const RealLift& lift : lifts) {
      if (chosen.empty() ? lift.element != 0 : lift.label <= chosen.back()->label) continue;
      if (std::any_of(chosen.begin(), chosen.end(),
                      [&](const RealLift* other) { return squared_chord(1, lift.x, other->x) > near; }))
        continue;
      chosen.push_back(&lift);
      extend();
      chosen.pop_back();
    }
  };
  extend();
}

using RealMatrix = std::array<Real, 4>;

Real operator*(const RealMatrix& g, const Real& x) {
  Real y{};
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t k = 0; k < 4; ++k) y[i] += g[i][k] * x[k];
  }
  return y;
}

RealMatrix approximate(const FieldMatrix& g) {
  RealMatrix result{};
  for (std::size_t i = 0; i < g.order(); ++i) {
    for (std::size_t k = 0; k < g.order(); ++k)
      result[i][k] = arf_get_d(arb_midref(g(i, k).enclosure().raw()), ARF_RND_NEAR);
  }
  return result;
}

struct RealElement {
  std::uint32_t number;
  RealMatrix matrix;
};

/// The elements that move o by at most the chord, as words; those between are at most `reach` away.
std::vector<RealElement> elements_within(Data& data, double reach, double chord) {
  std::vector<RealMatrix> letters;
  std::vector<std::int32_t> names;
  for (std::size_t k = 0; k < data.generators.size(); ++k) {
    letters.push_back(approximate(data.generators[k]));
    names.push_back(static_cast<std::int32_t>(k) + 1);
    letters.push_back(approximate(inverse_of(data.generators[k])));
    names.push_back(-static_cast<std::int32_t>(k) - 1);
  }
  std::vector<RealElement> all{{0, approximate(FieldMatrix::identity(data.m + 1))}};
  const Real o{1, 0, 0, 0};
  for (std::size_t at = 0; at < all.size(); ++at) {
    for (std::size_t k = 0; k < letters.size(); ++k) {
      RealMatrix g{};
      for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t j = 0; j < 4; ++j) {
          for (std::size_t l = 0; l < 4; ++l) g[i][j] += all[at].matrix[i][l] * letters[k][l][j];
        }
      }
      if (squared_chord(data.K, g * o, o) > reach) continue;
      const auto same = [&](const RealElement& h) {
        double most = 0;
        for (std::size_t i = 0; i < 4; ++i) {
          for (std::size_t j = 0; j < 4; ++j) most = std::max(most, std::fabs(g[i][j] - h.matrix[i][j]));
        }
        return most < 1e-6;
      };
      if (std::any_of(all.begin(), all.end(), same)) continue;
      data.words.push_back({all[at].number, names[k]});
      all.push_back({static_cast<std::uint32_t>(data.words.size()), g});
    }
  }
  std::erase_if(all, [&](const RealElement& g) { return squared_chord(data.K, g.matrix * o, o) > chord; });
  return all;
}

double triple(const Real& a, const Real& b, const Real& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}
Real minus(const Real& a, const Real& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2], a[3] - b[3]}; }

/// pow(q) for triangles of curvature 0 and -1, up to a positive factor.
double power(int K, const std::array<const RealLift*, 3>& t, const Real& q) {
  const Real a = minus(t[1]->x, t[0]->x), b = minus(t[2]->x, t[0]->x), y = minus(q, t[0]->x);
  if (K < 0) return triple(y, a, b) / triple(t[0]->x, a, b);
  const auto square = [](const Real& x) { return x[1] * x[1] + x[2] * x[2]; };
  const double twice = a[1] * b[2] - a[2] * b[1];
  const double c = (square(a) * b[2] - square(b) * a[2]) / twice, d = (square(b) * a[1] - square(a) * b[1]) / twice;
  return square(y) - c * y[1] - d * y[2];
}

/// Darts until 3000 of them in a row are too near to others; then the Delaunay triangles of the lifts.
void triangulate_darts(CoreSample& sample, const std::vector<RealElement>& elements, double separation,
                       const std::function<bool(const std::function<double()>&, Real&)>& dart) {
  const int K = sample.data.K;
  std::mt19937_64 random(7);
  const std::function<double()> uniform = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  std::vector<RealLift> lifts;
  const double near = separation * separation;
  for (int failures = 0; failures < 3000;) {
    Real x{};
    if (!dart(uniform, x)) continue;
    if (std::any_of(lifts.begin(), lifts.end(), [&](const RealLift& y) { return squared_chord(K, x, y.x) < near; })) {
      ++failures;
      continue;
    }
    failures = 0;
    const auto label = static_cast<Label>(sample.coordinates.size());
    sample.coordinates.push_back({exactly(x[1]), exactly(x[2]), exactly(x[3]), Rational(0)});
    for (const RealElement& g : elements) lifts.push_back({label, g.number, g.matrix * x});
  }
  for (const RealLift& first : lifts) {
    if (first.element != 0) continue;
    std::vector<const RealLift*> around;
    for (const RealLift& lift : lifts) {
      if (squared_chord(K, first.x, lift.x) < 8 * near) around.push_back(&lift);
    }
    for (const RealLift* second : around) {
      for (const RealLift* third : around) {
        if (second->label <= first.label || third->label <= second->label) continue;
        const std::array<const RealLift*, 3> t{&first, second, third};
        const auto outside = [&](const RealLift* q) {
          return std::find(t.begin(), t.end(), q) != t.end() || power(K, t, q->x) > 0;
        };
        if (!std::all_of(around.begin(), around.end(), outside)) continue;
        sample.add({first.label, second->label, third->label}, {0, second->element, third->element});
      }
    }
  }
  sample.place_points();
  sample.find_loops();
}

}  // namespace

void CoreSample::place_points() {
  const int K = data.K;
  const auto x = std::make_shared<std::vector<std::array<Rational, 4>>>(coordinates);
  data.enclosed = [K, x, size = data.m](Label j) {
    Vector<Ball> result{};
    Ball sum(K < 0 ? 1 : 0);
    for (std::size_t k = 0; k < 4; ++k) sum = sum + square(Ball((*x)[j][k]));
    for (std::size_t k = 0; k < (K == 0 ? size : K > 0 ? size + 1 : size); ++k) {
      const Ball coordinate((*x)[j][k]);
      result[K < 0 ? k + 1 : k] = K > 0 ? coordinate / square_root(sum) : coordinate;
    }
    if (K < 0) result[0] = square_root(sum);
    return result;
  };
  if (K == 0) {
    data.exact = [x](Label j) -> Vector<Rational> { return (*x)[j]; };
  }
  data.filter.clear();
  for (Label j = 0; j < coordinates.size(); ++j) {
    const BallScope scope(128);
    const Vector<Ball> enclosed = data.enclosed(j);
    Vector<Interval>& filter = data.filter.emplace_back();
    for (std::size_t k = 0; k < 4; ++k) filter[k] = enclosed[k].enclosure();
  }
}

void CoreSample::find_loops() {
  data.loops.clear();
  Report report;
  Complex complex(data);
  core::check_manifold(complex, report);
  using Vertex = std::pair<Label, core::Elements::Id>;
  std::map<Vertex, Vertex> before{{{0, 0}, {0, 0}}};
  std::vector<Vertex> front{{0, 0}};
  std::vector<Vertex> wanted;
  for (const FieldMatrix& g : data.generators) wanted.emplace_back(0, complex.elements.find(g));
  const auto missing = [&](const Vertex& v) { return !before.contains(v); };
  while (std::any_of(wanted.begin(), wanted.end(), missing) && before.size() < 20000) {
    std::vector<Vertex> next;
    for (const Vertex& v : front) {
      for (std::size_t at = 0; at < complex.neighbours.size(v.first); ++at) {
        const core::Neighbour& neighbour = complex.neighbours.of(v.first)[at];
        const Vertex w{neighbour.label, complex.elements.product(v.second, neighbour.phi)};
        if (before.emplace(w, v).second) next.push_back(w);
      }
    }
    front = next;
    if (front.empty()) break;
  }
  const auto step_between = [&](Label i, Label j) {
    for (std::size_t at = 0; at < complex.star.size(i); ++at) {
      const auto& place = complex.star.of(i)[at];
      for (std::uint32_t k = 0; k <= m(); ++k) {
        if (complex.label(place.simplex, k) == j) return core::Step{place.simplex, place.vertex, k};
      }
    }
    return core::Step{};
  };
  for (const Vertex& end : wanted) {
    std::vector<core::Step>& loop = data.loops.emplace_back();
    if (missing(end)) continue;
    for (Vertex v = end; v != Vertex{0, 0}; v = before[v])
      loop.insert(loop.begin(), step_between(before[v].first, v.first));
  }
}

void CoreSample::add(const std::vector<Label>& labels, const std::vector<std::uint32_t>& elements) {
  data.labels.insert(data.labels.end(), labels.begin(), labels.end());
  data.elements.insert(data.elements.end(), elements.begin() + 1, elements.end());
}

void CoreSample::remove(std::size_t simplex) {
  const auto labels = data.labels.begin() + static_cast<std::ptrdiff_t>(simplex * (m() + 1));
  data.labels.erase(labels, labels + static_cast<std::ptrdiff_t>(m() + 1));
  const auto elements = data.elements.begin() + static_cast<std::ptrdiff_t>(simplex * m());
  data.elements.erase(elements, elements + static_cast<std::ptrdiff_t>(m()));
}

CoreSample grid_torus(std::size_t m, int sides) { return grid(std::vector<int>(m, sides), sides); }

CoreSample covering_torus(int sides) { return grid({2 * sides, sides}, sides); }

CoreSample polytope(std::size_t m, const std::vector<Real>& vertices, bool up_to_sign) {
  CoreSample sample;
  sample.data = space(1, m);
  if (up_to_sign) {
    FieldMatrix g = FieldMatrix::identity(m + 1);
    for (std::size_t k = 0; k <= m; ++k) g(k, k) = FieldElement(-1);
    sample.data.generators.push_back(g);
    sample.data.words.push_back({0, 1});
  }
  std::vector<RealLift> lifts;
  double near = 100;
  for (const Real& x : vertices) {
    if (up_to_sign && x < Real{}) continue;
    const auto label = static_cast<Label>(sample.coordinates.size());
    sample.coordinates.push_back({exactly(x[0]), exactly(x[1]), exactly(x[2]), exactly(x[3])});
    lifts.push_back({label, 0, x});
    if (up_to_sign) lifts.push_back({label, 1, {-x[0], -x[1], -x[2], -x[3]}});
  }
  for (const RealLift& a : lifts) {
    for (const RealLift& b : lifts) {
      if (&a != &b) near = std::min(near, squared_chord(1, a.x, b.x));
    }
  }
  add_cliques(sample, lifts, 1.01 * near);
  sample.place_points();
  sample.find_loops();
  return sample;
}

CoreSample icosahedron(bool up_to_sign) {
  const double golden = (1 + std::sqrt(5.0)) / 2;
  std::vector<Real> vertices;
  for (const double a : {-1.0, 1.0}) {
    for (const double b : {-golden, golden}) {
      vertices.push_back({0, a, b, 0});
      vertices.push_back({a, b, 0, 0});
      vertices.push_back({b, 0, a, 0});
    }
  }
  return polytope(2, vertices, up_to_sign);
}

CoreSample cross_polytope(std::size_t m) {
  std::vector<Real> vertices;
  for (std::size_t k = 0; k <= m; ++k) {
    for (const double sign : {1.0, -1.0}) vertices.emplace_back()[k] = sign;
  }
  return polytope(m, vertices, false);
}

CoreSample cell_600(bool up_to_sign) {
  const double golden = (1 + std::sqrt(5.0)) / 2;
  std::set<Real> vertices;
  std::array<std::size_t, 4> order{0, 1, 2, 3};
  do {
    int inversions = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = 0; j < i; ++j) inversions += order[j] > order[i] ? 1 : 0;
    }
    for (int signs = 0; signs < 16; ++signs) {
      const auto sign = [&](int k) { return (signs >> k & 1) != 0 ? 0.5 : -0.5; };
      Real a{}, b{};
      a[order[0]] = 2 * sign(0);
      b[order[0]] = golden * sign(0);
      b[order[1]] = sign(1);
      b[order[2]] = sign(2) / golden;
      vertices.insert(a);
      vertices.insert({sign(0), sign(1), sign(2), sign(3)});
      if (inversions % 2 == 0) vertices.insert(b);
    }
  } while (std::next_permutation(order.begin(), order.end()));
  return polytope(3, {vertices.begin(), vertices.end()}, up_to_sign);
}

CoreSample klein_bottle() {
  CoreSample sample;
  sample.data = space(0, 2);
  FieldMatrix glide = FieldMatrix::identity(3);
  glide(1, 0) = FieldElement(1) / FieldElement(2);
  glide(2, 2) = FieldElement(-1);
  sample.data.generators = {glide, translation(2, 0, 1), translation(2, 1, 1)};
  std::vector<RealElement> elements;
  {
    const BallScope scope(128);
    elements = elements_within(sample.data, 20, 8);
  }
  triangulate_darts(sample, elements, 0.12, [](const auto& uniform, Real& x) {
    x = {1, std::ldexp(std::floor(std::ldexp(uniform(), 20)), -20),
         std::ldexp(std::floor(std::ldexp(uniform(), 20)), -20), 0};
    return true;
  });
  return sample;
}

CoreSample bolza_surface() {
  CoreSample sample;
  // t^2 = 2 + 2 sqrt 2; the sides of the octagon are exchanged by translations of the length l, cosh l = 1 + 2 t^2,
  // sinh l = t^3, along the axes at angles of 45 degrees.
  sample.field = std::make_shared<NumberField>(
      std::vector<Rational>{Rational(-4), Rational(0), Rational(-4), Rational(0), Rational(1)}, Rational(2),
      Rational(3));
  sample.data = space(-1, 2);
  const auto element = [&](std::vector<Rational> c) { return FieldElement(*sample.field, c); };
  const FieldElement cosh = element({Rational(1), Rational(0), Rational(2)});
  const FieldElement sinh = element({Rational(0), Rational(0), Rational(0), Rational(1)});
  const FieldElement half =
      element({Rational(-1) / Rational(2), Rational(0), Rational(1) / Rational(4)});  // sqrt 2 / 2
  const FieldElement zero(0), one(1);
  const std::vector<std::array<FieldElement, 2>> axes{{one, zero}, {half, half}, {zero, one}, {zero - half, half}};
  for (const std::array<FieldElement, 2>& u : axes) {
    FieldMatrix g = FieldMatrix::identity(3);
    g(0, 0) = cosh;
    for (std::size_t i = 0; i < 2; ++i) {
      g(0, i + 1) = g(i + 1, 0) = sinh * u[i];
      for (std::size_t k = 0; k < 2; ++k) g(i + 1, k + 1) = g(i + 1, k + 1) + (cosh - one) * u[i] * u[k];
    }
    sample.data.generators.push_back(g);
  }
  std::vector<RealElement> elements;
  {
    const BallScope scope(128);
    elements = elements_within(sample.data, 600, 600);
  }
  triangulate_darts(sample, elements, 0.5, [&](const auto& uniform, Real& x) {
    const auto coordinate = [&] { return std::ldexp(std::floor(std::ldexp(12 * uniform() - 6, 20)), -20); };
    x = {0, coordinate(), coordinate(), 0};
    x[0] = std::sqrt(1 + x[1] * x[1] + x[2] * x[2]);
    // In the octagon.
    const Real o{1, 0, 0, 0};
    return std::all_of(elements.begin(), elements.end(), [&](const RealElement& g) {
      return squared_chord(-1, x, g.matrix * o) >= squared_chord(-1, x, o);
    });
  });
  return sample;
}

double least_protection(const CoreSample& sample) {
  Complex complex(sample.data);
  const auto plane = [](const Vector<Interval>& x) { return std::array<double, 2>{x[0].upper(), x[1].upper()}; };
  // All lifts: those of the base and, glided along, of half a period further.
  std::vector<std::array<double, 2>> lifts;
  for (Label j = 0; j < complex.size(); ++j) {
    const auto [x, y] = plane(sample.data.filter[j]);
    for (int a = -4; a <= 4; ++a) {
      for (int b = -4; b <= 4; ++b) {
        lifts.push_back({x + a, y + b});
        lifts.push_back({x + a + 0.5, b - y});
      }
    }
  }
  double least = 100;
  for (std::size_t s = 0; s < sample.data.simplices(); ++s) {
    std::array<std::array<double, 2>, 3> v;
    for (std::size_t k = 0; k < 3; ++k) v[k] = plane(complex.lift<Interval>(s, k));
    const double a = v[1][0] - v[0][0], b = v[1][1] - v[0][1], c = v[2][0] - v[0][0], d = v[2][1] - v[0][1];
    const double twice = 2 * (a * d - b * c), p = a * a + b * b, q = c * c + d * d;
    const double x = (p * d - q * b) / twice, y = (q * a - p * c) / twice, radius = std::hypot(x, y);
    for (const auto& lift : lifts) {
      const double beyond = std::hypot(lift[0] - v[0][0] - x, lift[1] - v[0][1] - y) - radius;
      const bool vertex = std::any_of(v.begin(), v.end(),
                                      [&](const auto& w) { return std::hypot(lift[0] - w[0], lift[1] - w[1]) < 1e-6; });
      if (!vertex) least = std::min(least, beyond);
    }
  }
  return least;
}

std::vector<std::string> broken_rules(const CoreSample& sample) { return broken_rules(sample, "", ""); }

std::vector<std::string> broken_rules(const CoreSample& sample, const std::string& circumradius,
                                      const std::string& protection) {
  Report report;
  std::set<std::string> rules;
  try {
    if (core::are_isometries(sample.data, report)) {
      Complex complex(sample.data);
      core::check_manifold(complex, report);
      core::check_quotient(complex, report);
      core::check_hinges(complex, nullptr, report);
      if (!circumradius.empty()) {
        core::check_margins(complex, Quantity(exact_value(circumradius)), Quantity(exact_value(protection)), report);
      }
    }
  } catch (const Undecided&) {
    rules.insert("undecided");
  }
  for (const Finding& finding : report.findings) rules.insert(finding.rule);
  return {rules.begin(), rules.end()};
}

}  // namespace delcert::checker_tests::by_hand
