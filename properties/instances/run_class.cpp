#include "properties/instances/run_class.hpp"

#include "properties/instances/run_object.hpp"
#include "properties/instances/run_vocabulary.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

const RunObject& run_in(const Bindings& bindings) { return object_in<RunObject>(bindings, "r"); }

RunRecipe draw_recipe(int dimension, const Rational& most_share, Choices& choices) {
  RunRecipe recipe;
  // Some runs without perturbation, of a lattice: they satisfy no hypotheses, and nothing holds of them.
  const bool perturbed = !choices.happens(0.12);
  recipe.mode = perturbed ? RunMode::theory : RunMode::none;
  const long kind = choices.between(0, dimension == 2 ? 2 : 5);
  if (dimension == 2) {
    recipe.manifold = kind == 0 ? "torus-2" : kind == 1 ? "torus-2-hexagonal" : "torus-2-skewed";
  } else {
    recipe.manifold = "torus-3";
  }
  if (!perturbed || choices.happens(0.3)) {
    recipe.manifold = dimension == 2 ? "torus-2" : "torus-3";
    recipe.centred = dimension == 3;
    recipe.divisions = static_cast<std::uint32_t>(dimension == 2 ? choices.between(18, 30) : 14);
  } else {
    const Rational fineness = Rational(24) + (dimension == 2 ? Rational(16) : Rational(1)) * choices.fraction(4);
    recipe.radius = Rational(1) / fineness;
  }
  recipe.perturbation_share = most_share * (choices.happens(0.5) ? Rational(1) : Rational(1) - choices.fraction(3));
  recipe.net_seed = static_cast<std::uint64_t>(choices.between(0, (1L << 40) - 1));
  recipe.seed = static_cast<std::uint64_t>(choices.between(0, (1L << 40) - 1));
  return recipe;
}

class RunClass : public InstanceClass {
 public:
  std::string name() const override { return "run"; }
  std::string meaning() const override {
    return "a finished run r of the algorithm, in theory mode but for a few, on a flat m-torus, with its sampling "
           "radius epsilon, mu0 and rho0";
  }
  Signature signature() const override {
    return {{"r", types::run},
            {"m", types::integer},
            {"epsilon", types::number},
            {"mu0", types::number},
            {"rho0", types::number}};
  }
  void extend(Vocabulary& vocabulary) const override { add_run_quantities(vocabulary); }
  std::vector<Shape> shapes() const override { return {{0, 2}, {0, 3}}; }
  std::uint64_t cost(const Shape& shape) const override { return shape.m == 2 ? 100 : 2000; }
  std::string manifold(const Bindings& bindings) const override { return run_in(bindings).recipe().manifold; }

  std::optional<Instance> draw(const Shape& shape, const Bindings& given, const Limits& limits,
                               Choices& choices) const override {
    // The limit of rho0 is taken to be a part of mu0, whatever mu0 turns out to be.
    Bindings unit = given;
    unit["mu0"] = Rational(1);
    const Rational most = limits.most("rho0", unit, true).value_or(Rational(1));
    const Rational share = minimum(Rational(1), Rational(4) * most);
    const RunRecipe recipe = draw_recipe(shape.m, share, choices);
    Instance instance{given, {}};
    try {
      bind(instance.bindings, std::make_shared<RunObject>(recipe));
    } catch (const Rejection&) {
      return std::nullopt;
    }
    if (recipe.perturbation_share == share) instance.traits.insert(Trait::boundary);
    if (recipe.mode == RunMode::none) instance.traits.insert(Trait::cospherical);
    return instance;
  }

  std::vector<Bindings> simpler(const Bindings& bindings) const override {
    std::vector<Bindings> result;
    const RunRecipe& recipe = run_in(bindings).recipe();
    const auto add = [&](const RunRecipe& simpler) {
      try {
        result.push_back(bindings);
        bind(result.back(), std::make_shared<RunObject>(simpler));
      } catch (const Rejection&) {
        result.pop_back();
      }
    };
    if (recipe.seed > 9 || recipe.net_seed > 9) {
      RunRecipe simpler = recipe;
      simpler.seed %= 10;
      simpler.net_seed %= 10;
      add(simpler);
    }
    return result;
  }

  void require(const Bindings& bindings) const override {
    require_signature(*this, bindings);
    const RunObject& run = run_in(bindings);
    const auto is = [&](const char* name, const Rational& value) {
      if (number_in(bindings, name) != value) throw InputError(std::string(name) + " is not that of the run");
    };
    if (std::get<long>(bindings.at("m")) != run.dimension()) throw InputError("m is not the dimension of the run");
    is("epsilon", run.sampling_radius());
    is("mu0", run.separation());
    is("rho0", run.perturbation());
  }

 private:
  static void bind(Bindings& bindings, const std::shared_ptr<const RunObject>& run) {
    bindings["r"] = ObjectPointer(run);
    bindings["m"] = static_cast<long>(run->dimension());
    bindings["epsilon"] = run->sampling_radius();
    bindings["mu0"] = run->separation();
    bindings["rho0"] = run->perturbation();
  }
};

}  // namespace

const InstanceClass& run_class() {
  static const RunClass result;
  return result;
}

}  // namespace delcert
