#!/usr/bin/env python3
"""What a family of manifolds of one's own took: number of files and lines, without blank lines and comments.

  bench/families.py             prints the table
  bench/families.py --write     writes it into docs/decisions/what-families-took.md, with the date
  bench/families.py --check     whether all patterns below still name files
"""

import datetime
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PAGE = ROOT / "docs" / "decisions" / "what-families-took.md"
MARKS = ("<!-- families: generated -->\n", "<!-- families: end -->")
COLUMNS = {"kernel": ["kernel/"], "certificate, report": ["proofs/cert"], "checker": ["proofs/checker/"], "tests": ["tests/"], "pages, examples": ["docs/", "examples/"]}

# A file belongs to the first family of which a pattern is in its path.
FAMILIES = {
    "meshes": [r"polyhedral_mesh", r"mesh_(charts|evaluation|neighbours|sampler)", r"shown_facet", r"facet_tree", r"triangle_mesh", r"manifold/mesh_file", r"mesh_family", r"cli/mesh", r"mesh_samples", r"surface_mesh", r"checker/submanifolds/polyhedron",
               r"full_stars"],
    "radii that vary": [r"sizing", r"sampling_radii", r"graded_", r"length_units"],
    "piecewise linear transitions": [r"piecewise_", r"map_piece", r"blended_", r"cone-torus"],
    "atlases by formulas": [r"gluing/(?!metric_field|affine|periodic|growing|interval_matrix|chart_distortion)", r"atlas_(file|net|claims|family|test|run)", r"glued", r"checker/(atlases/|certificate/gluing)",
                            r"rational_function", r"manifolds/atlases/", r"docs/.*atlases", r"torus_by_charts", r"affine_triangulation"],
    "zero sets": [r"submanifold(?!s-to-come)", r"kernel/formula/formula_(map|functions)", r"checker/(arithmetic/)?formula_map", r"tests/checker/chord_", r"graph_(simplex|triangulation|isotopy)",
                  r"restricted_delaunay", r"reach_bound",
                  r"examples/own/", r"bring-your-own", r"wrong_manifolds", r"wrong-files", r"oracles/(projection|critical|trefoil|flat_clifford)"],
}
FOLDERS = ["kernel", "proofs", "tests", "docs", "examples"]


def lines_of(path):
    count = 0
    for line in path.read_text(errors="replace").splitlines():
        text = line.strip()
        if text and not text.startswith(("//", "#!", "*")) and not (text.startswith("#") and path.suffix in (".toml", ".py", ".cmake")):
            count += 1
    return count


def measured():
    result = {family: {column: [0, 0] for column in COLUMNS} for family in FAMILIES}
    used = {(family, pattern): 0 for family, patterns in FAMILIES.items() for pattern in patterns}
    for folder in FOLDERS:
        for path in sorted((ROOT / folder).rglob("*")):
            name = path.relative_to(ROOT).as_posix()
            if not path.is_file() or path.suffix not in (".cpp", ".hpp", ".py", ".toml", ".md", ".txt"):
                continue
            column = next((column for column, starts in COLUMNS.items() if name.startswith(tuple(starts))), None)
            for family, patterns in FAMILIES.items():
                found = next((pattern for pattern in patterns if re.search(pattern, name)), None)
                if found is None or column is None:
                    continue
                used[family, found] += 1
                result[family][column][0] += 1
                result[family][column][1] += lines_of(path)
                break
    return result, [f"{family}: {pattern}" for (family, pattern), count in used.items() if count == 0]


def table(result):
    number = lambda x: f"{x:,}".replace(",", " ")
    text = "| | " + " | ".join(COLUMNS) + " | files | lines |\n|---|" + "--:|" * (len(COLUMNS) + 2) + "\n"
    for family in ["zero sets", "meshes", "radii that vary", "atlases by formulas", "piecewise linear transitions"]:
        cells = [f"{files}: {number(lines)}" if files else "–" for files, lines in result[family].values()]
        files, lines = (sum(cell[k] for cell in result[family].values()) for k in (0, 1))
        text += f"| {family} | " + " | ".join(cells) + f" | {files} | {number(lines)} |\n"
    return text


def main():
    result, unused = measured()
    if "--check" in sys.argv:
        for pattern in unused:
            print(f"names no file: {pattern}")
        sys.exit(1 if unused else 0)
    text = table(result)
    if "--write" in sys.argv:
        page = PAGE.read_text()
        begin, end = page.index(MARKS[0]) + len(MARKS[0]), page.index(MARKS[1])
        PAGE.write_text(page[:begin] + text + f"\nCounted on {datetime.date.today()}.\n" + page[end:])
    print(text, end="")


if __name__ == "__main__":
    main()
