"""What these tests share."""

import tempfile
import unittest
from pathlib import Path

import delcert

SOURCE = Path(__file__).parents[2]


class Case(unittest.TestCase):
    """A test with a folder of its own."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def message_of(self, kind, call, *arguments, **options):
        """What it says when it raises what it should."""
        with self.assertRaises(kind) as found:
            call(*arguments, **options)
        self.assertIs(type(found.exception), kind)
        return str(found.exception)


def small(output=None, **options):
    """A certificate that is made in half a second: of dimension 2, with levels 1 to 6."""
    return delcert.certify("klein-bottle", radius="1/20", seed=1, output=output, **options)
