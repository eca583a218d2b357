"""What can go wrong, with the meaning of the exit statuses of the programs."""

import re


class Error(Exception):
    """Of all of these. `status` is the exit status of the programs that means the same."""

    status = 70


class Refuted(Error):
    """Well-formed, but what was asked for does not hold: exit status 1."""

    status = 1


class Undecided(Error):
    """It could not be decided, by any precision that was tried: exit status 2."""

    status = 2


class MalformedInput(Error, ValueError):
    """A file, or a name, that is not as it should be: exit status 3. The message says where, and what was expected."""

    status = 3


class Usage(Error, ValueError):
    """Arguments that make no sense: exit status 64."""

    status = 64


def made(kind, message):
    """The exception for what the libraries found; options of the command line are keyword arguments here."""
    argument = re.sub(r"--([a-z]+(?:-[a-z]+)*)", lambda option: option[1].replace("-", "_"), message)
    return globals()[kind](argument)
