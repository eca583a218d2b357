#!/usr/bin/env python3
"""ranks.py measure MPIRUN DELCERT-RANKS   measures the constants of one triangulation by several processes: bench/ranks.json
ranks.py write                          writes the tables of docs/ranks.md that follow from them
ranks.py --check                        fails if these are not what the page has

What is measured: spheres by one rank and by several, processor seconds of the rank that takes
most; of several ranks with what they wait for each other. What is extrapolated: 10⁸ points on 64 ranks, with the constants of
the larger one by one rank. What is assumed: the network."""

import json
import math
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
FIGURES = ROOT / "bench" / "ranks.json"
PAGE = ROOT / "docs" / "ranks.md"
RUNS = [("sphere-2", "1/50", 1), ("sphere-2", "3/320", 1), ("sphere-2", "3/320", 4),
        ("sphere-3", "1/8", 1), ("sphere-3", "1/8", 2)]
POINTS, RANKS = 10**8, 64
BANDWIDTH, LATENCY = 1.25e9, 50e-6  # bytes a second, seconds: 10 Gbit/s
STAGES = ["net", "separation", "points and stars", "stars in other charts", "measures of levels 5 and 6", "write chunks"]
CHUNKS = 8


def figures_of(output):
    lines = {line.split(None, 1)[0]: line.split(None, 1)[1] for line in output.splitlines() if not line.startswith(" ")}
    stages = {line.split("[")[0].strip(): float(line.split("[")[2].split()[0])
              for line in output.splitlines() if line.startswith("  ")}
    ranks = lines["ranks"].split()
    return {"points": int(lines["points"]), "own": int(ranks[5]), "here": int(ranks[11]),
            "colours": int(lines["perturbed"].split()[1]), "bytes": int(lines["sent"].split()[0]),
            "mib": int(lines["memory"].split()[0]), "net_mib": int(lines["memory"].split()[7]), "stages": stages}


def measure(mpirun, program):
    environment = os.environ | {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
                                "OMPI_MCA_rmaps_base_oversubscribe": "1", "OMPI_MCA_mpi_yield_when_idle": "1"}
    results = []
    for manifold, radius, ranks in RUNS:
        folder = tempfile.mkdtemp()
        output = subprocess.run([mpirun, "-n", str(ranks), program, "certify", "--manifold", manifold, "--radius", radius,
                                 "--seed", "1", "--chunks", str(CHUNKS), "--output", folder + "/chunks"],
                                capture_output=True, text=True, check=True, env=environment).stdout
        size = sum(path.stat().st_size for path in Path(folder, "chunks").iterdir())
        shutil.rmtree(folder)
        results.append({"manifold": manifold, "radius": radius, "ranks": ranks, "certificate": size, **figures_of(output)})
        print(json.dumps(results[-1]), file=sys.stderr)
    FIGURES.write_text(json.dumps(results, indent=1) + "\n")


def run_of(results, manifold, ranks):
    """The largest such run."""
    return max((run for run in results if run["manifold"] == manifold and run["ranks"] == ranks), key=lambda run: run["points"])


def measured_table(results):
    lines = ["| manifold, radius | points | ranks | a rank places, knows at most | colours | sent of moved points, kB | MiB of a rank "
             "| net, s | points and stars | other charts | 5 and 6 | writing |", "|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|"]
    for run in results:
        stages = run["stages"]
        lines.append(f"| {run['manifold']}, {run['radius']} | {run['points']} | {run['ranks']} | {run['own']}, {run['here']} "
                     f"| {run['colours']} | {run['bytes'] / 1000:.0f} | {run['mib']} | {stages['net']:.2f} "
                     f"| {stages['points and stars']:.2f} | {stages['stars in other charts']:.2f} "
                     f"| {stages['measures of levels 5 and 6']:.2f} | {stages['write chunks']:.2f} |")
    return lines


def plan(results, manifold):
    """Of one manifold: rows (stage, seconds, memory of a rank in GB, bytes that a rank sends)."""
    dimension = int(manifold[-1])
    alone = run_of(results, manifold, 1)
    points = alone["points"]
    micro = {stage: alone["stages"][stage] / points for stage in STAGES}
    numerator, denominator = (int(part) for part in alone["radius"].split("/"))
    volume = {2: 4 * math.pi, 3: 2 * math.pi**2}[dimension]
    density = points * (numerator / denominator) ** dimension / volume
    own = POINTS / RANKS
    side = (own / density) ** (1 / dimension)
    width = 13.5  # between one and two cells of 9ε
    here = density * (side + 2 * width) ** dimension
    halo = here - own
    shown = density * ((side + 2 * 9) ** dimension - side**dimension)
    moved = shown * (4 + 9 * dimension)
    memory_of_a_point = bytes_of_a_point(results, manifold, "mib")
    rows = [("net, by the first rank", POINTS * micro["net"], POINTS * bytes_of_a_point(results, manifold, "net_mib"),
             POINTS * 9 * dimension),
            ("division", halo * (4 + 9 * dimension) / BANDWIDTH, 0, halo * (4 + 9 * dimension)),
            ("separation", own * micro["separation"], 0, 0),
            ("points and stars", own * micro["points and stars"] + alone["colours"] * LATENCY + RANKS * LATENCY
             + moved / BANDWIDTH, here * memory_of_a_point, moved + side ** (dimension - 1) * 200),
            ("stars in other charts", own * micro["stars in other charts"], here * memory_of_a_point, 0),
            ("measures of levels 5 and 6", own * micro["measures of levels 5 and 6"], here * memory_of_a_point,
             side ** (dimension - 1) * density * 24 * dimension),
            ("write chunks", own * micro["write chunks"], here * memory_of_a_point, 0)]
    return rows, here


def bytes_of_a_point(results, manifold, key):
    """Memory of one rank a point, without what the program takes for itself: that is found from two nets on S²."""
    small, large = sorted((run for run in results if run["manifold"] == "sphere-2" and run["ranks"] == 1),
                          key=lambda run: run["points"])
    slope = (large[key] - small[key]) / (large["points"] - small["points"])
    base = small[key] - slope * small["points"]
    alone = run_of(results, manifold, 1)
    return (alone[key] - base) * 2**20 / alone["points"]


def amount(x):
    for unit in ("B", "kB", "MB", "GB"):
        if x < 1000 or unit == "GB":
            return f"{x:.3g} {unit}" if x < 1000 else f"{x:.0f} {unit}"
        x /= 1000
    return ""


def duration(seconds):
    return f"{seconds:.2g} s" if seconds < 1 else f"{seconds:.0f} s" if seconds < 600 else f"{seconds / 60:.0f} min"


def plan_table(results):
    lines = ["| stage | S²: time | memory of a rank | a rank sends | S³: time | memory of a rank | a rank sends |",
             "|---|--:|--:|--:|--:|--:|--:|"]
    plans = [plan(results, manifold) for manifold in ("sphere-2", "sphere-3")]
    for rows in zip(*(entry[0] for entry in plans)):
        cells = [f"{duration(seconds)} | {amount(memory) if memory else ''} | {amount(sent) if sent else ''}"
                 for _, seconds, memory, sent in rows]
        lines.append(f"| {rows[0][0]} | " + " | ".join(cells) + " |")
    totals = [f"{duration(sum(row[1] for row in entry[0]))} | {amount(max(row[2] for row in entry[0]))} | " for entry in plans]
    lines.append("| all | " + " | ".join(totals) + " |")
    without = [f"{duration(sum(row[1] for row in entry[0][1:]))} | {amount(max(row[2] for row in entry[0][1:]))} | "
               for entry in plans]
    lines.append("| all but the net | " + " | ".join(without) + " |")
    lines += ["", "A rank places 1.56·10⁶ labels and knows " + " and ".join(
        f"{entry[1] / 1e6:.2f}·10⁶ on {name}" for entry, name in zip(plans, ("S²", "S³"))) + "."]
    return lines


def pages():
    results = json.loads(FIGURES.read_text())
    before = PAGE.read_text()
    after = before
    for name, lines in (("measured", measured_table(results)), ("plan", plan_table(results))):
        begin, end = f"<!-- ranks: {name} -->\n", "<!-- ranks: end -->"
        head, rest = after.split(begin, 1)
        after = head + begin + "\n".join(lines) + "\n" + end + rest.split(end, 1)[1]
    return before, after


def main():
    if sys.argv[1:2] == ["measure"] and len(sys.argv) == 4:
        measure(*sys.argv[2:])
    elif sys.argv[1:] == ["write"]:
        PAGE.write_text(pages()[1])
    elif sys.argv[1:] == ["--check"]:
        before, after = pages()
        if before != after:
            sys.exit("docs/ranks.md has not the tables of bench/ranks.json: bench/ranks.py write")
    else:
        sys.exit(__doc__)


main()
