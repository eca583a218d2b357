"""notebooks.py FILE: runs all cells of a notebook in a kernel of this Python. Fails where a cell raises something, and where
the file holds outputs."""

import sys
import tempfile
from pathlib import Path

import nbformat
from nbclient import NotebookClient
from nbclient.exceptions import CellExecutionError


def complaint(path):
    notebook = nbformat.read(path, as_version=4)
    code = [cell for cell in notebook.cells if cell.cell_type == "code"]
    if not code:
        return "no cells to run"
    if any(cell.outputs or cell.execution_count for cell in code):
        return "it is stored with outputs"
    with tempfile.TemporaryDirectory() as folder:
        client = NotebookClient(notebook, timeout=600, kernel_name="python3", resources={"metadata": {"path": folder}})
        try:
            client.execute()
        except CellExecutionError as error:
            return str(error)
    if not any(cell.outputs for cell in code):
        return "no cell shows anything"
    return None


if __name__ == "__main__":
    found = complaint(Path(sys.argv[1]))
    sys.exit(found and f"{sys.argv[1]}: {found}")
