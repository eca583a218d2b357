#include "kernel/sample/space_form_net.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "kernel/error.hpp"
#include "kernel/manifold/space_form/lift_grid.hpp"
#include "kernel/number/rounding_guard.hpp"
#include "kernel/sample/space_form_domain.hpp"
#include "kernel/sample/voronoi_gaps.hpp"

namespace delcert {

namespace {

constexpr std::uint32_t batch = 4096;
/// Darts are thrown until fewer than one in this many lands.
constexpr std::uint32_t worth_throwing = 20;
constexpr std::uint32_t most_rounds = 200;
constexpr std::size_t most_points = 4000000;
/// Lifts are kept a little farther than they are asked for.
constexpr double spare = 1 + 0x1p-10;

template <int m>
class SpaceFormSampler {
 public:
  SpaceFormSampler(const SpaceForm& form, const Rational& radius, std::uint64_t seed)
      : radius_(approximate_double(radius)),
        seed_(seed),
        metric_(chart_metric<m>(form.form())),
        domain_(form, VoronoiGaps<m>::reach * radius_ * spare),
        gaps_(form.form().curvature(), radius_),
        grid_(empty_grid()) {}

  void throw_darts(const Progress& progress) {
    std::uint32_t dart = 0;
    std::uint32_t landed = batch;
    while (landed * worth_throwing >= batch) {
      progress("throw darts", points_.size(), points_.size());
      landed = 0;
      for (const std::uint32_t end = dart + batch; dart < end; ++dart) {
        CounterRandom random(seed_, RandomPurpose::darts, dart, 0);
        if (insert_if_free(domain_.random_point(random))) ++landed;
      }
    }
  }

  void fill_gaps(const Progress& progress) {
    std::vector<std::uint32_t> open(points_.size());
    for (std::uint32_t label = 0; label < open.size(); ++label) open[label] = label;
    for (std::uint32_t round = 0; !open.empty(); ++round) {
      if (round == most_rounds)
        throw Rejection("maximal Poisson-disk sampling found gaps for " + std::to_string(most_rounds) + " rounds");
      std::vector<std::uint32_t> still_open;
      const auto first_new = static_cast<std::uint32_t>(points_.size());
      for (std::size_t at = 0; at < open.size(); ++at) {
        if (at % 1024 == 0) progress("fill gaps", at, open.size());
        if (fill_gaps_about(open[at], round)) still_open.push_back(open[at]);
      }
      for (auto label = first_new; label < points_.size(); ++label) still_open.push_back(label);
      open = std::move(still_open);
    }
  }

  [[nodiscard]] SpaceFormNet<m> net() const {
    SpaceFormNet<m> result;
    for (const std::uint32_t label : spatial_order()) {
      Vector<Rational, m> centre;
      for (std::size_t axis = 0; axis < m; ++axis) centre[axis] = Rational::exactly(points_[label][axis]);
      result.centres.push_back(std::move(centre));
    }
    result.covering_radius = covering_radius_;
    result.separation = separation_;
    return result;
  }

 private:
  [[nodiscard]] LiftGrid<m> empty_grid() const {
    const RoundingGuard guard;
    return LiftGrid<m>(domain_.curvature(), metric_, radius_);
  }

  bool insert_if_free(const Vector<double, m>& coordinates) {
    if (!std::all_of(coordinates.begin(), coordinates.end(), [](double x) { return std::abs(x) < 0x1p30; }))
      return false;  // next to −o
    const RoundingGuard guard;
    Vector<Interval, m> enclosed;
    for (std::size_t axis = 0; axis < m; ++axis) enclosed[axis] = Interval::exactly(coordinates[axis]);
    const auto x = model_point<Interval, m>(domain_.curvature(), enclosed);
    if (grid_.approximately_occupied(x, radius_)) return false;
    if (points_.size() == most_points)
      throw Rejection("a net of this radius has more than " + std::to_string(most_points) +
                      " points, which is the most that is supported");
    const auto label = static_cast<std::uint32_t>(points_.size());
    points_.push_back(coordinates);
    grid_.insert({label, {}}, x);
    domain_.lifts().for_each_lift(x, [&](std::uint32_t number, const ModelPoint<Interval, m>& lift) {
      Shift<m> shift{};
      shift[0] = static_cast<std::int32_t>(number);
      grid_.insert({label, shift}, lift);
    });
    return true;
  }

  /// The lifts about a point, seen from it: Cartesian conformal coordinates.
  void look_about(std::uint32_t label, const Frame<PlainDouble, m>& frame) {
    {
      const RoundingGuard guard;
      Vector<Interval, m> enclosed;
      for (std::size_t axis = 0; axis < m; ++axis) enclosed[axis] = Interval::exactly(points_[label][axis]);
      seen_.clear();
      grid_.near(model_point<Interval, m>(domain_.curvature(), enclosed), VoronoiGaps<m>::reach * radius_, seen_);
    }
    std::sort(seen_.begin(), seen_.end());
    around_.clear();
    for (const Lift<m>& lift : seen_) {
      const auto number = static_cast<std::uint32_t>(lift.shift[0]);
      if (lift.index == label && number == 0) continue;
      const auto x = applied(domain_.matrix(number), domain_.point(points_[lift.index]));
      const auto plain = conformal_coordinates<PlainDouble, m>(frame.inverse_applied(x));
      Vector<double, m> conformal;
      for (std::size_t axis = 0; axis < m; ++axis) conformal[axis] = plain[axis].lower();
      around_.push_back(metric_.approximate_cartesian(conformal));
    }
  }

  /// Returns whether there was a gap.
  bool fill_gaps_about(std::uint32_t label, std::uint32_t round) {
    Vector<PlainDouble, m> plain;
    for (std::size_t axis = 0; axis < m; ++axis) plain[axis] = PlainDouble::exactly(points_[label][axis]);
    const Frame<PlainDouble, m> frame(domain_.curvature(), plain);
    look_about(label, frame);
    CounterRandom random(seed_, RandomPurpose::gap_filling, label, round);
    const auto found = gaps_.find(around_, random);
    for (const auto& cartesian : found.points) {
      const auto conformal = metric_.approximate_frame(cartesian);
      insert_if_free(domain_.reduced(frame.applied(domain_.point(conformal))));
    }
    separation_ = std::min(separation_, found.nearest);
    if (found.points.empty()) covering_radius_ = std::max(covering_radius_, found.farthest_vertex);
    return !found.points.empty();
  }

  /// Along a Morton curve in the linear model (𝔼ᵐ: the frame, ℍᵐ: without x₀).
  [[nodiscard]] std::vector<std::uint32_t> spatial_order() const {
    double size = 1;
    for (const auto& point : points_) {
      if (domain_.curvature() == Curvature::positive) break;
      for (const double coordinate : point) size = std::max(size, std::abs(coordinate));
    }
    std::vector<std::pair<std::uint64_t, std::uint32_t>> codes;
    for (std::uint32_t label = 0; label < points_.size(); ++label) {
      Vector<double, m + 1> at{};
      const auto x = domain_.point(points_[label]);
      for (std::size_t axis = 0; axis <= m; ++axis) {
        if (domain_.curvature() == Curvature::positive) {
          at[axis] = x[axis].lower();
        } else if (axis < m) {
          at[axis] = points_[label][axis] / size;
        }
      }
      std::uint64_t code = 0;
      for (unsigned bit = 0; bit < 16; ++bit) {
        for (std::size_t axis = 0; axis <= m; ++axis) {
          const auto cell = static_cast<std::uint64_t>((std::clamp(at[axis], -1.0, 1.0) + 1) * 0x1.fffcp14);
          code |= ((cell >> bit) & 1U) << (std::size_t{bit} * (m + 1) + axis);
        }
      }
      codes.emplace_back(code, label);
    }
    std::sort(codes.begin(), codes.end());
    std::vector<std::uint32_t> order;
    for (const auto& [code, label] : codes) order.push_back(label);
    return order;
  }

  double radius_;
  std::uint64_t seed_;
  FrameMetric<m> metric_;
  SpaceFormDomain<m> domain_;
  VoronoiGaps<m> gaps_;
  LiftGrid<m> grid_;
  std::vector<Vector<double, m>> points_;
  std::vector<Lift<m>> seen_;
  std::vector<Vector<double, m>> around_;
  double covering_radius_ = 0;
  double separation_ = std::numeric_limits<double>::infinity();
};

}  // namespace

template <int m>
SpaceFormNet<m> space_form_net(const SpaceForm& form, const Rational& radius, std::uint64_t seed,
                               const Progress& progress) {
  if (radius <= Rational(0)) throw InputError("the radius of a net is above 0");
  if (Rational(3) * radius > form.injectivity_radius.lower)
    throw Rejection(form.description.name + ": the radius of a net is at most a third of the injectivity radius, " +
                    std::to_string(approximate_double(form.injectivity_radius.lower / Rational(3))));
  SpaceFormSampler<m> sampler(form, radius, seed);
  sampler.throw_darts(progress);
  sampler.fill_gaps(progress);
  return sampler.net();
}

template SpaceFormNet<2> space_form_net<2>(const SpaceForm&, const Rational&, std::uint64_t, const Progress&);
template SpaceFormNet<3> space_form_net<3>(const SpaceForm&, const Rational&, std::uint64_t, const Progress&);

}  // namespace delcert
