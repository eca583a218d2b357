#!/usr/bin/env python3
"""Certificates of all families, compared with digests that are kept.

  golden.py check NAME --delcert PROGRAM       fails unless the certificate is, section by section, the one of digests.tsv
  golden.py freeze --delcert PROGRAM           writes digests.tsv anew; refuses if the geometry of one has changed
  golden.py freeze --geometry --delcert PROGRAM      the same, whatever has changed

certificates.tsv has a name and the options of `delcert certify` on every line, files from the root of the project on. The digests are SHA-256:

  document    the bytes of the certificate without `software` (the versions of libraries) and without its seal
  manifold, parameters, levels      the text of that section
  net, points                       the exact numbers, whatever their spelling
  simplices                         the set of the labels of the simplices

The last three are the geometry: no change of the format, of reports or of the order of work may change them."""

import argparse
import hashlib
import json
import re
import subprocess
import sys
import tempfile
from fractions import Fraction
from pathlib import Path

FOLDER = Path(__file__).parent
GEOMETRY = ("net", "points", "simplices")
SECTIONS = ("document", "manifold", "parameters", "levels") + GEOMETRY
HEXADECIMAL = re.compile(r"(-?)0x([0-9a-f]+)(?:\.([0-9a-f]+))?(?:p(-?[0-9]+))?")


def exact(text):
    match = HEXADECIMAL.fullmatch(text)
    if not match:
        return Fraction(text)
    sign, whole, fraction, exponent = match.groups()
    fraction = fraction or ""
    value = Fraction(int(whole + fraction, 16)) * Fraction(2) ** (int(exponent or 0) - 4 * len(fraction))
    return -value if sign else value


def digest(data):
    return hashlib.sha256(data if isinstance(data, bytes) else data.encode()).hexdigest()


def points_text(points):
    return "\n".join(" ".join(str(exact(coordinate)) for coordinate in point) for point in points)


def simplices_text(rows):
    simplices = sorted(tuple(row[: len(row) // 2 + 1]) for row in rows)
    return "\n".join(" ".join(map(str, simplex)) for simplex in simplices)


def without_versions(certificate):
    certificate, software = re.subn(rb'"software":\{[^}]*\},', b"", certificate)
    certificate, seal = re.subn(rb',"sha256":"[0-9a-f]{64}"', b"", certificate)
    if software != 1 or seal != 1:
        raise SystemExit("golden.py: the certificate has no software or no seal, or has them twice")
    return certificate


def sections_of(certificate):
    content = json.loads(certificate)
    result = {"document": digest(without_versions(certificate))}
    for section in ("manifold", "parameters", "levels"):
        result[section] = digest(json.dumps(content[section], separators=(",", ":"), ensure_ascii=False))
    result["net"] = digest(points_text(content["net"]))
    result["points"] = digest(points_text(content["points"]))
    result["simplices"] = digest(simplices_text(content["simplices"]))
    return result


def differences(found, kept):
    return [section for section in SECTIONS if found[section] != kept.get(section)]


def table(name):
    lines = (FOLDER / name).read_text().splitlines()
    return [line.split("\t") for line in lines if line]


def certify(delcert, options):
    with tempfile.TemporaryDirectory() as folder:
        output = Path(folder) / "certificate.json"
        command = [str(Path(delcert).resolve()), "certify", *options.split(), "--output", str(output)]
        run = subprocess.run(
            command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, check=False, cwd=FOLDER.parent.parent
        )
        if run.returncode != 0:
            raise SystemExit(f"golden.py: {' '.join(command)} ends with status {run.returncode}: {run.stderr}")
        return output.read_bytes()


def kept_digests():
    kept = {}
    for name, section, value in table("digests.tsv"):
        kept.setdefault(name, {})[section] = value
    return kept


def check(delcert, name):
    options = dict(table("certificates.tsv"))
    if name not in options or name not in kept_digests():
        raise SystemExit(f"golden.py: {name} is not in both tables")
    changed = differences(sections_of(certify(delcert, options[name])), kept_digests()[name])
    if changed:
        raise SystemExit(f"golden.py: {name}: other than kept: {', '.join(changed)}")


def freeze(delcert, geometry_may_change):
    kept = kept_digests() if (FOLDER / "digests.tsv").exists() else {}
    lines = []
    for name, options in table("certificates.tsv"):
        found = sections_of(certify(delcert, options))
        changed = differences(found, kept.get(name, found))
        if set(changed) & set(GEOMETRY) and not geometry_may_change:
            raise SystemExit(f"golden.py: {name}: {', '.join(changed)} would change; --geometry if that is meant")
        lines += [f"{name}\t{section}\t{found[section]}\n" for section in SECTIONS]
        print(f"{name}: {', '.join(changed) if changed else 'new' if name not in kept else 'as before'}")
    (FOLDER / "digests.tsv").write_text("".join(lines))


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("action", choices=("check", "freeze"))
    parser.add_argument("name", nargs="?")
    parser.add_argument("--delcert", required=True)
    parser.add_argument("--geometry", action="store_true")
    arguments = parser.parse_args()
    if arguments.action == "check":
        check(arguments.delcert, arguments.name)
    else:
        freeze(arguments.delcert, arguments.geometry)


if __name__ == "__main__":
    sys.exit(main())
