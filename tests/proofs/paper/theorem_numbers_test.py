"""Tests of proofs/paper/theorem_numbers.py: labels get the numbers that LaTeX gives them."""

import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[3] / "proofs" / "paper"))
import theorem_numbers  # noqa: E402

PAPER = r"""\newtheorem{thm}{Theorem} %[section]
\newtheorem{lem}[thm]{Lemma}
\newtheorem{mainthm}{Theorem}
\begin{document}
\section{One}
\label{sec:one}
\begin{lem} no label \end{lem}
% \begin{lem} \label{lem:comment} \end{lem}
\begin{thm}[Name]
  \label{thm:a}
  \begin{enumerate} \item \label{item} \end{enumerate}
  \begin{equation} \label{eq:a} x \end{equation}
  \begin{equation*} y \end{equation*}
\end{thm}
\section{Two}
\subsection{Inner} \label{sec:inner}
\begin{mainthm} \label{thm:main} \label{thm:again} \end{mainthm}
\begin{figure} \label{fig:x} \end{figure}
\section{Three}
\subsection{Inner} \label{sec:last}
\begin{equation} \label{eq:b} z \end{equation}
\begin{lem} \label{lem:b} \end{lem}
\end{document}
"""


class Numbers(unittest.TestCase):
    def test_they_are_counted_as_latex_does(self):
        self.assertEqual(theorem_numbers.numbers_of(PAPER), {
            "sec:one": "Section 1", "thm:a": "Theorem 2", "eq:a": "Equation (1)", "sec:inner": "Section 2.1", "thm:main": "Theorem 1",
            "thm:again": "Theorem 1", "sec:last": "Section 3.1", "eq:b": "Equation (2)", "lem:b": "Lemma 3"})

    def test_a_number_that_is_wrong(self):
        numbers = theorem_numbers.numbers_of(PAPER)
        self.assertEqual(theorem_numbers.check({"one": {"label": "lem:b", "number": "Lemma 3"}}, numbers), [])
        self.assertEqual(theorem_numbers.check({"one": {"label": "lem:b", "number": "Lemma 4"}}, numbers),
                         ["one: lem:b is Lemma 3, not Lemma 4"])
        self.assertEqual(theorem_numbers.check({"one": {"label": "lem:b"}}, numbers), ["one: lem:b is Lemma 3, not None"])
        self.assertEqual(theorem_numbers.check({"one": {"label": "lem:c", "number": "Lemma 3"}}, numbers),
                         ["one: the paper has no label lem:c"])


class Errata(unittest.TestCase):
    """The twin of the test of the errata: each number of theirs, altered, is found out."""

    def test_every_number_can_fail(self):
        here = pathlib.Path(theorem_numbers.__file__).resolve().parent
        numbers = dict(row.split("\t") for row in (here / "theorem_numbers.tsv").read_text(encoding="utf-8").splitlines())
        entries = theorem_numbers.load(here.parent / "errata")
        self.assertGreater(len(entries), 30)
        self.assertEqual(theorem_numbers.check(entries, numbers), [])
        for name, entry in entries.items():
            wrong = {**entry, "number": entry["number"] + "1"}
            self.assertEqual(len(theorem_numbers.check({**entries, name: wrong}, numbers)), 1, name)


if __name__ == "__main__":
    unittest.main()
