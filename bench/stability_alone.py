#!/usr/bin/env python3
"""How many stars of a zero set the stability lemma alone proves to be stars of the Delaunay complex of M: rule 4.stability of
docs/metric-fields.md, star by star, for a certificate of a run. In doubles: a figure that level 4 is compared with, and no
part of a proof.

  bench/stability_alone.py CERTIFICATE.json

Charts change distances by factors from 1 to sqrt(1 + L^2), L the greatest slope of M that chart i shows within two
circumradii of its point; so, with the scale in the middle of these, kappa = (S - 1)/(S + 1) with S = sqrt(1 + L^2). Circumradius,
thickness, protection and edges are those of star(i) in chart i.
"""

import itertools
import json
import math
import sys
from fractions import Fraction
from pathlib import Path


def number(text):
    """As certificates write them: 3/4, 0x3p-2."""
    return float.fromhex(text) if "x" in text else float(Fraction(text))


def solved(a, b):
    """x with a x = b, for a square matrix a and a matrix b of as many rows."""
    size, rows = len(a), [list(x) + list(y) for x, y in zip(a, b)]
    for k in range(size):
        pivot = max(range(k, size), key=lambda i: abs(rows[i][k]))
        rows[k], rows[pivot] = rows[pivot], rows[k]
        rows[k] = [x / rows[k][k] for x in rows[k]]
        for i in range(size):
            if i != k and rows[i][k]:
                factor = rows[i][k]
                rows[i] = [x - factor * y for x, y in zip(rows[i], rows[k])]
    return [row[size:] for row in rows]


def product(a, b):
    return [[sum(x * y for x, y in zip(row, column)) for column in zip(*b)] for row in a]


def norm(vector):
    return math.sqrt(sum(x * x for x in vector))


def difference(a, b):
    return [x - y for x, y in zip(a, b)]


class Manifold:
    def __init__(self, document):
        stated = document["manifold"]
        self.m, self.N = stated["dimension"], len(stated["variables"])
        self.q = self.N - self.m
        texts = [text.replace("^", "**") for text in stated["equations"]]
        names = {name: getattr(math, name) for name in ("sqrt", "exp", "sin", "cos")}
        self.f = eval(f"lambda {', '.join(stated['variables'])}: [{', '.join(texts)}]", names)

    def jacobian(self, x):
        step, columns = 2.0 ** -18, []
        for k in range(self.N):
            ends = [self.f(*[y + sign * step * (k == axis) for axis, y in enumerate(x)]) for sign in (1, -1)]
            columns.append([(a - b) / (2 * step) for a, b in zip(*ends)])
        return [list(row) for row in zip(*columns)]


class Chart:
    def __init__(self, manifold, numbers, centre):
        N, m = manifold.N, manifold.m
        columns, rest = [int(s) for s in numbers[:N]], iter(numbers[N:])
        plus = [[float(i == k) for k in range(N)] for i in range(N)]
        for i, k in itertools.combinations(range(N), 2):
            plus[i][k] = number(next(rest))
            plus[k][i] = -plus[i][k]
        cayley = solved(plus, [list(column) for column in zip(*plus)])
        frame = [[math.copysign(1, s) * row[abs(s) - 1] for s in columns] for row in cayley]
        self.tangent, self.normal = [row[:m] for row in frame], [row[m:] for row in frame]
        self.centre = [number(x) for x in centre]

    def place(self, x):
        offset = difference(x, self.centre)
        return [sum(row[k] * y for row, y in zip(self.tangent, offset)) for k in range(len(self.tangent[0]))]

    def point(self, manifold, home):
        """The point of M over this place."""
        x = [c + sum(a * y for a, y in zip(row, home)) for c, row in zip(self.centre, self.tangent)]
        for _ in range(8):
            heights = solved(product(manifold.jacobian(x), self.normal), [[value] for value in manifold.f(*x)])
            x = [a - sum(b * z[0] for b, z in zip(row, heights)) for a, row in zip(x, self.normal)]
        return x

    def slope(self, jacobian):
        return norm(x for row in solved(product(jacobian, self.normal), product(jacobian, self.tangent)) for x in row)


def ball(places):
    """Centre and radius of the circumscribed sphere of a simplex."""
    edges = [difference(x, places[0]) for x in places[1:]]
    offset = [row[0] for row in solved(edges, [[sum(x * x for x in edge) / 2] for edge in edges])]
    return [a + b for a, b in zip(places[0], offset)], norm(offset)


def least_altitude(places):
    edges = [difference(x, places[0]) for x in places[1:]]
    m = len(edges)
    dual = solved([list(row) for row in zip(*edges)], [[float(i == k) for k in range(m)] for i in range(m)])
    dual.append([sum(column) for column in zip(*dual)])
    return 1 / max(norm(row) for row in dual)


def passing(document):
    """How many stars pass, of how many."""
    manifold = Manifold(document)
    charts = [Chart(manifold, numbers, centre) for numbers, centre in zip(document["charts"], document["net"])]
    points = [chart.point(manifold, [number(y) for y in home])
              for chart, home in zip(charts, document["points"])]
    jacobians = [manifold.jacobian(x) for x in points]
    stars = [[] for _ in points]
    for entry in document["simplices"]:
        simplex = entry[:manifold.m + 1]  # elements of a group follow
        for label in simplex:
            stars[label].append(simplex)
    m, passed = manifold.m, 0
    around = [{label for simplex in star for label in simplex} for star in stars]
    for i, star in enumerate(stars):
        near = set().union(*(around[k] for k in around[i]))
        near = set().union(*(around[k] for k in near))
        places = {k: charts[i].place(points[k]) for k in near}
        r, t, delta, longest = 0, math.inf, math.inf, []
        for simplex in star:
            corners = [places[k] for k in simplex]
            centre, radius = ball(corners)
            edge = max(norm(difference(a, b)) for a, b in itertools.combinations(corners, 2))
            r, t = max(r, radius), min(t, least_altitude(corners) / (m * edge))
            delta = min(delta, min(norm(difference(places[k], centre)) for k in near if k not in simplex) - radius)
            longest.append(edge)
        shown = [k for k in near if norm(difference(places[k], places[i])) <= 2 * r]
        stretch = math.sqrt(1 + max(charts[i].slope(jacobians[k]) for k in shown) ** 2)
        kappa = (stretch - 1) / (stretch + 1)
        s, h = (1 + kappa) / (1 - kappa), 4 * kappa * r * r / (1 - kappa) ** 2
        passed += delta > 0 and all((m + 1) * h * (1 + 2 * s * r / (m * t * edge)) <= edge * delta + delta * delta
                                    for edge in longest)
    return passed, len(points)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        raise SystemExit(__doc__)
    print("{} of {} stars pass 4.stability".format(*passing(json.loads(Path(sys.argv[1]).read_text()))))
