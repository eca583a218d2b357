"""Modules that are needed for one thing each."""

import importlib


def module(name, package):
    """The module, or an ImportError that says what to install."""
    try:
        return importlib.import_module(name)
    except ImportError as error:
        top = name.split(".")[0]
        raise ImportError(f"the Python module {top} is needed for this; Debian has it in {package} ({error})", name=top) from None
