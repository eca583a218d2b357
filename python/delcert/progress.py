"""How far long work is, on one line of standard error."""

import sys
import time


class ProgressLine:
    """Draws "perturbing: 4120/10293 (40 %), 2 s", at most five times a second, and removes it at the end. It needs a
    terminal or a notebook; elsewhere nothing is drawn."""

    def __init__(self, stream=None, clock=time.monotonic, shown=None):
        self.stream = sys.stderr if stream is None else stream
        self.clock = clock
        self.shown = has_lines(self.stream) if shown is None else shown
        self.stage, self.start, self.drawn, self.width = None, 0.0, None, 0

    def __call__(self, stage, done, total):
        now = self.clock()
        if stage != self.stage:
            self.stage, self.start = stage, now
        elif self.drawn is not None and now - self.drawn < 0.2:
            return
        self.drawn = now
        share = f"/{total} ({100 * done // total} %)" if total else ""
        self._write(f"{stage}: {done}{share}, {now - self.start:.0f} s")

    def clear(self):
        if self.width:
            self._write("")
            self._put("\r")

    def _write(self, text):
        self._put("\r" + text + " " * (self.width - len(text)))
        self.width = len(text)

    def _put(self, text):
        if self.shown:
            self.stream.write(text)
            self.stream.flush()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.clear()


def has_lines(stream):
    """A terminal, or the output of a notebook's cell, where \\r begins the line anew, too."""
    return bool(getattr(stream, "isatty", bool)()) or type(stream).__module__.startswith("ipykernel")


class NoLine:
    """In the place of a `ProgressLine` where nothing, or a function of the user, is told."""

    def __init__(self, told):
        self.told = told

    def __enter__(self):
        return self.told

    def __exit__(self, *_):
        pass


def progress_of(asked):
    """For `progress=`: True draws a line, a function is called with (stage, done, total), None and False do nothing."""
    if asked is True:
        return ProgressLine()
    return NoLine(asked or None)
