#!/usr/bin/env python3
"""Decides whether Theorem 2, as printed, fails on a certified torus that is given a metric with a shortcut.

usage: shortcut_metric.py CERTIFICATE.json [--length NUMBER] [--offset NUMBER]

The certificate is one of `delcert certify --manifold torus-2 --mode theory`, not compressed, that delcert-check accepts: its input meets
Hypotheses 1 and 2, and its complex is the output of the algorithm. |x − y| is the distance on the torus. For two points
a, b of the torus and s > 0, the shortcut,

  d(x, y) = min(|x − y|, |x − a| + s + |b − y|, |x − b| + s + |a − y|)

is the distance in the torus with a segment of length s attached at a and b, so a metric, and near each point it is |x − y|.
The script takes s = `length`·ε, a at distance h = `offset`·ε from a point p of P′, and for b the point of P′ farthest from a,
and decides in rational numbers:

1. |a − b| + s ≥ 24ε. Then d(x, y) = |x − y| wherever |x − y| ≤ 12ε, as |x − a| + |b − y| ≥ |a − b| − |x − y|. So the hypothesis
   of Theorem 2 on d_M holds with η = 0: two points of a ball B(p_i, 6ε) are at most 12ε apart.
2. At the point x of the segment from a to p with |x − a| = (h − s)/2: d(x, p) = d(x, b) = (h + s)/2, and no point of P′ is nearer. So p
   and b are an edge of the Delaunay complex of P′ with respect to d, the nerve of the Voronoi diagram.
3. The complex of the certificate does not have this edge.

Exit status 1 if all of this holds: the theorem as printed is refuted. 0 if something does not hold, with what it is. 3 for a
certificate of another kind.
"""

import argparse
import json
import sys
from fractions import Fraction


def number(text):
    """An integer, a fraction, or a hexadecimal float: 0x<digits>p<exponent>."""
    if "p" in text:
        digits, exponent = text.split("p")
        return Fraction(int(digits, 16)) * Fraction(2)**int(exponent)
    return Fraction(text)


def squared(x, y):
    """The squared distance on the square torus of period 1."""
    total = Fraction(0)
    for one, other in zip(x, y):
        part = (one - other) % 1
        total += min(part, 1 - part)**2
    return total


def at_least(square, length):
    """Whether √square ≥ length."""
    return length <= 0 or square >= length**2


def unfit(certificate):
    """The reason why the argument does not apply to a certificate; empty if it applies."""
    manifold, parameters, levels = certificate["manifold"], certificate["parameters"], certificate["levels"]
    if manifold.get("family") != "flat-torus" or [[number(one) for one in row] for row in manifold["gram"]] != [[1, 0], [0, 1]]:
        return "not the square torus"
    if parameters["mode"] != "theory" or not levels.get("0", {}).get("hypotheses_2"):
        return "Hypotheses 2 are not certified"
    if "4" not in levels:
        return "the complex is not certified to be the Delaunay complex of the torus"
    return ""


def failures(certificate, length, offset):
    """(what of 1 to 3 does not hold, a sentence on the edge)."""
    radius = number(certificate["parameters"]["sampling_radius"])
    points = [[number(one) for one in point] for point in certificate["points"]]
    vertices = len(certificate["simplices"][0]) // 2 + 1
    edges = {frozenset((one, other)) for simplex in certificate["simplices"] for one in simplex[:vertices] for other in simplex[:vertices]}
    s, h, p = length * radius, offset * radius, 0
    a = [points[p][0] + h, points[p][1]]
    b = max(range(len(points)), key=lambda label: squared(a, points[label]))
    found = []
    if not at_least(squared(a, points[b]), 24 * radius - s):
        found.append("d differs from the distance of the torus within 12ε")
    if not 0 < s < h:
        found.append("the shortcut is not shorter than the way to the next point")
    else:
        half = (h + s) / 2
        x = [points[p][0] + half, points[p][1]]
        if squared(x, a) != ((h - s) / 2)**2 or squared(x, points[p]) != half**2:
            found.append("the point is not where it should be")
        if not all(at_least(squared(x, point), half) for point in points):
            found.append("another point of P′ is nearer")
        if not at_least(squared(x, points[b]), half):
            found.append("the shortcut is nearer from its other end")
    if frozenset((p, b)) in edges:
        found.append("the complex has the edge")
    return found, f"{p} and {b}, two points {float(squared(points[p], points[b]))**0.5 / float(radius):.4g} ε apart"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("certificate")
    parser.add_argument("--length", type=Fraction, default=Fraction(1, 10), help="s/ε (default 1/10)")
    parser.add_argument("--offset", type=Fraction, default=Fraction(1, 5), help="|a − p|/ε (default 1/5)")
    arguments = parser.parse_args()
    try:
        with open(arguments.certificate, encoding="utf-8") as file:
            certificate = json.load(file)
        reason = unfit(certificate)
    except (OSError, ValueError, KeyError) as error:
        reason = f"cannot be read: {error}"
    if reason:
        print(f"{arguments.certificate}: {reason}", file=sys.stderr)
        return 3
    found, edge = failures(certificate, arguments.length, arguments.offset)
    if found:
        print("no counterexample: " + "; ".join(found))
        return 0
    print(f"Theorem 2, as printed, fails for a metric with a shortcut of length {arguments.length} ε, η = 0: the Delaunay complex has the edge of {edge}, "
          "and the output does not")
    return 1


if __name__ == "__main__":
    sys.exit(main())
