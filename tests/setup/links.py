"""links.py FOLDER: every relative link of every Markdown page below FOLDER leads to a file, and to a heading of it if it names one."""

import re
import sys
from pathlib import Path
from urllib.parse import unquote

LEFT_OUT = ("build", "node_modules", ".git", "certificates")
FENCE = re.compile(r"^(```|~~~).*?^\1", re.MULTILINE | re.DOTALL)
CODE = re.compile(r"`[^`\n]*`")
LINK = re.compile(r"!?\[(?:[^\[\]]|\[[^\]]*\])*\]\(\s*<?([^)\s>]+)>?(?:\s+\"[^\"]*\")?\s*\)")
HEADING = re.compile(r"^#{1,6}\s+(.*?)\s*#*\s*$", re.MULTILINE)


def pages_below(folder):
    for page in sorted(folder.rglob("*.md")):
        if not any(part in LEFT_OUT for part in page.relative_to(folder).parts):
            yield page


def anchors_of(text):
    """The names that a heading gets: lower case, without punctuation, blanks as hyphens, numbered if they repeat."""
    found = {}
    names = set(re.findall(r"<a (?:id|name)=\"([^\"]+)\"", text))
    for heading in HEADING.findall(FENCE.sub("", text)):
        words = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading).replace("`", "").replace("*", "")
        name = "".join(c for c in words.strip().lower() if c.isalnum() or c in " -_").replace(" ", "-")
        count = found.get(name, 0)
        found[name] = count + 1
        names.add(name if count == 0 else f"{name}-{count}")
    return names


def complaints(folder):
    for page in pages_below(folder):
        text = CODE.sub("", FENCE.sub("", page.read_text(encoding="utf-8")))
        for target in LINK.findall(text):
            if re.match(r"[a-z]+:", target):
                continue
            path, _, anchor = unquote(target).partition("#")
            file = (page.parent / path).resolve() if path else page
            if not file.exists():
                yield f"{page.relative_to(folder)}: {target}: there is no such file"
            elif anchor and file.suffix == ".md" and anchor not in anchors_of(file.read_text(encoding="utf-8")):
                yield f"{page.relative_to(folder)}: {target}: there is no such heading"


def main():
    found = list(complaints(Path(sys.argv[1]).resolve()))
    print("\n".join(found) if found else "every link leads somewhere")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
