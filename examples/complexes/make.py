#!/usr/bin/env python3
"""Makes the complexes of this folder, which `delcert certify --complex` certifies (docs/complex-file.md).

    make.py [FOLDER]      writes the files, into this folder or another one
    make.py --pairings    lists the manifolds that the search among side pairings of the dodecahedron finds

Group elements are exact matrices over a quadratic field. Points are chosen in doubles and rounded: only which
simplices there are, and with which elements, has to be exact.
"""

import functools
import itertools
import math
import os
import sys
from fractions import Fraction


# Numbers a + bt of a quadratic field, t² = trace·t − norm.

class Number:
    __slots__ = ("field", "a", "b")

    def __init__(self, field, a, b=0):
        self.field, self.a, self.b = field, Fraction(a), Fraction(b)

    def of(self, other):
        return other if isinstance(other, Number) else Number(self.field, other)

    def __add__(self, other):
        other = self.of(other)
        return Number(self.field, self.a + other.a, self.b + other.b)

    def __sub__(self, other):
        return self + self.of(other) * -1

    def __mul__(self, other):
        other = self.of(other)
        product = self.b * other.b
        return Number(self.field, self.a * other.a - product * self.field.norm,
                      self.a * other.b + self.b * other.a + product * self.field.trace)

    def inverse(self):
        conjugate = Number(self.field, self.a + self.b * self.field.trace, -self.b)
        return conjugate * (1 / (self * conjugate).a)

    def __eq__(self, other):
        other = self.of(other)
        return self.a == other.a and self.b == other.b

    def __hash__(self):
        return hash((self.a, self.b))

    def __float__(self):
        return float(self.a) + float(self.b) * self.field.root

    def __str__(self):
        """As delcert reads it: "-1/2*t + 3"."""
        if self.b == 0:
            return str(self.a)
        size = "t" if abs(self.b) == 1 else f"{abs(self.b)}*t"
        text = size if self.b > 0 else "-" + size
        return text if self.a == 0 else f"{text} {'+' if self.a > 0 else '-'} {abs(self.a)}"


class Field:
    def __init__(self, text, ends, trace, norm):
        self.text, self.ends, self.trace, self.norm = text, ends, trace, norm
        self.root = (trace + math.sqrt(trace * trace - 4 * norm)) / 2
        self.t = Number(self, 0, 1)
        self.one = Number(self, 1)


ROOT_OF_2 = Field("t^2 - 2", (1, 2), 0, -2)
GOLDEN_RATIO = Field("t^2 - t - 1", ("3/2", 2), 1, -1)


# Matrices are tuples of rows.

def product(a, b):
    return tuple(tuple(sum((x * b[k][j] for k, x in enumerate(row) if not x == 0), row[0] * 0)
                       for j in range(len(b[0]))) for row in a)


def identity(field, order):
    return tuple(tuple(field.one * (i == j) for j in range(order)) for i in range(order))


def inverse(a):
    order = len(a)
    field = a[0][0].field
    rows = [list(row) + list(unit) for row, unit in zip(a, identity(field, order))]
    for k in range(order):
        pivot = next(i for i in range(k, order) if not rows[i][k] == 0)
        rows[k], rows[pivot] = rows[pivot], rows[k]
        factor = rows[k][k].inverse()
        rows[k] = [x * factor for x in rows[k]]
        for i in range(order):
            if i != k and not rows[i][k] == 0:
                factor = rows[i][k]
                rows[i] = [x - factor * y for x, y in zip(rows[i], rows[k])]
    return tuple(tuple(row[order:]) for row in rows)


class Element:
    """An isometry with a word for it: letters (name, ±1)."""

    def __init__(self, matrix, word):
        self.matrix, self.word, self.hash = matrix, word, hash(matrix)

    @functools.cache
    def __mul__(self, other):
        word = list(self.word)
        for letter in other.word:
            if word and word[-1] == (letter[0], -letter[1]):
                word.pop()
            else:
                word.append(letter)
        return Element(product(self.matrix, other.matrix), tuple(word))

    @functools.cache
    def inverse(self):
        return Element(inverse(self.matrix), tuple((name, -sign) for name, sign in reversed(self.word)))

    def __eq__(self, other):
        return self is other or (self.hash == other.hash and self.matrix == other.matrix)

    def __hash__(self):
        return self.hash

    def text(self, point):
        """"a b^-1 p"."""
        letters = [name if sign > 0 else name + "^-1" for name, sign in self.word]
        return " ".join(letters + [point])


# A polytope in hyperbolic space about the origin, in the form time·x₀² + |y|²: the facet k is on the plane whose normal
# is (alpha, normals[k]).

class Polytope:
    def __init__(self, field, time, alpha, normals, neighbours, corners):
        self.field, self.time, self.alpha, self.normals = field, time, alpha, normals
        self.neighbours = neighbours  # of each facet: the facets beside it, counter-clockwise
        self.corners = corners        # sets of facets
        self.dimension = len(normals[0])

    def reflection(self, k):
        """x ↦ x − 2⟨x, N⟩/⟨N, N⟩ N."""
        normal = (self.alpha,) + self.normals[k]
        dual = (self.alpha * self.time,) + self.normals[k]
        factor = sum((x * y for x, y in zip(normal, dual)), self.field.one * 0).inverse() * -2
        return tuple(tuple(self.field.one * (i == j) + factor * normal[i] * dual[j] for j in range(len(normal)))
                     for i in range(len(normal)))

    def symmetry(self, images):
        """The isometry about the origin that takes facets to facets: those of a basis decide."""
        columns = list(images)[:self.dimension]
        before = tuple(zip(*(self.normals[k] for k in columns)))
        after = tuple(zip(*(self.normals[images[k]] for k in columns)))
        linear = product(after, inverse(before))
        zero = self.field.one * 0
        return ((self.field.one,) + (zero,) * self.dimension,) + tuple((zero,) + row for row in linear)

    def pairing(self, name, images):
        """The isometry that takes the first facet of `images` to its image, the facets beside it so that they meet it
        as their images do, and the polytope to the other side of the image."""
        target = next(iter(images.values()))
        return Element(product(self.reflection(target), self.symmetry(images)), ((name, 1),))

    def corner(self, facets):
        """Its place, in doubles: a point of the hyperboloid −x₀² + |y|² = −1."""
        rows = [[float(x) for x in self.normals[k]] for k in sorted(facets)[:self.dimension]]
        right = -float(self.time) * float(self.alpha)
        y = [determinant([row[:j] + [right] + row[j + 1:] for row in rows]) / determinant(rows)
             for j in range(self.dimension)]
        return normalised([math.sqrt(-float(self.time))] + y)


def determinant(a):
    if len(a) == 2:
        return a[0][0] * a[1][1] - a[0][1] * a[1][0]
    return sum((-1) ** j * a[0][j] * determinant([row[:j] + row[j + 1:] for row in a[1:]]) for j in range(3))


def normalised(x):
    size = math.sqrt(x[0] * x[0] - sum(y * y for y in x[1:]))
    return [y / size for y in x]


def barycentre(points, weights=None):
    weights = weights or [1] * len(points)
    return normalised([sum(w * x for w, x in zip(weights, column)) for column in zip(*points)])


def moved(time, element, x):
    """A point of the hyperboloid, in doubles, by an exact matrix of the form time·x₀² + |y|²."""
    scale = math.sqrt(-float(time))
    y = [x[0] / scale] + list(x[1:])
    image = [sum(float(a) * b for a, b in zip(row, y)) for row in element.matrix]
    return [image[0] * scale] + image[1:]


def conformal(x):
    return [2 * y / (1 + x[0]) for y in x[1:]]


class Quotient:
    """Facets of a polytope paired by isometries: a face is the image of the first one of its class."""

    def __init__(self, polytope, pairings):
        self.polytope = polytope
        self.generators = {name: polytope.pairing(name, images) for name, images in pairings.items()}
        self.maps = []
        for name, images in pairings.items():
            there = dict(images)
            self.maps.append((next(iter(images)), there, self.generators[name]))
            self.maps.append((next(iter(images.values())), {b: a for a, b in there.items()},
                              self.generators[name].inverse()))
        self.known = {}

    def place(self, face):
        """(the first face of the class, the element that takes it here); a face is the set of facets that it lies on."""
        if face not in self.known:
            one = Element(identity(self.polytope.field, self.polytope.dimension + 1), ())
            self.known[face] = (face, one)
            front = [face]
            for here in front:
                for facet, images, element in self.maps:
                    if facet not in here:
                        continue
                    there = frozenset(images[k] for k in here)
                    if there not in self.known:
                        self.known[there] = (face, element * self.known[here][1])
                        front.append(there)
        return self.known[face]


# Files.

def toml_matrix(matrix):
    texts = [[f'"{x}"' for x in row] for row in matrix]
    widths = [max(len(row[j]) for row in texts) for j in range(len(texts))]
    rows = ["[" + ", ".join(x.ljust(w) for x, w in zip(row, widths)).rstrip() + "]" for row in texts]
    return "[\n  " + ",\n  ".join(rows) + "]"


def write(folder, name, comment, polytope, generators, points, simplices):
    """points: (name, place) in order, all names numbers or none; simplices: lists of (name, element)."""
    lines = [f"# {line}" for line in comment]
    lines += [f'name = "{name}"', 'family = "complex"', f"dimension = {polytope.dimension}", "curvature = -1",
              f'field = "{polytope.field.text}"',
              "root = [" + ", ".join(f'"{x}"' if isinstance(x, str) else str(x) for x in polytope.field.ends) + "]",
              f'time = "{polytope.time}"']
    are_numbers = all(isinstance(point, int) for point, _ in points)

    def coordinates(place):
        return "[" + ", ".join(f"{x + 0.0 if round(x, 4) else 0.0:.4f}" for x in conformal(place)) + "]"

    def vertex(point, element):
        if are_numbers and not element.word:
            return str(point)
        return '"' + element.text(str(point)) + '"'

    if are_numbers:
        lines += ["points = ["] + [f"  {coordinates(place)}," for _, place in points] + ["]"]
    lines += ["simplices = ["]
    lines += ["  [" + ", ".join(vertex(*v) for v in simplex) + "]," for simplex in simplices] + ["]"]
    if not are_numbers:
        lines += ["", "[points]"] + [f"{point} = {coordinates(place)}" for point, place in points]
    lines += ["", "[generators]"] + [f"{key} = {toml_matrix(generators[key].matrix)}" for key in sorted(generators)]
    with open(os.path.join(folder, name + ".toml"), "w", encoding="utf-8", newline="\n") as file:
        file.write("\n".join(lines) + "\n")


# Surfaces from the regular octagon with angles π/4.

def octagon():
    t, one, zero = ROOT_OF_2.t, ROOT_OF_2.one, ROOT_OF_2.one * 0
    half = t * Fraction(1, 2)
    normals = [(one, zero), (half, half), (zero, one), (half * -1, half)]
    normals += [(x * -1, y * -1) for x, y in normals]
    around = [((k + 1) % 8, (k - 1) % 8) for k in range(8)]
    return Polytope(ROOT_OF_2, one * 2 - t * 2, one, normals, around, [frozenset((k, (k + 1) % 8)) for k in range(8)])


def octagon_pairings(word):
    """Of a word such as "abABcdCD" around the octagon, capitals for inverses: the facets beside are paired in reverse
    where a letter comes once with and once against its direction."""
    result = {}
    for name in sorted(set(word.lower())):
        i, j = [k for k, letter in enumerate(word) if letter.lower() == name]
        turn = 1 if word[i] == word[j] else -1
        result[name] = {i: j, (i + 1) % 8: (j + turn) % 8, (i - 1) % 8: (j - turn) % 8}
    return result


def surface(folder, name, comment, word):
    """Sides in three parts, a ring of 24 points inside, and the centre."""
    polytope = octagon()
    quotient = Quotient(polytope, octagon_pairings(word))
    one = quotient.place(frozenset())[1]
    points = {"o": [1.0, 0.0, 0.0]}
    boundary = []
    corners = [frozenset(((k - 1) % 8, k)) for k in range(8)]
    places = [polytope.corner(corner) for corner in corners]
    points["v"] = places[0]
    for k in range(8):
        boundary.append(("v", quotient.place(corners[k])[1]))
        first, element = quotient.place(frozenset((k,)))
        (side,) = first
        letter = word[side].lower()
        if side == k:
            for part in (1, 2):
                points[f"{letter}{part}"] = barycentre((places[k], places[(k + 1) % 8]), (4 - part, 1 + part))
        # Whether the element takes the beginning of the first side to the beginning of this one.
        parts = (1, 2) if word[side] == word[k] else (2, 1)
        boundary += [(f"{letter}{part}", element) for part in parts]
    simplices = []
    for k in range(24):
        beyond = (boundary[k], boundary[(k + 1) % 24])
        # So weighted that the triangles are Delaunay.
        weights = [7 if point == "v" else 10 for point, _ in beyond]
        places = [moved(polytope.time, element, points[point]) for point, element in beyond]
        points[f"r{k:02}"] = barycentre([points["o"]] + places, [10 if 7 in weights else 5] + weights)
    for k in range(24):
        here, there = (f"r{k:02}", one), (f"r{(k + 1) % 24:02}", one)
        simplices += [[here, boundary[k], boundary[(k + 1) % 24]], [here, there, boundary[(k + 1) % 24]],
                      [("o", one), here, there]]
    write(folder, name, comment, polytope, quotient.generators, sorted(points.items()), simplices)


# 3-manifolds from the regular dodecahedron with dihedral angles 2π/5.

def dodecahedron():
    t, one, zero = GOLDEN_RATIO.t, GOLDEN_RATIO.one, GOLDEN_RATIO.one * 0
    normals = []
    for s, u in itertools.product((1, -1), repeat=2):
        triple = (zero, one * s, t * u)
        normals += [triple, triple[1:] + triple[:1], triple[2:] + triple[:2]]

    def dot(x, y):
        return sum((a * b for a, b in zip(x, y)), zero)

    def are_beside(j, k):
        return dot(normals[j], normals[k]) == t

    around = []
    for k in range(12):
        beside = [j for j in range(12) if are_beside(j, k)]
        ring = [beside[0]]
        while len(ring) < 5:
            ring.append(next(j for j in beside if are_beside(j, ring[-1]) and j not in ring
                             and float_determinant(normals, k, ring[-1], j) > 0))
        around.append(tuple(ring))
    corners = sorted({frozenset((j, k, l)) for j in range(12) for k in around[j] for l in around[j]
                      if l in around[k]}, key=sorted)
    return Polytope(GOLDEN_RATIO, t * Fraction(-7, 4) - Fraction(3, 4), one * 4 - t * 2, normals, around, corners)


def float_determinant(normals, i, j, k):
    return determinant([[float(x) for x in normals[n]] for n in (i, j, k)])


def images_of(polytope, i, j, turn):
    """Facet i to facet j, so that the polytope comes to lie beyond j: the ring about i goes backwards about j."""
    images = {i: j}
    for a in range(5):
        images[polytope.neighbours[i][a]] = polytope.neighbours[j][(turn - a) % 5]
    return images


def five_at_each_edge(maps, edges):
    """Whether every edge, followed around through the facets that are paired so far, closes up after five of them, if it
    can be followed so far. Edges are pairs of facets: the one that is crossed, and the other one."""
    for start in edges:
        here = start
        for count in range(1, 6):
            images = maps.get(here[0])
            if images is None:
                break
            # Beyond the facet here[0] is another copy of the polytope, in which the edge is on these facets.
            here = (images[here[1]], images[here[0]])
            if (here == start) != (count == 5):
                return False
    return True


def pairings_of(polytope, partners=None):
    """All ways to pair the facets, orientably, so that five dodecahedra meet at each edge: lists of (i, j, turn)."""
    edges = [(j, k) for j in range(12) for k in polytope.neighbours[j]]
    maps, chosen = {}, []

    def search():
        free = [k for k in range(12) if k not in maps]
        if not free:
            yield list(chosen)
            return
        i = free[0]
        for j in free[1:]:
            if partners is not None and partners[i] != j:
                continue
            for turn in range(5):
                images = images_of(polytope, i, j, turn)
                maps[i], maps[j] = images, {b: a for a, b in images.items()}
                if five_at_each_edge(maps, edges):
                    chosen.append((i, j, turn))
                    yield from search()
                    chosen.pop()
                del maps[i], maps[j]

    return search()


# What `--pairings` prints for H₁ = ℤ/29: faces, and how far they are turned.
PAIRING_29 = [(0, 1, 1), (2, 4, 4), (3, 5, 0), (6, 9, 3), (7, 10, 0), (8, 11, 0)]


def named(polytope, pairing):
    return {name: images_of(polytope, *one) for name, one in zip("abcdef", pairing)}


def first_homology(polytope, pairing):
    """The invariant factors, without 1, of the group made abelian; 0 for a free summand: one relation for each edge."""
    letters = {}
    for number, (i, j, turn) in enumerate(pairing):
        images = images_of(polytope, i, j, turn)
        letters[i], letters[j] = (number, 1, images), (number, -1, {b: a for a, b in images.items()})
    rows, seen = [], set()
    for j in range(12):
        for k in polytope.neighbours[j]:
            if (j, k) in seen:
                continue
            row, here = [0] * 6, (j, k)
            while True:
                seen.add(here)
                number, sign, images = letters[here[0]]
                row[number] += sign
                here = (images[here[1]], images[here[0]])
                if here == (j, k):
                    break
            rows.append(row)
    return smith_form(rows, 6)


def smith_form(rows, columns):
    result = []
    rows = [row[:] for row in rows]
    while any(any(row) for row in rows):
        while True:
            _, i, j = min((abs(x), i, j) for i, row in enumerate(rows) for j, x in enumerate(row) if x)
            pivot = rows[i][j]
            for k, row in enumerate(rows):
                if k != i:
                    factor = row[j] // pivot
                    rows[k] = [x - factor * y for x, y in zip(row, rows[i])]
            for l in range(len(rows[i])):
                if l != j:
                    factor = rows[i][l] // pivot
                    for row in rows:
                        row[l] -= factor * row[j]
            others = [x for k, row in enumerate(rows) for l, x in enumerate(row) if (k == i) != (l == j) and x]
            if others:
                continue
            bad = next((k for k, row in enumerate(rows) if k != i and any(x % pivot for x in row)), None)
            if bad is None:
                break
            rows[i] = [x + y for x, y in zip(rows[i], rows[bad])]
        result.append(abs(pivot))
        rows = [row[:j] + row[j + 1:] for k, row in enumerate(rows) if k != i]
    return [d for d in result if d != 1] + [0] * (columns - len(result))


def flags(polytope, quotient):
    """The barycentric subdivision of the polytope: simplices of a corner, an edge, a facet and the whole, each a pair of
    a name and an element; and the places of the names."""
    places, simplices = {}, []
    corner = {facets: polytope.corner(facets) for facets in polytope.corners}

    def vertex(face):
        first, element = quotient.place(face)
        places[tuple(sorted(first))] = barycentre([corner[c] for c in polytope.corners if first <= c])
        return tuple(sorted(first)), element

    for facets in polytope.corners:
        for order in itertools.permutations(sorted(facets)):
            simplices.append([vertex(frozenset(order[:size])) for size in (3, 2, 1, 0)])
    return simplices, places


def subdivided(time, simplices, places):
    """Barycentrically. A point of it is a face, moved so that its first vertex is at the identity."""
    names, new_places, result = {}, [], []

    def vertex(face):
        face = sorted(face, key=lambda v: (len(v[0]), v[0]))
        back = face[0][1].inverse()
        lifts = [(name, back * element) for name, element in face]
        key = tuple(lifts)
        if key not in names:
            names[key] = len(names)
            new_places.append((names[key], barycentre([moved(time, e, places[name]) for name, e in lifts])))
        return names[key], face[0][1]

    for simplex in simplices:
        vertices = {}
        for size in range(1, 5):
            for face in itertools.combinations(range(4), size):
                vertices[face] = vertex([simplex[k] for k in face])
        for order in itertools.permutations(range(4)):
            result.append([vertices[tuple(sorted(order[:size]))] for size in (1, 2, 3, 4)])
    return result, new_places


def dodecahedral_space(folder, name, comment, polytope, pairing):
    quotient = Quotient(polytope, named(polytope, pairing))
    simplices, places = flags(polytope, quotient)
    simplices, points = subdivided(polytope.time, simplices, places)
    write(folder, name, comment, polytope, quotient.generators, points, simplices)


def opposite_of(polytope):
    return [next(j for j in range(12) if all((x + y) == 0 for x, y in zip(polytope.normals[j], polytope.normals[k])))
            for k in range(12)]


def klein_bottle(folder):
    """Three columns of three points, a triangular lattice; a fourth one is the image of the first."""
    def at(column, row):
        turns, row = divmod(row, 3)
        if column < 3:
            word = "" if turns == 0 else "e2 "
            return f'"{word}{"abc"[column]}{row}"'
        # The glide reflection takes a_k to the height 1/6 − k/3.
        back, row = divmod(-(row + 3 * turns), 3)
        return f'"g {"" if back == 0 else "e2^-1 "}a{row}"'

    rows = []
    for column, shift in ((0, 0), (1, 1), (2, 0)):
        for k in range(3):
            left, right = (at(column, k), at(column, k + 1)), (at(column + 1, k + shift), at(column + 1, k + 1 + shift))
            rows.append(f"  [{left[0]}, {left[1]}, {right[0]}], [{left[1]}, {right[0]}, {right[1]}],")
    lines = ["# A Klein bottle, typed by hand: three columns of three points, equilateral triangles, and the glide reflection",
             "# g: (x, y) ↦ (x + 1/2, 1/6 − y). e2 is the translation by the second basis vector of the lattice.",
             'name = "klein-bottle-9"', 'family = "complex"', "dimension = 2", "curvature = 0",
             "gram = [[3, 0], [0, 1]]", "simplices = ["] + rows + ["]", "", "[points]"]
    for column, x in enumerate(("0", '"1/6"', '"1/3"')):
        for k in range(3):
            y = Fraction(k, 3) + Fraction(column % 2, 6)
            lines.append(f'{"abc"[column]}{k} = [{x}, ' + (f'"{y}"' if y.denominator > 1 else str(y)) + "]")
    lines += ["", "[generators]", 'g = [[1, 0, 0], ["1/2", 1, 0], ["1/6", 0, -1]]']
    with open(os.path.join(folder, "klein-bottle-9.toml"), "w", encoding="utf-8", newline="\n") as file:
        file.write("\n".join(lines) + "\n")


def make(folder):
    klein_bottle(folder)
    surface(folder, "genus-2", ["The closed surface of genus 2 from the regular octagon with angles π/4, sides paired as in",
                                "a b a⁻¹ b⁻¹ c d c⁻¹ d⁻¹. Made by make.py."], "abABcdCD")
    surface(folder, "four-crosscaps", ["The non-orientable closed surface of Euler characteristic −2 from the same octagon, sides",
                                       "paired as in a a b b c c d d. Made by make.py."], "aabbccdd")
    polytope = dodecahedron()
    first = next(pairings_of(polytope, opposite_of(polytope)))
    dodecahedral_space(folder, "seifert-weber", [
        "The Seifert–Weber space: the regular dodecahedron with dihedral angles 2π/5, opposite faces paired by a turn of",
        "3/10, subdivided barycentrically twice. Made by make.py."], polytope, first)
    dodecahedral_space(folder, "dodecahedral-29", [
        "A closed hyperbolic 3-manifold with H₁ = ℤ/29 from the dodecahedron of the Seifert–Weber space, with other pairs of",
        "faces (make.py --pairings), subdivided barycentrically twice. Made by make.py."], polytope, PAIRING_29)


if __name__ == "__main__":
    if sys.argv[1:] == ["--pairings"]:
        solid = dodecahedron()
        found = {}
        for one in pairings_of(solid):
            found.setdefault(tuple(first_homology(solid, one)), []).append(one)
        for factors, all_of_them in sorted(found.items()):
            print(factors, len(all_of_them), all_of_them[0])
    else:
        make(sys.argv[1] if len(sys.argv) > 1 else os.path.dirname(os.path.abspath(__file__)))
