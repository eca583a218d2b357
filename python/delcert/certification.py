"""Certifying, in this process."""

import json
import os
import shlex
import shutil
import tempfile
from pathlib import Path

import _delcert

from .certificate import Certificate
from .errors import Usage
from .exact import exact_text, whole
from .manifold import Manifold
from .progress import progress_of


def _text(value, name):
    if not isinstance(value, (str, os.PathLike)):
        raise Usage(f"{name}: a text was expected, not {type(value).__name__}")
    return os.fspath(value)


def _whole(least, most):
    return lambda value, name: whole(value, name, least, most)


def _choice(*allowed):
    def read(value, name):
        if value not in allowed:
            raise Usage(f"{name} = {value!r} is not one of {', '.join(allowed)}")
        return value

    return read


def _flag(value, name):
    if not isinstance(value, bool):
        raise Usage(f"{name} = {value!r} is neither True nor False")
    return value


def _levels(value, name):
    known = _delcert.all_levels()
    chosen = value.split(",") if isinstance(value, str) else [str(level) for level in value]
    for level in chosen:
        if level not in known:
            raise Usage(f"{name}: {level!r} is not one of {','.join(known)}")
    return chosen


# The options of `delcert certify`, in the order of its manual, which is that of the command in the certificate.
_options = {
    "manifold": _text,
    "radius": exact_text,
    "lattice": _whole(0, 2**32 - 1),
    "centred": _flag,
    "displace": _whole(0, 2**32 - 1),
    "points": _text,
    "icosphere": _whole(0, 2**32 - 1),
    "relax": _whole(0, 2**32 - 1),
    "sizing": _text,
    "seed": _whole(0, 2**64 - 1),
    "complex": _text,
    "mode": _choice("theory", "measured"),
    "candidates": _choice("pruned", "whole", "printed"),
    "perturbation": exact_text,
    "tolerance": exact_text,
    "clearance": exact_text,
    "choices": _whole(1, 1000000),
    "required_protection": exact_text,
    "repair_rounds": _whole(0, 1000000),
    "refine": _whole(0, 100),
    "no_perturbation": _flag,
    "levels": _levels,
    "threads": _whole(1, 1024),
}


def _command(options):
    """The command of a shell that writes the same certificate."""
    words = ["delcert", "certify"]
    for name in _options:
        value = options.get(name)
        if value is None or value is False or name == "threads":
            continue
        words.append("--" + name.replace("_", "-"))
        if value is not True:
            words.append(shlex.quote(",".join(value) if isinstance(value, list) else str(value)))
    return " ".join(words)


def certify(manifold, *, output=None, progress=None, **options):
    """Perturbs a net of a manifold, computes its Delaunay complex, and certifies it: `delcert certify`, in this process.

    `manifold`: the name of a built-in one, a `delcert.Manifold`, or a file. Keyword arguments are the options of
    `delcert certify` (docs/cli.md), with `_` for `-`; numbers are exact. `output`: the file of the certificate; a
    temporary one, which lives as long as what is returned, if there is none. `progress`: True, or a function of (stage,
    done, total), in which an exception ends the run. Ctrl-C ends it, too, and leaves nothing behind.

    Raises Refuted where a certificate is not reached, Undecided, MalformedInput, Usage.
    """
    name = manifold.name if isinstance(manifold, Manifold) else _text(manifold, "manifold")
    read = {"manifold": name}
    for option, value in options.items():
        if option not in _options:
            raise Usage(f"certify has no option {option}; it has {', '.join(_options)}, output, progress")
        if value is not None:
            read[option] = _options[option](value, option)
    for option, other in [("points", "lattice"), ("icosphere", "lattice")]:
        if option in read and other in read:
            raise Usage(f"{option} and {other} exclude each other")
    for option in ("centred", "displace"):
        if read.get(option) and "lattice" not in read:
            raise Usage(f"{option} asks for lattice")
    folder = None
    if output is None:
        folder = tempfile.mkdtemp(prefix="delcert-")
        output = Path(folder) / f"{Path(name).stem}.delcert.json.zst"
    try:
        with progress_of(progress) as told:
            report = json.loads(_delcert.certify(read, os.fspath(output), _command(read), told))
        return Certificate(output, report, folder)
    except BaseException:
        if folder is not None:
            shutil.rmtree(folder)
        raise
