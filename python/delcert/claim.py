"""Claims about instances: attacked, and searched for what comes nearest to refuting them."""

import json
import os
from fractions import Fraction

import _delcert

from .errors import MalformedInput, Usage
from .exact import whole
from .html import Rows, table
from .progress import progress_of


def _listed(value):
    return [value] if isinstance(value, (str, dict)) else list(value)


def _toml(value):
    """TOML's basic strings are JSON's."""
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{_toml(key)} = {_toml(one)}" for key, one in value.items()) + " }"
    if not isinstance(value, str):
        raise Usage(f"a formula was expected, not {value!r}")
    return json.dumps(value, ensure_ascii=False)


def _text_of(name, instance, given, show, forall, title):
    lines = [f"name = {_toml(name)}", f"instance = {_toml(instance)}"]
    if title:
        lines.append(f"title = {_toml(title)}")
    if forall:
        lines.append(f"forall = {_toml(forall)}")
    for key, formulas in (("given", given), ("show", show)):
        tables = [one if isinstance(one, dict) else {"claim": one} for one in _listed(formulas)]
        lines.append(f"{key} = [{', '.join(_toml(one) for one in tables)}]")
    return "\n".join(lines) + "\n"


class Claim:
    """Whenever the hypotheses `given` hold for an instance of a class, so do the conclusions `show`: formulas, or lists of
    them (docs/claim-format.md). `delcert.Claim("altitudes-of-faces")`, without these, is one of the library or of a file."""

    def __init__(self, name=None, *, instance=None, given=(), show=(), forall=None, title=""):
        if instance is None:
            if name is None or given or show or forall:
                raise Usage("a claim has an instance class and something to show, or it is a name of the library or a file")
            self._claim = _delcert.find_claim(os.fspath(name))
        else:
            name = "claim" if name is None else name
            self._claim = _delcert.claim_of_text(_text_of(name, instance, given, show, forall, title), name)
        facts = json.loads(self._claim.summary())
        self.name, self.title, self.source = facts["name"], facts["title"], facts["source"]
        self.status, self.instance, self.steps = facts["status"], facts["instance"], facts["steps"]
        self.given = [one["claim"] for one in facts["given"]]
        self.show = {one["name"]: one["claim"] for one in facts["show"]}

    @property
    def shapes(self):
        """The shapes (k, m) that an attack goes through unless told otherwise: k-simplices in R^m, or k = 0 for classes that
        have only a dimension m."""
        return self._claim.shapes()

    def attack(self, samples=1000, shapes=(), seed=0, threads=0, progress=None):
        """Decides the claim, exactly, on so many random instances of each shape; fewer where one is costly."""
        with progress_of(progress) as told:
            found = self._claim.attack(
                whole(samples, "samples", 1, 10**10),
                [_shape(shape) for shape in shapes],
                whole(seed, "seed", 0, 2**64 - 1),
                whole(threads, "threads", 0, 1024),
                told,
            )
        return Attack(self, json.loads(found))

    def tighten(self, shape, conclusion=None, evaluations=4000, seed=0, threads=0, progress=None):
        """Searches for the instance of a shape that comes nearest to refuting a conclusion, the first unless it is named."""
        names = list(self.show)
        if conclusion is not None and conclusion not in names:
            raise Usage(f"conclusion = {conclusion!r} is not one of {', '.join(names)}")
        at = 0 if conclusion is None else names.index(conclusion)
        with progress_of(progress) as told:
            found = self._claim.tighten(
                at,
                _shape(shape),
                whole(evaluations, "evaluations", 1, 10**12),
                whole(seed, "seed", 0, 2**64 - 1),
                whole(threads, "threads", 0, 1024),
                told,
            )
        return Tightest(self, names[at], json.loads(found)) if found else None

    def latex(self):
        """The claim as a paragraph for a paper (amsmath)."""
        return self._claim.latex()

    def verdict_on(self, witness):
        """"refuted", "proved" or "undecided": what the claim says of the instance of a witness, decided anew."""
        return self._claim.verdict_on(witness.text)

    def __repr__(self):
        lines = [f"{self.name}" + (f": {self.title}" if self.title else "")]
        lines += [f"  about: {self.instance}"] if self.instance else []
        lines += [f"  given {one}" for one in self.given] + [f"  show {one}" for one in self.show.values()]
        return "\n".join(lines)

    def _repr_html_(self):
        rows = [("given", one) for one in self.given] + [("show", one) for one in self.show.values()]
        return table(rows, title=f"{self.name} ({self.instance})")


def _shape(shape):
    if isinstance(shape, int) and not isinstance(shape, bool):
        return (0, whole(shape, "shape", 0, 16))
    try:
        k, m = shape
    except (TypeError, ValueError):
        raise Usage(f"shape = {shape!r} is neither (k, m) nor m") from None
    return (whole(k, "shape", 0, 16), whole(m, "shape", 0, 16))


def claims(word=""):
    """The claims of the library in whose name, title, source or class the word is; all without one."""
    rows = [one for one in json.loads(_delcert.claims()) if word in "\n".join((one["name"], one["title"], one["source"], one["instance"]))]
    if not rows:
        raise MalformedInput(f"no claim speaks of {word!r}")
    return Rows(rows, ("name", "title", "source", "status", "instance"))


class Attack:
    """What came of an attack."""

    def __init__(self, claim, found):
        self.claim = claim
        self.table = Rows(_rows(found), ("conclusion", "k", "m", "samples", "met", "verdict"), claim.name)
        self.totals = found["totals"]
        self.witnesses = [Witness(one["witness"], claim) for one in found["refutations"]]

    @property
    def refuted(self):
        return bool(self.witnesses)

    def __repr__(self):
        return repr(self.table) + "".join(f"\n{one!r}" for one in self.witnesses)

    def _repr_html_(self):
        return self.table._repr_html_() + "".join(one._repr_html_() for one in self.witnesses)


def _rows(found):
    for target in found["targets"]:
        tally = target["tally"]
        met = tally["samples"] - tally["not_drawn"] - tally["hypotheses_not_met"] - tally["hypotheses_undecided"]
        for one in tally["conclusions"]:
            row = {"conclusion": one["name"], "k": target["k"], "m": target["m"], "samples": tally["samples"], "met": met}
            row.update({key: one[key] for key in ("held", "violated", "undecided", "verdict")})
            lower, upper = one.get("worst", (None, None))
            row["worst_lower"] = None if lower is None else float.fromhex(lower)
            row["worst_upper"] = None if upper is None else float.fromhex(upper)
            yield row


class Tightest:
    """The instance with the greatest ratio that a search found: of the smaller side to the larger one as the conclusion
    has them, certified to be from `lower` to `upper`. Above 1 the conclusion is refuted."""

    def __init__(self, claim, conclusion, found):
        self.claim, self.conclusion = claim, conclusion
        self.lower, self.upper = found["lower"], found["upper"]
        self.is_equality, self.verdict, self.evaluations = found["is_equality"], found["verdict"], found["evaluations"]
        self.witness = Witness(found["witness"], claim)

    def __repr__(self):
        note = ", equality" if self.is_equality else ""
        return f"<{self.conclusion}: ratio from {self.lower} to {self.upper}, {self.verdict}{note}>"


class Witness:
    """An instance, exactly, with the conclusion that it refutes or comes near to refuting."""

    def __init__(self, text, claim=None):
        self.text = text  # of a witness file
        self.claim = claim
        content = json.loads(text)
        self.claim_name, self.conclusion, self.instance = content["claim"], content["conclusion"], content["instance"]
        self.bindings = {name: _exactly(next(iter(one.values()))) for name, one in content["bindings"].items()}

    @property
    def vertices(self):
        """The vertices of a simplex: tuples of Fractions. None where the instance is no simplex, or one of which only edges
        are known."""
        simplex = self.bindings.get("s")
        return simplex.get("points") if self.instance == "simplex" and isinstance(simplex, dict) else None

    def save(self, path):
        """As a witness file, for `delcert attack --replay` and `delcert report`."""
        with open(path, "w", encoding="utf-8") as file:
            file.write(self.text)

    def latex(self):
        """Its vertices, or its numbers, for a paper (amsmath)."""
        lines = [f"p_{{{at}}} &= {_latex(vertex)}" for at, vertex in enumerate(self.vertices or ())]
        if self.vertices is None:
            lines = [f"\\mathrm{{{name}}} &= {_latex(value)}" for name, value in self.bindings.items()]
        return "\\begin{align*}\n" + " \\\\\n".join(lines) + "\n\\end{align*}\n"

    def __repr__(self):
        said = f"of {self.claim_name} / {self.conclusion}"
        return f"<witness {said}: " + ", ".join(f"{name} = {_plain(one)}" for name, one in self.bindings.items()) + ">"

    def _repr_svg_(self):
        return _delcert.witness_svg(self.text) or None

    def _repr_html_(self):
        rows = [(name, _plain(one)) for name, one in self.bindings.items()]
        if self.vertices is not None:
            rows = [(f"p{at}", _plain(vertex)) for at, vertex in enumerate(self.vertices)]
        return table(rows, title=f"{self.claim_name} / {self.conclusion}")


def _exactly(value):
    if isinstance(value, str):
        try:
            return _delcert.exact(value)
        except Usage:
            return value
    if isinstance(value, list):
        return tuple(_exactly(one) for one in value)
    if isinstance(value, dict):
        return {key: _exactly(one) for key, one in value.items()}
    return value


def _plain(value):
    if isinstance(value, dict):
        return "; ".join(f"{key} {_plain(one)}" for key, one in value.items())
    if isinstance(value, tuple):
        return "(" + ", ".join(_plain(one) for one in value) + ")"
    return str(value)


def _latex(value):
    if isinstance(value, tuple):
        return "\\left(" + ", ".join(_latex(one) for one in value) + "\\right)"
    if isinstance(value, (int, Fraction)):
        return _delcert.exact_latex(str(value))
    return _plain(value)
