#!/usr/bin/env python3
"""Lists the relations of the paper's LaTeX file, one line each: line number, displayed or text, labels, formula.

usage: extract_relations.py PAPER.tex > relations.tsv

A relation is a sign < > = and their kin anywhere in the mathematics of the document's body, and a sign of inclusion,
membership or isomorphism if there is a number beside it (an index is none) or it is displayed. The line is that of the
sign. Labels are those of the theorem and of the equation that it stands in, which is how a claim about a label covers
the lines of the statement. The formula identifies the entry; words in it are left out.
"""

import re
import sys

DISPLAYS = ("equation", "equation*", "displaymath", "align", "align*", "gather", "gather*", "multline", "multline*")
STATEMENTS = ("thm", "lem", "de", "mainthm", "hyps")
ORDER = (r"\\leq?(?![a-zA-Z])|\\geq?(?![a-zA-Z])|\\neq?(?![a-zA-Z])|\\ll(?![a-zA-Z])|\\gg(?![a-zA-Z])"
         r"|\\approx(?![a-zA-Z])|:=|<|>|=")
SETS = r"\\in(?![a-zA-Z])|\\subset(?:eq)?(?![a-zA-Z])|\\supset(?:eq)?(?![a-zA-Z])|\\cong(?![a-zA-Z])"
RELATION = re.compile(f"(?P<order>{ORDER})|(?P<set>{SETS})")
BREAK = re.compile(r"\\\\|\\q?quad(?![a-zA-Z])")


def without_comments(text):
    """The text with comments blanked, every line where it was."""
    return re.sub(r"(?<!\\)%[^\n]*", "", text)


def body(text):
    """The document's body at its place, definitions of macros blanked; all of the text if it has no \\begin{document}."""
    start = text.find(r"\begin{document}")
    if start >= 0:
        text = re.sub(r"[^\n]", " ", text[:start]) + text[start:]
    return re.sub(r"\\(re)?newcommand\{[^\n]*", "", text)


def matching_brace(text, opening):
    depth = 0
    for at in range(opening, len(text)):
        if text[at] in "{}" and text[at - 1] != "\\":
            depth += 1 if text[at] == "{" else -1
            if depth == 0:
                return at
    raise ValueError("a brace is not closed")


def without_words(formula):
    """The formula with labels, references and \\text{...} blanked, of the same length."""
    for command in (r"\text{", r"\label{", r"\ref{", r"\Lemref{"):
        at = formula.find(command)
        while at >= 0:
            end = matching_brace(formula, at + len(command) - 1) + 1
            blank = re.sub(r"[^\n]", " ", formula[at:end])
            if command == r"\text{" and re.search("[a-z]", formula[at + len(command):end]) and "\n" not in blank:
                blank = r"\quad".ljust(len(blank))
            formula = formula[:at] + blank + formula[end:]
            at = formula.find(command)
    return formula


def regions(text):
    """(kind, start, end) of all mathematics, in order."""
    token = re.compile(r"\\begin\{([a-z*]+)\}|\\end\{([a-z*]+)\}|(?<!\\)\$")
    found, opened, environment = [], None, None
    for match in token.finditer(text):
        begin, end = match.group(1), match.group(2)
        if environment:
            if end == environment:
                found.append(("displayed", opened, match.start()))
                environment, opened = None, None
        elif begin in DISPLAYS and opened is None:
            environment, opened = begin, match.end()
        elif match.group() == "$" and opened is None:
            opened = match.end()
        elif match.group() == "$":
            found.append(("text", opened, match.start()))
            opened = None
    if opened is not None:
        raise ValueError("mathematics that does not end")
    return found


def statements(text):
    """(start, end, labels) of the theorem-like environments."""
    found = []
    for match in re.finditer(r"\\begin\{(" + "|".join(STATEMENTS) + r")\}", text):
        end = text.index(r"\end{" + match.group(1) + "}", match.end())
        # Labels of items and equations inside belong to these.
        labels = re.findall(r"\\label\{((?:lem|de|def|thm|hyps):[^}]*)\}", text[match.end():end])
        found.append((match.start(), end, labels))
    return found


def has_number(formula):
    without_indices = re.sub(r"_(\{[^{}]*\}|\w)", "", formula)
    return re.search(r"\d", without_indices) is not None


def short(formula):
    formula = re.sub(r"\\begin\{[^}]*\}|\\end\{[^}]*\}|&|\\[,;!]", " ", formula)
    formula = re.sub(r"\\(left|right)(?![a-z])", "", formula)
    formula = re.sub(r"\s+", " ", formula).strip(" ,.;")
    return formula if len(formula) <= 100 else formula[:97] + "..."


def relations(text):
    """The entries (line, kind, labels, formula) of a LaTeX text."""
    text = body(without_comments(text))
    inside = statements(text)
    entries = []
    for kind, start, end in regions(text):
        labels = [label for first, last, names in inside if first <= start < last for label in names]
        if kind == "displayed":
            labels += re.findall(r"\\label\{([^}]*)\}", text[start:end])
        formula = without_words(text[start:end])
        signs = list(RELATION.finditer(formula))
        breaks = [match.span() for match in BREAK.finditer(formula)]
        for index, sign in enumerate(signs):
            left = max([0] + [s.end() for s in signs[:index]] + [b[1] for b in breaks if b[1] <= sign.start()])
            right = min([len(formula)] + [s.start() for s in signs[index + 1:]]
                        + [b[0] for b in breaks if b[0] >= sign.end()])
            entry = formula[left:right]
            if sign.group("set") and kind == "text" and not has_number(entry):
                continue
            line = text.count("\n", 0, start + sign.start()) + 1
            entries.append((line, kind, ",".join(labels) or "-", short(entry)))
    return entries


def table(text):
    return "".join("\t".join(map(str, entry)) + "\n" for entry in relations(text))


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("usage: extract_relations.py PAPER.tex > relations.tsv")
    with open(sys.argv[1], encoding="utf-8") as paper:
        sys.stdout.write(table(paper.read()))
