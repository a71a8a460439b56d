"""Watching a marker: every new revision is reported, whichever client made it."""

from __future__ import annotations

import asyncio
from types import TracebackType

from .wire.connection import Event, Lost, Notification
from .wire.home import Home
from .messages.errors import CallError, ConnectionLost
from .wire.link import AnyConnection, Link
from .messages.results import Changed, Missed, Watching
from .messages.conversion import named, read


class AsyncWatch:
    """async with marker.watch() as changes: async for change in changes: ...

    The iteration ends when the marker is closed.  After a lost connection the client reconnects, and yields a Missed if
    the marker has changed in the meantime.  If it cannot reconnect within its `patience`, ConnectionLost is raised, and
    UnknownMarker if the daemon was started again and has lost the marker.
    """

    def __init__(self, link: Link, marker_id: str, home: Home) -> None:
        self._link, self._marker_id, self._home = link, marker_id, home
        self._events: asyncio.Queue[Event] = asyncio.Queue()
        self._deliver = self._events.put_nowait  # kept, because each access makes a new bound method
        self._connection: AnyConnection | None = None
        self.revision = 0  # the latest one known

    async def __aenter__(self) -> AsyncWatch:
        self.revision = await self._link.with_retries(self._begin)
        return self

    async def __aexit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        connection = self._connection
        if connection is None or not connection.unsubscribe(self._marker_id, self._deliver) or connection.lost:
            return
        try:
            await self._link.once(connection, "marker.unwatch", named(marker_id=self._marker_id))
        except (CallError, ConnectionLost):
            pass  # the marker was closed, or the watch ended with the connection

    def __aiter__(self) -> AsyncWatch:
        return self

    async def __anext__(self) -> Changed | Missed:
        while True:
            match await self._events.get():
                case Notification("marker.closed"):
                    raise StopAsyncIteration
                case Notification("marker.changed", params) if params["revision"] > self.revision:
                    self.revision = params["revision"]
                    return read(Changed, params)
                case Lost():
                    revision = await self._link.with_retries(self._begin)
                    if revision > self.revision:
                        self.revision = revision
                        return Missed(self._marker_id, revision)

    async def _begin(self) -> int:
        """Subscribes on the current connection before the daemon is asked to watch, so that no change is missed."""
        connection = await self._link.connection()
        self._home.check(connection)
        connection.subscribe(self._marker_id, self._deliver)
        try:
            answer = await self._link.once(connection, "marker.watch", named(marker_id=self._marker_id))
        except BaseException:
            connection.unsubscribe(self._marker_id, self._deliver)
            raise
        self._connection = connection
        return read(Watching, answer).revision
