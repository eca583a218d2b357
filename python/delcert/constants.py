"""The paper's constants."""

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import Optional, Tuple

import _delcert

from .errors import MalformedInput
from .exact import exact_text, whole
from .html import table


@dataclass(frozen=True)
class Constant:
    """A constant: its value lies from `lower` to `upper`, which are equal where it is rational and not too long."""

    name: str
    symbol: str
    latex_symbol: str
    exact: str  # the formula; empty where there is only an enclosure
    exact_latex: str
    lower: Fraction
    upper: Fraction
    log2: Optional[Tuple[Fraction, Fraction]]  # where its binary logarithm lies
    source: str  # the label in the paper
    is_estimate: bool  # nothing is proved about it; the bounds are of the arithmetic alone

    def __repr__(self):
        return f"<{self.name}, {self.symbol} = {self.exact or near(self)} ({self.source})>"

    def _repr_latex_(self):
        return f"${self.latex_symbol} = {self.exact_latex}$" if self.exact_latex else None


def near(constant):
    """About how large it is: a power of 2 where a float cannot hold it."""
    if constant.lower == 0:
        return "0"
    exponent = abs(constant.lower.numerator).bit_length() - constant.lower.denominator.bit_length()
    if not -1000 < exponent < 1000:
        return f"about 2^{exponent if constant.log2 is None else float(constant.log2[0]):.6g}"
    return f"about {float(constant.lower):.6g}"


class Constants(Mapping):
    """All constants for some parameters, by their names, in the order of the paper's argument."""

    def __init__(self, rows, title):
        self.title = title
        self._by_name = {}
        for row in rows:
            lower, upper = row.pop("value")
            self._by_name[row["name"]] = Constant(lower=lower, upper=upper, **row)

    def __getitem__(self, name):
        """By a name with blanks or underscores between its words."""
        try:
            return self._by_name[name.replace(" ", "_")]
        except KeyError:
            raise KeyError(f"no constant is called {name}; there are {', '.join(self._by_name)}") from None

    def __iter__(self):
        return iter(self._by_name)

    def __len__(self):
        return len(self._by_name)

    def __repr__(self):
        return self.title + "\n" + "\n".join(f"  {one.name} = {one.exact or near(one)}" for one in self.values())

    def _repr_html_(self):
        rows = [(one.name, one.symbol, one.exact, near(one), one.source) for one in self.values()]
        return table(rows, ("name", "", "exactly", "nearly", "source"), self.title)

    def _ipython_key_completions_(self):
        return list(self)


def constants(dim, separation, perturbation=None, radius_variation=0, distortion=0):
    """The paper's constants in dimension `dim`, exactly. `perturbation`: the largest unless it is given."""
    if not isinstance(dim, int):
        raise MalformedInput(f"dim = {dim!r} is no int")
    given = dict(separation=separation, radius_variation=radius_variation, distortion=distortion)
    texts = {name: exact_text(value, name) for name, value in given.items()}
    rho = None if perturbation is None else exact_text(perturbation, "perturbation")
    rows = _delcert.constants(
        whole(dim, "dim", -(2**31), 2**31 - 1), texts["separation"], rho, texts["radius_variation"], texts["distortion"]
    )
    return Constants(rows, f"dimension {dim}, separation {separation}")
