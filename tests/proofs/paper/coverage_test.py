"""What the extraction finds in a small LaTeX text, and that gaps and idle entries of the mapping are noticed."""

import pathlib
import re
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[3] / "proofs" / "paper"))
import coverage  # noqa: E402
import extract_relations  # noqa: E402

PAPER = r"""$before < document$
\begin{document}
\newcommand{\x}{$a = b$}
% $commented \leq out$, but 100\% is not
If $r = 6 s$, then $p \in B(c, 6 r)$ and $p_0 \in \sigma$,
\begin{lem}
  \label{lem:one}
  \begin{equation}
    \label{eq:two}
    a < b \quad \text{and for $n$ words}
    \quad c \leq d = \text{PL}
  \end{equation}
\end{lem}
\begin{equation*}
  \begin{split}
    x &\leq \left( y \right)\\
      &\neq z, \langle p, q \rangle.
  \end{split}
\end{equation*}
"""


class Extraction(unittest.TestCase):
    def test_relations_with_their_lines_and_labels(self):
        self.assertEqual(extract_relations.relations(PAPER), [
            (5, "text", "-", "r = 6 s"),
            (5, "text", "-", r"p \in B(c, 6 r)"),
            (10, "displayed", "lem:one,eq:two", "a < b"),
            (11, "displayed", "lem:one,eq:two", r"c \leq d"),
            (11, "displayed", "lem:one,eq:two", "d ="),
            (16, "displayed", "-", r"x \leq ( y )"),
            (17, "displayed", "-", r"\neq z, \langle p, q \rangle"),
        ])

    def test_mathematics_that_does_not_end(self):
        with self.assertRaises(ValueError):
            extract_relations.relations(r"if $a < b then")


def relations():
    return coverage.relations_of(extract_relations.table(PAPER))


CLAIMS = {
    "one": {"status": "paper", "source": "lem:one", "show": [{}]},
    "mine": {"status": "user", "step": [{"name": "idle", "lines": "17"}]},
    "three": {"status": "paper", "show": [{}], "step": [{"name": "last", "lines": "16-17"}]},
}
REASONS = [{"lines": "5", "reason": "a definition"}]


class Mapping(unittest.TestCase):
    def test_all_is_mapped(self):
        mapped, complaints = coverage.cover(relations(), CLAIMS, [], REASONS)
        self.assertEqual(complaints, [])
        self.assertEqual(coverage.figures(mapped), "relations extracted 7, mapped 7 (steps 2, claims 3, reasons 2)")
        self.assertEqual(mapped[-1], ("step", "three/last"))

    def test_a_claim_for_a_line(self):
        mapped, complaints = coverage.cover(relations(), CLAIMS, [{"name": "three", "lines": "5"}], [])
        self.assertEqual(complaints, [])
        self.assertEqual(mapped[0], ("claim", "three"))

    def test_an_unmapped_line(self):
        without_step = {stem: file for stem, file in CLAIMS.items() if stem != "three"}
        mapped, complaints = coverage.cover(relations(), without_step, [], REASONS)
        self.assertEqual(mapped[-2:], [None, None])
        self.assertEqual(len(complaints), 2)
        self.assertIn("line 16 is mapped to nothing", complaints[0])

    def test_a_reason_for_no_relation(self):
        _, complaints = coverage.cover(relations(), CLAIMS, [], REASONS + [{"lines": "12", "reason": "none"}])
        self.assertEqual(complaints, ["reasons.toml: no relation in line 12"])

    def test_a_reason_that_is_none(self):
        _, complaints = coverage.cover(relations(), CLAIMS, [], [{"lines": "5", "reason": " "}])
        self.assertEqual(complaints, ["reasons.toml: no reason for 5"])

    def test_a_claim_that_does_not_exist(self):
        _, complaints = coverage.cover(relations(), CLAIMS, [{"name": "four", "lines": "5"}], REASONS)
        self.assertEqual(complaints, ["claims.toml: there is no claim four"])

    def test_a_claim_for_no_relation(self):
        _, complaints = coverage.cover(relations(), CLAIMS, [{"name": "one", "lines": "6"}], REASONS)
        self.assertEqual(complaints, ["claims.toml: no relation in line 6"])

    def test_lines(self):
        self.assertEqual(coverage.lines_of("612-614, 640"), {612, 613, 614, 640})
        for wrong in ("", "12-", "14-12", "a"):
            with self.assertRaises(ValueError):
                coverage.lines_of(wrong)


def missing_steps(text, claim_files):
    """The steps that a text names as claim/step and that do not exist."""
    named = re.findall(r"\b([a-z][a-z0-9-]*)/([a-z][a-z0-9-]*)\b", text)
    return [f"{claim}/{step}" for claim, step in named
            if claim in claim_files and step not in [one["name"] for one in claim_files[claim].get("step", [])]]


class Findings(unittest.TestCase):
    def test_steps_that_findings_name_exist(self):
        proofs = pathlib.Path(coverage.__file__).resolve().parents[1]
        claim_files = {path.stem: coverage.load(path) for path in (proofs / "claims").glob("*.toml")}
        for path in sorted((proofs / "errata").glob("*.toml")):
            finding = coverage.load(path)
            text = " ".join(value for value in finding.values() if isinstance(value, str))
            self.assertEqual(missing_steps(text, claim_files), [], path.name)

    def test_a_step_that_does_not_exist(self):
        self.assertEqual(missing_steps("three/last, three/first, u/v", CLAIMS), ["three/first"])


if __name__ == "__main__":
    unittest.main()
