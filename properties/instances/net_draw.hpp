#pragma once

#include <optional>
#include <vector>

#include "properties/instances/instance_class.hpp"
#include "properties/instances/net_object.hpp"

namespace delcert {

/// p, q, m, epsilon, mu0, rho0, gamma0, delta0: what the classes of nets bind.
[[nodiscard]] Signature net_signature();

struct PerturbedNet {
  Instance instance;
  bool is_cospherical = false;
};

/// Any net, or a lattice next to a degenerate one (`draw_nearly_degenerate_net`) whose points stay where they are.
enum class NetKind : unsigned char { any, nearly_degenerate };

/// A net p that is certified to be ε-dense for B(0, factor·ε), its least distance at least μ₀ε, and the perturbed net
/// q. μ₀ and ρ₀ keep to `limits`, and reach them now and then; without limits ρ₀ may be as large as 3. If there is a
/// limit of gamma0, gamma0 and delta0 are the largest tried for which Q′ has no forbidden configuration, with
/// exceptions for the sake of twins. q is meant for the ball of radius (factor − 5/4)ε.
[[nodiscard]] std::optional<PerturbedNet> draw_perturbed_net(int dimension, long factor, const Rational& slack,
                                                             const Bindings& given, const Limits& limits,
                                                             Choices& choices, NetKind kind = NetKind::any);

/// The same instance with a point less in both nets, where it stays an instance.
[[nodiscard]] std::vector<Bindings> simpler_nets(const Bindings& bindings);

/// Throws InputError unless p is a (μ₀, ε)-net of B(0, factor·ε), factor at least the given one, with its first point
/// 0, and q moves every point by at most ρ₀ε. Decided exactly.
void require_perturbed_net(const Bindings& bindings, long factor);

}  // namespace delcert
