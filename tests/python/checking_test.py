"""Checking, by the separate program."""

import os
import unittest.mock
from pathlib import Path

import delcert
from cases import Case, small
from delcert import checking


class Checking(Case):
    def test_what_is_right_is_verified(self):
        certificate = small()
        report = certificate.check()
        self.assertTrue(report)
        self.assertEqual(report.levels, tuple(certificate.levels))
        self.assertIs(certificate.checked, report)
        self.assertIn("verified", repr(certificate))
        self.assertRegex(repr(report), r"^<delcert-check [0-9.]+: verified, levels 1 2 2s 4 5 6>$")
        self.assertIn("verified", report._repr_html_())
        self.assertEqual(report.message, "")

    def test_what_is_wrong_is_not(self):
        path = self.folder / "c.json"
        small(output=path)
        text = path.read_text()
        self.assertIn('"seed"', text)
        path.write_text(text.replace('"simplices":[[0,', '"simplices":[[1,', 1))
        report = delcert.load(path).check()
        self.assertFalse(report)
        self.assertIn(report.verdict, ("rejected", "malformed"))
        self.assertEqual(report.levels, ())
        self.assertNotEqual(report.message, "")
        self.assertIn(report.verdict, repr(report) + report._repr_html_())

    def test_the_program_is_that_of_the_build(self):
        self.assertTrue(os.access(checking.checker(), os.X_OK))
        with unittest.mock.patch.dict(os.environ, DELCERT_CHECK="/no/such/program"):
            self.assertEqual(checking.checker(), Path("/no/such/program"))
            with self.assertRaises(OSError):
                small().check()
        with unittest.mock.patch.object(checking._delcert, "__file__", "/no/such/folder/_delcert.so"):
            with unittest.mock.patch.dict(os.environ, PATH=""):
                self.assertIn("not installed", self.message_of(delcert.Error, checking.checker))
