"""run_test.py BUILD: what run.py must not count as caught."""
import contextlib
import importlib.util
import io
import os
import sys
import tempfile
from pathlib import Path

FOLDER = Path(__file__).resolve().parent
sys.argv = ["run.py", "--check"]
specification = importlib.util.spec_from_file_location("run", FOLDER / "run.py")
run = importlib.util.module_from_spec(specification)
specification.loader.exec_module(run)
failures = 0


def expect(name, condition, more=""):
    global failures
    if not condition:
        failures += 1
        print(f"FAILED: {name} {more}")


def refusal(call):
    try:
        call()
    except SystemExit as stopped:
        return str(stopped.code)
    return "accepted"


def script(folder, text):
    path = Path(folder) / "program"
    path.write_text(f"#!/bin/sh\n{text}\n")
    path.chmod(0o755)
    return path


GOOD = """# The number is another one.
file: proofs/replay/number.hpp
from: #pragma once
to: #pragma  once
test: tests/proofs/replay/number_test.cpp
"""
with tempfile.TemporaryDirectory() as folder:
    path = Path(folder) / "some.txt"

    def mutation(text):
        path.write_text(text)
        return run.Mutation(path)

    expect("a good one", refusal(lambda: run.check([mutation(GOOD)])) == "accepted")
    for name, old, new, why in [
        ("a text that is not there", "#pragma once", "#pragma twice", "0 times"),
        ("a text that is there often", "#pragma once", "Number", "times in"),
        ("no such file", "number.hpp", "none.hpp", "there is no"),
        ("no such test", "number_test", "none_test", "there is no"),
        ("a test source without tests", "tests/proofs/replay/number_test.cpp", "proofs/replay/main.cpp", "has no tests"),
        ("nothing changes", "to: #pragma  once", "to: #pragma once", "changes nothing"),
        ("a program that no test runs", "test:", "program: delcert\ntest:", "no test runs delcert"),
        ("a program and nothing compiled", "test:", "program: proofs/checker/delcert-check\ntest:", "names the sources"),
        ("an unknown key", "test:", "tests:", "were expected"),
        ("no comment", "# The number is another one.\n", "", "were expected"),
    ]:
        got = refusal(lambda: run.check([mutation(GOOD.replace(old, new, 1))]))
        expect(name, why in got, got)

    failed = "echo '[  FAILED  ] Suite.name (0 ms)'; echo '[  FAILED  ] 1 test, listed below:'"
    expect("a failure", run.outcome_of(script(folder, f"{failed}; exit 1"), "*") == ("failed", ["Suite.name"]))
    expect("a pass", run.outcome_of(script(folder, "echo '[  PASSED  ] 3 tests.'"), "*") == ("passed", []))
    expect("no test", run.outcome_of(script(folder, "echo '[  PASSED  ] 0 tests.'"), "*")[0] == "ended with status 0")
    expect("a crash", run.outcome_of(script(folder, f"{failed}; kill -SEGV $$"), "*")[0] == "ended with status -11")
    expect("an exit", run.outcome_of(script(folder, "exit 1"), "*")[0] == "ended with status 1")

    class Programs:
        """In the place of those that are compiled: what the program does with the mutation, and without."""

        def __init__(self, with_mutation, without):
            self.work = Path(tempfile.mkdtemp(dir=folder))
            self.outputs = (without, with_mutation)

        def outcome(self, mutation, overlay):
            return run.outcome_of(self.program(mutation, overlay), mutation.only)

        def program(self, mutation, overlay):
            output = self.outputs[(overlay / mutation.file).exists()]
            if output is None:
                raise RuntimeError("no program")
            return script(tempfile.mkdtemp(dir=folder), output)

        def once(self, key, make):
            return make(None)

    broken, right = f"{failed}; exit 1", "echo '[  PASSED  ] 1 test.'"
    for name, with_mutation, without, caught, why in [
        ("caught", broken, right, True, "caught: some by Suite.name"),
        ("not noticed", right, right, False, "passed"),
        ("does not build", None, right, False, "does not build"),
        ("fails anyway", broken, broken, False, "without the mutation: failed Suite.name"),
        ("does not build anyway", broken, None, False, "does not build without"),
    ]:
        got = run.apply(Programs(with_mutation, without), mutation(GOOD))
        expect(name, got[0] == caught and why in got[1], got)

# Over as many days as there are mutations, each has its turn; a day has always the same.
everything = list(range(7))


def sample(day):
    os.environ["DELCERT_MUTATIONS_DAY"] = day
    with contextlib.redirect_stdout(io.StringIO()) as printed:
        chosen = run.sample_of(everything, 2)
    expect("the day is printed", day in printed.getvalue())
    return chosen


expect("the same day", sample("2026-11-24") == sample("2026-11-24"))
expect("another day", sample("2026-11-24") != sample("2026-11-25"))
expect("all have their turn", set(sum((sample(f"2026-11-{day:02}") for day in range(1, 8)), [])) == set(everything))
expect("no day", "a date such as" in refusal(lambda: sample("today")))
print(f"{failures} failures")
sys.exit(failures > 0)
