#include "properties/instances/adaptive_sampling_class.hpp"

#include "proofs/formula/simplex_object.hpp"
#include "properties/instances/net_lipschitz.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

const SizingObject& sizing_in(const Bindings& bindings) { return object_in<SizingObject>(bindings, "f"); }
const std::vector<Rational>& coordinates_in(const Bindings& bindings, const char* name) {
  return object_in<PointObject>(bindings, name).coordinates();
}

ObjectPointer on_axis(std::size_t dimension, const Rational& coordinate) {
  std::vector<Rational> point(dimension);
  point[0] = coordinate;
  return std::make_shared<PointObject>(std::move(point));
}

/// The function at a point of the first axis. Precondition: the apexes are on it.
Rational on_axis(const SizingObject& f, const Rational& coordinate) {
  Rational least = f.cones()[0].height + f.slope() * absolute(coordinate - f.cones()[0].apex[0]);
  for (const auto& cone : f.cones()) {
    least = minimum(least, cone.height + f.slope() * absolute(coordinate - cone.apex[0]));
  }
  return least;
}

class AdaptiveSamplingClass : public InstanceClass {
 public:
  std::string name() const override { return "adaptive-sampling"; }
  std::string meaning() const override {
    return "a positive nu-Lipschitz function f on R^m; a centre a, a sample x at distance d of it and a sample y, x "
           "and "
           "y at distance at least mu_hat*f(x) and mu_hat*f(y); c > 0";
  }
  Signature signature() const override {
    return {{"f", types::sizing},      {"a", types::point},   {"x", types::point},
            {"y", types::point},       {"nu", types::number}, {"c", types::number},
            {"mu_hat", types::number}, {"d", types::number},  {"m", types::integer}};
  }
  void extend(Vocabulary& vocabulary) const override { add_sizing_quantities(vocabulary); }
  std::vector<Shape> shapes() const override { return {{0, 1}, {0, 2}, {0, 3}}; }

  // Along one axis, where the function changes as fast as it may.
  std::optional<Instance> draw(const Shape& shape, const Bindings& given, const Limits& limits,
                               Choices& choices) const override {
    Instance instance{given, {}};
    Bindings& bindings = instance.bindings;
    const auto dimension = static_cast<std::size_t>(shape.m);
    bindings["m"] = static_cast<long>(shape.m);
    const auto reach = [&](const char* name, const Rational& generous) {
      const auto limit = limits.most(name, bindings, true);
      // Below it, for hypotheses with <.
      const Rational most = (limit ? *limit : generous) * (Rational(1) - Rational::power_of_two(-41));
      const bool all = choices.happens(0.4);
      if (limit && all) instance.traits.insert(Trait::boundary);
      bindings[name] = all ? most : most * (choices.fraction(10) + Rational::power_of_two(-10));
    };
    reach("nu", Rational(2));
    reach("c", Rational(4));
    const Rational& nu = number_in(bindings, "nu");
    // Below 1/ν, so that there is a y where the function rises.
    reach("mu_hat", minimum(Rational(1), Rational(3) / (Rational(4) * nu)));
    std::vector<SizingObject::Cone> cones;
    const long count = choices.happens(0.5) ? 1 : choices.between(2, 3);
    for (long at = 0; at < count; ++at) {
      std::vector<Rational> apex(dimension);
      apex[0] = choices.symmetric(8) * Rational::power_of_two(choices.between(-2, 4));
      if (at == 0 && choices.happens(0.3)) apex[0] = Rational(0);
      cones.push_back({std::move(apex), choices.fraction(8) + Rational::power_of_two(-8)});
    }
    auto f = std::make_shared<SizingObject>(nu, std::move(cones));
    bindings["f"] = ObjectPointer(f);
    bindings["a"] = on_axis(dimension, Rational(0));
    reach("d", Rational(4) * on_axis(*f, Rational(0)));
    if (number_in(bindings, "d") < Rational(0)) return std::nullopt;
    // More often towards the first apex, where the function falls.
    const bool falls = choices.happens(0.7);
    const bool is_right = f->cones()[0].apex[0] >= Rational(0);
    const Rational x = falls == is_right ? number_in(bindings, "d") : -number_in(bindings, "d");
    bindings["x"] = on_axis(dimension, x);
    // The nearest point on one side that is as far as both ask for; μ̂ν < 1.
    const Rational& mu = number_in(bindings, "mu_hat");
    const Rational step = mu * on_axis(*f, x);
    const Rational side = choices.happens(0.5) ? Rational(1) : Rational(-1);
    Rational y = x + side * step;
    if (mu * on_axis(*f, y) > step) {
      if (mu * nu >= Rational(1)) return std::nullopt;
      y = x + side * step / (Rational(1) - mu * nu);
    }
    bindings["y"] = on_axis(dimension, y);
    return instance;
  }

  std::vector<Bindings> simpler(const Bindings& bindings) const override {
    std::vector<Bindings> result;
    const SizingObject& f = sizing_in(bindings);
    for (std::size_t left_out = 0; f.cones().size() > 1 && left_out < f.cones().size(); ++left_out) {
      auto cones = f.cones();
      cones.erase(cones.begin() + static_cast<std::ptrdiff_t>(left_out));
      Bindings candidate = bindings;
      candidate["f"] = ObjectPointer(std::make_shared<SizingObject>(f.slope(), std::move(cones)));
      try {
        require(candidate);
        result.push_back(std::move(candidate));
      } catch (const InputError&) {
        // The samples are too close for the larger function.
      }
    }
    return result;
  }

  void require(const Bindings& bindings) const override {
    require_signature(*this, bindings);
    const SizingObject& f = sizing_in(bindings);
    if (static_cast<long>(f.dimension()) != std::get<long>(bindings.at("m"))) {
      throw InputError("m is not the dimension of f");
    }
    if (f.slope() != number_in(bindings, "nu")) throw InputError("nu is not the slope of f");
    if (number_in(bindings, "c") <= Rational(0) || number_in(bindings, "mu_hat") <= Rational(0)) {
      throw InputError("c and mu_hat are not above 0");
    }
    for (const char* name : {"a", "x", "y"}) {
      if (coordinates_in(bindings, name).size() != f.dimension())
        throw InputError(std::string(name) + " is not in R^m");
      for (std::size_t axis = 1; axis < f.dimension(); ++axis) {
        if (coordinates_in(bindings, name)[axis] != Rational(0))
          throw InputError(std::string(name) + " is not on the axis");
      }
    }
    for (const auto& cone : f.cones()) {
      for (std::size_t axis = 1; axis < f.dimension(); ++axis) {
        if (cone.apex[axis] != Rational(0)) throw InputError("an apex of f is not on the axis");
      }
    }
    const Rational& x = coordinates_in(bindings, "x")[0];
    const Rational& y = coordinates_in(bindings, "y")[0];
    if (absolute(x - coordinates_in(bindings, "a")[0]) != number_in(bindings, "d")) {
      throw InputError("d is not the distance of x from a");
    }
    const Rational distance = absolute(x - y);
    for (const Rational* at : {&x, &y}) {
      if (distance < number_in(bindings, "mu_hat") * on_axis(f, *at)) throw InputError("x and y are too close");
    }
  }
};

}  // namespace

const InstanceClass& adaptive_sampling_class() {
  static const AdaptiveSamplingClass result;
  return result;
}

}  // namespace delcert
