#!/usr/bin/env python3
"""Every pattern of bench/families.py names a file, and one that names none is noticed."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "bench"))
import families

unused = families.measured()[1]
assert not unused, f"bench/families.py: patterns that name no file: {unused}"
families.FAMILIES["meshes"].append("a_file_that_nobody_wrote")
assert families.measured()[1] == ["meshes: a_file_that_nobody_wrote"]
