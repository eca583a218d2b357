"""forgeries.py PROGRAM [LIST …]: delcert-verified refuses each of these changes of a triangulation, for the reason that
the change violates, and accepts changes that violate nothing. Each LIST is a triangulation that it must accept.
forgeries.py --table: the table of docs/verified.md."""

import pathlib
import subprocess
import sys
import tempfile

import lattice_lists
from lattice_lists import LatticeList, kuhn

LABELS = "its labels do not increase|no points? |a label that is not in the list"
FACET = "there is no simplex whose vertex there is outside the circumball"
INSIDE = "a point that is not one of its vertices is in it"
FLAT = "its vertices are affinely dependent"
GRAM = "the Gram matrix is not symmetric and positive definite"

FORGERIES = []


def forgery(violates, reason, status=1):
    def add(function):
        FORGERIES.append((function, violates, reason, status))
        return function

    return add


def surface():
    return kuhn((5, 5), noise=0.08, seed=3)


def solid():
    return kuhn((4, 4, 4), noise=0.03, seed=4)


def edge(l, labels):
    """The places of the simplices with these labels."""
    return [k for k, s in enumerate(l.simplices) if set(labels) <= {label for label, _ in s}]


def moved(simplex, shift):
    return [(label, [a + b for a, b in zip(z, shift)]) for label, z in simplex]


def difference(a, b):
    return [x - y for x, y in zip(a, b)]


def flipped(l):
    """Two simplices with a common facet become m simplices with a common edge: the other diagonal."""
    s = l.simplices[0]
    facet, apex = s[1:], s[0]
    other = next(k for k in edge(l, [label for label, _ in facet]) if k != 0)
    t = l.simplices[other]
    shift = difference(facet[0][1], next(z for label, z in t if label == facet[0][0]))
    t = moved(t, shift)
    beyond = next(v for v in t if v not in facet)
    l.simplices = [x for k, x in enumerate(l.simplices) if k not in (0, other)]
    for k in range(len(facet)):
        l.simplices.append([apex, beyond] + facet[:k] + facet[k + 1:])
    return l.ordered()


def cover_of_degree_two(l):
    """The same points and simplices, in the lattice that has half the period along the first axis."""
    for p in l.points:
        p[0] *= 2
    for s in l.simplices:
        for _, z in s:
            z[0] *= 2
    m = l.dimension
    l.gram = [[l.gram[a][b] * (1 if a == 0 else 2) * (1 if b == 0 else 2) for b in range(m)] for a in range(m)]
    return l


def second_copy(l, offset):
    """All points and simplices once more, moved by `offset`."""
    n = len(l.points)
    l.points += [[x + o for x, o in zip(p, offset)] for p in l.points]
    l.simplices += [[(label + n, z) for label, z in s] for s in l.simplices]
    return l.ordered()


def two_sheets_with_a_slit(l, offset=0):
    """A covering of degree two branched over the end points of an edge, across which one changes the sheet."""
    a, b = sorted(label for label, _ in l.simplices[0])[:2]
    first, second = edge(l, [a, b])[:2]
    n = len(l.points)
    sheet = lambda s: [(label if label in (a, b) else label + n, z) for label, z in s]
    l.points += [[x + offset for x in p] for p in l.points]
    l.simplices += [sheet(s) for s in l.simplices]
    # The labels n + a and n + b are of no simplex.
    l.points[n + a], l.points[n + b] = list(l.points[a]), list(l.points[b])
    return l.ordered()


@forgery("a simplex is missing", FACET)
def one_simplex_missing():
    l = solid()
    del l.simplices[100]
    return l


@forgery("the star of a point is missing", FACET)
def star_missing():
    l = surface()
    l.simplices = [s for s in l.simplices if all(label != 7 for label, _ in s)]
    return l


@forgery("a hole filled with simplices that leave out a point, which is then in one of them", f"{INSIDE}|{FACET}")
def point_left_out():
    l = surface()
    star = edge(l, [12])
    link = []
    for k in star:
        s = l.simplices[k]
        shift = next(z for label, z in s if label == 12)
        link.append([v for v in moved(s, [-x for x in shift]) if v[0] != 12])
    start = link[0][0]
    rest = [s for k, s in enumerate(l.simplices) if k not in star]
    rest += [[start] + pair for pair in link if start not in pair]
    l.simplices = rest
    return l.ordered()


@forgery("half of the simplices, each with its neighbour in the other half", FACET)
def every_second_simplex():
    l = surface()
    l.simplices = l.simplices[::2]
    return l


@forgery("a simplex listed twice", f"{LABELS}|{FACET}")
def simplex_twice():
    l = surface()
    l.simplices.insert(9, [(label, list(z)) for label, z in l.simplices[8]])
    return l


@forgery("two simplices exchanged in the list", LABELS)
def order_of_simplices():
    l = surface()
    l.simplices[3], l.simplices[4] = l.simplices[4], l.simplices[3]
    return l


@forgery("the labels of a simplex in another order", LABELS)
def order_of_labels():
    l = surface()
    l.simplices[3] = l.simplices[3][::-1]
    return l


@forgery("an edge flipped: the other diagonal is not Delaunay", FACET)
def edge_flipped():
    return flipped(surface())


@forgery("two tetrahedra replaced by three, which overlap others or are not Delaunay", f"{FACET}|{INSIDE}")
def two_to_three():
    return flipped(solid())


@forgery("a point so far from its place that simplices are turned over", f"{FACET}|{INSIDE}|{FLAT}")
def point_far_away():
    l = surface()
    l.points[6][0] += l.period * 3 // 5
    return l


@forgery("a point moved within its star, so that a circumball of a simplex is not empty", FACET)
def point_moved():
    l = surface()
    # Towards the middle of an edge of its link, not as far as that.
    l.points[6][0] -= l.period * 42 // 500
    l.points[6][1] += l.period * 42 // 500
    return l


@forgery("a point of a solid moved within its star", f"{FACET}|{INSIDE}")
def point_of_solid_moved():
    l = solid()
    l.points[21][0] -= l.period // 10
    l.points[21][1] += l.period // 10
    return l


@forgery("a point moved by a lattice vector, and its simplices not", f"{FACET}|{INSIDE}")
def lattice_vector_of_point():
    l = surface()
    l.points[6][0] += l.period
    return l


@forgery("a lattice vector changed in one simplex", f"{FACET}|{INSIDE}")
def lattice_vector_of_vertex():
    l = surface()
    l.simplices[11][1][1][0] += 1
    return l


@forgery("the positions of two points exchanged", f"{FACET}|{INSIDE}")
def points_exchanged():
    l = surface()
    l.points[6], l.points[18] = l.points[18], l.points[6]
    return l


@forgery("one more point, in no simplex of the list", INSIDE)
def point_more():
    l = surface()
    l.points.append([sum(l.place(v)[k] for v in l.simplices[20]) // 3 for k in range(2)])
    return l


@forgery("one more point at the place of another", INSIDE)
def point_twice():
    l = solid()
    l.points.append([x - l.period for x in l.points[5]])
    return l


@forgery("one more point on an edge", INSIDE)
def point_on_edge():
    l = surface()
    # The sum is even: coordinates are multiplied by 2 first.
    l.period *= 2
    l.points = [[2 * x for x in p] for p in l.points]
    a, b = (l.place(v) for v in l.simplices[20][:2])
    l.points.append([(x + y) // 2 for x, y in zip(a, b)])
    return l


@forgery("two copies of the triangulation, one at the place of the other", INSIDE)
def two_copies():
    return second_copy(surface(), (0, 0))


@forgery("two copies of the triangulation, one moved against the other: each is locally Delaunay and has no boundary", INSIDE)
def two_copies_moved():
    l = surface()
    return second_copy(l, (l.period // 11, l.period // 13))


@forgery("two copies in dimension 3", INSIDE)
def two_solids():
    l = solid()
    return second_copy(l, (l.period // 11, l.period // 13, l.period // 17))


@forgery("the triangulation of a torus of twice the area: connected, closed, locally Delaunay, and it covers twice", INSIDE)
def twice_the_area():
    return cover_of_degree_two(kuhn((8, 4), noise=0.08, seed=5))


@forgery("the triangulation of a torus of twice the volume", INSIDE)
def twice_the_volume():
    return cover_of_degree_two(kuhn((6, 3, 3), noise=0.03, seed=6))


@forgery("twice the area, points of both sheets at the same places", INSIDE)
def twice_the_area_without_noise():
    return cover_of_degree_two(kuhn((8, 4)))


@forgery("two sheets that have two points and an edge in common, one sheet moved a little", f"{INSIDE}|{FACET}")
def two_sheets():
    return two_sheets_with_a_slit(surface(), offset=3)


@forgery("a simplex with a vertex twice", f"{LABELS}|{FLAT}")
def degenerate_simplex():
    l = surface()
    s = l.simplices[10]
    s[2] = (s[1][0], list(s[1][1]))
    return l


@forgery("a simplex with two lifts of one point", LABELS)
def one_point_for_all():
    return kuhn((1, 1))


@forgery("a grid of squares, cut along diagonals: four points on a circle", FACET)
def squares():
    l = kuhn((4, 4))
    l.gram = [[1, 0], [0, 1]]
    return l


@forgery("a label that no point has", f"{LABELS}|{FACET}")
def unknown_label():
    l = surface()
    l.simplices[-1][-1] = (99, l.simplices[-1][-1][1])
    return l


@forgery("no simplices", "there are no simplices")
def no_simplices():
    l = surface()
    l.simplices = []
    return l


@forgery("no points", LABELS)
def no_points():
    l = surface()
    l.points = []
    return l


@forgery("another metric, in which the triangulation is not Delaunay", FACET)
def another_metric():
    l = surface()
    l.gram = [[2, 1], [1, 2]]
    return l


@forgery("a matrix that is not positive definite", GRAM)
def indefinite():
    l = surface()
    l.gram = [[1, 2], [2, 1]]
    return l


@forgery("a matrix that is only semidefinite", GRAM)
def semidefinite():
    l = surface()
    l.gram = [[1, -1], [-1, 1]]
    return l


@forgery("a matrix that is not symmetric", GRAM)
def asymmetric():
    l = surface()
    l.gram[0][1] -= 1
    return l


@forgery("the period 0", "the period is not positive")
def no_period():
    l = surface()
    l.period = 0
    return l


@forgery("the period negative", "the period is not positive")
def negative_period():
    l = surface()
    l.period = -l.period
    return l


@forgery("the period doubled, which leaves gaps", f"{FACET}|{INSIDE}")
def double_period():
    l = surface()
    l.period *= 2
    return l


def edited(change):
    return lambda: change(surface().text())


UNREADABLE = [
    ("the file cut off", edited(lambda text: text[:-20]), "the file ends here"),
    ("more simplices than announced", edited(lambda text: text + text.splitlines()[-1] + "\n"), "more than the simplices"),
    ("a fraction", edited(lambda text: text.replace("\n0 ", "\n1/2 ", 1)), "not an integer"),
    ("a hexadecimal number", edited(lambda text: text.replace("period ", "period 0x", 1)), "not an integer"),
    ("a negative label", edited(lambda text: text.rsplit("\n", 2)[0] + "\n-1 0 0  1 0 0  2 0 0\n"), "a label is not between"),
    ("dimension 0", edited(lambda text: text.replace("dimension 2", "dimension 0")), "the dimension is not between"),
    ("another format", edited(lambda text: text.replace("delcert-lattice 1", "delcert-lattice 2")), "was expected"),
    ("an empty file", lambda: "", "the file ends here"),
]


def accepted_lists():
    yield "dimension 1", kuhn((5,))
    yield "the smallest torus of dimension 2", kuhn((3, 3))
    yield "dimension 2", surface()
    yield "dimension 3", solid()
    yield "dimension 4", kuhn((3, 3, 3, 3))
    flip = surface()
    # A point and its vertices moved by opposite lattice vectors are where they were.
    flip.points[6][0] += flip.period
    for s in flip.simplices:
        for label, z in s:
            if label == 6:
                z[0] -= 1
    yield "a lift of a point in place of another", flip
    scaled = surface()
    scaled.period *= 7
    scaled.points = [[7 * x for x in p] for p in scaled.points]
    scaled.gram = [[3 * x for x in row] for row in scaled.gram]
    yield "other units", scaled
    yield "twice the area, in its own lattice", kuhn((8, 4), noise=0.08, seed=5)
    yield "twice the volume, in its own lattice", kuhn((6, 3, 3), noise=0.03, seed=6)


def run(program, folder, text):
    path = folder / "list.txt"
    path.write_text(text)
    return subprocess.run([program, path], capture_output=True, text=True)


def matches(reasons, output):
    return any(reason in output for reason in reasons.split("|"))


def main(program, lists):
    failures = 0

    def fail(name, what, result):
        nonlocal failures
        failures += 1
        print(f"FAILED: {name}: {what}: status {result.returncode}, {result.stdout.strip()[:300]} {result.stderr.strip()[:300]}")

    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for title, l in accepted_lists():
            result = run(program, folder, l.text())
            if result.returncode != 0 or not result.stdout.startswith("accepted"):
                fail(title, "not accepted", result)
        for path in lists:
            result = subprocess.run([program, path], capture_output=True, text=True)
            if result.returncode != 0 or not result.stdout.startswith("accepted"):
                fail(path, "not accepted", result)
            else:
                print(f"{path}: {result.stdout.strip()}")
        for function, violates, reason, status in FORGERIES:
            result = run(program, folder, function().text())
            if result.returncode != status or not matches(reason, result.stdout) or "accepted:" in result.stdout.replace("not accepted:", ""):
                fail(function.__name__, violates, result)
        for title, make, reason in UNREADABLE:
            result = run(program, folder, make())
            if result.returncode != 3 or reason not in result.stderr:
                fail(title, reason, result)
        # The changes apply to what a run of delcert gave, too.
        for path in lists:
            l = lattice_lists.read(pathlib.Path(path).read_text())
            if l.dimension != 2:
                continue
            if run(program, folder, l.text()).returncode != 0:
                fail(path, "written again", run(program, folder, l.text()))
            missing = l.copy()
            del missing.simplices[len(l.simplices) // 2]
            for title, changed in [("a simplex missing", missing), ("flipped", flipped(l.copy())), ("two copies", second_copy(l.copy(), (l.period // 1001, 0)))]:
                result = run(program, folder, changed.text())
                if result.returncode != 1:
                    fail(f"{path}, {title}", "accepted", result)
    print(f"{len(FORGERIES)} forgeries, {len(UNREADABLE)} unreadable files, {failures} failures")
    return failures > 0


def table():
    print("| | what is violated |\n|---|---|")
    for function, violates, _, _ in FORGERIES:
        print(f"| {function.__name__.replace('_', ' ')} | {violates} |")


if __name__ == "__main__":
    if sys.argv[1] == "--table":
        table()
    else:
        sys.exit(main(sys.argv[1], sys.argv[2:]))
