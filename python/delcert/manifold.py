"""The built-in manifolds."""

import functools
from dataclasses import dataclass

import _delcert

from .errors import MalformedInput
from .html import Rows


@dataclass(frozen=True)
class Manifold:
    """A built-in manifold: for `delcert.certify`."""

    name: str
    kind: str
    dimension: int
    about: str

    def __str__(self):
        return self.name


@functools.cache
def _all():
    return tuple(Manifold(**row) for row in _delcert.manifolds())


def manifolds(word=""):
    """Those in whose name, kind or description the word is; all without one."""
    found = [one for one in _all() if word in f"{one.name}\n{one.kind}\n{one.about}"]
    if not found:
        raise MalformedInput(f"no built-in manifold speaks of {word!r}")
    return Rows(found, ("name", "dimension", "kind", "about"))


class _Names:
    """`delcert.manifold.bolza_surface`, for completion by the tab key; `-` of a name is `_` here."""

    def __dir__(self):
        return [_attribute(one) for one in _all()]

    def __getattr__(self, attribute):
        for one in _all():
            if _attribute(one) == attribute:
                return one
        raise AttributeError(f"no built-in manifold is called {attribute}; delcert.manifolds() lists them")

    def __repr__(self):
        return "delcert.manifold, with " + ", ".join(dir(self))


def _attribute(manifold):
    return manifold.name.replace("-", "_")


manifold = _Names()
