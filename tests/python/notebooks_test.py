"""What runs notebooks notices one that is broken."""

import nbformat.v4
from cases import Case
from notebooks import complaint


class Notebooks(Case):
    def complaint(self, *sources, outputs=()):
        cells = [nbformat.v4.new_code_cell(source, outputs=list(outputs)) for source in sources]
        path = self.folder / "notebook.ipynb"
        nbformat.write(nbformat.v4.new_notebook(cells=cells), path)
        return complaint(path)

    def test_one_that_is_right_passes(self):
        self.assertIsNone(self.complaint("x = 2", "assert x == 2\nx"))

    def test_one_that_is_wrong_does_not(self):
        self.assertIn("AssertionError", self.complaint("x = 2", "assert x == 3\nx"))
        self.assertIn("no cells", self.complaint())
        self.assertIn("no cell shows anything", self.complaint("x = 2"))
        self.assertIn("outputs", self.complaint("x = 2", outputs=[nbformat.v4.new_output("stream", text="2")]))
