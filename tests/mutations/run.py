#!/usr/bin/env python3
"""Breaks the project on purpose, one place at a time, and fails unless the test named for it fails then.

run.py --check                      every mutation fits the sources, and docs/mutations.md lists it
run.py --write                      writes the table of docs/mutations.md
run.py --build BUILD [NAME…]        applies these mutations, or all
run.py --build BUILD --sample N     applies the N mutations whose turn it is today, or on $DELCERT_MUTATIONS_DAY

mutations/NAME.txt has a comment that says what breaks, and lines `key: value`:
  file       what is changed
  from, to   a text that occurs once in the file, and what it becomes
  test       the test source that has to fail
  only       the tests of that source that run, as a filter of GoogleTest; all if left out
  with       further sources that are compiled with the mutation, or that the test needs, with blanks between
  program    if the test runs a program: that one, which is linked with the mutation; the test is the one that is built

The sources stay as they are: the changed file is put into a folder of its own that the compiler looks through first,
the test source and the sources of the mutation are compiled with the flags of their targets, and the linker takes them
in place of what is in the libraries of BUILD. The same program is also made without the mutation, and has to pass. Tests of
delcert-check run the program that DELCERT_CHECK names, so that a mutation of the checker needs no test of its own.
"""
import argparse
import concurrent.futures
import datetime
import json
import os
import re
import resource
import shlex
import subprocess
import sys
import tempfile
import threading
from pathlib import Path

FOLDER = Path(__file__).resolve().parent
PROJECT = FOLDER.parent.parent
PAGE = PROJECT / "docs/mutations.md"
BEGIN, END = "<!-- mutations: generated -->\n", "<!-- mutations: end -->\n"
KEYS = {"file", "from", "to", "test", "only", "with", "program"}
OPTIONAL = {"only", "with", "program"}
# Programs that tests run, and what names another one in their environment.
PROGRAMS = {"proofs/checker/delcert-check": "DELCERT_CHECK"}
SECONDS_OF_A_TEST = 900


def stop(message):
    sys.exit(f"mutations: {message}")


class Mutation:
    def __init__(self, path):
        self.name = path.stem
        lines = path.read_text().splitlines()
        self.what = " ".join(line[2:] for line in lines if line.startswith("# "))
        fields = dict(line.split(": ", 1) for line in lines if ": " in line and not line.startswith("# "))
        if not self.what or set(fields) - KEYS or KEYS - OPTIONAL - set(fields):
            stop(f"{path.name}: a comment and the keys {', '.join(sorted(KEYS))} were expected")
        self.file, self.old, self.new, self.test = (fields[key] for key in ("file", "from", "to", "test"))
        self.only = fields.get("only", "*")
        self.sources = fields.get("with", "").split()
        self.runs = fields.get("program")

    def text(self):
        """The file with the mutation in it."""
        if not (PROJECT / self.file).is_file():
            stop(f"{self.name}: there is no {self.file}")
        text = (PROJECT / self.file).read_text()
        if text.count(self.old) != 1:
            stop(f"{self.name}: its text is {text.count(self.old)} times in {self.file}, not once")
        return text.replace(self.old, self.new)

    def compiled(self):
        """What is compiled, the mutated source first if it is one."""
        own = [self.file] if self.file.endswith(".cpp") else []
        if self.runs:
            return [*own, *self.sources]
        return own + [source for source in [self.test, *self.sources] if source not in own]

    def row(self):
        """Of the table, in which a vertical bar would end a cell."""
        test = self.test.removeprefix("tests/")
        only = "" if self.only == "*" else f", `{self.only}`"
        return f"| `{self.name}` | {self.what} | `{self.file}` | `{test}`{only} |\n".replace("||", "\\|\\|")


def table(mutations):
    rows = "".join(m.row() for m in sorted(mutations, key=lambda m: (m.file, m.name)))
    return f"{len(mutations)} mutations:\n\n| mutation | what breaks | where | caught by |\n|---|---|---|---|\n{rows}"


def check(mutations):
    for mutation in mutations:
        if mutation.text() == (PROJECT / mutation.file).read_text():
            stop(f"{mutation.name} changes nothing")
        for source in mutation.compiled():
            if not (PROJECT / source).is_file():
                stop(f"{mutation.name}: there is no {source}")
        if mutation.runs not in {None, *PROGRAMS}:
            stop(f"{mutation.name}: no test runs {mutation.runs}")
        if mutation.runs and not mutation.compiled():
            stop(f"{mutation.name}: of a header, `with` names the sources that are compiled")
        if not re.search(r"\b(TEST|RC_GTEST)", (PROJECT / mutation.test).read_text()):
            stop(f"{mutation.name}: {mutation.test} has no tests")


class Build:
    """The commands of a build that has been made, for sources of our own choice."""

    def __init__(self, folder):
        self.folder = Path(folder).resolve()
        self.command_of, self.target_of = {}, {}
        for entry in json.loads((self.folder / "compile_commands.json").read_text()):
            words = shlex.split(entry["command"])
            target = words[words.index("-o") + 1].split(".dir/")[0].replace("CMakeFiles/", "")
            united = re.findall(r'^#include "(/.*)"', Path(entry["file"]).read_text(), re.M) if "/Unity/" in entry["file"] else []
            for source in [entry["file"], *united]:
                if Path(source).is_relative_to(PROJECT):
                    name = str(Path(source).relative_to(PROJECT))
                    self.command_of.setdefault(name, words)
                    self.target_of.setdefault(name, target)
        self.links = {}

    def compile_command(self, source, overlay, into):
        words = self.command_of.get(str(source)) or stop(f"{source} is in no target of {self.folder}")
        words = words[: words.index("-o")]
        at = next(i for i, word in enumerate(words) if word.startswith("-I"))
        # A header that is read in advance would be read as it was.
        if (overlay / "kernel/number").is_dir() and "-include" in words:
            del words[words.index("-include") : words.index("-include") + 2]
        path = overlay / source if (overlay / source).exists() else PROJECT / source
        return [*words[:at], f"-I{overlay}", *words[at:], "-w", "-o", str(into), "-c", str(path)]

    def link_command(self, target, objects, into, own):
        """`own`: the objects of the target, too, except for what `objects` define."""
        if target not in self.links:
            commands = subprocess.run(["ninja", "-C", str(self.folder), "-t", "commands", "-s", target],
                                      capture_output=True, text=True).stdout.splitlines()
            line = next(line for line in reversed(commands) if f" -o {target} " in line)
            self.links[target] = shlex.split(line.split(" && ")[1] if line.startswith(": &&") else line)
        words = [word for word in self.links[target] if own or not word.endswith(".o")]
        at = words.index("-o")
        return [*words[:at], "-Wl,-z,muldefs", *map(str, objects), "-o", str(into), *words[at + 2 :]]


def run_command(command, folder):
    result = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    if result.returncode != 0:
        raise RuntimeError((result.stderr or result.stdout)[-2000:])


class Programs:
    """Test programs with and without mutations; what several have in common is made once."""

    def __init__(self, build, work):
        self.build, self.work = build, work
        self.lock, self.made = threading.Lock(), {}

    def once(self, key, make):
        """The result of `make`, which runs once for each key; its exception, too, is the same for all."""
        with self.lock:
            waiting = self.made.get(key)
            if mine := waiting is None:
                waiting = self.made[key] = concurrent.futures.Future()
                name = str(len(self.made))
        if mine:
            try:
                waiting.set_result(make(self.work / name))
            except (RuntimeError, OSError) as error:
                waiting.set_exception(error)
        return waiting.result()

    def compiled(self, source, overlay):
        def make(folder):
            folder.mkdir()
            run_command(self.build.compile_command(source, overlay, folder / "object.o"), self.build.folder)
            return folder / "object.o"

        return self.once((source, overlay), make)

    def program(self, mutation, overlay):
        """The test's, or the one that it runs. `overlay`: the folder with the mutation, or an empty one."""
        nothing = self.work / "nothing"
        is_header = not mutation.file.endswith(".cpp")
        objects = [self.compiled(source, overlay if is_header or source == mutation.file else nothing)
                   for source in mutation.compiled()]

        def make(folder):
            folder.mkdir()
            target = mutation.runs or self.build.target_of[mutation.test]
            command = self.build.link_command(target, objects, folder / "program", own=mutation.runs is not None)
            run_command(command, self.build.folder)
            return folder / "program"

        return self.once((mutation.runs, *objects), make)

    def outcome(self, mutation, overlay):
        """Of the test with that program."""
        program = self.program(mutation, overlay)
        if not mutation.runs:
            return outcome_of(program, mutation.only)
        return outcome_of(self.build.folder / self.build.target_of[mutation.test], mutation.only,
                          {PROGRAMS[mutation.runs]: str(program)})


def outcome_of(program, only, more={}):
    """passed, failed, or what else happened; and the tests that failed. `more`: what is added to the environment."""
    environment = dict(os.environ, **more, RC_PARAMS=os.environ.get("RC_PARAMS", "seed=1 max_success=100"))
    try:
        result = subprocess.run([program, f"--gtest_filter={only}"], env=environment, cwd=program.parent,
                                capture_output=True, text=True, errors="replace", timeout=SECONDS_OF_A_TEST)
    except subprocess.TimeoutExpired:
        return "came to no end", []
    failed = sorted(set(re.findall(r"^\[  FAILED  \] ([\w/]+\.[\w./]+)", result.stdout, re.M)))
    if result.returncode == 1 and failed:
        return "failed", failed
    if result.returncode == 0 and re.search(r"^\[  PASSED  \] [1-9]", result.stdout, re.M):
        return "passed", []
    return f"ended with status {result.returncode}", []


def apply(programs, mutation):
    """Whether it was caught, and a line about it."""
    overlay = programs.work / mutation.name
    (overlay / mutation.file).parent.mkdir(parents=True)
    (overlay / mutation.file).write_text(mutation.text())
    try:
        outcome, failed = programs.outcome(mutation, overlay)
    except RuntimeError as error:
        return False, f"NOT CAUGHT: {mutation.name} does not build: {error}"
    if outcome != "failed":
        return False, f"NOT CAUGHT: {mutation.name}: {mutation.test} {outcome}"
    try:
        nothing = programs.work / "nothing"
        key = (programs.program(mutation, nothing), mutation.test, mutation.only)
        without, others = programs.once(key, lambda _: programs.outcome(mutation, nothing))
    except RuntimeError as error:
        return False, f"NOT CAUGHT: {mutation.name}: {mutation.test} does not build without the mutation: {error}"
    if without != "passed":
        return False, f"NOT CAUGHT: {mutation.name}: {mutation.test} without the mutation: {without} {' '.join(others)}"
    return True, f"caught: {mutation.name} by {failed[0]}" + (f" and {len(failed) - 1} more" if len(failed) > 1 else "")


def sample_of(mutations, count):
    day = os.environ.get("DELCERT_MUTATIONS_DAY") or datetime.date.today().isoformat()
    try:
        first = datetime.date.fromisoformat(day).toordinal() * count
    except ValueError:
        stop(f"DELCERT_MUTATIONS_DAY={day}: a date such as 2026-11-24 was expected")
    chosen = [mutations[(first + at) % len(mutations)] for at in range(min(count, len(mutations)))]
    print(f"the sample of {day}, {count} of {len(mutations)}; repeat it with DELCERT_MUTATIONS_DAY={day}", flush=True)
    return chosen


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--write", action="store_true")
    parser.add_argument("--build")
    parser.add_argument("--sample", type=int)
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("names", nargs="*")
    options = parser.parse_args()
    everything = [Mutation(path) for path in sorted((FOLDER / "mutations").glob("*.txt"))]
    unknown = set(options.names) - {m.name for m in everything}
    if unknown:
        stop(f"there is no mutation {', '.join(sorted(unknown))}")
    chosen = [m for m in everything if not options.names or m.name in options.names]
    check(chosen)
    page = PAGE.read_text()
    head, rest = page.split(BEGIN)
    listed, tail = rest.split(END)
    if options.write:
        PAGE.write_text(head + BEGIN + table(everything) + END + tail)
    elif listed != table(everything):
        stop("docs/mutations.md does not list the mutations as they are: tests/mutations/run.py --write")
    if options.check or options.write:
        print(f"{len(chosen)} mutations fit the sources")
        return 0
    build = Build(options.build or stop("--build or --check"))
    if options.sample:
        chosen = sample_of(chosen, options.sample)
    caught = 0
    with tempfile.TemporaryDirectory(prefix="delcert-mutations-") as work:
        with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
            (Path(work) / "nothing").mkdir()
            programs = Programs(build, Path(work))
            waiting = [pool.submit(apply, programs, m) for m in chosen]
            for result in concurrent.futures.as_completed(waiting):
                is_caught, line = result.result()
                caught += is_caught
                print(line, flush=True)
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    print(f"{caught} of {len(chosen)} mutations caught, {used.ru_utime + used.ru_stime:.0f} s of processor time")
    return 0 if caught == len(chosen) else 1


if __name__ == "__main__":
    sys.exit(main())
