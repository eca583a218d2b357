"""The list of built-in manifolds."""

import delcert
from cases import Case


class Manifolds(Case):
    def test_are_those_of_the_command(self):
        found = delcert.manifolds()
        self.assertGreater(len(found), 30)
        self.assertIn(("bolza-surface", 2), [(one.name, one.dimension) for one in found])
        self.assertTrue(all(one.about for one in found))

    def test_can_be_searched_for(self):
        names = [one.name for one in delcert.manifolds("lens")]
        self.assertIn("lens-space-5-2", names)
        self.assertNotIn("torus-2", names)
        self.message_of(delcert.MalformedInput, delcert.manifolds, "no such word")

    def test_names_can_be_completed(self):
        names = dir(delcert.manifold)
        self.assertEqual(len(names), len(delcert.manifolds()))
        for name in names:
            self.assertTrue(name.isidentifier(), name)
            self.assertEqual(getattr(delcert.manifold, name).name.replace("-", "_"), name)
        with self.assertRaises(AttributeError):
            delcert.manifold.tours_2

    def test_one_of_them_can_be_certified(self):
        one = delcert.certify(delcert.manifold.klein_bottle, radius="1/20", seed=1)
        self.assertEqual(one.manifold, "klein-bottle")

    def test_print_themselves(self):
        text, html = repr(delcert.manifolds("lens")), delcert.manifolds("lens")._repr_html_()
        self.assertEqual(len(text.splitlines()), 1 + len(delcert.manifolds("lens")))
        self.assertIn("<td", html)
        self.assertIn("lens-space-5-2", html)
