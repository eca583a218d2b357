"""Certified Delaunay triangulations of manifolds, and attacks on claims about them: docs/python.md is the guide."""

import _delcert

from .certificate import Certificate, load
from .certification import certify
from .checking import CheckReport
from .claim import Claim, Witness, claims
from .constants import Constant, Constants, constants
from .errors import Error, MalformedInput, Refuted, Undecided, Usage
from .manifold import Manifold, manifold, manifolds

__version__ = _delcert.version


def cite(style="bibtex"):
    """References to the paper and to delcert. `style`: "bibtex" or "text"."""
    if style not in ("bibtex", "text"):
        raise Usage(f"style = {style!r} is neither bibtex nor text")
    return _delcert.references(style == "text")


__all__ = [
    "Certificate",
    "CheckReport",
    "Claim",
    "Constant",
    "Constants",
    "Error",
    "Manifold",
    "MalformedInput",
    "Refuted",
    "Undecided",
    "Usage",
    "Witness",
    "certify",
    "cite",
    "claims",
    "constants",
    "load",
    "manifold",
    "manifolds",
]
