#!/usr/bin/env python3
"""Decides whether Theorem 1, as printed, fails on a torus with a hexagonal net of separation μ₀: Hypotheses 1 allow μ₀ > 1.

usage: hexagonal_net.py [--separation NUMBER] [--periods NUMBER]

The net is the hexagonal lattice of distance μ₀ε, on the plane divided by `periods` times that lattice; ε₀ = 0, transitions are
translations, m = 2. Everything is exact: squared distances in the lattice are rational multiples of ε². What is decided:

1. The input meets Hypotheses 1: the lattice is ε-dense, as its covering radius μ₀ε/√3 is below ε; it is μ₀ε-separated;
   and periods are at least 24ε, so that charts of radius 19/2 ε about the points show each point once (docs/claims/hypotheses.md).
   Hypotheses 2 hold for each ρ₀ ≤ μ₀/4 and each small ξ₀.
2. The first point p to be perturbed lies on the circle about its neighbour q through the neighbours of q. Three of these, not p,
   are a simplex of 𝒮_p. So each x within ρ₀ε of p is within ρ₀ε of its circle.
3. 2α̃₀ ≥ ρ₀, where 2α̃₀/ρ₀ = 2¹⁷m^{3/2}/(Cμ₀³): then no x is a good perturbation (def:extended.good.pert), and the algorithm
   does not end.

Exit status 1 if all of this holds, 0 if not, with what fails.
"""

import argparse
import sys
from fractions import Fraction

DIMENSION = 2
NEIGHBOURS = [(1, 0), (0, 1), (-1, 1), (-1, 0), (0, -1), (1, -1)]


def squared(point):
    """|point|² in the hexagonal lattice of distance 1."""
    a, b = point
    return a * a + a * b + b * b


def plus(one, other):
    return one[0] + other[0], one[1] + other[1]


def minus(one, other):
    return one[0] - other[0], one[1] - other[1]


def tolerance(separation):
    """2α̃₀/ρ₀ for C = m^{3/2}(2/μ₀)^E, E = 4m² + 5m + 21, and α̃₀ = 2¹⁶m^{3/2}(ρ₀/C)/μ₀³."""
    exponent = 4 * DIMENSION**2 + 5 * DIMENSION + 21
    return 2**17 * (separation / 2)**exponent / separation**3


def failures(separation, periods):
    """What of 1 to 3 does not hold."""
    found = []
    if separation**2 >= 3:
        found.append("the lattice is not ε-dense")
    if separation <= 0 or periods * separation < 24:
        found.append("a period is shorter than 24ε")
    p, q = (0, 0), (1, 0)
    simplex = [plus(q, NEIGHBOURS[k]) for k in (0, 2, 4)]
    if p in simplex or any(squared(minus(vertex, q)) != squared(minus(p, q)) for vertex in simplex):
        found.append("the circle does not pass through the point")
    edges = [minus(vertex, simplex[0]) for vertex in simplex[1:]]
    if edges[0][0] * edges[1][1] == edges[0][1] * edges[1][0]:
        found.append("the simplex is degenerate")
    reach = 5 + Fraction(3, 2) * separation
    if any(squared(minus(vertex, p)) * separation**2 >= reach**2 for vertex in simplex):
        found.append("the simplex is not among those that are tested")
    if tolerance(separation) < 1:
        found.append("2α̃₀ < ρ₀: the circle leaves room")
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--separation", type=Fraction, default=Fraction(17, 10), help="μ₀ (default 17/10)")
    parser.add_argument("--periods", type=int, default=16, help="periods in units of the lattice (default 16)")
    arguments = parser.parse_args()
    found = failures(arguments.separation, arguments.periods)
    if found:
        print("no counterexample: " + "; ".join(found))
        return 0
    print(f"Theorem 1, as printed, fails on the hexagonal net of separation {arguments.separation} with {arguments.periods**2} points: "
          f"2α̃₀ = {float(tolerance(arguments.separation)):.4g} ρ₀, and the first point lies on a circle that is tested")
    return 1


if __name__ == "__main__":
    sys.exit(main())
