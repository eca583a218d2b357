"""Certificates are checked by a program that shares no code with what made them: delcert-check."""

import datetime
import json
import os
import shutil
import subprocess
from pathlib import Path

import _delcert

from .errors import Error
from .html import table


def checker():
    """Where the program is: as DELCERT_CHECK says, else in the build folder or installation of this module, else in PATH."""
    if "DELCERT_CHECK" in os.environ:
        return Path(os.environ["DELCERT_CHECK"])
    module = Path(_delcert.__file__).resolve()
    places = [module.parents[1] / "proofs" / "checker" / "delcert-check"]
    places += [folder / "bin" / "delcert-check" for folder in module.parents]
    for place in places:
        if os.access(place, os.X_OK):
            return place
    found = shutil.which("delcert-check")
    if found:
        return Path(found)
    raise Error(f"delcert-check is not installed; looked for {places[0]}, {places[1]} and in PATH")


class CheckReport:
    """What delcert-check says of a certificate. It is true in a condition if all is verified."""

    def __init__(self, checker, status, result):
        self.checker = checker  # "delcert-check 0.2.0"
        self.status = status  # 0 verified, 1 rejected, 2 undecided, 3 malformed
        self.result = result  # the object that it printed
        self.date = datetime.datetime.now(datetime.timezone.utc).date().isoformat()

    @property
    def verified(self):
        return self.status == 0

    @property
    def verdict(self):
        return {0: "verified", 1: "rejected", 2: "undecided"}.get(self.status, "malformed")

    @property
    def levels(self):
        """The levels that are verified, by their names; none where anything is wrong."""
        verified = [one["level"] for one in self.result["levels"] if one["state"] == "verified"]
        # What levels rest on, the group of a space form for one, is listed with them.
        return tuple(name for name in verified if name[0].isdigit()) if self.verified else ()

    def __bool__(self):
        return self.verified

    def __repr__(self):
        if self.verified:
            return f"<{self.checker}: verified, levels {' '.join(self.levels)}>"
        return f"<{self.checker}: {self.verdict}: {self.message}>"

    @property
    def message(self):
        """What is wrong; empty where all is verified."""
        wrong = [self.result["malformed"]] if self.result.get("malformed") else []
        wrong += [finding for level in self.result.get("levels", ()) for finding in level["findings"]]
        return "; ".join(" ".join(str(part) for part in one.values()) for one in wrong)

    def _repr_html_(self):
        colour = {"verified": "#dff0d8", "undecided": "#fcf8e3"}.get(self.verdict, "#f2dede")
        rows = [("verdict", self.verdict), ("levels", " ".join(self.levels)), ("checked by", self.checker)]
        if not self.verified:
            rows.append(("why", self.message))
        return f'<div style="background: {colour}; color: black; padding: 4px">{table(rows)}</div>'


def check_file(path):
    program = checker()
    version = subprocess.run([program, "--version"], capture_output=True, text=True, check=True).stdout.strip()
    run = subprocess.run([program, "--json", "--", os.fspath(path)], capture_output=True, text=True)
    if not 0 <= run.returncode <= 3:
        raise Error(f"delcert-check ended with status {run.returncode}: {run.stderr.strip()}")
    return CheckReport(f"delcert-check {version}", run.returncode, json.loads(run.stdout))
