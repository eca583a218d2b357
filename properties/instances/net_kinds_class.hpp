#pragma once

#include "properties/instances/instance_class.hpp"
#include "properties/instances/net_draw.hpp"

namespace delcert {

/// What classes have in common whose instances begin with a perturbed net of ℝᵐ: an attack draws nets of any kind, the
/// structured ones are lattices next to degenerate ones, and none is simpler than another.
class NetKindsClass : public InstanceClass {
 public:
  std::optional<Instance> draw(const Shape& shape, const Bindings& given, const Limits& limits,
                               Choices& choices) const final {
    return draw_of(NetKind::any, shape, given, limits, choices);
  }

  bool has_structure(const Shape&) const final { return true; }

  std::optional<Instance> draw_structured(const Shape& shape, const Bindings& given, const Limits& limits,
                                          Choices& choices) const final {
    return draw_of(NetKind::nearly_degenerate, shape, given, limits, choices);
  }

  std::vector<Bindings> simpler(const Bindings&) const final { return {}; }

 private:
  /// One instance, as `draw`, that begins with a net of this kind.
  [[nodiscard]] virtual std::optional<Instance> draw_of(NetKind kind, const Shape& shape, const Bindings& given,
                                                        const Limits& limits, Choices& choices) const = 0;
};

}  // namespace delcert
