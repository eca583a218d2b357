"""Certificates: made in this process, read, shown, handed to other programs."""

import gc
import json
import os
import shlex
import subprocess
import unittest.mock
from fractions import Fraction

import _delcert
import delcert
import numpy
from cases import Case, small


class Made(Case):
    def test_has_the_bytes_of_the_command_that_it_states(self):
        delcert_program = os.environ["DELCERT_PROGRAM"]
        ours = small(output=self.folder / "ours.json.zst", choices=4, levels=["1", "2", "4"], threads=1)
        command = ours.software["command"]
        self.assertEqual(
            command, "delcert certify --manifold klein-bottle --radius 1/20 --seed 1 --choices 4 --levels 1,2,4"
        )
        theirs = self.folder / "theirs.json.zst"
        run = [delcert_program, *shlex.split(command)[1:], "--output", theirs]
        subprocess.run(run, check=True, capture_output=True)
        self.assertEqual(theirs.read_bytes(), ours.path.read_bytes())
        self.assertEqual(ours.software.get("commit", ""), _delcert.build_commit)
        other = small(output=self.folder / "other.json.zst", tolerance="1/100")
        self.assertNotEqual(other.path.read_bytes(), ours.path.read_bytes())

    def test_without_a_name_lives_as_long_as_it_is_used(self):
        certificate = small()
        path = certificate.path
        self.assertTrue(path.exists())
        certificate.save(self.folder / "kept.json.zst")
        del certificate
        gc.collect()
        self.assertFalse(path.exists())
        self.assertEqual(delcert.load(self.folder / "kept.json.zst").manifold, "klein-bottle")
        self.assertEqual([one.name for one in self.folder.iterdir()], ["kept.json.zst"])

    def test_options_that_exclude_each_other_are_refused(self):
        for options in ({"lattice": 3, "points": "x"}, {"centred": True}, {"displace": 3}, {"mode": "theoretic"}):
            self.message_of(delcert.Usage, delcert.certify, "torus-2", radius="1/30", **options)
        for options in ({"radius": 0.05}, {"choices": 0}, {"seed": -1}, {"levels": "7"}, {"manifold": 3}):
            self.message_of(delcert.Usage, delcert.certify, **{"manifold": "torus-2", **options})

    def test_reports_the_run(self):
        certificate = small()
        self.assertEqual(certificate.report_of_run["points"], len(certificate.points_exact))


class Read(Case):
    @classmethod
    def setUpClass(cls):
        cls.certificate = small()

    def test_simplices_are_those_of_the_file(self):
        certificate = small(output=self.folder / "c.json")
        content = json.loads((self.folder / "c.json").read_text())
        self.assertEqual(certificate.simplices.dtype, numpy.int32)
        self.assertEqual(certificate.simplices.tolist(), [row[:3] for row in content["simplices"]])
        with self.assertRaises(ValueError):
            certificate.simplices[0, 0] = 1

    def test_points_are_exact_and_near_the_approximate_ones(self):
        torus = delcert.certify("torus-2", radius="1/24", seed=1)
        exact = torus.points_exact
        self.assertTrue(all(isinstance(x, Fraction) for x in exact[0]))
        self.assertEqual(exact[-1], exact[len(exact) - 1])
        self.assertEqual(len(exact[1:4]), 3)
        with self.assertRaises(IndexError):
            exact[len(exact)]
        floats = torus.points_approximate()
        self.assertEqual((floats.dtype, floats.shape), (numpy.float64, (len(exact), 2)))
        self.assertTrue(numpy.allclose(floats, numpy.array([[float(x) for x in point] for point in exact])))
        self.assertFalse(numpy.allclose(floats, numpy.roll(floats, 1, axis=0)))

    def test_models_are_those_of_the_family(self):
        bolza = delcert.certify("bolza-surface", radius="1/8", seed=1)
        conformal, gnomonic = (bolza.points_approximate(model) for model in ("conformal", "gnomonic"))
        self.assertTrue((numpy.hypot(*conformal.T) < numpy.hypot(*gnomonic.T)).any())
        self.assertIn("conformal", self.message_of(delcert.MalformedInput, bolza.points_approximate, "unit"))
        self.assertIn("did you mean", self.message_of(delcert.MalformedInput, bolza.points_approximate, "gnomonik"))

    def test_bounds_are_exact_and_hold_of_what_is_measured(self):
        margins = self.certificate.margins
        self.assertIsInstance(margins.protection.lower, Fraction)
        slack = 1e-9
        self.assertGreater(margins.protection.approximate.min(), float(margins.protection.lower) - slack)
        self.assertGreater(margins.thickness.approximate.min(), float(margins.thickness.lower) - slack)
        self.assertLess(margins.circumradius.approximate.max(), float(margins.circumradius.upper) + slack)
        self.assertEqual(len(margins.thickness.approximate), len(self.certificate.simplices))
        # Twin: of the worst simplex alone, twice the bound does not hold.
        self.assertLess(margins.thickness.approximate.min(), 2 * float(margins.thickness.lower))
        self.assertIsNone(margins.protection.upper)

    def test_bounds_of_each_simplex_hold_and_are_narrow(self):
        for manifold, radius in (("torus-2", "1/24"), ("bolza-surface", "1/8"), ("projective-space-3", "13/100")):
            with self.subTest(manifold=manifold):
                self.check_bounds_of_each_simplex(delcert.certify(manifold, radius=radius, seed=1))

    def check_bounds_of_each_simplex(self, certificate):
        for name in ("protection", "thickness", "circumradius"):
            margin = getattr(certificate.margins, name)
            lower, upper = margin.bounds.T
            self.assertEqual(margin.bounds.shape, (len(certificate.simplices), 2))
            self.assertEqual(margin.bounds.dtype, numpy.float64)
            self.assertTrue((lower < upper).all() and (upper - lower < 1e-9).all(), name)
            # What is computed in floats is within the bounds, up to its own error.
            self.assertTrue((margin.approximate > lower - 1e-9).all() and (margin.approximate < upper + 1e-9).all(), name)
            # What the certificate states of all holds of the worst, and is near it.
            if margin.lower is not None:
                self.assertTrue(Fraction(upper.min()) >= margin.lower > Fraction(lower.min()) * Fraction(99, 100), name)
            else:
                self.assertTrue(Fraction(lower.max()) <= margin.upper < Fraction(upper.max()) * Fraction(101, 100), name)
        # Twin: bounds of another simplex do not hold.
        thickness = certificate.margins.thickness
        shifted = numpy.roll(thickness.bounds, 1, axis=0)
        self.assertFalse((thickness.approximate > shifted[:, 0] - 1e-9).all())
        with self.assertRaises(ValueError):
            thickness.bounds[0, 0] = 1

    def test_bounds_of_each_simplex_are_of_constant_curvature_only(self):
        ellipsoid = delcert.certify("ellipsoid", radius="1/10", seed=1)
        self.assertIn("submanifold", self.message_of(delcert.MalformedInput, lambda: ellipsoid.margins.thickness.bounds))

    def test_of_a_file_that_is_none_is_refused(self):
        path = self.folder / "c.json"
        path.write_text("{}")
        self.assertIn("c.json", self.message_of(delcert.MalformedInput, delcert.load, path))

    def test_prints_itself(self):
        self.assertIn("levels 1 2 2s 4 5 6 claimed, not checked", repr(small()))
        self.assertIn(self.certificate.sha256, self.certificate._repr_html_())


class Shown(Case):
    @classmethod
    def setUpClass(cls):
        cls.certificate = small()

    def test_a_picture_has_a_triangle_for_each_and_colours_for_each_measure(self):
        pictures = {colour: self.certificate.picture(colour=colour) for colour in ("thickness", "protection", "circumradius")}
        for colour, picture in pictures.items():
            self.assertGreater(picture._repr_svg_().count("<path"), len(self.certificate.simplices))
            self.assertIn(f"shaded by {colour}", picture.svg)
        self.assertEqual(len({picture.svg for picture in pictures.values()}), 3)
        pictures["thickness"].save(self.folder / "picture.svg")
        self.assertEqual((self.folder / "picture.svg").read_text(), pictures["thickness"].svg)
        self.assertIn("did you mean", self.message_of(delcert.MalformedInput, self.certificate.picture, colour="thicknes"))

    def test_a_page_says_whether_it_was_checked(self):
        found = self.certificate.report(self.folder / "page.html")
        self.assertTrue(found.verified)
        self.assertIn('"status":"verified"', (self.folder / "page.html").read_text())
        self.assertIsNone(self.certificate.report(self.folder / "page.html", check=False))
        self.assertNotIn('"status":"verified"', (self.folder / "page.html").read_text())

    def test_what_a_paper_takes_is_that_of_the_programs(self):
        program = os.environ["DELCERT_PROGRAM"]
        path = self.certificate.path

        def printed(*arguments):
            return subprocess.run([program, *arguments], capture_output=True, text=True, check=True).stdout

        self.assertEqual(self.certificate.latex(), printed("info", path, "--latex"))
        self.assertEqual(delcert.cite() + "\n" + self.certificate.cite(), printed("cite", path))
        self.assertEqual(delcert.cite("text") + self.certificate.cite("text"), printed("cite", path, "--format", "text"))
        self.assertEqual(
            delcert.load(path).export("csv", copies="glued").decode(),
            printed("export", path, "--format", "csv", "--copies", "glued"),
        )
        self.assertNotIn("not verified", self.certificate.export("csv").decode() if self.certificate.check() else "not verified")
        self.message_of(delcert.Usage, self.certificate.cite, "bibtecks")
        self.message_of(delcert.MalformedInput, self.certificate.export, "cvs")


class Received(Case):
    """By the programs that it is for."""

    @classmethod
    def setUpClass(cls):
        cls.certificate = small()
        cls.rows = {frozenset(row) for row in cls.certificate.simplices.tolist()}

    def test_gudhi_has_the_simplices_and_the_homology(self):
        tree = self.certificate.simplex_tree()
        self.assertEqual({frozenset(face) for face, _ in tree.get_skeleton(2) if len(face) == 3}, self.rows)
        for prime, betti in ((2, [1, 2, 1]), (3, [1, 1, 0])):
            tree.compute_persistence(homology_coeff_field=prime, persistence_dim_max=True)
            self.assertEqual(tree.betti_numbers(), betti)

    def test_meshio_writes_what_can_be_read_back(self):
        import meshio

        mesh = self.certificate.meshio(copies="cell")
        mesh.write(self.folder / "mesh.vtu")
        read = meshio.read(self.folder / "mesh.vtu")
        labels = read.point_data["label"]
        self.assertEqual({frozenset(labels[row].tolist()) for row in read.cells[0].data}, self.rows)
        self.assertTrue(numpy.allclose(read.cell_data["thickness"][0], mesh.cell_data["thickness"][0]))
        quotient = self.certificate.meshio(copies="quotient")
        self.assertLess(len(quotient.points), len(mesh.points))

    def test_vtk_has_the_grid(self):
        from vtkmodules.util.numpy_support import vtk_to_numpy

        grid = self.certificate.vtk()
        self.assertEqual(grid.GetNumberOfCells(), len(self.rows))
        labels = vtk_to_numpy(grid.GetPointData().GetArray("label"))
        cell = grid.GetCell(7)
        corners = [cell.GetPointId(k) for k in range(cell.GetNumberOfPoints())]
        position = int(vtk_to_numpy(grid.GetCellData().GetArray("position"))[7])
        self.assertEqual(set(labels[corners].tolist()), set(self.certificate.simplices[position].tolist()))

    def test_regina_recognises_it(self):
        small_, whole = self.certificate.regina(), self.certificate.regina(simplify=False)
        self.assertEqual(whole.size(), len(self.rows))
        self.assertLess(small_.size(), whole.size())
        for one in (small_, whole):
            self.assertEqual((one.eulerChar(), one.isOrientable(), one.isClosed()), (0, False, True))
        self.assertEqual(small_.isoSig(), self.certificate.isosig())

    def test_a_module_that_is_not_there_is_an_import_error_that_says_what_to_install(self):
        for name, package, call in (
            ("gudhi", "python3-gudhi", self.certificate.simplex_tree),
            ("meshio", "python3-meshio", self.certificate.meshio),
            ("vtkmodules.vtkCommonDataModel", "python3-vtk9", self.certificate.vtk),
            ("regina", "regina-normal", self.certificate.regina),
        ):
            with unittest.mock.patch.dict("sys.modules", {name: None}):
                self.assertIn(package, self.message_of(ImportError, call))
