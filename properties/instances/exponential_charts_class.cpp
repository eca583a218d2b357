#include "properties/instances/exponential_charts_class.hpp"

#include <array>

#include "properties/instances/configuration_geometry.hpp"
#include "properties/instances/random_simplex.hpp"
#include "properties/instances/space_vocabulary.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

/// The numbers of the points among those of x.
constexpr std::size_t centre_i = 0;
constexpr std::size_t centre_j = 1;
constexpr std::size_t point_a = 2;
constexpr std::size_t point_b = 3;
constexpr std::array<const char*, 4> point_names{"i", "j", "a", "b"};

/// What is farther on a sphere is close to the antipode.
constexpr long greatest_reach = 3;

ExactPoint direction_in_chart(int dimension, Choices& choices) {
  constexpr unsigned bits = 6;
  std::vector<double> direction;
  for (int axis = 0; axis < dimension; ++axis) direction.push_back(choices.unit() - 0.5);
  return rational_direction(direction, bits);
}

ExactPoint multiple_of(const Rational& factor, const ExactPoint& vector) {
  return combined(ExactPoint(vector.size(), Rational(0)), factor, vector);
}

/// A part of 1, often 1 itself, now and then very small.
Rational some_part(Choices& choices) {
  const double kind = choices.unit();
  if (kind < 0.45) return Rational(1);
  const Rational part = Rational(1) - choices.fraction(6) * Rational(15) / Rational(16);
  return kind < 0.85 ? part : part * Rational::power_of_two(-choices.between(1, 20));
}

/// Two charts and two points in units, the centre of the first at the origin.
class ChartDraw {
 public:
  ChartDraw(int dimension, Curvature curvature, Rational reach, Choices& choices)
      : dimension_(dimension),
        curvature_(curvature),
        reach_(std::move(reach)),
        longest_(conformal_length(curvature, reach_)),
        choices_(choices) {}

  SpaceObject run(const Rational& unit) {
    const bool is_far = choices_.happens(0.04);
    const ExactPoint j =
        multiple_of(is_far ? length(Rational(greatest_reach)) : length(reach_ * some_part(choices_)), any());
    ExactPoint a = first_point(j);
    ExactPoint b = second_point(a);
    if (choices_.happens(0.04)) {
      const Rational factor = length(Rational(greatest_reach)) / longest_;
      a = multiple_of(factor, a);
      b = multiple_of(factor, b);
    }
    return {curvature_, unit, {ExactPoint(static_cast<std::size_t>(dimension_), Rational(0)), j, a, b}};
  }

 private:
  [[nodiscard]] ExactPoint any() { return direction_in_chart(dimension_, choices_); }
  [[nodiscard]] Rational length(const Rational& distance) const { return conformal_length(curvature_, distance); }

  /// Opposite to j, where its chart is strained most; where j is; or anywhere in the ball, at its boundary by
  /// preference.
  [[nodiscard]] ExactPoint first_point(const ExactPoint& j) {
    const double kind = choices_.unit();
    const Rational size = length(reach_ * some_part(choices_));
    if (kind < 0.65) {
      const Rational squared = pairing(j, j);
      const Rational factor = size / square_root_upper(squared, 50);
      return kind < 0.4 ? multiple_of(-factor, j) : multiple_of(minimum(factor, Rational(1)), j);
    }
    return multiple_of(size, any());
  }

  /// Close to the first, across its ray from the origin by preference, or anywhere.
  [[nodiscard]] ExactPoint second_point(const ExactPoint& a) {
    ExactPoint b = any();
    if (choices_.happens(0.2)) return multiple_of(length(reach_ * some_part(choices_)), b);
    const Rational squared = pairing(a, a);
    if (choices_.happens(0.7)) b = combined(b, -(pairing(a, b) / squared), a);
    b = combined(a, square_root_upper(squared, 10) * Rational::power_of_two(-choices_.between(0, 24)), b);
    const Rational excess = pairing(b, b) / square(longest_);
    return excess <= Rational(1) ? b : multiple_of(Rational(1) / square_root_upper(excess, 50), b);
  }

  int dimension_;
  Curvature curvature_;
  Rational reach_;
  Rational longest_;
  Choices& choices_;
};

/// At least what the two points are from the centre j; nothing if one is its antipode.
std::optional<Rational> reach_in_second_chart(const SpaceObject& space) {
  for (const std::size_t point : {point_a, point_b}) {
    if (!space.seen_from(centre_j, point)) return std::nullopt;
  }
  const BigInterval reach = maximum(*distance_in_space<BigInterval>(space, centre_j, point_a),
                                    *distance_in_space<BigInterval>(space, centre_j, point_b));
  constexpr unsigned bits = 40;
  return shortened_up(reach.upper(), bits);
}

class ExponentialChartsClass : public InstanceClass {
 public:
  std::string name() const override { return "exponential-charts"; }
  std::string meaning() const override {
    return "points i, j, a, b = 0, 1, 2, 3 of x in a sphere or a hyperbolic space whose curvature has an absolute "
           "value of "
           "at most lambda, a and b different, and neither the antipode of i or j, whose exponential charts show them; "
           "r > 0 "
           "and s > 0 are lengths, most of the time such that j, a and b are within r of i, and a and b within s of j";
  }
  Signature signature() const override {
    Signature result{{"x", types::space_points},
                     {"m", types::integer},
                     {"lambda", types::number},
                     {"r", types::number},
                     {"s", types::number}};
    for (const char* point : point_names) result[point] = types::integer;
    return result;
  }
  void extend(Vocabulary& vocabulary) const override { add_space_quantities(vocabulary); }
  std::vector<Shape> shapes() const override { return {{0, 2}, {0, 3}}; }

  std::string manifold(const Bindings& bindings) const override {
    return object_in<SpaceObject>(bindings, "x").curvature() == Curvature::positive ? "sphere" : "hyperbolic space";
  }

  std::optional<Instance> draw(const Shape& shape, const Bindings& given, const Limits& limits,
                               Choices& choices) const override {
    Instance result{given, {}};
    Bindings& bindings = result.bindings;
    bindings["m"] = static_cast<long>(shape.m);
    for (std::size_t point = 0; point < point_names.size(); ++point)
      bindings[point_names[point]] = static_cast<long>(point);
    const Curvature curvature = choices.happens(0.5) ? Curvature::positive : Curvature::negative;
    const Rational unit = choices.happens(0.7)
                              ? Rational(1)
                              : (Rational(1) + choices.fraction(3)) * Rational::power_of_two(choices.between(-20, 20));
    bindings["lambda"] = Rational(1) / square(unit);
    const Rational own = Rational(greatest_reach) * unit;
    const auto limit = limits.most("r", bindings, true);
    const Rational part = some_part(choices);
    const Rational r = (limit ? minimum(own, *limit) : own) * part;
    if (r <= Rational(0)) return std::nullopt;
    if (limit && part == Rational(1)) result.traits.insert(Trait::boundary);
    bindings["r"] = r;
    const auto second_limit = limits.most("s", bindings, true);
    constexpr int tries = 8;
    for (int attempt = 0; attempt < tries; ++attempt) {
      auto space = std::make_shared<SpaceObject>(ChartDraw(shape.m, curvature, r / unit, choices).run(unit));
      const auto s = reach_in_second_chart(*space);
      if (!s || *s == Rational(0) || (second_limit && *second_limit < *s) ||
          space->points()[point_a] == space->points()[point_b]) {
        continue;
      }
      bindings["s"] = *s;
      bindings["x"] = ObjectPointer(std::move(space));
      return result;
    }
    return std::nullopt;
  }

  std::vector<Bindings> simpler(const Bindings& bindings) const override {
    std::vector<Bindings> result;
    const auto& space = object_in<SpaceObject>(bindings, "x");
    const auto keep = [&](Bindings candidate, const Rational& unit, const std::vector<ExactPoint>& points) {
      try {
        candidate["x"] = ObjectPointer(std::make_shared<SpaceObject>(space.curvature(), unit, points));
        require(candidate);
      } catch (const InputError&) {
        return;
      }
      result.push_back(std::move(candidate));
    };
    if (space.unit() != Rational(1)) {
      Bindings scaled = bindings;
      for (const char* length : {"r", "s"}) scaled[length] = number_in(bindings, length) / space.unit();
      scaled["lambda"] = number_in(bindings, "lambda") * square(space.unit());
      keep(std::move(scaled), Rational(1), space.points());
    }
    for (const auto& points : simpler_points(space.points(), point_names.size(), space.points().front().size())) {
      keep(bindings, space.unit(), points);
    }
    for (const char* length : {"r", "s"}) {
      for (const Rational& number : simpler_numbers(number_in(bindings, length))) {
        Bindings candidate = bindings;
        candidate[length] = number;
        keep(std::move(candidate), space.unit(), space.points());
      }
    }
    return result;
  }

  void require(const Bindings& bindings) const override {
    require_signature(*this, bindings);
    const auto refuse = [this](const std::string& why) { throw InputError(name() + ": " + why); };
    const auto& space = object_in<SpaceObject>(bindings, "x");
    if (space.size() != point_names.size()) refuse("x has not four points");
    if (std::get<long>(bindings.at("m")) != space.dimension()) refuse("m is not the dimension of x");
    for (std::size_t point = 0; point < point_names.size(); ++point) {
      if (std::get<long>(bindings.at(point_names[point])) != static_cast<long>(point)) {
        refuse(std::string(point_names[point]) + " is not " + std::to_string(point));
      }
    }
    if (number_in(bindings, "lambda") * square(space.unit()) < Rational(1)) refuse("the curvature is above lambda");
    for (const char* length : {"r", "s"}) {
      if (number_in(bindings, length) <= Rational(0)) refuse(std::string(length) + " is not positive");
    }
    if (space.points()[point_a] == space.points()[point_b]) refuse("a and b are the same point");
    for (const std::size_t centre : {centre_i, centre_j}) {
      for (const std::size_t point : {point_a, point_b}) {
        if (!space.seen_from(centre, point)) refuse("a point is the antipode of a centre");
      }
    }
  }
};

}  // namespace

const InstanceClass& exponential_charts_class() {
  static const ExponentialChartsClass result;
  return result;
}

}  // namespace delcert
