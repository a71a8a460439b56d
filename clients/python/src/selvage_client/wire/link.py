"""The link to the daemon, which reconnects and retries calls.

A call whose connection is lost is sent again on a new one if it cannot be applied twice: a read, a dry run, or a change with
an `opId`, for which the daemon repeats its first answer.  Calls that a busy or draining daemon refused are retried, too.
Watching and dragging belong to one connection, so their calls are made with `once`, which never retries.
"""

from __future__ import annotations

import asyncio
import ssl
import uuid
from collections.abc import Awaitable, Callable
from typing import Any, TypeVar

from .address import parse_address
from .connection import Answer, Connection, Event, Lost
from .home import Home
from .in_process import InProcess
from .progress import OnProgress
from ..messages.choices import MOTIONS
from ..messages.errors import Busy, ConnectionLost, Draining, call_error
from ..messages.results import Progress

T = TypeVar("T")

_FIRST_PAUSE, _LONGEST_PAUSE = 0.05, 1.0  # seconds between two attempts
_READS = {"engine.info", "marker.list", "marker.get", "marker.check", "marker.hold", "marker.regions", "rpc.discover",
          "library.add", "library.get", "library.list", "library.search"}
AnyConnection = Connection | InProcess
_CHANGES = {"marker.open", "marker.close", "marker.apply", "marker.undo", "marker.redo", "drag.end"}


def changes(method: str, params: dict[str, Any]) -> bool:
    """Whether the call changes the state of the daemon, so that it needs an opId."""
    return (method in _CHANGES or method in MOTIONS) and params.get("commit") is not False


def may_repeat(method: str, params: dict[str, Any]) -> bool:
    """Whether the call may be sent again when its answer was lost."""
    dry = method in MOTIONS and params.get("commit") is False
    return method in _READS or dry or "opId" in params


class Link:
    def __init__(self, address: str, token: str | None, context: ssl.SSLContext | None, patience: float) -> None:
        """`patience`: for how many seconds a call is retried."""
        self.address = address
        self._address = parse_address(address)
        self._token, self._context, self._patience = token, context, patience
        self._connection: AnyConnection | None = None
        self._connecting = asyncio.Lock()
        self._closed = False

    async def connection(self) -> AnyConnection:
        """The current connection, or a new one.  Raises ConnectionLost, or MissingExtra for `engine:`."""
        async with self._connecting:
            if self._closed:
                raise ConnectionLost("the client is closed")
            if self._connection is None or self._connection.lost:
                self._connection = await self._open()
            return self._connection

    def home(self) -> Home:
        """Of a marker whose id is known now."""
        return Home(self._connection.instance if self._connection else None)

    async def _open(self) -> AnyConnection:
        if self._address.in_process:
            return InProcess()
        return await Connection.open(self._address, self._token, self._context)

    async def call(
        self, method: str, params: dict[str, Any], progress: OnProgress | None = None, home: Home | None = None
    ) -> Any:
        """Makes a call and returns its result.  Adds an `opId` to changes.  Raises CallError and ConnectionLost.

        `home`: of the marker that the call is about, or that it opens.
        """
        marker_home = home or Home()
        if changes(method, params) and "opId" not in params:
            params = params | {"opId": uuid.uuid4().hex}

        async def attempt() -> Any:
            connection = await self.connection()
            if method == "marker.open":
                marker_home.move_to(connection)
            elif "markerId" in params:
                marker_home.check(connection)
            return await self.once(connection, method, params, progress)

        return await (self.with_retries(attempt) if may_repeat(method, params) else attempt())

    async def once(
        self, connection: AnyConnection, method: str, params: dict[str, Any], progress: OnProgress | None = None
    ) -> Any:
        """Makes a call on this connection and never retries it.  Cancelling the caller's task cancels the call."""
        events: asyncio.Queue[Event] = asyncio.Queue()
        number = connection.call(method, params, events.put_nowait, progress=progress is not None)
        try:
            await connection.drain()
            while True:
                match await events.get():
                    case Progress() as step if progress:
                        progress(step)
                    case Answer(error=dict(error)):
                        raise call_error(error)
                    case Answer(result):
                        return result
                    case Lost(reason):
                        raise ConnectionLost(reason)
        finally:
            connection.cancel(number)

    async def with_retries(self, attempt: Callable[[], Awaitable[T]]) -> T:
        """Repeats the attempt until it is answered or `patience` seconds have passed."""
        clock = asyncio.get_running_loop().time
        end, pause = clock() + self._patience, _FIRST_PAUSE
        while True:
            try:
                return await attempt()
            except (ConnectionLost, Busy, Draining) as error:
                wait = max(pause, error.retry_after) if isinstance(error, Busy) else pause
                if self._closed or clock() + wait > end:
                    raise
            await asyncio.sleep(wait)
            pause = min(2 * pause, _LONGEST_PAUSE)

    async def close(self) -> None:
        self._closed = True
        if self._connection:
            await self._connection.close()
