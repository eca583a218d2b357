"""documented.py PAGE [--renew]: runs the examples of a page's blocks ```python, in order, as at Python's prompt. Fails, naming
the line, where one prints something else than the page shows; with --renew writes what they print into the page."""

import contextlib
import doctest
import io
import os
import re
import sys
import tempfile
import traceback
from pathlib import Path

BLOCK = re.compile(r"^```python\n(.*?)^```$", re.M | re.S)


def printed(source, names):
    """What Python prints after this is entered, without empty lines at the end; of an exception the last line."""
    out = io.StringIO()
    with contextlib.redirect_stdout(out):
        try:
            exec(compile(source, "<page>", "single"), names)
        except Exception as error:
            print("".join(traceback.format_exception_only(type(error), error)), end="")
    return "".join(line.rstrip() + "\n" for line in out.getvalue().rstrip().splitlines())


def shown(example):
    lines = example.source.splitlines()
    return "".join(f"{'>>>' if at == 0 else '...'} {line}".rstrip() + "\n" for at, line in enumerate(lines))


def run(text):
    """The page with what its examples print, and a complaint for each that prints something else."""
    names, complaints = {"__name__": "__main__"}, []

    def renewed(block):
        first = text[: block.start()].count("\n") + 2
        result = ""
        for example in doctest.DocTestParser().get_examples(block[1]):
            found = printed(example.source, names)
            if found != example.want:
                where = first + example.lineno
                complaints.append(f"line {where}: {example.source}prints\n{found}and not\n{example.want}")
            result += shown(example) + found
        return f"```python\n{result}```"

    new = BLOCK.sub(renewed, text)
    return new, complaints


def main(page, *options):
    path = Path(page).resolve()
    text = path.read_text()
    if not BLOCK.search(text):
        return f"{page}: no examples"
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        new, complaints = run(text)
        os.chdir("/")
    if "--renew" in options:
        path.write_text(new)
        return 0
    return "\n".join(f"{page}: {one}" for one in complaints) or 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
