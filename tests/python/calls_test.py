"""What a call does to the rest of the process: the rounding mode, other threads, Ctrl-C."""

import ctypes
import os
import signal
import subprocess
import sys
import textwrap
import threading

import delcert
import numpy
from cases import Case, small

MATH = ctypes.CDLL("libm.so.6")
UPWARD = 0x800  # FE_UPWARD of x86-64
TENTHS = numpy.full(1000, 0.1)


def sums():
    return float(numpy.cumsum(TENTHS)[-1]).hex()


class Rounding(Case):
    """Certified arithmetic rounds upwards inside; nobody sees that outside."""

    def setUp(self):
        super().setUp()
        if MATH.fegetround() != 0:
            self.fail("rounding is not to nearest to begin with")
        self.addCleanup(MATH.fesetround, 0)
        self.before = sums()

    def expect_nearest(self):
        self.assertEqual(MATH.fegetround(), 0)
        self.assertEqual(sums(), self.before)

    def test_sums_can_tell(self):
        MATH.fesetround(UPWARD)
        self.assertNotEqual(sums(), self.before)

    def test_after_a_result(self):
        small()
        self.expect_nearest()

    def test_after_what_was_refuted(self):
        self.message_of(delcert.Refuted, delcert.certify, "torus-2", lattice=30, no_perturbation=True)
        self.expect_nearest()

    def test_after_an_exception_of_the_caller_who_had_changed_the_mode(self):
        def told(*_):
            MATH.fesetround(UPWARD)
            raise LookupError("enough")

        with self.assertRaises(LookupError):
            small(progress=told)
        self.expect_nearest()

    def test_the_mode_of_the_caller_does_not_matter_and_is_his_again(self):
        MATH.fesetround(UPWARD)
        sha256 = small(output=self.folder / "upward.json").sha256
        self.assertEqual(MATH.fegetround(), UPWARD)
        MATH.fesetround(0)
        self.assertEqual(small(output=self.folder / "nearest.json").sha256, sha256)


class Threads(Case):
    def ticks_during(self, call):
        """How often another thread of Python comes to its turn meanwhile."""
        ticks, over = [0], threading.Event()

        def tick():
            while not over.is_set():
                ticks[0] += 1
                over.wait(0.001)

        thread = threading.Thread(target=tick)
        thread.start()
        try:
            before = ticks[0]
            call()
            return ticks[0] - before
        finally:
            over.set()
            thread.join()

    def test_others_go_on_meanwhile(self):
        self.assertGreater(self.ticks_during(lambda: [small() for _ in range(10)]), 20)

    def test_where_the_lock_is_held_they_do_not(self):
        self.assertLess(min(self.ticks_during(lambda: pow(3, 2_000_000)) for _ in range(5)), 5)


class CtrlC(Case):
    def run_python(self, code, *arguments):
        run = [sys.executable, "-c", textwrap.dedent(code), *map(os.fspath, arguments)]
        return subprocess.run(run, capture_output=True, text=True, timeout=300)

    CODE = """
        import os, signal, sys
        import delcert

        def told(stage, done, total):
            if stage == "perturb":
                os.kill(os.getpid(), {signal})

        try:
            delcert.certify("bolza-surface", radius="1/10", seed=1, output=sys.argv[1], progress=told)
        except KeyboardInterrupt:
            print("interrupted")
        """

    def test_ends_the_run_and_leaves_nothing_behind(self):
        run = self.run_python(self.CODE.format(signal="signal.SIGINT"), self.folder / "c.json")
        self.assertEqual((run.stdout, run.stderr, run.returncode), ("interrupted\n", "", 0))
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_another_signal_does_not(self):
        run = self.run_python(self.CODE.format(signal="0"), self.folder / "c.json")
        self.assertEqual((run.stdout, run.stderr, run.returncode), ("", "", 0))
        self.assertEqual([path.name for path in self.folder.iterdir()], ["c.json"])

    def test_an_exception_of_the_function_that_is_told_is_raised_as_it_is(self):
        problem = LookupError("enough")

        def told(*_):
            raise problem

        with self.assertRaises(LookupError) as found:
            small(output=self.folder / "c.json", progress=told)
        self.assertIs(found.exception, problem)
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_attacks_end_too(self):
        claim = delcert.Claim(instance="simplex", show="circumradius(s) <= longest_edge(s)")
        with self.assertRaises(KeyboardInterrupt):
            claim.attack(samples=100000, shapes=[(2, 2)], progress=lambda *_: signal.raise_signal(signal.SIGINT))
