"""One connection to the daemon, with a JSON message per line and any number of concurrent calls.

It passes answers to the calls that wait for them, and notifications to their subscribers.  A connection that is lost is not
reopened: all calls and subscribers are then sent Lost.  Everything happens on the event loop that made the connection.
"""

from __future__ import annotations

import asyncio
import itertools
import json
import ssl
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from .address import Address
from ..messages.errors import ConnectionLost, HandshakeFailed, UnexpectedAnswer, call_error
from ..messages.results import Progress
from ..messages.conversion import read

# asyncio requires a limit for the length of a line, and a whole marker is one line.
_LONGEST_LINE = 1 << 28


@dataclass(frozen=True)
class Answer:
    result: Any = None
    error: dict[str, Any] | None = None


@dataclass(frozen=True)
class Notification:
    """A notification about a marker."""

    method: str
    params: dict[str, Any]


@dataclass(frozen=True)
class Lost:
    reason: str


Event = Answer | Progress | Notification | Lost
Deliver = Callable[[Event], None]


class Connection:
    def __init__(self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        self._reader, self._writer = reader, writer
        self._ids = itertools.count(1)
        self._calls: dict[int, tuple[Deliver, int]] = {}  # the receiver of the answer, and the length of the request
        self._subscribers: dict[str, list[Deliver]] = {}  # by marker id
        self.lost: Lost | None = None
        self.instance: str | None = None  # of the daemon; see Home
        self._reading = asyncio.create_task(self._read())

    @staticmethod
    async def open(address: Address, token: str | None, context: ssl.SSLContext | None) -> Connection:
        """Raises ConnectionLost, HandshakeFailed, Unauthorised when the token is refused, and Busy while the daemon loads."""
        try:
            if address.path is not None:
                ends = await asyncio.open_unix_connection(address.path, limit=_LONGEST_LINE)
            else:
                tls = (context or ssl.create_default_context()) if address.tls else None
                ends = await asyncio.open_connection(address.host, address.port, limit=_LONGEST_LINE, ssl=tls)
        except OSError as error:
            # A daemon that is full or shutting down may end the connection during the handshake: this can be retried.
            final = isinstance(error, ssl.SSLError) and not isinstance(error, ssl.SSLEOFError)
            where = address.path or f"{address.host}:{address.port}"
            raise (HandshakeFailed if final else ConnectionLost)(f"cannot reach {where}: {error}") from error
        connection = Connection(*ends)
        try:
            if token is not None and address.path is None:
                await connection._first("auth", {"token": token})
            connection.instance = (await connection._first("engine.info", {})).get("instance")
        except BaseException:
            await connection.close()
            raise
        return connection

    def call(self, method: str, params: dict[str, Any], deliver: Deliver, *, progress: bool = False) -> int:
        """Sends a call.  `deliver` receives its answer and, with `progress`, its rounds.  The id returned is for cancel."""
        number = next(self._ids)
        if progress:
            params = params | {"progressToken": number}
        line = json.dumps({"jsonrpc": "2.0", "id": number, "method": method, "params": params}, allow_nan=False)
        if self.lost:
            deliver(self.lost)
            return number
        self._calls[number] = (deliver, len(line))
        self._writer.write(line.encode() + b"\n")
        return number

    def cancel(self, number: int) -> None:
        """Cancels a call whose answer is no longer needed; has no effect if it has been answered."""
        if self._calls.pop(number, None) is None or self.lost:
            return
        stop = {"jsonrpc": "2.0", "method": "$/cancelRequest", "params": {"id": number}}
        self._writer.write(json.dumps(stop).encode() + b"\n")

    def subscribe(self, marker_id: str, deliver: Deliver) -> None:
        """From now on, notifications about a marker are passed to `deliver`."""
        self._subscribers.setdefault(marker_id, []).append(deliver)

    def unsubscribe(self, marker_id: str, deliver: Deliver) -> bool:
        """Returns whether the marker has no subscribers left."""
        subscribers = self._subscribers.get(marker_id, [])
        if deliver in subscribers:
            subscribers.remove(deliver)
        return not subscribers

    async def drain(self) -> None:
        """Waits until the requests have been written.  If the connection is lost, `deliver` of each call receives that."""
        try:
            await self._writer.drain()
        except OSError:
            pass

    async def close(self) -> None:
        self._reading.cancel()
        self._end("closed")
        try:
            await self._writer.wait_closed()
        except (OSError, ssl.SSLError):
            pass

    async def _first(self, method: str, params: dict[str, Any]) -> dict[str, Any]:
        """The result of a call while nobody else uses the connection."""
        answer: asyncio.Queue[Event] = asyncio.Queue()
        self.call(method, params, answer.put_nowait)
        match await answer.get():
            case Answer(error=dict(error)):
                raise call_error(error)
            case Answer(dict(result)):
                return result
            case Lost(reason):
                raise ConnectionLost(reason)
        raise UnexpectedAnswer(f"the answer to {method} is not an object")

    async def _read(self) -> None:
        reason = "the daemon closed the connection"
        try:
            while line := await self._reader.readline():
                self._route(json.loads(line))
        except (OSError, ValueError, KeyError, TypeError, AttributeError, UnexpectedAnswer) as error:
            reason = f"the connection failed: {error!r}"
        self._end(reason)

    def _route(self, message: dict[str, Any]) -> None:
        method, params = message.get("method"), message.get("params", {})
        if method is None:
            if call := self._calls.pop(self._longest() if message["id"] is None else message["id"], None):
                call[0](Answer(message.get("result"), message.get("error")))
        elif method == "$/progress":
            if call := self._calls.get(params["token"]):
                call[0](read(Progress, params))
        else:
            for deliver in list(self._subscribers.get(params.get("markerId"), [])):
                deliver(Notification(method, params))

    def _longest(self) -> int:
        """The longest call in progress, or 0.  An answer without an id refuses a call that was too long to be read."""
        return max(self._calls, key=lambda number: self._calls[number][1], default=0)

    def _end(self, reason: str) -> None:
        if self.lost:
            return
        self.lost = Lost(reason)
        self._writer.close()
        waiting = [*(deliver for deliver, _ in self._calls.values()), *itertools.chain.from_iterable(self._subscribers.values())]
        self._calls.clear()
        self._subscribers.clear()
        for deliver in waiting:
            deliver(self.lost)
