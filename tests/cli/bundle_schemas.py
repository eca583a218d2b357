"""bundle_schemas.py BUNDLE: the descriptions in a bundle follow their schemas, and every change of one is noticed.

What is changed, one place at a time: each value becomes one of another type, each key that is required is left out, and a
key is added that nobody knows. Of the RO-Crate also what no schema says: what it names exists, and it names everything.
"""
import copy
import json
import sys
import zipfile
from pathlib import Path

import jsonschema
import yaml

SCHEMAS = Path(__file__).resolve().parent / "schemas"
DESCRIPTIONS = {
    "CITATION.cff": ("citation", yaml.safe_load),
    ".zenodo.json": ("zenodo", json.loads),
    "codemeta.json": ("codemeta", json.loads),
    "ro-crate-metadata.json": ("ro-crate", json.loads),
}
# It is in the crate, and says itself what it is; sums are computed after it.
NOT_IN_THE_CRATE = {"ro-crate-metadata.json", "SHA256SUMS"}


def crate_faults(crate, sizes):
    """What is wrong between the entities of a crate and the files of its archive, whose sizes these are."""
    entities = {}
    for entity in crate["@graph"]:
        if entity["@id"] in entities:
            yield f"{entity['@id']} is described twice"
        entities[entity["@id"]] = entity
    missing = {"ro-crate-metadata.json", "./"} - set(entities)
    if missing:
        yield f"{missing} is not described"
        return
    root = entities["./"]
    parts = [part["@id"] for part in root["hasPart"]]
    if sorted(parts) != sorted(set(sizes) - NOT_IN_THE_CRATE):
        yield "the parts are not the files"
    referred = [*parts, *(author["@id"] for author in root.get("author", []))]
    if isinstance(root["license"], dict):
        referred.append(root["license"]["@id"])
    for name in referred:
        if name not in entities:
            yield f"{name} is not described"
    for name, entity in entities.items():
        if name not in {"./", "ro-crate-metadata.json", *referred}:
            yield f"nothing refers to {name}"
        if entity["@type"] == "File" and name in sizes and entity["contentSize"] != str(sizes[name]):
            yield f"{name} has another size"


def faults(name, document, sizes):
    schema = json.loads((SCHEMAS / f"{DESCRIPTIONS[name][0]}.schema.json").read_text())
    found = [error.message for error in jsonschema.Draft7Validator(schema).iter_errors(document)]
    if not found and name == "ro-crate-metadata.json":
        found = list(crate_faults(document, sizes))
    return found


def places(value, path=()):
    """Of all values in a document, from outside inwards. Of equal kinds of files in a crate the first three."""
    yield path
    if isinstance(value, dict):
        for key, inner in value.items():
            yield from places(inner, (*path, key))
    if isinstance(value, list):
        for at, inner in enumerate(value):
            if at < 6:
                yield from places(inner, (*path, at))


def changed(document, path, change):
    result = copy.deepcopy(document)
    if not path:
        return change(result)
    holder = result
    for step in path[:-1]:
        holder = holder[step]
    holder[path[-1]] = change(holder[path[-1]])
    return result


def changes(document, required):
    for path in places(document):
        yield f"{path} of another type", changed(document, path, lambda value: 7)
        yield f"{path} empty", changed(document, path, lambda value: type(value)())
        value = document
        for step in path:
            value = value[step]
        if isinstance(value, dict):
            yield f"{path} with another key", changed(document, path, lambda of: {**of, "unknown": "x"})
            for key in value:
                if key in required:
                    yield f"{path} without {key}", changed(
                        document, path, lambda of: {other: of[other] for other in of if other != key})
        if isinstance(value, list) and path[-1] == "@graph":
            for at in range(len(value)):
                yield f"{path} without {at}", changed(document, path, lambda of: of[:at] + of[at + 1:])


def required_keys(schema):
    if isinstance(schema, dict):
        return set(schema.get("required", [])).union(*(required_keys(inner) for inner in schema.values()))
    if isinstance(schema, list):
        return set().union(*(required_keys(inner) for inner in schema))
    return set()


def main(bundle):
    archive = zipfile.ZipFile(bundle)
    sizes = {entry.filename: entry.file_size for entry in archive.infolist()}
    tried, failures = 0, []
    for name, (schema, read) in DESCRIPTIONS.items():
        document = read(archive.read(name).decode())
        failures += [f"{name}: {fault}" for fault in faults(name, document, sizes)]
        required = required_keys(json.loads((SCHEMAS / f"{schema}.schema.json").read_text()))
        for what, other in changes(document, required):
            tried += 1
            if not faults(name, other, sizes):
                failures.append(f"{name}: {what} is not noticed")
    for failure in failures:
        print(failure)
    if not failures:
        print(f"{len(DESCRIPTIONS)} descriptions follow their schemas; {tried} changes are noticed")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
