"""Claims: attacked and tightened."""

import xml.etree.ElementTree
from fractions import Fraction

import delcert
from cases import SOURCE, Case

WRONG = dict(instance="simplex", show="circumradius(s) <= longest_edge(s)")
RIGHT = dict(instance="simplex", show="shortest_edge(s) <= longest_edge(s)")


class Claims(Case):
    def test_a_false_one_is_refuted_by_exact_vertices(self):
        found = delcert.Claim(**WRONG).attack(samples=1000, shapes=[(2, 2)])
        self.assertTrue(found.refuted)
        witness = found.witnesses[0]
        self.assertEqual(found.claim.verdict_on(witness), "refuted")
        self.assertEqual([len(vertex) for vertex in witness.vertices], [2, 2, 2])
        self.assertTrue(all(isinstance(x, Fraction) for vertex in witness.vertices for x in vertex))
        # R = abc/(4A), in squares, against the longest edge.
        p, q, r = witness.vertices
        a, b, c = (sum((x - y) ** 2 for x, y in zip(*pair)) for pair in ((p, q), (q, r), (r, p)))
        area = ((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])) / 2
        self.assertGreater(a * b * c / (16 * area**2), max(a, b, c))

    def test_a_true_one_is_not(self):
        found = delcert.Claim(**RIGHT).attack(samples=200, shapes=[(2, 2), (2, 3)], seed=5)
        self.assertFalse(found.refuted)
        self.assertEqual([(row["k"], row["m"], row["violated"]) for row in found.table], [(2, 2, 0), (2, 3, 0)])
        self.assertTrue(all(0 < row["held"] <= row["samples"] for row in found.table))
        self.assertTrue(all(row["worst_lower"] <= min(1, row["worst_upper"]) for row in found.table))

    def test_the_same_seed_finds_the_same_with_any_threads(self):
        claim = delcert.Claim(**WRONG)
        one, two = (claim.attack(samples=500, shapes=[(2, 2)], seed=3, threads=threads) for threads in (1, 2))
        self.assertEqual(one.witnesses[0].text, two.witnesses[0].text)
        self.assertEqual(list(one.table), list(two.table))
        self.assertNotEqual(list(one.table), list(claim.attack(samples=500, shapes=[(2, 2)], seed=4).table))

    def test_the_tightest_is_certified(self):
        claim = delcert.Claim(instance="simplex", show="circumradius(s) >= longest_edge(s)/2")
        found = claim.tighten(shape=(2, 2), evaluations=500)
        self.assertLess(0.9, found.lower)
        self.assertLessEqual(found.lower, found.upper)
        self.assertEqual(found.verdict, "proved")
        self.assertEqual(claim.verdict_on(found.witness), "proved")
        self.assertEqual(len(found.witness.vertices), 3)
        self.assertTrue(xml.etree.ElementTree.fromstring(found.witness._repr_svg_()).tag.endswith("svg"))
        self.assertEqual(found.witness.latex().count("p_{"), 3)
        self.message_of(delcert.Usage, claim.tighten, shape=(2, 2), conclusion="no such")

    def test_different_witnesses_are_drawn_differently(self):
        claim = delcert.Claim(**RIGHT)
        drawn = [claim.tighten(shape=shape, evaluations=50).witness._repr_svg_() for shape in ((3, 3), (1, 2), (2, 4))]
        self.assertEqual(len(set(drawn)), 3)

    def test_witnesses_are_files_of_the_programs(self):
        witness = delcert.Claim(**WRONG).attack(samples=1000, shapes=[(2, 2)]).witnesses[0]
        witness.save(self.folder / "w.json")
        read = delcert.Witness((self.folder / "w.json").read_text())
        self.assertEqual(read.vertices, witness.vertices)
        self.assertEqual(delcert.Claim(name="claim", **RIGHT).verdict_on(read), "proved")

    def test_a_file_and_a_name_of_the_library_are_claims(self):
        from_file = delcert.Claim(SOURCE / "examples" / "claims" / "circumradius-below-edge.toml")
        self.assertEqual(list(from_file.show.values()), ["circumradius(s) <= longest_edge(s)"])
        self.assertTrue(from_file.attack(samples=500, shapes=[(2, 2)]).refuted)
        known = delcert.Claim("thickness-and-singular-value")
        self.assertEqual(known.source, "lem:bound.skP")
        self.assertIn("\\", known.latex())
        self.assertIn("thickness-and-singular-value", [one["name"] for one in delcert.claims("thickness")])

    def test_hypotheses_and_parameters_are_those_given(self):
        claim = delcert.Claim(
            instance="simplex",
            forall={"a": "[1, 2]"},
            given=["k >= 2", {"name": "good", "claim": "is_nondegenerate(s)"}],
            show=[{"name": "edges", "claim": "shortest_edge(s) <= a*longest_edge(s)"}],
        )
        self.assertEqual(claim.given, ["k >= 2", "is_nondegenerate(s)"])
        self.assertEqual(claim.show, {"edges": "shortest_edge(s) <= a*longest_edge(s)"})
        self.assertFalse(claim.attack(samples=100, shapes=[(2, 2)]).refuted)

    def test_what_makes_no_sense_is_refused(self):
        self.assertIn("did you mean", self.message_of(delcert.MalformedInput, delcert.Claim, instance="simplex", show="circumradus(s) <= 1"))
        self.message_of(delcert.MalformedInput, delcert.Claim, "thickness-and-singular-valeu")
        self.message_of(delcert.MalformedInput, delcert.Claim, instance="simplices", show="0 < 1")
        self.message_of(delcert.Usage, delcert.Claim)
        self.message_of(delcert.Usage, delcert.Claim, instance="simplex", show=[3])
        claim = delcert.Claim(**RIGHT)
        self.message_of(delcert.MalformedInput, claim.attack, shapes=[(3, 2)])
        self.message_of(delcert.Usage, claim.attack, shapes=["2,2,2"])
        self.message_of(delcert.Usage, claim.attack, samples=0)
        self.message_of(delcert.Usage, claim.attack, samples=1.5)
        self.message_of(delcert.MalformedInput, delcert.claims, "no such word")

    def test_print_themselves(self):
        claim = delcert.Claim(**WRONG)
        found = claim.attack(samples=300, shapes=[(2, 2)])
        self.assertIn("show circumradius(s) <= longest_edge(s)", repr(claim))
        self.assertIn("REFUTED", repr(found))
        self.assertIn("<table>", found._repr_html_() + claim._repr_html_())
        self.assertEqual(len(repr(delcert.claims()).splitlines()), 1 + len(delcert.claims()))
