"""The line that says how far long work is."""

import io

from cases import Case, small
from delcert.progress import ProgressLine, progress_of


class Terminal(io.StringIO):
    def isatty(self):
        return True


class Progress(Case):
    def line(self, stream, times):
        return ProgressLine(stream, clock=iter(times).__next__)

    def test_a_line_says_the_stage_and_the_share_and_is_removed(self):
        terminal = Terminal()
        with self.line(terminal, [0.0, 1.0, 1.1, 3.0]) as told:
            told("perturbing", 1, 4)
            told("perturbing", 2, 4)
            told("perturbing", 3, 4)
            told("writing", 0, 0)
        first, second, third, removed, end = terminal.getvalue().split("\r")[1:]
        self.assertEqual((first, second), ("perturbing: 1/4 (25 %), 0 s", "perturbing: 2/4 (50 %), 1 s"))
        self.assertEqual(third.rstrip(), "writing: 0, 0 s")
        self.assertEqual((removed.strip(), end), ("", ""))

    def test_where_there_is_no_terminal_nothing_is_drawn(self):
        stream = io.StringIO()
        with self.line(stream, [0.0]) as told:
            told("perturbing", 1, 4)
        self.assertEqual(stream.getvalue(), "")

    def test_a_function_is_told_all_stages(self):
        stages = []
        small(progress=lambda stage, done, total: stages.append((stage, done <= total)))
        self.assertGreater(len({stage for stage, _ in stages}), 2)
        self.assertTrue(all(fits for _, fits in stages))
        self.assertIsNone(progress_of(None).__enter__())
        self.assertIsInstance(progress_of(True), ProgressLine)
