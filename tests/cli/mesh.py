#!/usr/bin/env python3
"""mesh.py DELCERT DELCERT_CHECK SURFACE_MESH: `delcert certify --manifold torus-of-revolution --complex MESH` certifies a mesh of the torus as it
is, and delcert-check verifies that; the same mesh with one thing wrong is refused, and what is wrong is named. So are meshes that other programs make:
SURFACE_MESH, by CGAL, and marching tetrahedra."""

import itertools
import math
import subprocess
import sys
import tempfile
from pathlib import Path

ALONG, AROUND = 96, 36


def torus():
    """Points, in decimals of seven digits, and triangles."""
    points, triangles = [], []
    for i in range(ALONG):
        for j in range(AROUND):
            u = 2 * math.pi * i / ALONG
            v = 2 * math.pi * (j + i % 2 / 2) / AROUND
            points.append([(2 + math.cos(v)) * math.cos(u), (2 + math.cos(v)) * math.sin(u), math.sin(v)])

    def label(i, j):
        return i % ALONG * AROUND + j % AROUND

    for i in range(ALONG):
        for j in range(AROUND):
            a, b, c, d = label(i, j), label(i + 1, j), label(i, j + 1), label(i + 1, j + 1)
            triangles += [[a, b, c], [b, d, c]] if i % 2 == 0 else [[a, b, d], [a, d, c]]
    return points, triangles


def off(points, triangles):
    lines = [f"OFF\n{len(points)} {len(triangles)} 0"]
    lines += ["%.9f %.9f %.9f" % tuple(point) for point in points]
    lines += ["3 %d %d %d" % tuple(triangle) for triangle in triangles]
    return "\n".join(lines) + "\n"


def obj(points, triangles):
    lines = ["v %.7f %.7f %.7f" % tuple(point) for point in points]
    lines += ["f %d %d %d" % tuple(vertex + 1 for vertex in triangle) for triangle in triangles]
    return "\n".join(lines) + "\n"


def flipped(points, triangles):
    """The edge of the first two triangles is the other diagonal: a triangulation as good as the other."""
    edge = sorted(set(triangles[0]) & set(triangles[1]))
    ends = sorted(set(triangles[0]) ^ set(triangles[1]))
    return points, [ends + edge[:1], ends + edge[1:]] + triangles[2:]


def pushed(points, triangles):
    """A vertex goes over a neighbour."""
    points = [list(point) for point in points]
    points[777] = [x + 1.5 * (y - x) for x, y in zip(points[777], points[778])]
    return points, triangles


def lifted(points, triangles):
    """A vertex is off the torus by a fifth of an edge."""
    points = [list(point) for point in points]
    points[900] = [1.02 * x for x in points[900]]
    return points, triangles


def doubled(points, triangles):
    """The same mesh twice: every place has two vertices."""
    return points + points, triangles + [[vertex + len(points) for vertex in triangle] for triangle in triangles]


def marching(cells):
    """Marching tetrahedra, six to a cube, with vertices on the torus: slivers and all."""
    step = 6.2 / cells
    origin = (-3.1 - 0.01234 * step, -3.1 - 0.0333 * step, -1.2 - 0.0271 * step)
    points, triangles, labels, values = [], [], {}, {}

    def place(corner):
        return [start + step * k for start, k in zip(origin, corner)]

    def function(x):
        flat = x[0] * x[0] + x[1] * x[1]
        return (flat + x[2] * x[2] + 3) ** 2 - 16 * flat

    def value(corner):
        if corner not in values:
            values[corner] = function(place(corner))
        return values[corner]

    def vertex(inside, outside):
        if (inside, outside) not in labels:
            low, high = place(inside), place(outside)
            for _ in range(60):
                middle = [(a + b) / 2 for a, b in zip(low, high)]
                if function(middle) < 0:
                    low = middle
                else:
                    high = middle
            labels[inside, outside] = len(points)
            points.append(low)
        return labels[inside, outside]

    for cube in itertools.product(range(cells), range(cells), range(math.ceil(2.4 / step) + 1)):
        corners = [tuple(k + by for k, by in zip(cube, offset)) for offset in itertools.product((0, 1), repeat=3)]
        if len({value(corner) < 0 for corner in corners}) == 1:
            continue
        for order in itertools.permutations(range(3)):
            path = [cube]
            for axis in order:
                path.append(tuple(k + (at == axis) for at, k in enumerate(path[-1])))
            inside = [corner for corner in path if value(corner) < 0]
            outside = [corner for corner in path if value(corner) >= 0]
            if len(inside) == 2 and len(outside) == 2:
                a, b, c, d = (vertex(inside[i], outside[j]) for i, j in ((0, 0), (0, 1), (1, 1), (1, 0)))
                triangles += [[a, b, c], [a, c, d]]
            elif inside and outside:
                triangles.append([vertex(i, o) for i in inside for o in outside])
    return points, triangles


def main():
    delcert, checker, surface_mesh = sys.argv[1:4]
    mesh = torus()
    with tempfile.TemporaryDirectory() as folder:
        certificate = Path(folder) / "mesh.json"

        def certify(text, name, *options):
            path = Path(folder) / name
            path.write_text(text)
            certificate.unlink(missing_ok=True)
            return subprocess.run([delcert, "certify", "--manifold", "torus-of-revolution", "--complex", path, "--output", certificate,
                                   *options], capture_output=True, text=True)

        for name, write in (("mesh.off", off), ("mesh.obj", obj)):
            done = certify(write(*mesh), name)
            assert done.returncode == 0, done.stderr
            for part in ("  1f  full stars", "homology Z, Z^2, Z; closed", "  5   triangulation", "  5i  isotopy"):
                assert part in done.stdout, (part, done.stdout)
            checked = subprocess.run([checker, certificate], capture_output=True, text=True)
            assert checked.returncode == 0, checked.stdout + checked.stderr
            assert "verified: levels charts 1f 2 5 5i" in checked.stdout, checked.stdout

        # Meshes of other programs. Slivers are too thin for 5i.
        made = subprocess.run([surface_mesh, "0.12"], capture_output=True, text=True, check=True).stdout
        for text, levels in ((made, "1f 2 5 5i"), (off(*marching(40)), "1f 2 5")):
            done = certify(text, "other.off")
            assert done.returncode == 0, done.stderr
            checked = subprocess.run([checker, certificate], capture_output=True, text=True)
            assert f"verified: levels charts {levels} (" in checked.stdout, checked.stdout + checked.stderr

        for change, expected in ((pushed, "label 777"), (lifted, "900"),
                                 (doubled, "level 5: in 2 components no label is certainly alone"),
                                 (lambda points, triangles: (points, triangles[1:]), "a face in other than two simplices"),
                                 (lambda points, triangles: (points, triangles + triangles[:1]), "occurs twice")):
            done = certify(off(*change(*mesh)), "wrong.off")
            assert done.returncode == 1, (expected, done.returncode, done.stderr)
            assert expected in done.stderr, (expected, done.stderr)
            assert not certificate.exists()

        done = certify(off(*flipped(*mesh)), "flipped.off", "--radius", "1/10")
        assert done.returncode == 0 and "  5i  isotopy" in done.stdout, done.stderr

        # Malformed, not about a surface in space, and a level that asks for less.
        assert certify("OFF\n3 1 0\n0 0 0\n", "short.off").returncode == 3
        wrong = subprocess.run([delcert, "certify", "--manifold", "torus-2", "--complex", Path(folder) / "mesh.off"],
                               capture_output=True, text=True)
        assert wrong.returncode == 3 and "is for submanifolds" in wrong.stderr, wrong.stderr
        done = certify(off(*doubled(*mesh)), "twice.off", "--levels", "1f,2")
        assert done.returncode == 0 and "  5 " not in done.stdout, done.stderr


if __name__ == "__main__":
    main()
