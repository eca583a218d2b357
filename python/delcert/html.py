"""Tables for notebooks."""

from html import escape


def table(rows, heading=(), title=""):
    """Rows of texts; all of them are escaped."""
    text = f"<p><b>{escape(title)}</b></p>" if title else ""
    text += "<table>"
    if heading:
        text += "<tr>" + "".join(f"<th>{escape(str(cell))}</th>" for cell in heading) + "</tr>"
    for row in rows:
        text += "<tr>" + "".join(f'<td style="text-align: left">{escape(str(cell))}</td>' for cell in row) + "</tr>"
    return text + "</table>"


class Rows(list):
    """A list of dicts or objects that prints itself as a table."""

    def __init__(self, rows, columns, title=""):
        super().__init__(rows)
        self.columns, self.title = columns, title

    def _cells(self):
        def cell(row, column):
            return row.get(column, "") if isinstance(row, dict) else getattr(row, column)

        return [[cell(row, column) for column in self.columns] for row in self]

    def __repr__(self):
        cells = [[str(cell) for cell in row] for row in [self.columns, *self._cells()]]
        widths = [max(map(len, column)) for column in zip(*cells)]
        return "\n".join("  ".join(text.ljust(width) for text, width in zip(row, widths)).rstrip() for row in cells)

    def _repr_html_(self):
        return table(self._cells(), self.columns, self.title)
