#include "tests/checker/hypersurface_oracle.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <stdexcept>
#include <vector>

#include "kernel/chart/ambient_grid.hpp"
#include "kernel/formula/formula_map.hpp"
#include "kernel/number/exact_text.hpp"
#include "tests/checker/plane_stars.hpp"
#include "tests/checker/support/certificate_text.hpp"

namespace delcert::checker_tests {
namespace {

using namespace plane;

double number(const Json& value) { return approximate_double(parse_exact(value.get<std::string>())); }

/// A point p + s·d of M, and the normal there.
struct Hit {
  double s = 0;
  Place normal{};
  int facet = 0;  ///< where it is; 0 of a sphere
};

class Manifold {
 public:
  Manifold() = default;
  Manifold(const Manifold&) = delete;
  Manifold& operator=(const Manifold&) = delete;
  virtual ~Manifold() = default;
  [[nodiscard]] virtual std::vector<Hit> hits(const Place& p, const Place& d) const = 0;
  [[nodiscard]] virtual std::vector<Place> samples() const = 0;
  [[nodiscard]] virtual bool is_round() const = 0;
};

/// The unit sphere of dimension 1 or 2.
class RoundSphere final : public Manifold {
 public:
  explicit RoundSphere(std::size_t m) : m_(m) {}
  [[nodiscard]] std::vector<Hit> hits(const Place& p, const Place& d) const override {
    // s with |p + sd| = 1, the smaller one without cancellation.
    const double a = dot(d, d), b = dot(p, d), c = dot(p, p) - 1;
    if (b * b < a * c || a == 0) return {};
    const double q = -(b + std::copysign(std::sqrt(b * b - a * c), b));
    std::vector<Hit> result;
    for (const double s : {q == 0 ? 0 : c / q, q / a}) result.push_back({s, unit(p + s * d), 0});
    return result;
  }
  [[nodiscard]] std::vector<Place> samples() const override {
    constexpr int count = 1000;
    std::vector<Place> result;
    for (int k = 0; k < count; ++k) {
      const double turn = m_ == 1 ? two_pi * k / count : two_pi * k * 0.6180339887498949;
      const double z = m_ == 1 ? 0 : 2 * (k + 0.5) / count - 1, flat = std::sqrt(1 - z * z);
      result.push_back({flat * std::cos(turn), flat * std::sin(turn), z});
    }
    return result;
  }
  [[nodiscard]] bool is_round() const override { return true; }

 private:
  std::size_t m_;
};

class Polyhedron final : public Manifold {
 public:
  /// `height`: how far from a place facets are looked for.
  Polyhedron(const Json& manifold, double height) : reach_(std::clamp(height * 1.001, 0.125, 1.0)) {
    std::vector<Place> vertices;
    for (const Json& x : manifold.at("mesh")) vertices.push_back({number(x.at(0)), number(x.at(1)), number(x.at(2))});
    for (const Json& facet : manifold.at("facets")) {
      const std::array<std::size_t, 3> corners = {facet.at(0), facet.at(1), facet.at(2)};
      for (std::size_t k = 0; k < 3; ++k) ++sides_[{corners[k], corners[(k + 1) % 3]}];
      Facet& added = facets_.emplace_back(
          Facet{vertices.at(corners[0]), vertices.at(corners[1]), vertices.at(corners[2]), {}, {}, 0});
      added.middle = 1.0 / 3 * (added.a + added.b + added.c);
      for (const Place& corner : {added.a, added.b, added.c})
        added.radius = std::max(added.radius, length(corner - added.middle) * 1.001);
      added.normal = unit(cross(added.b - added.a, added.c - added.a));
      if (!(length(added.middle) < 100)) throw std::invalid_argument("a mesh that is not near the origin");
      largest_ = std::max(largest_, added.radius);
      middles_.insert(added.middle.data());
    }
  }
  /// Each side once in each direction.
  [[nodiscard]] bool is_closed() const {
    return std::all_of(sides_.begin(), sides_.end(), [&](const auto& side) {
      const auto other = sides_.find({side.first.second, side.first.first});
      return side.second == 1 && other != sides_.end();
    });
  }
  [[nodiscard]] std::vector<Hit> hits(const Place& p, const Place& d) const override {
    constexpr double rim = 1e-9;
    std::vector<Hit> result;
    for (const std::size_t at : near(p)) {
      const Facet& facet = facets_[at];
      const double down = dot(facet.normal, d);
      if (down == 0) continue;
      const double s = dot(facet.normal, facet.a - p) / down;
      const Place x = p + s * d;
      const auto side = [&](const Place& from, const Place& to) {
        return dot(facet.normal, cross(to - from, x - from)) / length(to - from);
      };
      if (side(facet.a, facet.b) < -rim || side(facet.b, facet.c) < -rim || side(facet.c, facet.a) < -rim) continue;
      // On an edge it is in both facets.
      if (std::none_of(result.begin(), result.end(), [&](const Hit& hit) { return std::fabs(hit.s - s) < rim; }))
        result.push_back({s, facet.normal, static_cast<int>(at)});
    }
    return result;
  }
  [[nodiscard]] std::vector<Place> samples() const override {
    std::vector<Place> result;
    for (const Facet& facet : facets_) result.push_back(facet.middle);
    return result;
  }
  [[nodiscard]] bool is_round() const override { return false; }

 private:
  struct Facet {
    Place a, b, c, middle, normal;
    double radius;
  };
  /// The facets whose points may be within the reach.
  [[nodiscard]] std::vector<std::size_t> near(const Place& p) const {
    std::vector<std::size_t> result;
    if (!std::isfinite(length(p)) || length(p) > 4) return result;
    middles_.visit(p.data(), reach_ + largest_, [&](std::uint32_t at, double) {
      result.push_back(at);
      return false;
    });
    return result;
  }
  std::map<std::pair<std::size_t, std::size_t>, int> sides_;
  std::vector<Facet> facets_;
  double reach_;
  double largest_ = 0;
  AmbientGrid middles_{3, 0.25};
};

struct Chart {
  Place centre{}, normal{};
  std::array<Place, 2> tangent{};
  double weight = 0, radius = 0, height = 0;
  Flat home{};
  Place vertex{};  // p′

  [[nodiscard]] Flat across(const Place& p) const { return {dot(tangent[0], p - centre), dot(tangent[1], p - centre)}; }
  [[nodiscard]] double above(const Place& p) const { return dot(normal, p - centre); }
  [[nodiscard]] Place at(const Flat& y, double z) const {
    return centre + y[0] * tangent[0] + y[1] * tangent[1] + z * normal;
  }
  [[nodiscard]] bool contains(const Place& p) const { return size(across(p)) < radius && std::fabs(above(p)) < height; }
  /// Of M over y in the closed cylinder; none unless there is exactly one.
  [[nodiscard]] std::optional<Hit> zero(const Manifold& manifold, const Flat& y) const {
    std::optional<Hit> result;
    for (const Hit& hit : manifold.hits(at(y, 0), normal)) {
      if (std::fabs(hit.s) > height * (1 - slack)) continue;
      if (result) return std::nullopt;
      result = hit;
    }
    return result;
  }
  /// W = NY.
  [[nodiscard]] Place fibre() const { return weight * normal; }
};

/// The certificate, read.
struct Reading {
  std::size_t m;
  std::vector<Chart> charts;
  std::vector<Simplex> simplices;
  double slope, epsilon, perturbation, distortion;
  std::vector<Flat> box;  // from, to

  explicit Reading(const Json& j)
      : m(j.at("manifold").at("dimension").get<std::size_t>()),
        slope(number(j.at("manifold").at("slope"))),
        epsilon(number(j.at("parameters").at("sampling_radius"))),
        perturbation(number(j.at("parameters").at("perturbation"))),
        distortion(number(j.at("parameters").at("distortion"))) {
    if (j.at("manifold").contains("box")) {
      for (const Json& side : j.at("manifold").at("box")) box.push_back({number(side.at(0)), number(side.at(1))});
    }
    for (std::size_t i = 0; i < j.at("charts").size(); ++i)
      charts.push_back(chart_of(j.at("net").at(i), j.at("charts").at(i), j.at("points").at(i)));
    for (const Json& row : j.at("simplices")) {
      Simplex& simplex = simplices.emplace_back();
      for (std::size_t k = 0; k <= m; ++k) simplex.push_back(row.at(k));
    }
  }

 private:
  [[nodiscard]] Chart chart_of(const Json& centre, const Json& row, const Json& home) const {
    const std::size_t n = m + 1;
    Chart chart;
    for (std::size_t axis = 0; axis < n; ++axis) chart.centre[axis] = number(centre.at(axis));
    for (std::size_t k = 0; k < m; ++k) chart.home[k] = number(home.at(k));
    // A x = v × x, so that (1 + A)⁻¹ x = (x + (v·x)v − v × x)/(1 + |v|²), and T = 2(1 + A)⁻¹ − 1.
    std::array<double, 3> a{};
    for (std::size_t k = 0; k < n * (n - 1) / 2; ++k) a[k] = number(row.at(n + k));
    const Place v = n == 2 ? Place{0, 0, -a[0]} : Place{-a[2], a[1], -a[0]};
    const auto column = [&](std::size_t k) {
      const double axis = number(row.at(k));
      Place e{};
      e.at(static_cast<std::size_t>(std::fabs(axis)) - 1) = axis < 0 ? -1 : 1;
      return 2 / (1 + dot(v, v)) * (e + dot(v, e) * v - cross(v, e)) - e;
    };
    for (std::size_t k = 0; k < m; ++k) chart.tangent[k] = column(k);
    chart.normal = column(m);
    const std::size_t next = n + n * (n - 1) / 2;
    chart.weight = number(row.at(next));
    chart.radius = number(row.at(next + 1));
    chart.height = number(row.at(next + 2));
    return chart;
  }
};

class Oracle {
 public:
  Oracle(const Json& j, const Manifold& manifold)
      : j_(j), c_(j), manifold_(manifold), samples_(manifold.samples()), stars_(c_.m, c_.simplices, c_.charts.size()) {}

  std::string fault() {
    if (auto found = of_charts(); !found.empty()) return found;
    for (Chart& chart : c_.charts) {
      const auto hit = chart.zero(manifold_, chart.home);
      if (!hit) return "a point that is not there";
      chart.vertex = chart.at(chart.home, hit->s);
    }
    if (auto found = of_cover(); !found.empty()) return found;
    for (std::size_t i = 0; i < c_.charts.size(); ++i) {
      View& view = stars_.views[i];
      view.home = c_.charts[i].home;
      view.patch = c_.charts[i].radius;
      for (std::size_t k = 0; k < c_.charts.size(); ++k) {
        if (c_.charts[i].contains(c_.charts[k].vertex)) view.shown[k] = c_.charts[i].across(c_.charts[k].vertex);
      }
    }
    const Json& levels = j_.at("levels");
    const std::vector<std::pair<const char*, std::string (Oracle::*)(const Json&) const>> rules = {
        {"1", &Oracle::of_level_1}, {"2", &Oracle::of_level_2},   {"2s", &Oracle::of_level_2s},
        {"5", &Oracle::of_level_5}, {"5i", &Oracle::of_level_5i}, {"4", &Oracle::of_level_4},
        {"6", &Oracle::of_level_6}};
    for (const auto& [level, rule] : rules) {
      if (!levels.contains(level)) continue;
      if (auto found = (this->*rule)(levels.at(level)); !found.empty()) return std::string(level) + ": " + found;
    }
    return "";
  }

 private:
  /// Chart coordinates in directions around 0 at this distance.
  [[nodiscard]] std::vector<Flat> around(double distance) const {
    const int directions = c_.m == 1 ? 2 : 6;
    std::vector<Flat> result;
    for (int k = 0; k < directions; ++k)
      result.push_back(
          {distance * std::cos(two_pi * k / directions), c_.m == 1 ? 0 : distance * std::sin(two_pi * k / directions)});
    return result;
  }

  std::string of_charts() const {
    const int steps = c_.m == 1 ? 24 : 6;
    for (const Chart& chart : c_.charts) {
      for (std::size_t axis = 0; axis < c_.box.size(); ++axis) {
        const double wide = chart.radius * std::hypot(chart.tangent[0][axis], chart.tangent[1][axis]) +
                            chart.height * std::fabs(chart.normal[axis]);
        if (!(chart.centre[axis] - wide > c_.box[axis][0] && chart.centre[axis] + wide < c_.box[axis][1]))
          return "a cylinder outside of the box";
      }
      for (const double z : {-chart.height, chart.height}) {
        const double gradient = 2 * dot(chart.at({}, z), chart.normal);
        if (manifold_.is_round() && !(std::fabs(1 - chart.weight * gradient) < 1 + slack)) return "fibres";
      }
      const auto z0 = chart.zero(manifold_, {});
      if (!z0) return "no point over a centre";
      if (!(std::fabs(z0->s) + 9.0 / 16 * c_.slope * chart.radius < chart.height * (1 + slack)))
        if (manifold_.is_round()) return "a lid";
      for (int step = 1; step <= steps; ++step) {
        const double s = static_cast<double>(step) / steps;
        for (const Flat& y : around(chart.radius * s * (1 - slack))) {
          const auto hit = chart.zero(manifold_, y);
          if (!hit) return "no graph";
          if (!manifold_.is_round()) {
            if (steepness(chart, hit->normal) > c_.slope * (1 + slack)) return "a slope";
            continue;
          }
          const double half = c_.slope * chart.radius * (2 * s + 7 * s * s) / 16;
          for (const double part : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
            const double steep = steepness(chart, chart.at(y, z0->s + part * half));
            if (!(steep <= c_.slope * (1 + 7 * s) / 8 * (1 + slack) + slack)) return "a slope";
          }
        }
      }
      if (!(size(chart.home) < chart.radius)) return "a point outside of its chart";
    }
    if (!((1 + c_.distortion) * (1 + c_.distortion) >= 1 + c_.slope * c_.slope - slack)) return "distortion";
    return "";
  }
  /// Of M in the chart where it has this normal.
  static double steepness(const Chart& chart, const Place& normal) {
    return std::hypot(dot(normal, chart.tangent[0]), dot(normal, chart.tangent[1])) /
           std::fabs(dot(normal, chart.normal));
  }

  std::string of_cover() const {
    for (const Place& p : samples_) {
      if (std::none_of(c_.charts.begin(), c_.charts.end(), [&](const Chart& chart) { return chart.contains(p); }))
        return "a point in no cylinder";
    }
    return "";
  }

  std::string of_level_1(const Json& level) const {
    return stars_.fault_of_level_1(level, c_.perturbation * c_.epsilon);
  }
  std::string of_level_2(const Json& level) const { return stars_.fault_of_level_2(level); }
  std::string of_level_2s(const Json& level) const { return stars_.fault_of_level_2s(level); }

  /// A point of a simplex, what it is moved by, how often W that is, and where it comes to.
  struct Moved {
    Place x, by;
    double s = 0;
    Hit hit;
  };
  [[nodiscard]] std::optional<Moved> moved(const Simplex& simplex, const std::vector<double>& t) const {
    Place x{}, w{};
    for (std::size_t k = 0; k < simplex.size(); ++k) {
      x = x + t[k] * c_.charts[simplex[k]].vertex;
      w = w + t[k] * c_.charts[simplex[k]].fibre();
    }
    std::optional<Moved> result;
    for (const Hit& hit : manifold_.hits(x, w)) {
      if (!result || std::fabs(hit.s) < std::fabs(result->s)) result = Moved{x, hit.s * w, hit.s, hit};
    }
    return result;
  }
  /// At a grid of points.
  const std::vector<Moved>& moved(const Simplex& simplex) const {
    const auto [found, is_new] = moved_.try_emplace(&simplex);
    if (is_new) found->second = moved_now(simplex);
    return found->second;
  }
  [[nodiscard]] std::vector<Moved> moved_now(const Simplex& simplex) const {
    const int steps = c_.m == 1 ? 16 : 3;
    std::vector<Moved> result;
    for (int a = 0; a <= steps; ++a) {
      for (int b = 0; b <= (c_.m == 1 ? 0 : steps - a); ++b) {
        const double u = static_cast<double>(a) / steps, v = static_cast<double>(b) / steps;
        std::vector<double> t = {1 - u - v, u};
        if (c_.m == 2) t.push_back(v);
        if (auto found = moved(simplex, t)) result.push_back(*found);
      }
    }
    return result;
  }

  std::string of_level_5(const Json& level) const {
    const double gamma = number(level.at("contraction")), omega = number(level.at("displacement"));
    const std::size_t grid = c_.m == 1 ? 17 : 10;
    double angle = 0;
    for (const Simplex& simplex : c_.simplices) {
      const std::vector<Moved>& points = moved(simplex);
      if (points.size() != grid) return "a point that goes nowhere";
      for (const Moved& point : points) {
        if (length(point.by) > omega * (1 + slack) + slack) return "displacement";
        for (const std::size_t i : simplex) {
          const Chart& chart = c_.charts[i];
          if (!(size(chart.across(point.x)) + omega < chart.radius * (1 + slack))) return "fibre, disc";
          if (!(std::fabs(chart.above(point.x)) + omega < chart.height * (1 + slack))) return "fibre, lid";
        }
      }
      for (std::size_t k = 1; k < points.size(); ++k) {
        for (const std::size_t i : simplex) {
          const Chart& chart = c_.charts[i];
          const Place by = points[k].by - points[k - 1].by, way = points[k].x - points[k - 1].x;
          const Flat change = {dot(chart.tangent[0], by), dot(chart.tangent[1], by)};
          const Flat across = {dot(chart.tangent[0], way), dot(chart.tangent[1], way)};
          if (size(change) > gamma * size(across) + slack) return "contraction";
        }
      }
      angle += angle_of(simplex);
    }
    // Every simplex once around, and once only.
    return std::fabs(angle - (c_.m == 1 ? two_pi : 2 * two_pi)) > 1e-6 ? "not once around" : "";
  }
  /// Seen from the origin.
  [[nodiscard]] double angle_of(const Simplex& simplex) const {
    const Place a = unit(c_.charts[simplex[0]].vertex), b = unit(c_.charts[simplex[1]].vertex);
    if (c_.m == 1) return std::atan2(length(cross(a, b)), dot(a, b));
    return std::fabs(solid_angle(a, b, unit(c_.charts[simplex[2]].vertex)));
  }

  /// Of pairs of simplices it knows what follows from the rules: how far they are apart, how high stars are.
  std::string of_level_5i(const Json& level) const {
    if (level.contains("cosine")) return of_normals(number(level.at("cosine")));
    const Json& five = j_.at("levels").at("5");
    const double gamma = number(five.at("contraction")), omega = number(five.at("displacement"));
    const double margin = number(level.at("margin"));
    std::vector<bool> is_roomy(c_.charts.size(), true);
    std::vector<double> altitudes(c_.charts.size(), 10);
    std::vector<const Simplex*> all;
    for (std::size_t i = 0; i < c_.charts.size(); ++i) {
      const Chart& chart = c_.charts[i];
      double side = 0;
      for (const Simplex* simplex : stars_.star(i)) {
        if ((*simplex)[0] == i) all.push_back(simplex);
        const std::vector<Moved>& points = moved(*simplex);
        for (const std::size_t v : *simplex) {
          if (!(std::fabs(chart.above(c_.charts[v].vertex)) + 3 * omega < chart.height * (1 + slack)))
            is_roomy[i] = false;
          const Place w = c_.charts[v].fibre();
          for (const Moved& point : points)
            side = std::max(side, std::hypot(dot(chart.tangent[0], w), dot(chart.tangent[1], w)) * std::fabs(point.s));
        }
        altitudes[i] = std::min(altitudes[i], altitude_at(i, *simplex));
      }
      // What is sampled is half of what is claimed, at most.
      if (!((1 - gamma) * altitudes[i] / static_cast<double>(c_.m + 1) - side >= margin - slack)) is_roomy[i] = false;
    }
    const auto has_room = [&](const Simplex* simplex) {
      return std::all_of(simplex->begin(), simplex->end(), [&](std::size_t i) { return is_roomy[i]; });
    };
    all.erase(std::remove_if(all.begin(), all.end(), has_room), all.end());
    for (const Simplex* one : all) {
      for (const Simplex* other : all) {
        if (one == other) break;
        double most = -1;  // of the altitudes of common labels
        for (const std::size_t i : *one) {
          if (std::find(other->begin(), other->end(), i) != other->end()) most = std::max(most, altitudes[i]);
        }
        if (most >= 0 ? !(most >= margin - slack) : !(gap(*one, *other, margin) >= margin - slack)) return "margin";
      }
    }
    return "";
  }
  /// At points of simplices: gradients of |x|² at angles to their normals, on the side of W at the first vertex.
  [[nodiscard]] std::string of_normals(double cosine) const {
    for (const Simplex& simplex : c_.simplices) {
      const Place a = c_.charts[simplex[0]].vertex, b = c_.charts[simplex[1]].vertex;
      Place normal =
          unit(c_.m == 1 ? Place{b[1] - a[1], a[0] - b[0], 0} : cross(b - a, c_.charts[simplex[2]].vertex - a));
      if (dot(normal, c_.charts[simplex[0]].fibre()) < 0) normal = -1.0 * normal;
      for (const Moved& point : moved(simplex)) {
        if (!(dot(normal, unit(point.x)) >= cosine - slack)) return "cosine";
      }
    }
    return "";
  }
  /// Between points of two simplices, where they are and where they come to; less, if it certainly is this at least.
  [[nodiscard]] double gap(const Simplex& one, const Simplex& other, double enough) const {
    const std::vector<Moved>&here = moved(one), &there = moved(other);
    if (here.empty() || there.empty()) return enough;
    const auto size_of = [](const std::vector<Moved>& points) {
      double result = 0;
      for (const Moved& a : points) result = std::max(result, length(a.x - points[0].x) + length(a.by));
      return result;
    };
    const double apart = length(here[0].x - there[0].x) - size_of(here) - size_of(there);
    if (apart >= enough) return apart;
    double result = 10;
    for (const Moved& a : here) {
      for (const Moved& b : there) {
        const Place now = a.x - b.x;
        result = std::min({result, length(now), length(now + a.by - b.by)});
      }
    }
    return result;
  }
  /// In chart i.
  [[nodiscard]] double altitude_at(std::size_t i, const Simplex& simplex) const {
    const auto x = stars_.corners(i, simplex);
    if (!x) return 10;
    if (x->size() == 2) return size(minus((*x)[0], (*x)[1]));
    const auto at = static_cast<std::size_t>(std::find(simplex.begin(), simplex.end(), i) - simplex.begin());
    const Flat side = minus((*x)[(at + 2) % 3], (*x)[(at + 1) % 3]);
    return std::fabs(turned(side, minus((*x)[at], (*x)[(at + 1) % 3]))) / size(side);
  }

  std::string of_level_4(const Json& level) const {
    const double density = number(level.at("density"));
    const bool is_extrinsic = level.at("metric") != "intrinsic";
    std::vector<double> reaches(c_.charts.size(), 0);
    std::set<Simplex> edges;
    for (const Simplex& simplex : c_.simplices) {
      for (const std::size_t a : simplex) {
        for (const std::size_t b : simplex) edges.insert({a, b});
      }
    }
    for (const Place& x : samples_) {
      std::vector<std::pair<double, std::size_t>> near;
      for (std::size_t i = 0; i < c_.charts.size(); ++i) near.emplace_back(length(c_.charts[i].vertex - x), i);
      std::partial_sort(near.begin(), near.begin() + 3, near.end());
      if (near[0].first > density * (1 + slack)) return "density";
      reaches[near[0].second] = std::max(reaches[near[0].second], near[0].first);
      const bool is_near_tie = near[2].first - near[1].first < 1e-6;
      if (is_extrinsic && !is_near_tie && edges.count({near[0].second, near[1].second}) == 0) return "edges";
    }
    for (std::size_t i = 0; i < c_.charts.size(); ++i) {
      const Chart& chart = c_.charts[i];
      if (!(size(chart.home) + reaches[i] < chart.radius * (1 + slack))) return "patch";
      if (is_extrinsic && !(std::fabs(chart.above(chart.vertex)) + reaches[i] < chart.height * (1 + slack)))
        return "lid";
    }
    // On a sphere simplices are the facets of the convex hull, for both distances.
    if (!manifold_.is_round()) return "";
    for (const Simplex& simplex : c_.simplices) {
      const Place a = c_.charts[simplex[0]].vertex, b = c_.charts[simplex[1]].vertex;
      Place outwards = c_.m == 1 ? Place{b[1] - a[1], a[0] - b[0], 0} : cross(b - a, c_.charts[simplex[2]].vertex - a);
      outwards = std::copysign(1 / length(outwards), dot(outwards, a)) * outwards;
      for (std::size_t i = 0; i < c_.charts.size(); ++i) {
        if (std::count(simplex.begin(), simplex.end(), i) > 0) continue;
        if (dot(outwards, c_.charts[i].vertex - a) > slack) return "simplices";
      }
    }
    return "";
  }

  std::string of_level_6(const Json& level) const {
    const double least = number(level.at("bilipschitz").at(0)), most = number(level.at("bilipschitz").at(1));
    const double normal = number(level.at("normal"));
    if (level.at("self_delaunay") != (c_.m == 2)) return "self-Delaunay";
    if (c_.m == 2 && least_weight() < number(level.at("weight")) - slack) return "weight";
    for (const Simplex& simplex : c_.simplices) {
      const Place a = c_.charts[simplex[0]].vertex, b = c_.charts[simplex[1]].vertex;
      const Place across = c_.m == 1 ? Place{} : unit(cross(b - a, c_.charts[simplex[2]].vertex - a));
      const std::vector<Moved>& points = moved(simplex);
      for (std::size_t k = 0; k < points.size(); ++k) {
        const Hit& hit = points[k].hit;
        const double sine = c_.m == 1 ? std::fabs(dot(unit(b - a), hit.normal)) : length(cross(across, hit.normal));
        if (sine > normal * (1 + slack) + slack) return "normal";
        if (k == 0) continue;
        const Moved &to = points[k], &from = points[k - 1];
        const double chord = length(to.x + to.by - from.x - from.by);
        const double way = manifold_.is_round() ? 2 * std::asin(std::min(chord / 2, 1.0)) : chord;
        const double ratio = way / length(to.x - from.x);
        // Between two facets the chord is shorter than the way on M.
        const bool is_way = manifold_.is_round() || to.hit.facet == from.hit.facet;
        if ((is_way && ratio < least - slack) || ratio > most + slack) return "bilipschitz";
      }
    }
    return "";
  }
  /// Of cot α + cot β at edges.
  [[nodiscard]] double least_weight() const {
    std::map<Simplex, double> weights;
    for (const Simplex& simplex : c_.simplices) {
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t i = simplex[(k + 1) % 3], j = simplex[(k + 2) % 3];
        const Place apex = c_.charts[simplex[k]].vertex;
        const Place u = c_.charts[i].vertex - apex, v = c_.charts[j].vertex - apex;
        weights[{std::min(i, j), std::max(i, j)}] += dot(u, v) / length(cross(u, v));
      }
    }
    double result = 1e9;
    for (const auto& [edge, weight] : weights) result = std::min(result, weight);
    return result;
  }

  const Json& j_;
  Reading c_;
  const Manifold& manifold_;
  std::vector<Place> samples_;
  Stars stars_;
  mutable std::map<const Simplex*, std::vector<Moved>> moved_;
};

}  // namespace

std::string fault_of_hypersurface(const std::string& text) {
  const Json j = Json::parse(text);
  const Json& manifold = j.at("manifold");
  if (manifold.at("vertices") != "manifold") return "another kind of vertices";
  if (manifold.contains("mesh")) {
    double height = 0;
    for (const Json& row : j.at("charts")) height = std::max(height, number(row.back()));
    const Polyhedron polyhedron(manifold, height);
    if (!polyhedron.is_closed()) return "a mesh that is not closed";
    return Oracle(j, polyhedron).fault();
  }
  const auto variables = manifold.at("variables").get<std::vector<std::string>>();
  const auto equations = manifold.at("equations").get<std::vector<std::string>>();
  const std::size_t m = manifold.at("dimension");
  const std::vector<std::string> expected = {m == 1 ? "x^2+y^2-1" : "x^2+y^2+z^2-1"};
  if (FormulaMap(variables, equations).canonical_texts() != expected || variables.size() != m + 1)
    return "another zero set";
  return Oracle(j, RoundSphere(m)).fault();
}

}  // namespace delcert::checker_tests
