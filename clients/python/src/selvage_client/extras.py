"""Packages that are only needed for some methods, and the error that says how to install one."""

from __future__ import annotations

import importlib
from typing import Any

from .messages.errors import MissingExtra


def imported(module: str, what: str, extra: str) -> Any:
    """The module.  Raises MissingExtra: `what` needs it, and `pip install 'selvage-client[EXTRA]'` brings it."""
    try:
        return importlib.import_module(module)
    except ImportError as error:
        raise MissingExtra(what, extra, module) from error
