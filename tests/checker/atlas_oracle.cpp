#include "tests/checker/atlas_oracle.hpp"

#include <algorithm>
#include <array>
#include <map>

#include "kernel/number/exact_text.hpp"
#include "tests/checker/exact_formula.hpp"
#include "tests/checker/plane_stars.hpp"
#include "tests/checker/support/certificate_text.hpp"

namespace delcert::checker_tests {
namespace {

using namespace plane;

Rational exact(const Json& stated) { return parse_exact(stated.get<std::string>()); }
double rough(const Json& stated) { return approximate_double(exact(stated)); }

using Exact = std::vector<Rational>;  // a point of a box
/// From, to, on each axis.
struct Box {
  explicit Box(const Json& sides) {
    for (const Json& side : sides) {
      exactly.push_back({exact(side.at(0)), exact(side.at(1))});
      roughly.push_back({approximate_double(exactly.back()[0]), approximate_double(exactly.back()[1])});
    }
    if (exactly.size() != 2) throw std::invalid_argument("no box of the plane");
  }
  [[nodiscard]] bool contains(const Flat& x) const {
    return roughly[0][0] < x[0] && x[0] < roughly[0][1] && roughly[1][0] < x[1] && x[1] < roughly[1][1];
  }
  [[nodiscard]] bool contains(const Exact& x) const {
    return exactly[0][0] < x[0] && x[0] < exactly[0][1] && exactly[1][0] < x[1] && x[1] < exactly[1][1];
  }
  /// Of a closed box, and nearly.
  [[nodiscard]] bool nearly_contains(const Flat& x) const {
    return roughly[0][0] - slack < x[0] && x[0] < roughly[0][1] + slack && roughly[1][0] - slack < x[1] &&
           x[1] < roughly[1][1] + slack;
  }
  /// Points of a grid of so many by so many, none on a side.
  [[nodiscard]] std::vector<Exact> grid(int steps) const {
    std::vector<Exact> result;
    for (int a = 0; a < steps; ++a) {
      for (int b = 0; b < steps; ++b) result.push_back({at(0, 2 * a + 1, 2 * steps), at(1, 2 * b + 1, 2 * steps)});
    }
    return result;
  }
  std::vector<std::array<Rational, 2>> exactly;
  std::vector<std::array<double, 2>> roughly;

 private:
  [[nodiscard]] Rational at(std::size_t axis, int part, int whole) const {
    return exactly[axis][0] + (exactly[axis][1] - exactly[axis][0]) * Rational(part) / Rational(whole);
  }
};

/// The other chart's coordinates of a point of one.
Flat inverted(const Flat& x) {
  const double squared = x[0] * x[0] + x[1] * x[1];
  return {x[0] / squared, x[1] / squared};
}
Exact inverted(const Exact& x) {
  const Rational squared = square(x[0]) + square(x[1]);
  return {x[0] / squared, x[1] / squared};
}
bool is_origin(const Exact& x) { return x[0] == Rational(0) && x[1] == Rational(0); }
Flat roughly(const Exact& x) { return {approximate_double(x[0]), approximate_double(x[1])}; }

Place on_sphere(std::size_t chart, const Flat& x) {
  const double squared = x[0] * x[0] + x[1] * x[1], up = (squared - 1) / (squared + 1);
  return {2 * x[0] / (squared + 1), 2 * x[1] / (squared + 1), chart == 0 ? up : -up};
}

/// Row by row.
using Square = std::array<double, 4>;
Flat operator*(const Square& a, const Flat& x) { return {a[0] * x[0] + a[1] * x[1], a[2] * x[0] + a[3] * x[1]}; }
Square operator*(const Square& a, const Square& b) {
  return {a[0] * b[0] + a[1] * b[2], a[0] * b[1] + a[1] * b[3], a[2] * b[0] + a[3] * b[2], a[2] * b[1] + a[3] * b[3]};
}
double greatest_stretch(const Square& a) {
  const double sum = a[0] * a[0] + a[1] * a[1] + a[2] * a[2] + a[3] * a[3], area = a[0] * a[3] - a[1] * a[2];
  return std::sqrt((sum + std::sqrt(std::max(sum * sum - 4 * area * area, 0.0))) / 2);
}
Square derivative_of_inversion(const Flat& x) {
  const double squared = x[0] * x[0] + x[1] * x[1], fourth = squared * squared;
  return {(squared - 2 * x[0] * x[0]) / fourth, -2 * x[0] * x[1] / fourth, -2 * x[0] * x[1] / fourth,
          (squared - 2 * x[1] * x[1]) / fourth};
}

struct Chart {
  explicit Chart(const Json& j)
      : variables(j.at("variables").get<std::vector<std::string>>()), domain(j.at("domain")), core(j.at("core")) {}
  std::vector<std::string> variables;
  Box domain, core;
};

struct Transition {
  std::size_t from, to;
  std::vector<std::string> map, inverse, where;
};

struct LabelChart {
  std::size_t home;
  Square to, back;          // A and its inverse
  Flat centre, own, place;  // `own`: y; `place`: of p' in the box of its home
  Flat elsewhere;           // the same in the other box
  Flat reach;               // of its patch, a little more
};

class Oracle {
 public:
  explicit Oracle(const Json& j) : j_(j) {
    const Json& manifold = j.at("manifold");
    for (const Json& chart : manifold.at("charts")) charts_.emplace_back(chart);
    for (const Json& t : manifold.at("transitions")) {
      const auto formulas = [&](const char* key) { return t.at(key).get<std::vector<std::string>>(); };
      transitions_.push_back({t.at("from").get<std::size_t>(), t.at("to").get<std::size_t>(), formulas("map"),
                              formulas("inverse"), formulas("where")});
      if (transitions_.back().from + transitions_.back().to != 1) throw std::invalid_argument("no such charts");
    }
    patch_ = rough(manifold.at("patch_radius"));
    const Json& parameters = j.at("parameters");
    moved_ = rough(parameters.at("perturbation")) * rough(parameters.at("sampling_radius"));
    distortion_ = rough(parameters.at("distortion"));
    for (std::size_t i = 0; i < j.at("charts").size(); ++i) read_label(i);
    for (const Json& row : j.at("simplices")) {
      Simplex& simplex = simplices_.emplace_back();
      for (std::size_t v = 0; v < 3; ++v) simplex.push_back(row.at(v).get<std::size_t>());
    }
  }

  std::string fault() {
    // The same for most.
    static std::map<std::string, std::string> known;
    const auto [at, is_new] = known.try_emplace(j_.at("manifold").dump());
    if (is_new) at->second = of_gluing();
    if (!at->second.empty()) return at->second;
    if (auto found = of_labels(); !found.empty()) return found;
    Stars stars(2, simplices_, labels_.size());
    for (std::size_t i = 0; i < labels_.size(); ++i) {
      View& view = stars.views[i];
      view.home = labels_[i].own;
      view.patch = patch_;
      for (std::size_t k = 0; k < labels_.size(); ++k) {
        const auto seen = shown(labels_[i].home, k);
        if (!seen || !may_show(labels_[i], *seen)) continue;
        const Flat x = labels_[i].to * minus(*seen, labels_[i].centre);
        if (size(x) < patch_ * (1 + slack)) view.shown[k] = x;
      }
    }
    const Json& levels = j_.at("levels");
    const auto said = [&](const char* level, const std::string& found) {
      return found.empty() ? found : level + (": " + found);
    };
    std::string found;
    if (levels.contains("1")) found = said("1", stars.fault_of_level_1(levels.at("1"), moved_));
    if (found.empty() && levels.contains("2")) {
      found = said("2", stars.fault_of_level_2(levels.at("2")));
      if (found.empty() && levels.at("2").contains("homology") &&
          levels.at("2").at("homology") != Json::array({"Z", "0", "Z"}))
        found = "2: homology";
    }
    if (found.empty() && levels.contains("2s")) found = said("2s", stars.fault_of_level_2s(levels.at("2s")));
    if (found.empty() && levels.contains("5")) found = said("5", of_level_5(levels.at("5")));
    return found;
  }

 private:
  void read_label(std::size_t i) {
    const Json &row = j_.at("charts").at(i), &centre = j_.at("net").at(i), &own = j_.at("points").at(i);
    LabelChart label{};
    label.home = exact(row.at(0)) == Rational(0) ? 0 : 1;
    if (label.home == 1 && exact(row.at(0)) != Rational(1)) throw std::invalid_argument("no such home");
    const double a = rough(row.at(1)), b = rough(row.at(2)), d = rough(row.at(3));
    label.to = {a, b, 0, d};
    label.back = {1 / a, -b / (a * d), 0, 1 / d};
    label.centre = {rough(centre.at(0)), rough(centre.at(1))};
    label.own = {rough(own.at(0)), rough(own.at(1))};
    const Flat by = label.back * label.own;
    label.place = {label.centre[0] + by[0], label.centre[1] + by[1]};
    for (std::size_t axis = 0; axis < 2; ++axis)
      label.reach[axis] = 1.001 * patch_ * std::hypot(label.back[2 * axis], label.back[2 * axis + 1]);
    label.elsewhere = inverted(label.place);
    labels_.push_back(label);
  }

  /// The image of a point of the chart `from`, where the transition is defined.
  [[nodiscard]] std::optional<Exact> image(const Transition& t, bool forwards, const Exact& x) const {
    const auto& maps = forwards ? t.map : t.inverse;
    const auto& variables = charts_[forwards ? t.from : t.to].variables;
    Exact result;
    for (const std::string& formula : maps) {
      const auto value = exact_value(formula, variables, x);
      if (!value) return std::nullopt;
      result.push_back(*value);
    }
    return result;
  }
  /// Whether it glues x, of the chart t.from, to its place in the other one.
  [[nodiscard]] bool glues(const Transition& t, const Exact& x) const {
    for (const std::string& condition : t.where) {
      const auto value = exact_value(condition, charts_[t.from].variables, x);
      if (!value || *value <= Rational(0)) return false;
    }
    return image(t, true, x).has_value();
  }

  std::string of_gluing() const {
    constexpr int steps = 24;
    for (std::size_t a = 0; a < 2; ++a) {
      const Chart &here = charts_[a], &there = charts_[1 - a];
      for (std::size_t axis = 0; axis < 2; ++axis) {
        if (here.core.exactly[axis][0] <= here.domain.exactly[axis][0] ||
            here.domain.exactly[axis][1] <= here.core.exactly[axis][1])
          return "a core that is not inside of its box";
      }
      for (const Exact& x : here.domain.grid(steps)) {
        const Flat about = roughly(x);
        if (is_origin(x)) {
          if (!here.core.nearly_contains(about)) return "points in no core";
          continue;
        }
        const Exact y = inverted(x);
        if (!here.core.nearly_contains(about) && !there.core.nearly_contains(roughly(y))) return "points in no core";
        if (!there.domain.contains(y)) continue;
        bool are_glued = false;
        for (const Transition& t : transitions_) {
          const bool forwards = t.from == a;
          if (!glues(t, forwards ? x : y)) continue;
          are_glued = true;
          if (image(t, forwards, x) != y || image(t, !forwards, y) != x) return "a transition to another place";
        }
        if (!are_glued) return "points of one place that are not glued";
      }
      // Nothing is glued to a point of the box to which nothing is to be.
      for (const Transition& t : transitions_) {
        if (t.from != a) continue;
        for (const Exact& x : here.domain.grid(7)) {
          if (!glues(t, x)) continue;
          const auto y = image(t, true, x);
          if (charts_[t.to].domain.contains(*y) && (is_origin(x) || *y != inverted(x)))
            return "a transition to another place";
        }
      }
    }
    return "";
  }

  std::string of_labels() const {
    for (const LabelChart& label : labels_) {
      const Box& box = charts_[label.home].domain;
      for (std::size_t axis = 0; axis < 2; ++axis) {
        const double wide = patch_ * std::hypot(label.back[2 * axis], label.back[2 * axis + 1]) * (1 - slack);
        if (!(box.roughly[axis][0] < label.centre[axis] - wide && label.centre[axis] + wide < box.roughly[axis][1]))
          return "a patch outside of its box";
      }
      if (j_.at("parameters").at("mode") == "none" && size(label.own) > 0) return "a point moved in the mode none";
    }
    for (std::size_t j = 0; j < labels_.size(); ++j) {
      if (is_stretched_more(j)) return "distortion";
    }
    return "";
  }
  /// By the box around its patch.
  [[nodiscard]] bool may_show(const LabelChart& label, const Flat& x) const {
    return std::fabs(x[0] - label.centre[0]) <= label.reach[0] && std::fabs(x[1] - label.centre[1]) <= label.reach[1];
  }
  /// Where points near c_j that are moved as far as p_j may be come into the patches of others.
  [[nodiscard]] bool is_stretched_more(std::size_t j) const {
    const LabelChart& from = labels_[j];
    const double wide = moved_ * std::hypot(from.back[0], from.back[1]), high = moved_ * std::fabs(from.back[3]);
    const std::array<Flat, 5> signs = {Flat{0, 0}, Flat{1, 1}, Flat{1, -1}, Flat{-1, 1}, Flat{-1, -1}};
    for (const Flat& sign : signs) {
      const Flat x = {from.centre[0] + sign[0] * wide, from.centre[1] + sign[1] * high};
      for (std::size_t chart = 0; chart < 2; ++chart) {
        const Flat there = chart == from.home ? x : inverted(x);
        if (!charts_[chart].domain.contains(there)) continue;
        const Square turn = chart == from.home ? from.back : derivative_of_inversion(x) * from.back;
        for (std::size_t i = 0; i < labels_.size(); ++i) {
          if (i == j || labels_[i].home != chart || !may_show(labels_[i], there)) continue;
          if (!(size(labels_[i].to * minus(there, labels_[i].centre)) < patch_ * (1 - slack))) continue;
          if (greatest_stretch(labels_[i].to * turn) > (1 + distortion_) * (1 + slack)) return true;
        }
      }
    }
    return false;
  }

  /// Where a chart of the file shows a label.
  [[nodiscard]] std::optional<Flat> shown(std::size_t chart, std::size_t label) const {
    const Flat x = labels_[label].home == chart ? labels_[label].place : labels_[label].elsewhere;
    return charts_[chart].domain.contains(x) ? std::optional<Flat>(x) : std::nullopt;
  }

  std::string of_level_5(const Json& level) const {
    const double gamma = rough(level.at("contraction")), lambda = rough(level.at("displacement"));
    double angle = 0;
    for (const Simplex& simplex : simplices_) {
      std::array<Place, 3> corners;
      for (std::size_t v = 0; v < 3; ++v)
        corners[v] = on_sphere(labels_.at(simplex[v]).home, labels_.at(simplex[v]).place);
      angle += std::fabs(solid_angle(corners[0], corners[1], corners[2]));
      if (auto found = of_seam(simplex, gamma, lambda); !found.empty()) return found;
    }
    return std::fabs(angle - 2 * two_pi) > 1e-6 ? "not once around" : "";
  }
  /// The straight simplex of the first home, blended with that of the second.
  [[nodiscard]] std::string of_seam(const Simplex& simplex, double gamma, double lambda) const {
    const LabelChart* last = nullptr;
    bool is_seam = false;
    std::array<std::array<Flat, 3>, 2> x{};
    for (std::size_t v = 3; v-- > 0;) {
      const LabelChart& label = labels_[simplex[v]];
      if (label.home == 1) last = &label;
      if (label.home == 0) is_seam = true;
    }
    if (last == nullptr || !is_seam) return "";
    for (std::size_t chart = 0; chart < 2; ++chart) {
      for (std::size_t v = 0; v < 3; ++v) {
        const auto seen = shown(chart, simplex[v]);
        if (!seen) return "a vertex that a home does not show";
        x[chart][v] = *seen;
      }
    }
    constexpr int steps = 6;
    // Of the blend and of the straight simplex.
    std::array<std::array<std::array<Flat, 2>, steps + 1>, steps + 1> places{};
    bool is_contraction = true;
    std::optional<std::array<Flat, 2>> before;
    for (int a = 0; a <= steps; ++a) {
      for (int b = 0; b <= steps - a; ++b) {
        const double u = static_cast<double>(a) / steps, w = static_cast<double>(b) / steps;
        const std::array<double, 3> t = {1 - u - w, u, w};
        Flat first{}, second{};
        double share = 0;
        for (std::size_t v = 0; v < 3; ++v) {
          for (std::size_t axis = 0; axis < 2; ++axis) {
            first[axis] += t[v] * x[0][v][axis];
            second[axis] += t[v] * x[1][v][axis];
          }
          if (labels_[simplex[v]].home == 0) share += t[v];
        }
        const Flat across = inverted(first);
        if (!charts_[0].domain.contains(first) || !charts_[1].domain.contains(across)) return "a seam outside of a box";
        const Flat off = last->to * minus(across, second);
        const std::array<Flat, 2> now = {Flat{share * off[0], share * off[1]}, last->to * second};
        if (size(now[0]) > lambda * (1 + slack) + slack) return "displacement";
        places[static_cast<std::size_t>(a)][static_cast<std::size_t>(b)] = {
            Flat{now[0][0] + now[1][0], now[0][1] + now[1][1]}, now[1]};
        if (before && size(minus(now[0], (*before)[0])) > gamma * size(minus(now[1], (*before)[1])) + slack)
          is_contraction = false;
        before = now;
      }
    }
    // What is no contraction has to keep areas.
    constexpr double bent = 0.02;  // of the small triangles
    for (std::size_t a = 0; a < steps && !is_contraction; ++a) {
      for (std::size_t b = 0; b + a < steps; ++b) {
        const auto area = [&](std::size_t which) {
          const Flat& corner = places[a][b][which];
          const Flat u = minus(places[a + 1][b][which], corner), w = minus(places[a][b + 1][which], corner);
          return u[0] * w[1] - u[1] * w[0];
        };
        if (area(0) / area(1) < (1 - gamma) * (1 - gamma) - bent) return "contraction";
      }
    }
    return "";
  }

  const Json& j_;
  std::vector<Chart> charts_;
  std::vector<Transition> transitions_;
  double patch_ = 0, moved_ = 0, distortion_ = 0;
  std::vector<LabelChart> labels_;
  std::vector<Simplex> simplices_;
};

}  // namespace

std::string fault_of_sphere_by_charts(const std::string& text) {
  const Json j = Json::parse(text);
  const Json& manifold = j.at("manifold");
  if (manifold.at("family") != "atlas" || manifold.at("dimension") != 2 || manifold.at("charts").size() != 2)
    return "another atlas";
  return Oracle(j).fault();
}

}  // namespace delcert::checker_tests
