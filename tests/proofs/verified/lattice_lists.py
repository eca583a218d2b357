"""Triangulations of flat tori in the plain list of docs/verified.md: reading, writing, making and changing them."""

import copy
import itertools
import random


class LatticeList:
    """Integers only: `points` in units of 1/`period`, simplices as lists of (label, lattice vector)."""

    def __init__(self, period, gram, points, simplices):
        self.period, self.gram, self.points, self.simplices = period, gram, points, simplices

    @property
    def dimension(self):
        return len(self.gram)

    def copy(self):
        return copy.deepcopy(self)

    def text(self):
        row = lambda numbers: " ".join(map(str, numbers))
        lines = ["delcert-lattice 1", f"dimension {self.dimension}", f"period {self.period}", "gram"]
        lines += map(row, self.gram)
        lines += [f"points {len(self.points)}"] + [row(p) for p in self.points]
        lines += [f"simplices {len(self.simplices)}"]
        lines += ["  ".join(row([label, *shift]) for label, shift in s) for s in self.simplices]
        return "\n".join(lines) + "\n"

    def place(self, vertex):
        label, shift = vertex
        return [x + self.period * z for x, z in zip(self.points[label], shift)]

    def ordered(self):
        """Labels increase in each simplex, the first one is not moved, and simplices are in lexicographic order."""
        simplices = []
        for s in self.simplices:
            s = sorted(s)
            first = s[0][1]
            simplices.append([(label, [a - b for a, b in zip(shift, first)]) for label, shift in s])
        self.simplices = sorted(simplices, key=lambda s: [label for label, _ in s])
        return self


def read(text):
    lines = [line.split("#")[0].split() for line in text.splitlines()]
    words = iter([word for line in lines for word in line])
    number = lambda: int(next(words))
    assert [next(words) for _ in range(3)] == ["delcert-lattice", "1", "dimension"]
    m = number()
    vector = lambda: [number() for _ in range(m)]
    assert next(words) == "period"
    period = number()
    assert next(words) == "gram"
    gram = [vector() for _ in range(m)]
    assert next(words) == "points"
    points = [vector() for _ in range(number())]
    assert next(words) == "simplices"
    simplices = [[(number(), vector()) for _ in range(m + 1)] for _ in range(number())]
    return LatticeList(period, gram, points, simplices)


def kuhn(counts, noise=0, seed=1):
    """The points of a grid with these numbers of points along the axes, in the metric of the lattice A_m*, in which the
    triangulation of each cube along its diagonal (Kuhn's, Freudenthal's) is the Delaunay triangulation (Voronoi 1908:
    the principal form of the first type). `noise` moves each coordinate by at most that part of a cell."""
    m = len(counts)
    period = 1000
    for n in counts:
        period *= n
    base = [[m if a == b else -1 for b in range(m)] for a in range(m)]
    gram = [[base[a][b] * counts[a] * counts[b] for b in range(m)] for a in range(m)]
    draw = random.Random(seed)
    cells = list(itertools.product(*map(range, counts)))
    label_of = {cell: label for label, cell in enumerate(cells)}
    points = [[i * (period // n) + round(draw.uniform(-noise, noise) * period / n) for i, n in zip(cell, counts)]
              for cell in cells]
    simplices = []
    for cell in cells:
        for axes in itertools.permutations(range(m)):
            corner, simplex = list(cell), []
            for axis in (None, *axes):
                if axis is not None:
                    corner[axis] += 1
                label = label_of[tuple(i % n for i, n in zip(corner, counts))]
                simplex.append((label, [i // n for i, n in zip(corner, counts)]))
            simplices.append(simplex)
    return LatticeList(period, gram, points, simplices).ordered()
