#include "properties/instances/curved_net_class.hpp"

#include <algorithm>

#include "properties/instances/configuration_geometry.hpp"
#include "properties/instances/curved_net_bounds.hpp"
#include "properties/instances/net_draw.hpp"
#include "properties/instances/net_kinds_class.hpp"
#include "properties/instances/net_sample.hpp"
#include "properties/instances/net_star.hpp"
#include "properties/instances/space_star.hpp"
#include "properties/instances/space_star_vocabulary.hpp"
#include "properties/instances/space_vocabulary.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

/// The net is drawn for a ball of so many of its radii, and certified for one of 12 radii in the space.
constexpr long curved_net_factor = 13;
constexpr long ball_factor = 12;
/// Sampling radii are at most these parts of the unit: there are twelve of them in a ball, and more.
const Rational& largest_radius(Curvature curvature) {
  static const Rational on_spheres = Rational(3) / Rational(50);
  static const Rational in_hyperbolic_spaces = Rational(1) / Rational(32);
  return curvature == Curvature::positive ? on_spheres : in_hyperbolic_spaces;
}

/// Hypotheses that limit rho0, with room for what is lost between coordinates and charts.
class RoomForCharts : public Limits {
 public:
  RoomForCharts(const Limits& given, Rational share) : given_(given), share_(std::move(share)) {}
  std::optional<Rational> most(const std::string& name, const Bindings& bound, bool exact) const override {
    // Of the others, some are about quantities that are not there yet.
    if (name != "rho0") return std::nullopt;
    const auto limit = given_.most(name, bound, exact);
    return limit ? std::optional(*limit * share_) : std::nullopt;
  }

 private:
  const Limits& given_;
  Rational share_;
};

const SpaceObject& space_in(const Bindings& bindings, const std::string& name) {
  return object_in<SpaceObject>(bindings, name);
}

/// A net and its perturbation in coordinates, before they are put into a space.
struct FlatNets {
  std::vector<ExactPoint> p;
  std::vector<ExactPoint> q;
  Rational radius;
  Rational squared_separation;
  std::vector<std::uint32_t> neighbours;  ///< the other vertices of the star of the first point
  std::set<Trait> traits;
};

std::optional<FlatNets> draw_flat_nets(NetKind kind, int dimension, const Limits& limits, Choices& choices) {
  const Rational slack = Rational::power_of_two(-choices.between(6, 12));
  auto drawn = draw_perturbed_net(dimension, curved_net_factor, slack, {}, limits, choices, kind);
  if (!drawn) return std::nullopt;
  const auto& p = object_in<NetObject>(drawn->instance.bindings, "p");
  const auto& q = object_in<NetObject>(drawn->instance.bindings, "q");
  FlatNets result{p.points(), q.points(), p.sampling_radius(), Rational(0), {}, std::move(drawn->instance.traits)};
  with_net_dimension(dimension, [&]<int m>() {
    result.squared_separation = squared_separation<m>(p.vectors<m>());
    const auto cells = star_cells<m>(q.vectors<m>(), Rational(2) * p.sampling_radius());
    if (!cells) return;
    for (const auto& cell : *cells) result.neighbours.insert(result.neighbours.end(), cell.begin() + 1, cell.end());
  });
  std::sort(result.neighbours.begin(), result.neighbours.end());
  result.neighbours.erase(std::unique(result.neighbours.begin(), result.neighbours.end()), result.neighbours.end());
  if (result.neighbours.empty()) return std::nullopt;
  return result;
}

class CurvedNetClass : public NetKindsClass {
 public:
  std::string name() const override { return "curved-net"; }
  std::string meaning() const override {
    return "a net p of a ball of a sphere or a hyperbolic space about its first point, number i = 0, and its "
           "perturbation "
           "q, seen in the exponential charts at the points i and j of p; in both charts p is a net with mu0 and the "
           "sampling radii epsilon_i and epsilon_j for balls of eight of them, and q moves no point by more than rho0 "
           "of "
           "them; xi bounds the distortion of the transition from chart i, eta that of chart i, on the ball of radius "
           "6 epsilon_i; w is the part of q in this ball";
  }
  Signature signature() const override {
    Signature result{{"p", types::space_points}, {"q", types::space_points}, {"w", types::space_points},
                     {"m", types::integer},      {"i", types::integer},      {"j", types::integer}};
    for (const char* number : {"epsilon", "epsilon_i", "epsilon_j", "mu0", "rho0", "xi", "eta"}) {
      result[number] = types::number;
    }
    return result;
  }
  void extend(Vocabulary& vocabulary) const override { add_space_stars(vocabulary); }
  std::vector<Shape> shapes() const override { return {{0, 2}, {0, 3}}; }
  std::uint64_t cost(const Shape& shape) const override { return shape.m == 2 ? 40 : 3000; }
  std::string manifold(const Bindings& bindings) const override {
    return space_in(bindings, "p").curvature() == Curvature::positive ? "sphere" : "hyperbolic space";
  }

  void require(const Bindings& bindings) const override {
    require_signature(*this, bindings);
    const auto refuse = [this](const std::string& why) { throw InputError(name() + ": " + why); };
    const SpaceObject& p = space_in(bindings, "p");
    const SpaceObject& q = space_in(bindings, "q");
    if (p.curvature() != q.curvature() || p.unit() != q.unit() || p.dimension() != q.dimension() ||
        p.size() != q.size()) {
      refuse("p and q are not of one space, or not as many points");
    }
    for (const SpaceObject* space : {&p, &q}) {
      for (const ExactPoint& point : space->points()) {
        if (Rational(1) < pairing(point, point)) refuse("a point is far from the origin");
      }
    }
    if (std::get<long>(bindings.at("m")) != p.dimension()) refuse("m is not the dimension of p");
    if (pairing(p.points()[0], p.points()[0]) != Rational(0)) refuse("the first point of p is not the origin");
    if (std::get<long>(bindings.at("i")) != 0) refuse("i is not 0");
    const long j = std::get<long>(bindings.at("j"));
    if (j <= 0 || static_cast<std::size_t>(j) >= p.size()) refuse("j is not the number of another point of p");
    const auto& epsilon = number_in(bindings, "epsilon");
    const auto& radius_i = number_in(bindings, "epsilon_i");
    const auto& radius_j = number_in(bindings, "epsilon_j");
    for (const Rational* radius : {&epsilon, &radius_i, &radius_j}) {
      if (*radius <= Rational(0) || Rational(8) * *radius > p.unit()) refuse("a sampling radius is not in (0, 1/8]");
    }
    const BigInterval apart = *distance_in_space<BigInterval>(p, 0, static_cast<std::size_t>(j));
    if (!is_proved(less(apart, BigInterval(Rational(4) * epsilon)))) refuse("j is not within 4 epsilon of i");
    require_density(p, epsilon);
    const auto bounds = curved_net_bounds(p, q, static_cast<std::size_t>(j), epsilon, radius_i, radius_j,
                                          squared_separation_in_coordinates(p));
    if (!bounds.has_room) refuse("the charts are not within the ball of radius 12 epsilon");
    for (const Rational* radius : {&radius_i, &radius_j}) {
      if (*radius < radius_in_chart(p, epsilon, *radius)) refuse("p is not certainly dense in a chart");
    }
    const auto& mu0 = number_in(bindings, "mu0");
    const auto& rho0 = number_in(bindings, "rho0");
    if (mu0 <= Rational(0) || bounds.separation < mu0 * maximum(radius_i, radius_j)) {
      refuse("p is not certainly mu0-separated in the charts");
    }
    if (rho0 * minimum(radius_i, radius_j) < bounds.displacement) refuse("q is not certainly within rho0 of p");
    if (number_in(bindings, "xi") < bounds.distortion)
      refuse("the transition is not certainly distorted by at most xi");
    if (number_in(bindings, "eta") < bounds.metric_distortion)
      refuse("chart i is not certainly distorted by at most eta");
    const auto region = points_within(q, Rational(6) * radius_i);
    if (!region || region->points() != space_in(bindings, "w").points() ||
        region->curvature() != space_in(bindings, "w").curvature() ||
        region->unit() != space_in(bindings, "w").unit()) {
      refuse("w is not the part of q in the ball of radius 6 epsilon_i");
    }
  }

 private:
  /// In coordinates that are scaled by a power of two, so that lengths are about 1.
  void require_density(const SpaceObject& p, const Rational& epsilon) const {
    const Rational scale = Rational::power_of_two(-binary_exponent(epsilon / p.unit()));
    NetObject::Points points;
    for (const ExactPoint& point : p.points()) points.push_back(combined(ExactPoint(point.size()), scale, point));
    const Rational ball = ball_in_coordinates(p, Rational(ball_factor) * epsilon);
    const NetObject net(std::move(points), scale * epsilon / p.unit(), scale * ball);
    if (!net.covering() || epsilon < covering_in_space(p, net.covering()->upper / scale, ball)) {
      throw InputError(name() + ": p is not certified to be epsilon-dense in the space");
    }
  }

  /// A net and its place in a space but for the size.
  struct Draw {
    FlatNets nets;
    Curvature curvature = Curvature::positive;
    Rational unit;
    std::size_t j = 0;
    Rational more_i;  ///< the sampling radii are so many times what they have to be
    Rational more_j;
    const Bindings& given;

    /// At a size at which the sampling radius is about the given one, in units.
    [[nodiscard]] std::optional<Instance> at(const Rational& radius) const {
      auto result = in_space(*this, radius);
      if (result) result->traits = nets.traits;
      return result;
    }
  };

  std::optional<Instance> draw_of(NetKind kind, const Shape& shape, const Bindings& given, const Limits& limits,
                                  Choices& choices) const override {
    const Curvature curvature = choices.happens(0.5) ? Curvature::positive : Curvature::negative;
    const bool is_free = choices.happens(0.06);
    const Rational share = choices.happens(0.5) ? Rational(1) : Rational(1) - choices.fraction(5);
    const Rational wide = largest_radius(curvature) * (Rational(1) - choices.fraction(5) * Rational(7) / Rational(8));
    const Rational unit = choices.happens(0.7) ? Rational(1) : Rational::power_of_two(choices.between(-20, 20));
    const Rational more_i = choices.happens(0.5) ? Rational(1) : Rational(1) + choices.fraction(4) / Rational(16);
    const Rational more_j = choices.happens(0.5) ? Rational(1) : Rational(1) + choices.fraction(4) / Rational(16);
    const RoomForCharts room(limits, Rational(2) / Rational(3));
    // Of a lattice that is protected by curvature alone, no size is small enough: another one then.
    constexpr int tries = 4;
    for (int attempt = 0; attempt < tries; ++attempt) {
      auto nets = draw_flat_nets(kind, shape.m, room, choices);
      if (!nets) continue;
      const long last = static_cast<long>(nets->neighbours.size()) - 1;
      const std::size_t j = nets->neighbours[static_cast<std::size_t>(choices.between(0, last))];
      const Draw draw{*std::move(nets), curvature, unit, j, more_i, more_j, given};
      auto result = draw.at(wide);
      if (result && !is_free) result = shrunk(draw, *std::move(result), limits, share);
      if (result && has_certified_stars(result->bindings)) return result;
    }
    return std::nullopt;
  }

  /// Ties, which enclosures cannot decide, are not drawn.
  static bool has_certified_stars(const Bindings& bindings) {
    const SpaceObject& p = space_in(bindings, "p");
    const auto j = static_cast<std::size_t>(std::get<long>(bindings.at("j")));
    return star_in_chart(space_in(bindings, "q"), p.points()[0]) &&
           star_in_chart(space_in(bindings, "q"), p.points()[j]);
  }

  /// So small that the distortions are a share of what the hypotheses allow, or what they allow; nothing where that
  /// does not succeed.
  static std::optional<Instance> shrunk(const Draw& draw, Instance instance, const Limits& limits,
                                        const Rational& share) {
    constexpr int rounds = 3;
    for (const char* distortion : {"xi", "eta"}) {
      // What is allowed depends on the size a little.
      for (int round = 0; round <= rounds; ++round) {
        const auto limit = limits.most(distortion, instance.bindings, false);
        if (!limit) break;
        const Rational now = number_in(instance.bindings, distortion);
        if (round > 0 && now <= *limit) {
          if (share == Rational(1)) {
            instance.bindings[distortion] = *limit;
            instance.traits.insert(Trait::boundary);
          }
          break;
        }
        if (*limit <= Rational(0) || round == rounds) return std::nullopt;
        // A distortion grows with the square of the radius, and a little faster.
        const Rational ratio = *limit * share * Rational(63) / Rational(64) / now;
        const Rational factor = minimum(Rational(1), square_root_lower(ratio, 12));
        auto smaller = draw.at(shortened_down(radius_of(instance) * factor, 10));
        if (!smaller) return std::nullopt;
        instance = *std::move(smaller);
      }
    }
    return instance;
  }

  /// In units.
  static Rational radius_of(const Instance& instance) {
    return number_in(instance.bindings, "epsilon") / space_in(instance.bindings, "p").unit();
  }

  /// With all that is bound.
  static std::optional<Instance> in_space(const Draw& draw, const Rational& radius) {
    const FlatNets& nets = draw.nets;
    const std::size_t j = draw.j;
    const Rational factor = shortened_down(radius / nets.radius, 10);
    const auto scaled = [&](const std::vector<ExactPoint>& points) {
      std::vector<ExactPoint> result;
      for (const ExactPoint& point : points) result.push_back(combined(ExactPoint(point.size()), factor, point));
      return result;
    };
    const auto p = std::make_shared<SpaceObject>(draw.curvature, draw.unit, scaled(nets.p));
    const auto q = std::make_shared<SpaceObject>(draw.curvature, draw.unit, scaled(nets.q));
    for (const SpaceObject* space : {p.get(), q.get()}) {
      for (const ExactPoint& point : space->points()) {
        if (Rational(1) < pairing(point, point)) return std::nullopt;
      }
    }
    constexpr unsigned bits = 20;
    const Rational ball = Rational(curved_net_factor) * nets.radius * factor;
    const Rational epsilon = shortened_up(covering_in_space(*p, nets.radius * factor, ball), bits);
    if (ball < ball_in_coordinates(*p, Rational(ball_factor) * epsilon)) return std::nullopt;
    const auto radius_for = [&](const Rational& more) {
      // It depends on itself a little.
      Rational result = epsilon;
      for (int round = 0; round < 2; ++round) {
        result = shortened_up(radius_in_chart(*p, epsilon, result) * (more + Rational::power_of_two(-10)), bits);
      }
      return result;
    };
    const Rational radius_i = radius_for(draw.more_i);
    const Rational radius_j = radius_for(draw.more_j);
    for (const Rational* chosen : {&radius_i, &radius_j}) {
      if (*chosen < radius_in_chart(*p, epsilon, *chosen)) return std::nullopt;
    }
    const auto bounds =
        curved_net_bounds(*p, *q, j, epsilon, radius_i, radius_j, square(factor) * nets.squared_separation);
    if (!bounds.has_room) return std::nullopt;
    auto region = points_within(*q, Rational(6) * radius_i);
    if (!region) return std::nullopt;
    Instance result{draw.given, {}};
    Bindings& bindings = result.bindings;
    bindings["p"] = ObjectPointer(p);
    bindings["q"] = ObjectPointer(q);
    bindings["w"] = ObjectPointer(std::make_shared<SpaceObject>(*std::move(region)));
    bindings["m"] = static_cast<long>(p->dimension());
    bindings["i"] = 0L;
    bindings["j"] = static_cast<long>(j);
    bindings["epsilon"] = epsilon;
    bindings["epsilon_i"] = radius_i;
    bindings["epsilon_j"] = radius_j;
    bindings["mu0"] = shortened_down(bounds.separation / maximum(radius_i, radius_j), bits);
    bindings["rho0"] = bounds.displacement == Rational(0)
                           ? Rational(0)
                           : shortened_up(bounds.displacement / minimum(radius_i, radius_j), bits);
    bindings["xi"] = shortened_up(bounds.distortion, bits);
    bindings["eta"] = shortened_up(bounds.metric_distortion, bits);
    return result;
  }
};

}  // namespace

const InstanceClass& curved_net_class() {
  static const CurvedNetClass result;
  return result;
}

}  // namespace delcert
