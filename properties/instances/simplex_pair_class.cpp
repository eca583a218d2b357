#include "properties/instances/simplex_pair_class.hpp"

#include "kernel/simplex/realisability.hpp"
#include "proofs/formula/pair_vocabulary.hpp"
#include "properties/instances/flat_groups.hpp"
#include "properties/instances/pair_distortion.hpp"
#include "properties/instances/pair_image.hpp"
#include "properties/instances/random_simplex.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

using Points = SimplexObject::Points;

enum class Way : unsigned char { linear, displaced, other, relengthened, star };

/// How large ξ shall be: the greatest that is allowed, or less.
struct Aim {
  Rational greatest;
  Rational xi;
  bool is_limited = false;
  bool at_limit = false;
};

Way draw_way(Choices& choices) {
  const double kind = choices.unit();
  if (kind < 0.2) return Way::linear;
  if (kind < 0.45) return Way::displaced;
  if (kind < 0.6) return Way::other;
  if (kind < 0.85) return Way::relengthened;
  return Way::star;
}

class SimplexPairClass : public InstanceClass {
 public:
  std::string name() const override { return "simplex-pair"; }
  std::string meaning() const override {
    return "a non-degenerate k-simplex s and a simplex t with edge lengths that differ by at most xi times the longest "
           "edge of s, in R^m, k >= 1, by coordinates or by squared edge lengths";
  }
  Signature signature() const override {
    return {{"s", types::simplex},
            {"t", types::simplex},
            {"xi", types::number},
            {"k", types::integer},
            {"m", types::integer}};
  }
  void extend(Vocabulary& vocabulary) const override { add_pair_quantities(vocabulary); }
  std::vector<Shape> shapes() const override { return simplex_shapes(); }

  std::optional<Instance> draw(const Shape& shape, const Bindings& given, const Limits& limits,
                               Choices& choices) const override {
    const double amount = choices.unit();
    const Way way = draw_way(choices);
    const bool exactly_at_limit = choices.happens(0.1);
    const bool is_regular = way == Way::star && choices.happens(0.75);
    SimplexPointer simplex;
    if (is_regular) {
      simplex = regular_simplex_by_edges(shape.k);
    } else {
      auto points = random_simplex(shape, choices);
      if (!points) return std::nullopt;
      simplex = std::make_shared<SimplexObject>(std::move(*points));
    }
    Instance instance{given, {}};
    instance.bindings["s"] = ObjectPointer(simplex);
    instance.bindings["k"] = static_cast<long>(shape.k);
    instance.bindings["m"] = static_cast<long>(shape.m);
    const Aim aim = aim_of(limits, instance.bindings, amount, exactly_at_limit, choices);
    const SimplexPointer image = image_of(simplex, way, shape, aim, choices);
    if (!image) return std::nullopt;
    return with_image(std::move(instance), simplex, image, aim, choices);
  }

  bool has_structure(const Shape&) const override { return true; }

  /// Two flat groups or any simplex, and edges that are changed by the signs of λ_iλ_j.
  std::optional<Instance> draw_structured(const Shape& shape, const Bindings& given, const Limits& limits,
                                          Choices& choices) const override {
    // A little below the limit, mostly: first-order estimates are nearly attained for small xi.
    const double amount = choices.unit();
    std::optional<Points> points;
    if (choices.happens(0.8)) {
      if (auto groups = flat_groups(shape, choices)) points = std::move(groups->points);
    } else {
      points = random_simplex(shape, choices);
    }
    if (!points) return std::nullopt;
    const auto simplex = std::make_shared<SimplexObject>(std::move(*points));
    Instance instance{given, {}};
    instance.bindings["s"] = ObjectPointer(simplex);
    instance.bindings["k"] = static_cast<long>(shape.k);
    instance.bindings["m"] = static_cast<long>(shape.m);
    const Aim aim = aim_of(limits, instance.bindings, amount, false, choices);
    return with_image(std::move(instance), simplex, signed_image(*simplex, aim.xi, choices), aim, choices);
  }

  std::vector<Bindings> simpler(const Bindings& bindings) const override {
    const SimplexObject& simplex = object_in<SimplexObject>(bindings, "s");
    const SimplexObject& image = object_in<SimplexObject>(bindings, "t");
    const Rational& xi = number_in(bindings, "xi");
    std::vector<Bindings> result;
    const auto propose = [&](const SimplexPointer& s, const SimplexPointer& t) {
      if (!is_proved(is_non_degenerate(s->exact_gram())) || s->dimension() == 0) return;
      const std::size_t least_dimension = std::max(s->dimension(), t->dimension());
      for (const SimplexPointer& each : {s, t}) {
        if (each->has_coordinates() && each->ambient_dimension() < least_dimension) return;
      }
      Bindings candidate = bindings;
      candidate["s"] = ObjectPointer(s);
      candidate["t"] = ObjectPointer(t);
      candidate["k"] = static_cast<long>(s->dimension());
      candidate["m"] = static_cast<long>(std::max(s->ambient_dimension(), t->ambient_dimension()));
      const Rational measured = measured_distortion(*s, *t);
      if (measured <= xi) result.push_back(candidate);
      candidate["xi"] = measured;
      if (measured != xi) result.push_back(std::move(candidate));
    };
    const auto same_s = std::make_shared<SimplexObject>(simplex);
    const auto same_t = std::make_shared<SimplexObject>(image);
    for (std::size_t left_out = 0; simplex.dimension() > 1 && left_out < simplex.vertex_count(); ++left_out) {
      std::vector<std::size_t> vertices;
      for (std::size_t i = 0; i < simplex.vertex_count(); ++i) {
        if (i != left_out) vertices.push_back(i);
      }
      propose(std::make_shared<SimplexObject>(simplex.face(vertices)),
              std::make_shared<SimplexObject>(image.face(vertices)));
    }
    if (simplex.has_coordinates() && image.has_coordinates()) {
      // The same change of both, as far as they have the same.
      const auto of_s = simpler_points(simplex.points(), simplex.vertex_count(), 1);
      const auto of_t = simpler_points(image.points(), image.vertex_count(), 1);
      for (std::size_t at = 0; at < std::min(of_s.size(), of_t.size()); ++at) {
        if (of_s[at].front().size() != of_t[at].front().size()) continue;
        propose(std::make_shared<SimplexObject>(of_s[at]), std::make_shared<SimplexObject>(of_t[at]));
      }
    }
    for (const auto& each : simpler_alone(simplex)) propose(each, same_t);
    for (const auto& each : simpler_alone(image)) propose(same_s, each);
    for (const Rational& number : simpler_numbers(xi)) {
      // Rounded up, since the distortion itself must stay below.
      const Rational above = number < xi ? xi + (xi - number) : number;
      Bindings candidate = bindings;
      for (const Rational& each : {number, above}) {
        candidate["xi"] = each;
        if (each >= Rational(0) && is_distortion_at_most(simplex, image, each)) result.push_back(candidate);
      }
    }
    return result;
  }

  void require(const Bindings& bindings) const override {
    require_signature(*this, bindings);
    const SimplexObject& simplex = object_in<SimplexObject>(bindings, "s");
    const SimplexObject& image = object_in<SimplexObject>(bindings, "t");
    if (simplex.dimension() == 0 || !is_proved(is_non_degenerate(simplex.exact_gram()))) {
      throw InputError("simplex-pair: s is not a non-degenerate simplex of at least two points");
    }
    if (simplex.vertex_count() != image.vertex_count()) {
      throw InputError("simplex-pair: s and t have different numbers of vertices");
    }
    if (std::get<long>(bindings.at("k")) != static_cast<long>(simplex.dimension())) {
      throw InputError("simplex-pair: k is not the dimension of s");
    }
    for (const SimplexObject* each : {&simplex, &image}) {
      const auto least = static_cast<long>(each->ambient_dimension());
      const long m = std::get<long>(bindings.at("m"));
      if (each->has_coordinates() ? m != least : m < least) {
        throw InputError("simplex-pair: m is not the dimension of the space");
      }
    }
    const Rational& xi = number_in(bindings, "xi");
    if (xi < Rational(0) || !is_distortion_at_most(simplex, image, xi)) {
      throw InputError("simplex-pair: an edge differs by more than xi times the longest edge of s");
    }
  }

 private:
  /// The pair, with the distortion that it has, or the greatest that is allowed.
  static std::optional<Instance> with_image(Instance instance, const SimplexPointer& simplex,
                                            const SimplexPointer& image, const Aim& aim, Choices& choices) {
    const Rational measured = measured_distortion(*simplex, *image);
    const bool fits = !aim.is_limited || measured <= aim.greatest;
    // Rounded up, the measured distortion may exceed what the distortion itself does not.
    if (!fits && !is_distortion_at_most(*simplex, *image, aim.greatest)) return std::nullopt;
    const bool is_at_limit = !fits || (aim.is_limited && aim.at_limit && choices.happens(0.5));
    instance.bindings["t"] = ObjectPointer(image);
    instance.bindings["xi"] = is_at_limit ? aim.greatest : measured;
    instance.traits = traits_of(*simplex);
    if (aim.is_limited && std::get<Rational>(instance.bindings["xi"]) >= nearly(aim)) {
      instance.traits.insert(Trait::boundary);
    }
    return instance;
  }

  static Rational nearly(const Aim& aim) { return aim.greatest * (Rational(1) - Rational::power_of_two(-40)); }

  static Aim aim_of(const Limits& limits, const Bindings& bound, double amount, bool exactly, Choices& choices) {
    Aim aim;
    aim.at_limit = amount < 0.5;
    const auto limit = limits.most("xi", bound, exactly && aim.at_limit);
    const long depth = choices.between(0, 200);
    const Rational share = choices.fraction(16);
    aim.is_limited = limit.has_value();
    aim.greatest = limit.value_or(Rational(4));
    aim.xi = aim.greatest;
    if (amount >= 0.98) aim.xi = Rational(0);
    if (amount >= 0.5 && amount < 0.75) aim.xi *= share;
    if (amount >= 0.75 && amount < 0.98) aim.xi *= share * Rational::power_of_two(-depth);
    return aim;
  }

  static SimplexPointer image_of(const SimplexPointer& simplex, Way way, const Shape& shape, const Aim& aim,
                                 Choices& choices) {
    const Rational& xi = aim.xi;
    switch (way) {
      case Way::linear:
        return linear_image(*simplex, xi, choices);
      case Way::displaced:
        return displaced_image(*simplex, random_directions(*simplex, choices), xi);
      case Way::other: {
        // Another simplex, which may be much thinner; or towards it.
        auto points = random_simplex(shape, choices);
        if (!points) return nullptr;
        if (!aim.is_limited) return std::make_shared<SimplexObject>(std::move(*points));
        for (std::size_t i = 0; i < points->size(); ++i) {
          for (std::size_t axis = 0; axis < points->front().size(); ++axis) {
            (*points)[i][axis] -= simplex->points()[i][axis];
          }
        }
        return displaced_image(*simplex, *points, xi);
      }
      default:
        return relengthened_image(*simplex, xi, way == Way::star, choices);
    }
  }

  /// The simplex made simpler with its vertices kept.
  static std::vector<SimplexPointer> simpler_alone(const SimplexObject& simplex) {
    std::vector<SimplexPointer> result;
    if (simplex.has_coordinates()) {
      const std::size_t dimension = simplex.ambient_dimension();
      for (auto& points : simpler_points(simplex.points(), simplex.vertex_count(), dimension)) {
        result.push_back(std::make_shared<SimplexObject>(std::move(points)));
      }
      return result;
    }
    SymmetricMatrix<Rational> squared_edges(simplex.vertex_count());
    for (std::size_t i = 0; i < squared_edges.order(); ++i) {
      for (std::size_t j = 0; j < i; ++j) squared_edges(i, j) = simplex.exact_gram().squared_edge(i, j);
    }
    for (std::size_t i = 0; i < squared_edges.order(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        for (const Rational& number : simpler_numbers(squared_edges(i, j))) {
          SymmetricMatrix<Rational> candidate = squared_edges;
          candidate(i, j) = number;
          const auto gram = edge_gram_from_squared_edges(candidate);
          if (number <= Rational(0) || !is_proved(is_realisable(gram, gram.dimension()))) continue;
          result.push_back(std::make_shared<SimplexObject>(candidate));
        }
      }
    }
    return result;
  }
};

}  // namespace

const InstanceClass& simplex_pair_class() {
  static const SimplexPairClass result;
  return result;
}

}  // namespace delcert
