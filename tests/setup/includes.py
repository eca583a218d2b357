#!/usr/bin/env python3
"""includes.py [ROOT]: fails, naming file and line, unless every #include "…" of the sources keeps to the table of folders
in HACKING.md: a folder uses what stands below it, or the folders that its last column names, or libraries only. So the
checker and the replay share nothing with what they check, and no layer rests on one above it."""

import re
import sys
from pathlib import Path

ROW = re.compile(r"\| ((?:`[a-z_/]+/`(?:, )?)+) \|.*\| ([^|]*) \|")
INCLUDE = re.compile(r'\s*#\s*include\s*"([^"]*)"')
TOP = ("apps", "kernel", "proofs", "properties", "python", "support")
GENERATED = ("delcert_version.hpp",)


def folders_in(cell):
    return re.findall(r"`([a-z_/]+)/`", cell)


def layers(page):
    """Folder -> the folders that it may use, from the first table of the page whose first column is `folder`."""
    rows = []
    inside = False
    for line in page.splitlines():
        if line.startswith("| folder |"):
            inside = True
        elif inside and not line.startswith("|"):
            break
        elif inside and not line.startswith("|---"):
            match = ROW.fullmatch(line)
            if not match:
                raise SystemExit(f"HACKING.md: not a row of folders: {line}")
            rows.append((folders_in(match[1]), match[2]))
    if not rows:
        raise SystemExit("HACKING.md has no table of folders")
    result = {}
    for at, (folders, allowed) in enumerate(rows):
        uses = set(folders)
        if not allowed.startswith("libraries only"):
            uses |= set(folders_in(allowed))
            if "the folders below" in allowed:
                uses |= {folder for below, _ in rows[at + 1 :] for folder in below}
        for folder in folders:
            result[folder] = uses
    return result


def layer_of(path, known):
    """The row that a file belongs to: the longest folder of the table that it is in."""
    for folder in path.parents:
        if folder.as_posix() in known:
            return folder.as_posix()
    return None


def complaints(root):
    known = layers((root / "HACKING.md").read_text())
    result = []
    sources = sorted(path for top in TOP for path in (root / top).rglob("*") if path.suffix in (".hpp", ".cpp"))
    for source in sources:
        name = source.relative_to(root)
        layer = layer_of(name, known)
        if layer is None:
            result.append(f"{name}: its folder is not in the table of HACKING.md")
            continue
        for number, line in enumerate(source.read_text().splitlines(), 1):
            match = INCLUDE.match(line)
            if not match or match[1] in GENERATED:
                continue
            used = layer_of(Path(match[1]), known)
            where = f'{name}:{number}: "{match[1]}"'
            if not (root / match[1]).is_file():
                result.append(f"{where} is no path from the root")
            elif used is None:
                result.append(f"{where} is in no folder of the table of HACKING.md")
            elif used not in known[layer]:
                result.append(f"{where}: {layer}/ may not use {used}/")
    return sources, result


def main():
    root = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parents[2]
    sources, found = complaints(root)
    if not sources:
        sys.exit(f"{root}: no sources")
    if found:
        sys.exit("\n".join(found))


if __name__ == "__main__":
    main()
