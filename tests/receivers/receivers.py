#!/usr/bin/env python3
"""Certificates, exported by delcert and read back by the programs that the exports are for.

  receivers.py check NAME…     certifies the manifolds, exports them in every format that can hold them, and compares what
                               GUDHI, meshio, VTK and Regina read with the certificate: sets of simplices, counts, measures,
                               Euler characteristic, homology. The same comparison has to fail with two labels exchanged
                               between two simplices of the file. Fails, too, unless docs/export.md has the row that comes out.
  receivers.py table [--long]  writes the table of docs/export.md; with --long also the rows of long_manifolds.tsv, which
                               take minutes each, and without it leaves them as they are
  receivers.py rows NAME…      writes these rows of the table, and leaves all others as they are
  receivers.py missing         adds the rows that the table lacks, and leaves all others as they are
  receivers.py complete        fails unless every built-in manifold is in one of the lists and has its row; exempt are
                               those below EXEMPT

A manifold that fails does not keep the others from being looked at. manifolds.tsv has a name and the options of
`delcert certify` on every line, and above each kind of manifold a line with # and the kind."""

import argparse
import csv
import functools
import itertools
import json
import math
import re
import subprocess
import sys
import tempfile
import traceback
from pathlib import Path

import gudhi
import meshio
import numpy
import regina
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOGeometry import vtkOBJReader
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

FOLDER = Path(__file__).parent
ROOT = FOLDER.parents[1]
PAGE = ROOT / "docs" / "export.md"
BEGIN = "<!-- receivers: begin -->\n"
END = "<!-- receivers: end -->\n"
MOST_FOR_HOMOLOGY = 2000
# Hypotheses 1 ask for ε <= 1/24 there, which in dimension 4 is more than certify has been tried on.
EXEMPT = {"torus-4"}
CELLS = {1: "line", 2: "triangle", 3: "tetra"}


class Mismatch(Exception):
    pass


def expect(found, wanted, what):
    if found != wanted:
        if isinstance(found, set):
            found, wanted = sorted(found - wanted)[:3], sorted(wanted - found)[:3]
        raise Mismatch(f"{what}: {str(found)[:200]} and not {str(wanted)[:200]}")


def expect_close(found, wanted, what):
    found, wanted = numpy.asarray(found, float), numpy.asarray(wanted, float)
    expect(found.shape, wanted.shape, what + ", how many")
    if not numpy.allclose(found, wanted, rtol=1e-8, atol=1e-12, equal_nan=True):
        raise Mismatch(f"{what}: other numbers")


# A finitely generated abelian group: its rank and the orders of its cyclic summands.


def group(text):
    rank, torsion = 0, []
    for summand in [] if text == "0" else text.split(" + "):
        match = re.fullmatch(r"\(?Z(?:/([0-9]+))?\)?(?:\^([0-9]+))?", summand)
        times = int(match[2] or 1)
        if match[1]:
            torsion += [int(match[1])] * times
        else:
            rank += times
    return rank, sorted(torsion)


def group_of_regina(found):
    return found.rank(), sorted(int(str(found.invariantFactor(k))) for k in range(found.countInvariantFactors()))


def betti_numbers(groups, prime):
    """Of homology with coefficients in a prime field, by the universal coefficient theorem."""
    divisible = [sum(order % prime == 0 for order in torsion) for _, torsion in groups]
    return [rank + divisible[k] + (divisible[k - 1] if k > 0 else 0) for k, (rank, _) in enumerate(groups)]


class Certified:
    """A certificate, as far as it is compared, and the exports of it."""

    def __init__(self, delcert, certificate, folder):
        self.delcert, self.certificate, self.folder = delcert, certificate, folder
        content = json.loads(certificate.read_text())
        self.dimension = content["manifold"]["dimension"]
        self.labels = len(content["points"])
        self.rows = [tuple(row[: self.dimension + 1]) for row in content["simplices"]]
        self.simplices = set(self.rows)
        self.level_2 = content["levels"]["2"]
        self.groups = [group(text) for text in self.level_2["homology"]] if "homology" in self.level_2 else None
        self.seal = content["sha256"]
        facets = {}
        for at, row in enumerate(self.rows):
            for k in range(len(row)):
                facets.setdefault(row[:k] + row[k + 1 :], []).append((at, k))
        self.facets = facets
        self.is_closed = all(len(sides) == 2 for sides in facets.values())
        expect(self.level_2["simplices"], len(self.simplices), "simplices of level 2")
        expect(self.is_closed, self.level_2["closed"], "closed")

    def export(self, form, *options):
        path = self.folder / f"export{'-'.join(options)}.{form}"
        if not path.exists():
            run = subprocess.run(
                [self.delcert, "export", self.certificate, "--format", form, *options, "--output", path],
                capture_output=True,
                text=True,
            )
            if run.returncode != 0:
                raise Mismatch(f"export {form} ended with {run.returncode}: {run.stderr.strip()}")
        return path

    @functools.cached_property
    def drawing(self):
        return json.loads(self.export("json").read_text())


# What is compared, for each format and receiver. `path` is the export, or one with exchanged labels.


def compare_drawing(certified, path):
    drawing = json.loads(path.read_text())
    expect(drawing["certificate"]["sha256"], certified.seal, "sha256")
    rows = numpy.array(drawing["simplices"]).reshape(-1, certified.dimension + 1)
    compare_cells(certified, rows, numpy.array(drawing["vertices"]["label"]))


def compare_cells(certified, cells, labels):
    found = [tuple(sorted(int(labels[vertex]) for vertex in cell)) for cell in cells]
    expect(len(found), len(certified.rows), "simplices")
    expect(set(found), certified.simplices, "labels of simplices")


def compare_faces(certified, drawing, points, matching):
    """Facets in one simplex of the cell are those of the table, and glued by it nothing is open."""
    cells = numpy.array(drawing["simplices"]).reshape(-1, certified.dimension + 1)
    count = {}
    for cell in cells:
        for facet in itertools.combinations(sorted(cell), certified.dimension):
            count[facet] = count.get(facet, 0) + 1
    boundary = {facet for facet, times in count.items() if times == 1}
    listed = set()
    label = drawing["vertices"]["label"]
    for first, second in matching:
        expect([label[k] for k in first], [label[k] for k in second], "labels of matching faces")
        for face in (first, second):
            listed.add(tuple(sorted(face)))
    expect(len(listed), 2 * len(matching), "matching faces")
    if certified.is_closed:
        expect(listed, boundary, "faces of the cell's boundary")


def meshio_reads(certified, path, form):
    drawing = certified.drawing
    mesh = meshio.read(path, file_format={"off": "off", "obj": "obj", "ply": "ply"}.get(form, form))
    cells = mesh.cells_dict[CELLS[certified.dimension]]
    labels = {"medit": "medit:ref"}.get(form, "label")
    if form in ("off", "obj"):
        compare_cells(certified, cells, drawing["vertices"]["label"])
    else:
        expect(list(map(int, numpy.ravel(mesh.point_data[labels]))), drawing["vertices"]["label"], "labels of vertices")
        compare_cells(certified, cells, numpy.ravel(mesh.point_data[labels]))
    points = numpy.array(drawing["vertices"]["coordinates"]).reshape(-1, drawing["ambient_dimension"])
    expect_close(mesh.points[:, : points.shape[1]], points, "coordinates")
    if form in ("vtu", "gmsh"):
        for name, values in drawing["measures"].items():
            if values is not None:
                expect_close(numpy.ravel(mesh.cell_data[name][0]), [math.nan if x is None else x for x in values], name)


def vtk_reads(certified, path, form):
    drawing = certified.drawing
    reader = {"vtu": vtkXMLUnstructuredGridReader, "obj": vtkOBJReader, "ply": vtkPLYReader}[form]()
    reader.SetFileName(str(path))
    reader.Update()
    data = reader.GetOutput()
    cells = [[data.GetCell(k).GetPointId(i) for i in range(certified.dimension + 1)] for k in range(data.GetNumberOfCells())]
    expect(data.GetNumberOfPoints(), len(drawing["vertices"]["label"]), "vertices")
    compare_cells(certified, cells, drawing["vertices"]["label"])
    if form != "vtu":
        return
    expect(vtk_to_numpy(data.GetPointData().GetArray("label")).tolist(), drawing["vertices"]["label"], "labels")
    for name, values in drawing["measures"].items():
        if values is not None:
            found = vtk_to_numpy(data.GetCellData().GetArray(name))
            expect_close(found, [math.nan if x is None else x for x in values], name)
    array = data.GetFieldData().GetArray("matching_faces")
    pairs = [] if array is None else vtk_to_numpy(array).reshape(-1, 2 * certified.dimension).tolist()
    m = certified.dimension
    compare_faces(certified, drawing, None, [(row[:m], row[m:]) for row in pairs])


def python_reads_csv(certified, path, _):
    with open(path, newline="") as file:
        expect(file.readline()[:2], "# ", "comment")
        rows = list(csv.DictReader(file))
    columns = [f"label_{k}" for k in range(certified.dimension + 1)]
    found = [tuple(sorted(int(row[column]) for column in columns)) for row in rows]
    expect(len(found), len(certified.rows), "lines")
    expect(set(found), certified.simplices, "labels of lines")
    for row, simplex in zip(rows, found):
        expect(certified.rows[int(row["position"])], simplex, "position")


def simplex_tree(path):
    tree = gudhi.SimplexTree()
    for line in path.read_text().splitlines():
        dimension, *labels, value = line.split()
        expect(len(labels), int(dimension) + 1, "labels of a face")
        tree.insert([int(label) for label in labels], float(value))
    return tree


def gudhi_reads(certified, path, reader):
    tree = simplex_tree(path)
    top = {tuple(sorted(face)) for face, _ in tree.get_simplices() if len(face) == certified.dimension + 1}
    expect(top, certified.simplices, "simplices")
    faces = {face for row in certified.rows for k in range(1, len(row) + 1) for face in itertools.combinations(row, k)}
    expect(tree.num_simplices(), len(faces), "faces")
    counts = [0] * (certified.dimension + 1)
    for face in faces:
        counts[len(face) - 1] += 1
    expect(sum((-1) ** k * count for k, count in enumerate(counts)), certified.level_2["euler_characteristic"], "Euler")
    own = subprocess.run([reader, path], capture_output=True, text=True, check=True).stdout.split()
    expect(own, [str(counts[0]), str(len(faces)), str(certified.dimension)], "what GUDHI's reader of files counts")
    if not certified.groups:
        return
    # Persistence of faces that all come at once is slow: of large complexes it is asked of what --simplify leaves.
    if certified.is_closed and len(certified.rows) > MOST_FOR_HOMOLOGY:
        tree = simplex_tree(certified.export("simplex-tree", "--simplify"))
    for prime in (2, 3, 5):
        tree.compute_persistence(homology_coeff_field=prime, persistence_dim_max=True)
        expect(tree.betti_numbers(), betti_numbers(certified.groups, prime), f"Betti numbers modulo {prime}")


def euler_of_regina(found):
    return found.eulerCharTri() if hasattr(found, "eulerCharTri") else found.eulerChar()


def compare_triangulation(certified, found):
    expect(found.isValid(), True, "valid")
    expect(found.isClosed() if hasattr(found, "isClosed") else not found.hasBoundaryFacets(), certified.is_closed, "closed")
    expect(found.countComponents(), certified.groups[0][0] if certified.groups else 1, "connected components")
    expect(euler_of_regina(found), certified.level_2["euler_characteristic"], "Euler characteristic")
    # Regina takes minutes for the homology of ten thousand simplices: it is asked of the simplified complex.
    if certified.groups and found.size() <= MOST_FOR_HOMOLOGY:
        expect(group_of_regina(found.homology()), certified.groups[1], "H1")
        expect(found.isOrientable(), certified.groups[certified.dimension] == certified.groups[0] or not certified.is_closed, "orientable")


def regina_reads(certified, path, _):
    """The triangulation as it is: gluings are those of the certificate, facet by facet and vertex by vertex."""
    found = regina.open(str(path))
    if found is None:
        raise Mismatch("Regina cannot read the file")
    expect(certified.seal in found.label(), True, "sha256 in the label")
    expect(found.size(), len(certified.rows), "simplices")
    for facet, sides in certified.facets.items():
        for (at, k), (other, opposite) in (sides, reversed(sides)) if len(sides) == 2 else ():
            simplex = found.simplex(at)
            neighbour = simplex.adjacentSimplex(k)
            if neighbour is None:
                raise Mismatch(f"facet {facet} is open")
            gluing = simplex.adjacentGluing(k)
            expect((neighbour.index(), gluing[k]), (other, opposite), f"what is beyond facet {facet}")
            for i, label in enumerate(certified.rows[at]):
                if i != k:
                    expect(certified.rows[other][gluing[i]], label, f"label beyond facet {facet}")
    compare_triangulation(certified, found)


def simplified(certified):
    """Few enough simplices for all that Regina is asked."""
    return regina.open(str(certified.export("regina", "--simplify")))


def regina_reads_signature(certified, path, _):
    """That of the simplified complex, which is compared with what Regina computes."""
    text = path.read_text().strip()
    wanted = simplified(certified)
    compare_triangulation(certified, wanted)
    expect(text, wanted.isoSig(), "signature")
    found = type(wanted).fromIsoSig(text)
    if found is None:
        raise Mismatch("no signature")
    compare_triangulation(certified, found)


def regina_reads_snappea(certified, path, _):
    wanted = simplified(certified)
    found = regina.Triangulation3.fromSnapPea(path.read_text())
    if found is None:
        raise Mismatch("no file of SnapPea's")
    expect(found.isOriented(), True, "oriented")
    expect(found.isIsomorphicTo(wanted) is not None, True, "isomorphic to the triangulation in Regina's file")
    compare_triangulation(certified, found)
    kernel = regina.SnapPeaTriangulation(found)
    expect(kernel.isNull(), False, "nothing in SnapPea's kernel")
    expect(group_of_regina(kernel.homologyFilled()), certified.groups[1], "H1 of SnapPea's kernel")


def name_of(certified):
    """What Regina calls it, after it has made it smaller still."""
    if certified.dimension not in (2, 3) or not certified.is_closed:
        return "–"
    found = simplified(certified)
    if not found.isConnected():
        return f"{found.countComponents()} components"
    if certified.dimension == 2:
        genus = 2 - found.eulerChar()
        return f"orientable, genus {genus // 2}" if found.isOrientable() else f"non-orientable, genus {genus}"
    small = regina.Triangulation3(found)
    small.intelligentSimplify()
    standard = regina.StandardTriangulation.recognise(small)
    if standard is not None and standard.manifold() is not None:
        return standard.manifold().name()
    names = [hit.name().split(" : ")[0] for hit in regina.Census.lookup(small)]
    return names[0] if names else "no census name"


def comparisons(certified, reader):
    """(receiver, format, options of the export, comparison)"""
    m = certified.dimension
    result = [("Python", "json", (), lambda c, path, _: compare_drawing(c, path)), ("Python", "csv", (), python_reads_csv)]
    result.append(("GUDHI", "simplex-tree", (), lambda c, path, _: gudhi_reads(c, path, reader)))
    if m <= 3:
        result += [("meshio", form, (), meshio_reads) for form in ("vtu", "medit", "gmsh")] + [("VTK", "vtu", (), vtk_reads)]
    if m == 2:
        result += [("meshio", form, (), meshio_reads) for form in ("off", "obj", "ply")]
        result += [("VTK", form, (), vtk_reads) for form in ("obj", "ply")]
    if m >= 2:
        result.append(("Regina", "regina", (), regina_reads))
        # A signature is that of a connected complex.
        if certified.is_closed and (not certified.groups or certified.groups[0] == (1, [])):
            result.append(("Regina", "isosig", ("--simplify",), regina_reads_signature))
    if m == 3 and certified.is_closed and certified.groups and certified.groups[3] == (1, []):
        result.append(("Regina", "snappea", ("--simplify",), regina_reads_snappea))
    return result


# Two labels exchanged between two simplices, in each format.


def exchange(simplices, label):
    """Exchanges the last vertex of the first of these lists of vertices with that of the next one with which other sets of
    labels come out, none of them with a label twice: what came out before is missing then. The place of that list."""
    def sets(*lists):
        return sorted(sorted(label(vertex) for vertex in one) for one in lists)

    first = simplices[0]
    for at, other in enumerate(simplices):
        new = sets([*first[:-1], other[-1]], [*other[:-1], first[-1]])
        if new != sets(first, other) and all(len(set(one)) == len(one) for one in new):
            first[-1], other[-1] = other[-1], first[-1]
            return at
    raise SystemExit("receivers.py: there is nothing to exchange")


def exchanged(lines, rows, corners, separator, label):
    """The lines with two entries of the last of these columns exchanged between two of these rows."""
    split = {row: lines[row].split(separator) for row in rows}
    simplices = [[split[row][column] for column in corners] for row in rows]
    exchange(simplices, label)
    for row, simplex in zip(rows, simplices):
        split[row][corners[-1]] = simplex[-1]
    return [separator.join(split[at]) if at in split else line for at, line in enumerate(lines)]


def otherwise_glued(lines, form, m):
    """The first simplex glued to its neighbour beyond facet 0 with two other vertices exchanged, from both sides: files of
    gluings that do not fit together make Regina run for ever."""
    permutations = {2: regina.Perm3, 3: regina.Perm4}[m]
    if form == "regina":
        start = next(at for at, line in enumerate(lines) if "<simplex>" in line)
        words = lines[start].split(" ")
        other, gluing = int(words[3]), permutations.Sn[int(words[4])]
        new = gluing * permutations(1, 2)
        words[4] = str(new.SnIndex())
        back = lines[start + other].split(" ")
        back[4 + 2 * gluing[0]] = str(new.inverse().SnIndex())
        return [*lines[:start], " ".join(words), *lines[start + 1 : start + other], " ".join(back), *lines[start + other + 1 :]]
    start = 10
    other = int(lines[start - 1].split()[0])
    words = lines[start].split(" ")
    gluing = permutations([int(digit) for digit in words[1]])
    new = gluing * permutations(1, 2)
    words[1] = "".join(str(new[k]) for k in range(m + 1))
    back = lines[start + 9 * other].split(" ")
    back[1 + gluing[0]] = "".join(str(new.inverse()[k]) for k in range(m + 1))
    changed = {start: " ".join(words), start + 9 * other: " ".join(back)}
    return [changed.get(at, line) for at, line in enumerate(lines)]


# In these formats vertices are numbered, from this number on.
FIRST_VERTEX = {"vtu": 0, "medit": 1, "gmsh": 1, "off": 0, "ply": 0, "obj": 1}


def with_exchanged_labels(certified, path, form):
    m, simplices, labels = certified.dimension, len(certified.rows), certified.drawing["vertices"]["label"]
    text = path.read_text()
    lines = text.split("\n")

    def first_with(start):
        return next(at for at, line in enumerate(lines) if line.startswith(start))

    if form == "json":
        drawing = json.loads(text)
        rows = numpy.reshape(drawing["simplices"], (-1, m + 1)).tolist()
        exchange(rows, labels.__getitem__)
        return json.dumps({**drawing, "simplices": list(itertools.chain(*rows))})
    if form == "isosig":
        middle = len(text) // 2
        other = next(at for at in range(middle, len(text)) if text[at] != text[middle])
        return text[:middle] + text[other] + text[middle + 1 : other] + text[middle] + text[other + 1 :]
    if form in ("regina", "snappea"):
        return "\n".join(otherwise_glued(lines, form, m))
    first, corners = {
        "vtu": lambda: (1 + next(at for at, line in enumerate(lines) if '"connectivity"' in line), range(m + 1)),
        "medit": lambda: (2 + first_with({1: "Edges", 2: "Triangles", 3: "Tetrahedra"}[m]), range(m + 1)),
        "gmsh": lambda: (2 + first_with("$Elements"), range(5, 6 + m)),
        "off": lambda: (len(lines) - 1 - simplices, range(1, 4)),
        "ply": lambda: (len(lines) - 1 - simplices, range(1, 4)),
        "obj": lambda: (first_with("f "), range(1, 4)),
        "csv": lambda: (2, range(1, m + 2)),
        "simplex-tree": lambda: (first_with(f"{m} "), range(1, m + 2)),
    }[form]()
    start = FIRST_VERTEX.get(form)
    label = int if start is None else lambda vertex: labels[int(vertex) - start]
    return "\n".join(exchanged(lines, range(first, first + simplices), corners, "," if form == "csv" else " ", label))


# The table.


def row_of(name, certified, done):
    receivers = {}
    for receiver, form in done:
        receivers.setdefault(receiver, []).append(form)
    drawing = certified.drawing
    cell = f"{len(drawing['vertices']['label'])}" if certified.dimension <= 4 else "–"
    homology = certified.level_2["homology"][1] if certified.groups else "–"
    small = simplified(certified).size() if certified.dimension >= 2 and certified.is_closed else "–"
    columns = [
        name,
        f"{len({label for row in certified.rows for label in row})}/{len(certified.rows)}",
        cell,
        str(certified.level_2["euler_characteristic"]),
        homology,
        *(", ".join(receivers.get(receiver, ["–"])) for receiver in ("GUDHI", "meshio", "VTK", "Regina")),
        str(small),
        name_of(certified),
    ]
    return "| " + " | ".join(columns) + " |"


HEADER = [
    "| manifold | vertices/simplices | vertices of the cell | χ | H₁ | GUDHI | meshio | VTK | Regina | simplified to | Regina's name |",
    "|---|---|--:|--:|---|---|---|---|---|--:|---|",
]


def entries(file):
    return [line.split("\t") for line in (FOLDER / file).read_text().splitlines() if not line.startswith("#")]


def certified_at(arguments, name, options, folder):
    certificate = folder / "certificate.json"
    kept = Path(arguments.certificates or folder) / f"{name}.json"
    if kept.is_file():
        certificate.write_bytes(kept.read_bytes())
    else:
        words = [arguments.delcert, "certify", *options.split(), "--output", certificate]
        run = subprocess.run(words, capture_output=True, text=True, cwd=ROOT)
        if run.returncode != 0:
            sys.exit(f"{name}: {run.stderr.strip()}")
        if arguments.certificates:
            kept.write_bytes(certificate.read_bytes())
    return Certified(arguments.delcert, certificate, folder)


def expect_noticed(certified, form, path, compare):
    """The comparison fails with two labels exchanged, in a file of its own: what is compared with is the export as it is."""
    broken = certified.folder / f"exchanged.{form}"
    broken.write_text(with_exchanged_labels(certified, path, form))
    expect(broken.read_text() != path.read_text(), True, "another file")
    try:
        compare(certified, broken, form)
    except Exception:  # a mismatch, or the receiver itself refuses
        return
    raise Mismatch("two labels are exchanged, and nothing is noticed")


def compare_all(arguments, name, options):
    with tempfile.TemporaryDirectory() as folder:
        certified = certified_at(arguments, name, options, Path(folder))
        done = []
        for receiver, form, export_options, compare in comparisons(certified, arguments.reader):
            try:
                path = certified.export(form, *export_options)
                compare(certified, path, form)
                expect_noticed(certified, form, path, compare)
            except Mismatch as mismatch:
                sys.exit(f"{name}: {receiver} reads {form}: {mismatch}")
            done.append((receiver, form))
        return row_of(name, certified, done)


def table_rows():
    text = PAGE.read_text()
    table = text[text.index(BEGIN) + len(BEGIN) : text.index(END)].splitlines()
    return {line.split(" | ")[0].removeprefix("| "): line for line in table[2:] if line.startswith("| ")}


def for_each_name(arguments, action):
    """All of them, whatever fails; what has failed is named at the end."""
    options = dict(entries("manifolds.tsv"))
    failed = []
    for name in arguments.names:
        try:
            action(arguments, name, options[name])
        except SystemExit as reason:
            failed.append(name)
            print(f"FAILED: {reason}", flush=True)
        except Exception:
            failed.append(name)
            print(f"FAILED: {name}", flush=True)
            traceback.print_exc()
    if failed:
        sys.exit(f"failed: {' '.join(failed)}")


def check_one(arguments, name, options):
    row = compare_all(arguments, name, options)
    print(row, flush=True)
    if table_rows().get(name) != row:
        sys.exit(f"docs/export.md has another row for {name}: run tests/receivers/receivers.py table")


def check(arguments):
    for_each_name(arguments, check_one)


def write_table(rows):
    """Of rows by name, in the order of the lists."""
    names = [name for file in ("manifolds.tsv", "long_manifolds.tsv") for name, _ in entries(file)]
    text = PAGE.read_text()
    begin, end = text.index(BEGIN) + len(BEGIN), text.index(END)
    table = HEADER + [rows[name] for name in names if name in rows]
    PAGE.write_text(text[:begin] + "\n".join(table) + "\n" + text[end:])


def table(arguments):
    rows = table_rows()
    for file in ["manifolds.tsv"] + ["long_manifolds.tsv"] * arguments.long:
        for name, options in entries(file):
            rows[name] = compare_all(arguments, name, options)
    write_table(rows)


def rows_again(arguments):
    rows, options = table_rows(), dict(entries("manifolds.tsv") + entries("long_manifolds.tsv"))
    for name in arguments.names:
        rows[name] = compare_all(arguments, name, options[name])
        print(rows[name], flush=True)
        write_table(rows)


def complete(arguments):
    listed = {name for file in ("manifolds.tsv", "long_manifolds.tsv") for name, _ in entries(file)}
    run = subprocess.run([arguments.delcert, "manifolds", "--json"], capture_output=True, text=True, check=True)
    built_in = {manifold["name"] for manifold in json.loads(run.stdout)}
    wanting = {"in no list": built_in - listed - EXEMPT, "without a row": listed - set(table_rows())}
    wanting["exempt, but no built-in manifold, or listed"] = EXEMPT - (built_in - listed)
    for what, names in wanting.items():
        if names:
            sys.exit(f"{what}: {' '.join(sorted(names))}")
    print(f"{len(built_in - EXEMPT)} of {len(built_in)} built-in manifolds have a row")


def missing(arguments):
    rows = table_rows()
    for file in ("manifolds.tsv", "long_manifolds.tsv"):
        for name, options in entries(file):
            if name in rows:
                continue
            rows[name] = compare_all(arguments, name, options)
            print(rows[name], flush=True)
            write_table(rows)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--delcert", default=ROOT / "build/release/apps/delcert")
    parser.add_argument("--reader", default=ROOT / "build/release/tests/receivers/read_simplex_tree")
    parser.add_argument("--certificates", help="a folder of certificates NAME.json: used where there are any, and kept there")
    commands = parser.add_subparsers(required=True)
    for command, action in (("check", check), ("table", table), ("rows", rows_again), ("missing", missing), ("complete", complete)):
        subparser = commands.add_parser(command)
        subparser.set_defaults(action=action)
        if command == "table":
            subparser.add_argument("--long", action="store_true")
        elif command in ("check", "rows"):
            subparser.add_argument("names", nargs="+")
    arguments = parser.parse_args()
    arguments.action(arguments)


if __name__ == "__main__":
    main()
