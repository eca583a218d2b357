#!/usr/bin/env python3
"""Compares the quotations of the errata with the paper.

usage: quotations.py [--paper PAPER.tex [--write]] [--errata FOLDER] [--list FILE]

A quotation is what stands between “ and ” in a text of proofs/errata/*.toml. It has to occur in the paper, macros expanded,
within the `lines` of its entry; […] stands for something left out, and [label] for a reference. Spaces, brackets and
braces do not count, and a fraction a/b is \\frac{a}{b}. With --paper every quotation is looked up there; with --write the
list is written anew from those that are found. Without, every quotation has to be in the list, proofs/paper/quotations.tsv,
with its file and lines, and every row of the list in an entry. Every entry that is not "read: holds" quotes at least once,
and its `printed` has nothing but quotations and […] in it. Exit status 1 if a quotation is not found.
"""

import argparse
import pathlib
import re
import sys
import tomllib
import unicodedata

from coverage import lines_of

SYMBOLS = {
    "alpha": "α", "delta": "δ", "Delta": "Δ", "epsilon": "ε", "eta": "η", "Gamma": "Γ", "iota": "ι", "Lambda": "Λ", "mu": "μ",
    "nu": "ν", "phi": "φ", "varphi": "φ", "Phi": "Φ", "rho": "ρ", "sigma": "σ", "Sigma": "Σ", "tau": "τ", "Upsilon": "Υ",
    "xi": "ξ", "zeta": "ζ", "leq": "≤", "geq": "≥", "in": "∈", "subset": "⊂", "subseteq": "⊆", "cap": "∩", "cup": "∪",
    "setminus": "∖", "to": "→", "mapsto": "↦", "circ": "∘", "colon": ":", "times": "×", "cong": "≅", "partial": "∂", "sqrt": "√",
    "min": "min", "exp": "exp", "dim": "dim", "lvert": "|", "rvert": "|", "lVert": "‖", "rVert": "‖", "ldots": "…", "dagger": "†",
    "infty": "∞", "bigcup": "⋃", "#": "#", "{": "", "}": "", "left": "", "right": "", "quad": "", "qquad": "", ",": "",
    "-": "", " ": "", "\\": "", "item": "", "textbf": "", "emph": "", "text": "", "mathsf": "", "mathcal": "", "mathbb": "",
    "operatorname": "", "index": None, "label": None, "overline": None,
}
ACCENTS = {"tilde": "\u0303", "hat": "\u0302", "overline": "\u0305"}
LETTERS = {"mathcal": {"N": "𝒩", "S": "𝒮", "M": "M", "P": "𝒫"}, "mathbb": {"R": "ℝ"}}
SUPERSCRIPTS = dict(zip("⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻ᵐᵏʲⁿᵀ", "0123456789+−mkjnT"))
SUBSCRIPTS = dict(zip("₀₁₂₃₄₅₆₇₈₉", "0123456789"))


def group(text, at):
    """(contents, end) of the braces, or of the one token, that begin at text[at], blanks skipped."""
    while at < len(text) and (text[at].isspace() or ord(text[at]) >= Paper.FIRST):
        at += 1
    if at >= len(text):
        return "", at
    if text[at] == "{":
        depth, end = 0, at
        while end < len(text):
            if text[end] == "\\":
                end += 1
            elif text[end] == "{":
                depth += 1
            elif text[end] == "}":
                depth -= 1
                if depth == 0:
                    return text[at + 1:end], end + 1
            end += 1
        raise ValueError(f"braces: {text[at:at + 40]!r}")
    token = re.compile(r"\\(?:[a-zA-Z]+|.)|.", re.S).match(text, at)
    return token.group(0), token.end()


def definitions(paper):
    """name -> (number of arguments, body) of the macros that the paper defines; the last definition counts."""
    macros = {}
    for found in re.finditer(r"\\(?:re)?newcommand\{\\([a-zA-Z]+)\}(?:\[(\d)\])?|\\DeclareMathOperator\{\\([a-zA-Z]+)\}", paper):
        body, _ = group(paper, found.end())
        macros[found.group(1) or found.group(3)] = (int(found.group(2) or 0), body)
    return macros


def expand(text, macros, depth=0):
    if depth > 40:
        raise ValueError("macros without an end")
    out, at = "", 0
    for_command = re.compile(r"\\([a-zA-Z]+)")
    while True:
        found = for_command.search(text, at)
        if not found:
            return out + text[at:]
        out += text[at:found.start()]
        at = found.end()
        if found.group(1) not in macros:
            out += found.group(0)
            continue
        arguments, body = macros[found.group(1)]
        for number in range(1, arguments + 1):
            argument, at = group(text, at)
            body = body.replace(f"#{number}", argument)
        out += expand("{" + body + "}", macros, depth + 1)


def plain(text):
    """LaTeX without macros of the paper, as text with Unicode signs."""
    out, at = "", 0
    command = re.compile(r"\\(?:([a-zA-Z]+)|(.))", re.S)
    while at < len(text):
        if text[at] != "\\":
            out += text[at]
            at += 1
            continue
        found = command.match(text, at)
        name, at = found.group(1) or found.group(2), found.end()
        if name == "frac":
            above, at = group(text, at)
            below, at = group(text, at)
            out += plain(above) + "/" + plain(below)
        elif name in ACCENTS:
            under, at = group(text, at)
            under = plain(under).replace("{", "").replace("}", "").strip()
            out += under[:1] + ACCENTS[name] + under[1:]
        elif name in ("label", "index", "begin", "end", "hspace", "hfill"):
            if name != "hfill":
                _, at = group(text, at)
        elif name in ("ref", "eqref", "cite"):
            option = ""
            blank = re.compile(r"\s*\[([^\]]*)\]").match(text, at)
            if blank:
                option, at = ", " + blank.group(1), blank.end()
            label, at = group(text, at)
            out += "[" + label + option + "]"
        elif name in LETTERS:
            letter, at = group(text, at)
            out += LETTERS[name].get(letter, letter)
        elif name in SYMBOLS:
            out += SYMBOLS[name]
        else:
            out += name
    return out


def normal(text):
    """What is compared: no spaces, brackets or braces, one way to write primes, minus signs, indices and exponents."""
    text = re.sub(r"\b(Theorem|Lemma|Equation|Hypotheses|Definition|Section)~?\s*(?=\[)", "", text)
    text = unicodedata.normalize("NFD", text)
    out, last = "", ""
    for c in text:
        sort = "^" if c in SUPERSCRIPTS else "_" if c in SUBSCRIPTS else ""
        if sort and sort != last:
            out += sort
        last = sort
        out += SUPERSCRIPTS.get(c) or SUBSCRIPTS.get(c) or c
    out = out.replace("'", "′").replace("-", "−").replace("≅", "≅").replace("ℝ", "R").replace("ϵ", "ε")
    # A prime is written before an index and an accent next to its letter.
    out = re.sub(r"[\s{}()\[\]$~]+", "", out)
    out = re.sub(r"_([^\W_]+|.)′", lambda m: "′_" + m.group(1) if len(m.group(1)) == 1 else m.group(0), out)
    return out


class Paper:
    """The paper with its macros expanded; a sign at the beginning of each line says which line it is."""

    FIRST = 0xF0000

    def __init__(self, text):
        lines = [re.sub(r"(?<!\\)%.*", "", line) for line in text.split("\n")]
        macros = definitions("\n".join(lines))
        marked = "\n".join(chr(self.FIRST + number) + line for number, line in enumerate(lines, 1))
        self.whole = plain(expand(marked, macros))
        self.count = len(lines)

    def text(self, lines):
        """The normal form of the given lines, each run of consecutive ones a string."""
        runs = []
        for number in sorted(lines):
            if not runs or number != runs[-1][1] + 1:
                runs.append([number, number])
            runs[-1][1] = number
        texts = []
        for first, last in runs:
            begin = self.whole.find(chr(self.FIRST + first))
            end = len(self.whole) if last >= self.count else self.whole.find(chr(self.FIRST + last + 1), begin)
            texts.append(normal(re.sub("[\U000F0000-\U000FFFFF]", "", self.whole[begin:end])))
        return texts

    def has(self, quotation, lines):
        return any(quotation in text for text in self.text(lines))


def quotations_of(entry):
    """The pieces of what stands between “ and ” in the texts of an entry."""
    pieces = []
    for value in entry.values():
        if isinstance(value, str):
            for quotation in re.findall(r"“([^”]*)”", value):
                pieces += [piece.strip() for piece in quotation.split("[…]") if piece.strip()]
    return pieces


def words_between_quotations(text):
    """What a text has but quotations and […]."""
    return re.sub(r"“[^”]*”|\[…\]", "", text).strip()


def check(entries, known=None, paper=None):
    """(rows, complaints): the quotations of the entries, and those that neither the list nor the paper has."""
    rows, complaints = [], []
    for name, entry in sorted(entries.items()):
        quotations = quotations_of(entry)
        if not quotations and entry.get("kind") != "read: holds":
            complaints.append(f"{name}: quotes nothing")
        elif entry.get("kind") != "read: holds" and (words := words_between_quotations(entry["printed"])):
            complaints.append(f"{name}: printed has words that are not quoted: {words}")
        for quotation in quotations:
            row = (name, entry["lines"], normal(quotation))
            if paper is not None and not paper.has(row[2], lines_of(entry["lines"])):
                complaints.append(f"{name}: not in lines {entry['lines']} of the paper: {quotation}\n  as {row[2]}")
            if known is not None and row not in known:
                complaints.append(f"{name}: not in the list of quotations that were found: {quotation}")
            rows.append(row)
    if known is not None:
        complaints += [f"{row[0]}: in the list, and in no entry: {row[2]}" for row in known if row not in rows]
    return rows, complaints


def load(folder):
    entries = {}
    for path in sorted(folder.glob("*.toml")):
        with open(path, "rb") as file:
            entries[path.stem] = tomllib.load(file)
    return entries


def arguments_of(description, table):
    """The arguments of a program that compares the errata with the paper, or with a list, the file `table` beside this one."""
    here = pathlib.Path(__file__).resolve().parent
    parser = argparse.ArgumentParser(description=description.splitlines()[0])
    parser.add_argument("--paper", help="the LaTeX file")
    parser.add_argument("--write", action="store_true", help="write the list anew, from the paper")
    parser.add_argument("--errata", default=here.parent / "errata", help="the folder of the entries")
    parser.add_argument("--list", default=here / table, help="the list")
    arguments = parser.parse_args()
    if arguments.write and not arguments.paper:
        parser.error("--write needs --paper")
    return arguments


def main():
    arguments = arguments_of(__doc__, "quotations.tsv")
    entries, table = load(pathlib.Path(arguments.errata)), pathlib.Path(arguments.list)
    paper = Paper(pathlib.Path(arguments.paper).read_text(encoding="utf-8")) if arguments.paper else None
    known = None
    if not arguments.write:
        known = [tuple(row.split("\t")) for row in table.read_text(encoding="utf-8").splitlines()]
    rows, complaints = check(entries, known, paper)
    if arguments.write and not complaints:
        table.write_text("".join("\t".join(row) + "\n" for row in rows), encoding="utf-8")
    for complaint in complaints:
        print(complaint, file=sys.stderr)
    print(f"{len(rows)} quotations of {len(entries)} entries, {len(complaints)} complaints")
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
