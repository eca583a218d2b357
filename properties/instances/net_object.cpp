#include "properties/instances/net_object.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "kernel/number/exact_text.hpp"
#include "kernel/sample/net_measure.hpp"
#include "proofs/formula/simplex_object.hpp"

namespace delcert {

namespace {

std::optional<CoveringBounds> covering_bounds(const NetObject& net) {
  return with_net_dimension(net.dimension(), [&net]<int m>() -> std::optional<CoveringBounds> {
    FlatSpace<m> space;
    space.ball_radius = net.ball_radius();
    try {
      const auto density = measure_density<m>(space, PointSet<m>(net.vectors<m>()), std::nullopt, no_progress());
      return CoveringBounds{density.covering_radius_lower, density.sampling_radius};
    } catch (const Rejection&) {
      return std::nullopt;
    }
  });
}

void require_points(const NetObject::Points& points) {
  if (points.empty()) throw InputError("a net has points");
  const std::size_t dimension = points.front().size();
  if (dimension != 2 && dimension != 3) throw InputError("nets are for dimensions 2 and 3");
  if (points.size() < dimension + 2) throw InputError("a net has at least m + 2 points");
  for (const auto& point : points) {
    if (point.size() != dimension) throw InputError("a net has points of different dimensions");
  }
  auto sorted = points;
  std::sort(sorted.begin(), sorted.end());
  if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) {
    throw InputError("a net has two points that are the same");
  }
}

}  // namespace

NetObject::NetObject(Points points, Rational sampling_radius, Rational ball_radius)
    : points_(std::move(points)), sampling_radius_(std::move(sampling_radius)), ball_radius_(std::move(ball_radius)) {
  require_points(points_);
  if (sampling_radius_ <= Rational(0)) throw InputError("the sampling radius of a net is not above 0");
  if (ball_radius_ < Rational(0)) throw InputError("the radius of the ball of a net is negative");
  if (ball_radius_ > Rational(0)) covering_ = covering_bounds(*this);
}

nlohmann::ordered_json NetObject::json() const {
  nlohmann::ordered_json result;
  result["sampling_radius"] = exact_text(sampling_radius_);
  result["ball_radius"] = exact_text(ball_radius_);
  result["points"] = nlohmann::ordered_json::array();
  for (const auto& point : points_) result["points"].push_back(json_of(point));
  return result;
}

ObjectPointer NetObject::read(const nlohmann::ordered_json& json) {
  if (!json.is_object() || !json.contains("points")) throw InputError("a net has points");
  const auto number = [&json](const char* key) {
    if (!json.contains(key) || !json.at(key).is_string()) {
      throw InputError(std::string("a net has a ") + key + ", an exact number in quotes");
    }
    return parse_exact(json.at(key).get<std::string>());
  };
  if (!json.at("points").is_array()) throw InputError("the points of a net are not a list");
  Points points;
  for (const auto& point : json.at("points")) points.push_back(rationals_from(point, "a point of a net"));
  return std::make_shared<NetObject>(std::move(points), number("sampling_radius"), number("ball_radius"));
}

}  // namespace delcert
