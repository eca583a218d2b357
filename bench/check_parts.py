#!/usr/bin/env python3
"""What the parts of a check cost: check_parts.py CHECKER CERTIFICATE [PARTS...]

For each number of parts a line of a table: user seconds and memory of the costliest part, user seconds of all parts
together, and of `--merge`. The first line, one part, is a check of the whole. Lines for docs/decisions/
certificates-across-machines.md are made by this program.
"""

import os
import subprocess
import sys
import tempfile


def measured(command):
    """User seconds and peak memory in MiB of a command that has to succeed."""
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL)
    _, status, usage = os.wait4(process.pid, 0)
    if status != 0:
        sys.exit(f"{' '.join(command)}: status {os.waitstatus_to_exitcode(status)}")
    return usage.ru_utime, usage.ru_maxrss / 1024


def main():
    checker, certificate = sys.argv[1:3]
    numbers = [int(number) for number in sys.argv[3:]] or [1, 2, 4, 8, 16]
    print("| parts | costliest part, s | MiB | all parts, s | merge, s |")
    print("|--:|--:|--:|--:|--:|")
    for number in numbers:
        with tempfile.TemporaryDirectory() as folder:
            receipts = [os.path.join(folder, str(k)) for k in range(1, number + 1)]
            costs = [
                measured([checker, certificate, "--part", f"{k}/{number}", "--receipt", receipt])
                for k, receipt in enumerate(receipts, 1)
            ]
            merge, _ = measured([checker, "--merge", *receipts])
        seconds = [cost[0] for cost in costs]
        memory = max(cost[1] for cost in costs)
        print(f"| {number} | {max(seconds):.2f} | {memory:.0f} | {sum(seconds):.2f} | {merge:.2f} |", flush=True)


if __name__ == "__main__":
    main()
