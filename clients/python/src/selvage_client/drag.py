"""Drag sessions: a piece is picked up, moved any number of times, and put down."""

from __future__ import annotations

from collections.abc import Callable
from types import TracebackType
from typing import Any

from .wire.home import Home
from .wire.link import AnyConnection, Link
from .messages.choices import DragMode
from .messages.results import Dragged, DragStarted, Edited, Point
from .messages.conversion import named, read


class AsyncDrag:
    """async with marker.drag("sleeve") as drag: await drag.move((x, y))

    Leaving the block ends the session and commits the change; an exception in the block ends it and leaves the marker
    unchanged.  `started` and `ended` are the results of starting and of ending the session.  A session is lost with its
    connection: the next move then raises ConnectionLost.
    """

    def __init__(
        self,
        link: Link,
        marker_id: str,
        home: Home,
        piece: str,
        mode: DragMode | None,
        base_rev: int | None,
        edited: Callable[[Edited], None],
    ) -> None:
        """`edited` is called with the result of ending the session."""
        self._link, self._marker_id, self._home, self._edited = link, marker_id, home, edited
        self._begin = named(marker_id=marker_id, piece=piece, mode=mode, base_rev=base_rev)
        self._connection: AnyConnection | None = None
        self.started: DragStarted | None = None
        self.ended: Edited | None = None

    async def begin(self) -> DragStarted:
        self._connection = await self._link.connection()
        self._home.check(self._connection)
        self.started = read(DragStarted, await self._link.once(self._connection, "drag.begin", self._begin))
        return self.started

    async def move(self, to: Point) -> Dragged:
        """Raises Superseded when a later move arrived before the daemon had begun this one."""
        return read(Dragged, await self._call("drag.move", to=to))

    async def end(self, *, commit: bool | None = None, op_id: str | None = None) -> Edited:
        answer = await self._call("drag.end", marker_id=self._marker_id, commit=commit, op_id=op_id)
        self.ended = read(Edited, answer)
        self._edited(self.ended)
        return self.ended

    async def __aenter__(self) -> AsyncDrag:
        await self.begin()
        return self

    async def __aexit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        if self.ended is None and (error is None or (self._connection and not self._connection.lost)):
            await self.end(commit=None if error is None else False)

    async def _call(self, method: str, **params: Any) -> Any:
        if self._connection is None or self.started is None:
            raise RuntimeError("the drag has not begun")
        return await self._link.once(self._connection, method, named(drag_id=self.started.drag_id, **params))
