#include "properties/instances/local_net_class.hpp"

#include "properties/instances/net_draw.hpp"
#include "properties/instances/net_vocabulary.hpp"

namespace delcert {

namespace {

class LocalNetClass : public InstanceClass {
 public:
  std::string name() const override { return "local-net"; }
  std::string meaning() const override {
    return "a (mu0, epsilon)-net p of the ball B(p_i, 8 epsilon) of R^m, p_i = 0 its first point, and a perturbation q "
           "of it by at most rho0*epsilon; gamma0 and delta0 such that q has no forbidden configuration in B(p_i, 6 "
           "epsilon), most of the time, if the claim limits gamma0";
  }
  Signature signature() const override { return net_signature(); }
  void extend(Vocabulary& vocabulary) const override { add_net_quantities(vocabulary); }
  std::vector<Shape> shapes() const override { return {{0, 2}, {0, 3}}; }
  std::uint64_t cost(const Shape& shape) const override { return shape.m == 2 ? 10 : 200; }

  std::optional<Instance> draw(const Shape& shape, const Bindings& given, const Limits& limits,
                               Choices& choices) const override {
    auto drawn = draw_perturbed_net(shape.m, 8, Rational(0), given, limits, choices);
    if (!drawn) return std::nullopt;
    return std::move(drawn->instance);
  }

  std::vector<Bindings> simpler(const Bindings& bindings) const override { return simpler_nets(bindings); }

  void require(const Bindings& bindings) const override {
    require_signature(*this, bindings);
    require_perturbed_net(bindings, 8);
  }
};

}  // namespace

const InstanceClass& local_net_class() {
  static const LocalNetClass result;
  return result;
}

}  // namespace delcert
