#include "tests/checker/support/submanifold_model.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <numeric>
#include <set>

namespace delcert::checker_tests {
namespace {

using Row = std::vector<double>;
using Rows = std::vector<Row>;

constexpr double pi = 3.14159265358979323846;

double dot(const Row& a, const Row& b) { return std::inner_product(a.begin(), a.end(), b.begin(), 0.0); }
Row difference(Row a, const Row& b) {
  for (std::size_t k = 0; k < a.size(); ++k) a[k] -= b[k];
  return a;
}
double distance(const Row& a, const Row& b) {
  double sum = 0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += (a[k] - b[k]) * (a[k] - b[k]);
  return std::sqrt(sum);
}
/// The coordinate of a - b along a direction.
double component(const Row& direction, const Row& a, const Row& b) {
  double sum = 0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += direction[k] * (a[k] - b[k]);
  return sum;
}

std::string text(double x) {
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, "%a", x);
  std::string result = buffer;
  result.erase(std::remove(result.begin(), result.end(), '+'), result.end());
  return x == 0 ? "0" : result;
}
double rounded(double x, int bits) { return std::ldexp(std::nearbyint(std::ldexp(x, bits)), -bits); }

/// Gauss and Jordan, with a search for pivots.
Rows inverse(Rows a) {
  const std::size_t n = a.size();
  for (std::size_t k = 0; k < n; ++k) {
    a[k].resize(2 * n);
    a[k][n + k] = 1;
  }
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k; i < n; ++i) pivot = std::fabs(a[i][k]) > std::fabs(a[pivot][k]) ? i : pivot;
    std::swap(a[k], a[pivot]);
    for (std::size_t i = 0; i < n; ++i) {
      if (i == k) continue;
      const double factor = a[i][k] / a[k][k];
      for (std::size_t j = 0; j < 2 * n; ++j) a[i][j] -= factor * a[k][j];
    }
    const double unit = 1 / a[k][k];
    for (double& x : a[k]) x *= unit;
  }
  for (Row& row : a) row.erase(row.begin(), row.begin() + static_cast<std::ptrdiff_t>(n));
  return a;
}

Rows product(const Rows& a, const Rows& b) {
  Rows result(a.size(), Row(b[0].size()));
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) {
      for (std::size_t k = 0; k < b[0].size(); ++k) result[i][k] += a[i][j] * b[j][k];
    }
  }
  return result;
}

/// Df, one function a row, by differences.
Rows gradients(const SubmanifoldModel& model, const Row& x) {
  Rows result(model.equations.size(), Row(x.size()));
  for (std::size_t k = 0; k < x.size(); ++k) {
    constexpr double step = 0x1p-17;
    Row above = x, below = x;
    above[k] += step;
    below[k] -= step;
    const Row high = model.map(above), low = model.map(below);
    for (std::size_t f = 0; f < high.size(); ++f) result[f][k] = (high[f] - low[f]) / (2 * step);
  }
  return result;
}

/// A chart: what the certificate has of it, and in doubles the frame that follows.
struct ModelChart {
  std::vector<int> axes;
  Row skew;
  Rows frame, Y;  // tangent axes, then normal ones, one a row
};

/// A signed permutation of the axes, and a skew matrix, of which the frame is nearly tangent.
ModelChart chart_at(const SubmanifoldModel& model, const Row& x) {
  const std::size_t n = x.size(), q = model.equations.size();
  Rows target = gradients(model, x);  // normal axes, then tangent ones
  for (std::size_t k = 0; k < n; ++k) {
    target.emplace_back(n);
    target.back()[k] = 1;
  }
  Rows basis;
  for (Row& row : target) {
    for (const Row& other : basis) {
      const double along = dot(row, other);
      for (std::size_t k = 0; k < n; ++k) row[k] -= along * other[k];
    }
    const double length = std::sqrt(dot(row, row));
    if (length < 0.3 && basis.size() >= q) continue;
    for (double& entry : row) entry /= length;
    basis.push_back(row);
    if (basis.size() == n) break;
  }
  std::rotate(basis.begin(), basis.begin() + static_cast<std::ptrdiff_t>(q), basis.end());
  for (std::size_t a = 0; a < n; ++a) {
    const double along = basis[0][a], up = basis[model.m][a];
    basis[0][a] = std::cos(model.tilt) * along + std::sin(model.tilt) * up;
    basis[model.m][a] = std::cos(model.tilt) * up - std::sin(model.tilt) * along;
  }
  // Each axis of the frame is matched with the axis of R^n along which it is longest, the clearest first.
  ModelChart chart;
  chart.axes.assign(n, 0);
  std::set<std::size_t> used;
  for (std::size_t step = 0; step < n; ++step) {
    double most = -1;
    std::size_t best = 0, axis = 0;
    for (std::size_t k = 0; k < n; ++k) {
      for (std::size_t a = 0; a < n && chart.axes[k] == 0; ++a) {
        if (used.contains(a) || std::fabs(basis[k][a]) <= most) continue;
        most = std::fabs(basis[k][a]);
        best = k;
        axis = a;
      }
    }
    chart.axes[best] = (basis[best][axis] < 0 ? -1 : 1) * static_cast<int>(axis + 1);
    used.insert(axis);
  }
  // The frame is B S, S the signed permutation: B = (1 - A) (1 + A)^-1, so A = (1 - B) (1 + B)^-1.
  const auto turned = [&] {
    Rows result(n, Row(n));
    for (std::size_t k = 0; k < n; ++k) {
      const auto column = static_cast<std::size_t>(std::abs(chart.axes[k]) - 1);
      for (std::size_t a = 0; a < n; ++a) result[a][column] = (chart.axes[k] < 0 ? -1 : 1) * basis[k][a];
    }
    return result;
  };
  const auto cayley = [n](const Rows& a) {
    Rows plus = a, minus = a;
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t k = 0; k < n; ++k) {
        plus[i][k] = (i == k ? 1 : 0) + a[i][k];
        minus[i][k] = (i == k ? 1 : 0) - a[i][k];
      }
    }
    return product(minus, inverse(plus));
  };
  Rows skew = cayley(turned());
  // A reflection has the eigenvalue -1: then another sign of a tangent axis.
  for (std::size_t k = 0; k < model.m && !(std::fabs(skew[0][n - 1]) < 4 && std::fabs(skew[0][1]) < 4); ++k) {
    chart.axes[k] = -chart.axes[k];
    skew = cayley(turned());
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = i + 1; k < n; ++k) {
      skew[i][k] = rounded((skew[i][k] - skew[k][i]) / 2, 12);
      skew[k][i] = -skew[i][k];
      chart.skew.push_back(skew[i][k]);
    }
    skew[i][i] = 0;
  }
  const Rows exact = cayley(skew);
  chart.frame.assign(n, Row(n));
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t a = 0; a < n; ++a) {
      chart.frame[k][a] =
          (chart.axes[k] < 0 ? -1 : 1) * exact[a][static_cast<std::size_t>(std::abs(chart.axes[k]) - 1)];
    }
  }
  Rows along(q, Row(q));
  const Rows slopes = gradients(model, x);
  for (std::size_t f = 0; f < q; ++f) {
    for (std::size_t k = 0; k < q; ++k) along[f][k] = dot(slopes[f], chart.frame[model.m + k]);
  }
  chart.Y = inverse(along);
  for (Row& row : chart.Y) {
    for (double& entry : row) entry = rounded(entry, 20);
  }
  return chart;
}

/// What level 1 measures of the stars, without error bounds.
struct StarMargins {
  double radius = 0, thickness = 1, protection = 1e9;
};

void measure_simplex(const Rows& places, const std::vector<Row>& others, StarMargins& margins) {
  const std::size_t m = places.size() - 1;
  Rows edges;
  Row squares;
  for (std::size_t k = 1; k <= m; ++k) {
    edges.push_back(difference(places[k], places[0]));
    squares.push_back(dot(edges.back(), edges.back()) / 2);
  }
  const Rows dual = inverse(edges);
  Row centre(m);
  for (std::size_t a = 0; a < m; ++a) {
    for (std::size_t k = 0; k < m; ++k) centre[a] += dual[a][k] * squares[k];
  }
  for (std::size_t a = 0; a < m; ++a) centre[a] += places[0][a];
  const double radius = distance(centre, places[0]);
  margins.radius = std::max(margins.radius, radius);
  double longest = 0;
  for (const Row& a : places) {
    for (const Row& b : places) longest = std::max(longest, distance(a, b));
  }
  for (std::size_t v = 0; v <= m; ++v) {
    double steepness = 0;
    for (std::size_t a = 0; a < m; ++a) {
      double gradient = 0;
      for (std::size_t k = 0; k < m; ++k) gradient += v == 0 ? -dual[a][k] : k + 1 == v ? dual[a][k] : 0;
      steepness += gradient * gradient;
    }
    margins.thickness = std::min(margins.thickness, 1 / std::sqrt(steepness) / (static_cast<double>(m) * longest));
  }
  for (const Row& q : others) margins.protection = std::min(margins.protection, distance(q, centre) - radius);
}

StarMargins measure(const SubmanifoldModel& model, const std::vector<ModelChart>& charts) {
  StarMargins margins;
  const auto place = [&](std::size_t i, std::size_t j) {
    Row result;
    for (std::size_t k = 0; k < model.m; ++k)
      result.push_back(component(charts[i].frame[k], model.points[j], model.points[i]));
    return result;
  };
  std::vector<std::vector<std::size_t>> stars(model.points.size());
  for (std::size_t s = 0; s < model.simplices.size(); ++s) {
    for (const int j : model.simplices[s]) stars[static_cast<std::size_t>(j)].push_back(s);
  }
  for (std::size_t i = 0; i < model.points.size(); ++i) {
    std::vector<std::size_t> near;
    for (std::size_t j = 0; j < model.points.size(); ++j) {
      if (!(distance(model.points[i], model.points[j]) < model.patch_radius)) continue;
      double height = 0;
      for (std::size_t k = model.m; k < charts[i].frame.size(); ++k)
        height = std::max(height, std::fabs(component(charts[i].frame[k], model.points[j], model.points[i])));
      if (height < model.height) near.push_back(j);
    }
    for (const std::size_t s : stars[i]) {
      Rows places, others;
      for (const std::size_t j : near) {
        const bool is_vertex =
            std::count(model.simplices[s].begin(), model.simplices[s].end(), static_cast<int>(j)) > 0;
        (is_vertex ? places : others).push_back(place(i, j));
      }
      measure_simplex(places, others, margins);
    }
  }
  return margins;
}

/// All signs of (1, 0, 0, 0), of (1, 1, 1, 1)/2, and of the even permutations of (g, 1, 1/g, 0)/2, g the golden ratio.
Rows vertices_of_600_cell() {
  const double golden_ratio = (1 + std::sqrt(5.0)) / 2;
  const Row unequal = {rounded(golden_ratio / 2, 40), 0.5, rounded(0.5 / golden_ratio, 40), 0};
  std::set<Row> vertices;
  const auto add = [&](const Row& x) {
    for (unsigned signs = 0; signs < 16; ++signs) {
      Row y = x;
      for (std::size_t k = 0; k < 4; ++k) y[k] = (signs >> k & 1U) != 0 && x[k] != 0 ? -x[k] : x[k];
      vertices.insert(y);
    }
  };
  add({0.5, 0.5, 0.5, 0.5});
  std::vector<std::size_t> order = {0, 1, 2, 3};
  do {
    int inversions = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      for (std::size_t l = 0; l < k; ++l) inversions += order[l] > order[k] ? 1 : 0;
    }
    Row axis(4), x(4);
    axis[order[0]] = 1;
    for (std::size_t k = 0; k < 4; ++k) x[order[k]] = unequal[k];
    add(axis);
    if (inversions % 2 == 0) add(x);
  } while (std::next_permutation(order.begin(), order.end()));
  return {vertices.begin(), vertices.end()};
}

void sort_simplices(SubmanifoldModel& model) {
  for (auto& simplex : model.simplices) std::sort(simplex.begin(), simplex.end());
  std::sort(model.simplices.begin(), model.simplices.end());
}

/// Points on the unit sphere, triangles.
void divide_icosahedron(int divisions, Rows& points, std::vector<std::vector<int>>& triangles) {
  const double golden_ratio = (1 + std::sqrt(5.0)) / 2;
  for (const double a : {-1.0, 1.0}) {
    for (const double b : {-golden_ratio, golden_ratio}) {
      points.push_back({0, a, b});
      points.push_back({a, b, 0});
      points.push_back({b, 0, a});
    }
  }
  for (int i = 0; i < 12; ++i) {
    for (int j = i + 1; j < 12; ++j) {
      for (int k = j + 1; k < 12; ++k) {
        const auto near = [&](int a, int b) {
          return distance(points[static_cast<std::size_t>(a)], points[static_cast<std::size_t>(b)]) < 2.1;
        };
        if (near(i, j) && near(j, k) && near(i, k)) triangles.push_back({i, j, k});
      }
    }
  }
  for (int division = 0; division < divisions; ++division) {
    std::map<std::pair<int, int>, int> middles;
    const auto middle = [&](int a, int b) {
      const auto [at, is_new] = middles.try_emplace(std::minmax(a, b), static_cast<int>(points.size()));
      if (is_new) {
        Row sum = points[static_cast<std::size_t>(a)];
        for (std::size_t k = 0; k < 3; ++k) sum[k] += points[static_cast<std::size_t>(b)][k];
        points.push_back(sum);
      }
      return at->second;
    };
    std::vector<std::vector<int>> divided;
    for (const auto& t : triangles) {
      const int ab = middle(t[0], t[1]), bc = middle(t[1], t[2]), ca = middle(t[2], t[0]);
      for (const auto& part : {std::vector{t[0], ab, ca}, {t[1], ab, bc}, {t[2], bc, ca}, {ab, bc, ca}})
        divided.push_back(part);
    }
    triangles = divided;
    for (Row& x : points) {
      const double length = std::sqrt(dot(x, x));
      for (double& entry : x) entry /= length;
    }
  }
}

/// Points of which every other row is moved by half a step, and triangles; rows and columns close up.
void staggered_grid(int columns, int rows, std::vector<std::vector<int>>& triangles) {
  const auto label = [&](int column, int row) { return (row + rows) % rows * columns + (column + columns) % columns; };
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const int right = row % 2;
      triangles.push_back({label(column, row), label(column + 1, row), label(column + right, row + 1)});
      triangles.push_back({label(column, row), label(column + right - 1, row + 1), label(column + right, row + 1)});
    }
  }
}

/// Patches and claims that fit edges of this length on a manifold of curvature at most 1.
void fit(SubmanifoldModel& model, double edge) {
  model.sampling_radius = edge;
  model.patch_radius = rounded(2.3 * edge, 20);
  model.slope = rounded(1.25 * model.patch_radius / std::sqrt(1 - model.patch_radius * model.patch_radius), 20);
  model.height = rounded(0.62 * model.slope * model.patch_radius, 20);
  model.displacement = 0.5 * edge * edge;
  model.margin = edge / 64;
}

double norm_less_one(const Row& x, double centre) {
  Row y = x;
  y[0] -= centre;
  return dot(y, y) - 1;
}

}  // namespace

SubmanifoldModel sphere_model(int divisions) {
  SubmanifoldModel model{.variables = {"x", "y", "z"},
                         .equations = {"x^2+y^2+z^2-1"},
                         .map = [](const Row& x) { return Row{dot(x, x) - 1}; },
                         .box = {{-2, 2}, {-2, 2}, {-2, 2}}};
  divide_icosahedron(divisions, model.points, model.simplices);
  for (Row& point : model.points) {
    for (double& x : point) x = rounded(x, 40);
  }
  sort_simplices(model);
  const double edge = 1.25 / std::pow(2.0, divisions);  // of the longest edges
  fit(model, edge);
  return model;
}

SubmanifoldModel sphere_of_cells_model() {
  SubmanifoldModel model{.m = 3,
                         .variables = {"a", "b", "c", "d"},
                         .equations = {"a^2+b^2+c^2+d^2-1"},
                         .map = [](const Row& x) { return Row{dot(x, x) - 1}; },
                         .box = {{-2, 2}, {-2, 2}, {-2, 2}, {-2, 2}}};
  model.given = true;
  model.points = vertices_of_600_cell();
  const auto near = [&](std::size_t i, std::size_t j) { return distance(model.points[i], model.points[j]) < 0.7; };
  std::map<std::pair<std::size_t, std::size_t>, int> middles;
  const auto middle = [&](std::size_t i, std::size_t j) {
    const auto [at, is_new] = middles.try_emplace({i, j}, static_cast<int>(model.points.size()));
    if (is_new) {
      Row sum = model.points[i];
      for (std::size_t k = 0; k < 4; ++k) sum[k] += model.points[j][k];
      const double length = std::sqrt(dot(sum, sum));
      for (double& entry : sum) entry = rounded(entry / length, 40);
      model.points.push_back(sum);
    }
    return at->second;
  };
  const auto cut = [&](const std::array<std::size_t, 4>& t) {
    const auto m = [&](std::size_t i, std::size_t j) { return middle(t[i], t[j]); };
    for (std::size_t i = 0; i < 4; ++i) {
      std::vector<int> corner = {static_cast<int>(t[i])};
      for (std::size_t j = 0; j < 4; ++j) {
        if (j != i) corner.push_back(m(std::min(i, j), std::max(i, j)));
      }
      model.simplices.push_back(corner);
    }
    // What is left is an octahedron, about the diagonal from the first edge to the last.
    const std::array<int, 4> ring = {m(0, 2), m(0, 3), m(1, 3), m(1, 2)};
    for (std::size_t k = 0; k < 4; ++k) model.simplices.push_back({m(0, 1), m(2, 3), ring[k], ring[(k + 1) % 4]});
  };
  const std::size_t n = model.points.size();
  for (std::size_t a = 0; a < n; ++a) {
    for (std::size_t b = a + 1; b < n; ++b) {
      for (std::size_t c = b + 1; near(a, b) && c < n; ++c) {
        for (std::size_t d = c + 1; near(a, c) && near(b, c) && d < n; ++d)
          if (near(a, d) && near(b, d) && near(c, d)) cut({a, b, c, d});
      }
    }
  }
  sort_simplices(model);
  model.sampling_radius = 0.25;
  model.patch_radius = 0.53125;
  model.slope = 0.8125;
  model.height = 0.25;
  model.contraction = 0.9375;
  model.displacement = 0.0625;
  return model;
}

SubmanifoldModel on_mesh(SubmanifoldModel model, const SubmanifoldModel& polyhedron) {
  model.mesh = polyhedron.points;
  model.facets = polyhedron.simplices;
  for (auto& facet : model.facets) {
    const auto corner = [&](int k) { return model.mesh[static_cast<std::size_t>(facet[static_cast<std::size_t>(k)])]; };
    const Row a = corner(0), b = corner(1), c = corner(2);
    const double volume =
        a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
    if (volume < 0) std::swap(facet[1], facet[2]);
  }
  return model;
}

SubmanifoldModel doubled(SubmanifoldModel model) {
  std::string others;
  for (std::size_t k = 1; k < model.variables.size(); ++k) others += "+" + model.variables[k] + "^2";
  const std::string& x = model.variables[0];
  model.equations = {"((" + x + "-2)^2" + others + "-1)*((" + x + "+2)^2" + others + "-1)"};
  model.map = [](const Row& at) { return Row{norm_less_one(at, 2) * norm_less_one(at, -2)}; };
  model.box[0] = {-4, 4};
  // Here the gradient changes along the normal half as fast again as that of one sphere.
  model.slope *= 1.1;
  const std::size_t n = model.points.size(), t = model.simplices.size();
  for (std::size_t j = 0; j < n; ++j) {
    model.points.push_back(model.points[j]);
    model.points[j][0] += 2;
    model.points.back()[0] -= 2;
  }
  for (std::size_t s = 0; s < t; ++s) {
    model.simplices.push_back(model.simplices[s]);
    for (int& j : model.simplices.back()) j += static_cast<int>(n);
  }
  return model;
}

SubmanifoldModel first_component(SubmanifoldModel model) {
  model.points.resize(model.points.size() / 2);
  model.simplices.resize(model.simplices.size() / 2);
  return model;
}

SubmanifoldModel branched_sphere_model(int rings, int ring) {
  SubmanifoldModel model = sphere_model(0);
  model.points = {{0, 0, 1}, {0, 0, -1}};
  model.simplices.clear();
  const auto label = [&](int row, int column) { return 2 + row * ring + (column + ring) % ring; };
  for (int row = 0; row < rings; ++row) {
    const double v = pi * (row + 1) / (rings + 1);
    for (int column = 0; column < ring; ++column) {
      const double u = 4 * pi * (column + (row % 2) / 2.0) / ring;
      model.points.push_back(
          {rounded(std::sin(v) * std::cos(u), 40), rounded(std::sin(v) * std::sin(u), 40), rounded(std::cos(v), 40)});
      const int right = row % 2;
      if (row == 0) model.simplices.push_back({0, label(0, column), label(0, column + 1)});
      if (row == rings - 1) {
        model.simplices.push_back({1, label(row, column), label(row, column + 1)});
        continue;
      }
      model.simplices.push_back({label(row, column), label(row, column + 1), label(row + 1, column + right)});
      model.simplices.push_back(
          {label(row, column), label(row + 1, column + right - 1), label(row + 1, column + right)});
    }
  }
  model.given = true;
  sort_simplices(model);
  fit(model, 0.2);
  return model;
}

SubmanifoldModel torus_model(int around, int across, int turns) {
  SubmanifoldModel model{.variables = {"x", "y", "z"},
                         .equations = {"(x^2+y^2+z^2+3)^2-16*(x^2+y^2)"},
                         .map =
                             [](const Row& x) {
                               const double flat = x[0] * x[0] + x[1] * x[1], sum = flat + x[2] * x[2] + 3;
                               return Row{sum * sum - 16 * flat};
                             },
                         .box = {{-4, 4}, {-4, 4}, {-2, 2}}};
  for (int row = 0; row < across; ++row) {
    for (int column = 0; column < around; ++column) {
      const double u = turns * 2 * pi * (column + (row % 2) / 2.0) / around, v = 2 * pi * row / across;
      const double flat = 2 + std::cos(v);
      model.points.push_back(
          {rounded(flat * std::cos(u), 40), rounded(flat * std::sin(u), 40), rounded(std::sin(v), 40)});
    }
  }
  staggered_grid(around, across, model.simplices);
  sort_simplices(model);
  const double edge = 3.3 * 2 * pi * turns / around;
  fit(model, edge);
  return model;
}

SubmanifoldModel circle_model(int points, int turns) {
  SubmanifoldModel model{.m = 1,
                         .variables = {"x", "y"},
                         .equations = {"x^2+y^2-1"},
                         .map = [](const Row& x) { return Row{dot(x, x) - 1}; },
                         .box = {{-2, 2}, {-2, 2}}};
  for (int k = 0; k < points; ++k) {
    const double u = turns * 2 * pi * k / points;
    model.points.push_back({rounded(std::cos(u), 40), rounded(std::sin(u), 40)});
    model.simplices.push_back({k, (k + 1) % points});
  }
  sort_simplices(model);
  const double edge = turns * 2 * pi / points;
  fit(model, edge);
  return model;
}

SubmanifoldModel nested_circles_model(int points, double gap) {
  SubmanifoldModel model = circle_model(points, 1);
  const double wide = (1 + gap) * (1 + gap);
  const int ratio = static_cast<int>(std::lround(wide * 0x1p20));
  model.equations = {"(x^2+y^2-1)*(1048576*(x^2+y^2)-" + std::to_string(ratio) + ")"};
  model.map = [ratio](const Row& x) { return Row{(dot(x, x) - 1) * (0x1p20 * dot(x, x) - ratio)}; };
  const double radius = std::sqrt(ratio / 0x1p20);
  for (int k = 0; k < points; ++k) {
    const double u = 2 * pi * (k + 0.5) / points;
    model.points.push_back({rounded(radius * std::cos(u), 40), rounded(radius * std::sin(u), 40)});
    model.simplices.push_back({points + k, points + (k + 1) % points});
  }
  sort_simplices(model);
  return model;
}

SubmanifoldModel flat_torus_model(int points) {
  SubmanifoldModel model{.variables = {"a", "b", "c", "d"},
                         .equations = {"a^2+b^2-1", "c^2+d^2-1"},
                         .map =
                             [](const Row& x) {
                               return Row{x[0] * x[0] + x[1] * x[1] - 1, x[2] * x[2] + x[3] * x[3] - 1};
                             },
                         .box = {{-2, 2}, {-2, 2}, {-2, 2}, {-2, 2}}};
  const int rows = 2 * static_cast<int>(std::lround(points / std::sqrt(3.0)));
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < points; ++column) {
      const double u = 2 * pi * (column + (row % 2) / 2.0) / points, v = 2 * pi * row / rows;
      model.points.push_back(
          {rounded(std::cos(u), 40), rounded(std::sin(u), 40), rounded(std::cos(v), 40), rounded(std::sin(v), 40)});
    }
  }
  staggered_grid(points, rows, model.simplices);
  sort_simplices(model);
  const double edge = 2 * pi / points;
  fit(model, edge);
  return model;
}

SubmanifoldModel tilted_torus_model() {
  constexpr double squared_radius = 0.063;
  SubmanifoldModel model{.variables = {"a", "b", "c", "d"},
                         .equations = {"a^2+b^2-1", "c^2+d^2-63/1000"},
                         .map =
                             [](const Row& x) {
                               return Row{x[0] * x[0] + x[1] * x[1] - 1, x[2] * x[2] + x[3] * x[3] - squared_radius};
                             },
                         .box = {{-2, 2}, {-2, 2}, {-2, 2}, {-2, 2}}};
  // Edges along the first circle are a little longer than two rows are apart, and look shorter in charts.
  constexpr int columns = 91, rows = 46;
  const double radius = std::sqrt(squared_radius);
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const double u = 2 * pi * (column + (row % 2) / 2.0) / columns, v = 2 * pi * row / rows;
      model.points.push_back({rounded(std::cos(u), 40), rounded(std::sin(u), 40), rounded(radius * std::cos(v), 40),
                              rounded(radius * std::sin(v), 40)});
    }
  }
  staggered_grid(columns, rows, model.simplices);
  sort_simplices(model);
  const double edge = 2 * pi / columns;
  fit(model, edge);
  model.displacement = edge * edge;
  model.tilt = 0.2;
  model.patch_radius = rounded(1.35 * edge, 20);
  // At the middle of a patch an eighth of it, which is more than the tilt.
  model.slope = rounded(8.3 * std::tan(model.tilt), 20);
  model.height = rounded(0.62 * model.slope * model.patch_radius, 20);
  return model;
}

SubmanifoldModel lifted(SubmanifoldModel flat_torus, std::size_t dimension) {
  SubmanifoldModel model = std::move(flat_torus);
  const auto heights = [dimension](const Row& x) {
    Row result = {x[0] * x[2] / 2, x[1] * x[3] / 2};
    result.resize(dimension - 4);
    return result;
  };
  for (std::size_t k = 4; k < dimension; ++k) {
    model.variables.push_back(k == 4 ? "e" : "f");
    model.equations.push_back(k == 4 ? "e-a*c/2" : "f-b*d/2");
    model.box.push_back({-1, 1});
  }
  for (Row& point : model.points) {
    for (const double height : heights(point)) point.push_back(rounded(height, 40));
  }
  model.map = [heights](const Row& x) {
    Row result = {x[0] * x[0] + x[1] * x[1] - 1, x[2] * x[2] + x[3] * x[3] - 1};
    const Row expected = heights(x);
    for (std::size_t k = 0; k < expected.size(); ++k) result.push_back(x[4 + k] - expected[k]);
    return result;
  };
  model.patch_radius = rounded(0.85 * model.patch_radius, 20);
  model.slope = 0.75;
  model.height = rounded(0.62 * model.slope * model.patch_radius, 20);
  model.displacement *= 2.5;
  return model;
}

Json certificate(const SubmanifoldModel& model, const std::vector<std::string>& levels) {
  Json j;
  j["format"] = "delcert-certificate";
  j["version"] = 2;
  j["software"]["delcert"] = "test";
  Json& manifold = j["manifold"];
  manifold["name"] = "model";
  manifold["family"] = "submanifold";
  manifold["dimension"] = model.m;
  if (model.mesh.empty()) {
    manifold["variables"] = model.variables;
    manifold["equations"] = model.equations;
    for (const auto& [low, high] : model.box) manifold["box"].push_back({std::to_string(low), std::to_string(high)});
  } else {
    for (const Row& x : model.mesh) manifold["mesh"].push_back({text(x[0]), text(x[1]), text(x[2])});
    manifold["facets"] = model.facets;
  }
  manifold["slope"] = text(model.slope);
  manifold["vertices"] = model.given ? "given" : "manifold";
  Json& parameters = j["parameters"];
  parameters["mode"] = "none";
  parameters["candidates"] = "whole";
  parameters["seed"] = "0";
  parameters["sampling_radius"] = text(rounded(model.sampling_radius, 20));
  parameters["separation"] = "1/4";
  parameters["radius_variation"] = "0";
  parameters["distortion"] = text(rounded(std::sqrt(1 + model.slope * model.slope) - 1, 30) + 0x1p-29);
  parameters["perturbation"] = "0";
  parameters["flake_parameter_squared"] = "1";
  parameters["tolerance"] = "0";

  std::vector<ModelChart> charts;
  Json all_charts = Json::array(), net = Json::array(), points = Json::array(), simplices = Json::array();
  for (const Row& x : model.points) charts.push_back(chart_at(model, x));
  const StarMargins margins =
      std::count(levels.begin(), levels.end(), "1") > 0 ? measure(model, charts) : StarMargins{};
  // What is so near to a point has to be below the lid.
  const double density = 1.06 * std::sqrt(1 + model.slope * model.slope) * margins.radius;
  const bool is_delaunay = std::count(levels.begin(), levels.end(), "4") > 0 && model.metric != "intrinsic";
  const double height = is_delaunay && !model.is_low ? std::max(model.height, 1.05 * density) : model.height;
  for (std::size_t i = 0; i < charts.size(); ++i) {
    const Row& x = model.points[i];
    Json chart = Json::array(), place = Json::array();
    for (const int axis : charts[i].axes) chart.push_back(std::to_string(axis));
    for (const double entry : charts[i].skew) chart.push_back(text(entry));
    for (const Row& row : charts[i].Y) {
      for (const double entry : row) chart.push_back(text(entry));
    }
    chart.push_back(text(model.patch_radius));
    chart.push_back(text(height));
    all_charts.push_back(chart);
    for (const double entry : x) place.push_back(text(entry));
    net.push_back(place);
    points.push_back(std::vector<std::string>(model.m, "0"));
  }
  for (const auto& simplex : model.simplices) {
    Json row = simplex;
    for (std::size_t k = 0; k < model.m; ++k) row.push_back(0);
    simplices.push_back(row);
  }
  j["levels"] = Json::object();
  for (const std::string& level : levels) {
    Json& value = j["levels"][level] = Json::object();
    if (level == "1") {
      value["protection"] = text(rounded(margins.protection / 2, 30));
      value["thickness"] = text(rounded(margins.thickness / 2, 20));
      value["circumradius"] = text(rounded(margins.radius * 1.1, 30));
    } else if (level == "2") {
      std::set<std::pair<int, int>> edges;
      for (const auto& simplex : model.simplices) {
        for (std::size_t k = 0; k < simplex.size(); ++k) {
          for (std::size_t i = 0; i < k; ++i) edges.insert({simplex[i], simplex[k]});
        }
      }
      value["simplices"] = model.simplices.size();
      value["euler_characteristic"] = static_cast<int>(model.points.size()) - static_cast<int>(edges.size()) +
                                      (model.m == 2 ? static_cast<int>(model.simplices.size()) : 0);
      if (model.m == 3) value["euler_characteristic"] = 0;
      value["closed"] = true;
    } else if (level == "2s") {
      value["reach"] = text(rounded(model.patch_radius * 0.99, 30));
    } else if (level == "5") {
      value["route"] = "graph";
      value["contraction"] = text(model.contraction);
      value["displacement"] = text(rounded(model.displacement, 30));
    } else if (level == "5i") {
      value["margin"] = text(rounded(model.margin, 30));
    } else if (level == "4") {
      value["metric"] = model.metric;
      value["density"] = text(rounded(density, 30));
    } else if (level == "6") {
      value["self_delaunay"] = model.m == 2;
      if (model.m == 2) value["weight"] = "0";
      value["bilipschitz"] = {text(1 - model.sampling_radius), text(1 + model.sampling_radius)};
      value["normal"] = text(1.5 * model.sampling_radius);
    }
  }
  j["net"] = net;
  j["charts"] = all_charts;
  j["net_simplices"] = Json::array();
  j["points"] = points;
  j["elements"] = Json::array();
  j["simplices"] = simplices;
  j["loops"] = Json::array();
  return j;
}

}  // namespace delcert::checker_tests
