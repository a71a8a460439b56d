"""A marker watched: every new revision, whoever made it."""

from __future__ import annotations

import asyncio
from types import TracebackType

from .wire.connection import Event, Lost, Told
from .messages.errors import CallError, ConnectionLost
from .wire.link import AnyConnection, Link
from .messages.results import Changed, Missed, Watching
from .messages.words import named, read


class AsyncWatch:
    """async with marker.watch() as changes: async for change in changes: ...

    Ends when the marker is closed.  A lost connection is made again, and when the marker moved on meanwhile a Missed
    says so; ConnectionLost when that takes longer than the client's patience.
    """

    def __init__(self, link: Link, marker_id: str) -> None:
        self._link, self._marker_id = link, marker_id
        self._events: asyncio.Queue[Event] = asyncio.Queue()
        self._deliver = self._events.put_nowait  # one object, so that it can be found again
        self._connection: AnyConnection | None = None
        self.revision = 0  # the latest one known

    async def __aenter__(self) -> AsyncWatch:
        self.revision = await self._link.patiently(self._begin)
        return self

    async def __aexit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        connection = self._connection
        if connection is None or not connection.unlisten(self._marker_id, self._deliver) or connection.lost:
            return
        try:
            await self._link.once(connection, "marker.unwatch", named(marker_id=self._marker_id))
        except (CallError, ConnectionLost):
            pass  # closed meanwhile, or gone with the connection

    def __aiter__(self) -> AsyncWatch:
        return self

    async def __anext__(self) -> Changed | Missed:
        while True:
            match await self._events.get():
                case Told("marker.closed"):
                    raise StopAsyncIteration
                case Told("marker.changed", params) if params["revision"] > self.revision:
                    self.revision = params["revision"]
                    return read(Changed, params)
                case Lost():
                    revision = await self._link.patiently(self._begin)
                    if revision > self.revision:
                        self.revision = revision
                        return Missed(self._marker_id, revision)

    async def _begin(self) -> int:
        """Listens on the present connection, first, and watches on it: nothing falls between the two."""
        connection = await self._link.connection()
        connection.listen(self._marker_id, self._deliver)
        try:
            answer = await self._link.once(connection, "marker.watch", named(marker_id=self._marker_id))
        except BaseException:
            connection.unlisten(self._marker_id, self._deliver)
            raise
        self._connection = connection
        return read(Watching, answer).revision
