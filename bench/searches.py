#!/usr/bin/env python3
"""The pages of docs/tables that directed searches fill: how tight bounds are, their exponents, the power of attacks.

  bench/searches.py measure [--build build/release] [--only NAME]…   runs the searches, writes the records and the pages
  bench/searches.py render [--build build/release]                    the pages again from the records
  bench/searches.py check [--build build/release]                     whether the pages are those of the records, and the
                                                                      claims those of which the records are

NAME is a key of PLAN; without --only all of them run, which takes hours. With --logs, a folder, tighten goes on from
what it has finished. The records are docs/tables/{tightness,exponents,power}.json, and searches.json, which has the SHA-256
of what each claim said when it was searched, and what a few cheap searches found then: a page says so if the program
finds something else now.
"""

import argparse
import hashlib
import json
import subprocess
import sys
import tomllib
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
TABLES = ROOT / "docs/tables"
CLAIMS = ROOT / "proofs/claims"

SIMPLICES = ["circumradius-under-distortion", "circumscribing-balls-under-distortion"]
SHAPES = [part for k in range(1, 6) for part in ("--shape", f"{k},{k}")]
SLIVERS = [part for k in range(2, 4) for part in ("--shape", f"{k},{k}")]
HOOPS = ["--shape", "2,2", "--shape", "3,3", "--seed", "1", "--evaluations", "100"]
CHARTS = ["exponential-chart-distances", "exponential-chart-distances-sharper", "exponential-chart-transitions",
          "exponential-chart-transitions-sharper"]
SHARPER = ["thickness-under-distortion-sharper", "circumradius-under-distortion-sharper",
           "circumscribing-balls-under-distortion-sharper", "circumcentres-under-distortion-sharper", "crude-circumradius-bound-sharper"]
THIN = "1/4,1/8,1/16,1/32,1/64,1/128"
SMALL = "1/1024,1/4096,1/16384,1/65536,1/262144"
# By the name of the searches: the file of the record, and the command.
PLAN = {
    "tightness": ("tightness", ["tighten", "--all", "--seed", "1", "--evaluations", "2000"]),
    "deep-circumradii": ("tightness", ["tighten", "circumradius-under-distortion", "--shape", "3,3", "--shape", "4,4", "--shape", "5,5",
                                       "--seed", "1", "--evaluations", "100000"]),
    "balls": ("tightness", ["tighten", "circumscribing-balls-under-distortion", "--shape", "3,3", "--shape", "4,4", "--shape", "5,5",
                            "--seed", "1", "--evaluations", "2000"]),
    "tightness-hoops": ("tightness", ["tighten", "raw-hoop-distortion", "--seed", "1", "--evaluations", "300"]),
    "tightness-charts": ("tightness", ["tighten", *CHARTS, "curved-hoop-distortion", "curved-raw-hoop-distortion", "--seed", "1",
                                       "--evaluations", "2000"]),
    "tightness-sharper": ("tightness", ["tighten", *SHARPER, *SHAPES, "--seed", "1", "--evaluations", "2000"]),
    "tightness-sharper-hoops": ("tightness", ["tighten", "raw-hoop-distortion-sharper", "hoop-distortion-sharper", "--shape", "2,2",
                                              "--shape", "3,3", "--seed", "1", "--evaluations", "500"]),
    "exponents-thickness": ("exponents", ["tighten", *SIMPLICES, *SLIVERS, "--seed", "1", "--evaluations", "2000",
                                          "--along", "thickness(s)", "--values", THIN]),
    "exponents-distortion": ("exponents", ["tighten", *SIMPLICES, *SLIVERS, "--seed", "1", "--evaluations", "500",
                                           "--along", "xi", "--values", SMALL]),
    "exponents-dimension": ("exponents", ["tighten", *SIMPLICES, *SHAPES, "--seed", "1", "--evaluations", "1000", "--along", "k"]),
    "exponents-hoops": ("exponents", ["tighten", "raw-hoop-distortion", "--shape", "2,2", "--seed", "1", "--evaluations", "200",
                                      "--along", "gamma0", "--values", "1/1048576,1/4194304,1/16777216,1/67108864"]),
    "power-simplices": ("power", ["power", "circumradius-under-distortion", "circumradius-under-distortion-sharper",
                                  "circumscribing-balls-under-distortion", "circumscribing-balls-under-distortion-sharper",
                                  "thickness-under-distortion", "crude-circumradius-bound",
                                  "--shape", "1,1", "--shape", "2,2", "--shape", "3,3", "--seed", "1", "--evaluations", "1000"]),
    "power-hoops": ("power", ["power", "raw-hoop-distortion", *HOOPS]),
    "power-other-hoops": ("power", ["power", "raw-hoop-distortion-sharper", "hoop-distortion", "hoop-distortion-sharper", *HOOPS]),
    "power-stars": ("power", ["power", "stable-stars", "delaunay-metric-stability", "--shape", "2", "--seed", "1",
                              "--evaluations", "2000"]),
    "power-charts": ("power", ["power", *CHARTS, "--shape", "2", "--seed", "1", "--evaluations", "2000"]),
    "power-curved": ("power", ["power", "curved-stable-stars", "curved-delaunay-complex", "--shape", "2", "--seed", "1",
                               "--evaluations", "2000"]),
}
# Claims that are no statements of the paper, but readings of some.
READINGS = ["circumcentres-under-distortion", "top-simplices-suffice"]
CANARIES = ["tighten", "circumradius-under-distortion", "circumscribing-balls-under-distortion", "raw-hoop-distortion",
            "thickness-and-singular-value", "--shape", "2,2", "--seed", "1", "--evaluations", "40", "--json"]


def run(build, arguments):
    done = subprocess.run([build / "apps/delcert", *arguments], capture_output=True, text=True)
    if done.returncode not in (0, 1, 2):
        sys.exit(f"{' '.join(map(str, arguments))}: exit status {done.returncode}\n{done.stderr}")
    return done.stdout


def statement_hash(name):
    """Of what a claim says: not of its twins, reasons, steps and notes."""
    claim = tomllib.loads((CLAIMS / f"{name}.toml").read_text())
    given = [one if isinstance(one, str) else one["claim"] for one in claim.get("given", [])]
    show = [[one.get("name"), one["claim"], one.get("base")] for one in claim.get("show", [])]
    said = [claim.get("instance"), claim.get("forall"), claim.get("let"), claim.get("points"), given, show]
    return hashlib.sha256(json.dumps(said, sort_keys=True).encode()).hexdigest()


def read(name):
    file = TABLES / f"{name}.json"
    return json.loads(file.read_text()) if file.exists() else []


def write(name, content):
    (TABLES / f"{name}.json").write_text(json.dumps(content, indent=2 if name == "power" else 1, ensure_ascii=False) + "\n")


def search_key(row):
    return [row["claim"], row.get("along", ""), row.get("k", 0), row.get("m", 0)]


def merged(old, new):
    """The new rows in the place of those of the same searches; a ratio from more evaluations stays."""
    more = {str(search_key(row)) for row in old for other in new if search_key(row) == search_key(other) and "lower" in row
            and row["evaluations"] > other.get("evaluations", 0)}
    new = [row for row in new if str(search_key(row)) not in more]
    replaced = {str(search_key(row)) for row in new}
    kept = [row for row in old if str(search_key(row)) not in replaced]
    searched = {row["claim"] for row in new}
    result = []
    for claim in dict.fromkeys(row["claim"] for row in [*old, *new]):
        rows = [row for row in [*kept, *new] if row["claim"] == claim]
        result += sorted(rows, key=search_key) if claim in searched else rows
    return result


def canaries(build):
    return [[row["claim"], row["conclusion"], row.get("lower")] for row in json.loads(run(build, CANARIES))]


def measure(build, only, logs):
    record = json.loads((TABLES / "searches.json").read_text()) if (TABLES / "searches.json").exists() else {}
    for name in only or PLAN:
        file, command = PLAN[name]
        log = ["--log", str(logs / f"{name}.jsonl")] if logs and command[0] == "tighten" and "--along" not in command else []
        rows = json.loads(run(build, [*command, *log, "--json"]))
        write(file, merged(read(file), rows))
        record[name] = {"claims": {claim: statement_hash(claim) for claim in sorted({row["claim"] for row in rows})},
                        "canaries": canaries(build)}
        write("searches", record)
    render(build)


# Pages

TIGHTNESS_HEAD = """# How tight

For each conclusion in each shape the worst ratio, of the smaller side to the larger one, that a directed search found: random and
structured instances, then local searches from the best of them ([attacks.md](../attacks.md#by-how-much-would-a-constant-have-to-be-wrong)).
The ratio is certified, the lower end of an interval; that there is no worse instance is not. Above 1 the statement is refuted. Where a conclusion declares a base, it is
the ratio of what both sides exceed that by, negative if the smaller side stays below it. *Equality, exactly*: both sides are
the same number, decided exactly; a ratio printed as 1 without that note is within 10⁻⁹ of it. With `--witnesses` the commands write
the instances, exactly. `tightness.json` has what they print, of two searches of the same conclusion the one with more instances
(fewer than asked for where an instance is costly):

@COMMANDS@
`bench/searches.py measure` runs them and writes this page.

*Reading refuted* is said of two claims that are no statements of the paper: circumcentres-under-distortion is lem:bound.cc
without C(σ) ∈ U, which the lemma takes for granted, so that nothing holds the image of C(σ); and top-simplices-suffice is about
diametric spheres where the paper speaks of circumspheres ([printed-algorithm.md](../claims/printed-algorithm.md)).
"""
EXPONENTS_HEAD = """# Exponents

A bound that is a product of powers has an exponent for each quantity. For some values of a quantity a directed search looked for the
worst instance on which it has nearly this value (up to 9/8 times), and the slope of log(worst ratio) against log(quantity) was fitted:
so much is the exponent of what was found off the exponent in the bound. ± is the standard error of the slope, *residual* the largest
distance of a point from the line, as a binary logarithm, and *values* the number at which an instance was found. The ratios are
certified, but that there are no worse instances is not, and the line through them is a fit; an exponent of what was found that differs
from the printed one says what these searches found, and proves nothing. A quantity that the bound does not contain has the exponent 0;
*other*: the bound is no product of powers of it.

@COMMANDS@
`bench/searches.py measure` runs them and writes this page; `exponents.json` has all points.
"""


def searches_of(file):
    """Those behind a record, the widest first: it was begun before there was searches.json, so it may not be named there."""
    known = json.loads((TABLES / "searches.json").read_text())
    return [name for name, plan in PLAN.items() if plan[0] == file and (name in known or name == file)]


def command_text(names):
    lines = []
    for name in names:
        line = "delcert"
        for part in [f"'{part}'" if "(" in part else part for part in PLAN[name][1]] + ["--json"]:
            if len(line) + len(part) > 116:
                lines.append(line + " \\")
                line = "   "
            line += " " + part
        lines.append(line)
    return "```\n" + "\n".join(lines) + "\n```"


def number(x):
    return f"{x:.9g}" if x is not None else "–"


def age_note(names, now):
    record = json.loads((TABLES / "searches.json").read_text())
    old = [name for name in names if record.get(name, {}).get("canaries") != now]
    commands = " and ".join(f"number {1 + names.index(name)}" for name in old)
    return f"\nOf these commands the program finds something else now: {commands}; their rows are older.\n" if old else ""


def note(row):
    text = row.get("note", "no instance with a ratio")
    return "reading refuted" if text == "REFUTED" and row["claim"] in READINGS else text


def dimensions(row):
    return f"m={row['m']}" if row["k"] == 0 else f"k={row['k']} m={row['m']}"


def tightness_page(now):
    rows = read("tightness")
    text = TIGHTNESS_HEAD.replace("@COMMANDS@", command_text(searches_of("tightness")))
    text += age_note(searches_of("tightness"), now)
    text += "\n## With 100 000 instances\n\nThe worst ratio for each k, in ℝᵏ.\n\n| claim / conclusion | "
    deep = [row for row in rows if row.get("evaluations", 0) >= 100000]
    ks = sorted({row["k"] for row in deep if row["k"] == row["m"]})
    text += " | ".join(f"k={k}" for k in ks) + " |\n|---|" + "--:|" * len(ks) + "\n"
    for claim, conclusion in dict.fromkeys((row["claim"], row["conclusion"]) for row in deep):
        cells = {row["k"]: number(row.get("lower")) for row in deep
                 if (row["claim"], row["conclusion"]) == (claim, conclusion) and row["k"] == row["m"]}
        text += f"| {claim} / {conclusion} | " + " | ".join(cells.get(k, "–") for k in ks) + " |\n"
    text += "\n## Equalities\n\n| claim / conclusion | shapes |\n|---|---|\n"
    equal = {}
    for row in rows:
        if row.get("note") == "equality, exactly":
            equal.setdefault(f"{row['claim']} / {row['conclusion']}", []).append(dimensions(row))
    for name in sorted(equal):
        text += f"| {name} | {', '.join(equal[name])} |\n"
    text += "\n## All\n\n| claim / conclusion | shape | worst ratio found | evaluations | |\n|---|---|--:|--:|---|\n"
    for row in rows:
        text += (f"| {row['claim']} / {row['conclusion']} | {dimensions(row)} | {number(row.get('lower'))} | "
                 f"{row.get('evaluations', 0)} | {note(row)} |\n")
    return text


def exponents_page(now):
    text = EXPONENTS_HEAD.replace("@COMMANDS@", command_text(searches_of("exponents")))
    text += age_note(searches_of("exponents"), now)
    for along, title in [("thickness(s)", "Thickness"), ("xi", "Distortion"), ("gamma0", "Γ₀"), ("k", "Dimension")]:
        text += f"\n## {title}\n\n| claim / conclusion | shape | in the bound | of the worst found | residual | values |\n|---|---|--:|--:|--:|--:|\n"
        for row in read("exponents"):
            if row["along"] != along:
                continue
            shape = dimensions(row) if "k" in row else "k = m"
            found = sum("ratio_lower" in point for point in row["points"])
            has_fit = "exponent_found" in row
            text += (f"| {row['claim']} / {row['conclusion']} | {shape} | {row.get('exponent_in_bound', 'other')} | "
                     + (f"{row['exponent_found']:.2f} ± {row['error']:.2f} | {row['residual']:.2f}" if has_fit else "– | –")
                     + f" | {found} of {len(row['points'])} |\n")
    return text


def pages(build):
    now = canaries(build)
    tables = {"slack": "slack.json", "ratios": "tightness.json", "power": "power.json"}
    files = [part for option, file in tables.items() for part in (f"--{option}", TABLES / file)]
    return {"tightness.md": tightness_page(now), "exponents.md": exponents_page(now),
            "power.md": run(build, ["tables", "--power", TABLES / "power.json", "--places"]),
            "constants.md": run(build, ["tables", *files]), "constants.tex": run(build, ["tables", *files, "--latex"])}


def render(build):
    for name, text in pages(build).items():
        (TABLES / name).write_text(text)


def complaints(build):
    result = []
    for name, text in pages(build).items():
        if (TABLES / name).read_text() != text:
            result.append(f"docs/tables/{name} is not what bench/searches.py render writes")
    record = json.loads((TABLES / "searches.json").read_text())
    for name, section in record.items():
        for claim, known in section["claims"].items():
            if not (CLAIMS / f"{claim}.toml").exists():
                result.append(f"{name}: there is no claim {claim} any more")
            elif statement_hash(claim) != known:
                result.append(f"{name}: {claim} says something else than when it was searched")
    return result


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("what", choices=["measure", "render", "check"])
    parser.add_argument("--build", type=Path, default=ROOT / "build/release")
    parser.add_argument("--logs", type=Path)
    parser.add_argument("--only", action="append", choices=list(PLAN))
    options = parser.parse_args()
    if options.what == "measure":
        measure(options.build, options.only, options.logs)
    elif options.what == "render":
        render(options.build)
    else:
        found = complaints(options.build)
        print("\n".join(found) if found else "the pages of docs/tables are those of their records, and the claims too")
        sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
