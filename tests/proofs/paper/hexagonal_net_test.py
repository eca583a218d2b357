"""Tests of proofs/paper/hexagonal_net.py: each condition can fail."""

import pathlib
import sys
import unittest
from fractions import Fraction

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[3] / "proofs" / "paper"))
import hexagonal_net  # noqa: E402


class HexagonalNet(unittest.TestCase):
    def test_all_conditions_hold(self):
        for separation in ("161/100", "17/10", "173/100"):
            self.assertEqual(hexagonal_net.failures(Fraction(separation), 16), [])

    def test_a_smaller_separation_leaves_room(self):
        for separation in ("3/2", "8/5"):
            self.assertEqual(hexagonal_net.failures(Fraction(separation), 24), ["2α̃₀ < ρ₀: the circle leaves room"])

    def test_an_input_that_does_not_meet_the_hypotheses(self):
        self.assertEqual(hexagonal_net.failures(Fraction("174/100"), 16), ["the lattice is not ε-dense"])
        self.assertEqual(hexagonal_net.failures(Fraction("17/10"), 14), ["a period is shorter than 24ε"])

    def test_the_tolerance_is_that_of_the_paper(self):
        # m = 2: 2¹⁷(μ₀/2)⁴⁷/μ₀³ = 2⁻³⁰μ₀⁴⁴
        for separation in (Fraction(1), Fraction(17, 10)):
            self.assertEqual(hexagonal_net.tolerance(separation), separation**44 / 2**30)

    def test_neighbours_are_at_distance_one(self):
        self.assertEqual([hexagonal_net.squared(each) for each in hexagonal_net.NEIGHBOURS], [1] * 6)


if __name__ == "__main__":
    unittest.main()
