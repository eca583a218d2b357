#include "kernel/sample/space_form_net.hpp"

#include "kernel/number/exact_text.hpp"
#include "kernel/number/simple_fraction.hpp"
#include "kernel/parallel/parts.hpp"
#include "kernel/sample/disk_sampling.hpp"
#include "kernel/sample/space_form_points.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

void require_radius(const SpaceForm& form, const Rational& radius) {
  if (radius <= Rational(0)) throw InputError("the radius of a net is above 0");
  if (Rational(3) * radius > form.injectivity_radius.lower)
    throw Rejection(form.description.name +
                    ": the radius of a net is at most a third of the injectivity radius: take at most " +
                    exact_text(simple_fraction_at_most(form.injectivity_radius.lower / Rational(3))));
}

/// The points of a space form as `DiskSampling` takes them.
template <int m>
class Points {
 public:
  using Candidate = typename SpaceFormPoints<m>::Candidate;

  Points(const SpaceForm& form, double radius)
      : radius_(radius), points_(form, DiskSampling<m, Points>::reach * radius) {}

  void take(const std::vector<Vector<Rational, m>>& centres) {
    for (const auto& centre : centres) {
      Vector<double, m> coordinates;
      for (std::size_t axis = 0; axis < m; ++axis) coordinates[axis] = approximate_double(centre[axis]);
      points_.insert(points_.domain().reduced(points_.domain().point(coordinates)), 0);
    }
  }
  [[nodiscard]] std::optional<Candidate> dart(CounterRandom& random) const {
    return points_.candidate(points_.domain().random_point(random), radius_);
  }
  [[nodiscard]] std::optional<Candidate> candidate_about(std::uint32_t label, const Vector<double, m>& place) const {
    return points_.candidate(points_.at(label, place), radius_);
  }
  void begin_round() { points_.begin_round(); }
  bool insert(const Candidate& candidate) { return points_.insert_candidate(candidate, radius_); }
  [[nodiscard]] bool has_new_about(std::uint32_t label) const { return points_.has_new_about(label); }
  void look_about(std::uint32_t label, std::vector<Vector<double, m>>& around) const {
    points_.look_about(label, around);
  }
  [[nodiscard]] std::size_t size() const { return points_.size(); }

  [[nodiscard]] Vector<Rational, m> exactly_at(std::uint32_t label, const Vector<double, m>& place) const {
    const auto at = points_.at(label, place);
    Vector<Rational, m> result;
    for (std::size_t axis = 0; axis < m; ++axis) result[axis] = Rational::exactly(at[axis]);
    return result;
  }
  [[nodiscard]] std::vector<Vector<Rational, m>> ordered() const { return points_.ordered(); }

 private:
  double radius_;
  SpaceFormPoints<m> points_;
};

/// A net in the making.
template <int m>
struct Sampling {
  Sampling(const SpaceForm& form, const Rational& radius)
      : points(form, approximate_double(radius)), disks(points, form.form().curvature(), approximate_double(radius)) {}

  [[nodiscard]] std::vector<Vector<Rational, m>> relaxed(const Progress& progress) {
    std::vector<Vector<Rational, m>> result;
    const auto moved = [&](std::size_t first, std::size_t last) {
      std::vector<Vector<Rational, m>> places;
      for (auto label = static_cast<std::uint32_t>(first); label < last; ++label)
        places.push_back(points.exactly_at(label, VoronoiCells<m>::mass_centre(disks.cell_of(label))));
      return places;
    };
    in_parts("relax", points.size(), progress, moved,
             [&](const auto& places) { result.insert(result.end(), places.begin(), places.end()); });
    return result;
  }
  [[nodiscard]] SpaceFormNet<m> net() const { return {points.ordered(), disks.covering_radius(), disks.separation()}; }

  Points<m> points;
  DiskSampling<m, Points<m>> disks;
};

}  // namespace

template <int m>
SpaceFormNet<m> space_form_net(const SpaceForm& form, const Rational& radius, std::uint64_t seed,
                               const Progress& progress) {
  require_radius(form, radius);
  Sampling<m> sampling(form, radius);
  sampling.disks.throw_darts(seed, progress);
  sampling.disks.fill_gaps(seed, progress);
  return sampling.net();
}

template <int m>
SpaceFormNet<m> measured_net(const SpaceForm& form, const std::vector<Vector<Rational, m>>& centres,
                             const Rational& radius) {
  require_radius(form, radius);
  Sampling<m> sampling(form, radius);
  sampling.points.take(centres);
  sampling.disks.measure(no_progress());
  return sampling.net();
}

template <int m>
SpaceFormNet<m> relaxed_net(const SpaceForm& form, const std::vector<Vector<Rational, m>>& centres,
                            const Rational& radius, std::uint32_t steps, const Progress& progress) {
  require_radius(form, radius);
  auto moved = centres;
  for (std::uint32_t step = 0; step < steps; ++step) {
    Sampling<m> sampling(form, radius);
    sampling.points.take(moved);
    moved = sampling.relaxed(progress);
  }
  return measured_net<m>(form, moved, radius);
}

#define DELCERT_INSTANTIATE(m)                                                                                        \
  template SpaceFormNet<m> space_form_net<m>(const SpaceForm&, const Rational&, std::uint64_t, const Progress&);      \
  template SpaceFormNet<m> measured_net<m>(const SpaceForm&, const std::vector<Vector<Rational, m>>&,                 \
                                           const Rational&);                                                          \
  template SpaceFormNet<m> relaxed_net<m>(const SpaceForm&, const std::vector<Vector<Rational, m>>&, const Rational&, \
                                          std::uint32_t, const Progress&);
DELCERT_INSTANTIATE(2)
DELCERT_INSTANTIATE(3)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
