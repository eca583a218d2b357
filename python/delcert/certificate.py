"""Certificates: what they say, in Python's types and in those of other programs."""

import functools
import json
import os
import shutil
import tempfile
import weakref
from collections.abc import Sequence
from fractions import Fraction
from pathlib import Path
from types import SimpleNamespace

import _delcert
import numpy

from .checking import check_file
from .errors import Usage
from .html import table
from .optional import module


def load(path):
    """The certificate in a file, plain or compressed. Nothing of it is verified before `check()` says so."""
    return Certificate(path)


def _value(text):
    try:
        return _delcert.exact(text)
    except Usage:
        return text


class Picture:
    """An SVG, which a notebook shows."""

    def __init__(self, svg):
        self.svg = svg

    def _repr_svg_(self):
        return self.svg

    def __repr__(self):
        return f"<a picture, SVG of {len(self.svg)} characters: save(path)>"

    def save(self, path):
        Path(path).write_text(self.svg)


class Margin:
    """A measure of all simplices: `lower` or `upper` is the bound that the certificate states, exactly (the other is
    None), `approximate` what is computed for each simplex in floats, without error bounds, and `bounds` what is proved of
    each simplex, on flat tori and space forms."""

    def __init__(self, name, approximate, lower=None, upper=None, bounds=None):
        self.name, self.approximate, self.lower, self.upper = name, approximate, lower, upper
        self._bounds = bounds

    @property
    def bounds(self):
        """float64, a row (lower, upper) for each simplex, by intervals that are rounded outwards, from the exact points, in
        the charts of the vertices. On flat tori the lower bound of the protection rests on level 4, which `check()` verifies; all
        others rest on nothing. For flat tori and space forms only: MalformedInput elsewhere."""
        rows = self._bounds()[self.name]
        rows.flags.writeable = False
        return rows

    def __repr__(self):
        bound = f">= {self.lower}" if self.upper is None else f"<= {self.upper}"
        if self.lower is None and self.upper is None:
            bound = "not claimed"
        return f"<{self.name} {bound} certified; approximately {numpy.nanmin(self.approximate):.6g} to {numpy.nanmax(self.approximate):.6g}>"


class _Points(Sequence):
    """The points, exactly: the coordinates that the certificate has, a tuple of Fractions for each label."""

    def __init__(self, content):
        self._content = content

    def __len__(self):
        return self._content.point_count()

    def __getitem__(self, label):
        if isinstance(label, slice):
            return [self[one] for one in range(*label.indices(len(self)))]
        if not -len(self) <= label < len(self):
            raise IndexError(f"label {label}: there are {len(self)} points")
        return self._content.point(label % len(self))

    def __repr__(self):
        return f"<{len(self)} exact points>"


class Certificate:
    """A certified Delaunay triangulation, as its file says: a claim until `check()` is true."""

    def __init__(self, path, report=None, temporary_folder=None):
        self.path = Path(path)
        self.report_of_run = report  # of `certify`: docs/report-format.md
        self._content = _delcert.ReadCertificate(os.fspath(path))
        self._facts = json.loads(self._content.summary())
        self.manifold, self.family = self._facts["manifold"], self._facts["family"]
        self.dimension, self.sha256 = self._facts["dimension"], self._facts["sha256"]
        self.parameters = {name: _value(text) for name, text in self._facts["parameters"].items()}
        self.software = self._facts["software"]
        self.levels = self._facts["levels"]  # as claimed: what `delcert info --json` prints
        self.checked = None  # what `check()` found last
        if temporary_folder is not None:
            weakref.finalize(self, shutil.rmtree, temporary_folder)

    def check(self):
        """Has delcert-check, a separate program, verify the file."""
        self.checked = check_file(self.path)
        return self.checked

    def save(self, path):
        """Copies the file; what was there under that name is replaced, whole or not at all."""
        path = Path(path)
        with tempfile.NamedTemporaryFile(dir=path.parent, prefix=f".{path.name}-", delete=False) as copy:
            try:
                copy.write(self.path.read_bytes())
                copy.close()
                os.replace(copy.name, path)
            except BaseException:
                os.unlink(copy.name)
                raise

    # What it says.

    @functools.cached_property
    def simplices(self):
        """Labels, int32, a row of m + 1 for each simplex, in the order of the file."""
        rows = self._content.simplices()
        rows.flags.writeable = False
        return rows

    @property
    def points_exact(self):
        """Of each label, a tuple of Fractions: coordinates of the frame on flat tori and balls, in general those that
        docs/certificate-format.md says for the family."""
        return _Points(self._content)

    def points_approximate(self, model=None):
        """Of each label, float64, without error bounds, in the coordinates of a model (docs/export.md); NaN for a label
        of no simplex."""
        drawn = self._content.drawing("quotient", model)
        result = numpy.full((len(self.points_exact), drawn["coordinates"].shape[1]), numpy.nan)
        result[drawn["labels"]] = drawn["coordinates"]
        return result

    @functools.cached_property
    def margins(self):
        """Protection and circumradius, in units of the sampling radius, and thickness: each a `Margin`."""
        drawn = self._content.drawing("quotient", None)
        order = numpy.argsort(drawn["positions"])

        def stated(key, unit):
            entries = dict(self._facts["levels_claimed"].get("1", {}))
            return Fraction(_delcert.exact(entries[key])) / unit if key in entries else None

        def measured(name):
            return drawn["measures"][name][order]

        # All three at once, when the first is asked for.
        bounds = functools.cache(self._content.bounds)
        radius = self.parameters["sampling_radius"]
        return SimpleNamespace(
            protection=Margin("protection", measured("protection"), lower=stated("protection", radius), bounds=bounds),
            thickness=Margin("thickness", measured("thickness"), lower=stated("thickness", 1), bounds=bounds),
            circumradius=Margin("circumradius", measured("circumradius"), upper=stated("circumradius", radius), bounds=bounds),
        )

    # For other programs.

    def simplex_tree(self):
        """A gudhi.SimplexTree of the labels, all filtration values 0."""
        tree = module("gudhi", "python3-gudhi").SimplexTree()
        for row in self.simplices.tolist():
            tree.insert(row)
        return tree

    def _drawn(self, copies, model):
        drawn = self._content.drawing(copies, model)
        points = numpy.zeros((len(drawn["labels"]), 3))
        points[:, : drawn["coordinates"].shape[1]] = drawn["coordinates"]
        return drawn, points

    def meshio(self, copies="cell", model=None):
        """A meshio.Mesh in approximate coordinates, with labels and measures."""
        kind = {1: "line", 2: "triangle", 3: "tetra"}.get(self.dimension)
        if kind is None:
            raise Usage(f"meshes are of dimension 1 to 3, and not {self.dimension}")
        mesh = module("meshio", "python3-meshio")
        drawn, points = self._drawn(copies, model)
        cell_data = {name: [values] for name, values in drawn["measures"].items()}
        cell_data["position"] = [drawn["positions"]]
        point_data = {"label": drawn["labels"], "lift": drawn["lifts"]}
        return mesh.Mesh(points, [(kind, drawn["simplices"])], point_data=point_data, cell_data=cell_data)

    def vtk(self, copies="cell", model=None):
        """A vtkUnstructuredGrid in approximate coordinates, with labels and measures."""
        cell_type = {1: 3, 2: 5, 3: 10}.get(self.dimension)  # VTK_LINE, VTK_TRIANGLE, VTK_TETRA
        if cell_type is None:
            raise Usage(f"grids are of dimension 1 to 3, and not {self.dimension}")
        data_model = module("vtkmodules.vtkCommonDataModel", "python3-vtk9")
        core = module("vtkmodules.vtkCommonCore", "python3-vtk9")
        support = module("vtkmodules.util.numpy_support", "python3-vtk9")
        drawn, points = self._drawn(copies, model)

        def array(values, name):
            result = support.numpy_to_vtk(numpy.ascontiguousarray(values), deep=True)
            result.SetName(name)
            return result

        places = core.vtkPoints()
        places.SetData(array(points, "points"))
        corners = drawn["simplices"].astype(numpy.int64)
        cells = data_model.vtkCellArray()
        counted = numpy.column_stack([numpy.full(len(corners), corners.shape[1]), corners]).ravel()
        cells.ImportLegacyFormat(support.numpy_to_vtkIdTypeArray(counted, deep=True))
        grid = data_model.vtkUnstructuredGrid()
        grid.SetPoints(places)
        grid.SetCells(cell_type, cells)
        grid.GetPointData().AddArray(array(drawn["labels"], "label"))
        grid.GetPointData().AddArray(array(drawn["lifts"], "lift"))
        grid.GetCellData().AddArray(array(drawn["positions"], "position"))
        for name, values in drawn["measures"].items():
            grid.GetCellData().AddArray(array(values, name))
        return grid

    def regina(self, simplify=True):
        """A triangulation of Regina's, of dimension 2 to 4. `simplify`: with edges contracted as long as the link
        condition allows it; without, Regina takes minutes for what it is asked of ten thousand simplices."""
        regina = module("regina", "regina-normal")
        with tempfile.TemporaryDirectory(prefix="delcert-") as folder:
            path = Path(folder) / "triangulation.rga"
            path.write_bytes(self.export("regina", simplify=simplify))
            packet = regina.open(os.fspath(path))
        return {2: regina.Triangulation2, 3: regina.Triangulation3, 4: regina.Triangulation4}[self.dimension](packet)

    def isosig(self):
        """Regina's isomorphism signature of the simplified complex."""
        return self.export("isosig", simplify=True).decode().strip()

    def export(self, format, path=None, copies="cell", model=None, exact=False, simplify=False):
        """The bytes of a file in one of the formats of `delcert export` (docs/export.md); written, if there is a path,
        whole or not at all."""
        bytes_ = self._content.exported(format, copies, model, exact, simplify, bool(self.checked))
        if path is not None:
            Path(path).write_bytes(bytes_)
        return bytes_

    # For people.

    def picture(self, colour="thickness", model=None, plain=False):
        """A surface or a curve as a `Picture`: triangles are the darker, the greater the measure `colour`; `plain`: without the
        worst star and a scale."""
        return Picture(self._content.picture(colour, model, plain))

    def report(self, path, check=True):
        """Writes one HTML file that shows the certificate, without needing any network. Returns what delcert-check
        says, which the page shows; None if it is not asked."""
        found = self.check() if check else None
        asked = (found.checker, found.date, json.dumps(found.result)) if found else ("", "", "")
        _delcert.write_page(os.fspath(self.path), *asked, os.fspath(path))
        return found

    def latex(self):
        """What is claimed as a table for a paper."""
        return self._content.latex()

    def cite(self, style="bibtex"):
        """A reference to the certificate. `style`: "bibtex" or "text"."""
        if style not in ("bibtex", "text"):
            raise Usage(f"style = {style!r} is neither bibtex nor text")
        return self._content.reference(style == "text")

    def _verdict(self):
        return "not checked" if self.checked is None else self.checked.verdict

    def __repr__(self):
        return (
            f"<certificate of {self.manifold}: {len(self.points_exact)} points, {self._facts['simplices']} simplices of "
            f"dimension {self.dimension}, levels {' '.join(self.levels)} claimed, {self._verdict()}>"
        )

    def _repr_html_(self):
        rows = [
            ("points, simplices", f"{len(self.points_exact)}, {self._facts['simplices']} of dimension {self.dimension}"),
            ("sampling radius", self.parameters["sampling_radius"]),
            ("levels claimed", " ".join(self.levels)),
            ("delcert-check", self._verdict()),
            ("made by", self.software.get("command", "")),
            ("sha256", self.sha256),
        ]
        return table(rows, title=self.manifold)
