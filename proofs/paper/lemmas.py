#!/usr/bin/env python3
"""Says how far each lemma and theorem of the paper is checked, and holds docs/paper-to-code.md to it.

usage: lemmas.py [--root FOLDER]

The table "How far each lemma is checked" has a row for every lemma and theorem of theorem_numbers.tsv, and its cells are
what the sources say: the theorems of Coq that the column *whole* names exist in proofs/formal, and docs/formal.md has each
of them with the label of the row; *steps* is `yes` if a claim file about the label has steps, *attacked* if one has a claim
that is not only a user's, *read* if an entry of proofs/errata is about it, else `–`. Exit status 1 if anything differs.
"""

import argparse
import pathlib
import re
import sys
import tomllib

HEADING = "## How far each lemma is checked"
COLUMNS = ["lemma", "whole", "steps", "attacked", "read"]


def rows_of(page):
    """label -> cells, from the table under the heading."""
    part = page.split(HEADING, 1)
    if len(part) != 2:
        raise ValueError(f"docs/paper-to-code.md: there is no {HEADING!r}")
    rows = {}
    lines = [line for line in part[1].split("\n## ")[0].splitlines() if line.startswith("|")]
    for number, line in enumerate(lines):
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        if number == 0 and cells != COLUMNS:
            raise ValueError(f"docs/paper-to-code.md: the columns are {cells}, not {COLUMNS}")
        if number < 2:
            continue
        label = cells[0].split(",")[0].split(" ")[0]
        if label in rows:
            raise ValueError(f"docs/paper-to-code.md: {label} has two rows")
        rows[label] = dict(zip(COLUMNS, cells))
    return rows


def complaints(page, formal_page, labels, theories, claims, errata):
    """What differs. theories: module -> text; claims and errata: lists of what the TOML files say."""
    result = []
    rows = rows_of(page)
    proved = {f"{module}.{name}" for module, text in theories.items()
              for name in re.findall(r"\b(?:Theorem|Lemma|Corollary)\s+(\w+)", text)}
    listed = {}
    for line in formal_page.splitlines():
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        if line.startswith("| `") and len(cells) >= 2:
            for name in re.findall(r"`([\w.]+)`", cells[0]):
                listed[name] = cells[1]
            if cells[0].count("`") and (not re.findall(r"`[\w]+\.[\w]+`", cells[0])):
                result.append(f"docs/formal.md: {cells[0]} names no theorem of a file")

    def about(label, entries, wanted):
        return any(label in re.findall(r"[a-z]+:[\w.]+", entry.get("source", "")) and wanted(entry) for entry in entries)

    for label in labels:
        if label not in rows:
            result.append(f"docs/paper-to-code.md: {label} has no row")
    for label, row in rows.items():
        if label not in labels:
            result.append(f"docs/paper-to-code.md: {label} is no lemma or theorem of the paper")
        names = re.findall(r"`([\w.]+)`", row["whole"])
        if not names and row["whole"] != "–":
            result.append(f"{label}: whole is {row['whole']!r}, which names no theorem; expected a theorem or –")
        for name in names:
            if name not in proved:
                result.append(f"{label}: no theorem of proofs/formal is called {name}")
            elif label not in listed.get(name, ""):
                result.append(f"{label}: docs/formal.md does not have {name} for it")
        expected = {"steps": about(label, claims, lambda c: c.get("step")),
                    "attacked": about(label, claims, lambda c: c.get("show") and c.get("status") != "user"),
                    "read": any(entry["label"] == label for entry in errata)}
        for column, holds in expected.items():
            if row[column] != ("yes" if holds else "–"):
                result.append(f"{label}: {column} is {row[column]!r}; expected {'yes' if holds else '–'}")
    return result


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--root", type=pathlib.Path, default=pathlib.Path(__file__).resolve().parents[2])
    root = parser.parse_args().root

    def toml(folder):
        return [tomllib.loads(path.read_text(encoding="utf-8")) for path in sorted((root / folder).glob("*.toml"))]

    numbers = (root / "proofs/paper/theorem_numbers.tsv").read_text(encoding="utf-8").splitlines()
    labels = [line.split("\t")[0] for line in numbers if re.match(r"(Lemma|Theorem) ", line.split("\t")[1])]
    # Another label of a lemma that has one is no lemma.
    labels = [label for label in labels if not label.endswith(".appdx")]
    theories = {path.stem: path.read_text(encoding="utf-8") for path in (root / "proofs/formal").glob("*.v")}
    found = complaints((root / "docs/paper-to-code.md").read_text(encoding="utf-8"),
                       (root / "docs/formal.md").read_text(encoding="utf-8"), labels, theories, toml("proofs/claims"),
                       toml("proofs/errata"))
    for complaint in found:
        print(complaint)
    print(f"{len(labels)} lemmas and theorems, {len(found)} complaints")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
