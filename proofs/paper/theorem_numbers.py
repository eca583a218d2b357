#!/usr/bin/env python3
"""Compares the theorem numbers of the errata with those that LaTeX gives to the paper's labels.

usage: theorem_numbers.py [--paper PAPER.tex [--write]] [--errata FOLDER] [--list FILE]

`number` of an entry of proofs/errata, "Lemma 9" or "Section 3.2", has to be what is printed where its `label` is referred
to. With --paper the numbers are counted there, as LaTeX counts them, and compared with the list, proofs/paper/theorem_numbers.tsv;
with --write the list is written anew. Without, the list decides. Exit status 1 if a number is wrong.
"""

import pathlib
import re
import sys

from quotations import arguments_of, load


def theorem_environments(paper):
    """environment -> (counter, name) as the preamble declares them."""
    environments = {}
    for name, shared, title in re.findall(r"\\newtheorem\{(\w+)\}(?:\[(\w+)\])?\{(\w+)\}", paper):
        environments[name] = (shared or name, title)
    return environments


def numbers_of(paper):
    """label -> what is printed where the paper refers to it, for sections, equations and what is like a theorem."""
    paper = "\n".join(re.sub(r"(?<!\\)%.*", "", line) for line in paper.split("\n"))
    environments = theorem_environments(paper)
    counters, numbers, inside, section = {}, {}, [], None

    def count(counter):
        counters[counter] = counters.get(counter, 0) + 1
        return counters[counter]

    for found in re.finditer(r"\\(begin|end|label)\{([\w:.*]+)\}|\\(section|subsection)\{", paper):
        command, argument, heading = found.groups()
        if heading == "section":
            section, counters["subsection"] = f"Section {count('section')}", 0
        elif heading == "subsection":
            section = f"Section {counters['section']}.{count('subsection')}"
        elif command == "begin":
            if argument == "equation":
                inside.append((argument, f"Equation ({count('equation')})"))
            elif argument in environments:
                counter, title = environments[argument]
                inside.append((argument, f"{title} {count(counter)}"))
            elif argument in ("enumerate", "itemize", "figure"):
                inside.append((argument, None))
        elif command == "end":
            if inside and inside[-1][0] == argument:
                inside.pop()
        else:
            number = inside[-1][1] if inside else section
            if number:
                numbers[argument] = number
    return numbers


def check(entries, numbers):
    """Complaints about entries whose number is not that of their label."""
    complaints = []
    for name, entry in sorted(entries.items()):
        wanted = numbers.get(entry["label"])
        if wanted is None:
            complaints.append(f"{name}: the paper has no label {entry['label']}")
        elif entry.get("number") != wanted:
            complaints.append(f"{name}: {entry['label']} is {wanted}, not {entry.get('number')}")
    return complaints


def main():
    arguments = arguments_of(__doc__, "theorem_numbers.tsv")
    table, complaints = pathlib.Path(arguments.list), []
    if arguments.paper:
        counted = numbers_of(pathlib.Path(arguments.paper).read_text(encoding="utf-8"))
        if arguments.write:
            table.write_text("".join(f"{label}\t{number}\n" for label, number in counted.items()), encoding="utf-8")
    numbers = dict(row.split("\t") for row in table.read_text(encoding="utf-8").splitlines())
    if arguments.paper and numbers != counted:
        complaints.append(f"{table.name}: not the numbers of the paper")
    entries = load(pathlib.Path(arguments.errata))
    complaints += check(entries, numbers)
    for complaint in complaints:
        print(complaint, file=sys.stderr)
    print(f"{len(numbers)} labels, {len(entries)} entries, {len(complaints)} complaints")
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
