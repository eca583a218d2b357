#include "tests/checker/support/space_form_model.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <stdexcept>

#include "tests/checker/support/edge_path.hpp"

namespace delcert::checker_tests {
namespace {

double squared(std::size_t m, const Point& a) {
  double sum = 0;
  for (std::size_t k = 0; k < m; ++k) sum += a[k] * a[k];
  return sum;
}

double dot(std::size_t m, const Point& a, const Point& b) {
  double sum = 0;
  for (std::size_t k = 0; k < m; ++k) sum += a[k] * b[k];
  return sum;
}

Point combined(const Point& a, double t, const Point& b) {
  return {a[0] + t * b[0], a[1] + t * b[1], a[2] + t * b[2], a[3] + t * b[3]};
}

/// The frame of the point with conformal coordinates -a is the inverse of that of a.
Point framed(int K, std::size_t m, const Point& a, double direction, const Point& x) {
  const Point p = linear_of(K, m, a);
  Point y{};
  double along = 0;
  for (std::size_t k = 0; k < m; ++k) along += p[k + 1] * x[k + 1];
  y[0] = K == 0 ? x[0] : p[0] * x[0] - direction * K * along;
  for (std::size_t k = 0; k < m; ++k)
    y[k + 1] = x[k + 1] + direction * p[k + 1] * x[0] - (K == 0 ? 0 : K * a[k] * along / 2);
  return y;
}

double log_factor(int K, double length) {  // of conformal coordinates
  const double half = length / 2;
  if (K == 0 || half < 1e-8) return 1;
  return (K > 0 ? std::atan(half) : std::atanh(half)) / half;
}

Point exponential(int K, std::size_t m, const Point& v) {
  const double s = std::sqrt(squared(m, v));
  Point x{1, 0, 0, 0};
  double factor = 1;
  if (K != 0 && s > 0) {
    x[0] = K > 0 ? std::cos(s) : std::cosh(s);
    factor = (K > 0 ? std::sin(s) : std::sinh(s)) / s;
  }
  for (std::size_t k = 0; k < m; ++k) x[k + 1] = factor * v[k];
  return x;
}

struct Ball {
  Point centre{};
  double radius = 0;
  double determinant = 0;  // of the edge vectors
};

/// The circumscribing sphere, by Cramer's rule.
Ball circumball(std::size_t m, const std::vector<Point>& x) {
  std::array<std::array<double, 3>, 3> a{};
  std::array<double, 3> b{};
  for (std::size_t i = 0; i < m; ++i) {
    const Point e = combined(x[i + 1], -1, x[0]);
    for (std::size_t k = 0; k < m; ++k) a[i][k] = e[k];
    b[i] = squared(m, e) / 2;
  }
  const auto determinant = [m](const std::array<std::array<double, 3>, 3>& t) {
    if (m == 2) return t[0][0] * t[1][1] - t[0][1] * t[1][0];
    return t[0][0] * (t[1][1] * t[2][2] - t[1][2] * t[2][1]) - t[0][1] * (t[1][0] * t[2][2] - t[1][2] * t[2][0]) +
           t[0][2] * (t[1][0] * t[2][1] - t[1][1] * t[2][0]);
  };
  Ball ball;
  ball.determinant = determinant(a);
  Point c{};
  for (std::size_t k = 0; k < m; ++k) {
    auto t = a;
    for (std::size_t i = 0; i < m; ++i) t[i][k] = b[i];
    c[k] = determinant(t) / ball.determinant;
  }
  ball.radius = std::sqrt(squared(m, c));
  ball.centre = combined(x[0], 1, c);
  return ball;
}

/// Least altitude over m times the longest edge.
double thickness(std::size_t m, const std::vector<Point>& x) {
  double longest = 0, least = 1e9;
  for (const Point& p : x) {
    for (const Point& q : x) longest = std::max(longest, std::sqrt(squared(m, combined(p, -1, q))));
  }
  for (std::size_t apex = 0; apex <= m; ++apex) {
    std::vector<Point> y = x;
    std::swap(y[0], y[apex]);
    // Gram and Schmidt on the facet opposite to y_0.
    Point rest = combined(y[0], -1, y[1]);
    std::vector<Point> basis;
    for (std::size_t k = 2; k <= m; ++k) {
      Point e = combined(y[k], -1, y[1]);
      for (const Point& u : basis) e = combined(e, -dot(m, e, u), u);
      basis.push_back(combined({}, 1 / std::sqrt(squared(m, e)), e));
    }
    for (const Point& u : basis) rest = combined(rest, -dot(m, rest, u), u);
    least = std::min(least, std::sqrt(squared(m, rest)));
  }
  return least / (static_cast<double>(m) * longest);
}

struct Shown {
  int label;
  Point conformal, chart;
};

/// All lifts of the perturbed points and what the chart of a label shows of them.
class Atlas {
 public:
  explicit Atlas(const SpaceFormModel& model) : model_(model) {
    double farthest = 0;
    for (const Point& a : model.net)
      farthest = std::max(farthest, distance_from_origin(model.K, model.m, linear_of(model.K, model.m, a)));
    for (std::size_t j = 0; j < model.size(); ++j) {
      const Point x = framed(model.K, model.m, model.net[j], 1, exponential(model.K, model.m, model.vectors[j]));
      for (const Isometry& g : model.elements) {
        const Point y = image(model.m, g, x);
        if (distance_from_origin(model.K, model.m, y) < farthest + 6 * model.epsilon)
          lifts_.emplace_back(static_cast<int>(j), y);
      }
    }
  }

  std::vector<Shown> around(std::size_t i, double radius) const {
    const std::size_t m = model_.m;
    std::vector<Shown> result;
    for (const auto& [label, x] : lifts_) {
      const Point y = framed(model_.K, m, model_.net[i], -1, x);
      if (distance_from_origin(model_.K, m, y) > radius) continue;
      const Point a = conformal_of(m, y);
      result.push_back({label, a, combined({}, log_factor(model_.K, std::sqrt(squared(m, a))), a)});
    }
    return result;
  }

 private:
  const SpaceFormModel& model_;
  std::vector<std::pair<int, Point>> lifts_;
};

/// The star of i among the points of its chart.
std::vector<Labels> star_of(const SpaceFormModel& model, const std::vector<Shown>& shown, int i) {
  const std::size_t m = model.m;
  const Shown* centre = nullptr;
  for (const Shown& s : shown) {
    if (s.label == i) centre = &s;
  }
  std::vector<const Shown*> near;
  for (const Shown& s : shown) {
    if (&s != centre && std::sqrt(squared(m, combined(s.chart, -1, centre->chart))) < 2.6 * model.epsilon)
      near.push_back(&s);
  }
  std::vector<Labels> star;
  const auto consider = [&](const std::vector<const Shown*>& others) {
    std::vector<Point> x{centre->chart};
    Labels labels;
    for (const Shown* s : others) {
      x.push_back(s->chart);
      labels.push_back(s->label);
    }
    const Ball ball = circumball(m, x);
    if (std::fabs(ball.determinant) < 1e-7 * std::pow(model.epsilon, static_cast<double>(m))) return;
    if (ball.radius > 1.3 * model.epsilon) return;
    for (const Shown* s : near) {
      if (std::find(others.begin(), others.end(), s) == others.end() &&
          squared(m, combined(s->chart, -1, ball.centre)) < ball.radius * ball.radius)
        return;
    }
    std::sort(labels.begin(), labels.end());
    star.push_back(labels);
  };
  for (std::size_t a = 0; a < near.size(); ++a) {
    for (std::size_t b = a + 1; b < near.size(); ++b) {
      if (m == 2) consider({near[a], near[b]});
      for (std::size_t d = b + 1; m == 3 && d < near.size(); ++d) consider({near[a], near[b], near[d]});
    }
  }
  std::sort(star.begin(), star.end());
  return star;
}

Labels with(const Labels& others, int i) {
  Labels all = others;
  all.push_back(i);
  std::sort(all.begin(), all.end());
  return all;
}

/// The labels of simplices that some star lacks.
std::set<int> in_disagreement(const std::vector<std::vector<Labels>>& stars) {
  std::vector<std::set<Labels>> sets(stars.size());
  for (std::size_t i = 0; i < stars.size(); ++i) {
    for (const Labels& others : stars[i]) sets[i].insert(with(others, static_cast<int>(i)));
  }
  std::set<int> result;
  for (const auto& set : sets) {
    for (const Labels& simplex : set) {
      for (const int j : simplex) {
        if (!sets[static_cast<std::size_t>(j)].contains(simplex)) result.insert(simplex.begin(), simplex.end());
      }
    }
  }
  return result;
}

/// The labels of triangles near j that do not stand clear of another label in the chart of j.
std::set<int> unclear(const SpaceFormModel& model, const std::vector<Shown>& shown, int j) {
  const std::size_t m = model.m;
  std::set<int> result, centres{j};
  std::vector<Point> place(model.size());
  for (const Shown& s : shown) place[static_cast<std::size_t>(s.label)] = s.chart;
  for (const Labels& others : model.stars[static_cast<std::size_t>(j)]) centres.insert(others.begin(), others.end());
  for (const int i : centres) {
    for (const Labels& others : model.stars[static_cast<std::size_t>(i)]) {
      const Labels all = with(others, i);
      std::vector<Point> x;
      for (const int v : all) x.push_back(place[static_cast<std::size_t>(v)]);
      const Ball ball = circumball(m, x);
      for (const Shown& s : shown) {
        if (std::find(all.begin(), all.end(), s.label) != all.end()) continue;
        if (std::sqrt(squared(m, combined(s.chart, -1, ball.centre))) > ball.radius + 1e-3 * model.epsilon) continue;
        result.insert(all.begin(), all.end());
        result.insert(s.label);
      }
    }
  }
  return result;
}

/// sin r / r, 1, sinh r / r.
double length_ratio(int K, double r) { return K == 0 ? 1 : (K > 0 ? std::sin(r) : std::sinh(r)) / r; }

/// Moves every point at random by at most rho epsilon.
class Mover {
 public:
  Mover(const SpaceFormModel& model, std::uint64_t seed) : model_(model), random_(seed) {}

  Point draw() {
    Point v{};
    do {
      for (std::size_t k = 0; k < model_.m; ++k) v[k] = dyadic(0.99 * model_.rho * model_.epsilon * uniform());
    } while (squared(model_.m, v) > std::pow(0.99 * model_.rho * model_.epsilon, 2));
    return v;
  }
  std::vector<Point> draw_all() {
    std::vector<Point> result;
    for (std::size_t i = 0; i < model_.size(); ++i) result.push_back(draw());
    return result;
  }

 private:
  double uniform() { return static_cast<double>(random_() >> 11) * 0x1p-52 - 1; }

  const SpaceFormModel& model_;
  std::mt19937_64 random_;
};

/// Every star, in its own chart.
void find_stars(SpaceFormModel& model, const Atlas& atlas) {
  model.stars.clear();
  for (std::size_t i = 0; i < model.size(); ++i)
    model.stars.push_back(star_of(model, atlas.around(i, 4 * model.epsilon), static_cast<int>(i)));
}

Point perturbed_point(const SpaceFormModel& model, int i) {
  const auto at = static_cast<std::size_t>(i);
  return framed(model.K, model.m, model.net[at], 1, exponential(model.K, model.m, model.vectors[at]));
}

/// Increases with the distance of two points: -cos d, d^2, cosh d.
double spread(const SpaceFormModel& model, const Point& x, const Point& y) {
  double along = 0, squares = 0;
  for (std::size_t k = 1; k <= model.m; ++k) {
    along += x[k] * y[k];
    squares += (x[k] - y[k]) * (x[k] - y[k]);
  }
  return model.K == 0 ? squares : model.K > 0 ? -x[0] * y[0] - along : x[0] * y[0] - along;
}

Isometry times(const Isometry& a, const Isometry& b) {
  Isometry result{};
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t k = 0; k < 4; ++k) {
      for (std::size_t j = 0; j < 4; ++j) result[i][k] += a[i][j] * b[j][k];
    }
  }
  return result;
}

/// Of an isometry in the standard basis.
Isometry inverse(const SpaceFormModel& model, const Isometry& a) {
  Isometry result{};
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t k = 0; k < 4; ++k) {
      const bool mixed = (i == 0) != (k == 0);
      result[i][k] = mixed ? model.K * a[k][i] : a[k][i];
    }
  }
  for (std::size_t i = 1; i < 4 && model.K == 0; ++i) {
    for (std::size_t k = 1; k < 4; ++k) result[i][0] -= result[i][k] * a[k][0];
  }
  return result;
}

/// The keys from `elements` on.
void add_complex(Json& document, const SpaceFormModel& model) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < model.size(); ++i) points.push_back(perturbed_point(model, static_cast<int>(i)));
  std::vector<MovedSimplex<Isometry>> simplices;
  Json rows = Json::array();
  for (const Labels& labels : simplices_of(model.stars)) {
    simplices.push_back({labels, {model.elements[0]}});
    rows.push_back(labels);
    const Point& first = points[static_cast<std::size_t>(labels[0])];
    for (std::size_t k = 1; k < labels.size(); ++k) {
      const Point& x = points[static_cast<std::size_t>(labels[k])];
      const auto away = [&](const Isometry& g) { return spread(model, image(model.m, g, x), first); };
      const auto nearest = std::min_element(model.elements.begin(), model.elements.end(),
                                            [&](const Isometry& g, const Isometry& h) { return away(g) < away(h); });
      rows.back().push_back(nearest - model.elements.begin());
      simplices.back().motions.push_back(*nearest);
    }
  }
  document["elements"] = model.words;
  document["simplices"] = rows;
  document["loops"] = Json::array();
  for (const Isometry& end : model.letters) {
    const Point target = image(model.m, end, points[0]);
    const auto step = [&](const Isometry& h, const Isometry& a, const Isometry& b) {
      return times(times(h, inverse(model, a)), b);
    };
    const auto remaining = [&](int label, const Isometry& h) {
      return spread(model, image(model.m, h, points[static_cast<std::size_t>(label)]), target);
    };
    const auto at_end = [&](const Isometry& h) {
      double most = 0;
      for (std::size_t i = 0; i <= model.m; ++i) {
        for (std::size_t k = 0; k <= model.m; ++k) most = std::max(most, std::fabs(h[i][k] - end[i][k]));
      }
      return most < 1e-5;
    };
    document["loops"].push_back(edge_path<Isometry>(simplices, model.elements[0], step, remaining, at_end));
  }
}

double tangent(int K, double r) { return K == 0 ? r : K > 0 ? std::tan(r) : std::tanh(r); }

}  // namespace

double dyadic(double x) { return std::floor(x * 0x1p30) * 0x1p-30; }

Point linear_of(int K, std::size_t m, const Point& a) {
  const double D = K * squared(m, a) / 4;
  Point x{(1 - D) / (1 + D), 0, 0, 0};
  for (std::size_t k = 0; k < m; ++k) x[k + 1] = a[k] / (1 + D);
  return x;
}

Point conformal_of(std::size_t m, const Point& x) {
  Point a{};
  for (std::size_t k = 0; k < m; ++k) a[k] = 2 * x[k + 1] / (1 + x[0]);
  return a;
}

Point image(std::size_t m, const Isometry& g, const Point& x) {
  Point y{};
  for (std::size_t i = 0; i <= m; ++i) y[i] = dot(m + 1, g[i], x);
  return y;
}

double distance_from_origin(int K, std::size_t m, const Point& x) {
  double sum = 0;
  for (std::size_t k = 0; k < m; ++k) sum += x[k + 1] * x[k + 1];
  const double side = std::sqrt(sum);
  return K == 0 ? side : K > 0 ? std::atan2(side, x[0]) : std::asinh(side);
}

double transition_distortion(const SpaceFormModel& model) {
  const double across = length_ratio(model.K, 9 * model.epsilon) / length_ratio(model.K, 3 * model.epsilon);
  return (model.K > 0 ? 1 / across : across) - 1;
}

double metric_distortion(const SpaceFormModel& model) {
  return std::fabs(length_ratio(model.K, 6 * model.epsilon) - 1);
}

void perturb_until_stars_agree(SpaceFormModel& model, std::uint64_t seed, bool in_all_charts) {
  Mover mover(model, seed);
  model.vectors = mover.draw_all();
  for (int round = 0; round < 200; ++round) {
    const Atlas atlas(model);
    find_stars(model, atlas);
    std::set<int> bad = in_disagreement(model.stars);
    if (bad.empty() && in_all_charts) {
      for (std::size_t j = 0; j < model.size(); ++j)
        bad.merge(unclear(model, atlas.around(j, 6 * model.epsilon), static_cast<int>(j)));
    }
    if (bad.empty()) return;
    for (const int i : bad) model.vectors[static_cast<std::size_t>(i)] = mover.draw();
  }
  throw std::runtime_error("the stars do not come to agree");
}

SpaceFormMargins roomy_margins(const SpaceFormModel& model) {
  const std::size_t m = model.m;
  const int K = model.K;
  const Atlas atlas(model);
  SpaceFormMargins found;
  found.protection = found.thickness = found.empty = found.riemannian_thickness = found.least_stretch = 1e9;
  std::map<Labels, double> cotangents;  // of the angles opposite to an edge
  for (std::size_t i = 0; i < model.size(); ++i) {
    const std::vector<Shown> shown = atlas.around(i, std::min(6 * model.epsilon, model.injectivity_radius));
    const auto find = [&](int label) {
      return *std::find_if(shown.begin(), shown.end(), [&](const Shown& s) { return s.label == label; });
    };
    const Point own = find(static_cast<int>(i)).conformal;
    std::set<int> around{static_cast<int>(i)};
    // Level 2s is for surfaces.
    for (const Labels& others : model.stars[i]) {
      if (m == 2) around.insert(others.begin(), others.end());
    }
    for (const int j : around) {
      for (const Labels& others : model.stars[static_cast<std::size_t>(j)]) {
        std::vector<Point> chart, flat, perturbed;
        const Labels all = with(others, j);
        for (const int v : all) {
          chart.push_back(find(v).chart);
          flat.push_back(find(v).conformal);
          const Point moved = conformal_of(m, framed(K, m, own, -1, linear_of(K, m, flat.back())));
          perturbed.push_back(combined({}, log_factor(K, std::sqrt(squared(m, moved))), moved));
        }
        const Ball ball = circumball(m, chart);
        found.reach = std::max(found.reach, std::sqrt(squared(m, ball.centre)) + ball.radius);
        if (j != static_cast<int>(i)) continue;
        found.circumradius = std::max(found.circumradius, ball.radius);
        found.thickness = std::min(found.thickness, thickness(m, chart));
        found.riemannian_thickness = std::min(found.riemannian_thickness, thickness(m, perturbed));
        for (const Point& x : perturbed)
          found.riemannian_radius = std::max(found.riemannian_radius, std::sqrt(squared(m, x)));
        const Ball round = circumball(m, flat);
        const double w = 1 + K * (squared(m, round.centre) - round.radius * round.radius) / 4, t = round.radius / w;
        const double rho = K == 0 ? t : K > 0 ? std::atan(t) : std::atanh(t);
        found.ball = std::max(found.ball, rho);
        if (all[0] == j && m == 2) {
          for (std::size_t apex = 0; apex < 3; ++apex) {
            const auto length = [&](std::size_t from, std::size_t to) {
              const Point y = framed(K, m, flat[from], -1, linear_of(K, m, flat[to]));
              return std::pow(distance_from_origin(K, m, y), 2);
            };
            const std::size_t one = (apex + 1) % 3, other = (apex + 2) % 3;
            const double a = length(apex, one), b = length(apex, other), sum = a + b - length(one, other);
            cotangents[{std::min(all[one], all[other]), std::max(all[one], all[other])}] +=
                sum / std::sqrt(4 * a * b - sum * sum);
          }
        }
        for (const Shown& s : shown) {
          if (std::find(all.begin(), all.end(), s.label) != all.end()) continue;
          found.protection =
              std::min(found.protection, std::sqrt(squared(m, combined(s.chart, -1, ball.centre))) - ball.radius);
          // (|q - c|^2 - R^2) / (2 + 2D) is about (d - rho) tan rho w.
          const double power = squared(m, combined(s.conformal, -1, round.centre)) - round.radius * round.radius;
          found.empty = std::min(found.empty, power / (2 + K * squared(m, s.conformal) / 2) / (t * w) / (1 + 2 * t));
        }
      }
    }
  }
  if (m == 2) found.weight = 1e9;
  for (const auto& [edge, sum] : cotangents) found.weight = std::min(found.weight, 0.999 * sum);
  // tan rho^2 bounds all that bends.
  const double bend = std::pow(tangent(1, found.ball), 2);
  found.least_stretch = K == 0 ? 1 : 1 - bend;
  found.greatest_stretch = K == 0 ? 1 : 1 + bend;
  found.protection /= 2;
  found.thickness /= 1.5;
  found.empty /= 4;
  found.riemannian_thickness /= 1.01;
  for (double* upper : {&found.circumradius, &found.reach, &found.ball, &found.riemannian_radius}) *upper *= 1.01;
  return found;
}

Json certificate(const SpaceFormModel& model, const SpaceFormMargins& margins, const std::set<std::string>& levels) {
  const auto text = [](double x) { return at_most(x).text(); };
  const auto points = [&](const std::vector<Point>& list) {
    Json rows = Json::array();
    for (const Point& x : list) {
      Json row = Json::array();
      for (std::size_t k = 0; k < model.m; ++k) row.push_back(text(x[k] / model.frame[k]));
      rows.push_back(row);
    }
    return rows;
  };
  const Json parameters{{"mode", "measured"},
                        {"candidates", "pruned"},
                        {"seed", "7"},
                        {"sampling_radius", text(model.epsilon)},
                        {"separation", text(model.mu)},
                        {"radius_variation", "0"},
                        {"distortion", "0"},
                        {"perturbation", text(model.rho)},
                        {"flake_parameter_squared", "0x1p-120"},
                        {"tolerance", "0x1p-40"}};
  const auto [simplices, euler] = count(model.stars);
  const Json riemannian{{"route", "space-form"},
                        {"thickness", text(margins.riemannian_thickness)},
                        {"radius", text(margins.riemannian_radius)}};
  Json metric{{"self_delaunay", margins.weight >= 0}};
  if (margins.weight >= 0) metric["weight"] = text(margins.weight);
  metric["bilipschitz"] = Json::array({text(margins.least_stretch), text(margins.greatest_stretch)});
  const Json values{{"0", Json{{"density", text(1.001 * margins.ball + model.rho * model.epsilon)},
                               {"distortion", text(1.001 * transition_distortion(model))},
                               {"metric_distortion", text(1.001 * metric_distortion(model))}}},
                    {"1", Json{{"protection", text(margins.protection)},
                               {"thickness", text(margins.thickness)},
                               {"circumradius", text(margins.circumradius)}}},
                    {"2", Json{{"simplices", simplices}, {"euler_characteristic", euler}, {"closed", true}}},
                    {"2s", Json{{"reach", text(margins.reach)}}},
                    {"4", Json{{"protection", text(margins.empty)}, {"circumradius", text(margins.ball)}}},
                    {"5", levels.contains("5r") ? riemannian : Json{{"route", "space-form"}}},
                    {"6", metric}};
  Json claimed = Json::object();
  for (const auto& [name, value] : values.items()) {
    if (levels.contains(name)) claimed[name] = value;
  }
  Json result{{"format", "delcert-certificate"},
              {"version", 2},
              {"software", Json{{"delcert", "test"}}},
              {"manifold", model.manifold},
              {"parameters", parameters},
              {"levels", claimed},
              {"net", points(model.net)},
              {"net_simplices", Json::array()},
              {"points", points(model.vectors)}};
  add_complex(result, model);
  return result;
}

}  // namespace delcert::checker_tests
