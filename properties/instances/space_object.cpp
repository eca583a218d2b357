#include "properties/instances/space_object.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "kernel/chart/model_space.hpp"
#include "kernel/number/exact_text.hpp"
#include "proofs/formula/simplex_object.hpp"
#include "properties/instances/net_object.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

template <int m>
Vector<Rational, m> vector_of(const ExactPoint& point) {
  Vector<Rational, m> result;
  std::copy(point.begin(), point.end(), result.begin());
  return result;
}

}  // namespace

SpaceObject::SpaceObject(Curvature curvature, Rational unit, std::vector<ExactPoint> points)
    : curvature_(curvature), unit_(std::move(unit)), points_(std::move(points)) {
  if (curvature_ == Curvature::zero) throw InputError("points of a space: its curvature is 0");
  if (unit_ <= Rational(0)) throw InputError("points of a space: the unit is not above 0");
  if (points_.empty()) throw InputError("points of a space: there are none");
  const std::size_t dimension = points_.front().size();
  if (dimension != 2 && dimension != 3) throw InputError("points of a space are for dimensions 2 and 3");
  for (const ExactPoint& point : points_) {
    if (point.size() != dimension) throw InputError("points of a space: of different dimensions");
    if (curvature_ == Curvature::negative && pairing(point, point) >= Rational(4)) {
      throw InputError("points of a space: one lies outside of hyperbolic space");
    }
  }
}

std::optional<ExactPoint> seen_by(Curvature curvature, const ExactPoint& centre, const ExactPoint& point) {
  return with_net_dimension(static_cast<int>(point.size()), [&]<int m>() -> std::optional<ExactPoint> {
    const auto x = model_point<Rational, m>(curvature, vector_of<m>(point));
    const auto seen = applied(inverse_model_frame<Rational, m>(curvature, vector_of<m>(centre)), x);
    if (seen[0] == Rational(-1)) return std::nullopt;
    const auto coordinates = conformal_coordinates<Rational, m>(seen);
    return ExactPoint(coordinates.begin(), coordinates.end());
  });
}

std::optional<ExactPoint> SpaceObject::seen_from(std::size_t centre, std::size_t point) const {
  for (const std::size_t number : {centre, point}) {
    if (number >= size()) {
      throw InputError("points of a space: of " + std::to_string(size()) + " there is no number " +
                       std::to_string(number));
    }
  }
  return seen_by(curvature_, points_[centre], points_[point]);
}

nlohmann::ordered_json SpaceObject::json() const {
  nlohmann::ordered_json result;
  result["curvature"] = sign_of(curvature_);
  result["unit"] = exact_text(unit_);
  result["points"] = nlohmann::ordered_json::array();
  for (const auto& point : points_) result["points"].push_back(json_of(point));
  return result;
}

ObjectPointer SpaceObject::read(const nlohmann::ordered_json& json) {
  const auto part = [&json](const char* key) -> const nlohmann::ordered_json& {
    if (!json.is_object() || !json.contains(key)) {
      throw InputError(std::string("points of a space: ") + key + " is missing");
    }
    return json.at(key);
  };
  const auto& sign = part("curvature");
  if (!sign.is_number_integer() || (sign != 1 && sign != -1)) {
    throw InputError("points of a space: curvature is neither 1 nor -1");
  }
  if (!part("unit").is_string()) throw InputError("points of a space: unit is not an exact number in quotes");
  if (!part("points").is_array()) throw InputError("points of a space: points is not a list");
  std::vector<ExactPoint> points;
  for (const auto& point : part("points")) points.push_back(rationals_from(point, "a point of a space"));
  return std::make_shared<SpaceObject>(sign == 1 ? Curvature::positive : Curvature::negative,
                                       parse_exact(part("unit").get<std::string>()), std::move(points));
}

Rational conformal_length(Curvature curvature, const Rational& distance) {
  if (distance == Rational(0)) return distance;
  const BigInterval half(distance / Rational(2));
  const BigInterval tangent =
      curvature == Curvature::positive ? sine(half) / cosine(half) : hyperbolic_sine(half) / hyperbolic_cosine(half);
  const Rational lower = Rational(2) * tangent.lower();
  constexpr long bits = 52;
  return rounded_down(lower, binary_exponent(lower) - bits);
}

}  // namespace delcert
