#!/usr/bin/env python3
"""What the project asks of its speed, as ratios: measures them, records them in bench/goals.json, and writes the table of
docs/performance.md between its marks, <!-- goals --> and <!-- goals: end -->.

  bench/goals.py measure [--build build/release] [--repetitions 5] [--long] [--only REGEX]
  bench/goals.py render                   the table again from the record
  bench/goals.py check                    whether the table is that of the record

The two sides of a ratio take turns, five times or more, and the figure is the median of the ratios; the table also has the least, the
greatest, and the load, that is, how many processes ran or waited. Times are processor times, of one thread, unless the line
says otherwise. --long also measures the sphere with a million points. Lines with † were measured when the programs counted
otherwise than bench/costs.json says now. Programs of bench/ are built with -DDELCERT_BENCHMARKS=ON, target `benchmarks`.
"""

import argparse
import json
import math
import os
import re
import statistics
import sys
import tempfile
from pathlib import Path

import costs

ROOT = Path(__file__).resolve().parent.parent
MARK = re.compile(r"(<!-- goals -->\n).*?(<!-- goals: end -->)", re.DOTALL)
SEVERAL_LEVELS = "perturbed and certified on 1, 2, 2s, 4, 5 : GUDHI's complex and its fix"


class Line:
    """One row: what is measured by `once(build)` each time, a list of figures or one, and what is asked of the median."""

    def __init__(self, name, title, asked, once, unit="", at_least=False, long=False):
        self.name, self.title, self.asked, self.once = name, title, asked, once
        self.unit, self.at_least, self.long = unit, at_least, long

    def is_met(self, median):
        return median >= self.asked if self.at_least else median <= self.asked


def tangential(*arguments):
    """bench/tangential_complex: both sides in one process, one after the other."""
    def once(build):
        text = costs.timed([build / "bench/tangential_complex", *arguments])[0]
        ratio = {what: float(value) for what, value in re.findall(r"^\| ([^|]+) \| [0-9.]+ \| ([0-9.]+) \|", text, re.MULTILINE)}
        return ratio["perturbed, certified on levels 1, 2, 4"] + ratio["level 2s"]
    return once


def benchmark(program, *arguments):
    """Processor seconds by the name of the benchmark."""
    text = costs.timed([program, *arguments, "--benchmark_format=json", "--benchmark_min_time=0.1"])[0]
    units = {"ns": 1e-9, "us": 1e-6, "ms": 1e-3, "s": 1}
    return {one["name"]: {**one, "seconds": one["cpu_time"] * units[one["time_unit"]]} for one in json.loads(text)["benchmarks"]}


def certified(run, build, folder):
    """The certificate, what certifying took, and the number of points."""
    certificate = os.path.join(folder, "certificate.json")
    text, took = costs.timed(run.certify(build / "apps/delcert", certificate))
    return certificate, took, json.loads(text)["points"]


def checked(build, certificate, *options):
    return costs.timed([build / "proofs/checker/delcert-check", *options, certificate])[1]


def torus_beside_cgal(build):
    with tempfile.TemporaryDirectory() as folder:
        run = costs.Run("torus-3", "1/24", options=("--mode", "theory"))
        ours = certified(run, build, folder)[1]["user"]
    theirs = benchmark(build / "bench/stages_certified", "--benchmark_filter=torus-3:1_24/cgal_periodic_delaunay")
    return ours / next(iter(theirs.values()))["seconds"]


def beside_plain_doubles(net):
    def once(build):
        sums = []
        for program in ("stages_certified", "stages_plain"):
            stages = benchmark(build / "bench" / program, f"--benchmark_filter={net}/")
            sums.append(sum(one["seconds"] for name, one in stages.items() if "cgal" not in name))
        return sums[0] / sums[1]
    return once


def curved_beside_plain_doubles(*run):
    """What bench/curved_stages.cpp does, from the net to level 5, with intervals and with doubles in their place."""
    def once(build):
        certified, plain = (json.loads(costs.timed([build / "bench" / program, *run])[0])
                            for program in ("curved_certified", "curved_plain"))
        for report, kernel in ((certified, "certified"), (plain, "plain doubles")):
            if report["kernel"] != kernel or not report["levels 1, 2, 4"]:
                raise SystemExit(f"{' '.join(run)}, {kernel}: {json.dumps(report)}")
        if certified["points"] != plain["points"]:
            raise SystemExit(f"{' '.join(run)}: {certified['points']} points, with doubles {plain['points']}")
        return sum(certified["seconds"].values()) / sum(plain["seconds"].values())
    return once


def check_beside_certify(*run):
    def once(build):
        with tempfile.TemporaryDirectory() as folder:
            certificate, took, _ = certified(costs.Run(*run), build, folder)
            return checked(build, certificate, "--threads", "1")["user"] / took["user"]
    return once


EXPORTED = ["json", "vtu", "medit", "gmsh", "csv", "simplex-tree", "regina"]


def export_beside_certify(*run):
    """Of formats of all dimensions the one that takes longest, by medians of five: of single times of some milliseconds the
    greatest would be that of the most disturbed one."""
    def once(build):
        with tempfile.TemporaryDirectory() as folder:
            certificate, took, _ = certified(costs.Run(*run), build, folder)
            times = {form: [] for form in EXPORTED}
            for _ in range(5):
                for form in EXPORTED:
                    times[form].append(costs.timed([build / "apps/delcert", "export", certificate, "--format", form])[1]["user"])
            return max(statistics.median(of_form) for of_form in times.values()) / took["user"]
    return once


def check_a_point(*run):
    def once(build):
        with tempfile.TemporaryDirectory() as folder:
            certificate, _, points = certified(costs.Run(*run), build, folder)
            return 1e6 * checked(build, certificate, "--threads", "1")["user"] / points
    return once


def sample_beside_rationals(claim):
    """A whole sample of an attack, drawing included, and all that it decides and measures in GMP's fractions."""
    def once(build):
        times = benchmark(build / "bench/claims", f"--benchmark_filter=^{claim}/k=3,m=3/(rationals|sample)")
        each = {name.rsplit("/", 1)[1]: one["each"] for name, one in times.items()}
        return each["sample"] / each["rationals"]
    return once


SIZES = [("sphere-2", "3/32"), ("sphere-2", "3/100"), ("sphere-2", "3/320")]
LARGEST = ("sphere-2", "299/100000")


def exponent(step, sizes):
    """The slope of the regression line of log seconds over log points."""
    def once(build):
        logarithms = []
        for manifold, radius in sizes:
            with tempfile.TemporaryDirectory() as folder:
                certificate, took, points = certified(costs.Run(manifold, radius, 1), build, folder)
                seconds = took["user"] if step == "certify" else checked(build, certificate, "--threads", "1")["user"]
                logarithms.append((math.log(points), math.log(seconds)))
        return statistics.linear_regression(*zip(*logarithms)).slope
    return once


def on_two_threads(step, manifold, radius, what):
    def once(build):
        with tempfile.TemporaryDirectory() as folder:
            certificate, took, _ = certified(costs.Run(manifold, radius, 1, 2), build, folder)
            return (took if step == "certify" else checked(build, certificate, "--threads", "2"))[what]
    return once


def speed_up(step, manifold, radius, *options):
    """Wall time of one thread over that of two."""
    def once(build):
        walls = []
        for threads in (1, 2):
            with tempfile.TemporaryDirectory() as folder:
                run = costs.Run(manifold, radius, 1, threads, options=options)
                certificate, took, _ = certified(run, build, folder)
                walls.append((took if step == "certify" else checked(build, certificate, "--threads", str(threads)))["wall"])
        return walls[0] / walls[1]
    return once


def speed_up_of_attacks(build):
    walls = [costs.timed([build / "apps/delcert-claims", "attack", "thickness-and-singular-value", "--shape", "3,3", "--samples",
                          "60000", "--seed", "1", "--threads", str(threads)])[1]["wall"] for threads in (1, 2)]
    return walls[0] / walls[1]


TORUS_2, TORUS_3 = ("torus-2", "1/100"), ("torus-3", "1/24")
CHECKED = [TORUS_2, TORUS_3, ("sphere-2", "1/84"), ("sphere-3", "1/10"), ("bolza-surface", "1/10"), ("poincare-sphere", "13/500")]
LINES = [
    Line("gudhi 2", "𝕊², ε = 1/84: " + SEVERAL_LEVELS, 3, tangential("sphere-2", "1/84")),
    Line("gudhi 3", "𝕊³, ε = 1/10: " + SEVERAL_LEVELS, 5, tangential("sphere-3", "1/10")),
    Line("cgal", "𝕋³, ε = 1/24, all levels : CGAL's periodic triangulation", 10, torus_beside_cgal),
    Line("plain 2", "𝕋², ε = 1/100: certified : plain doubles", 1.7, beside_plain_doubles("torus-2:1_100")),
    Line("plain 3", "𝕋³, ε = 1/24: certified : plain doubles", 1.7, beside_plain_doubles("torus-3:1_24")),
    *(Line(f"plain {manifold}", f"{title}, ε = {radius}: certified : plain doubles", 1.7, curved_beside_plain_doubles(manifold, radius))
      for title, manifold, radius in (("𝕊²", "sphere-2", "1/84"), ("𝕊³", "sphere-3", "1/10"), ("bolza-surface", "bolza-surface", "1/10"))),
    *(Line(f"check {manifold}", f"{manifold}, ε = {radius}: check : certify", 0.25, check_beside_certify(manifold, radius, 1))
      for manifold, radius in CHECKED),
    *(Line(f"export {manifold}", f"{manifold}, ε = {radius}: export, the slowest format : certify", 0.1,
           export_beside_certify(manifold, radius, 1)) for manifold, radius in CHECKED),
    Line("check a point 2", "check, 𝕊², ε = 1/84", 15, check_a_point("sphere-2", "1/84", 1), " µs a point"),
    Line("check a point 3", "check, 𝕊³, ε = 1/10", 100, check_a_point("sphere-3", "1/10", 1), " µs a point"),
    Line("check a point torus", "check, 𝕋³, ε = 1/24", 80, check_a_point("torus-3", "1/24", 1), " µs a point"),
    *(Line(f"attack {claim}", f"`{claim}`, k = m = 3: a sample of an attack : the same in rationals", 0.2,
           sample_beside_rationals(claim))
      for claim in ("thickness-and-singular-value", "crude-circumradius-bound")),
    *(Line(f"exponent of {step}", f"𝕊², 10³ to 10⁵ points: exponent of {step} in the number of points", 1.03, exponent(step, SIZES))
      for step in ("certify", "check")),
    *(Line(f"long exponent of {step}", f"𝕊², 10³ to 10⁶ points: exponent of {step}", 1.03, exponent(step, SIZES + [LARGEST]), long=True)
      for step in ("certify", "check")),
    Line("long certify", "𝕊², 10⁶ points, 2 threads: certify", 60, on_two_threads("certify", *LARGEST, "wall"), " s", long=True),
    Line("long memory", "𝕊², 10⁶ points, 2 threads: memory of certify", 2048, on_two_threads("certify", *LARGEST, "mib"), " MiB", long=True),
    Line("long check", "𝕊², 10⁶ points, 2 threads: check", 20, on_two_threads("check", *LARGEST, "wall"), " s", long=True),
    *(Line(f"threads {step} {manifold}", f"{manifold}, ε = {radius}: {step}, 1 thread : 2 threads, wall time", 1.8,
           speed_up(step, manifold, radius), at_least=True)
      for step, manifold, radius in (("certify", "sphere-2", "1/84"), ("certify", "sphere-3", "3/20"), ("certify", "torus-2", "1/400"),
                                     ("certify", "torus-3", "1/24"), ("check", "sphere-2", "1/84"), ("check", "torus-3", "1/24"))),
    Line("threads attack", "attack on `thickness-and-singular-value`, 1 thread : 2 threads, wall time", 1.8, speed_up_of_attacks,
         at_least=True),
]


def is_due(line, arguments):
    if arguments.only:
        return re.search(arguments.only, line.name) is not None
    return arguments.long or not line.long


def measure(arguments, record, file, identity):
    for line in LINES:
        if not is_due(line, arguments):
            continue
        figures = [line.once(arguments.build) for _ in range(1 if line.long else arguments.repetitions)]
        record[line.name] = {"figures": [round(figure, 4) for figure in figures], "load": round(os.getloadavg()[1], 1),
                             "programs": identity}
        file.write_text(json.dumps(record, indent=1, ensure_ascii=False) + "\n")
        print(f"{line.name}: {statistics.median(figures):.3g}{line.unit}", flush=True)


def figure_text(value):
    """Three digits, or all before the point."""
    return f"{value:.0f}" if value >= 1000 else f"{value:.3g}"


def table(record, identity):
    rows = ["| | asked | median | least – greatest | times | load |", "|---|--:|--:|--:|--:|--:|"]
    for line in LINES:
        one = record.get(line.name)
        if one is None:
            continue
        median = statistics.median(one["figures"])
        mark = "" if one["programs"] == identity else " †"
        figure = figure_text(median) + line.unit
        rows.append(f"| {line.title}{mark} | {'≥' if line.at_least else '≤'} {line.asked:g}{line.unit} | "
                    f"{f'**{figure}**' if line.is_met(median) else figure} | "
                    f"{figure_text(min(one['figures']))} – {figure_text(max(one['figures']))} | {len(one['figures'])} | {one['load']} |")
    return "\n".join(rows) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("action", choices=["measure", "render", "check"])
    parser.add_argument("--build", type=Path, default=ROOT / "build/release")
    parser.add_argument("--repetitions", type=int, default=5)
    parser.add_argument("--long", action="store_true")
    parser.add_argument("--only", metavar="REGEX", help="measure the lines whose names this finds, and nothing else")
    parser.add_argument("--root", type=Path, default=ROOT)
    arguments = parser.parse_args()
    file = arguments.root / "bench/goals.json"
    record = json.loads(file.read_text()) if file.exists() else {}
    identity = costs.identity_of(json.loads((arguments.root / "bench/costs.json").read_text()))
    if arguments.action == "measure":
        measure(arguments, record, file, identity)
    page = arguments.root / "docs/performance.md"
    old = page.read_text()
    new, count = MARK.subn(lambda match: match[1] + table(record, identity) + match[2], old)
    if count != 1:
        raise SystemExit(f"goals.py: {page} has {count} places for the table")
    if arguments.action == "check":
        print("the table is that of the record" if new == old else "performance.md: not what bench/goals.json says: bench/goals.py render")
        return 0 if new == old else 1
    page.write_text(new)
    return 0


if __name__ == "__main__":
    sys.exit(main())
