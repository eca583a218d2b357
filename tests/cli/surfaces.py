#!/usr/bin/env python3
"""surfaces.py DELCERT DELCERT_CHECK [--all]: surfaces that the examples do not have, with a first guess of --radius. It is refused, and the
message ends with options that should do. They do: the surface is certified, about as many points are needed as the message says, and delcert-check
verifies the certificate. What is advised is run with --all only: docs/bring-your-own-manifold.md has it for the first of them."""

import re
import subprocess
import sys
import tempfile
from pathlib import Path

FOLDER = Path(__file__).resolve().parent / "surfaces"
ADVICE = re.compile(r"; for the whole manifold (--radius [0-9/]+(?: --sizing curvature:[0-9/,]+)? --refine [0-9]+) should do, with some ([0-9]+) points$")
# Name, first guess, homology, and whether radii should vary.
SURFACES = [
    ("cassini", "1/10", "Z, 0, Z", False),
    ("chmutov", "1/10", "Z, Z^10, Z", True),
    ("bretzel", "1/8", "Z, Z^4, Z", True),
]


def main():
    delcert, checker = sys.argv[1:3]
    is_all = "--all" in sys.argv
    with tempfile.TemporaryDirectory() as folder:
        certificate = Path(folder) / "surface.json.zst"

        def certify(name, options):
            command = [delcert, "certify", "--manifold", FOLDER / f"{name}.toml", *options, "--output", certificate]
            return subprocess.run(command, capture_output=True, text=True)

        for name, guess, homology, varies in SURFACES:
            refused = certify(name, ["--radius", guess])
            assert refused.returncode == 1 and not certificate.exists(), (name, refused)
            said = ADVICE.search(refused.stderr.strip())
            assert said, (name, refused.stderr)
            options, about = said[1], int(said[2])
            print(f"{name}: {options}, some {about} points", flush=True)
            assert ("--sizing" in options) == varies, (name, options)
            if not is_all:
                continue
            done = certify(name, options.split())
            assert done.returncode == 0, (name, done.stderr)
            assert "  5   triangulation: " in done.stdout and f"homology {homology}; closed" in done.stdout, (name, done.stdout)
            points = int(re.search(r"^net +([0-9]+) points", done.stdout, re.M)[1])
            assert points / 3 < about < points * 3, (name, about, points)
            checked = subprocess.run([checker, certificate], capture_output=True, text=True)
            assert checked.returncode == 0 and "verified: levels charts " in checked.stdout, (name, checked.stdout + checked.stderr)
            certificate.unlink()


main()
