#!/usr/bin/env python3
"""What builds cost: measures it in a fresh clone without a compiler cache, records it in bench/builds.json, and writes the
table of docs/performance.md between its marks and cmake/build-costs.tsv, from which ./run and ./test say what they will take.

  bench/builds.py measure [--commit REVISION] [--name NAME] [--jobs N] [--all]
                                 the programs, one after the other, as ./run builds them; with --all also everything, as ./test
                                 does. Without --commit: the commit that stands here, under the name `now`
  bench/builds.py render         the table and the file again from the record
  bench/builds.py check          whether they are those of the record

Processor seconds are those of all compilers and linkers together. Other work on the machine makes them more, by a third and above
where several processes wait for each core, so the table has the load: how many processes ran or waited, ours among them.
"""

import argparse
import json
import os
import re
import resource
import subprocess
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
MARK = re.compile(r"(<!-- builds -->\n).*?(<!-- builds: end -->)", re.DOTALL)
PROGRAMS = ["delcert", "delcert-check", "delcert-publish", "delcert-claims"]


def run(command, folder):
    result = subprocess.run(command, cwd=folder, env={**os.environ, "CCACHE_DISABLE": "1"}, stdout=subprocess.PIPE,
                            stderr=subprocess.STDOUT, text=True)
    if result.returncode != 0:
        raise SystemExit(f"builds.py: exit status {result.returncode}: {' '.join(command)}\n{result.stdout}")
    return result.stdout


def megabytes_in(folder):
    """What the files of a folder take on the disk."""
    return sum(path.lstat().st_blocks * 512 for path in folder.rglob("*") if not path.is_symlink()) / 1e6


def built(clone, build, target, jobs):
    """What this target costs on top of what has been built: jobs, processor seconds, seconds, megabytes."""
    before, begin, size = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic(), megabytes_in(build)
    output = run(["ninja", "-C", str(build), "-j", str(jobs), target], clone)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    steps = re.findall(r"^\[\d+/(\d+)\]", output, re.MULTILINE)
    return {"steps": int(steps[-1]) if steps else 0,
            "processor": round(after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime),
            "wall": round(time.monotonic() - begin), "load": round(os.getloadavg()[2], 1),
            "megabytes": round(megabytes_in(build) - size)}


def configured(clone, folder, tests):
    run(["cmake", "-S", ".", "-B", str(folder), "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", f"-DDELCERT_TESTS={tests}",
         "-DDELCERT_STRICT_TWINS=ON", "-DDELCERT_UNITED_SOURCES=ON"], clone)
    return folder


def has_target(clone, build, target):
    return subprocess.run(["ninja", "-C", str(build), "-t", "query", target], cwd=clone, capture_output=True).returncode == 0


def measured(commit, jobs, everything):
    with tempfile.TemporaryDirectory() as work:
        clone = Path(work) / "clone"
        run(["git", "clone", "--quiet", "--no-checkout", str(ROOT), str(clone)], work)
        run(["git", "checkout", "--quiet", commit], clone)
        commit = run(["git", "rev-parse", "--short=10", "HEAD"], clone).strip()
        build = configured(clone, clone / "build/programs", "OFF")
        targets = {target: built(clone, build, target, jobs) for target in PROGRAMS if has_target(clone, build, target)}
        if everything:
            targets["all"] = built(clone, configured(clone, clone / "build/all", "ON"), "all", jobs)
        return {target: {"commit": commit, **one} for target, one in targets.items()}


def sums_of(targets):
    """The rows of a record: what is called for, at which commit, and what that costs from nothing."""
    parts = [targets[name] for name in PROGRAMS[:2]]
    rows = [("`./run`: certify and check", parts)]
    for name, title in zip(PROGRAMS[2:], ["and then export, report", "and then attack, prove"]):
        if name in targets:
            parts = parts + [targets[name]]
            rows.append((title, parts))
    if "all" in targets:
        rows.append(("`./test`: everything", [targets["all"]]))
    return [(title, parts[-1]["commit"], max(part["load"] for part in parts),
             {key: sum(part[key] for part in parts) for key in ("steps", "processor", "megabytes")}) for title, parts in rows]


def table(record):
    lines = ["| | what is built | steps | processor seconds | load | minutes on two cores | MB in `build/` |",
             "|---|---|--:|--:|--:|--:|--:|"]
    for name, one in record.items():
        for title, commit, load, total in sums_of(one):
            lines.append(f"| {name}, {commit} | {title} | {total['steps']} | {total['processor']} | {load} | "
                         f"{total['processor'] / 120:.1f} | {total['megabytes']} |")
    return "\n".join(lines) + "\n"


def costs(record):
    lines = ["# What building costs, by bench/builds.py measure: target, processor seconds, MB in the build folder.\n"]
    lines += [f"{name} {one['processor']} {one['megabytes']}\n" for name, one in record["now"].items()]
    return "".join(lines)


def rendered(root):
    """The files that the record decides, and what they should be."""
    record = json.loads((root / "bench/builds.json").read_text())
    page = root / "docs/performance.md"
    text, count = MARK.subn(lambda match: match[1] + table(record) + match[2], page.read_text())
    if count != 1:
        raise SystemExit(f"builds.py: {page} has {count} places for the table")
    return {page: text, root / "cmake/build-costs.tsv": costs(record)}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("action", choices=["measure", "render", "check"])
    parser.add_argument("--commit", default="HEAD")
    parser.add_argument("--name", default="now")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--all", action="store_true")
    parser.add_argument("--root", type=Path, default=ROOT)
    arguments = parser.parse_args()
    record_file = arguments.root / "bench/builds.json"
    if arguments.action == "measure":
        record = json.loads(record_file.read_text()) if record_file.exists() else {}
        # What is not measured this time stays.
        record.setdefault(arguments.name, {}).update(measured(arguments.commit, arguments.jobs, arguments.all))
        record_file.write_text(json.dumps(record, indent=1) + "\n")
    files = rendered(arguments.root)
    if arguments.action == "check":
        stale = [path for path, text in files.items() if not path.exists() or path.read_text() != text]
        for path in stale:
            print(f"{path.relative_to(arguments.root)}: not what bench/builds.json says: bench/builds.py render")
        raise SystemExit(1 if stale else 0)
    for path, text in files.items():
        path.write_text(text)


if __name__ == "__main__":
    main()
