#!/usr/bin/env python3
"""ranks_test.py MPIRUN DELCERT-RANKS DELCERT DELCERT-CHECK FOLDER: one triangulation by several processes (docs/ranks.md).

1, 2, 3 and 4 ranks write what `delcert certify` and `delcert split` write, byte for byte, and the checker verifies it. A rank
that is killed ends the run, which goes on from what is finished, and ends with the same bytes."""

import os
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

mpirun, ranks_program, delcert, checker, folder = sys.argv[1:6]
shutil.rmtree(folder, ignore_errors=True)
os.makedirs(folder)
os.chdir(folder)
# Containers run as root; and there may be fewer processors than ranks.
environment = os.environ | {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
                            "OMPI_MCA_rmaps_base_oversubscribe": "1", "OMPI_MCA_btl_vader_single_copy_mechanism": "none",
                            "OMPI_MCA_mpi_yield_when_idle": "1",
                            "ASAN_OPTIONS": "detect_leaks=0"}
faults = []


def expect(what, found, expected):
    if found != expected:
        faults.append(f"{what}: found {found!r}, expected {expected!r}")


def expect_that(what, holds):
    if not holds:
        faults.append(what)


def run(*words):
    done = subprocess.run([str(word) for word in words], capture_output=True, text=True, check=False, env=environment)
    return done.returncode, done.stdout, done.stderr


def command(count, name, manifold, radius, chunks, seed=1):
    return [mpirun, "-n", str(count), ranks_program, "certify", "--manifold", manifold, "--radius", radius,
            "--seed", str(seed), "--chunks", str(chunks), "--output", name]


def files_of(name):
    return {path.name: path.read_bytes() for path in Path(name).iterdir()}


def alone(name, manifold, radius, chunks):
    status, _, errors = run(delcert, "certify", "--manifold", manifold, "--radius", radius, "--seed", "1",
                            "--output", name + ".json.zst")
    expect(f"certify {name}: {errors}", status, 0)
    status, output, _ = run(delcert, "split", name + ".json.zst", "--chunks", str(chunks), "--output", name)
    expect(f"split {name}", status, 0)
    return files_of(name), next(line.split()[1] for line in output.splitlines() if line.startswith("root"))


def value(output, key):
    return next((line.split(None, 1)[1] for line in output.splitlines() if line.startswith(key)), "")


files, root = alone("sphere", "sphere-2", "1/20", 5)
for count in (1, 2, 3, 4):
    name = f"sphere-{count}"
    status, output, errors = run(*command(count, name, "sphere-2", "1/20", 5))
    expect(f"{count} ranks: {errors}", status, 0)
    expect(f"the root of {count} ranks", value(output, "root"), root)
    expect(f"the names of the files of {count} ranks", sorted(files_of(name)), sorted(files))
    expect_that(f"the files of {count} ranks are not those of one process", files_of(name) == files)
    expect_that(f"{name}.progress is left", not Path(name + ".progress").exists())
for chunk in range(1, 6):
    status, _, errors = run(checker, "--chunk", chunk, "--receipt", f"{chunk}.receipt", "sphere-4", "--quiet")
    expect(f"chunk {chunk}: {errors}", status, 0)
status, output, _ = run(checker, "--merge", *[f"{chunk}.receipt" for chunk in range(1, 6)], "sphere-4/header.json.zst")
expect("merged receipts", (status, "verified" in output), (0, True))

# Its twin: of another seed, the same comparison finds other bytes.
status, _, errors = run(*command(2, "other-seed", "sphere-2", "1/20", 5, seed=2))
expect(f"another seed: {errors}", status, 0)
expect_that("another seed gives the same files", files_of("other-seed") != files)

# What is refused ends all ranks, with the status of its kind and the rank.
for words, expected, text in ((command(2, "refused", "torus-2", "1/20", 5), 3, "only spheres"),
                              (command(2, "sphere-2", "sphere-2", "1/20", 5), 3, "has a certificate already"),
                              (command(2, "refused", "sphere-2", "1/20", 1), 64, "--chunks")):
    status, _, errors = run(*words)
    expect(f"status of {words[-6:]}", status, expected)
    expect_that(f"{words[-6:]} says nothing of {text}: {errors}", text in errors)

# A rank is killed while points are placed: when its log has some colours.
shutil.rmtree("killed", ignore_errors=True)
files, root = alone("larger", "sphere-2", "1/40", 4)
process = subprocess.Popen(command(3, "killed", "sphere-2", "1/40", 4), stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                           text=True, env=environment)


def rank_process(rank):
    """The process of this rank, counted from 0, of the run above."""
    for entry in Path("/proc").iterdir():
        if not entry.name.isdigit():
            continue
        try:
            variables = (entry / "environ").read_bytes().split(b"\0")
            words = (entry / "cmdline").read_bytes().split(b"\0")
        except OSError:
            continue
        if f"OMPI_COMM_WORLD_RANK={rank}".encode() in variables and words[0] == ranks_program.encode() \
                and b"killed" in words and os.readlink(entry / "cwd") == os.getcwd():
            return int(entry.name)
    return None


log = Path("killed.progress/placed-1")
victim = None
while process.poll() is None:
    victim = victim or rank_process(1)
    if victim and log.exists() and log.stat().st_size > 20000:
        os.kill(victim, signal.SIGKILL)
        break
    time.sleep(0.0005)
_, errors = process.communicate()
expect_that("the rank could not be killed in time", victim is not None and process.returncode != 0)
expect_that(f"the message does not name the rank that was killed: {errors}", "rank 1" in errors and "signal 9" in errors)
expect_that("a run that was killed has written a header", not Path("killed/header.json.zst").exists())
expect_that("what was finished is not kept", log.exists() and Path("killed.progress/net").exists())
status, _, errors = run(*command(2, "killed", "sphere-2", "1/40", 4))
expect("the status of a run that goes on with another number of ranks", status, 3)
expect_that(f"it does not say why: {errors}", "is of another run" in errors)
status, output, errors = run(*command(3, "killed", "sphere-2", "1/40", 4))
expect(f"the run that goes on: {errors}", status, 0)
colours = value(output, "perturbed").split()
found = int(colours[colours.index("found") - 1]) if "found" in colours else -1
expect_that(f"the run does not go on from finished colours: {colours}", 0 < found < int(colours[1] if colours else 0))
expect("its root", value(output, "root"), root)
expect_that("its files are not those of one process", files_of("killed") == files)

if faults:
    sys.exit("\n".join(faults))
