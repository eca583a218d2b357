#!/usr/bin/env python3
"""mesh.py DELCERT DELCERT_CHECK: `delcert certify --manifold torus-of-revolution --complex MESH` certifies a mesh of the torus as it
is, and delcert-check verifies that; the same mesh with one thing wrong is refused, and what is wrong is named."""

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
    lines += ["%.7f %.7f %.7f" % tuple(point) for point in points]
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


def main():
    delcert, checker = sys.argv[1:3]
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

        for change, expected in ((pushed, "label 777"), (lifted, "900"),
                                 (doubled, "level 5: in 2 components no label is certainly alone"),
                                 (lambda points, triangles: (points, triangles[1:]), "a face in other than two simplices"),
                                 (lambda points, triangles: (points, triangles + triangles[:1]), "is there twice")):
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
