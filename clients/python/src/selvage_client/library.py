"""The daemon's library of stored markers, whose arrangements `marker.remake` reuses."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from .messages.conversion import named, read
from .wire.link import Link
from .wire.portal import Blocking, Portal, blocking


@dataclass(frozen=True)
class Stored:
    """A stored marker, without its pieces."""

    id: str
    name: str
    style: str
    unit: str
    pieces: int
    width: float
    spacing: float
    length: float
    utilisation: float


@dataclass(frozen=True)
class StoredNow(Stored):
    """A marker that was just stored.  `added` is false when the library contained the same marker already."""

    added: bool


@dataclass(frozen=True)
class StoredMarker(Stored):
    """A stored marker with its pieces.  `marker` is a native document."""

    marker: dict[str, Any]


@dataclass(frozen=True)
class StoredNear(Stored):
    """A search result.  `distance` measures how much the pieces differ; it is 0 when they are equal."""

    distance: float


@dataclass(frozen=True)
class StoredList:
    """A part of the library, which holds `count` markers in all."""

    count: int
    markers: tuple[Stored, ...]


class AsyncLibrary:
    """client.library: `await client.library.add(marker.id, style="jeans")`"""

    def __init__(self, link: Link) -> None:
        self._link = link

    async def add(self, marker_id: str, *, style: str | None = None) -> StoredNow:
        """Stores the current revision of an open marker, which must be valid and have all of its pieces placed."""
        return read(StoredNow, await self._link.call("library.add", named(marker_id=marker_id, style=style), None))

    async def get(self, id: str) -> StoredMarker:
        return read(StoredMarker, await self._link.call("library.get", {"id": id}, None))

    async def list(self, *, offset: int | None = None, most: int | None = None) -> StoredList:
        """Lists stored markers in the order in which they were added."""
        return read(StoredList, await self._link.call("library.list", named(offset=offset, most=most), None))

    async def remove(self, id: str) -> None:
        await self._link.call("library.remove", {"id": id}, None)

    async def search(self, marker_id: str, *, most: int | None = None) -> tuple[StoredNear, ...]:
        """Finds the stored markers that are most similar to an open marker, the most similar first."""
        found = await self._link.call("library.search", named(marker_id=marker_id, most=most), None)
        return tuple(read(StoredNear, each) for each in found["near"])


class Library(Blocking):
    """client.library of the blocking client.  See AsyncLibrary."""

    def __init__(self, portal: Portal, twin: AsyncLibrary) -> None:
        self._portal, self._twin = portal, twin

    add = blocking(AsyncLibrary.add)
    get = blocking(AsyncLibrary.get)
    list = blocking(AsyncLibrary.list)
    remove = blocking(AsyncLibrary.remove)
    search = blocking(AsyncLibrary.search)
