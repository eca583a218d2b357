#include "properties/instances/simplex_class.hpp"

#include "kernel/simplex/realisability.hpp"
#include "properties/instances/random_simplex.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

class SimplexClass : public InstanceClass {
 public:
  std::string name() const override { return "simplex"; }
  std::string meaning() const override { return "a non-degenerate k-simplex s in R^m, k >= 1, by its coordinates"; }
  Signature signature() const override { return {{"s", types::simplex}, {"k", types::integer}, {"m", types::integer}}; }
  std::vector<Shape> shapes() const override { return simplex_shapes(); }

  std::optional<Instance> draw(const Shape& shape, const Bindings& given, const Limits&,
                               Choices& choices) const override {
    // So that the least altitude mostly belongs to another vertex, as eq:upper.bnd.small.sing assumes.
    const bool orders = choices.happens(0.75);
    auto points = random_simplex(shape, choices);
    if (!points) return std::nullopt;
    if (orders) put_high_vertex_first(*points);
    const auto simplex = std::make_shared<SimplexObject>(std::move(*points));
    Instance instance{given, traits_of(*simplex)};
    bind(instance.bindings, simplex);
    return instance;
  }

  std::vector<Bindings> simpler(const Bindings& bindings) const override {
    const auto& simplex = object_in<SimplexObject>(bindings, "s");
    std::vector<Bindings> result;
    for (auto& points : simpler_points(simplex.points(), 2, 1)) {
      if (points.size() > points.front().size() + 1) continue;
      auto candidate = std::make_shared<SimplexObject>(std::move(points));
      if (!is_proved(is_non_degenerate(candidate->exact_gram()))) continue;
      result.push_back(bindings);
      bind(result.back(), std::move(candidate));
    }
    return result;
  }

  void require(const Bindings& bindings) const override {
    require_signature(*this, bindings);
    const auto& simplex = object_in<SimplexObject>(bindings, "s");
    if (!simplex.has_coordinates() || simplex.dimension() == 0 || !is_proved(is_non_degenerate(simplex.exact_gram()))) {
      throw InputError("simplex: s is not a non-degenerate simplex of at least two points");
    }
    if (std::get<long>(bindings.at("k")) != static_cast<long>(simplex.dimension()) ||
        std::get<long>(bindings.at("m")) != static_cast<long>(simplex.ambient_dimension())) {
      throw InputError("simplex: k and m are not the dimensions of s");
    }
  }

 private:
  static void bind(Bindings& bindings, std::shared_ptr<const SimplexObject> simplex) {
    bindings["k"] = static_cast<long>(simplex->dimension());
    bindings["m"] = static_cast<long>(simplex->ambient_dimension());
    bindings["s"] = ObjectPointer(std::move(simplex));
  }
};

}  // namespace

const InstanceClass& simplex_class() {
  static const SimplexClass result;
  return result;
}

}  // namespace delcert
