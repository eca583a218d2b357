"""Tests of proofs/paper/quotations.py: a quotation that is altered by one sign is found out."""

import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[3] / "proofs" / "paper"))
import quotations  # noqa: E402

PAPER = r"""\newcommand{\eps}{\epsilon}
\newcommand{\trans}[2]{\varphi_{#2 #1}} % from #1 to #2
\newcommand{\transij}{\trans{i}{j}}
\newcommand{\pts}{\mathsf{P}}
\DeclareMathOperator{\starr}{star}
\newcommand{\Lemref}[1]{Lemma~\ref{#1}}
\newcommand{\abs}[1]{\lvert#1\rvert}
\begin{lem}
  Let $\tilde{\pts}'_i$ be $\eps_0$-dense, % and not sparse
  where $\abs{\transij(x) -
    y} \leq \frac{1}{2^{12}} \left( \frac{\eps}{C} \right)^{2m+1}$.
\end{lem}
By \Lemref{lem:x} and \cite[Thm. 4]{someone} the \emph{star} $\starr(p)$ is \textbf{small}.
""".replace("\n\\begin{lem}", "\n\\begin{lem}\\label{lem:x}")

ENTRY = {"kind": "misprint", "lines": "8-13",
         "printed": "“Let P̃′_i be ε₀-dense” […] “|φ_ji(x) − y| ≤ 1/2^12 (ε/C)^{2m+1}”",
         "wrong": "“By [lem:x] […] star(p) is small.”"}


def complaints(entry, paper=PAPER, known=None):
    return quotations.check({"one": entry}, known, quotations.Paper(paper) if paper else None)[1]


def altered(old, new):
    return {key: value.replace(old, new) for key, value in ENTRY.items()}


class Quotations(unittest.TestCase):
    def test_macros_are_expanded(self):
        self.assertEqual(complaints(ENTRY), [])

    def test_what_is_left_out_parts_a_quotation(self):
        self.assertEqual(len(quotations.quotations_of(ENTRY)), 4)

    def test_a_quotation_that_is_not_in_the_paper(self):
        for old, new in (("φ_ji", "φ_ij"), ("2^12", "2^13"), ("≤", "<"), ("P̃′", "P′"), ("P̃′", "P̃"), ("ε₀", "ε"), ("2m+1", "2m+2"),
                         ("dense", "dense and not sparse"), ("lem:x", "lem:y"), ("small", "smaller")):
            found = complaints(altered(old, new))
            self.assertEqual(len(found), 1, (old, new))
            self.assertIn("not in lines 8-13 of the paper", found[0])

    def test_a_quotation_from_other_lines(self):
        self.assertEqual(len(complaints(altered("8-13", "8-10"))), 3)
        self.assertEqual(len(complaints(altered("8-13", "8-10, 13"))), 1)

    def test_an_entry_without_a_quotation(self):
        entry = {"kind": "misprint", "lines": "8", "printed": "ε₀", "wrong": "ε"}
        self.assertEqual(complaints(entry), ["one: quotes nothing"])
        self.assertEqual(complaints({**entry, "kind": "read: holds"}), [])

    def test_printed_is_quoted_and_no_more(self):
        self.assertEqual(complaints(altered("2m+1}”", "2m+1}” and more")), ["one: printed has words that are not quoted: and more"])
        self.assertEqual(complaints(altered("“Let P̃′_i", "Let “P̃′_i")), ["one: printed has words that are not quoted: Let"])
        self.assertEqual(complaints({"kind": "read: holds", "lines": "8", "printed": "All is small.", "wrong": "It is."}), [])

    def test_without_the_paper_the_list_decides(self):
        rows, _ = quotations.check({"one": ENTRY})
        self.assertEqual(complaints(ENTRY, None, rows), [])
        found = complaints(altered("2^12", "2^13"), None, rows)
        self.assertEqual(len(found), 2)
        self.assertIn("not in the list", found[0])
        self.assertIn("in no entry", found[1])
        self.assertEqual(len(complaints(altered("8-13", "8-14"), None, rows)), 8)

    def test_braces_that_do_not_match(self):
        with self.assertRaises(ValueError):
            quotations.Paper("\\newcommand{\\x}[1]{#1}\n\\x{y")


class Errata(unittest.TestCase):
    """The twin of the test of the errata: each quotation of theirs, altered by a sign, is found out."""

    def test_every_quotation_can_fail(self):
        here = pathlib.Path(quotations.__file__).resolve().parent
        entries = quotations.load(here.parent / "errata")
        known = [tuple(row.split("\t")) for row in (here / "quotations.tsv").read_text(encoding="utf-8").splitlines()]
        self.assertEqual(quotations.check(entries, known)[1], [])
        self.assertGreater(len(known), 50)
        for name, entry in entries.items():
            for quotation in quotations.quotations_of(entry):
                wrong = {key: value.replace(quotation, quotation + "x") if isinstance(value, str) else value
                         for key, value in entry.items()}
                self.assertNotEqual(quotations.check({**entries, name: wrong}, known)[1], [], quotation)


if __name__ == "__main__":
    unittest.main()
