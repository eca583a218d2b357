#include "properties/instances/distortion_map_class.hpp"

#include <algorithm>

#include "kernel/simplex/circumsphere.hpp"
#include "kernel/simplex/realisability.hpp"
#include "properties/instances/flat_groups.hpp"
#include "properties/instances/map_draw.hpp"
#include "properties/instances/map_quantities.hpp"
#include "properties/instances/random_simplex.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

enum class MapKind : unsigned char { linear, smooth, inversion, transition, displaced, lifted, tilted };

const ExactPoint& point_in(const Bindings& bindings, const std::string& name) {
  return object_in<PointObject>(bindings, name).coordinates();
}
const MapObject& map_in(const Bindings& bindings) { return object_in<MapObject>(bindings, "phi"); }

MapKind draw_kind(Choices& choices) {
  const double kind = choices.unit();
  if (kind < 0.2) return MapKind::linear;
  if (kind < 0.35) return MapKind::smooth;
  if (kind < 0.45) return MapKind::inversion;
  if (kind < 0.5) return MapKind::transition;
  if (kind < 0.75) return MapKind::displaced;
  if (kind < 0.9) return MapKind::lifted;
  return MapKind::tilted;
}

MapObject::Form draw_map(const CentredSimplex& simplex, MapKind way, const Rational& xi, Choices& choices) {
  switch (way) {
    case MapKind::linear:
      return random_linear_map(simplex.centre.size(), xi, choices);
    case MapKind::smooth:
      return random_smooth_map(simplex, xi, choices);
    case MapKind::inversion:
      return random_inversion(simplex, minimum(xi, Rational(1) / Rational(2)), choices);
    case MapKind::transition:
      if (auto map = random_transition(simplex.centre.size(), choices)) return *std::move(map);
      break;
    case MapKind::lifted:
      if (auto map = lifted_centre(simplex, xi, choices)) return *std::move(map);
      break;
    case MapKind::tilted:
      if (auto map = tilted_centre(simplex, xi, choices)) return *std::move(map);
      break;
    default:
      break;
  }
  return displaced_points(simplex, xi, choices);
}

ObjectPointer point_object(const ExactPoint& point) { return std::make_shared<PointObject>(point); }

class DistortionMapClass : public InstanceClass {
 public:
  std::string name() const override { return "distortion-map"; }
  std::string meaning() const override {
    return "a non-degenerate k-simplex s in R^m, k >= 1, the centre c of a circumscribing ball, a map phi of "
           "distortion "
           "xi > 0 on a set with the vertices and, if outside = 0, with c; t and c_image are the images, offset is the "
           "squared distance of c from the circumcentre";
  }
  Signature signature() const override {
    return {{"s", types::simplex},     {"c", types::point},   {"phi", types::map},       {"t", types::simplex},
            {"c_image", types::point}, {"xi", types::number}, {"offset", types::number}, {"outside", types::number},
            {"k", types::integer},     {"m", types::integer}};
  }
  void extend(Vocabulary& vocabulary) const override { add_map_quantities(vocabulary); }
  std::vector<Shape> shapes() const override { return simplex_shapes(); }

  std::optional<Instance> draw(const Shape& shape, const Bindings& given, const Limits& limits,
                               Choices& choices) const override {
    const double amount = choices.unit();
    const MapKind way = draw_kind(choices);
    const bool exactly_at_limit = choices.happens(0.1);
    const bool wants_circumcentre = choices.happens(0.3);
    const bool wants_outside = choices.happens(0.1);
    const long depth = choices.between(0, 200);
    const Rational share = choices.fraction(16) + Rational::power_of_two(-17);
    auto points = random_simplex(shape, choices);
    if (!points) return std::nullopt;
    const auto simplex = std::make_shared<SimplexObject>(std::move(*points));
    Instance instance{given, traits_of(*simplex)};
    instance.bindings["s"] = ObjectPointer(simplex);
    instance.bindings["k"] = static_cast<long>(shape.k);
    instance.bindings["m"] = static_cast<long>(shape.m);

    const auto most_offset = limits.most("offset", instance.bindings, true);
    const bool at_circumcentre = wants_circumcentre || (most_offset && *most_offset <= Rational(0));
    const auto centred = with_centre(*simplex, at_circumcentre, choices);
    if (!centred) return std::nullopt;
    const auto most_outside = limits.most("outside", instance.bindings, true);
    const bool is_outside = wants_outside && !(most_outside && *most_outside < Rational(1));

    const auto limit = limits.most("xi", instance.bindings, exactly_at_limit && amount < 0.5);
    // Without a limit, maps may flatten the simplex nearly.
    const Rational greatest = limit.value_or(Rational(1) - Rational::power_of_two(-choices.between(1, 30)));
    if (greatest <= Rational(0)) return std::nullopt;
    Rational aim = greatest;
    if (amount >= 0.5) aim *= share;
    if (amount >= 0.75) aim *= Rational::power_of_two(-depth);
    const auto map = std::make_shared<MapObject>(is_outside ? MapObject::Form(with_centre_outside(*centred, choices))
                                                            : draw_map(*centred, way, aim, choices));
    Rational xi = certified_distortion(*map, aim);
    // Also for isometries, since the paper asks for a positive number.
    if (xi > greatest || xi == Rational(0) || (amount < 0.25 && limit)) xi = aim;
    // A linear map has it by construction, and to check that takes long.
    if (!std::holds_alternative<LinearMap>(map->form()) && !map->has_distortion(xi)) return std::nullopt;
    if (!bind(instance.bindings, simplex, centred->centre, map, xi)) return std::nullopt;
    if (limit && xi >= greatest * (Rational(1) - Rational::power_of_two(-40))) instance.traits.insert(Trait::boundary);
    return instance;
  }

  bool has_structure(const Shape&) const override { return true; }

  /// Two flat groups, and the centre drawn from one to the other.
  std::optional<Instance> draw_structured(const Shape& shape, const Bindings& given, const Limits& limits,
                                          Choices& choices) const override {
    const Rational share = (Rational(1) + choices.fraction(16)) / Rational(2);
    const bool is_smaller = choices.happens(0.5);
    const long depth = choices.between(1, 24);
    auto groups = flat_groups(shape, choices);
    if (!groups) return std::nullopt;
    const auto simplex = std::make_shared<SimplexObject>(groups->points);
    Instance instance{given, traits_of(*simplex)};
    instance.bindings["s"] = ObjectPointer(simplex);
    instance.bindings["k"] = static_cast<long>(shape.k);
    instance.bindings["m"] = static_cast<long>(shape.m);
    const bool wants_circumcentre = choices.happens(0.7);
    const auto most_offset = limits.most("offset", instance.bindings, true);
    const bool at_circumcentre = wants_circumcentre || (most_offset && *most_offset <= Rational(0));
    const auto centred = with_centre(*simplex, at_circumcentre, choices);
    if (!centred) return std::nullopt;
    const Rational greatest = limits.most("xi", instance.bindings, false).value_or(Rational(1) / Rational(16));
    if (greatest <= Rational(0)) return std::nullopt;
    const Rational aim = greatest * share * (is_smaller ? Rational::power_of_two(-depth) : Rational(1));
    const auto map =
        std::make_shared<MapObject>(MapObject::Form(centre_between_groups(*centred, *groups, aim, choices)));
    const Rational xi = certified_distortion(*map, aim);
    if (xi > greatest || xi == Rational(0) || !map->has_distortion(xi)) return std::nullopt;
    if (!bind(instance.bindings, simplex, centred->centre, map, xi)) return std::nullopt;
    return instance;
  }

  std::vector<Bindings> simpler(const Bindings& bindings) const override {
    // As a bare map of the same points, which has fewer numbers; these are then made simpler.
    const SimplexObject& simplex = object_in<SimplexObject>(bindings, "s");
    const MapObject& map = map_in(bindings);
    FiniteMap bare{simplex.points(), object_in<SimplexObject>(bindings, "t").points(), simplex.vertex_count()};
    bare.points.push_back(point_in(bindings, "c"));
    bare.images.push_back(point_in(bindings, "c_image"));
    if (map.is_in_domain(bare.points.back())) ++bare.domain_count;
    std::vector<Bindings> result;
    const bool at_circumcentre = number_in(bindings, "offset") == Rational(0);
    if (!std::holds_alternative<FiniteMap>(map.form())) {
      propose(result, bindings, bare);
      propose_with_simpler_vertices(result, bindings);
      if (const auto* linear = std::get_if<LinearMap>(&map.form())) propose_simpler_maps(result, bindings, *linear);
    }
    const std::size_t count = simplex.vertex_count();
    for (std::size_t left_out = 0; count > 2 && left_out < count; ++left_out) {
      FiniteMap candidate = bare;
      const auto at = static_cast<std::ptrdiff_t>(left_out);
      candidate.points.erase(candidate.points.begin() + at);
      candidate.images.erase(candidate.images.begin() + at);
      --candidate.domain_count;
      if (at_circumcentre) move_to_circumcentre(candidate);
      propose(result, bindings, candidate);
    }
    // Vertices first, then images: a centre of a new simplex is its circumcentre.
    const SimplexObject::Points vertices(bare.points.begin(), bare.points.end() - 1);
    const std::size_t dimension = vertices.front().size();
    for (auto& points : simpler_points(vertices, count, count - 1)) {
      if (points.front().size() != dimension) continue;
      FiniteMap candidate = bare;
      std::copy(points.begin(), points.end(), candidate.points.begin());
      if (!move_to_circumcentre(candidate)) continue;
      propose(result, bindings, candidate);
      candidate.images = candidate.points;
      candidate.images.back() = bare.images.back();
      propose(result, bindings, candidate);
    }
    for (auto& images : simpler_points(bare.images, count + 1, dimension)) {
      FiniteMap candidate = bare;
      candidate.images = std::move(images);
      propose(result, bindings, candidate);
    }
    for (std::size_t axis = 0; dimension > count - 1 && axis < dimension; ++axis) {
      FiniteMap candidate = bare;
      for (auto* points : {&candidate.points, &candidate.images}) {
        for (ExactPoint& point : *points) point.erase(point.begin() + static_cast<std::ptrdiff_t>(axis));
      }
      if (at_circumcentre && !move_to_circumcentre(candidate)) continue;
      propose(result, bindings, candidate);
    }
    for (const Rational& number : simpler_numbers(number_in(bindings, "xi"))) {
      if (number <= Rational(0) || !map.has_distortion(number)) continue;
      result.push_back(bindings);
      result.back()["xi"] = number;
    }
    return result;
  }

  void require(const Bindings& bindings) const override {
    require_signature(*this, bindings);
    const SimplexObject& simplex = object_in<SimplexObject>(bindings, "s");
    if (!simplex.has_coordinates() || simplex.dimension() == 0 || !is_proved(is_non_degenerate(simplex.exact_gram()))) {
      throw InputError("distortion-map: s is not a non-degenerate simplex of at least two points");
    }
    const MapObject& map = map_in(bindings);
    const ExactPoint& centre = point_in(bindings, "c");
    if (centre.size() != simplex.ambient_dimension()) throw InputError("distortion-map: c is not in the space of s");
    for (const auto& point : simplex.points()) {
      if (squared_distance_between(centre, point) != squared_distance_between(centre, simplex.points()[0])) {
        throw InputError("distortion-map: c is not the centre of a circumscribing ball");
      }
      if (!map.is_in_domain(point)) throw InputError("distortion-map: a vertex is not where phi has its distortion");
    }
    const Rational& xi = number_in(bindings, "xi");
    if (xi <= Rational(0) || !map.has_distortion(xi)) {
      throw InputError("distortion-map: phi has no certified distortion of at most xi, or xi is not above 0");
    }
    Bindings expected = bindings;
    if (!bind(expected, std::make_shared<SimplexObject>(simplex), centre, std::make_shared<MapObject>(map), xi)) {
      throw InputError("distortion-map: phi is not defined on the vertices and c");
    }
    for (const char* name : {"k", "m", "offset", "outside"}) {
      if (expected.at(name) != bindings.at(name))
        throw InputError(std::string("distortion-map: ") + name + " is not what it is called");
    }
    const SimplexObject& image = object_in<SimplexObject>(bindings, "t");
    if (image.points() != object_in<SimplexObject>(expected, "t").points() ||
        point_in(bindings, "c_image") != point_in(expected, "c_image")) {
      throw InputError("distortion-map: t and c_image are not the images of s and c");
    }
  }

 private:
  /// All names; false if the map is not defined on the vertices and the centre.
  static bool bind(Bindings& bindings, std::shared_ptr<const SimplexObject> simplex, const ExactPoint& centre,
                   std::shared_ptr<const MapObject> map, const Rational& xi) {
    SimplexObject::Points images;
    for (const auto& point : simplex->points()) {
      auto image = map->image(point);
      if (!image) return false;
      images.push_back(*std::move(image));
    }
    const auto centre_image = map->image(centre);
    const auto sphere = circumsphere(simplex->exact_gram());
    if (!centre_image || !sphere) return false;
    bindings["offset"] = squared_distance_between(centre, simplex->points()[0]) - sphere->squared_radius;
    bindings["outside"] = Rational(map->is_in_domain(centre) ? 0 : 1);
    bindings["k"] = static_cast<long>(simplex->dimension());
    bindings["m"] = static_cast<long>(simplex->ambient_dimension());
    bindings["xi"] = xi;
    bindings["t"] = ObjectPointer(std::make_shared<SimplexObject>(std::move(images)));
    bindings["c_image"] = point_object(*centre_image);
    bindings["c"] = point_object(centre);
    bindings["phi"] = ObjectPointer(std::move(map));
    bindings["s"] = ObjectPointer(std::move(simplex));
    return true;
  }

  /// The last point becomes the circumcentre of the others; false if they are degenerate.
  static bool move_to_circumcentre(FiniteMap& map) {
    const SimplexObject::Points vertices(map.points.begin(), map.points.end() - 1);
    const auto gram = edge_gram_from_points(vertices);
    if (!is_proved(is_non_degenerate(gram))) return false;
    map.points.back() = circumcentre(*circumsphere(gram), vertices);
    return true;
  }

  static void propose_if_fit(std::vector<Bindings>& result, const Bindings& bindings, SimplexObject::Points vertices,
                             const ExactPoint& centre, const std::shared_ptr<const MapObject>& map) {
    const Rational& xi = number_in(bindings, "xi");
    if (!std::all_of(vertices.begin(), vertices.end(), [&](const auto& each) { return map->is_in_domain(each); }) ||
        !map->has_distortion(xi)) {
      return;
    }
    Bindings candidate = bindings;
    if (bind(candidate, std::make_shared<SimplexObject>(std::move(vertices)), centre, map, xi)) {
      result.push_back(std::move(candidate));
    }
  }

  /// The same map on simpler vertices, with their circumcentre.
  static void propose_with_simpler_vertices(std::vector<Bindings>& result, const Bindings& bindings) {
    const SimplexObject& simplex = object_in<SimplexObject>(bindings, "s");
    const auto map = std::make_shared<MapObject>(map_in(bindings));
    for (auto& points : simpler_points(simplex.points(), simplex.vertex_count(), simplex.ambient_dimension())) {
      const auto gram = edge_gram_from_points(points);
      if (!is_proved(is_non_degenerate(gram))) continue;
      const ExactPoint centre = circumcentre(*circumsphere(gram), points);
      propose_if_fit(result, bindings, std::move(points), centre, map);
    }
  }

  /// Linear maps with rounder entries, on the same points.
  static void propose_simpler_maps(std::vector<Bindings>& result, const Bindings& bindings, const LinearMap& map) {
    const auto propose_map = [&](LinearMap candidate) {
      propose_if_fit(result, bindings, object_in<SimplexObject>(bindings, "s").points(), point_in(bindings, "c"),
                     std::make_shared<MapObject>(std::move(candidate)));
    };
    for (const long bits : {1L, 3L, 7L, 15L, 30L}) {
      LinearMap candidate = map;
      for (ExactPoint& row : candidate.rows) {
        for (Rational& entry : row) entry = rounded_down(entry + Rational::power_of_two(-bits - 1), -bits);
      }
      if (candidate.rows != map.rows) propose_map(std::move(candidate));
    }
    for (std::size_t row = 0; row < map.rows.size(); ++row) {
      for (std::size_t column = 0; column < map.rows.size(); ++column) {
        std::vector<Rational> numbers = simpler_numbers(map.rows[row][column]);
        if (!numbers.empty()) numbers.emplace_back(0);
        for (const Rational& number : numbers) {
          LinearMap candidate = map;
          candidate.rows[row][column] = number;
          if (number != map.rows[row][column]) propose_map(std::move(candidate));
        }
      }
    }
  }

  static void propose(std::vector<Bindings>& result, const Bindings& bindings, const FiniteMap& map) {
    const auto simplex =
        std::make_shared<SimplexObject>(SimplexObject::Points(map.points.begin(), map.points.end() - 1));
    if (!is_proved(is_non_degenerate(simplex->exact_gram()))) return;
    const ExactPoint& centre = map.points.back();
    for (const auto& point : simplex->points()) {
      const Rational squared = squared_distance_between(centre, point);
      // A vertex that is the centre would be mapped in two ways.
      if (squared != squared_distance_between(centre, simplex->points()[0]) || squared == Rational(0)) return;
    }
    const auto object = std::make_shared<MapObject>(map);
    const Rational& xi = number_in(bindings, "xi");
    const Rational measured = certified_distortion(*object, xi);
    for (const Rational& each : {xi, measured}) {
      if (each <= Rational(0) || !object->has_distortion(each)) continue;
      Bindings candidate = bindings;
      if (bind(candidate, simplex, centre, object, each)) result.push_back(std::move(candidate));
      if (xi == measured) break;
    }
  }
};

}  // namespace

const InstanceClass& distortion_map_class() {
  static const DistortionMapClass result;
  return result;
}

}  // namespace delcert
