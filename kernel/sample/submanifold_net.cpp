#include "kernel/sample/submanifold_net.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "kernel/sample/disk_sampling.hpp"
#include "kernel/sample/spatial_order.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

constexpr std::size_t most_points_of_submanifold = 2000000;

/// The points of a zero set as `DiskSampling` takes them: coordinates about a point are those of its tangent plane, as
/// multiples of its radius by the greatest one.
template <int m>
class SubmanifoldPoints {
 public:
  SubmanifoldPoints(const EmbeddedManifold& manifold, Sizing sizing)
      : manifold_(manifold),
        sizing_(std::move(sizing)),
        greatest_(sizing_.greatest()),
        n_(manifold.ambient()),
        step_(net_step(greatest_)),
        sampler_(manifold.sampler(greatest_)),
        cells_(n_, 4 * std::sqrt(sizing_.least() / greatest_) * greatest_) {
    for (const auto& side : manifold.box()) box_.push_back({approximate_double(side[0]), approximate_double(side[1])});
  }

  bool throw_dart(CounterRandom& random) { return insert_from(sampler_->dart(random)); }
  /// The point of M to which is found from here, unless there is none or another is closer to it than the
  /// radius there.
  bool insert_from(std::vector<double> x) {
    if (!sampler_->project(x, nullptr) || !is_in_box(x) || !is_free(x)) return false;
    return insert(x);
  }
  void insert_about(std::uint32_t label, const Vector<double, m>& place) {
    const Dense<double>& frame = frames_[label];
    std::vector<double> x(n_);
    for (std::size_t axis = 0; axis < n_; ++axis) {
      x[axis] = cells_[label][axis];
      for (std::size_t k = 0; k < m; ++k) x[axis] += frame[axis * n_ + k] * place[k] * units_[label];
    }
    if (!sampler_->project(x, &frame) || height(label, x) > most_slope * 2 * radius_of(label)) {
      std::vector<double> where(cells_[label], cells_[label] + n_);
      const std::string reason = manifold_.name() + ": the manifold is too curved for the sampling radius near " +
                                 rough_text(where) + ": " + sampler_->advice(where);
      throw TooCoarse(reason, {std::move(where)});
    }
    if (!is_in_box(x))
      throw Undecided(manifold_.name() + ": undecided whether the manifold goes through the side of the box near " +
                      rough_text(x) + ": it is to be inside of the box, without boundary");
    if (is_free_in_chart(label, x)) insert(x);
  }
  void look_about(std::uint32_t label, std::vector<Vector<double, m>>& around) const {
    constexpr double reach = DiskSampling<m, SubmanifoldPoints>::reach;
    around.clear();
    std::vector<std::uint32_t> seen;
    const double radius = radius_of(label);
    cells_.visit(cells_[label], most_stretch * reach * radius, [&](std::uint32_t other, double) {
      if (other != label) seen.push_back(other);
      return false;
    });
    std::sort(seen.begin(), seen.end());
    for (const std::uint32_t other : seen) {
      auto place = seen_from(label, cells_[other]);
      if (!place || pairing(*place, *place) > reach * radius * (reach * radius)) continue;
      for (double& coordinate : *place) coordinate /= units_[label];
      around.push_back(*place);
    }
  }
  [[nodiscard]] std::size_t size() const { return cells_.size(); }

  /// Where points are, in the order of a space-filling curve, and the radii there.
  struct Ordered {
    std::vector<std::vector<Rational>> centres;
    SamplingRadii radii;
  };
  [[nodiscard]] Ordered ordered(const Rational& greatest) const {
    std::vector<std::array<double, 4>> places(size());
    for (std::size_t label = 0; label < size(); ++label) {
      for (std::size_t axis = 0; axis < std::min<std::size_t>(n_, 4); ++axis) {
        const std::array<double, 2>& side = box_[axis];
        places[label][axis] = 2 * (cells_[label][axis] - side[0]) / (side[1] - side[0]) - 1;
      }
    }
    Ordered result{{}, greatest};
    std::vector<double> radii;
    for (const std::uint32_t label : spatial_order<4>(places)) {
      auto& centre = result.centres.emplace_back();
      for (std::size_t axis = 0; axis < n_; ++axis) centre.push_back(Rational::exactly(cells_[label][axis]));
      radii.push_back(radius_of(label));
    }
    if (sizing_.size() > 0) result.radii = SamplingRadii(radii);
    return result;
  }

  /// Half the radius at these places.
  void refine(const std::vector<std::vector<double>>& places, double slope) {
    std::vector<Sizing::Cone> cones;
    for (const auto& place : places) cones.push_back({place, sizing_.at(place.data()) / 2, slope});
    for (Sizing::Cone& cone : cones) {
      if (cone.radius < sizing_.at(cone.apex.data()) * 0.75) sizing_.add(std::move(cone));
    }
    for (std::uint32_t label = 0; label < size(); ++label) units_[label] = sizing_.at(cells_[label]) / greatest_;
  }

 private:
  /// What is seen at a steeper angle than this is another sheet.
  static constexpr double most_slope = 1.5;
  static constexpr double most_stretch = 1.5;

  [[nodiscard]] bool is_in_box(const std::vector<double>& x) const {
    for (std::size_t axis = 0; axis < n_; ++axis) {
      if (!(x[axis] > box_[axis][0] && x[axis] < box_[axis][1])) return false;
    }
    return true;
  }
  [[nodiscard]] double radius_of(std::uint32_t label) const { return units_[label] * greatest_; }

  bool insert(std::vector<double> x) {
    if (size() == most_points_of_submanifold)
      throw Rejection("a net of this radius has more than " + std::to_string(most_points_of_submanifold) +
                      " points, which is the most that is supported");
    for (double& coordinate : x) coordinate = std::nearbyint(coordinate / step_) * step_;
    const auto normals = sampler_->normals(x);
    if (!normals) return false;
    auto proposed = propose_frame(*normals, manifold_.codimension(), n_);
    if (!proposed) return false;
    cells_.insert(x.data());
    units_.push_back(sizing_.at(x.data()) / greatest_);
    frames_.push_back(std::move(proposed->frame));
    return true;
  }

  [[nodiscard]] double height(std::uint32_t label, const std::vector<double>& x) const {
    double squared = 0;
    for (std::size_t b = m; b < n_; ++b) squared += square_of(along(label, x.data(), b));
    return std::sqrt(squared);
  }
  static double square_of(double x) { return x * x; }
  [[nodiscard]] double along(std::uint32_t label, const double* x, std::size_t column) const {
    double result = 0;
    for (std::size_t axis = 0; axis < n_; ++axis)
      result += frames_[label][axis * n_ + column] * (x[axis] - cells_[label][axis]);
    return result;
  }
  /// In the tangent plane of this label; none if it must be on another sheet.
  [[nodiscard]] std::optional<Vector<double, m>> seen_from(std::uint32_t label, const double* x) const {
    Vector<double, m> place{};
    double across = 0;
    double above = 0;
    for (std::size_t k = 0; k < n_; ++k) {
      const double coordinate = along(label, x, k);
      if (k < m) place[k] = coordinate;
      (k < m ? across : above) += square_of(coordinate);
    }
    if (above > square_of(most_slope) * across) return std::nullopt;
    return place;
  }

  /// No point is closer in its own chart than the radius at x.
  [[nodiscard]] bool is_free(const std::vector<double>& x) const {
    bool result = true;
    const double radius = sizing_.at(x.data());
    cells_.visit(x.data(), most_stretch * radius, [&](std::uint32_t other, double squared) {
      const auto place = seen_from(other, x.data());
      result = squared > square_of(step_) && (!place || pairing(*place, *place) >= radius * radius);
      return !result;
    });
    return result;
  }
  /// No point is closer in the chart of this label than its radius.
  [[nodiscard]] bool is_free_in_chart(std::uint32_t label, const std::vector<double>& x) const {
    const double radius = radius_of(label);
    const auto place = seen_from(label, x.data());
    if (!place || pairing(*place, *place) < radius * radius) return false;
    bool result = true;
    cells_.visit(x.data(), most_stretch * radius, [&](std::uint32_t other, double squared) {
      const auto there = seen_from(label, cells_[other]);
      if (there) {
        const auto offset = difference(*there, *place);
        result = pairing(offset, offset) >= radius * radius;
      }
      if (squared <= square_of(step_)) result = false;
      return !result;
    });
    return result;
  }

  const EmbeddedManifold& manifold_;
  Sizing sizing_;
  double greatest_;
  std::size_t n_;
  double step_;
  std::unique_ptr<ManifoldSampler> sampler_;
  AmbientGrid cells_;
  std::vector<Dense<double>> frames_;
  std::vector<std::array<double, 2>> box_;
  std::vector<double> units_;  // radii, as parts of the greatest
};

[[noreturn]] void refuse_part(const EmbeddedManifold& manifold, const CoverReport& report) {
  const BoxPart& part = report.open.front();
  if (!manifold.is_smooth())
    throw UncoveredPart(manifold.name() + ": undecided near " + rough_text(part.lower) +
                        ": this part of the mesh is not certainly in a patch");
  throw UncoveredPart(manifold.name() + ": undecided at the part of the box from " + rough_text(part.lower) + " to " +
                      rough_text(part.upper) +
                      ": it may have zeros of the equations, and is in no patch; there may be a singular point, a "
                      "component of the manifold "
                      "that is too small for the sampling radius, or the manifold may go through the side of the box");
}

}  // namespace

template <int m>
struct SubmanifoldSampling<m>::State {
  State(const EmbeddedManifold& set, const Rational& radius, Sizing sizing)
      : manifold(set),
        greatest(radius),
        points(set, std::move(sizing)),
        sampling(points, Curvature::zero, approximate_double(radius)) {}

  const EmbeddedManifold& manifold;
  Rational greatest;
  SubmanifoldPoints<m> points;
  DiskSampling<m, SubmanifoldPoints<m>> sampling;
  bool is_begun = false;
};

template <int m>
SubmanifoldSampling<m>::SubmanifoldSampling(const EmbeddedManifold& manifold, const Rational& radius, Sizing sizing,
                                            std::uint64_t seed)
    : seed_(seed) {
  if (radius <= Rational(0)) throw InputError("the radius of a net is above 0");
  state_ = std::make_unique<State>(manifold, radius, std::move(sizing));
}
template <int m>
SubmanifoldSampling<m>::~SubmanifoldSampling() = default;

template <int m>
SubmanifoldNet<m> SubmanifoldSampling<m>::complete_in_box(const Progress& progress) {
  constexpr int most_rounds = 16;
  auto& [manifold, greatest, points, sampling, is_begun] = *state_;
  if (!is_begun) sampling.throw_darts(seed_, progress);
  is_begun = true;
  for (int round = 0;; ++round) {
    sampling.fill_gaps(seed_, progress);
    SubmanifoldNet<m> result;
    auto [centres, radii] = points.ordered(greatest);
    result.centres = std::move(centres);
    result.radii = std::move(radii);
    if (points.size() > 0) result.charts = manifold.fit_charts(result.centres, result.radii, progress);
    const CoverReport cover = manifold.check_cover(result.charts.charts, progress);
    result.covering_radius = sampling.covering_radius();
    result.parts = cover.parts;
    if (cover.open.empty()) {
      if (points.size() == 0) throw Rejection(manifold.name() + ": no point of the box is a zero of the equations");
      return result;
    }
    bool is_longer = false;
    for (const BoxPart& part : cover.open) {
      std::vector<double> x;
      for (std::size_t axis = 0; axis < part.lower.size(); ++axis)
        x.push_back(part.lower[axis] / 2 + part.upper[axis] / 2);
      if (points.insert_from(std::move(x))) is_longer = true;
    }
    if (!is_longer || round == most_rounds) refuse_part(manifold, cover);
  }
}

template <int m>
SubmanifoldNet<m> SubmanifoldSampling<m>::complete(const Progress& progress) {
  try {
    return complete_in_box(progress);
  } catch (const Rejection&) {
    // What a singular point does to nets and charts says less than where it is.
    const EmbeddedManifold& manifold = state_->manifold;
    const auto part = manifold.singular_part();
    if (!part) throw;
    throw Undecided(manifold.name() + ": undecided at the part of the box from " + rough_text(part->lower) + " to " +
                    rough_text(part->upper) +
                    ": there may be a singular point, where the equations hold and their derivatives are dependent");
  }
}

template <int m>
void SubmanifoldSampling<m>::refine(const std::vector<std::vector<double>>& places) {
  constexpr double slope = 0.125;
  state_->points.refine(places, slope);
}
template class SubmanifoldSampling<1>;
template class SubmanifoldSampling<2>;
template class SubmanifoldSampling<3>;

template <int m>
SubmanifoldNet<m> submanifold_net(const EmbeddedManifold& manifold, const Rational& radius, std::uint64_t seed,
                                  const Progress& progress) {
  const Sizing constant(manifold.ambient(), approximate_double(radius));
  return SubmanifoldSampling<m>(manifold, radius, constant, seed).complete(progress);
}
template SubmanifoldNet<1> submanifold_net<1>(const EmbeddedManifold&, const Rational&, std::uint64_t, const Progress&);
template SubmanifoldNet<2> submanifold_net<2>(const EmbeddedManifold&, const Rational&, std::uint64_t, const Progress&);
template SubmanifoldNet<3> submanifold_net<3>(const EmbeddedManifold&, const Rational&, std::uint64_t, const Progress&);

std::uint64_t require_cover(const EmbeddedManifold& manifold, const std::vector<TangentChart>& charts,
                            const Progress& progress) {
  const CoverReport report = manifold.check_cover(charts, progress);
  if (!report.open.empty()) refuse_part(manifold, report);
  return report.parts;
}

}  // namespace delcert
