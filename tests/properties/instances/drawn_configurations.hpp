#pragma once

#include <vector>

#include "properties/instances/configuration_draw.hpp"

namespace delcert::drawn_configurations {

/// The hypotheses of lem:prop.forbid.cfg and μ₀ ≤ 1.
class LimitsOfTheLemma : public Limits {
 public:
  std::optional<Rational> most(const std::string& name, const Bindings& bound, bool) const override {
    const auto number = [&bound](const std::string& of) { return std::get<Rational>(bound.at(of)); };
    if (name == "mu0") return Rational(1);
    if (name == "rho0") return number("mu0") / Rational(4);
    if (name == "gamma0") return Rational(2) * square(number("mu0")) / Rational(75);
    if (name == "delta0") return power(number("gamma0"), std::get<long>(bound.at("m")) + 1);
    return std::nullopt;
  }
};

inline const std::vector<Shape> shapes{{2, 2}, {2, 3}, {3, 3}, {3, 4}, {4, 4}};
constexpr std::uint32_t draws = 40;

template <class Draw>
std::vector<Configuration> drawn(const Draw& draw, const Limits& limits, const Shape& shape, std::uint32_t count) {
  const Bindings bound{{"k", static_cast<long>(shape.k)}, {"m", static_cast<long>(shape.m)}};
  std::vector<Configuration> result;
  for (std::uint32_t number = 0; number < count; ++number) {
    RandomChoices choices(1, static_cast<std::uint32_t>(shape.k * 16 + shape.m), number);
    if (auto configuration = draw(shape, bound, limits, choices)) result.push_back(std::move(*configuration));
  }
  return result;
}

}  // namespace delcert::drawn_configurations
