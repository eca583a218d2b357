#!/usr/bin/env python3
"""report_schema.py DELCERT SCHEMA PAGE: what `delcert certify --json` prints in every family is as docs/report.schema.json
says, and its bounds are on the safe side; reports that are a little wrong are refused; the page describes every key.

The validator knows the keywords that the schema uses, as JSON Schema 2020-12 defines them, and refuses a schema with another one."""

import copy
import json
import re
import subprocess
import sys
import tempfile
from fractions import Fraction
from pathlib import Path

# Options, and a key of `measures` or a level that only this family has.
RUNS = [("--manifold circle --radius 1/30", "levels.0.hypotheses_2"),
        ("--manifold torus-2 --lattice 20 --mode measured", "levels.3.tested"),
        ("--manifold disk --radius 1/12 --seed 1 --levels 0,1,2,4", "input.0.item"),
        ("--manifold sphere-2 --radius 1/8", "measures.stability.transitions"),
        ("--manifold klein-bottle --radius 1/24", "levels.0.density"),
        ("--manifold bolza-surface --radius 1/8 --seed 1", "levels.6.weight"),
        ("--manifold torus-2-hills --radius 1/20 --seed 1", "measures.delaunay_margin.margin"),
        ("--manifold torus-2-anisotropic --radius 1/20", "levels.4.margin"),
        ("--manifold torus-of-revolution --radius 1/10 --seed 1", "levels.5i.margin")]

TYPES = {"object": dict, "array": list, "string": str, "boolean": bool, "null": type(None)}


def has_type(value, name):
    if name in ("integer", "number"):
        return isinstance(value, int if name == "integer" else (int, float)) and not isinstance(value, bool)
    return isinstance(value, TYPES[name])


def faults(value, schema, root, place="$"):
    """What is wrong with the value, each as a line."""
    found = []
    for keyword, argument in schema.items():
        if keyword == "$ref":
            found += faults(value, root["$defs"][argument.removeprefix("#/$defs/")], root, place)
        elif keyword == "anyOf":
            if all(faults(value, one, root, place) for one in argument):
                found.append(f"{place}: none of the alternatives")
        elif keyword == "type":
            if not has_type(value, argument):
                found.append(f"{place}: not of type {argument}")
        elif keyword == "const":
            if value != argument or isinstance(value, bool) != isinstance(argument, bool):
                found.append(f"{place}: not {argument}")
        elif keyword == "enum":
            if value not in argument:
                found.append(f"{place}: not one of {argument}")
        elif keyword == "pattern":
            if isinstance(value, str) and not re.search(argument, value):
                found.append(f"{place}: does not match {argument}")
        elif keyword in ("minimum", "maximum"):
            if has_type(value, "number") and (value < argument if keyword == "minimum" else value > argument):
                found.append(f"{place}: {keyword} {argument}")
        elif keyword in ("minItems", "maxItems"):
            if isinstance(value, list) and (len(value) < argument if keyword == "minItems" else len(value) > argument):
                found.append(f"{place}: {keyword} {argument}")
        elif keyword == "prefixItems":
            if isinstance(value, list):
                for at, one in enumerate(value[:len(argument)]):
                    found += faults(one, argument[at], root, f"{place}[{at}]")
        elif keyword == "items":
            if isinstance(value, list):
                for at, one in enumerate(value):
                    found += faults(one, argument, root, f"{place}[{at}]")
        elif keyword == "required":
            if isinstance(value, dict):
                found += [f"{place}: no key {key}" for key in argument if key not in value]
        elif keyword == "properties":
            if isinstance(value, dict):
                for key, one in argument.items():
                    if key in value:
                        found += faults(value[key], one, root, f"{place}.{key}")
        elif keyword == "additionalProperties":
            if isinstance(value, dict) and not argument:
                found += [f"{place}: unknown key {key}" for key in value if key not in schema.get("properties", {})]
        elif keyword not in ("$schema", "$defs", "title", "description"):
            sys.exit(f"the schema has a keyword that is not known here: {keyword}")
    return found


def property_names(schema):
    """Of all objects that the schema describes."""
    if isinstance(schema, list):
        return {name for one in schema for name in property_names(one)}
    if not isinstance(schema, dict):
        return set()
    return set(schema.get("properties", {})) | property_names(list(schema.values()))


def number(text):
    match = re.fullmatch(r"(-?)0x([0-9a-f]+)(?:p(-?[0-9]+))?", text)
    if not match:
        return Fraction(text)
    return (-1 if match[1] else 1) * int(match[2], 16) * Fraction(2) ** int(match[3] or 0)


def unsafe_bounds(value, radius, place="$"):
    """Doubles that say more than the exact number, or that are far from it."""
    if isinstance(value, list):
        return [line for at, one in enumerate(value) for line in unsafe_bounds(one, radius, f"{place}[{at}]")]
    if not isinstance(value, dict):
        return []
    if "bound" not in value:
        return [line for key, one in value.items() for line in unsafe_bounds(one, radius, f"{place}.{key}")]
    exact = number(value["exact"])
    pairs = [(exact, value["value"])]
    if value["unit"] != "1":
        pairs.append((exact / radius ** (2 if value["unit"] == "length^2" else 1), value["in_sampling_radii"]))
    sign = 1 if value["bound"] == "lower" else -1
    return [f"{place}: {shown} says more than {truth}" if sign * Fraction(shown) > sign * truth else
            f"{place}: {shown} is far from {truth}"
            for truth, shown in pairs
            if sign * Fraction(shown) > sign * truth or abs(Fraction(shown) - truth) > abs(truth) / 2 ** 50]


def at(report, path):
    for key in path.split("."):
        report = report[int(key)] if isinstance(report, list) else report[key]
    return report


def without(path):
    def change(report):
        folder, _, key = path.rpartition(".")
        del (at(report, folder) if folder else report)[key]
    return change


def with_value(path, value):
    def change(report):
        folder, _, key = path.rpartition(".")
        (at(report, folder) if folder else report)[key] = value
    return change


# Of the circle, each is refused.
TWINS = [without("manifold"), without("levels.1.protection"), without("levels.1.protection.unit"),
         without("levels.1.protection.in_sampling_radii"), with_value("levels.1.protection", "1/2"),
         with_value("levels.1.protection.value", "0.5"), with_value("levels.1.protection.bound", "upper"),
         with_value("levels.1.thickness.unit", "length"), with_value("levels.7", {}), with_value("points", 2.5),
         with_value("points", True), with_value("points", -1), with_value("version", 2),
         with_value("manifold.family", "space-form"), with_value("parameters.separation", 1),
         with_value("parameters.separation", "1.5"), with_value("input.0.verdict", "true"),
         with_value("levels.6.bilipschitz", []), with_value("levels.6.bilipschitz.0.bound", "upper"),
         with_value("new", 1)]
UNSAFE_TWINS = [with_value("levels.1.protection.value", 1.0), with_value("levels.1.circumradius.value", 0.0),
                with_value("levels.1.protection.value", 0.0), with_value("levels.1.protection.in_sampling_radii", 2.0)]


def main():
    program, schema, page = sys.argv[1], json.loads(Path(sys.argv[2]).read_text()), Path(sys.argv[3]).read_text()
    missing = [name for name in sorted(property_names(schema)) if f"`{name}`" not in page]
    if missing:
        sys.exit(f"{sys.argv[3]} does not describe {', '.join(missing)}")
    circle = None
    with tempfile.TemporaryDirectory() as folder:
        for options, path in RUNS:
            command = [program, "certify", *options.split(), "--json", "--output", folder + "/c.json"]
            report = json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)
            circle = circle or report
            certificate = json.loads(Path(folder, "c.json").read_text())
            if list(report["levels"]) != list(certificate["levels"]):
                sys.exit(f"{options}: levels {list(report['levels'])}, in the certificate {list(certificate['levels'])}")
            lines = faults(report, schema, schema) + unsafe_bounds(report, number(report["parameters"]["sampling_radius"]))
            if lines:
                sys.exit(f"{options}:\n  " + "\n  ".join(lines))
            at(report, path)
    for twin, find in [(twin, lambda wrong: faults(wrong, schema, schema)) for twin in TWINS] + [
            (twin, lambda wrong: unsafe_bounds(wrong, number(wrong["parameters"]["sampling_radius"])))
            for twin in UNSAFE_TWINS]:
        wrong = copy.deepcopy(circle)
        twin(wrong)
        if not find(wrong):
            sys.exit(f"twin {(TWINS + UNSAFE_TWINS).index(twin)} is not refused")


main()
