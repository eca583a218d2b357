#include "tests/checker/plane_stars.hpp"

#include <algorithm>
#include <set>

#include "kernel/number/exact_text.hpp"

namespace delcert::checker_tests::plane {
namespace {

double value_of(const Json& stated) { return approximate_double(parse_exact(stated.get<std::string>())); }

}  // namespace

Circle circle_through(const std::vector<Flat>& x) {
  if (x.size() == 2) return {{(x[0][0] + x[1][0]) / 2, 0}, std::fabs(x[0][0] - x[1][0]) / 2};
  const Flat u = minus(x[1], x[0]), v = minus(x[2], x[0]);
  const double a = u[0] * u[0] + u[1] * u[1], b = v[0] * v[0] + v[1] * v[1], twice = 2 * turned(u, v);
  const Flat to = {(a * v[1] - b * u[1]) / twice, (b * u[0] - a * v[0]) / twice};
  return {{x[0][0] + to[0], x[0][1] + to[1]}, size(to)};
}
double longest_side(const std::vector<Flat>& x) {
  double result = 0;
  for (std::size_t k = 0; k < x.size(); ++k) result = std::max(result, size(minus(x[k], x[(k + 1) % x.size()])));
  return result;
}
double least_altitude(const std::vector<Flat>& x) {
  if (x.size() == 2) return size(minus(x[0], x[1]));
  return std::fabs(turned(minus(x[1], x[0]), minus(x[2], x[0]))) / longest_side(x);
}

Stars::Stars(std::size_t m, const std::vector<Simplex>& simplices, std::size_t labels)
    : views(labels), m_(m), simplices_(simplices), stars_(labels) {
  for (const Simplex& simplex : simplices) {
    for (const std::size_t label : simplex) stars_.at(label).push_back(&simplex);
  }
}

std::optional<std::vector<Flat>> Stars::corners(std::size_t i, const Simplex& simplex) const {
  std::vector<Flat> result;
  for (const std::size_t label : simplex) {
    const auto found = views[i].shown.find(label);
    if (found == views[i].shown.end()) return std::nullopt;
    result.push_back(found->second);
  }
  return result;
}

/// A label that chart i shows within this distance, and not of the simplex, nearer than this to its circumsphere's
/// inside.
bool Stars::is_disturbed(std::size_t i, const Simplex& simplex, const Circle& ball, double protection,
                         double reach) const {
  for (const auto& [label, x] : views[i].shown) {
    if (std::count(simplex.begin(), simplex.end(), label) > 0 || size(x) > reach * (1 - slack)) continue;
    if (size(minus(x, ball.centre)) < ball.radius + protection - slack) return true;
  }
  return false;
}

std::string Stars::fault_of_level_1(const Json& level, double moved) const {
  const double delta = value_of(level.at("protection")), r = value_of(level.at("circumradius"));
  const double thickness = value_of(level.at("thickness"));
  const double within = moved + 2 * r + delta;
  for (std::size_t i = 0; i < views.size(); ++i) {
    if (size(views[i].home) > moved + slack) return "perturbation";
    if (!(within < views[i].patch * (1 + slack))) return "patch";
    double angle = 0;
    for (const Simplex* simplex : stars_[i]) {
      const auto x = corners(i, *simplex);
      if (!x) return "a vertex that is not shown";
      const Circle ball = circle_through(*x);
      if (!(ball.radius <= r * (1 + slack))) return "circumradius";
      if (!(least_altitude(*x) >= thickness * static_cast<double>(m_) * longest_side(*x) * (1 - slack)))
        return "thickness";
      if (is_disturbed(i, *simplex, ball, delta, within)) return "protection";
      angle += angle_at(i, *simplex, *x);
    }
    if (std::fabs(angle - two_pi) > 1e-6) return "facets";
  }
  return "";
}

/// Of the simplex at label i; half a turn of an edge.
double Stars::angle_at(std::size_t i, const Simplex& simplex, const std::vector<Flat>& x) {
  if (x.size() == 2) return two_pi / 2;
  const auto at = static_cast<std::size_t>(std::find(simplex.begin(), simplex.end(), i) - simplex.begin());
  const Flat u = minus(x[(at + 1) % 3], x[at]), v = minus(x[(at + 2) % 3], x[at]);
  return std::fabs(std::atan2(turned(u, v), u[0] * v[0] + u[1] * v[1]));
}

std::string Stars::fault_of_level_2(const Json& level) const {
  if (level.at("simplices") != simplices_.size() || level.at("closed") != true) return "counts";
  std::set<Simplex> different;
  std::map<Simplex, int> edges;
  for (Simplex simplex : simplices_) {
    std::sort(simplex.begin(), simplex.end());
    different.insert(simplex);
    for (std::size_t k = 0; k < simplex.size(); ++k) {
      for (std::size_t l = 0; l < k; ++l) ++edges[{simplex[l], simplex[k]}];
    }
  }
  if (different.size() != simplices_.size()) return "a simplex twice";
  const int points = static_cast<int>(views.size()), sides = static_cast<int>(edges.size());
  const int triangles = m_ == 1 ? 0 : static_cast<int>(different.size());
  if (level.at("euler_characteristic") != points - sides + triangles) return "Euler characteristic";
  if (m_ == 2 && std::any_of(edges.begin(), edges.end(), [](const auto& edge) { return edge.second != 2; }))
    return "an edge of other than two triangles";
  return "";
}

std::string Stars::fault_of_level_2s(const Json& level) const {
  const double reach = value_of(level.at("reach"));
  for (std::size_t j = 0; j < views.size(); ++j) {
    if (!(reach < views[j].patch)) return "reach";
    std::set<const Simplex*> near;
    for (const Simplex* simplex : stars_[j]) {
      for (const std::size_t i : *simplex) near.insert(stars_[i].begin(), stars_[i].end());
    }
    for (const Simplex* simplex : near) {
      const auto x = corners(j, *simplex);
      if (!x) return "a vertex that is not shown";
      const Circle ball = circle_through(*x);
      if (size(ball.centre) + ball.radius > reach * (1 + slack)) return "a ball beyond the reach";
      if (is_disturbed(j, *simplex, ball, 0, reach)) return "a star";
    }
  }
  return "";
}

}  // namespace delcert::checker_tests::plane
