#!/usr/bin/env python3
"""chunks_test.py DELCERT DELCERT-CHECK FOLDER: certificates in chunks (docs/certificate-in-chunks.md).

`delcert split` writes what another implementation of the page, here, writes, byte for byte; the receipts of all chunks say
what one check says; each forgery is rejected by its rule, where it is; receipts that are not of one whole are refused."""

import bisect
import hashlib
import json
import os
import shutil
import subprocess
import sys

delcert, checker, folder = sys.argv[1:4]
shutil.rmtree(folder, ignore_errors=True)
os.makedirs(folder)
os.chdir(folder)
faults = []


def expect(what, found, expected):
    if found != expected:
        faults.append(f"{what}: found {found!r}, expected {expected!r}")


def run(*words):
    done = subprocess.run([str(word) for word in words], capture_output=True, text=True, check=False)
    return done.returncode, done.stdout, done.stderr


def dumped(value):
    return json.dumps(value, separators=(",", ":"), ensure_ascii=False)


def sealed(text):
    return text + ',"sha256":"' + hashlib.sha256(text.encode()).hexdigest() + '"}\n'


def root_of(digests):
    level = [bytes.fromhex(digest) for digest in digests]
    while len(level) > 1:
        level = [hashlib.sha256(b"\1" + b"".join(level[at:at + 2])).digest() if at + 1 < len(level) else level[at]
                 for at in range(0, len(level), 2)]
    return level[0].hex()


def digest_of(text):
    return hashlib.sha256(b"\0" + text.encode()).hexdigest()


def in_chunks(certificate, number):
    """The texts of the files, by name, as the page says."""
    points, simplices = certificate["points"], certificate["simplices"]
    count, corners = len(points), len(points[0]) + 1
    first = [count // number * k + min(k, count % number) for k in range(number + 1)]
    texts, table = {}, []
    members, own = [[] for _ in range(number)], [0] * number
    for simplex in simplices:
        chunks = [bisect.bisect_right(first, label) - 1 for label in simplex[:corners]]
        own[chunks[0]] += 1
        for chunk in set(chunks):
            members[chunk].append(simplex)
    for k in range(number):
        chunk = {"format": "delcert-chunk", "version": 1, "net": certificate["net"][first[k]:first[k + 1]],
                 "points": points[first[k]:first[k + 1]], "simplices": members[k]}
        texts[str(k + 1)] = dumped(chunk) + "\n"
        table.append([first[k], own[k], digest_of(texts[str(k + 1)])])
    levels = dict(certificate["levels"])
    levels["2"] = {key: value for key, value in levels["2"].items() if key != "homology"}
    loops = [[simplices[loop[at]] + loop[at + 1:at + 3] for at in range(0, len(loop), 3)]
             for loop in certificate["loops"]]
    header = {"format": "delcert-chunks", "version": 1, "points": count, "chunks": table,
              "root": root_of([entry[2] for entry in table])}
    header |= {key: certificate[key] for key in ("software", "manifold", "parameters")}
    header |= {"levels": levels, "elements": certificate["elements"], "loops": loops}
    texts["header"] = sealed(dumped(header)[:-1])
    return texts


class Folder:
    """The files of a certificate in chunks, to be changed."""

    def __init__(self, texts, name):
        self.name, self.number = name, len(texts) - 1
        shutil.rmtree(name, ignore_errors=True)
        os.makedirs(name)
        for file, text in texts.items():
            self.put(file, text)

    def put(self, file, text):
        with open(f"{self.name}/{file}.json", "w", encoding="utf-8") as stream:
            stream.write(text)

    def text(self, file):
        with open(f"{self.name}/{file}.json", encoding="utf-8") as stream:
            return stream.read()

    def change(self, file, edit):
        """And what depends on it: digests, root, seal."""
        value = json.loads(self.text(file))
        edit(value)
        self.put(file, dumped(value) + "\n")
        header = json.loads(self.text("header"))
        for k, entry in enumerate(header["chunks"]):
            entry[2] = digest_of(self.text(str(k + 1)))
        header["root"] = root_of([entry[2] for entry in header["chunks"]])
        self.seal(header)

    def seal(self, header):
        header.pop("sha256", None)
        self.put("header", sealed(dumped(header)[:-1]))

    def check(self, k):
        status, output, error = run(checker, "--chunk", k, "--receipt", f"{self.name}.{k}", "--json", self.name)
        if not output:
            return status, {error}
        outcome = json.loads(output)
        if outcome["malformed"]:
            return status, {outcome["malformed"]["rule"]}
        return status, {finding["rule"] for level in outcome["levels"] for finding in level["findings"]}

    def merge(self, *receipts):
        """The status, and the rule by which it is refused or the last line."""
        names = receipts or [f"{self.name}.{k + 1}" for k in range(self.number)]
        status, output, error = run(checker, "--merge", *names)
        if error:
            return status, next(word.rstrip(":") for word in error.split() if word.startswith("merge."))
        return status, output.splitlines()[-1].split("(")[0].strip()


def certificate_of(manifold, radius):
    file = f"{manifold}.json"
    status, _, error = run(delcert, "certify", "--manifold", manifold, "--radius", radius, "--seed", 1, "--output", file)
    expect(manifold + error, status, 0)
    with open(file, encoding="utf-8") as stream:
        return json.load(stream)


# Together they are what one check verifies: of each curvature, with and without loops.
whole = {}
for manifold, radius, number in (("sphere-2", "1/10", 5), ("bolza-surface", "1/8", 3), ("klein-bottle", "1/20", 2)):
    certificate = certificate_of(manifold, radius)
    texts = whole[manifold] = in_chunks(certificate, number)
    status, _, error = run(delcert, "split", f"{manifold}.json", "--chunks", number, "--output", f"{manifold}.split")
    expect(f"split {manifold} {error}", status, 0)
    for file, text in texts.items():
        packed = f"{manifold}.split/{file}.json.zst"
        found = subprocess.run(["zstd", "-dc", packed], capture_output=True, check=False).stdout.decode()
        expect(f"{packed} is as the page says", found == text, True)
    together = Folder(texts, f"{manifold}.chunks")
    for k in range(1, number + 1):
        expect(f"{manifold}, chunk {k}", together.check(k), (0, set()))
        status, output, _ = run(checker, "--chunk", k, "--receipt", "r", f"{manifold}.split")
        expect("no chunk is said to be verified", (status, "verified:" in output, "passed, part" in output), (0, False, True))
    one = run(checker, f"{manifold}.json")[1].splitlines()[-1].split("(")[0].strip()
    expect(manifold, together.merge(), (0, one))
    expect("with its header", run(checker, "--merge", *[f"{manifold}.chunks.{k + 1}" for k in range(number)],
                                  f"{manifold}.chunks/header.json")[0], 0)

bolza = whole["bolza-surface"]
first_of_second = json.loads(bolza["header"])["chunks"][1][0]


def shared(chunk):
    """In chunk 2, a simplex that chunk 1 has too."""
    return next(at for at, simplex in enumerate(chunk["simplices"]) if simplex[0] < first_of_second)


def other_element(chunk):
    simplex = chunk["simplices"][shared(chunk)]
    simplex[-1] = 1 if simplex[-1] == 0 else 0


def header_with(edit):
    def change(target):
        header = json.loads(target.text("header"))
        edit(header)
        target.seal(header)
    return change


def third_vertex(header):
    """The same edge of a simplex that is not in the list."""
    step = header["loops"][0][0]
    third = 3 - step[5] - step[6]
    step[third] += 1 if third == 2 or step[third] + 1 < step[third + 1] else -1


def add_count(header):
    header["chunks"][0][1] += 1


def exchange(target):
    one, two = target.text("1"), target.text("2")
    target.put("1", two)
    target.put("2", one)


forgeries = [
    ("altered", "chunk.digest", 3, 2, lambda target: target.put("2", target.text("2") + " ")),
    ("altered, and a neighbour", "chunk.digest", 3, 1, lambda target: target.put("2", target.text("2") + " ")),
    ("exchanged", "chunk.digest", 3, 1, exchange),
    ("missing", "chunk.file", 3, 1, lambda target: os.remove(f"{target.name}/2.json")),
    ("another root", "chunk.root", 3, 1, header_with(lambda header: header.update(root="0" * 64))),
    ("first labels", "chunk.ranges", 3, 1, header_with(lambda header: header["chunks"][1].__setitem__(0, 0))),
    ("no such chunk", "chunk.ranges", 3, 9, lambda target: None),
    ("a simplex too few", "chunk.labels", 3, 1, header_with(add_count)),
    ("a point too few", "chunk.labels", 3, 1, lambda target: target.change("1", lambda chunk: chunk["points"].pop())),
    ("not sealed", "seal", 3, 1, lambda target: target.put("header", target.text("header").replace("bolza", "balzo", 1))),
    ("a homology", "form.family", 3, 1,
     header_with(lambda header: header["levels"]["2"].update(homology=["Z", "Z^4", "Z"]))),
    ("a simplex in one of two chunks", "chunk.border", 1, 1,
     lambda target: target.change("2", lambda chunk: header_free(chunk))),
    ("other elements", "chunk.border", 1, 1, lambda target: target.change("2", other_element)),
    ("a loop through nothing", "core.group", 1, 1, header_with(third_vertex)),
    ("no loop", "form.loops", 3, 1, header_with(lambda header: header["loops"].pop())),
    ("a point elsewhere", "core.facets", 1, 2,
     lambda target: target.change("2", lambda chunk: chunk["points"].__setitem__(9, ["1/2", "0"]))),
]


def header_free(chunk):
    del chunk["simplices"][shared(chunk)]


for name, rule, status, k, forge in forgeries:
    target = Folder(bolza, "forged")
    forge(target)
    found, rules = target.check(k)
    expect(f"{name}: {rules}", (found, rule in rules), (status, True))

# What is wrong in one chunk is found there and not far away, and the whole is rejected.
sphere = Folder(whole["sphere-2"], "sphere")
sphere.change("3", lambda chunk: chunk["points"].__setitem__(5, ["1/2", "0"]))
statuses = [sphere.check(k + 1)[0] for k in range(sphere.number)]
expect("the chunk of the point is rejected", statuses[2], 1)
expect("the whole is rejected", sphere.merge()[0], 1)

# Without level 4 the charts of level 2s have to be searched as far as they reach, so more than six edges are read.
weak = Folder(whole["sphere-2"], "weak")
header_with(lambda header: [header["levels"].pop(level) for level in ("0", "4", "5", "6")])(weak)
for k in range(weak.number):
    expect("weak claims", weak.check(k + 1), (0, set()))
expect("weak claims", weak.merge(), (0, "verified: levels group 1 2 2s"))

# Receipts that are not of one whole.
good = [f"sphere-2.chunks.{k}" for k in range(1, 6)]
refused = Folder(whole["sphere-2"], "refused")
expect("all", refused.merge(*good)[0], 0)
expect("one is missing", refused.merge(*good[:2], *good[3:]), (2, "merge.missing"))
expect("one is twice", refused.merge(*good, good[1]), (1, "merge.doubled"))
expect("one is of another certificate", refused.merge(*good[:2], "bolza-surface.chunks.3", *good[3:]),
       (3, "merge.certificate"))


def altered(edit, seal=True):
    with open(good[2], encoding="utf-8") as stream:
        text = stream.read()
    receipt = json.loads(text)
    edit(receipt)
    receipt.pop("sha256")
    with open("altered", "w", encoding="utf-8") as stream:
        stream.write(sealed(dumped(receipt)[:-1]) if seal else text.replace('"trees":', '"trees":1', 1))
    return refused.merge(*good[:2], "altered", *good[3:])


def range_of(receipt, rules):
    return next(item for level in receipt["levels"] for item in level["ranges"] if item["rules"] == rules)


def part(text, number, of, joins=()):
    """The receipt, of part number/of."""
    with open(text, encoding="utf-8") as stream:
        receipt = json.load(stream)
    receipt["part"] = {"number": number, "of": of}
    receipt["chunk"]["joins"] += joins
    receipt.pop("sha256")
    with open(f"part.{number}.{of}", "w", encoding="utf-8") as stream:
        stream.write(sealed(dumped(receipt)[:-1]))
    return f"part.{number}.{of}"


def fewer_facets(receipt):
    item = range_of(receipt, "core.hinges")
    item["end"] -= 1


expect("as it was", altered(lambda receipt: None)[0], 0)
expect("altered", altered(lambda receipt: None, seal=False), (3, "merge.receipt"))
expect("another root", altered(lambda receipt: receipt["chunk"].update(root="0" * 64)), (3, "merge.certificate"))
expect("a tree that nothing joins", altered(lambda receipt: receipt["chunk"].update(trees=receipt["chunk"]["trees"] + 1)),
       (1, "merge.connected"))
expect("a facet too few", altered(fewer_facets), (1, "merge.count"))
expect("a root that is none", altered(lambda receipt: receipt["chunk"].update(root="")), (3, "merge.receipt"))
expect("other numbers of chunks, joined to one that is not there",
       refused.merge(part(good[0], 1, 2), *[part(good[k], 4 + k, 8, [[0, 2 + k, 0]]) for k in range(1, 5)]),
       (1, "merge.chunks"))
expect("a range that is not the chunk's",
       altered(lambda receipt: range_of(receipt, "0.separation").update(end=range_of(receipt, "0.separation")["end"] - 1)),
       (3, "merge.receipt"))

print("\n".join(faults) or "as expected")
sys.exit(1 if faults else 0)
