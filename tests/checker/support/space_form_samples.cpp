#include "tests/checker/support/space_form_samples.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

namespace delcert::checker_tests {
namespace {

const std::set<std::string> surface_levels = {"0", "1", "2", "2s", "4", "5", "6"};
const std::set<std::string> solid_levels = {"1", "2", "4", "5", "6"};

Isometry identity(std::size_t m) {
  Isometry result{};
  for (std::size_t k = 0; k <= m; ++k) result[k][k] = 1;
  return result;
}

Isometry product(const Isometry& a, const Isometry& b) {
  Isometry result{};
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t k = 0; k < 4; ++k) {
      for (std::size_t j = 0; j < 4; ++j) result[i][k] += a[i][j] * b[j][k];
    }
  }
  return result;
}

Json rows(std::size_t order, const std::function<Json(std::size_t, std::size_t)>& entry) {
  Json result = Json::array();
  for (std::size_t i = 0; i < order; ++i) {
    Json row = Json::array();
    for (std::size_t k = 0; k < order; ++k) row.push_back(entry(i, k));
    result.push_back(row);
  }
  return result;
}

Json rational(const std::string& x) { return Json::array({x}); }

Json manifold(const std::string& name, const std::string& family, std::size_t m, const Json& field, const Json& root,
              const Json& time, const Json& gram, const Json& generators, const std::string& injectivity_radius) {
  return Json{{"name", name},
              {"family", family},
              {"dimension", m},
              {"field", field},
              {"root", root},
              {"time", time},
              {"gram", gram},
              {"generators", generators},
              {"injectivity_radius", injectivity_radius}};
}

const Json rational_field = Json::array({"0", "1"}), around_0 = Json::array({"-1", "1"});

Json diagonal(std::size_t order, const std::string& entry) {
  return rows(order, [&](std::size_t i, std::size_t k) { return rational(i == k ? entry : "0"); });
}

/// A model on the sphere of the points x; of the projective space if they are to be taken up to sign.
SpaceFormModel spherical(std::size_t m, bool projective, std::vector<Point> points) {
  SpaceFormModel model;
  model.K = 1;
  model.m = m;
  model.elements = {identity(m)};
  model.injectivity_radius = projective ? 1.5625 : 3.125;
  Json generators = Json::array();
  if (projective) {
    generators.push_back(diagonal(m + 1, "-1"));
    Isometry opposite = identity(m);
    for (Point& row : opposite) {
      for (double& x : row) x = -x;
    }
    model.elements.push_back(opposite);
    model.words.push_back({0, 1});
    model.letters.push_back(opposite);
    std::erase_if(points, [](const Point& x) { return x < Point{}; });
  }
  model.manifold = manifold("a test", "spherical", m, rational_field, around_0, rational("1"), diagonal(m, "1"),
                            generators, projective ? "25/16" : "25/8");
  for (const Point& x : points) {
    Point a = conformal_of(m, x);
    for (double& coordinate : a) coordinate = dyadic(coordinate);
    model.net.push_back(a);
  }
  return model;
}

/// Rotates by three angles, so that no point is special; all points then have the length 1.
std::vector<Point> turned(std::vector<Point> points, std::size_t size) {
  const double angles[] = {0.3, 0.7, 1.1};
  for (Point& x : points) {
    for (std::size_t k = 0; k + 1 < size; ++k) {
      const double c = std::cos(angles[k]), s = std::sin(angles[k]), a = x[k], b = x[k + 1];
      x[k] = c * a - s * b;
      x[k + 1] = s * a + c * b;
    }
    double length = 0;
    for (const double coordinate : x) length += coordinate * coordinate;
    for (double& coordinate : x) coordinate /= std::sqrt(length);
  }
  return points;
}

const double golden = (1 + std::sqrt(5.0)) / 2;

double distance(const Point& x, const Point& y) {
  double sum = 0;
  for (std::size_t k = 0; k < 4; ++k) sum += (x[k] - y[k]) * (x[k] - y[k]);
  return std::sqrt(sum);
}

void add_once(std::vector<Point>& points, const Point& x) {
  if (std::none_of(points.begin(), points.end(), [&](const Point& y) { return distance(x, y) < 1e-6; }))
    points.push_back(x);
}

std::vector<Point> icosphere_points(int frequency) {
  std::vector<Point> corners;
  for (const double a : {-1.0, 1.0}) {
    for (const double b : {-golden, golden}) {
      corners.push_back({0, a, b, 0});
      corners.push_back({a, b, 0, 0});
      corners.push_back({b, 0, a, 0});
    }
  }
  std::vector<Point> points;
  for (std::size_t i = 0; i < 12; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      for (std::size_t k = 0; k < j; ++k) {
        if (std::max({distance(corners[i], corners[j]), distance(corners[i], corners[k]),
                      distance(corners[j], corners[k])}) > 2.1)
          continue;
        for (int a = 0; a <= frequency; ++a) {
          for (int b = 0; a + b <= frequency; ++b) {
            Point x{};
            for (std::size_t t = 0; t < 3; ++t)
              x[t] = (a * corners[i][t] + b * corners[j][t] + (frequency - a - b) * corners[k][t]) / frequency;
            const double length = distance(x, {});
            for (double& coordinate : x) coordinate /= length;
            add_once(points, x);
          }
        }
      }
    }
  }
  return turned(points, 3);
}

/// The 120 vertices: permutations of (±1, 0, 0, 0), (±1, ±1, ±1, ±1)/2 and even ones of (±golden, ±1, ±1/golden, 0)/2.
std::vector<Point> cell_600_points() {
  std::vector<Point> points;
  std::array<std::size_t, 4> order{0, 1, 2, 3};
  do {
    int inversions = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = 0; j < i; ++j) inversions += order[j] > order[i] ? 1 : 0;
    }
    for (int signs = 0; signs < 16; ++signs) {
      const auto sign = [&](int k) { return (signs >> k & 1) != 0 ? 0.5 : -0.5; };
      Point a{}, b{};
      a[order[0]] = 2 * sign(0);
      b[order[0]] = golden * sign(0);
      b[order[1]] = sign(1);
      b[order[2]] = sign(2) / golden;
      add_once(points, a);
      add_once(points, {sign(0), sign(1), sign(2), sign(3)});
      if (inversions % 2 == 0) add_once(points, b);
    }
  } while (std::next_permutation(order.begin(), order.end()));
  return turned(points, 4);
}

SpaceFormSample finished(SpaceFormModel model, double epsilon, double mu, double rho, std::set<std::string> levels,
                         std::uint64_t seed) {
  model.epsilon = dyadic(epsilon);
  model.mu = dyadic(mu);
  model.rho = dyadic(rho);
  perturb_until_stars_agree(model, seed, levels.contains("2s"));
  const SpaceFormMargins margins = roomy_margins(model);
  return {std::move(model), margins, std::move(levels)};
}

/// Random points of a domain, no closer than `separation` to each other, as many as many darts give.
void throw_darts(SpaceFormModel& model, double separation, std::uint64_t seed,
                 const std::function<bool(const std::function<double()>&, Point&)>& dart) {
  std::mt19937_64 random(seed);
  const std::function<double()> uniform = [&random] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  std::vector<Point> lifts;
  for (int failures = 0; failures < 4000;) {
    Point a{};
    if (!dart(uniform, a)) continue;
    for (double& coordinate : a) coordinate = dyadic(coordinate);
    const Point x = linear_of(model.K, model.m, a);
    // 4 sinh^2(d/2) or d^2.
    const auto near = [&](const Point& y) {
      double chord = model.K * (x[0] - y[0]) * (x[0] - y[0]);
      for (std::size_t k = 1; k <= model.m; ++k) chord += (x[k] - y[k]) * (x[k] - y[k]);
      return chord < separation * separation * 1.01;
    };
    if (std::any_of(lifts.begin(), lifts.end(), near)) {
      ++failures;
      continue;
    }
    failures = 0;
    model.net.push_back(a);
    for (const Isometry& g : model.elements) {
      const Point y = image(model.m, g, x);
      if (distance_from_origin(model.K, model.m, y) < 4) lifts.push_back(y);
    }
  }
}

/// Adds the products of the generators and their inverses, which come in turn in `steps`, that move o by less than
/// this.
void add_elements(SpaceFormModel& model, const std::vector<Isometry>& steps, double reach) {
  model.elements = {identity(2)};
  for (std::size_t at = 0; at < model.elements.size(); ++at) {
    for (std::size_t number = 0; number < steps.size(); ++number) {
      const Isometry next = product(model.elements[at], steps[number]);
      const bool known = std::any_of(model.elements.begin(), model.elements.end(), [&](const Isometry& g) {
        return std::fabs(g[1][0] - next[1][0]) + std::fabs(g[2][0] - next[2][0]) < 1e-4;
      });
      if (known || next[0][0] >= std::cosh(reach)) continue;
      const int letter = static_cast<int>(number / 2) + 1;
      model.words.push_back({static_cast<int>(at), number % 2 == 0 ? letter : -letter});
      model.elements.push_back(next);
    }
  }
}

/// Random points closer to o than to its images under the steps. The squares of conformal coordinates are at most
/// `farthest` there, and (1 - a quarter of them)^2 at least `thinnest`.
void throw_darts_into_polygon(SpaceFormModel& model, const std::vector<Isometry>& steps, double farthest,
                              double thinnest) {
  throw_darts(model, 0.105, 5, [&](const std::function<double()>& uniform, Point& a) {
    a = {2 * (2 * uniform() - 1), 2 * (2 * uniform() - 1), 0, 0};
    if (a[0] * a[0] + a[1] * a[1] > farthest) return false;
    // With the right density, and closer to o than to its images.
    const double D = 1 - (a[0] * a[0] + a[1] * a[1]) / 4;
    if (uniform() > thinnest / (D * D)) return false;
    const Point x = linear_of(-1, 2, a);
    return std::all_of(steps.begin(), steps.end(), [&](const Isometry& g) { return image(2, g, x)[0] >= x[0]; });
  });
}

}  // namespace

const SpaceFormSample& icosphere() {
  static const SpaceFormSample result =
      finished(spherical(2, false, icosphere_points(8)), 0.11, 0.7, 0.02, surface_levels, 1);
  return result;
}

const SpaceFormSample& projective_plane() {
  static const SpaceFormSample result =
      finished(spherical(2, true, icosphere_points(8)), 0.11, 0.7, 0.02, surface_levels, 2);
  return result;
}

const SpaceFormSample& cell_600() {
  static const SpaceFormSample result =
      finished(spherical(3, false, cell_600_points()), 0.42, 0.9, 0.02, solid_levels, 3);
  return result;
}

const SpaceFormSample& projective_space() {
  static const SpaceFormSample result =
      finished(spherical(3, true, cell_600_points()), 0.42, 0.9, 0.02, solid_levels, 4);
  return result;
}

/// The regular octagon with angles pi/4; generator k translates in the direction k pi/4 by l with cosh l = 5 + 4t,
/// t = sqrt 2. The basis stretches o by S = sinh l.
const SpaceFormSample& bolza_surface() {
  static const SpaceFormSample result = [] {
    SpaceFormModel model;
    model.K = -1;
    const double t = std::sqrt(2.0), c = 5 + 4 * t, S = std::sqrt(56 + 40 * t);
    const auto pair = [](const std::string& a, const std::string& b) { return Json::array({a, b}); };
    // u = (1, 0), (t/2, t/2), (0, 1), (-t/2, t/2), each entry by its sign and whether it has t/2.
    struct Direction {
      int x, y;
      bool diagonal;
    };
    Json generators = Json::array();
    std::vector<Isometry> steps;
    for (const Direction d : {Direction{1, 0, false}, {1, 1, true}, {0, 1, false}, {-1, 1, true}}) {
      const double scale = d.diagonal ? t / 2 : 1, u[] = {scale * d.x, scale * d.y};
      const int signs[] = {d.x, d.y};
      for (const double way : {1.0, -1.0}) {
        Isometry g = identity(2);
        g[0][0] = c;
        for (std::size_t i = 0; i < 2; ++i) {
          g[0][i + 1] = g[i + 1][0] = way * S * u[i];
          for (std::size_t k = 0; k < 2; ++k) g[i + 1][k + 1] += (c - 1) * u[i] * u[k];
        }
        steps.push_back(g);
      }
      model.letters.push_back(steps[steps.size() - 2]);
      generators.push_back(rows(3, [&](std::size_t i, std::size_t k) {
        const auto times = [](int sign, int value) { return std::to_string(sign * value); };
        if (i == 0 && k == 0) return pair("5", "4");
        if (i == 0)
          return d.diagonal ? pair("0", times(signs[k - 1], 1) + "/2") : rational(std::to_string(signs[k - 1]));
        // S^2 u; times t/2 it is 40 + 28t.
        if (k == 0)
          return d.diagonal ? pair(times(signs[i - 1], 40), times(signs[i - 1], 28))
                            : pair(times(signs[i - 1], 56), times(signs[i - 1], 40));
        const int uu = signs[i - 1] * signs[k - 1], one = i == k ? 1 : 0;
        // (4 + 4t) uu, halved for a diagonal direction.
        return d.diagonal ? pair(std::to_string(one + 2 * uu), std::to_string(2 * uu))
                          : pair(std::to_string(one + 4 * uu), std::to_string(4 * uu));
      }));
    }
    model.manifold = manifold("a test", "hyperbolic", 2, Json::array({"-2", "0", "1"}), Json::array({"1", "2"}),
                              pair("-56", "-40"), diagonal(2, "1"), generators, "3/2");
    model.injectivity_radius = 1.5;
    add_elements(model, steps, 8);
    // All of the octagon is within 2.9.
    throw_darts_into_polygon(model, steps, 2.9, 0.0756);
    return finished(std::move(model), 0.115, 0.9, 0.2, surface_levels, 6);
  }();
  return result;
}

const SpaceFormSample& unstable_bolza_surface() {
  static const SpaceFormSample result =
      finished(bolza_surface().model, 0.115, 0.9, 0.2, {"0", "1", "2", "4", "5", "6"}, 6);
  return result;
}

Json surface_with_far_crosscap() {
  Json generators = Json::array();
  for (const auto& matrix : {std::array{"7/2", "3/2", "0", "15/2", "7/2", "0", "0", "0", "1"},
                             {"7/2", "0", "3/2", "0", "1", "0", "15/2", "0", "7/2"},
                             {"19", "6", "6", "30", "9", "10", "30", "10", "9"},
                             {"19", "6", "-6", "30", "9", "-10", "-30", "-10", "9"}})
    generators.push_back(rows(3, [&](std::size_t i, std::size_t k) { return rational(matrix[3 * i + k]); }));
  return manifold("a test", "hyperbolic", 2, rational_field, around_0, rational("-5"), diagonal(2, "1"), generators,
                  "69/100");
}

const SpaceFormSample& far_crosscap() {
  static const SpaceFormSample result = [] {
    SpaceFormModel model;
    model.K = -1;
    model.manifold = surface_with_far_crosscap();
    model.injectivity_radius = 0.69;
    // The basis of the file stretches o by t = sqrt 5.
    const double t = std::sqrt(5.0);
    const auto isometry = [&](const std::array<double, 9>& entries) {
      Isometry g{};
      for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < 3; ++k)
          g[i][k] = entries[3 * i + k] * (i == 0 && k > 0 ? t : i > 0 && k == 0 ? 1 / t : 1);
      }
      return g;
    };
    std::vector<Isometry> steps;
    for (const auto& [forward, backward] :
         {std::pair(std::array{3.5, 1.5, 0., 7.5, 3.5, 0., 0., 0., 1.},
                    std::array{3.5, -1.5, 0., -7.5, 3.5, 0., 0., 0., 1.}),
          {{3.5, 0., 1.5, 0., 1., 0., 7.5, 0., 3.5}, {3.5, 0., -1.5, 0., 1., 0., -7.5, 0., 3.5}},
          {{19., 6., 6., 30., 9., 10., 30., 10., 9.}, {19., -6., -6., -30., 9., 10., -30., 10., 9.}},
          {{19., 6., -6., 30., 9., -10., -30., -10., 9.}, {19., -6., 6., -30., 9., -10., 30., -10., 9.}}}) {
      steps.push_back(isometry(forward));
      steps.push_back(isometry(backward));
      model.letters.push_back(isometry(forward));
    }
    add_elements(model, steps, 5.2);
    // cosh^2 of the distance of a vertex from o is 45/4.
    throw_darts_into_polygon(model, steps, 2.2, 0.2);
    return finished(std::move(model), 0.115, 0.9, 0.2, {"1", "2", "4"}, 6);
  }();
  return result;
}

/// The torus of 2 by 1 modulo a glide reflection along the first axis.
const SpaceFormSample& klein_bottle() {
  static const SpaceFormSample result = [] {
    SpaceFormModel model;
    model.K = 0;
    model.frame = {2, 1, 1, 1};
    Json generators = Json::array();
    const std::string glide[3][3] = {{"1", "0", "0"}, {"1/2", "1", "0"}, {"0", "0", "-1"}};
    generators.push_back(rows(3, [&](std::size_t i, std::size_t k) { return rational(glide[i][k]); }));
    Json gram = diagonal(2, "1");
    gram[0][0] = rational("4");
    model.manifold = manifold("a test", "flat", 2, rational_field, around_0, rational("0"), gram, generators, "1/2");
    model.injectivity_radius = 0.5;
    model.elements = {identity(2)};
    // (u, v) -> (u + x, ±v + y): translations by y, each followed by powers of the glide.
    const auto moved = [](int x, int y) {
      Isometry g = identity(2);
      g[1][0] = x;
      g[2][0] = y;
      if (x % 2 != 0) g[2][2] = -1;
      return g;
    };
    model.letters = {moved(1, 0), moved(2, 0), moved(0, 1)};
    std::map<std::pair<int, int>, int> numbers{{{0, 0}, 0}};
    const auto add = [&](std::pair<int, int> from, int letter, int x, int y) {
      numbers[{x, y}] = static_cast<int>(model.elements.size());
      model.words.push_back({numbers.at(from), letter});
      model.elements.push_back(moved(x, y));
    };
    for (int y = 1; y <= 3; ++y) {
      for (const int sign : {1, -1}) add({0, sign * (y - 1)}, 3 * sign, 0, sign * y);
    }
    for (int y = -3; y <= 3; ++y) {
      for (int x = 1; x <= 3; ++x) {
        for (const int sign : {1, -1}) add({sign * (x - 1), y}, sign, sign * x, y);
      }
    }
    throw_darts(model, 0.0375, 7, [](const std::function<double()>& uniform, Point& a) {
      a = {uniform(), uniform(), 0, 0};
      return true;
    });
    return finished(std::move(model), 0.0416, 0.9, 0.2, surface_levels, 8);
  }();
  return result;
}

}  // namespace delcert::checker_tests
