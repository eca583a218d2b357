#!/usr/bin/env python3
"""golden_test.py DELCERT: golden.py notices a change of each section, and says which; another spelling of the same
number is no change of the geometry."""

import re
import sys

import golden

certificate = golden.certify(sys.argv[1], dict(golden.table("certificates.tsv"))["circle"])
kept = golden.sections_of(certificate)


def expect(what, pattern, replacement, changed):
    text, count = re.subn(pattern, replacement, certificate.decode(), count=1)
    if count != 1 or text == certificate.decode():
        sys.exit(f"{what}: nothing to change")
    found = golden.differences(golden.sections_of(text.encode()), kept)
    if found != changed:
        sys.exit(f"{what}: {found} instead of {changed}")


if golden.differences(golden.sections_of(certificate), kept):
    sys.exit("the same certificate has other digests")
expect("a version", r'"delcert":"[^"]*"', '"delcert":"9"', [])
expect("a name", r'"name":"circle"', '"name":"Circle"', ["document", "manifold"])
expect("a seed", r'"seed":"0"', '"seed":"1"', ["document", "parameters"])
expect("a margin", r'"protection":"', '"protection":"1', ["document", "levels"])
expect("a point of the net", r'"net":\[\["', '"net":[["-', ["document", "net"])
expect("a point", r'"points":\[\["0x', '"points":[["0x1', ["document", "points"])
expect("another spelling", r'"points":\[\["0x', '"points":[["0x0', ["document"])
expect("a simplex", r'"simplices":\[\[[0-9]+,', '"simplices":[[17,', ["document", "simplices"])
