#include "properties/instances/configuration_draw.hpp"

#include <utility>

#include "kernel/number/ladder.hpp"
#include "kernel/simplex/edges.hpp"
#include "kernel/simplex/thickness.hpp"
#include "properties/instances/configuration_skeleton.hpp"

namespace delcert {

namespace {

using Points = SimplexObject::Points;
using Point = std::vector<Rational>;

constexpr unsigned root_bits = 40;
constexpr long lowest_flake_exponent = 200;

/// The points around the centre of a hexagon of the net, pulled towards it: with ε = 1, μ₀ = 17/10, ρ₀ = 17/40 the
/// hexagonal lattice of edge 17/10 is a net (each point of the plane is closer than 1 to it), and its points at
/// distance 17/10 from one of them may move to distance 13/10 of it.
const Rational hexagonal_separation = Rational(17) / Rational(10);
const Rational hexagonal_perturbation = hexagonal_separation / Rational(4);
const Rational hexagonal_radius = Rational(13) / Rational(10);

Points hexagonal_directions(Choices& choices) {
  const Point right{Rational(1), Rational(0)};
  Point up = rational_direction({0.5, 0.8660254037844386}, 10);
  if (choices.happens(0.5)) up[0] = -up[0];
  Points result{right, up};
  result.push_back({-right[0], -right[1]});
  result.push_back({-up[0], -up[1]});
  return result;
}

class Draw {
 public:
  Draw(const Shape& shape, const Bindings& bound, const Limits& limits, Choices& choices)
      : k_(static_cast<std::size_t>(shape.k)),
        m_(static_cast<std::size_t>(shape.m)),
        bound_(bound),
        limits_(limits),
        choices_(choices) {}

  std::optional<Configuration> forbidden_configuration() {
    ConfigurationSkeleton skeleton = draw_configuration_skeleton(k_, choices_);
    const std::size_t moved = static_cast<std::size_t>(choices_.between(0, static_cast<long>(k_) + 1));
    Rational radius = k_ == m_ ? Rational(1) - Rational::power_of_two(-choices_.between(1, 24))
                               : Rational(1) - (Rational(1) - choices_.fraction(6)) * Rational(3) / Rational(4);
    const bool hexagonal = k_ == 2 && m_ == 2 && !limits_.most("mu0", bound_, true) && choices_.happens(0.25);
    if (hexagonal) {
      skeleton.points = hexagonal_directions(choices_);
      radius = hexagonal_radius / (Rational(1) + hexagonal_perturbation);
      if (!take_net(hexagonal_separation, hexagonal_perturbation)) return std::nullopt;
    } else if (!draw_net(scaled_points(skeleton.points, radius))) {
      return std::nullopt;
    }
    if (!draw_flake_parameter(Rational(2) * square(result_.mu0) / Rational(25)) || !draw_protection()) {
      return std::nullopt;
    }
    if (skeleton.is_sliver && !tilt(skeleton)) return std::nullopt;
    if (!place(skeleton, moved, radius)) return std::nullopt;
    // The size at which ε = 1.
    finish(Rational(1) + result_.rho0);
    return result_;
  }

  /// Of the facet opposite to the moved vertex the distance of that vertex from its sphere is attained, up to 2^−depth,
  /// and the radius where the bound of edges leaves room.
  std::optional<Configuration> tight_properties() {
    constexpr long least_depth = 60;
    constexpr long greatest_depth = 400;
    const ConfigurationSkeleton skeleton{in_a_cap(choices_.unit()), false, {}, {}};
    const long depth = choices_.between(least_depth, greatest_depth);
    const auto first = static_cast<std::size_t>(choices_.between(0, static_cast<long>(k_) + 1));
    const Rational short_of = Rational(1) - Rational::power_of_two(-depth);
    const Rational longest = square_root_upper(squared_longest_edge(edge_gram_from_points(skeleton.points)), root_bits);
    const Rational radius = minimum(Rational(2), Rational(5) / Rational(2) / longest) * short_of;
    if (!draw_separation(scaled_points(skeleton.points, radius))) return std::nullopt;
    if (!draw_flake_parameter(cube(result_.mu0) * Rational::power_of_two(-17)) || !draw_protection()) {
      return std::nullopt;
    }
    const Rational shift = result_.hoop_bound() * radius * short_of;
    for (std::size_t at = 0; at < k_ + 2; ++at) {
      for (const Rational& here : {-shift, shift}) {
        set_points(skeleton.points, (first + at) % (k_ + 2), radius, here, Rational(0));
        if (!has_forbidden_properties(result_)) continue;
        finish(Rational(1));
        return result_;
      }
    }
    return std::nullopt;
  }

  std::optional<Configuration> forbidden_properties() {
    ConfigurationSkeleton skeleton = draw_configuration_skeleton(k_, choices_);
    if (!skeleton.is_sliver && choices_.happens(0.6)) skeleton.points = in_a_cap(choices_.unit());
    const std::size_t moved = static_cast<std::size_t>(choices_.between(0, static_cast<long>(k_) + 1));
    const Rational short_of = Rational(1) - Rational::power_of_two(-choices_.between(2, 30));
    const Rational longest = square_root_upper(squared_longest_edge(edge_gram_from_points(skeleton.points)), root_bits);
    const Rational radius = shortened_down(minimum(Rational(2), Rational(5) / Rational(2) / longest) * short_of, 30);
    if (!draw_separation(scaled_points(skeleton.points, radius))) return std::nullopt;
    if (!draw_flake_parameter(cube(result_.mu0) * Rational::power_of_two(-17)) || !draw_protection()) {
      return std::nullopt;
    }
    if (skeleton.is_sliver && !tilt(skeleton)) return std::nullopt;
    if (!displace(skeleton, moved, radius)) return std::nullopt;
    finish(Rational(1));
    return result_;
  }

 private:
  static Rational cube(const Rational& x) { return square(x) * x; }

  Rational limit(const std::string& name, const Rational& own) const {
    return limits_.most(name, bound_, true).value_or(own);
  }

  /// A number from 0 to the limit, now and then the limit itself.
  Rational up_to(const Rational& most, double share_at_limit) {
    if (choices_.happens(share_at_limit)) {
      result_.at_boundary = true;
      return most;
    }
    return shortened_down(most * choices_.fraction(8), 12);
  }

  bool take_net(const Rational& mu0, const Rational& rho0) {
    result_.mu0 = mu0;
    result_.rho0 = rho0;
    result_.epsilon = Rational(1) / (Rational(1) + rho0);
    result_.perturbed_epsilon = Rational(1);
    result_.perturbed_mu0 = (mu0 - Rational(2) * rho0) / (Rational(1) + rho0);
    bound_["mu0"] = mu0;
    if (rho0 > limit("rho0", rho0)) return false;
    bound_["rho0"] = rho0;
    return true;
  }

  /// A little below the least distance of the points, for what moves later; 0 if they are much too close.
  static Rational safe_separation(const Points& points) {
    const Rational separation = square_root_lower(squared_separation(points), root_bits);
    if (separation < Rational::power_of_two(-7)) return Rational(0);
    return shortened_down(separation * (Rational(1) - Rational::power_of_two(-12)), 16);
  }

  /// μ₀, ρ₀, μ₀′ for points in the unit ε′ = 1: μ₀′ at most their separation.
  bool draw_net(const Points& points) {
    const Rational separation = safe_separation(points);
    if (separation == Rational(0)) return false;
    Rational mu0 = limit("mu0", Rational(1));
    mu0 = minimum(minimum(mu0, Rational(1)), shortened_down(Rational(5) / Rational(2) * separation, 12));
    if (choices_.happens(0.6)) mu0 = shortened_down(mu0 * (Rational(1) - choices_.fraction(7) / Rational(2)), 10);
    Rational least(0);
    Rational most(0);
    while (true) {
      bound_["mu0"] = mu0;
      // From (μ₀ − 2ρ₀)/(1 + ρ₀) ≤ separation.
      least = maximum(Rational(0), (mu0 - separation) / (Rational(2) + separation));
      if (least > Rational(0)) least = shortened_up(least, 16);
      most = limit("rho0", mu0 * Rational(9) / Rational(20));
      if (least <= most) break;
      mu0 = shortened_down(mu0 * Rational(15) / Rational(16), 12);
    }
    const double where = choices_.unit();
    Rational rho0 = least;
    if (where < 0.4) {
      rho0 = most;
      result_.at_boundary = true;
    } else if (where < 0.7) {
      rho0 = least + shortened_down((most - least) * choices_.fraction(8), 12);
    }
    if (!take_net(mu0, rho0)) return false;
    if (choices_.happens(0.15)) {
      // The separation as it is measured, not as the perturbation guarantees it.
      const Rational room = minimum(Rational(1), separation) - result_.perturbed_mu0;
      result_.perturbed_mu0 += shortened_down(room * choices_.fraction(6), 12);
    }
    return true;
  }

  /// μ₀ for points in the unit ε = 1, ρ₀ = 0.
  bool draw_separation(const Points& points) {
    const Rational separation = safe_separation(points);
    if (separation == Rational(0)) return false;
    Rational mu0 = minimum(minimum(limit("mu0", Rational(1)), Rational(1)), separation);
    if (choices_.happens(0.5)) mu0 = shortened_down(mu0 * (Rational(1) - choices_.fraction(7) / Rational(2)), 10);
    return take_net(mu0, Rational(0));
  }

  bool draw_flake_parameter(const Rational& own_most) {
    const auto given = limits_.most("gamma0", bound_, true);
    const Rational most = given ? minimum(*given, own_most) : own_most;
    if (most <= Rational(0)) return false;
    constexpr double at_limit = 0.125;
    const double u = choices_.unit();
    if (u < at_limit) {
      result_.gamma0 = most;
      if (given && most == *given) result_.at_boundary = true;
    } else {
      const double w = (u - at_limit) / (1.0 - at_limit);
      const double w2 = w * w;
      const double exponent = static_cast<double>(lowest_flake_exponent) * w2 * w2 * w2 * w2;
      const long whole = static_cast<long>(exponent);
      const Rational rest = Rational::exactly(1.0 - (exponent - static_cast<double>(whole)) / 2.0);
      result_.gamma0 = shortened_down(most * Rational::power_of_two(-whole) * rest, 6);
    }
    bound_["gamma0"] = result_.gamma0;
    return true;
  }

  bool draw_protection() {
    const auto most = limits_.most("delta0", bound_, true);
    protection_is_free_ = !most;
    const Rational own = power(result_.gamma0, static_cast<long>(m_) + 1);
    result_.delta0 = most ? up_to(*most, 0.5) : up_to(choices_.happens(0.5) ? Rational(1) / Rational(2) : own, 0.5);
    bound_["delta0"] = result_.delta0;
    return result_.delta0 >= Rational(0);
  }

  /// Makes the sliver hardly Γ₀-good: thickness Γ₀ᵏ(1 + a margin).
  bool tilt(ConfigurationSkeleton& skeleton) const {
    const Rational margin = Rational::power_of_two(-choices_.between(3, 16));
    const Rational goal = power(result_.gamma0, static_cast<long>(k_));
    const Rational wanted = goal * (Rational(1) + margin / Rational(2));
    Rational tilt = minimum(goal, Rational::power_of_two(-10));
    constexpr int rounds = 6;
    for (int round = 0; round < rounds; ++round) {
      skeleton.tilt_by(tilt);
      const auto squared = squared_thickness(edge_gram_from_points(skeleton.sliver()));
      if (!squared || *squared == Rational(0)) return false;
      const Rational thickness = square_root_lower(*squared, root_bits);
      if (thickness >= goal && thickness <= goal * (Rational(1) + margin)) return true;
      tilt = shortened_up(tilt * wanted / thickness, 20);
      if (tilt > Rational(1)) return false;
    }
    return false;
  }

  /// How far the moved vertex may leave ℝᵏ so that the least altitude stays below (k+1)Γ₀^{k+1}Δ: D(a, τ) is D(p, τ)
  /// times D(a, τ_p)/D(p, τ_a), by the volume of τ.
  std::optional<Rational> greatest_height(const Points& points, std::size_t moved) const {
    const EdgeGram<Rational> simplex = edge_gram_from_points(points);
    const EdgeGram<Rational> base = simplex.opposite_facet(moved);
    Rational gain(1);
    for (std::size_t a = 0; a < points.size(); ++a) {
      if (a == moved) continue;
      const auto here = squared_altitude(simplex.opposite_facet(a), moved > a ? moved - 1 : moved);
      const auto there = squared_altitude(base, a > moved ? a - 1 : a);
      if (!here || !there || *there == Rational(0)) return std::nullopt;
      gain = maximum(gain, *here / *there);
    }
    const Rational bound = square(Rational(static_cast<long>(k_) + 1)) * squared_longest_edge(simplex) * gain;
    return power(result_.gamma0, static_cast<long>(k_) + 1) * square_root_lower(bound, root_bits);
  }

  void set_points(const Points& unit, std::size_t moved, const Rational& radius, const Rational& shift,
                  const Rational& height) {
    result_.points = embedded_points(scaled_points(unit, radius), m_);
    for (std::size_t axis = 0; axis < k_; ++axis) {
      result_.points[moved][axis] = unit[moved][axis] * (radius + shift);
    }
    if (m_ > k_) result_.points[moved][k_] = height;
  }

  bool place(const ConfigurationSkeleton& skeleton, std::size_t moved, const Rational& radius) {
    Rational off = choices_.symmetric(6) * Rational(5) / Rational(4);
    off = maximum(Rational(-1), minimum(Rational(1), off)) * result_.protection();
    // Outwards, where it is far: so it leaves the other vertices.
    if (protection_is_free_) off = absolute(off);
    if (k_ == m_) {
      set_points(skeleton.points, moved, radius, off, Rational(0));
      return is_forbidden_configuration(result_);
    }
    const auto highest = greatest_height(scaled_points(skeleton.points, radius), moved);
    if (!highest) return false;
    Rational height = *highest * (Rational(1) - Rational::power_of_two(-choices_.between(1, 12)));
    if (choices_.happens(0.2)) height *= choices_.fraction(8);
    height = shortened_down(height, 12);
    // The centre of the ball is as far from ℝᵏ as the radius ε′ = 1 allows, or less.
    const Rational out = square_root_lower(Rational(1) - square(radius), 12) * choices_.symmetric(6);
    const bool keeps_off = choices_.happens(0.5);
    for (int attempt = 0; attempt < 4; ++attempt, height /= Rational(2)) {
      const Rational exact_shift = (Rational(2) * height * out - square(height)) / (Rational(2) * radius);
      const Rational shift =
          exact_shift < Rational(0) ? -shortened_down(-exact_shift, 20) : shortened_down(exact_shift, 20);
      set_points(skeleton.points, moved, radius, keeps_off ? shift + off : shift, height);
      if (is_forbidden_configuration(result_)) return true;
    }
    return false;
  }

  /// Directions within a cap, so that the sphere is large against the edges.
  Points in_a_cap(double u) const {
    std::vector<std::vector<double>> directions = spread_directions(k_, k_ == 2);
    const double distance = 1.0 + u;
    // Along no diagonal and no axis, so that opposite directions stay apart.
    constexpr double leaning = 0.25;
    for (auto& direction : directions) {
      for (std::size_t axis = 0; axis < k_; ++axis) {
        direction[axis] += distance * (axis == 0 ? leaning : 1.0) / square_root_of_axes();
      }
    }
    return jittered(directions, jitter_amplitude(choices_) / 4.0, choices_);
  }
  double square_root_of_axes() const {
    // Of k ≤ 6, to an accuracy that does not matter.
    constexpr double roots[] = {1.0, 1.0, 1.4, 1.7, 2.0, 2.2, 2.4};
    return roots[std::min<std::size_t>(k_, 6)];
  }

  /// Moves one vertex until the worst d(v, S(τ_v))/R(τ_v) is α₀ or a little less.
  bool displace(const ConfigurationSkeleton& skeleton, std::size_t moved, const Rational& radius) {
    const Rational goal = result_.hoop_bound();
    const Rational margin = Rational::power_of_two(-choices_.between(3, 20));
    const bool outwards = choices_.happens(0.5);
    const Rational along = outwards ? Rational(1) : Rational(-1);
    const Rational aside = m_ > k_ ? choices_.fraction(6) : Rational(0);
    Rational size = shortened_down(goal * radius / Rational(4), 20);
    constexpr int rounds = 8;
    const auto move_by = [&](const Rational& by) {
      set_points(skeleton.points, moved, radius, by * along * (Rational(1) - aside), by * aside);
    };
    for (int round = 0; round < rounds; ++round) {
      move_by(size);
      const Rational hoop = approximate_hoop(edge_gram_from_points(result_.points));
      if (hoop == Rational(0)) break;
      const bool is_close = hoop <= goal && hoop >= goal * (Rational(1) - Rational(2) * margin);
      if (is_close && has_forbidden_properties(result_)) return true;
      if (is_close) break;
      size = shortened_down(size * goal * (Rational(1) - margin) / hoop, 28);
    }
    // A large move can spoil a facet; none at all leaves all vertices on one sphere.
    for (const long fewer : {1L, 8L, 40L, 120L}) {
      move_by(size * Rational::power_of_two(-fewer));
      if (has_forbidden_properties(result_)) return true;
    }
    move_by(Rational(0));
    return has_forbidden_properties(result_);
  }

  /// Turned, scaled and shifted.
  void finish(const Rational& factor) {
    if (choices_.happens(0.4)) {
      Point normal;
      for (std::size_t axis = 0; axis < m_; ++axis) normal.emplace_back(choices_.between(-3, 3));
      result_.points = mirrored_points(std::move(result_.points), normal);
    }
    if (choices_.happens(0.15)) {
      for (std::size_t axis = 0; axis < m_; ++axis) {
        const Rational shift = choices_.symmetric(4) * Rational(4);
        for (Point& point : result_.points) point[axis] += shift;
      }
    }
    result_ = scaled(std::move(result_), factor);
  }

  std::size_t k_;
  std::size_t m_;
  Bindings bound_;
  const Limits& limits_;
  Choices& choices_;
  Configuration result_;
  bool protection_is_free_ = false;
};

}  // namespace

std::optional<Configuration> draw_forbidden_configuration(const Shape& shape, const Bindings& bound,
                                                          const Limits& limits, Choices& choices) {
  if (shape.k < 2 || shape.k > shape.m) return std::nullopt;
  return Draw(shape, bound, limits, choices).forbidden_configuration();
}

std::optional<Configuration> draw_forbidden_properties(const Shape& shape, const Bindings& bound, const Limits& limits,
                                                       Choices& choices) {
  if (shape.k < 2 || shape.k > shape.m) return std::nullopt;
  return Draw(shape, bound, limits, choices).forbidden_properties();
}

std::optional<Configuration> draw_tight_properties(const Shape& shape, const Bindings& bound, const Limits& limits,
                                                   Choices& choices) {
  if (shape.k < 2 || shape.k > shape.m) return std::nullopt;
  return Draw(shape, bound, limits, choices).tight_properties();
}

}  // namespace delcert
