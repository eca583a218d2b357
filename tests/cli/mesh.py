#!/usr/bin/env python3
"""mesh.py DELCERT DELCERT_CHECK SURFACE_MESH [--large]: `delcert certify --manifold torus-of-revolution --complex MESH` certifies a mesh of the torus as it
is, and delcert-check verifies that; the same mesh with one thing wrong is refused, and what is wrong is named. So are meshes that other programs make:
SURFACE_MESH, by CGAL, and marching tetrahedra. With --large all of that with some 50 000 triangles, with VTK's marching cubes too,
and with a line for each mesh that says what it took; with --table what these meshes took and what was proved of them, as a table of docs/submanifolds.md
(bench/costs.py measure --only meshes)."""

import itertools
import json
import math
import subprocess
import resource
import sys
import tempfile
import time
from pathlib import Path

ALONG, AROUND = 96, 36
LARGE_ALONG, LARGE_AROUND = 264, 96


def torus(along=ALONG, around=AROUND):
    """Points, in decimals of seven digits, and triangles."""
    points, triangles = [], []
    for i in range(along):
        for j in range(around):
            u = 2 * math.pi * i / along
            v = 2 * math.pi * (j + i % 2 / 2) / around
            points.append([(2 + math.cos(v)) * math.cos(u), (2 + math.cos(v)) * math.sin(u), math.sin(v)])

    def label(i, j):
        return i % along * around + j % around

    for i in range(along):
        for j in range(around):
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


def handle_cut(points, triangles):
    """The tube is cut along two of its circles, the part between is taken out, and both circles are filled with discs: a sphere."""
    cut = [k for k, point in enumerate(points) if point[0] > 1 and abs(point[1]) < 0.3]
    inside = set(cut)
    kept = [triangle for triangle in triangles if not inside & set(triangle)]
    sides = {(a, b) for triangle in kept for a, b in zip(triangle, triangle[1:] + triangle[:1])}
    open_sides = [(a, b) for a, b in sides if (b, a) not in sides]
    points = [list(point) for point in points]
    for sign in (1, -1):
        rim = [side for side in open_sides if points[side[0]][1] * sign > 0]
        points.append([sum(points[a][axis] for a, _ in rim) / len(rim) for axis in range(3)])
        kept += [[b, a, len(points) - 1] for a, b in rim]
    used = sorted({vertex for triangle in kept for vertex in triangle})
    number = {vertex: k for k, vertex in enumerate(used)}
    return [points[vertex] for vertex in used], [[number[vertex] for vertex in triangle] for triangle in kept]


def folded(points, triangles):
    """An edge is flipped whose two triangles make up no convex quadrilateral, so that one triangle shows its other side."""
    around = {}
    for k, triangle in enumerate(triangles):
        for at in range(3):
            around.setdefault(frozenset((triangle[at], triangle[(at + 1) % 3])), []).append((k, triangle[(at + 2) % 3]))

    def side(c, d, a):
        """On which side of the edge from c to d, seen from outside of the torus, a is."""
        u, v = ([points[end][axis] - points[c][axis] for axis in range(3)] for end in (d, a))
        x = points[c]
        flat = math.hypot(x[0], x[1])
        normal = [x[0] * (1 - 2 / flat), x[1] * (1 - 2 / flat), x[2]]
        return sum(normal[k] * (u[(k + 1) % 3] * v[(k + 2) % 3] - u[(k + 2) % 3] * v[(k + 1) % 3]) for k in range(3))

    for edge, ((first, c), (second, d)) in around.items():
        a, b = edge
        if side(c, d, a) * side(c, d, b) > 0 and frozenset((c, d)) not in around:
            others = [triangle for k, triangle in enumerate(triangles) if k not in (first, second)]
            return points, others + [[c, a, d], [c, d, b]]
    raise SystemExit("no edge whose flip would fold the mesh")


def raised(points, triangles):
    """A vertex is off the torus by half of its longest edge."""
    points = [list(point) for point in points]
    number = len(points) // 3
    around = {vertex for triangle in triangles if number in triangle for vertex in triangle}
    x = points[number]
    longest = max(math.dist(x, points[vertex]) for vertex in around)
    flat = math.hypot(x[0], x[1])
    normal = [x[0] * (1 - 2 / flat), x[1] * (1 - 2 / flat), x[2]]
    points[number] = [a + longest / 2 * b for a, b in zip(x, normal)]
    return points, triangles


def marching_cubes(cells):
    """As VTK makes them: vertices are interpolated between corners, and so not on the torus."""
    import vtk
    step = 6.2 / cells
    origin = (-3.1 - 0.01234 * step, -3.1 - 0.0333 * step, -1.2 - 0.0271 * step)
    size = (cells + 1, cells + 1, math.ceil(2.4 / step) + 2)
    values = vtk.vtkDoubleArray()
    for k, j, i in itertools.product(*(range(count) for count in reversed(size))):
        x, y, z = (start + step * at for start, at in zip(origin, (i, j, k)))
        flat = x * x + y * y
        values.InsertNextValue((flat + z * z + 3) ** 2 - 16 * flat)
    image = vtk.vtkImageData()
    image.SetDimensions(*size)
    image.SetSpacing(step, step, step)
    image.SetOrigin(*origin)
    image.GetPointData().SetScalars(values)
    march = vtk.vtkMarchingCubes()
    march.SetInputData(image)
    march.SetValue(0, 0)
    march.ComputeNormalsOff()
    march.ComputeGradientsOff()
    march.Update()
    found = march.GetOutput()
    corners = vtk.vtkIdList()
    triangles = []
    for k in range(found.GetNumberOfCells()):
        found.GetCellPoints(k, corners)
        triangles.append([corners.GetId(at) for at in range(3)])
    return [list(found.GetPoint(k)) for k in range(found.GetNumberOfPoints())], triangles


def read_off(text):
    words = text.split()
    vertices, facets = int(words[1]), int(words[2])
    numbers = [float(x) for x in words[4:4 + 3 * vertices]]
    labels = [int(x) for x in words[4 + 3 * vertices:]]
    return [numbers[3 * k:3 * k + 3] for k in range(vertices)], [labels[4 * k + 1:4 * k + 4] for k in range(facets)]


def large_meshes(surface_mesh):
    """Three of some 50 000 triangles, by their names in the table."""
    made = subprocess.run([surface_mesh, "0.0524"], capture_output=True, text=True, check=True).stdout
    return {"a regular grid, nine decimals": torus(LARGE_ALONG, LARGE_AROUND), "`make_surface_mesh` of CGAL": read_off(made),
            "marching cubes of VTK": marching_cubes(91)}


def seconds_of(run):
    """The result, seconds of the clock and of processors."""
    begin, before = time.monotonic(), resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    result = run()
    return result, time.monotonic() - begin, resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before


def timed(certify, checker, certificate, mesh):
    """The report, the levels that the checker verifies, and seconds: to certify, of processors, to check."""
    done, wall, user = seconds_of(lambda: certify(off(*mesh), "large.off", "--json", "--threads", "2"))
    assert done.returncode == 0, done.stderr
    checked, _, check = seconds_of(lambda: subprocess.run([checker, certificate], capture_output=True, text=True))
    assert checked.returncode == 0, checked.stdout + checked.stderr
    levels = checked.stdout[checked.stdout.index("verified: levels charts ") + 24:].split(" (")[0]
    assert levels == "1f 2 5 5i", levels
    return json.loads(done.stdout), levels, (wall, user, check)


def large(certify, checker, certificate, surface_mesh):
    """Meshes of some 50 000 triangles, what they took, and the same with one thing wrong."""
    print("mesh; triangles; levels; certify: seconds, of one processor; check: seconds of one processor")
    for name, mesh in large_meshes(surface_mesh).items():
        _, levels, (wall, user, check) = timed(certify, checker, certificate, mesh)
        print(f"{name}; {len(mesh[1])}; {levels}; {wall:.1f}, {user:.1f}; {check:.1f}", flush=True)
        for change in (folded, raised, handle_cut):
            if change is folded and "grid" in name:
                continue  # no edge of it is like that
            done = certify(off(*change(*mesh)), "wrong.off")
            print(f"  {change.__name__}: exit {done.returncode}: {done.stderr.strip().splitlines()[0][:200]}", flush=True)
            assert done.returncode in (1, 2), done.stderr
            assert "simplex" in done.stderr or "label" in done.stderr or "star of" in done.stderr, done.stderr
            assert not certificate.exists()


def table(certify, checker, certificate, surface_mesh):
    def up(x, digits):
        return f"{math.ceil(x * 10**digits) / 10**digits:.{digits}f}"

    def down(x, digits):
        return f"{math.floor(x * 10**digits) / 10**digits:.{digits}f}"

    print("| mesh | triangles | levels | displacement ≤ | contraction ≤ | margin of 5i | certify, s | of processors | check, s |")
    print("|---|--:|---|--:|--:|--:|--:|--:|--:|")
    for name, mesh in large_meshes(surface_mesh).items():
        report, levels, took = timed(certify, checker, certificate, mesh)
        five, isotopy = report["levels"]["5"], report["levels"]["5i"]
        room = (f"{down(isotopy['margin']['in_sampling_radii'], 3)} ε" if "margin" in isotopy
                else f"none; cosine {down(isotopy['cosine']['value'], 3)}")
        row = [name, f"{len(mesh[1]):,}".replace(",", " "), levels, f"{up(five['displacement']['in_sampling_radii'], 3)} ε",
               up(five["contraction"]["value"], 4), room, *(f"{x:.1f}" for x in took)]
        print("| " + " | ".join(row) + " |", flush=True)


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

        for option, measured in (("--large", large), ("--table", table)):
            if option in sys.argv:
                measured(certify, checker, certificate, surface_mesh)
                return

        for name, write in (("mesh.off", off), ("mesh.obj", obj)):
            done = certify(write(*mesh), name)
            assert done.returncode == 0, done.stderr
            for part in ("  1f  full stars", "homology Z, Z^2, Z; closed", "  5   triangulation", "  5i  isotopy"):
                assert part in done.stdout, (part, done.stdout)
            checked = subprocess.run([checker, certificate], capture_output=True, text=True)
            assert checked.returncode == 0, checked.stdout + checked.stderr
            assert "verified: levels charts 1f 2 5 5i" in checked.stdout, checked.stdout

        # Meshes of other programs. Slivers have no margin of 5i, but normals near to those of the torus.
        made = subprocess.run([surface_mesh, "0.12"], capture_output=True, text=True, check=True).stdout
        slivers = marching(40)
        for text, bound in ((made, "margin ≥"), (off(*slivers), "cosine of the angle")):
            done = certify(text, "other.off")
            assert done.returncode == 0, done.stderr
            checked = subprocess.run([checker, certificate], capture_output=True, text=True)
            assert f"  5i  isotopy: the complex is embedded, {bound}" in done.stdout, done.stdout
            assert "verified: levels charts 1f 2 5 5i (" in checked.stdout, checked.stdout + checked.stderr
        # Level 5i is not looked at where it is not asked for.
        done = certify(off(*slivers), "other.off", "--levels", "1f,2,5")
        assert done.returncode == 0 and "  5   triangulation" in done.stdout, done.stderr
        for part in ("  5i", "isotopy", "pairs of simplices"):
            assert part not in done.stdout, done.stdout
        # One edge flipped so that two triangles overlap.
        done = certify(off(*folded(*slivers)), "folded.off")
        assert done.returncode == 1 and "star of" in done.stderr, done.stderr

        for change, expected in ((pushed, "star of 777"), (lifted, "900"), (raised, "1152"), (handle_cut, "label"),
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
