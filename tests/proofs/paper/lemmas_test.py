"""Tests of proofs/paper/lemmas.py: what the page says of a lemma is what the sources say, and anything else is found out."""

import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[3] / "proofs" / "paper"))
import lemmas  # noqa: E402

PAGE = """# Page

## How far each lemma is checked

| lemma | whole | steps | attacked | read |
|---|---|---|---|---|
| lem:one, quoted | `balls.first`, for μ₀ ≤ 1 | yes | – | yes |
| thm:two | – | – | yes | – |
"""
FORMAL = """| theorem | in the paper | what is shown |
|---|---|---|
| `balls.first`, `second` | lem:one | all |
"""
THEORIES = {"balls": "Theorem first n : n = n.\nLemma second : True."}
CLAIMS = [{"source": "Somebody, lem:one", "step": [{}]}, {"source": "thm:two", "show": [{}]},
          {"source": "lem:one", "show": [{}], "status": "user"}]
ERRATA = [{"label": "lem:one"}]


def complaints(page=PAGE, formal=FORMAL, labels=("lem:one", "thm:two"), theories=None, claims=None, errata=None):
    return lemmas.complaints(page, formal, list(labels), THEORIES if theories is None else theories,
                             CLAIMS if claims is None else claims, ERRATA if errata is None else errata)


class Lemmas(unittest.TestCase):
    def refused(self, words, **changed):
        found = complaints(**changed)
        self.assertTrue(any(words in complaint for complaint in found), found)

    def test_the_page_is_right(self):
        self.assertEqual(complaints(), [])

    def test_a_theorem_that_does_not_exist(self):
        self.refused("no theorem of proofs/formal is called balls.third", page=PAGE.replace("balls.first", "balls.third"))
        self.refused("no theorem of proofs/formal is called balls.first", theories={"balls": "Definition first := 1."})

    def test_a_theorem_of_another_lemma(self):
        self.refused("docs/formal.md does not have balls.first for it", formal=FORMAL.replace("lem:one", "lem:three"))

    def test_whole_without_a_theorem(self):
        self.refused("names no theorem", page=PAGE.replace("| thm:two | –", "| thm:two | yes"))

    def test_columns_that_say_too_much_or_too_little(self):
        self.refused("thm:two: steps is 'yes'", page=PAGE.replace("| thm:two | – | –", "| thm:two | – | yes"))
        self.refused("lem:one: steps is 'yes'", claims=CLAIMS[1:])
        self.refused("thm:two: attacked is 'yes'", claims=CLAIMS[:1])
        self.refused("lem:one: read is 'yes'", errata=[])
        self.refused("thm:two: read is '–'", errata=ERRATA + [{"label": "thm:two"}])

    def test_rows(self):
        self.refused("lem:three has no row", labels=("lem:one", "thm:two", "lem:three"))
        self.refused("thm:two is no lemma or theorem", labels=("lem:one",))
        with self.assertRaisesRegex(ValueError, "two rows"):
            complaints(page=PAGE + "| thm:two | – | – | yes | – |\n")
        with self.assertRaisesRegex(ValueError, "the columns are"):
            complaints(page=PAGE.replace("| read |", "| seen |"))
        with self.assertRaisesRegex(ValueError, "there is no"):
            complaints(page="# Page")


if __name__ == "__main__":
    unittest.main()
