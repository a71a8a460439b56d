"""Where the id of a marker has its meaning.

A daemon without a store gives the ids of markers to other markers when it is started again.  So a handle remembers the
instance of the daemon in which its marker is open, and never uses its id in another one.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

from ..messages.errors import UnknownMarker


class Connected(Protocol):
    """A connection; `instance` is the daemon's, or None if the daemon does not tell it."""

    instance: str | None


@dataclass
class Home:
    instance: str | None = None  # None: not known yet

    def move_to(self, connection: Connected) -> None:
        self.instance = connection.instance

    def check(self, connection: Connected) -> None:
        """Raises UnknownMarker if the connection leads to another instance."""
        if self.instance is None:
            self.instance = connection.instance
        elif connection.instance is not None and connection.instance != self.instance:
            raise UnknownMarker("the daemon was started again and no longer has this marker; the id may name another one now",
                                {"field": "/markerId"})
