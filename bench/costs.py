#!/usr/bin/env python3
"""What runs cost: measures it, records it in bench/costs.json, and writes the tables of README.md and
docs/performance.md, those of the members in docs/space-forms.md, of zero sets in docs/submanifolds.md and of atlases in docs/atlases.md, between their marks, <!-- costs: NAME --> and
<!-- costs: end -->.

  bench/costs.py measure [--build build/release] [--long] [--members] [--only REGEX]   all of it, in less than ten minutes on two idle cores
  bench/costs.py render                                     the tables again from the record
  bench/costs.py check [--build build/release]              whether the tables are those of the record, and the record is
                                                            of these programs: the cheap runs are made again, and what
                                                            they count has to be what is recorded, times are not looked at

--long also measures the runs that take minutes, --members certifies and checks all members; without these their figures stay, marked by † once the programs count
otherwise than when they were measured. Tables of bench/ratios, bench/claims and bench/tangential_complex are measured
where these have been built (-DDELCERT_BENCHMARKS=ON, target `benchmarks`), and stay as they are elsewhere; so does that of the meshes
of tests/cli/mesh.py, for which the tests and Debian's python3-vtk9 are needed.
"""

import argparse
import hashlib
import json
import math
import os
import re
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import stability_alone

ROOT = Path(__file__).resolve().parent.parent
MARK = re.compile(r"(<!-- costs: (?!end)([a-z0-9-]+) -->\n).*?(<!-- costs: end -->)", re.DOTALL)


class Run:
    """A certified run that tables speak of."""

    def __init__(self, manifold, radius, seed=0, threads=1, cheap=False, long=False, member=False, options=()):
        self.manifold, self.radius, self.seed, self.threads = manifold, radius, seed, threads
        self.cheap, self.long, self.member, self.options = cheap, long, member, list(options)
        self.is_flat = re.match("torus-[0-9](-skewed)?$", manifold) is not None
        self.name = " ".join([f"{manifold} {radius} seed {seed} threads {threads}", *options] + ["member"] * member)

    def certify(self, program, output):
        command = [program, "certify", "--manifold", self.manifold, "--radius", self.radius, "--seed", str(self.seed)]
        return command + [*self.options, "--json", "--threads", str(self.threads), "--output", output]

    def is_due(self, arguments, record):
        """Whether this time it is measured."""
        if arguments.only:
            return re.search(arguments.only, self.name) is not None
        asked = arguments.long if self.long else arguments.members or self.cheap if self.member else True
        return asked or (self.cheap and self.name not in record["runs"])


TORI = [Run("torus-2", "1/24", cheap=True), Run("torus-2", "1/100", cheap=True), Run("torus-2", "1/400"),
        Run("torus-2-skewed", "1/24", cheap=True), Run("torus-2-skewed", "1/100"), Run("torus-2-skewed", "1/400"),
        Run("torus-3", "1/24"), Run("torus-3", "1/40")]
FORMS = [Run("sphere-2", "1/50", 1, 2), Run("sphere-2", "299/100000", 1, 2, long=True), Run("sphere-3", "1/10", 1, 2),
         Run("poincare-sphere", "13/500", 1, 2), Run("seifert-weber-space", "9/125", 1, 2)]
SIZES = [Run("sphere-2", "3/32", 1, cheap=True), Run("sphere-2", "3/100", 1), Run("sphere-2", "3/320", 1),
         Run("sphere-2", "299/100000", 1, 2, long=True)]
THREADS = [[Run("sphere-2", "1/50", 1, threads) for threads in (1, 2, 4)],
           [Run("sphere-3", "3/20", 1, threads) for threads in (1, 2, 4)]]
MEMBERS = [Run(manifold, radius, 1, 2, member=True, cheap=manifold in ("klein-bottle", "projective-plane", "bolza-surface"))
           for manifold, radius in [("sphere-2", "1/10"), ("sphere-2", "1/50"), ("projective-plane", "1/10"),
                                    ("klein-bottle", "1/24"), ("bolza-surface", "1/10"), ("klein-quartic", "1/10"),
                                    ("regular-polygon-surface-3", "1/10"), ("sphere-3", "3/20"), ("sphere-3", "1/10"),
                                    ("projective-space-3", "13/100"), ("quaternion-space", "13/200"),
                                    ("lens-space-5-2", "13/250"), ("lens-space-7-2", "37/1000"),
                                    ("poincare-sphere", "13/500"), ("flat-torus-3", "1/24"), ("flat-half-turn", "1/24"),
                                    ("flat-third-turn", "1/24"), ("flat-quarter-turn", "1/24"), ("flat-sixth-turn", "1/24"),
                                    ("hantzsche-wendt", "1/24"), ("flat-first-amphicosm", "1/24"),
                                    ("flat-second-amphicosm", "1/24"), ("flat-first-amphidicosm", "1/24"),
                                    ("flat-second-amphidicosm", "1/24"), ("seifert-weber-space", "9/125")]]
ZERO_SETS = [Run(manifold, radius, 1, 2, cheap=manifold == "two-spheres")
             for manifold, radius in [("torus-of-revolution", "3/20"), ("torus-of-revolution", "1/10"), ("torus-of-revolution", "1/14"),
                                      ("torus-of-revolution", "1/20"), ("ellipsoid", "1/10"), ("ellipsoid", "1/16"),
                                      ("two-spheres", "1/17"), ("clifford-torus", "1/20")]]
ZERO_SETS += [Run("trefoil", "1/26", 1, 2)]
ZERO_SETS += [Run("sphere-3-in-r4", "1/11", 1, 2, long=True)]
# In codimension 2 and 3, without the levels that are not reached at this radius.
ZERO_SETS += [Run(manifold, radius, 1, 2, long=True, options=("--levels", "1,2,5"))
              for manifold, radius in [("s2-x-s1", "1/6"), ("torus-3-in-r6", "1/6"), ("torus-3-in-r6", "3/20"), ("stiefel-2-3", "1/10")]]
# Radii that vary.
ZERO_SETS += [Run("ellipsoid", "1", 1, 2, cheap=True, options=("--sizing", "curvature:3/20,1/10")),
              Run("tanglecube", "1", 1, 2, options=("--sizing", "curvature:1/10,1/10")),
              Run("tanglecube", "1", 1, 2, options=("--sizing", "curvature:3/20,1/10", "--refine", "8")),
              Run("genus-2", "1/4", 1, 2, long=True, options=("--sizing", "curvature:1/10,1/10", "--refine", "3")),
              Run("genus-2", "1/60", 1, 2, long=True, options=("--sizing", "curvature:1/10,1/18", "--refine", "3"))]
ATLASES = [Run(manifold, radius, 1, 2, cheap=True)
           for manifold, radius in [("cone-torus", "1/36"), ("klein-bottle-rectangles", "1/30"), ("projective-plane-by-charts", "1/10"),
                                    ("projective-plane-by-charts", "1/16"), ("sphere-2-stereographic", "1/8"),
                                    ("sphere-2-stereographic", "1/16"), ("torus-2-bent", "1/40"), ("torus-2-by-charts", "1/30")]]
ATLASES.insert(6, Run("sphere-3-stereographic", "1/10", 1, 2))
ALL = {run.name: run for run in TORI + FORMS + SIZES + sum(THREADS, []) + MEMBERS + ZERO_SETS + ATLASES}
BENCHES = {"ratios": ["ratios", "3"],
           "claims": ["claims", "--benchmark_filter=^(thickness-and-singular-value|crude-circumradius-bound).*k=3,m=3",
                      "--benchmark_min_time=0.5", "--benchmark_format=json"],
           "tangential-2": ["tangential_complex", "sphere-2", "1/84"],
           "tangential-3": ["tangential_complex", "sphere-3", "1/10"],
           "tangential-6": ["tangential_complex", "torus-3-in-r6", "1/6"],
           "tangential-6-finer": ["tangential_complex", "torus-3-in-r6", "3/20"],
           "meshes": [], "remeshed": []}


def command_of_bench(name, build):
    """What makes this table."""
    if name == "meshes":
        return [Path("/usr/bin/python3"), ROOT / "tests/cli/mesh.py", build / "apps/delcert", build / "proofs/checker/delcert-check",
                build / "tests/cli/surface-mesh", "--table"]
    if name == "remeshed":
        return [ROOT / "bench/remeshed_sphere.py", build / "apps/delcert", build / "proofs/checker/delcert-check"]
    program, *arguments = BENCHES[name]
    return [build / "bench" / program, *arguments]


def descendants(process):
    """The process and what it has forked: the checker works in processes of its own."""
    try:
        children = Path(f"/proc/{process}/task/{process}/children").read_text().split()
    except OSError:
        children = []
    return [process] + [one for child in children for one in descendants(child)]


def peak_memory_in_kib(process):
    """Of all processes that are alive now, the peak of each. What wait4 reports has the memory of this script in it, from which
    the process was forked."""
    result = 0
    for one in descendants(process):
        try:
            result += int(re.search(r"VmHWM:\s*(\d+)", Path(f"/proc/{one}/status").read_text())[1])
        except (OSError, TypeError):
            pass
    return result


def timed(command):
    """Standard output, wall seconds, seconds of the user, MiB."""
    with tempfile.TemporaryFile() as output:
        begin = time.monotonic()
        process = subprocess.Popen(command, stdout=output, stderr=subprocess.DEVNULL)
        peak, ended = 0, 0
        while not ended:
            peak = max(peak, peak_memory_in_kib(process.pid))
            ended, status, usage = os.wait4(process.pid, os.WNOHANG)
            if not ended:
                time.sleep(0.002)
        wall = time.monotonic() - begin
        process.returncode = os.waitstatus_to_exitcode(status)
        if process.returncode != 0:
            raise SystemExit(f"costs.py: exit status {process.returncode}: {' '.join(map(str, command))}")
        output.seek(0)
        return output.read().decode(), {"wall": round(wall, 3), "user": round(usage.ru_utime, 3),
                                        "mib": round(peak / 1024)}


def of_zero_set(report, document):
    """What a table says of a submanifold besides: margins of levels, in sampling radii where they are lengths."""
    levels = report["levels"]
    if report["manifold"]["family"] != "submanifold" or "5" not in levels:
        return {}
    five, isotopy, metric = levels["5"], levels.get("5i"), levels.get("6")
    return {"zero set": {"contraction": five["contraction"]["value"],
                         "displacement": five["displacement"]["in_sampling_radii"],
                         "isotopy": isotopy and isotopy.get("margin", {}).get("in_sampling_radii"),
                         "delaunay": levels.get("4", {}).get("metric"),
                         "normal": metric and metric["normal"]["value"],
                         "homology": levels["2"]["homology"],
                         "stable": list(stability_alone.passing(document)) if "4" in levels else None,
                         "uniformly": report["measures"].get("radii", {}).get("points_with_the_least")}}


def of_atlas(report):
    """The same of an atlas by formulas."""
    if report["manifold"]["family"] != "atlas":
        return {}
    one, five = report["levels"]["1"], report["levels"].get("5")
    return {"atlas": {"protection": one["protection"]["in_sampling_radii"], "thickness": one["thickness"]["value"],
                      "displacement": five and five["displacement"]["in_sampling_radii"],
                      "contraction": five and five["contraction"]["value"],
                      "homology": report["levels"]["2"]["homology"]}}


def counts(report, certificate, check):
    """What a run and its check count, which is the same on every machine: points, simplices, decisions, and a digest of
    the points and simplices."""
    document = json.loads(Path(certificate).read_text())
    content = json.dumps([document["points"], document["simplices"]], separators=(",", ":"), sort_keys=True)
    return {"points": report["points"], "simplices": report["simplices"], "statistics": report["statistics"],
            "levels": [str(level["level"]) if isinstance(level, dict) else level for level in report["levels"]],
            "decisions": {stage["stage"]: sum(stage["decisions"].values()) for stage in report["stages"]
                          if sum(stage["decisions"].values()) > 0},
            **of_zero_set(report, document), **of_atlas(report),
            "content": hashlib.sha256(content.encode()).hexdigest(),
            "check": {"levels": [level["level"] for level in check["levels"]], "decisions": check["decisions"]}}


def disagreeing_without_perturbation(run, build):
    """How many stars of the net itself do not agree with the star of another label."""
    with tempfile.TemporaryDirectory() as folder:
        command = run.certify(build / "apps/delcert", os.path.join(folder, "never.json")) + ["--no-perturbation"]
        result = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    if result.returncode == 0:
        return 0
    found = re.search(r"(\d+) stars are not in agreement with another", result.stderr)
    if result.returncode == 1 and "nothing is certified" in result.stderr:
        return int(found[1]) if found else 0
    raise SystemExit(f"costs.py: {run.name} without perturbation: exit status {result.returncode}: {result.stderr}")


def homology_of_simplices(build, certificate):
    """What `delcert homology` finds in a file that has the simplices of the certificate and nothing else."""
    bare = certificate + ".simplices"
    Path(bare).write_text(json.dumps({"simplices": json.loads(Path(certificate).read_text())["simplices"]}))
    groups = json.loads(timed([build / "apps/delcert", "homology", bare, "--json"])[0])["homology"]
    os.remove(bare)
    return groups


def of_member(run, build, certificate, report):
    """What the table of members says besides."""
    stars, measures = report["levels"]["1"], report.get("measures", {})
    return {"raw": disagreeing_without_perturbation(run, build),
            "differ": measures.get("star_chart_pairs", {}).get("stars_differing", 0),
            "hinges": [measures.get("hinges", {}).get(key, 0) for key in ("not_locally_delaunay", "undecided", "all")],
            "margins": [stars["protection"]["in_sampling_radii"], stars["thickness"]["value"],
                        stars["circumradius"]["in_sampling_radii"]],
            "homology": homology_of_simplices(build, certificate)}


def once(run, build, folder):
    certificate = os.path.join(folder, "certificate.json")
    text, certify = timed(run.certify(build / "apps/delcert", certificate))
    report = json.loads(text)
    checker = build / "proofs/checker/delcert-check"
    text, check = timed([checker, "--json", certificate])
    result = {"counts": counts(report, certificate, json.loads(text)), "certify": certify, "check": check,
              "stages": {stage["stage"]: round(stage["seconds"], 4) for stage in report["stages"]}}
    # The seconds of these levels alone, as the checker tells them; it has one thread.
    result["check 2 4 5 6"] = sum(level["seconds"] for level in json.loads(text)["levels"]
                                  if level["level"] in ("2", "4", "5", "6"))
    if run.member:
        result["counts"]["member"] = of_member(run, build, certificate, report)
    if run.is_flat:
        result["check without 3"] = timed([checker, "--json", "--levels", "0,1,2,4,5", certificate])[1]
    os.remove(certificate)
    return result


def median_of(results):
    """Field by field; counts are the same in all of them."""
    first = results[0]
    if isinstance(first, dict):
        return {key: first[key] if key == "counts" else median_of([result[key] for result in results]) for key in first}
    return statistics.median(results)


def measure(run, build):
    with tempfile.TemporaryDirectory() as folder:
        results = [once(run, build, folder)]
        if results[0]["certify"]["wall"] < 2:
            results += [once(run, build, folder) for _ in range(2)]
    if any(result["counts"] != results[0]["counts"] for result in results):
        raise SystemExit(f"costs.py: {run.name} is not the same twice")
    return median_of(results)


def identity_of(record):
    """Of the programs, by what they count on the cheap runs."""
    text = json.dumps({name: record["runs"][name]["counts"] for name, run in sorted(ALL.items()) if run.cheap},
                      sort_keys=True)
    return hashlib.sha256(text.encode()).hexdigest()


def write(file, record):
    file.write_text(json.dumps(record, indent=1, ensure_ascii=False) + "\n")


def measure_all(arguments, record, file):
    """Cheap runs first, as they tell which programs these are, and long ones last: what ends early keeps what it has measured."""
    for name, run in ALL.items():
        if not run.is_due(arguments, record) and name not in record["runs"]:
            print(f"{name}: left out, {'--long' if run.long else '--members'} measures it", flush=True)
    due = [(name, run) for name, run in ALL.items() if run.is_due(arguments, record)]
    due.sort(key=lambda one: (not one[1].cheap, one[1].long))
    for at, (name, run) in enumerate(due):
        begin = time.monotonic()
        one = measure(run, arguments.build)
        record["runs"][name] = one
        cheap_ones_are_known = all(other in record["runs"] for other, each in ALL.items() if each.cheap)
        if cheap_ones_are_known:
            identity = identity_of(record)
            for other, each in due[: at + 1]:
                if each.cheap or other == name:
                    record["runs"][other]["programs"] = identity
            write(file, record)
        print(f"{name}: certify {one['certify']['wall']} s, check {one['check']['wall']} s; {at + 1} of {len(due)} measured, "
              f"this one in {time.monotonic() - begin:.0f} s", flush=True)
    for name in BENCHES:
        if arguments.only and not re.search(arguments.only, name):
            continue
        command = command_of_bench(name, arguments.build)
        missing = [str(word) for word in command if isinstance(word, Path) and not word.exists()]
        if missing:
            print(f"{name}: there is no {missing[0]}, its table stays", flush=True)
            continue
        text = timed(command)[0]
        record["benches"][name] = json.loads(text)["benchmarks"] if name == "claims" else text
        print(f"{name}: measured", flush=True)


def seconds(x):
    return f"{x:.2f} s" if x < 1 else f"{x:.1f} s" if x < 20 else f"{x:.0f} s"


def memory(mib):
    return f"{mib:.0f} MiB" if mib < 1000 else f"{mib / 1024:.1f} GiB"


def decimals(x, digits, rounded):
    """Rounded to the side on which the bound is one."""
    return f"{rounded(x * 10**digits) / 10**digits:.{digits}f}"


def thousands(n):
    return f"{n:,}".replace(",", " ")


TITLES = {"torus-2": "torus ℝ²/ℤ²", "torus-3": "torus ℝ³/ℤ³", "sphere-2": "sphere 𝕊²", "sphere-3": "sphere 𝕊³",
          "poincare-sphere": "Poincaré's sphere", "seifert-weber-space": "Seifert–Weber space"}


class Tables:
    def __init__(self, record):
        self.record = record
        self.identity = identity_of(record)

    def of(self, run):
        return self.record["runs"].get(run.name)

    def mark(self, run):
        return "" if self.of(run)["programs"] == self.identity else " †"

    @staticmethod
    def table(head, aligned, rows):
        return "\n".join([head, aligned] + ["| " + " | ".join(row) + " |" for row in rows]) + "\n"

    def readme_tori(self):
        rows = []
        for run in TORI:
            if run.manifold == "torus-2-skewed" or run.radius == "1/24" and run.manifold == "torus-2":
                continue
            one = self.of(run)
            level_3 = one["stages"]["search forbidden configurations"]
            rows.append([f"{TITLES[run.manifold]}, ε = {run.radius}{self.mark(run)}", thousands(one["counts"]["points"]),
                         seconds(one["certify"]["user"]), seconds(level_3), seconds(one["check"]["user"]),
                         memory(max(one["certify"]["mib"], one["check"]["mib"]))])
        return self.table("| | points | certify | of which level 3 | check | peak memory |", "|---|--:|--:|--:|--:|--:|",
                          rows)

    def readme_forms(self):
        rows = []
        for run in FORMS:
            one = self.of(run)
            if one:
                rows.append([f"{TITLES[run.manifold]}, ε = {run.radius}{self.mark(run)}",
                             thousands(one["counts"]["points"]), seconds(one["certify"]["wall"]),
                             seconds(one["check"]["wall"]), memory(max(one["certify"]["mib"], one["check"]["mib"])),
                             " ".join(one["counts"]["levels"])])
        return self.table("| | points | certify | check | peak memory | levels |", "|---|--:|--:|--:|--:|---|", rows)

    def whole_runs(self):
        names = [("sample", ("read or sample the net", "throw darts", "fill gaps")), ("density", ("measure density",)),
                 ("perturb", ("perturb",)), ("triangulate", ("triangulate",)), ("stars", ("certify stars",)),
                 ("levels", ("derive levels",)), ("write", ("write the certificate",))]
        rows = []
        for run in TORI:
            one = self.of(run)
            stages = one["stages"]
            level_3 = stages["search forbidden configurations"]
            rest = sum(stages.values()) - level_3
            points = one["counts"]["points"]
            rows.append([f"{run.manifold}, {run.radius}{self.mark(run)}", str(points), str(one["counts"]["simplices"])] +
                        [f"{sum(stages[part] for part in parts):.3f}" for _, parts in names] +
                        [f"{rest:.3f}", f"{level_3:.3f}", f"{1e6 * (rest + level_3) / points:.1f}",
                         f"{one['certify']['mib']:.0f}"])
        head = "| net | points | simplices | " + " | ".join(name for name, _ in names)
        return self.table(head + " | rest | level 3 | µs a point | peak MiB |", "|---|" + "--:|" * 13, rows)

    def checks_of_tori(self):
        rows = [[f"{run.manifold}, {run.radius}{self.mark(run)}", f"{one['check']['user']:.2f}", f"{one['check without 3']['user']:.2f}",
                 f"{one['check']['user'] / one['certify']['user']:.2f}", f"{one['check']['mib']:.0f}"]
                for run, one in ((run, self.of(run)) for run in TORI)
                if (run.manifold, run.radius) not in (("torus-2", "1/24"), ("torus-2-skewed", "1/24"),
                                                      ("torus-2-skewed", "1/100"))]
        return self.table("| net | all levels, s | without level 3, s | check : certify | peak MiB |",
                          "|---|--:|--:|--:|--:|", rows)

    def checks_by_levels(self):
        chosen = [TORI[6], FORMS[0], SIZES[2], FORMS[1]] + FORMS[2:]
        rows = []
        for run in chosen:
            one = self.of(run)
            if one and "check 2 4 5 6" in one:
                certify, core, every = one["certify"]["user"], one["check 2 4 5 6"], one["check"]["user"]
                rows.append([f"{run.manifold}, {run.radius}{self.mark(run)}", thousands(one["counts"]["points"]), f"{certify:.2f}",
                             f"{core:.2f}", f"{core / certify:.3f}", f"{every:.2f}", f"{every / certify:.2f}"])
        return self.table("| run | points | certify, s | check 2 4 5 6, s | : certify | check, s | : certify |",
                          "|---|--:|--:|--:|--:|--:|--:|", rows)

    def members(self):
        rows = []
        for run in MEMBERS:
            one = self.of(run)
            if one:
                counted = one["counts"]
                member, statistics_ = counted["member"], counted["statistics"]
                protection, thickness, circumradius = member["margins"]
                rows.append([run.manifold + self.mark(run), run.radius, str(counted["points"]), str(counted["simplices"]),
                             f"{statistics_['tries'] / statistics_['placements']:.1f}", str(member["raw"]),
                             str(member["differ"]), decimals(protection, 5, math.floor), decimals(thickness, 4, math.floor),
                             decimals(circumradius, 3, math.ceil), " ".join(counted["levels"]),
                             ", ".join(member["homology"])])
        return self.table("| manifold | ε | points | simplices | tries | raw | differ | δ/ε ≥ | thickness ≥ | R/ε ≤ | levels | homology |",
                          "|---|---|" + "--:|" * 8 + "---|---|", rows)

    def costs_of_members(self):
        rows = []
        for run in MEMBERS:
            one = self.of(run)
            if one:
                stages = one["stages"]
                net = sum(stages.get(part, 0) for part in ("verify the group", "read or sample the net", "throw darts", "fill gaps"))
                rows.append([run.manifold + self.mark(run), run.radius, f"{net:.2f}",
                             f"{stages.get('colour', 0) + stages['perturb']:.2f}", f"{one['certify']['wall']:.2f}",
                             f"{one['check']['user']:.2f}", f"{one['check 2 4 5 6']:.2f}", f"{one['certify']['mib']:.0f}",
                             f"{one['check']['mib']:.0f}"])
        return self.table("| manifold | ε | group, net | perturb | certify | check | of which 2 4 5 6 | MiB | MiB, check |",
                          "|---|---|" + "--:|" * 7, rows)

    def hinges(self):
        wrong = [f"{member['hinges'][0] + member['hinges'][1]} of {member['hinges'][2]} of {run.manifold} at {run.radius}"
                 for run, member in ((run, self.of(run)["counts"]["member"]) for run in MEMBERS if self.of(run))
                 if member["hinges"][0] + member["hinges"][1] > 0]
        return (", ".join(wrong) or "none") + "; of the other members none.\n"

    def zero_sets(self):
        rows = []
        for run in ZERO_SETS:
            one = self.of(run)
            if one and "zero set" in one["counts"]:
                counted = one["counts"]
                found = counted["zero set"]
                radius = " ".join([run.radius, *(option for key, option in zip(run.options[::2], run.options[1::2]) if key != "--levels")])
                rows.append([run.manifold + self.mark(run), radius, thousands(counted["points"]),
                             thousands(found["uniformly"]) if found.get("uniformly") else "–",
                             thousands(counted["simplices"]), " ".join(counted["levels"]),
                             decimals(found["contraction"], 3, math.ceil), decimals(found["displacement"], 3, math.ceil),
                             decimals(found["isotopy"], 3, math.floor) if found["isotopy"] else "–",
                             found["delaunay"] or "–",
                             f"{100 * found['stable'][0] / found['stable'][1]:.0f} %" if found.get("stable") else "–",
                             decimals(found["normal"], 3, math.ceil) if found["normal"] else "–",
                             ", ".join(found["homology"]), f"{one['certify']['wall']:.1f}", f"{one['check']['user']:.1f}",
                             f"{max(one['certify']['mib'], one['check']['mib']):.0f}"])
        return self.table("| manifold | ε, sizing, refinements | points | uniformly | simplices | levels | γ ≤ | ω/ε ≤ | 5i/ε ≥ | level 4 | 4.stability | normal ≤ | homology | certify, s | check, s | MiB |",
                          "|---|---|--:|--:|--:|---|--:|--:|--:|---|--:|--:|---|--:|--:|--:|", rows)

    def atlases(self):
        rows = []
        for run in ATLASES:
            one = self.of(run)
            if one:
                counted, found = one["counts"], one["counts"]["atlas"]
                rows.append([run.manifold + self.mark(run), run.radius, thousands(counted["points"]), thousands(counted["simplices"]),
                             " ".join(counted["levels"]), decimals(found["protection"], 4, math.floor),
                             decimals(found["thickness"], 3, math.floor),
                             decimals(found["displacement"], 3, math.ceil) if found["displacement"] else "–",
                             decimals(found["contraction"], 3, math.ceil) if found["contraction"] else "–",
                             ", ".join(found["homology"]), f"{one['certify']['wall']:.1f}", f"{one['check']['user']:.1f}"])
        return self.table("| atlas | ε | points | simplices | levels | δ/ε ≥ | thickness ≥ | λ/ε ≤ | γ ≤ | homology | certify, s | check, s |",
                          "|---|---|--:|--:|---|--:|--:|--:|--:|---|--:|--:|", rows)

    def sizes(self):
        rows = []
        for run in SIZES:
            one = self.of(run)
            if one:
                points = one["counts"]["points"]
                rows.append([run.radius + self.mark(run), thousands(points)] +
                            [part for step in ("certify", "check") for part in
                             (f"{one[step]['user']:.2f}", f"{1e6 * one[step]['user'] / points:.0f}",
                              thousands(round(one[step]["mib"])))])
        return self.table("| ε | points | certify, s | µs a point | MiB | check, s | µs a point | MiB |",
                          "|---|--:|--:|--:|--:|--:|--:|--:|", rows)

    def threads(self):
        rows = [[f"{runs[0].manifold}, ε = {runs[0].radius}, {thousands(self.of(runs[0])['counts']['points'])} points"] +
                [f"{self.of(run)['certify']['wall']:.1f} s{self.mark(run)}" for run in runs] for runs in THREADS]
        return self.table("| run | 1 thread | 2 threads | 4 threads |", "|---|--:|--:|--:|", rows)

    def times_of_claims(self):
        """By claim, or claim:conclusion, and by what is measured."""
        times = {}
        for one in self.record["benches"]["claims"]:
            claim, _, how = one["name"].split("/")[:3]
            times.setdefault(claim, {})[how] = one
        return times

    def claims(self):
        rows = []
        for claim, by in self.times_of_claims().items():
            if ":" in claim:
                each = {how: 1e6 * by[how]["each"] for how in ("ladder", "256_bits")}
                name, conclusion = claim.split(":")
                rows.append([f"`{name}`, `{conclusion}`", f"{each['ladder']:.1f} µs", f"{each['256_bits']:.1f} µs",
                             f"1 : {each['256_bits'] / each['ladder']:.2f}", f"{100 * by['ladder']['filter']:.1f} %"])
        return self.table("| conclusion, k = 3, m = 3 | ladder | 256 bits | ladder : 256 bits | by the filter |", "|---|--:|--:|--:|--:|", rows)

    def samples_of_claims(self):
        rows = []
        for claim, by in self.times_of_claims().items():
            if "rationals" in by:
                each = {how: 1e6 * by[how]["each"] for how in ("sample", "ladder", "rationals", "fraction_free")}
                rows.append([f"`{claim}`", *(f"{time:.1f} µs" for time in each.values()),
                             f"{each['sample'] / each['rationals']:.2f} : 1", f"{each['sample'] / each['fraction_free']:.2f} : 1"])
        return self.table("| claim, k = 3, m = 3 | a whole sample | of which decisions | in fractions | without | sample : fractions | : without |",
                          "|---|--:|--:|--:|--:|--:|--:|", rows)

    def all(self):
        result = {"readme-tori": self.readme_tori(), "readme-forms": self.readme_forms(), "whole-runs": self.whole_runs(),
                  "checks-of-tori": self.checks_of_tori(), "checks-by-levels": self.checks_by_levels(),
                  "sizes": self.sizes(), "threads": self.threads(), "members": self.members(),
                  "members-costs": self.costs_of_members(), "members-hinges": self.hinges(),
                  "zero-sets": self.zero_sets(), "atlases": self.atlases()}
        for name, text in self.record["benches"].items():
            result[name] = self.claims() if name == "claims" else text
            if name == "claims":
                result["claims-samples"] = self.samples_of_claims()
        return result


def rendered(text, tables):
    """The page with its tables in the places of those between marks that there are; others stay."""
    return MARK.sub(lambda found: found[1] + tables.get(found[2], found[0][len(found[1]):-len(found[3])]) + found[3], text)


def pages(root):
    return [root / "README.md", root / "docs/performance.md", root / "docs/space-forms.md", root / "docs/submanifolds.md",
            root / "docs/atlases.md"]


def render(root, record):
    tables = Tables(record).all()
    for page in pages(root):
        page.write_text(rendered(page.read_text(), tables))


def difference(recorded, counted, path=""):
    """The first place where the two differ."""
    if isinstance(recorded, dict) and isinstance(counted, dict):
        for key in sorted(recorded.keys() | counted.keys()):
            if recorded.get(key) != counted.get(key):
                return difference(recorded.get(key), counted.get(key), f"{path}/{key}")
    return f"{path or '/'}: recorded {recorded}, now {counted}"


def counted_with(build, file):
    """What the programs of a build folder count in a cheap run, by its name; kept in a file, if one is named, for the next call."""
    known = json.loads(file.read_text()) if file and file.exists() else {}

    def counted(name, run):
        if name not in known:
            with tempfile.TemporaryDirectory() as folder:
                known[name] = once(run, build, folder)["counts"]
            if file:
                file.write_text(json.dumps(known))
        return known[name]

    return counted


def check(root, record, counted):
    complaints = []
    tables = Tables(record).all()
    marks = [mark for page in pages(root) for mark in MARK.findall(page.read_text())]
    for name in sorted(Tables(record).all().keys() - {mark[1] for mark in marks}):
        complaints.append(f"the table {name} stands nowhere")
    for page in pages(root):
        if rendered(page.read_text(), tables) != page.read_text():
            complaints.append(f"{page.name}: a table is not that of bench/costs.json: bench/costs.py render")
    older = False
    for name, run in ALL.items():
        # One complaint of this kind is enough.
        if run.cheap and not older:
            found = counted(name, run)
            older = found != record["runs"][name]["counts"]
            if older:
                complaints.append(f"{name}: the tables are older than the programs: bench/costs.py measure\n    "
                                  + difference(record["runs"][name]["counts"], found))
    print("\n".join(complaints) or "the tables are of these programs")
    return 1 if complaints else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("action", choices=["measure", "render", "check"])
    parser.add_argument("--build", type=Path, default=ROOT / "build/release")
    parser.add_argument("--long", action="store_true")
    parser.add_argument("--members", action="store_true")
    parser.add_argument("--only", metavar="REGEX", help="measure the runs whose names this finds, and nothing else")
    parser.add_argument("--root", type=Path, default=ROOT, help="where the pages and the record are")
    parser.add_argument("--counts", type=Path, metavar="FILE", help="check: what the programs count is kept here, for another check")
    arguments = parser.parse_args()
    file = arguments.root / "bench/costs.json"
    record = json.loads(file.read_text()) if file.exists() else {"runs": {}, "benches": {}}
    if arguments.action == "check":
        return check(arguments.root, record, counted_with(arguments.build, arguments.counts))
    if arguments.action == "measure":
        measure_all(arguments, record, file)
        write(file, record)
    render(arguments.root, record)
    return 0


if __name__ == "__main__":
    sys.exit(main())
