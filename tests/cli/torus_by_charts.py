#!/usr/bin/env python3
"""The square torus in four rectangles, compared with the built-in one.

Certifies `torus-2-by-charts`, takes its perturbed points, exactly, to R^2/Z^2, and certifies `torus-2` with these points as
they are: both are the Delaunay complex of the same points, so the simplices have to be the same, label for label, and so has
the homology. With `--twin` one point is somewhere else, and nothing but that must be noticed."""

import json
import pathlib
import subprocess
import sys
import tempfile
from fractions import Fraction


def exact(text):
    sign, text = (-1, text[1:]) if text.startswith("-") else (1, text)
    if not text.startswith("0x"):
        return sign * Fraction(text)
    mantissa, _, exponent = text[2:].partition("p")
    return sign * int(mantissa, 16) * Fraction(2) ** int(exponent or 0)


def certified(delcert, file, *arguments):
    subprocess.run([delcert, "certify", *arguments, "--output", file], check=True, stdout=subprocess.DEVNULL)
    return json.loads(file.read_text(encoding="utf-8"))


def point_of(net, chart, home):
    a, b, d = (exact(entry) for entry in chart[1:])
    y = exact(home[1]) / d
    x = (exact(home[0]) - b * y) / a
    return (exact(net[0]) + x) % 1, (exact(net[1]) + y) % 1


def compare(delcert, folder, twin):
    """Whether the triangles are the same; the files are in `folder`, of this run alone."""
    glued = certified(delcert, folder / "glued.json", "--manifold", "torus-2-by-charts", "--radius", "1/30", "--seed", "3")
    points = [point_of(*row) for row in zip(glued["net"], glued["charts"], glued["points"])]
    if twin:
        points[5], points[300] = points[300], points[5]
    points_file = folder / "points.txt"
    points_file.write_text("".join(f"{x} {y}\n" for x, y in points), encoding="utf-8")
    flat = certified(delcert, folder / "flat.json", "--manifold", "torus-2", "--points", points_file, "--no-perturbation")
    labels = [[sorted(simplex[:3]) for simplex in document["simplices"]] for document in (glued, flat)]
    assert len(labels[0]) == 2 * len(points), "a torus has twice as many triangles as vertices"
    assert glued["levels"]["2"]["homology"] == flat["levels"]["2"]["homology"] == ["Z", "Z^2", "Z"]
    assert {"1", "2", "2s", "5"} <= glued["levels"].keys() and "5" in flat["levels"]
    same = sorted(labels[0]) == sorted(labels[1])
    print(f"{len(points)} points, {len(labels[0])} triangles, the same: {same}")
    return same


def main():
    with tempfile.TemporaryDirectory() as folder:
        sys.exit(0 if compare(sys.argv[1], pathlib.Path(folder), "--twin" in sys.argv) else 1)


if __name__ == "__main__":
    main()
