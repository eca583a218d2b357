#include "properties/instances/point_set_class.hpp"

#include <algorithm>

#include "proofs/formula/decision.hpp"
#include "proofs/formula/evaluation.hpp"
#include "properties/instances/random_simplex.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

using Points = SimplexObject::Points;

void bind_points(Bindings& bindings, Points points) {
  bindings["n"] = static_cast<long>(points.size());
  bindings["m"] = static_cast<long>(points.front().size());
  bindings["p"] = ObjectPointer(std::make_shared<SimplexObject>(std::move(points)));
}

/// Points that break constraints are moved, one at a time, as long as they then break no more.
class Repair {
 public:
  Repair(const PointRules& rules, std::vector<ExpressionPointer> constraints, const Bindings& given, Choices& choices)
      : rules_(rules), constraints_(std::move(constraints)), given_(given), choices_(choices) {
    // Coarse ones coincide and fall into line.
    bits_ = choices_.happens(0.25) ? static_cast<unsigned>(choices_.between(1, 3)) : 16U;
  }

  /// Nothing if some constraint is not certain after all moves.
  std::optional<Bindings> run(const Shape& shape) {
    Points points(static_cast<std::size_t>(shape.k) + 1, std::vector<Rational>(static_cast<std::size_t>(shape.m)));
    for (auto& point : points) {
      for (std::size_t axis = 0; axis < point.size(); ++axis) point[axis] = anywhere(axis);
    }
    constexpr int most_moves = 60;
    double breach = breach_of(points);
    for (int move = 0; breach > 0 && move < most_moves; ++move) {
      Points other = points;
      auto& point = other[static_cast<std::size_t>(choices_.between(0, shape.k))];
      const bool is_far = choices_.happens(0.3);
      const Rational step = Rational::power_of_two(-choices_.between(0, 6));
      for (std::size_t axis = 0; axis < point.size(); ++axis) {
        point[axis] = is_far ? anywhere(axis) : near(point[axis], axis, step);
      }
      const double its_breach = breach_of(other);
      if (its_breach > breach) continue;
      breach = its_breach;
      points = std::move(other);
    }
    Bindings result = bound(std::move(points));
    Scene scene(result);
    const bool holds = std::all_of(constraints_.begin(), constraints_.end(), [&](const ExpressionPointer& constraint) {
      return is_proved(decide_statement(*constraint, scene));
    });
    return holds ? std::optional<Bindings>(std::move(result)) : std::nullopt;
  }

 private:
  /// A multiple of 2^−bits of the side; an end that does not belong to the box is not met.
  Rational anywhere(std::size_t axis) {
    const ParameterRange& side = rules_.box_of(axis);
    const long last = 1L << bits_;
    if (*side.lower == *side.upper) return *side.lower;
    const long first = side.has_lower ? 0 : 1;
    const long end = side.has_upper ? last : last - 1;
    const Rational part = Rational(choices_.between(first, std::max(first, end))) / Rational(last);
    return *side.lower + (*side.upper - *side.lower) * part;
  }

  /// Within the box, whose ends count as its own: the constraints decide whether they are.
  Rational near(const Rational& from, std::size_t axis, const Rational& step) {
    const ParameterRange& side = rules_.box_of(axis);
    const Rational to = from + (*side.upper - *side.lower) * step * choices_.symmetric(bits_);
    return minimum(*side.upper, maximum(*side.lower, to));
  }

  [[nodiscard]] Bindings bound(Points points) const {
    Bindings result = given_;
    bind_points(result, std::move(points));
    return result;
  }

  /// How many constraints are certainly broken, and by how much: only a guide.
  [[nodiscard]] double breach_of(const Points& points) const {
    const Bindings bindings = bound(points);
    Scene scene(bindings);
    double result = 0;
    for (const ExpressionPointer& constraint : constraints_) {
      bool is_broken = false;
      {
        const RoundingGuard guard;
        is_broken = is_refuted(Evaluation<Interval>(scene).truth(*constraint));
      }
      if (!is_broken) continue;
      const auto ratio = ratio_bounds(*constraint, scene, false);
      result += 1 + (ratio && ratio->lower > 1 ? std::min(ratio->lower - 1, 1.0) : 0.0);
    }
    return result;
  }

  const PointRules& rules_;
  std::vector<ExpressionPointer> constraints_;
  const Bindings& given_;
  Choices& choices_;
  unsigned bits_ = 0;
};

/// For claims that do not say what the points are.
const PointRules& usual_rules() {
  static const PointRules result{{1, most_points}, {1, most_dimensions}, {parse_range("[-1, 1]")}, {}, Rational(0)};
  return result;
}

class PointSetClass : public InstanceClass {
 public:
  std::string name() const override { return std::string(point_set_name); }
  std::string meaning() const override {
    return "n points of R^m, the vertices of p, which may coincide or be dependent: as many, in the box and with the "
           "constraints that the claim states in its table points";
  }
  Signature signature() const override { return {{"p", types::simplex}, {"n", types::integer}, {"m", types::integer}}; }
  std::vector<Shape> shapes() const override { return {{1, 1}, {2, 2}, {3, 2}, {3, 3}}; }
  bool has(const Shape& shape) const override {
    return shape.k >= 0 && shape.k < most_points && shape.m >= 1 && shape.m <= most_dimensions;
  }

  std::optional<Instance> draw(const Shape& shape, const Bindings& given, const Limits& limits,
                               Choices& choices) const override {
    const PointRules* rules = limits.points();
    auto bindings = Repair(rules == nullptr ? usual_rules() : *rules, limits.constraints(), given, choices).run(shape);
    if (!bindings) return std::nullopt;
    Instance result{std::move(*bindings), {}};
    const auto& points = object_in<SimplexObject>(result.bindings, "p");
    if (points.dimension() > 0 && points.vertex_count() <= points.ambient_dimension() + 1) {
      result.traits = traits_of(points);
    }
    return result;
  }

  std::vector<Bindings> simpler(const Bindings& bindings) const override {
    const auto& points = object_in<SimplexObject>(bindings, "p");
    std::vector<Bindings> result;
    for (auto& simpler : simpler_points(points.points(), points.vertex_count(), points.ambient_dimension())) {
      if (simpler.size() != points.vertex_count() || simpler.front().size() != points.ambient_dimension()) continue;
      result.push_back(bindings);
      bind_points(result.back(), std::move(simpler));
    }
    return result;
  }

  void require(const Bindings& bindings) const override {
    require_signature(*this, bindings);
    const auto& points = object_in<SimplexObject>(bindings, "p");
    if (!points.has_coordinates()) throw InputError("point-set: p has no coordinates");
    if (std::get<long>(bindings.at("n")) != static_cast<long>(points.vertex_count()) ||
        std::get<long>(bindings.at("m")) != static_cast<long>(points.ambient_dimension())) {
      throw InputError("point-set: n and m are not the numbers of points and of dimensions");
    }
  }
};

}  // namespace

const InstanceClass& point_set_class() {
  static const PointSetClass result;
  return result;
}

}  // namespace delcert
