"""The paper's constants."""

from fractions import Fraction

import delcert
from cases import Case


class Constants(Case):
    def test_lie_between_their_bounds(self):
        found = delcert.constants(dim=2, separation=1)
        divisor = found["flake divisor"]
        # C = m^{3/2} (2/mu)^{4m^2 + 5m + 21}
        self.assertLess(divisor.lower**2, Fraction(2) ** 3 * Fraction(2) ** (2 * 47))
        self.assertGreater(divisor.upper**2, Fraction(2) ** 3 * Fraction(2) ** (2 * 47))
        self.assertLess(divisor.upper - divisor.lower, divisor.lower / 10**6)
        self.assertTrue(all(one.lower <= one.upper for one in found.values()))

    def test_depend_on_the_parameters_exactly(self):
        self.assertEqual(delcert.constants(2, Fraction(1, 2))["separation"].lower, Fraction(1, 2))
        self.assertNotEqual(
            delcert.constants(2, "1/2", perturbation="1/16")["flake_parameter"].lower,
            delcert.constants(2, "1/2")["flake_parameter"].lower,
        )

    def test_have_numbers_that_no_float_holds(self):
        tiny = delcert.constants(3, "1/4")["metric distortion bound"]
        self.assertGreater(tiny.lower, 0)
        self.assertLess(tiny.log2[1], -1074)
        self.assertIn("2^(-1556)", repr(tiny))
        self.assertRegex(repr(delcert.constants(3, "1/4")), "sphere_sample_size_estimate = about 2\\^5[0-9]{3}")

    def test_what_is_not_there_is_refused(self):
        with self.assertRaises(KeyError):
            delcert.constants(2, 1)["flake diviser"]
        self.message_of(delcert.Usage, delcert.constants, 2, 0.5)
        self.message_of(delcert.MalformedInput, delcert.constants, 0, 1)
        self.message_of(delcert.MalformedInput, delcert.constants, 2, 2)

    def test_print_themselves(self):
        found = delcert.constants(2, 1)
        self.assertEqual(len(repr(found).splitlines()), 1 + len(found))
        self.assertIn("hyps:param.bnds", found._repr_html_())
        self.assertTrue(found["flake divisor"]._repr_latex_().startswith("$C = "))
