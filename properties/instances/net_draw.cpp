#include "properties/instances/net_draw.hpp"

#include <algorithm>

#include "kernel/manifold/flat_atlas.hpp"
#include "kernel/perturb/perturbation.hpp"
#include "proofs/certificate/run_parameters.hpp"
#include "properties/instances/net_forbidden.hpp"
#include "properties/instances/net_sample.hpp"
#include "properties/instances/net_star.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

/// Perturbed nets are meant for a ball smaller than that of the net by this many sampling radii.
const Rational& margin() {
  static const Rational result = Rational(Integer(5), Integer(4));
  return result;
}

template <int m>
class NetDraw {
 public:
  NetDraw(NetKind kind, long factor, const Rational& slack, const Bindings& given, const Limits& limits,
          Choices& choices)
      : kind_(kind), factor_(factor), slack_(slack), limits_(limits), choices_(choices) {
    result_.instance.bindings = given;
  }

  std::optional<PerturbedNet> run() {
    result_.instance.bindings["m"] = static_cast<long>(m);
    if (!bind_net() || !bind_separation()) return std::nullopt;
    bind_perturbation();
    move();
    bind_forbidden();
    try {
      bindings()["q"] = ObjectPointer(std::make_shared<NetObject>(coordinate_lists<m>(moved_),
                                                                  (Rational(1) + perturbation_) * epsilon_,
                                                                  (Rational(factor_) - margin()) * epsilon_));
    } catch (const InputError&) {
      return std::nullopt;  // two points moved to the same place
    }
    return std::move(result_);
  }

 private:
  Bindings& bindings() { return result_.instance.bindings; }

  bool bind_net() {
    const long reach = slack_ > Rational(0) ? factor_ + 1 : factor_;
    auto sample = kind_ == NetKind::any ? draw_net<m>(reach, choices_) : draw_nearly_degenerate_net<m>(reach, choices_);
    points_ = std::move(sample.points);
    result_.is_cospherical = sample.family == NetFamily::lattice;
    const Rational wanted = sample.radius * (Rational(1) + Rational::power_of_two(-20)) * (Rational(1) + slack_);
    epsilon_ = rounded_up(wanted, binary_exponent(wanted) - 26);
    const auto net = std::make_shared<NetObject>(coordinate_lists<m>(points_), epsilon_, Rational(factor_) * epsilon_);
    // A little below, so that what is derived of it can be certified too.
    if (!net->covering() || net->covering()->upper > epsilon_ * (Rational(1) - Rational::power_of_two(-24)))
      return false;
    bindings()["p"] = ObjectPointer(net);
    bindings()["epsilon"] = epsilon_;
    return true;
  }

  bool bind_separation() {
    const Rational squared = squared_separation<m>(points_);
    const Rational length = square_root_lower(squared, 60);
    const Rational ratio = length * (Rational(1) - slack_) / epsilon_;
    separation_ =
        slack_ == Rational(0) && square(length) == squared && choices_.happens(0.3) ? ratio : rounded_down(ratio, -30);
    if (const auto limit = limits_.most("mu0", bindings(), true)) separation_ = minimum(separation_, *limit);
    bindings()["mu0"] = separation_;
    return separation_ > Rational(0);
  }

  void bind_perturbation() {
    const auto limit = limits_.most("rho0", bindings(), true);
    const Rational generous =
        choices_.happens(0.5) ? separation_ / Rational(4) : minimum(Rational(5), Rational(8) * separation_);
    const Rational most = limit ? maximum(Rational(0), *limit) : generous;
    perturbation_ = choices_.happens(0.4) ? most : most * choices_.fraction(8);
    if (limit && perturbation_ == most) result_.instance.traits.insert(Trait::boundary);
    bindings()["rho0"] = perturbation_;
  }

  /// Moves the points; by the algorithm, those that can matter for Q′.
  void move() {
    if (kind_ == NetKind::nearly_degenerate) {
      moved_ = points_;
      return;
    }
    const auto seed = static_cast<std::uint64_t>(choices_.between(0, (1L << 40) - 1));
    const long kind = choices_.between(0, 4);
    const Rational length = perturbation_ * epsilon_;
    const bool can_run =
        perturbation_ > Rational(0) && perturbation_ <= minimum(Rational(1), separation_) / Rational(4);
    if (kind == 4 && can_run) {
      run_algorithm_here(seed);
    } else {
      const auto motion = static_cast<NetMotion>(kind == 4 ? 0 : kind);
      Vector<Rational, m> centre{};
      Rational reach = Rational(20) * epsilon_;
      if (motion == NetMotion::outward) {
        const auto cells = star_cells<m>(points_, Rational(2) * epsilon_);
        if (cells) centre = hole(*cells);
        if (choices_.happens(0.5)) reach = Rational(3) * epsilon_;
      }
      moved_ = moved_points<m>(points_, length, motion, centre, reach, seed);
      if (motion == NetMotion::none && result_.is_cospherical) result_.instance.traits.insert(Trait::cospherical);
    }
  }

  /// The centre of the largest cell at the first point.
  Vector<Rational, m> hole(const StarCells& cells) const {
    Vector<Rational, m> best{};
    for (const auto& cell : cells) {
      const auto centre = centre_of<m>(points_, cell);
      if (pairing(centre, centre) > pairing(best, best)) best = centre;
    }
    return best;
  }

  void run_algorithm_here(std::uint64_t seed) {
    const Rational separation = minimum(Rational(1), separation_);
    FlatSpace<m> space;
    space.ball_radius = (Rational(factor_) + Rational(3)) * epsilon_;
    const FlatAtlas<m> atlas(space, PointSet<m>(points_), epsilon_);
    ParameterChoice choice;
    choice.mode = choices_.happens(0.5) ? RunMode::theory : RunMode::measured;
    choice.perturbation = perturbation_;
    choice.seed = seed;
    choice.clearance = Rational(0);  // the first good perturbation, as the paper has it
    choice.choices = 1;
    if (choice.mode == RunMode::measured) {
      choice.tolerance = minimum(default_tolerance(Dimension(m)), perturbation_ / Rational(16));
    }
    const auto parameters = parameters_for(Dimension(m), separation, choice);
    std::vector<Label> labels;
    const Rational reach = Rational(Integer(25), Integer(4)) * epsilon_;
    for (std::uint32_t at = 0; at < points_.size(); ++at) {
      if (pairing(points_[at], points_[at]) <= square(reach)) labels.emplace_back(at);
    }
    Perturbation<m> perturbation(atlas, parameters.algorithm);
    moved_ = points_;
    try {
      perturbation.place_anew(labels, no_progress());
    } catch (const Rejection&) {
      return;  // no good perturbation was found: none then
    }
    for (const Label label : labels) moved_[label.value] = perturbation.points().exact(label);
  }

  [[nodiscard]] bool has_forbidden(const Rational& flake_parameter, const Rational& protection) const {
    if (separation_ < Rational(2) * perturbation_) return false;
    NetPoints<m> region;
    for (const auto& point : moved_) {
      if (pairing(point, point) < square(Rational(6) * epsilon_)) region.push_back(point);
    }
    return find_forbidden_configuration<m>(region,
                                           {flake_parameter, (Rational(1) + perturbation_) * epsilon_,
                                            protection * (separation_ - Rational(2) * perturbation_) * epsilon_})
        .has_value();
  }

  void bind_forbidden() {
    const auto limit = limits_.most("gamma0", bindings(), false);
    if (!limit) {
      bindings()["gamma0"] = Rational::power_of_two(-6);
      const Rational most = limits_.most("delta0", bindings(), true).value_or(Rational(1));
      bindings()["delta0"] = choices_.happens(0.5) ? most : most * choices_.fraction(8);
      return;
    }
    // In space, with larger ones nearly everything is nearly a flake, and the search takes long.
    const Rational first = m == 2 ? *limit : minimum(*limit, Rational::power_of_two(-4));
    const unsigned bits = kind_ == NetKind::any ? 3 : 8;
    Rational flake_parameter =
        rounded_down(first, binary_exponent(first) - 10) * (Rational(1) - choices_.fraction(bits));
    const long powers = choices_.between(1, m + 1);
    const auto protection_for = [&](const Rational& flake) {
      bindings()["gamma0"] = flake;
      const auto most = limits_.most("delta0", bindings(), true);
      const Rational wanted = power(flake, powers);
      return most ? minimum(wanted, *most) : wanted;
    };
    bool is_free = false;
    if (!choices_.happens(0.08)) {
      is_free = choose_forbidden(flake_parameter, protection_for);
      if (!is_free && perturbation_ > Rational(0)) {
        // Cospherical as they are: moved at random, and again.
        moved_ = moved_points<m>(points_, perturbation_ * epsilon_, NetMotion::random, {}, Rational(0), 1);
        result_.instance.traits.erase(Trait::cospherical);
        is_free = choose_forbidden(flake_parameter, protection_for);
      }
    }
    Rational protection = protection_for(flake_parameter);
    if (is_free && !limits_.most("delta0", bindings(), true) && choices_.happens(m == 2 ? 0.4 : 0.1)) {
      protection = largest_protection(flake_parameter, protection);
      result_.instance.traits.insert(Trait::boundary);
    }
    bindings()["delta0"] = protection;
  }

  /// The largest protection, within 1 %, for which there is still no forbidden configuration. Precondition: there is
  /// none for the one given.
  Rational largest_protection(const Rational& flake_parameter, Rational least) const {
    Rational most = least;
    do {
      least = most;
      most = Rational(2) * least;
    } while (most < Rational(1) && !has_forbidden(flake_parameter, most));
    for (int round = 0; round < 7; ++round) {
      const Rational middle = rounded_down((least + most) / Rational(2), binary_exponent(least) - 12);
      (has_forbidden(flake_parameter, middle) ? most : least) = middle;
    }
    return least;
  }

  /// Halves the parameters until there is no forbidden configuration; false if that does not help.
  template <class ProtectionFor>
  bool choose_forbidden(Rational& flake_parameter, const ProtectionFor& protection_for) {
    constexpr long most_halvings = 48;
    const Rational first = flake_parameter;
    for (long halvings = 0; halvings <= most_halvings; halvings += halvings < 8 ? 1 : 8) {
      flake_parameter = first * Rational::power_of_two(-halvings);
      if (!has_forbidden(flake_parameter, protection_for(flake_parameter))) return true;
    }
    return false;
  }

  NetKind kind_;
  long factor_;
  Rational slack_;
  const Limits& limits_;
  Choices& choices_;
  PerturbedNet result_;
  NetPoints<m> points_;
  NetPoints<m> moved_;
  Rational epsilon_;
  Rational separation_;
  Rational perturbation_;
};

template <int m>
void require_perturbed(const Bindings& bindings, long factor) {
  const NetObject& p = object_in<NetObject>(bindings, "p");
  const NetObject& q = object_in<NetObject>(bindings, "q");
  const Rational& epsilon = number_in(bindings, "epsilon");
  if (p.size() != q.size() || q.dimension() != m) throw InputError("p and q are nets of different sizes");
  const auto points = p.vectors<m>();
  const auto moved = q.vectors<m>();
  if (pairing(points[0], points[0]) != Rational(0)) throw InputError("the first point of p is not 0");
  if (p.sampling_radius() != epsilon) throw InputError("the sampling radius of p is not epsilon");
  if (p.ball_radius() < Rational(factor) * epsilon) {
    throw InputError("p is not for a ball of radius " + std::to_string(factor) + " epsilon");
  }
  if (q.ball_radius() > p.ball_radius() - margin() * epsilon) throw InputError("q is for a ball that is too large");
  if (!p.covering() || p.covering()->upper > epsilon) throw InputError("p is not certified to be epsilon-dense");
  if (squared_separation<m>(points) < square(number_in(bindings, "mu0") * epsilon)) {
    throw InputError("p has points closer than mu0*epsilon");
  }
  const Rational& perturbation = number_in(bindings, "rho0");
  if (perturbation < Rational(0)) throw InputError("rho0 is negative");
  for (std::size_t at = 0; at < points.size(); ++at) {
    const auto step = difference(moved[at], points[at]);
    if (pairing(step, step) > square(perturbation * epsilon)) {
      throw InputError("point " + std::to_string(at) + " is moved by more than rho0*epsilon");
    }
  }
}

}  // namespace

Signature net_signature() {
  return {{"p", types::net},      {"q", types::net},       {"m", types::integer},     {"epsilon", types::number},
          {"mu0", types::number}, {"rho0", types::number}, {"gamma0", types::number}, {"delta0", types::number}};
}

std::optional<PerturbedNet> draw_perturbed_net(int dimension, long factor, const Rational& slack, const Bindings& given,
                                               const Limits& limits, Choices& choices, NetKind kind) {
  return with_net_dimension(dimension,
                            [&]<int m>() { return NetDraw<m>(kind, factor, slack, given, limits, choices).run(); });
}

std::vector<Bindings> simpler_nets(const Bindings& bindings) {
  const NetObject& p = object_in<NetObject>(bindings, "p");
  const NetObject& q = object_in<NetObject>(bindings, "q");
  const auto rebound = [&](NetObject::Points first, NetObject::Points second) {
    Bindings result = bindings;
    auto net = std::make_shared<NetObject>(std::move(first), p.sampling_radius(), p.ball_radius());
    if (!net->covering() || net->covering()->upper > number_in(bindings, "epsilon")) return Bindings{};
    result["p"] = ObjectPointer(std::move(net));
    result["q"] = ObjectPointer(std::make_shared<NetObject>(std::move(second), q.sampling_radius(), q.ball_radius()));
    return result;
  };
  std::vector<Bindings> result;
  const auto add = [&](NetObject::Points first, NetObject::Points second) {
    if (auto simpler = rebound(std::move(first), std::move(second)); !simpler.empty()) result.push_back(simpler);
  };
  if (p.points() != q.points()) {
    // The points outside the region of interest where they were.
    auto points = q.points();
    for (std::size_t at = 0; at < points.size(); ++at) {
      Rational squared(0);
      for (const Rational& coordinate : p.points()[at]) squared += square(coordinate);
      if (squared * Rational(16) > square(p.ball_radius()) * Rational(9)) points[at] = p.points()[at];
    }
    if (points != q.points()) add(p.points(), points);
  }
  return result;
}

void require_perturbed_net(const Bindings& bindings, long factor) {
  const NetObject& p = object_in<NetObject>(bindings, "p");
  if (std::get<long>(bindings.at("m")) != p.dimension()) throw InputError("m is not the dimension of p");
  with_net_dimension(p.dimension(), [&]<int m>() { require_perturbed<m>(bindings, factor); });
}

}  // namespace delcert
