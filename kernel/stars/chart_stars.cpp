#include "kernel/stars/chart_stars.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "kernel/simplex/dimensions.hpp"
#include "kernel/stars/approximate_star.hpp"

namespace delcert {

namespace {

template <int m>
std::vector<Label> labels_of(const ChartView<m>& view, const PlaceSimplex<m>& simplex) {
  std::vector<Label> result;
  for (const std::uint32_t place : simplex) result.push_back(view.label(place));
  std::sort(result.begin(), result.end());
  return result;
}

/// The place of label i itself; none if its point is not seen as itself.
template <int m>
std::optional<std::uint32_t> home_of(const ChartView<m>& view, Label i) {
  for (std::uint32_t place = 0; place < view.size(); ++place) {
    if (view.label(place) == i && view.sighting(place).is_unmoved()) return place;
  }
  return std::nullopt;
}

template <int m>
std::vector<PlaceSimplex<m>> proposed(const ChartView<m>& view, std::uint32_t home) {
  std::vector<Vector<double, m>> approximate;
  {
    const FilterGuard guard;
    for (std::size_t place = 0; place < view.size(); ++place) {
      const auto& position = view.position(LocalCoordinates::chart, place);
      // Ends of enclosures, not middles: whether a sum next to the end of a guard is rounded upwards depends on the
      // compiler.
      Vector<double, m> end;
      for (std::size_t axis = 0; axis < m; ++axis) end[axis] = position[axis].lower();
      approximate.push_back(end);
    }
  }
  for (auto& x : approximate) x = view.atlas().metric().approximate_cartesian(x);
  return approximate_star<m>(approximate, home);
}

template <int m>
class StarCertification {
 public:
  StarCertification(const ChartView<m>& view, Label i, double required_protection, CertifiedStar<m>& result)
      : view_(view), label_(i), required_protection_(required_protection), result_(result) {}

  /// Whether it may be that nothing is wrong but that too little is seen.
  [[nodiscard]] bool sees_too_little() const { return sees_too_little_; }

  void run() {
    const auto home = home_of<m>(view_, label_);
    if (!home) {
      fail({label_}, FailureCause::undecided, "its own point is not in its patch");
      return;
    }
    const auto simplices = proposed<m>(view_, *home);
    for (const auto& simplex : simplices) certify(simplex);
    std::sort(result_.star.simplices.begin(), result_.star.simplices.end());
    if (result_.failures.empty()) check_facets();
    sees_too_little_ = !result_.failures.empty() && !blames_a_point_;
  }

 private:
  void certify(const PlaceSimplex<m>& simplex) {
    const auto labels = labels_of<m>(view_, simplex);
    ChartSimplex<m> others;
    std::size_t next = 0;
    for (const std::uint32_t place : simplex) {
      if (view_.label(place) != label_ && next < m) others[next++] = view_.sighting(place);
    }
    if (next < m || std::adjacent_find(labels.begin(), labels.end()) != labels.end()) {
      fail(labels, FailureCause::combinatorial, simplex_text(labels) + " has a label twice");
      return;
    }
    result_.star.simplices.push_back(others);
    LocalMargins margins;
    std::size_t witness = view_.size();
    if (const auto failure = chart_simplex_failure<m>(view_, simplex, required_protection_, margins, witness)) {
      auto concerned = labels;
      std::string text = simplex_text(labels) + " " + failure->reason;
      if (witness < view_.size()) {
        blames_a_point_ = true;
        concerned.push_back(view_.label(witness));
        text += ": label " + std::to_string(view_.label(witness).value);
      }
      fail(concerned, failure->cause, text);
    } else if (result_.star.simplices.size() == 1) {
      result_.margins = margins;
    } else {
      result_.margins.include(margins);
    }
  }

  void check_facets() {
    if (result_.star.simplices.empty()) {
      fail({label_}, FailureCause::combinatorial, "its star is empty");
      return;
    }
    std::vector<std::array<std::uint32_t, static_cast<std::size_t>(m)>> faces;
    for (const auto& others : result_.star.simplices) {
      for (std::size_t omitted = 0; omitted < m; ++omitted) {
        std::array<std::uint32_t, static_cast<std::size_t>(m)> face{};  // the last entry stays 0
        std::size_t next = 0;
        for (std::size_t at = 0; at < m; ++at) {
          if (at != omitted) face[next++] = others[at].index;
        }
        faces.push_back(face);
      }
    }
    std::sort(faces.begin(), faces.end());
    for (std::size_t first = 0; first < faces.size();) {
      std::size_t last = first;
      while (last < faces.size() && faces[last] == faces[first]) ++last;
      if (last - first != 2) {
        std::vector<Label> concerned{label_};
        for (std::size_t at = 0; at + 1 < m; ++at) concerned.emplace_back(faces[first][at]);
        fail(concerned, FailureCause::combinatorial,
             "a face of its star is in " + std::to_string(last - first) + " simplices instead of 2");
        return;
      }
      first = last;
    }
  }

  void fail(std::vector<Label> concerned, FailureCause cause, std::string reason) {
    result_.failures.push_back({label_, std::move(reason), std::move(concerned), cause});
  }

  const ChartView<m>& view_;
  Label label_;
  double required_protection_;
  CertifiedStar<m>& result_;
  bool blames_a_point_ = false;
  bool sees_too_little_ = false;
};

}  // namespace

LocalMargins LocalMargins::as_multiples(const LengthUnits& units, Label i) const {
  return {units.lower(i, protection), thickness, units.upper(i, circumradius), units.upper(i, reach)};
}

void LocalMargins::include(const LocalMargins& other) {
  protection = std::min(protection, other.protection);
  thickness = std::min(thickness, other.thickness);
  circumradius = std::max(circumradius, other.circumradius);
  reach = std::max(reach, other.reach);
}

std::string simplex_text(std::vector<Label> labels) {
  std::sort(labels.begin(), labels.end());
  std::string result = "simplex {";
  for (std::size_t at = 0; at < labels.size(); ++at) {
    result += (at > 0 ? ", " : "") + std::to_string(labels[at].value);
  }
  return result + "}";
}

template <int m>
std::optional<SimplexFailure> chart_simplex_failure(const ChartView<m>& view, const PlaceSimplex<m>& simplex,
                                                    double required_protection, LocalMargins& margins,
                                                    std::size_t& witness, int look_beyond_part) {
  const auto undecided = [](std::string reason) { return SimplexFailure{FailureCause::undecided, std::move(reason)}; };
  witness = view.size();
  const double look_beyond = approximate_double(view.atlas().sampling_radius(view.chart())) / look_beyond_part;
  const auto ball = look_at_ball<m>(view, LocalCoordinates::chart, simplex, look_beyond);
  if (!is_proved(ball.empty)) {
    witness = ball.witness;
    if (witness == view.size()) return undecided("cannot be told from a degenerate simplex");
    if (!is_refuted(ball.empty)) return undecided("is undecided");
    return SimplexFailure{FailureCause::occupied_ball, "has another point in its closed circumball"};
  }
  const double complete = view.complete_radius(LocalCoordinates::chart);
  const FilterGuard guard;
  const auto& metric = view.filter_metric();
  const Filter radius = square_root(ball.squared_radius);
  const Filter centre = square_root(metric.squared_norm(ball.centre));
  // √(R² + P) − R without cancellation.
  const Filter power = twice(ball.least_power);
  const Filter gap = power / (square_root(ball.squared_radius + power) + radius);
  const Filter room = Filter::exactly(complete) - centre - radius;
  margins.protection = minimum(gap, room).lower();
  margins.circumradius = radius.upper();
  margins.reach = (centre + radius).upper();
  LocalVertices<Filter, m> vertices;
  for (std::size_t corner = 0; corner <= m; ++corner)
    vertices[corner] = view.position(LocalCoordinates::chart, simplex[corner]);
  margins.thickness = thickness_of<m>(metric, vertices);
  if (!(room.lower() > 0)) return undecided("has a circumball that does not lie in the patch");
  if (!(margins.protection > 0)) return undecided("has a protection too small for the filter");
  if (!(margins.thickness > 0)) return undecided("has a thickness too small for the filter");
  if (!(margins.protection > required_protection)) {
    witness = ball.nearest;
    return SimplexFailure{FailureCause::less_protected, "is less protected than required"};
  }
  return std::nullopt;
}

template <int m>
CertifiedStar<m> chart_star(ChartView<m>& scratch, Label i, double required_protection) {
  CertifiedStar<m> result;
  // Little is enough for the stars of a perturbed net; more, up to the whole patch, where that may be what fails.
  for (const double half_reach : scratch.half_reaches()) {
    scratch.look_by_halves(i, half_reach);
    result = {};
    result.star.label = i;
    result.reach = scratch.reach();
    StarCertification<m> certification(scratch, i, required_protection, result);
    certification.run();
    if (!certification.sees_too_little()) break;
  }
  return result;
}

#define DELCERT_INSTANTIATE(m)                                                                                         \
  template CertifiedStar<m> chart_star<m>(ChartView<m>&, Label, double);                                               \
  template std::optional<SimplexFailure> chart_simplex_failure<m>(const ChartView<m>&, const PlaceSimplex<m>&, double, \
                                                                  LocalMargins&, std::size_t&, int);
DELCERT_FOR_EACH_DIMENSION(DELCERT_INSTANTIATE)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
