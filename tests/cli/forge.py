#!/usr/bin/env python3
"""forge.py CERTIFICATE UNSEALED RESEALED OTHER: the certificate with another circumradius in level 1, much too small,
under the old seal and under a new one; and one that says that it has dimension 4, sealed."""

import hashlib
import re
import sys


def write_sealed(path, content):
    head = content[: content.rindex(b',"sha256":"')]
    with open(path, "wb") as file:
        file.write(head + b',"sha256":"' + hashlib.sha256(head).hexdigest().encode() + b'"}\n')


def main():
    certificate, unsealed, resealed, other = sys.argv[1:]
    with open(certificate, "rb") as file:
        content = file.read()
    forged, count = re.subn(rb'"circumradius":"[^"]*"', b'"circumradius":"1/1000"', content, count=1)
    if count != 1 or forged == content:
        raise SystemExit("forge.py: there is no circumradius to forge")
    with open(unsealed, "wb") as file:
        file.write(forged)
    write_sealed(resealed, forged)
    write_sealed(other, content.replace(b'"dimension":1', b'"dimension":4', 1))


if __name__ == "__main__":
    main()
