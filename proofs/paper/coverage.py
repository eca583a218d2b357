#!/usr/bin/env python3
"""Says of every relation of the paper what re-checks it: a step, a claim, or why nothing does.

usage: coverage.py [--list] [--paper PAPER.tex]

Reads relations.tsv (what extract_relations.py lists), the claim files in proofs/claims/, and here claims.toml and
reasons.toml. A relation is mapped if its line is among the `lines` of a step of the paper or a mended one, or if a claim is
about a label that it stands under, or if claims.toml names a claim for its line, or else if reasons.toml gives a reason.
Prints the figures, and with --list every entry with what it is mapped to. Exit status 1 for each of: a relation that is
mapped to nothing; lines without a relation that have a reason or a claim; a claim that does not exist; with --paper a
table that is not what the script extracts. A statement in words has no relation sign and is not counted, but steps may
be about it.
"""

import argparse
import collections
import pathlib
import re
import sys
import tomllib

import extract_relations

Relation = collections.namedtuple("Relation", "line kind labels formula")


def lines_of(text):
    """The line numbers of "612-614, 640"."""
    lines = set()
    for part in text.split(","):
        match = re.fullmatch(r"\s*(\d+)(?:\s*-\s*(\d+))?\s*", part)
        if not match:
            raise ValueError(f"no line numbers: {text!r}")
        first, last = int(match.group(1)), int(match.group(2) or match.group(1))
        if last < first:
            raise ValueError(f"lines the wrong way round: {text!r}")
        lines.update(range(first, last + 1))
    return lines


def relations_of(table):
    relations = []
    for row in table.splitlines():
        line, kind, labels, formula = row.split("\t")
        relations.append(Relation(int(line), kind, () if labels == "-" else tuple(labels.split(",")), formula))
    return relations


def cover(relations, claim_files, named_claims, reasons):
    """(what each relation is mapped to or None, complaints) from data as in the TOML files."""
    steps, by_label, by_line, excuses = {}, {}, {}, {}
    complaints = []
    for stem, file in claim_files.items():
        status = file.get("status", "user")
        source = file.get("source", "")
        for label in re.findall(r"[a-z]+:[\w.]+", source):
            if "show" in file and status != "user":
                by_label.setdefault(label, stem)
        for step in file.get("step", []):
            # A sharper step is about what the paper could have claimed, and stands at no line of it.
            if step.get("status", status) not in ("user", "sharper"):
                for line in lines_of(step["lines"]):
                    steps.setdefault(line, f"{stem}/{step['name']}")
    for entry in named_claims:
        if entry["name"] not in claim_files:
            complaints.append(f"claims.toml: there is no claim {entry['name']}")
        for line in lines_of(entry["lines"]):
            by_line.setdefault(line, entry["name"])
    for entry in reasons:
        if not entry["reason"].strip():
            complaints.append(f"reasons.toml: no reason for {entry['lines']}")
        for line in lines_of(entry["lines"]):
            excuses.setdefault(line, entry["reason"])
    with_relation = {relation.line for relation in relations}
    for name, entries in (("reasons", reasons), ("claims", named_claims)):
        for part in ",".join(entry["lines"] for entry in entries).split(","):
            if entries and not lines_of(part) & with_relation:
                complaints.append(f"{name}.toml: no relation in line {part.strip()}")

    mapped = []
    for relation in relations:
        label = next((label for label in relation.labels if label in by_label), None)
        if relation.line in steps:
            mapped.append(("step", steps[relation.line]))
        elif label or relation.line in by_line:
            mapped.append(("claim", by_label[label] if label else by_line[relation.line]))
        elif relation.line in excuses:
            mapped.append(("reason", excuses[relation.line]))
        else:
            mapped.append(None)
            complaints.append(f"line {relation.line} is mapped to nothing: {relation.formula}")
    return mapped, complaints


def figures(mapped):
    count = collections.Counter(entry[0] for entry in mapped if entry)
    return (f"relations extracted {len(mapped)}, mapped {sum(count.values())} "
            f"(steps {count['step']}, claims {count['claim']}, reasons {count['reason']})")


def load(path):
    with open(path, "rb") as file:
        return tomllib.load(file)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--list", action="store_true", help="print every relation with what it is mapped to")
    parser.add_argument("--paper", help="the LaTeX file, to compare relations.tsv with")
    arguments = parser.parse_args()
    here = pathlib.Path(__file__).resolve().parent
    table = (here / "relations.tsv").read_text(encoding="utf-8")
    claim_files = {path.stem: load(path) for path in sorted((here.parent / "claims").glob("*.toml"))}
    relations = relations_of(table)
    mapped, complaints = cover(relations, claim_files, load(here / "claims.toml").get("claim", []),
                               load(here / "reasons.toml").get("reason", []))
    if arguments.paper:
        paper = pathlib.Path(arguments.paper).read_text(encoding="utf-8")
        if extract_relations.table(paper) != table:
            complaints.append("relations.tsv is not what extract_relations.py extracts from the paper")
    if arguments.list:
        for relation, entry in zip(relations, mapped):
            print(relation.line, relation.formula, *(entry or ("nothing",)), sep="\t")
    print(figures(mapped))
    for complaint in complaints:
        print(complaint, file=sys.stderr)
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
