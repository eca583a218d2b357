#!/usr/bin/env python3
"""mesh_manifold.py DELCERT DELCERT_CHECK: a closed mesh in space is a manifold of its own: `delcert certify` meshes it anew and
delcert-check verifies that; a mesh that is not closed, meets itself or has a sharp crease is refused, and what is wrong is named."""

import math
import subprocess
import sys
import tempfile
from pathlib import Path

DIVISIONS = 24


def sphere(divisions=DIVISIONS, centre=(0.0, 0.0, 0.0)):
    """The octahedron, its faces divided, its vertices on the unit sphere, in decimals of 17 digits; facets show their outer sides."""
    numbers, points, facets = {}, [], []

    def vertex(*at):
        if at not in numbers:
            numbers[at] = len(points)
            length = math.sqrt(sum(x * x for x in at))
            points.append([x / length + c for x, c in zip(at, centre)])
        return numbers[at]

    for octant in range(8):
        sign = [1 - 2 * (octant >> axis & 1) for axis in range(3)]

        def corner(i, j):
            return vertex(sign[0] * i, sign[1] * j, sign[2] * (divisions - i - j))

        def add(a, b, c):
            facets.append([a, b, c] if sign[0] * sign[1] * sign[2] > 0 else [a, c, b])

        for i in range(divisions):
            for j in range(divisions - i):
                add(corner(i, j), corner(i + 1, j), corner(i, j + 1))
                if i + j + 1 < divisions:
                    add(corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1))
    return points, facets


def off(points, facets):
    lines = [f"OFF\n{len(points)} {len(facets)} 0"]
    lines += [" ".join(x if isinstance(x, str) else "%.16g" % x for x in point) for point in points]
    lines += ["3 %d %d %d" % tuple(facet) for facet in facets]
    return "\n".join(lines) + "\n"


def together(one, other):
    return one[0] + other[0], one[1] + [[vertex + len(one[0]) for vertex in facet] for facet in other[1]]


def cracked(points, facets):
    """One facet has a vertex of its own, a unit in the last place away from that of the others."""
    number = facets[100][0]
    twin = list(points[number])
    twin[0] = "%.17g" % math.nextafter(twin[0], 2)
    return points + [twin], facets[:100] + [[len(points)] + facets[100][1:]] + facets[101:]


def opened(points, facets):
    return points, facets[1:]


def reversed_facet(points, facets):
    return points, [facets[0][::-1]] + facets[1:]


def folded(points, facets):
    """A vertex is carried over its neighbours, so that facets lie over one another."""
    number = facets[200][0]
    around = sorted({vertex for facet in facets if number in facet for vertex in facet if vertex != number})
    moved = [1.1 * points[around[0]][k] + 0.4 * (points[around[0]][k] - points[number][k]) for k in range(3)]
    length = math.sqrt(sum(x * x for x in moved))
    return points[:number] + [[x / length for x in moved]] + points[number + 1:], facets


def lens(angle):
    """Two caps of spheres that meet along a circle of radius 1, at this angle."""
    half = angle / 2
    points, facets = sphere()

    def pressed(x, y, z):
        # By latitude: a cap of a sphere of radius 1/sin(half), the equator stays where it is.
        share = 1 - 2 * math.acos(max(-1.0, min(1.0, abs(z)))) / math.pi
        turn = half * (1 - share)
        flat = math.hypot(x, y)
        radius = 1 / math.sin(half)
        height = math.copysign(radius * math.cos(turn) - radius * math.cos(half), z) if z != 0 else 0.0
        along = radius * math.sin(turn)
        return [x / flat * along if flat else 0.0, y / flat * along if flat else 0.0, height]

    return [pressed(*point) for point in points], facets


def main():
    delcert, checker = sys.argv[1:3]
    mesh = sphere()
    with tempfile.TemporaryDirectory() as folder:
        folder = Path(folder)
        certificate = folder / "certificate.json"
        manifold = folder / "part.toml"
        manifold.write_text('name = "part"\nfamily = "submanifold"\ndimension = 2\nmesh = "part.off"\n')

        def certify(text, *options):
            (folder / "part.off").write_text(text)
            certificate.unlink(missing_ok=True)
            return subprocess.run([delcert, "certify", "--manifold", manifold, "--radius", "1/6", "--seed", "1", "--output", certificate,
                                   *options], capture_output=True, text=True)

        done = certify(off(*mesh))
        assert done.returncode == 0, done.stderr
        for part in ("homology Z, 0, Z; closed", "  4   ", "  5   triangulation", "  6   "):
            assert part in done.stdout, (part, done.stdout)
        checked = subprocess.run([checker, certificate], capture_output=True, text=True)
        assert checked.returncode == 0, checked.stdout + checked.stderr
        assert "verified: levels charts 1 2 4 5" in checked.stdout, checked.stdout

        for change, expected in ((cracked, "merge the vertices along it"), (opened, "close the boundary"),
                                 (reversed_facet, "reverse one of them"),
                                 (lambda points, facets: (points, facets + facets[:1]), "is in 3 facets"),
                                 (folded, "facet "),
                                 (lambda *one: together(one, sphere(centre=(1.25, 0, 0))), "facet "),
                                 (lambda *one: together(one, one), "the mesh meets itself there")):
            done = certify(off(*change(*mesh)))
            assert done.returncode == 1, (expected, done.returncode, done.stderr)
            assert expected in done.stderr, (expected, done.stderr)
            assert not certificate.exists()

        # A sharp crease: the facets along it are named, with what to do.
        for angle in 30, 150:
            done = certify(off(*lens(math.radians(angle))))
            assert done.returncode == 1, (done.returncode, done.stderr)
            assert "the sharpest crease near by is between the facets" in done.stderr, done.stderr
            assert "smooth the mesh there" in done.stderr, done.stderr

        # Malformed, and no mesh at all.
        assert certify("OFF\n3 1 0\n0 0 0\n").returncode == 3
        (folder / "part.off").unlink()
        done = subprocess.run([delcert, "certify", "--manifold", manifold, "--radius", "1/6"], capture_output=True, text=True)
        assert done.returncode == 3 and "cannot be read" in done.stderr, done.stderr


if __name__ == "__main__":
    main()
