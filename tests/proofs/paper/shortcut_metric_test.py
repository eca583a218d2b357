"""Tests of proofs/paper/shortcut_metric.py on a small made-up torus: each condition can fail."""

import copy
import pathlib
import sys
import unittest
from fractions import Fraction

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[3] / "proofs" / "paper"))
import shortcut_metric  # noqa: E402

# The corners of a grid of 8 times 8 with its diagonals; the sampling radius is far too small for it, which is not what is tested.
SIDE = 8
CERTIFICATE = {
    "manifold": {"family": "flat-torus", "gram": [["1", "0"], ["0", "1"]]},
    "parameters": {"mode": "theory", "sampling_radius": "0x1p-6"},
    "levels": {"0": {"hypotheses_2": True}, "4": {}},
    "points": [[f"{i}/{SIDE}", f"{j}/{SIDE}"] for i in range(SIDE) for j in range(SIDE)],
    "simplices": [[SIDE * i + j, SIDE * ((i + 1) % SIDE) + (j + k) % SIDE, SIDE * ((i + k) % SIDE) + (j + 1) % SIDE, 0, 0]
                  for i in range(SIDE) for j in range(SIDE) for k in (0, 1)],
}
TENTH, FIFTH = Fraction(1, 10), Fraction(1, 5)


def failures(certificate=CERTIFICATE, length=TENTH, offset=FIFTH):
    return shortcut_metric.failures(certificate, length, offset)[0]


def altered(*path, value):
    certificate = copy.deepcopy(CERTIFICATE)
    inner = certificate
    for key in path[:-1]:
        inner = inner[key]
    inner[path[-1]] = value
    return certificate


class ShortcutMetric(unittest.TestCase):
    def test_all_conditions_hold(self):
        self.assertEqual(shortcut_metric.unfit(CERTIFICATE), "")
        self.assertEqual(failures(), [])

    def test_a_shortcut_that_is_no_shortcut(self):
        for length in (FIFTH, Fraction(1, 4), Fraction(0)):
            self.assertEqual(failures(length=length), ["the shortcut is not shorter than the way to the next point"])

    def test_a_torus_that_is_too_small(self):
        self.assertEqual(failures(altered("parameters", "sampling_radius", value="1/32")), ["d differs from the distance of the torus within 12ε"])

    def test_another_point_that_is_nearer(self):
        self.assertEqual(failures(altered("points", 9, value=["1/500", "0"])), ["another point of P′ is nearer"])

    def test_a_complex_with_the_edge(self):
        far = SIDE * 4 + 4
        self.assertEqual(failures(altered("simplices", 0, value=[0, far, 1, 0, 0])), ["the complex has the edge"])

    def test_certificates_of_another_kind(self):
        for certificate in (altered("manifold", "family", value="space-form"), altered("manifold", "gram", value=[["1", "0"], ["0", "2"]]),
                            altered("parameters", "mode", value="measured"), altered("levels", "0", value={}),
                            altered("levels", value={"0": {"hypotheses_2": True}})):
            self.assertNotEqual(shortcut_metric.unfit(certificate), "")

    def test_numbers_are_exact(self):
        self.assertEqual(shortcut_metric.number("0x3p-2"), Fraction(3, 4))
        self.assertEqual(shortcut_metric.number("-2/6"), Fraction(-1, 3))
        self.assertEqual(shortcut_metric.squared([Fraction(0), Fraction(1, 8)], [Fraction(7, 8), Fraction(0)]), Fraction(1, 32))


if __name__ == "__main__":
    unittest.main()
