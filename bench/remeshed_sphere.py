#!/usr/bin/env python3
"""remeshed_sphere.py DELCERT DELCERT_CHECK [RADIUS]: a certified sphere is exported as a mesh (of the given radius, 1/50), and this is the manifold of a
second run, at ε = 1/10. Prints what was proved and what it took, as a table of docs/submanifolds.md; seconds are of processors."""

import json
import math
import resource
import subprocess
import sys
import tempfile
from pathlib import Path


def up(x, digits):
    return f"{math.ceil(x * 10**digits) / 10**digits:.{digits}f}"


def seconds_of(command, folder):
    """Standard output, and seconds of processors."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    done = subprocess.run([str(word) for word in command], cwd=folder, capture_output=True, text=True)
    if done.returncode != 0:
        raise SystemExit(f"{' '.join(map(str, command))}: exit status {done.returncode}: {done.stderr}")
    return done.stdout, resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before


def main():
    delcert, checker = (Path(word).resolve() for word in sys.argv[1:3])
    radius = sys.argv[3] if len(sys.argv) > 3 else "1/50"
    with tempfile.TemporaryDirectory() as folder:
        folder = Path(folder)
        seconds_of([delcert, "certify", "--manifold", "sphere-2", "--radius", radius, "--seed", "1", "--output", "sphere.json"], folder)
        seconds_of([delcert, "export", "sphere.json", "--format", "off", "--output", "part.off"], folder)
        (folder / "part.toml").write_text('name = "part"\nfamily = "submanifold"\ndimension = 2\nmesh = "part.off"\n')
        text, certify = seconds_of([delcert, "certify", "--manifold", "part.toml", "--radius", "1/10", "--seed", "1", "--levels", "1,2,4,5",
                                    "--json", "--output", "certificate.json"], folder)
        _, check = seconds_of([checker, "certificate.json"], folder)
        report = json.loads(text)
        lines = (line.split("#")[0].split() for line in (folder / "part.off").read_text().splitlines())
        vertices, facets = next(words for words in lines if len(words) == 3)[:2]  # after OFF
        levels = report["levels"]
        four, five = levels["4"], levels["5"]
        print("| vertices of M | facets of M | ε | triangles | levels | level 4 | density ≤ | displacement ≤ | contraction ≤ | certify, s | check, s |")
        print("|--:|--:|--:|--:|---|---|--:|--:|--:|--:|--:|")
        row = [f"{int(vertices):,}".replace(",", " "), f"{int(facets):,}".replace(",", " "), "1/10",
               f"{report['simplices']:,}".replace(",", " "), " ".join(levels), four["metric"],
               f"{up(four['density']['in_sampling_radii'], 3)} ε", f"{up(five['displacement']['in_sampling_radii'], 3)} ε",
               up(five["contraction"]["value"], 3), f"{certify:.1f}", f"{check:.1f}"]
        print("| " + " | ".join(row) + " |")


if __name__ == "__main__":
    main()
