"""What links.py finds, and what it leaves alone."""

import tempfile
import unittest
from pathlib import Path

from links import complaints


class Links(unittest.TestCase):
    def found(self, pages):
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            for path, text in pages.items():
                (folder / path).parent.mkdir(parents=True, exist_ok=True)
                (folder / path).write_text(text, encoding="utf-8")
            return list(complaints(folder.resolve()))

    def test_links_that_lead_somewhere(self):
        pages = {
            "README.md": "[a](docs/a.md) [b](docs/a.md#two-words) [c](#own) ![d](docs/d.svg) [e](https://example.org/x)\n\n# Own\n",
            "docs/a.md": "# Two *words*\n\n[up](../README.md)\n",
            "docs/d.svg": "",
        }
        self.assertEqual(self.found(pages), [])

    def test_files_and_headings_that_are_not_there(self):
        self.assertEqual(self.found({"a.md": "[x](b.md)"}), ["a.md: b.md: there is no such file"])
        self.assertEqual(self.found({"a.md": "# One\n[x](#two)"}), ["a.md: #two: there is no such heading"])
        self.assertEqual(len(self.found({"a.md": "[x](b.md#one-1)", "b.md": "# One\n"})), 1)

    def test_headings_that_repeat(self):
        self.assertEqual(self.found({"a.md": "[x](#one-1)\n# One\n# One\n"}), [])

    def test_what_is_code_is_no_link(self):
        self.assertEqual(self.found({"a.md": "`[x](nowhere.md)`\n\n```\n[y](nowhere.md)\n# [z](n)\n```\n"}), [])

    def test_headings_in_code_are_none(self):
        self.assertEqual(len(self.found({"a.md": "[x](#one)\n```\n# One\n```\n"})), 1)


if __name__ == "__main__":
    unittest.main()
