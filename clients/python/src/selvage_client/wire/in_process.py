"""The address `engine:`, at which the engine of the distribution selvage-engine answers calls in this process.

InProcess replaces a Connection and cannot be lost.  It has markers of its own, which other clients do not see.
"""

from __future__ import annotations

import asyncio
import concurrent.futures
import itertools
import json
import os
from collections.abc import Callable
from typing import Any, Protocol

from .connection import Answer, Deliver, Event, Lost
from ..extras import imported
from ..messages.results import Progress


class Stop(Protocol):
    """Asks a call to end."""

    def request(self) -> None: ...


class InProcess:
    """The engine works on threads of its own; everything else happens on the event loop that made this object."""

    def __init__(self) -> None:
        """Raises MissingExtra when the engine is not installed."""
        engine = imported("selvage_engine", "the address engine:", "engine")
        cores = os.cpu_count() or 1
        self._stop_of_call: Callable[[], Stop] = engine.Stop
        self._engine = engine.Engine(cores)
        self._workers = concurrent.futures.ThreadPoolExecutor(cores, thread_name_prefix="selvage-engine")
        self._loop = asyncio.get_running_loop()
        self._ids = itertools.count(1)
        self._calls: dict[int, tuple[Deliver, Stop]] = {}  # the receiver of the answer, and how to stop the call
        self.lost: Lost | None = None
        self.instance: str | None = None  # it cannot be started again

    def call(self, method: str, params: dict[str, Any], deliver: Deliver, *, progress: bool = False) -> int:
        """Begins a call.  `deliver` receives its answer and, with `progress`, its rounds.  The id returned is for cancel."""
        number = next(self._ids)
        if self.lost:
            deliver(self.lost)
            return number
        stop = self._stop_of_call()
        self._calls[number] = (deliver, stop)
        line = json.dumps({"jsonrpc": "2.0", "id": number, "method": method, "params": params}, allow_nan=False)

        def on_round(round: int, length: float, bound: float | None, nodes: int | None) -> None:
            self._loop.call_soon_threadsafe(self._deliver, number, Progress(round, length, bound, nodes))

        def work() -> None:
            try:
                text = self._engine.answer(line, stop, on_round if progress else None)
                event = _answer(json.loads(text))
            except Exception as error:  # the caller must not wait for ever
                event = Lost(f"the engine failed: {error!r}")
            self._loop.call_soon_threadsafe(self._end, number, event)

        self._workers.submit(work)
        return number

    def cancel(self, number: int) -> None:
        """Cancels a call whose answer is no longer needed; has no effect if it has been answered."""
        if found := self._calls.pop(number, None):
            found[1].request()

    def subscribe(self, marker_id: str, deliver: Deliver) -> None:
        """Does nothing: the engine refuses to watch markers, so there are no notifications."""

    def unsubscribe(self, marker_id: str, deliver: Deliver) -> bool:
        return True

    async def drain(self) -> None:
        """Does nothing: there is no buffer to be written."""

    async def close(self) -> None:
        self.lost = Lost("closed")
        for deliver, stop in self._calls.values():
            stop.request()
            deliver(self.lost)
        self._calls.clear()
        await asyncio.to_thread(self._workers.shutdown)

    def _deliver(self, number: int, event: Event) -> None:
        if found := self._calls.get(number):
            found[0](event)

    def _end(self, number: int, event: Event) -> None:
        self._deliver(number, event)
        self._calls.pop(number, None)


def _answer(response: dict[str, Any]) -> Event:
    return Answer(response.get("result"), response.get("error"))
