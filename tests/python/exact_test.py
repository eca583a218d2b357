"""Numbers: exact in, exact out."""

from fractions import Fraction

import delcert
import numpy
from cases import Case
from delcert.exact import exact_text, whole


class Exact(Case):
    def test_integers_fractions_and_texts_are_taken(self):
        for value, text in [(3, "3"), (Fraction(2, 8), "1/4"), ("13/500", "13/500"), ("0x1p-4", "0x1p-4"), (numpy.int64(7), "7")]:
            self.assertEqual(exact_text(value, "radius"), text)

    def test_a_float_is_refused_with_the_fraction_to_write(self):
        message = self.message_of(delcert.Usage, exact_text, 0.1, "radius")
        self.assertEqual(
            message,
            "radius = 0.1 is a float, and not 1/10 but 3602879701896397/36028797018963968: write Fraction(1, 10) or '1/10'",
        )
        self.assertIn("write Fraction(1, 4) or '1/4'", self.message_of(delcert.Usage, exact_text, numpy.float32(0.25), "radius"))
        self.assertEqual(self.message_of(delcert.Usage, exact_text, float("nan"), "radius"), "radius = nan is no exact number")

    def test_the_fraction_to_write_is_taken(self):
        value = 0.1
        message = self.message_of(delcert.Usage, exact_text, value, "radius")
        written = message.split("'")[-2]
        self.assertEqual(float(Fraction(exact_text(written, "radius"))), value)

    def test_what_is_no_number_is_refused(self):
        self.assertIn("write 1/10", self.message_of(delcert.Usage, exact_text, "0.1", "radius"))
        for value in (True, None, [1], 1j, "", "1/0", "one"):
            self.assertTrue(self.message_of(delcert.Usage, exact_text, value, "radius").startswith("radius"))

    def test_whole_numbers_have_their_range(self):
        self.assertEqual(whole(numpy.int32(5), "seed", 0, 5), 5)
        for value in (6, -1, 2.0, True, "3"):
            self.message_of(delcert.Usage, whole, value, "seed", 0, 5)
