#!/usr/bin/env python3
"""What includes.py lets pass and what it must not, on small trees."""

import sys
import tempfile
from pathlib import Path

import includes

PAGE = """# Page

| folder | target; what it holds | may use |
|---|---|---|
| `proofs/checker/` | the checker | libraries only: **nothing** else |
| `proofs/replay/` | the replay | libraries only |
| `apps/` | programs | the folders below |
| `properties/fuzz/` | targets | `proofs/checker/`, the folders below |
| `kernel/manifold/` | readers | the folders below |
| `kernel/manifold/gluing/` | charts | the folders below |
| `kernel/topology/` | labels | `kernel/number/` |
| `kernel/simplex/` | simplices | `kernel/number/`, `support/` |
| `kernel/number/` | numbers | `support/` |
| `support/` | errors | libraries only |

| `kernel/other/` | of another table | the folders below |
"""
FILES = {
    "proofs/checker/rule.hpp": "<gmp.h>",
    "proofs/checker/core/page.hpp": '"proofs/checker/rule.hpp"',
    "proofs/replay/log.hpp": "<gmp.h>",
    "apps/main.cpp": '"kernel/manifold/file.hpp"',
    "properties/fuzz/target.cpp": '"proofs/checker/rule.hpp"',
    "kernel/manifold/file.hpp": '"kernel/manifold/gluing/chart.hpp"',
    "kernel/manifold/gluing/chart.hpp": '"kernel/simplex/edge.hpp"',
    "kernel/topology/complex.hpp": '"kernel/number/interval.hpp"',
    "kernel/simplex/edge.hpp": '"support/error.hpp"',
    "kernel/number/interval.hpp": '"delcert_version.hpp"',
    "support/error.hpp": "<string>",
}


def found(changes):
    with tempfile.TemporaryDirectory() as folder:
        root = Path(folder)
        (root / "HACKING.md").write_text(PAGE)
        for name, include in {**FILES, **changes}.items():
            (root / name).parent.mkdir(parents=True, exist_ok=True)
            (root / name).write_text(f"#pragma once\n#include {include}\n")
        return includes.complaints(root)[1]


def expect(what, changes, complaint):
    complaints = found(changes)
    expected = [complaint] if complaint else []
    if complaints != expected:
        sys.exit(f"{what}: {complaints} instead of {expected}")


expect("in order", {}, None)
expect("upwards", {"kernel/simplex/edge.hpp": '"kernel/manifold/file.hpp"'},
       'kernel/simplex/edge.hpp:2: "kernel/manifold/file.hpp": kernel/simplex/ may not use kernel/manifold/')
expect("upwards from a folder within", {"kernel/manifold/gluing/chart.hpp": '"kernel/manifold/file.hpp"'},
       'kernel/manifold/gluing/chart.hpp:2: "kernel/manifold/file.hpp": '
       "kernel/manifold/gluing/ may not use kernel/manifold/")
expect("below, but not named", {"kernel/topology/complex.hpp": '"kernel/simplex/edge.hpp"'},
       'kernel/topology/complex.hpp:2: "kernel/simplex/edge.hpp": kernel/topology/ may not use kernel/simplex/')
expect("the kernel in the checker", {"proofs/checker/rule.hpp": '"kernel/number/interval.hpp"'},
       'proofs/checker/rule.hpp:2: "kernel/number/interval.hpp": proofs/checker/ may not use kernel/number/')
expect("the same, further in", {"proofs/checker/core/page.hpp": '"support/error.hpp"'},
       'proofs/checker/core/page.hpp:2: "support/error.hpp": proofs/checker/ may not use support/')
expect("the checker in the replay", {"proofs/replay/log.hpp": '"proofs/checker/rule.hpp"'},
       'proofs/replay/log.hpp:2: "proofs/checker/rule.hpp": proofs/replay/ may not use proofs/checker/')
expect("the checker in a program", {"apps/main.cpp": '"proofs/checker/rule.hpp"'},
       'apps/main.cpp:2: "proofs/checker/rule.hpp": apps/ may not use proofs/checker/')
expect("a folder of no table", {"kernel/other/new.hpp": "<string>"},
       "kernel/other/new.hpp: its folder is not in the table of HACKING.md")
expect("a relative path", {"kernel/manifold/file.hpp": '"gluing/chart.hpp"'},
       'kernel/manifold/file.hpp:2: "gluing/chart.hpp" is no path from the root')
