"""Optional packages, which only some methods need, and the error that says how to install them."""

from __future__ import annotations

import importlib
from typing import Any

from .messages.errors import MissingExtra


def imported(module: str, what: str, extra: str) -> Any:
    """Imports and returns the module.  Raises MissingExtra: `what` needs it; `extra` is the extra that installs it."""
    try:
        return importlib.import_module(module)
    except ImportError as error:
        raise MissingExtra(what, extra, module) from error
