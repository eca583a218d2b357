#!/usr/bin/env python3
"""wrong_manifolds.py DELCERT [--write]: files that do not describe a manifold, or are malformed. For each, `delcert certify` ends soon with
its exit status – 1 for a false statement, 2 for undecided, 3 for malformed – and a sentence that says where; it writes nothing. The table of
docs/wrong-files.md is made of them (--write), and is compared."""

import math
import re
import subprocess
import sys
import tempfile
from pathlib import Path

import mesh_manifold

SECONDS = 60
PAGE = Path(__file__).resolve().parents[2] / "docs" / "wrong-files.md"
MARKS = ("<!-- wrong files: generated -->\n", "<!-- wrong files: end -->")
SPHERE = {
    "name": '"wrong"',
    "family": '"submanifold"',
    "dimension": "2",
    "variables": '["x", "y", "z"]',
    "equations": '["x^2 + y^2 + z^2 - 1"]',
    "box": "[[-2, 2], [-2, 2], [-2, 2]]",
}
TETRAHEDRON = "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n"


def zero_set(**lines):
    entries = dict(SPHERE, **{key.rstrip("_"): value for key, value in lines.items()})
    return "".join(f"{key} = {value}\n" for key, value in entries.items() if value is not None)


def equation(text, **lines):
    return zero_set(equations=f'["{text}"]', **lines)


# What the file says; exit status; what the message has to match.
ZERO_SETS = {
    # What is written wrongly.
    "syntax": (zero_set(dimension="= 2"), 3, r"wrong\.toml:3"),
    "no equations": (zero_set(equations=None), 3, r"wrong\.toml.*equations"),
    "no family": (zero_set(family=None), 3, r"wrong\.toml.*family"),
    "misspelt family": (zero_set(family='"submanifolds"'), 3, r"wrong\.toml:2.*submanifold"),
    "unknown key": (zero_set(radius="3"), 3, r"wrong\.toml:7.*radius"),
    "dimension 0": (zero_set(dimension="0"), 3, r"wrong\.toml:3.*dimension"),
    "dimension 4": (zero_set(dimension="4"), 3, r"wrong\.toml:3.*dimension"),
    "an equation too many": (zero_set(equations='["x", "y"]'), 3, r"wrong\.toml:5"),
    "a box of two axes": (zero_set(box="[[-2, 2], [-2, 2]]"), 3, r"wrong\.toml:6"),
    "a box without inside": (zero_set(box="[[-2, 2], [2, -2], [-2, 2]]"), 3, r"wrong\.toml:6"),
    "a box of floats": (zero_set(box="[[-2, 2.5], [-2, 2], [-2, 2]]"), 3, r"wrong\.toml:6"),
    "two variables of one name": (zero_set(variables='["x", "y", "x"]'), 3, r"wrong\.toml:4.*x"),
    "a variable that is a function": (zero_set(variables='["x", "y", "sin"]'), 3, r"wrong\.toml:4.*sin"),
    "unknown variable": (equation("x^2 + w^2 - 1"), 3, r"wrong\.toml:5:21: unknown variable w"),
    "decimals": (equation("x^2 + y^2 + z^2 - 0.5"), 3, r"wrong\.toml:5.*decimal"),
    "an equality": (equation("x^2 + y^2 + z^2 = 1"), 3, r"wrong\.toml:5.*a - b"),
    "a division by 0": (equation("x^2/(2 - 2)"), 3, r"wrong\.toml:5.*division by 0"),
    "a bracket open": (equation("(x^2 + y^2 + z^2 - 1"), 3, r"wrong\.toml:5"),
    "homology that is no group": (zero_set(homology='["Z", "0", "Y"]'), 3, r"wrong\.toml:7.*Y"),
    # What is no closed submanifold in the box, or is not seen to be one.
    "a cone": (equation("x^2 + y^2 - z^2"), 2, "undecided"),
    "a pinched sphere": (equation("x^2 + y^2 - z^2*(1 - z^2)"), 2, "undecided at the part of the box from .*e-0"),
    "a pinched torus": (equation("(x^2 + y^2 + z^2)^2 - 4*(x^2 + y^2)"), 2, "undecided at the part of the box from .*e-0"),
    "two spheres that touch": (equation("((x - 1/2)^2 + y^2 + z^2 - 1/4)*((x + 1/2)^2 + y^2 + z^2 - 1/4)"), 2, "undecided"),
    "spheres that cross": (equation("((x - 1/3)^2 + y^2 + z^2 - 1/4)*((x + 1/3)^2 + y^2 + z^2 - 1/4)"), (1, 2), "wrong: .*(undecided|patch)"),
    "unbounded": (equation("x^2 + y^2 - 1"), (1, 2), "box"),
    "cut by the box": (zero_set(box="[[-2, 2], [-2, 2], [0, 2]]"), (1, 2), "box"),
    "outside of the box": (zero_set(box="[[2, 3], [2, 3], [2, 3]]"), 1, "no point of the box"),
    "without zeros": (equation("x^2 + y^2 + z^2 + 1"), 1, "no point of the box"),
    "identically 0": (equation("x - x + 0*y"), (1, 2), "independent|undecided"),
    "a square": (equation("(x^2 + y^2 + z^2 - 1)^2"), (1, 2), "wrong: "),
    "a plane with its square": (zero_set(variables='["x", "y", "z", "w"]', equations='["x", "x^2"]', box="[[-1, 1], [-1, 1], [-1, 1], [-1, 1]]"), (1, 2), "wrong: "),
    "equations that depend on each other": (zero_set(variables='["x", "y", "z", "w"]', equations='["x^2 + y^2 + z^2 + w^2 - 1", "2*(x^2 + y^2 + z^2 + w^2) - 2"]', box="[[-2, 2], [-2, 2], [-2, 2], [-2, 2]]"), (1, 2), "wrong: "),
    "a torus and a sphere of radius 1/500": (
        equation("((x^2 + y^2 + z^2 + 3)^2 - 16*(x^2 + y^2))*(x^2 + y^2 + z^2 - 1/250000)", box='[["-7/2", "7/2"], ["-7/2", "7/2"], ["-3/2", "3/2"]]'),
        (1, 2),
        r"near \(-?0\.00[0-9]+, -?0\.00[0-9]+, -?(0\.00|[0-9.]+e-)",
    ),
    "undefined in the box": (equation("x^2 + y^2 + z^2 - 1 + 1/x"), (1, 2), "wrong: "),
    "a root that ends": (equation("sqrt(x) + y^2 + z^2 - 1"), (1, 2), "wrong: "),
    "of infinite order": (equation("exp(x^2 + y^2 + z^2 - 1) - 1 + 0/(x + 3)", homology='["Z", "Z", "Z"]'), 1, "homology is Z, 0, Z, and not Z, Z, Z"),
}

MESHES = {
    "cut short": (TETRAHEDRON[:-9], 3, r"wrong\.off"),
    "not a number": (TETRAHEDRON.replace("0 0 1", "0 0 nan"), 3, r"wrong\.off:6"),
    "a label too great": (TETRAHEDRON.replace("3 0 2 1", "3 0 2 4"), 3, r"wrong\.off:7"),
    "a square": (TETRAHEDRON.replace("3 0 2 1", "4 0 2 1 3"), 3, r"wrong\.off:7"),
    "a label twice": (TETRAHEDRON.replace("3 0 2 1", "3 0 2 2"), 3, r"wrong\.off:7"),
    "a boundary": (TETRAHEDRON.replace("4 4 0", "4 3 0").replace("3 0 3 2\n", ""), (1, 3), "wrong|facet|triangle|simplex"),
    "nowhere near": (TETRAHEDRON, (1, 2), "not independent at|label|patch|simplex"),
    "no vertices": ("OFF\n0 0 0\n", 3, r"wrong\.off"),
    "another kind of file": ("solid wrong\nendsolid\n", 3, r"wrong\.off:1"),
}


# A mesh as the manifold itself: an octahedron whose faces are divided, on the sphere.
OCTAHEDRON = mesh_manifold.sphere(12)
ROUND = mesh_manifold.sphere()
PART = 'name = "wrong"\nfamily = "submanifold"\ndimension = 2\nmesh = "wrong.off"\n'


def changed(change, mesh=ROUND):
    return mesh_manifold.off(*change(*mesh))


def without_area(points, facets):
    return points, facets + [[facets[0][0], facets[0][1], facets[0][0]]]


def nearly_flat(points, facets):
    """A facet on one line: its last vertex is the middle of its first two."""
    points = [list(x) for x in points]
    a, b, c = facets[300]
    points[a], points[b] = [0.0, 0.0, 1.0], [0.25, 0.0, 1.0]
    points[c] = [0.125, 0.0, 1.0]
    return points, facets


def wound_twice(rings=15, ring=61):
    """A sphere that goes around its poles twice: the links of the poles wind twice."""
    points, facets = [[0.0, 0.0, 1.0], [0.0, 0.0, -1.0]], []

    def label(i, j):
        return 2 + i * ring + j % ring

    for i in range(rings):
        latitude = math.pi * (i + 1) / (rings + 1)
        for j in range(ring):
            turn = 4 * math.pi * (j + i % 2 / 2) / ring
            points.append([math.sin(latitude) * math.cos(turn), math.sin(latitude) * math.sin(turn), math.cos(latitude)])
    for j in range(ring):
        facets += [[0, label(0, j), label(0, j + 1)], [1, label(rings - 1, j + 1), label(rings - 1, j)]]
        for i in range(rings - 1):
            a, b, c, d = label(i, j), label(i, j + 1), label(i + 1, j), label(i + 1, j + 1)
            facets += [[a, c, b], [b, c, d]] if i % 2 else [[a, c, d], [a, d, b]]
    return points, facets


MESH_MANIFOLDS = {
    # What is written wrongly.
    "a mesh and equations": (PART + 'equations = ["x"]\n', mesh_manifold.off(*OCTAHEDRON), 3, r"wrong\.toml:5"),
    "a mesh of dimension 3": (PART.replace("= 2", "= 3"), mesh_manifold.off(*OCTAHEDRON), 3, r"wrong\.toml:3"),
    "no such mesh": (PART.replace("wrong.off", "other.off"), "", 3, "other.off.*cannot be read"),
    "a mesh without facets": (PART, "OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n", (1, 3), "wrong"),
    "an infinite coordinate": (PART, mesh_manifold.off(*OCTAHEDRON).replace("\n1 0 0\n", "\ninf 0 0\n", 1), 3, r"wrong\.off:[0-9]+"),
    # What is no closed surface in space, or too sharp.
    "a crack of one ulp": (PART, changed(mesh_manifold.cracked), 1, "merge the vertices along it"),
    "a hole": (PART, changed(mesh_manifold.opened), 1, "close the boundary"),
    "a facet reversed": (PART, changed(mesh_manifold.reversed_facet), 1, "reverse one of them"),
    "a facet twice": (PART, changed(lambda points, facets: (points, facets + facets[:1])), 1, "is in 3 facets"),
    "a facet that is a segment": (PART, changed(without_area), (1, 3), "wrong|facet"),
    "a facet without an area": (PART, changed(nearly_flat), 1, "facet"),
    "a fold": (PART, changed(mesh_manifold.folded), 1, "facet "),
    "another part too near": (PART, changed(lambda *one: mesh_manifold.together(one, mesh_manifold.sphere(centre=(1.25, 0, 0)))), 1, "facet "),
    "a mesh that is there twice": (PART, changed(lambda *one: mesh_manifold.together(one, one)), 1, "the mesh meets itself there"),
    "poles around which the mesh winds twice": (PART, mesh_manifold.off(*wound_twice()), 1, "facet|label"),
    "a crease of 30 degrees": (PART, changed(lambda *_: mesh_manifold.lens(math.radians(30))), 1, "the sharpest crease near by is between the facets"),
}

# What --sizing says, a file or not; exit status; what the message has to match.
SIZINGS = {
    "a cone without a slope": ("1 0 0 1/16\n", 3, r"wrong\.txt:1"),
    "a cone in the plane": ("1 0 1/16 1/8\n", 3, r"wrong\.txt:1"),
    "a radius of 0": ("1 0 0 0 1/8\n", 3, r"wrong\.txt.*above 0"),
    "a slope below 0": ("1 0 0 1/16 -1/8\n", 3, r"wrong\.txt.*above 0"),
    "a decimal radius": ("1 0 0 0.0625 1/8\n", 3, r"wrong\.txt:1"),
    "no such sizing": (None, 3, r"no-such-file"),
    "curvature without a slope": ("curvature:1/10", 3, "curvature:K,NU"),
    "a share of 0": ("curvature:0,1/10", 3, "not above 0"),
}


EXAMPLES = Path(__file__).resolve().parents[2] / "examples" / "manifolds" / "atlases"
GLUED_SPHERE = (EXAMPLES / "sphere-2-stereographic.toml").read_text()
GLUED_TORUS = (EXAMPLES / "torus-2-by-charts.toml").read_text()
CONE_TORUS = (EXAMPLES / "cone-torus.toml").read_text()


def glued(*changes, text=GLUED_SPHERE):
    for old, new in changes:
        assert old in text, old
        text = text.replace(old, new)
    return text


TWO_ORIGINS = """name = "two-origins"
family = "atlas"
dimension = 2
charts = [
  {name = "one", variables = ["x", "y"], domain = [[-1, 1], [-1, 1]]},
  {name = "other", variables = ["u", "v"], domain = [[-1, 1], [-1, 1]]},
]
transitions = [{from = "one", to = "other", map = ["x", "y"], inverse = ["u", "v"], where = ["x^2 + y^2"]}]
"""



def sheared_on_one_side():
    """The cone torus with one fold that goes to u + c(v + |v|) first: nothing changes where v < 0."""
    fold = re.search(r'from = "q"\nto = "e0"\nmap = \["(u [^"]*)", "([^"u]*)"\]\ninverse = \["([^"]*)", "([^"]*)"\]', CONE_TORUS)
    first, second, u, v = fold.groups()
    shear = "1/1000000*({0} + abs({0}))"
    changed = f'from = "q"\nto = "e0"\nmap = ["{first} + {shear.format("v")}", "{second}"]\ninverse = ["{u} - {shear.format("(" + v + ")")}", "{v}"]'
    return glued((fold[0], changed), text=CONE_TORUS)


ATLASES = {
    # What is written wrongly.
    "no charts": (TWO_ORIGINS[: TWO_ORIGINS.index("charts")], 3, r"wrong\.toml.*charts"),
    "a chart that nobody knows": (glued(('to = "south"', 'to = "west"')), 3, r"wrong\.toml:21.*name of a chart"),
    "two charts of one name": (glued(('name = "south"', 'name = "north"')), 3, r"wrong\.toml:14.*taken"),
    "a chart to itself": (glued(('to = "south"', 'to = "north"')), 3, r"wrong\.toml:21.*another chart"),
    "a core that is larger": (glued(("3/2", "5/2")), 3, r"wrong\.toml:11.*strictly inside"),
    "a variable of another chart": (glued(('"x/(x^2', '"u/(x^2')), 3, r"wrong\.toml:22.*u"),
    "a root": (glued(('"x/(x^2 + y^2)"', '"x/sqrt(x^2 + y^2)"')), 3, "map, formula 1: not a rational function"),
    "a division by 0": (glued(('"x/(x^2 + y^2)"', '"x/(x - x)"')), 3, r"wrong\.toml:22:10: a division by 0"),
    "a decimal": (glued(("-3/2", "-1.5")), 3, r"wrong\.toml:11.*exact"),
    "a fold that is not linear": (TWO_ORIGINS.replace('"x", "y"], inv', '"x + abs(x*y)", "y"], inv'), 3, "map, formula 1: not piecewise linear"),
    "a fold of a condition": (TWO_ORIGINS.replace("x^2 + y^2", "abs(x)"), 3, "unknown function abs"),
    "a condition with poles": (TWO_ORIGINS.replace("x^2 + y^2", "1/x"), 3, "where: not a polynomial"),
    # What is no atlas.
    "an inverse that is wrong in the last digit": (
        glued(('"v/(u^2 + v^2)"', '"v/(u^2 + 1000000000000000000000000000001/1000000000000000000000000000000*v^2)"')),
        1,
        "atlas.inverse: the (inverse of map|map of inverse) is not the identity: coordinate [12]",
    ),
    "a cocycle that fails at one place": (
        glued(('map = ["x", "y + 1"]\ninverse = ["x", "y - 1"]', 'map = ["x", "y + 1 + x/1000000"]\ninverse = ["x", "y - 1 - x/1000000"]'), text=GLUED_TORUS),
        1,
        "atlas.cocycle: .*no transition does the same; chart [a-d]: x in ",
    ),
    "a fold that has another inverse on one side": (
        glued(("8248717/215710560*abs(2340/2359*t)", "8248717/215710560*2340/2359*t"), text=CONE_TORUS),
        1,
        "atlas.inverse: the inverse of map is not the identity: coordinate 1 is not u",
    ),
    "an absolute value of a number, and an inverse without it": (
        glued(('"x/(x^2 + y^2)"', '"abs(-2)*x/(x^2 + y^2)"')),
        1,
        "atlas.inverse: the inverse of map is not the identity: coordinate 1 is not x",
    ),
    "a cocycle that fails on one side of a fold": (sheared_on_one_side(), 1, "atlas.cocycle: .*no transition does the same; chart [a-z0-9]*: "),
    "a gap between charts of cone points": (
        glued(('"2/3"', '"1/5"'), ('"-2/3"', '"-1/5"'), ('"3/5"', '"3/16"'), ('"-3/5"', '"-3/16"'), text=CONE_TORUS),
        1,
        "atlas.compact: no core holds these points; chart ",
    ),
    "two sheets that are glued on one side of a fold": (
        TWO_ORIGINS.replace('"x", "y"], inverse = ["u", "v"], where = ["x^2 + y^2"]', '"x + abs(y)/3", "y"], inverse = ["u - abs(v)/3", "v"], where = ["y"]'),
        2,
        "atlas.hausdorff: transition 1, from one to other: .*; chart one: x in .*; chart other: u in ",
    ),
    "charts that do not cover": (glued(("3/2", "9/10")), 1, "atlas.compact: no core holds these points; chart north: x in "),
    "a plane with two origins": (TWO_ORIGINS, 2, "atlas.hausdorff: transition 1, from one to other: .*; chart one: x in .*; chart other: u in "),
    "a map that is not injective": (
        TWO_ORIGINS.replace('map = ["x", "y"], inverse = ["u", "v"], where = ["x^2 + y^2"]', 'map = ["x", "x*y"], inverse = ["u", "v/u"]'),
        2,
        "atlas.hausdorff",
    ),
    "a sphere that is said to be a torus": (glued(('["Z", "0", "Z"]', '["Z", "Z^2", "Z"]')), 1, "homology is Z, 0, Z, and not Z, Z.2, Z"),
    "a radius too large": (glued(("-2", "-13/8"), ('"2"', '"13/8"'), ("3/2", "5/4")), 1, "label|patch|radius"),
}


def table(rows):
    """A line for each kind; what differs from one folder to another is left out."""
    lines = ["| what | kind | exit | what `certify` says, its first sentence |", "|---|---|--:|---|"]
    for family, name, status, message in rows:
        text = message.split("\n")[0].removeprefix("delcert: error: ")
        text = text if len(text) <= 230 else text[:230].rsplit(" ", 1)[0] + " …"
        lines.append(f"| {family} | {name} | {status} | {text.replace('|', chr(92) + '|').replace('<', '&lt;')} |")
    return "\n".join(lines) + f"\n\n{len(rows)} kinds.\n"


def compare(rows, write):
    text = PAGE.read_text()
    begin, end = text.index(MARKS[0]) + len(MARKS[0]), text.index(MARKS[1])
    renewed = text[:begin] + table(rows) + text[end:]
    if write:
        PAGE.write_text(renewed)
    return [] if write or text == renewed else [f"{PAGE.name} is not what is said now: wrong_manifolds.py DELCERT --write"]


def main():
    delcert = sys.argv[1]
    failures, rows = [], []
    with tempfile.TemporaryDirectory() as folder:
        output = Path(folder) / "never.json"

        def expect(family, name, arguments, statuses, pattern):
            statuses = statuses if isinstance(statuses, tuple) else (statuses,)
            command = [delcert, "certify", *arguments, "--output", str(output)]
            try:
                found = subprocess.run(command, capture_output=True, text=True, timeout=SECONDS)
            except subprocess.TimeoutExpired:
                failures.append(f"{name}: does not end")
                return
            message = found.stderr.strip().replace(folder + "/", "")
            rows.append((family, name, found.returncode, message))
            if found.returncode not in statuses or not re.search(pattern, message, re.S) or found.stdout or output.exists():
                failures.append(f"{family}, {name}: status {found.returncode}, expected {statuses} with /{pattern}/: {message}")
            output.unlink(missing_ok=True)

        manifold = Path(folder) / "wrong.toml"
        for name, (text, statuses, pattern) in ZERO_SETS.items():
            manifold.write_text(text)
            expect("zero set", name, ["--manifold", str(manifold), "--radius", "1/8", "--seed", "1"], statuses, pattern)
        mesh = Path(folder) / "wrong.off"
        for name, (text, off, statuses, pattern) in MESH_MANIFOLDS.items():
            manifold.write_text(text)
            mesh.write_text(off)
            expect("mesh as M", name, ["--manifold", str(manifold), "--radius", "1/6", "--seed", "1"], statuses, pattern)
        manifold.write_text(zero_set())
        for name, (text, statuses, pattern) in MESHES.items():
            mesh.write_text(text)
            expect("mesh to certify", name, ["--manifold", str(manifold), "--complex", str(mesh)], statuses, pattern)
        for name, (text, statuses, pattern) in SIZINGS.items():
            sizing = Path(folder) / ("wrong.txt" if text else "no-such-file.txt")
            if text:
                sizing.write_text(text)
            argument = text if text and text.startswith("curvature") else str(sizing)
            expect("radii", name, ["--manifold", str(manifold), "--radius", "1/8", "--seed", "1", "--sizing", argument], statuses, pattern)
        for name, (text, statuses, pattern) in ATLASES.items():
            manifold.write_text(text)
            radius = "1/2" if name == "a radius too large" else "1/10"
            expect("atlas", name, ["--manifold", str(manifold), "--radius", radius, "--seed", "1"], statuses, pattern)
        # The twin: what is right is certified.
        manifold.write_text(zero_set())
        found = subprocess.run([delcert, "certify", "--manifold", manifold, "--radius", "1/8", "--seed", "1", "--output", output], capture_output=True)
        if found.returncode != 0 or not output.exists():
            failures.append("a sphere is refused")
        # A component that is far smaller than the radius is found, or not said not to be there.
        manifold.write_text(equation("(x^2 + y^2 + z^2 - 1)*((x - 3/2)^2 + y^2 + z^2 - 1/250000)"))
        found = subprocess.run([delcert, "certify", "--manifold", manifold, "--radius", "1/8", "--seed", "1", "--output", output], capture_output=True, text=True, timeout=SECONDS)
        if found.returncode == 0 and "Z^2, 0, Z^2" not in found.stdout:
            failures.append("a small sphere is overlooked")
    failures += compare(rows, "--write" in sys.argv)
    print(f"{len(rows)} kinds")
    for failure in failures:
        print(failure)
    sys.exit(1 if failures else 0)


main()
