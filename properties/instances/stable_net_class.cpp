#include "properties/instances/stable_net_class.hpp"

#include <algorithm>

#include "proofs/formula/simplex_object.hpp"
#include "properties/instances/net_chart.hpp"
#include "properties/instances/net_draw.hpp"
#include "properties/instances/net_kinds_class.hpp"
#include "properties/instances/net_star.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

constexpr long net_factor = 12;
constexpr long chart_reach = 10;

const ChartMap& chart_map_in(const Bindings& bindings) { return object_in<PointObject>(bindings, "phi").coordinates(); }

/// The other vertices of the star of the first point.
std::vector<std::uint32_t> star_vertices(const NetObject& net, const Rational& distance) {
  std::vector<std::uint32_t> result;
  with_net_dimension(net.dimension(), [&]<int m>() {
    const auto cells = star_cells<m>(net.vectors<m>(), distance);
    if (!cells) return;
    for (const auto& cell : *cells) result.insert(result.end(), cell.begin() + 1, cell.end());
  });
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

/// What chart j sees: the images of the perturbed points whose originals are within 10ε of p_j, the point i first.
NetObject::Points seen_from(const Bindings& bindings, std::size_t j) {
  const NetObject& p = object_in<NetObject>(bindings, "p");
  const NetObject& q = object_in<NetObject>(bindings, "q");
  const Rational reach = Rational(chart_reach) * p.sampling_radius();
  NetObject::Points points;
  for (std::size_t at = 0; at < q.size(); ++at) {
    Rational squared(0);
    for (std::size_t axis = 0; axis < p.points()[at].size(); ++axis) {
      squared += square(p.points()[at][axis] - p.points()[j][axis]);
    }
    if (squared <= square(reach)) points.push_back(q.points()[at]);
  }
  return chart_image(chart_map_in(bindings), points);
}

class StableNetClass : public NetKindsClass {
 public:
  std::string name() const override { return "stable-net"; }
  std::string meaning() const override {
    return "a net p and its perturbation q as in local-net, for a ball of radius 12 epsilon, a linear transition phi "
           "of "
           "distortion at most xi to the chart of a point j of the star of q, and w, what that chart sees of q, the "
           "first point first; p and its image are (mu0, epsilon)-nets";
  }
  Signature signature() const override {
    Signature result = net_signature();
    result["phi"] = types::point;
    result["w"] = types::net;
    result["xi"] = types::number;
    result["j"] = types::integer;
    return result;
  }
  void extend(Vocabulary& vocabulary) const override { add_chart_quantities(vocabulary); }
  std::vector<Shape> shapes() const override { return {{0, 2}, {0, 3}}; }
  std::uint64_t cost(const Shape& shape) const override { return shape.m == 2 ? 10 : 200; }

  void require(const Bindings& bindings) const override {
    require_signature(*this, bindings);
    require_perturbed_net(bindings, net_factor);
    const NetObject& p = object_in<NetObject>(bindings, "p");
    const auto& xi = number_in(bindings, "xi");
    if (xi < Rational(0) || xi >= Rational(1) || !has_chart_distortion(chart_map_in(bindings), p.dimension(), xi)) {
      throw InputError("phi has a distortion above xi");
    }
    // The image is a net with the same parameters.
    const auto& epsilon = number_in(bindings, "epsilon");
    if (p.covering()->upper * (Rational(1) + xi) > epsilon) throw InputError("the image of p is not epsilon-dense");
    Bindings stretched = bindings;
    stretched["mu0"] = number_in(bindings, "mu0") / (Rational(1) - xi);
    require_perturbed_net(stretched, net_factor);
    const long j = std::get<long>(bindings.at("j"));
    const auto vertices = star_vertices(object_in<NetObject>(bindings, "q"), Rational(2) * epsilon);
    if (j < 0 || !std::binary_search(vertices.begin(), vertices.end(), static_cast<std::uint32_t>(j))) {
      throw InputError("j is not a vertex of the star of q");
    }
    if (object_in<NetObject>(bindings, "w").points() != seen_from(bindings, static_cast<std::size_t>(j))) {
      throw InputError("w is not what the chart of j sees");
    }
  }

 private:
  std::optional<Instance> draw_of(NetKind kind, const Shape& shape, const Bindings& given, const Limits& limits,
                                  Choices& choices) const override {
    const Rational slack = Rational::power_of_two(choices.happens(0.5) ? -4 : -choices.between(5, 40));
    auto drawn = draw_perturbed_net(shape.m, net_factor, slack, given, limits, choices, kind);
    if (!drawn) return std::nullopt;
    Bindings& bindings = drawn->instance.bindings;
    const auto& epsilon = number_in(bindings, "epsilon");
    const auto vertices = star_vertices(object_in<NetObject>(bindings, "q"), Rational(2) * epsilon);
    if (vertices.empty()) return std::nullopt;
    const std::uint32_t j =
        vertices[static_cast<std::size_t>(choices.between(0, static_cast<long>(vertices.size()) - 1))];
    bindings["j"] = static_cast<long>(j);
    const auto limit = limits.most("xi", bindings, false);
    const Rational most = limit ? maximum(Rational(0), minimum(slack, *limit)) : slack;
    const bool all = choices.happens(0.5);
    const Rational xi = all ? most : most * choices.fraction(6);
    if (limit && xi == *limit) drawn->instance.traits.insert(Trait::boundary);
    bindings["xi"] = xi;
    bindings["phi"] = ObjectPointer(std::make_shared<PointObject>(draw_chart_map(shape.m, xi, choices)));
    bindings["w"] = ObjectPointer(std::make_shared<NetObject>(seen_from(bindings, j), epsilon, Rational(0)));
    return std::move(drawn->instance);
  }
};

}  // namespace

const InstanceClass& stable_net_class() {
  static const StableNetClass result;
  return result;
}

}  // namespace delcert
