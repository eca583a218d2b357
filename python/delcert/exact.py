"""Exact numbers: integers, fractions, and texts of either; never a float."""

import math
import numbers
from fractions import Fraction

import _delcert

from .errors import Usage


def exact_text(value, name):
    """The text of an exact number as the programs read it. Refuses a float, whose value is hardly ever what was meant,
    with the fraction to write instead."""
    if isinstance(value, bool):
        raise Usage(f"{name} = {value} is no number")
    if isinstance(value, numbers.Rational):
        value = Fraction(value)
        return str(value)
    if isinstance(value, numbers.Real):
        raise Usage(refusal(float(value), name))
    if not isinstance(value, str):
        raise Usage(f"{name}: an int, a fractions.Fraction or a text such as '1/4' was expected, not {type(value).__name__}")
    try:
        _delcert.exact(value)
    except Usage as error:
        raise Usage(f"{name}: {error}") from None
    return value


def refusal(value, name):
    if not math.isfinite(value):
        return f"{name} = {value} is no exact number"
    meant, is_ = Fraction(repr(value)), Fraction(value)
    if meant == is_:
        return f"{name} = {value!r} is a float; numbers are exact here: write Fraction({written(meant)}) or '{meant}'"
    return f"{name} = {value!r} is a float, and not {meant} but {is_}: write Fraction({written(meant)}) or '{meant}'"


def written(fraction):
    return f"{fraction.numerator}, {fraction.denominator}"


def whole(value, name, least, most):
    """An integer from a range."""
    if isinstance(value, bool) or not isinstance(value, numbers.Integral):
        raise Usage(f"{name} = {value!r} is no int")
    if not least <= value <= most:
        raise Usage(f"{name} = {value} is not from {least} to {most}")
    return int(value)
