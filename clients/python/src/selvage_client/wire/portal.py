"""Blocking calls of asynchronous methods, which run in an event loop on a thread of its own."""

from __future__ import annotations

import asyncio
import concurrent.futures
import functools
import queue
import threading
from collections.abc import Callable, Coroutine
from typing import Any, Concatenate, ParamSpec, TypeVar

from ..messages.errors import ConnectionLost
from ..messages.results import Progress
from .progress import progress_callback

P = ParamSpec("P")
T = TypeVar("T")


class Portal:
    def __init__(self) -> None:
        self._loop = asyncio.new_event_loop()
        self._ending = threading.Lock()  # closing cancels all calls begun before it; none is begun afterwards
        self.closed = False
        self._thread = threading.Thread(target=self._loop.run_forever, name="selvage", daemon=True)
        self._thread.start()

    def run(
        self,
        coroutine: Coroutine[Any, Any, T],
        steps: queue.SimpleQueue[Progress | None] | None = None,
        progress: Callable[[Progress], None] | None = None,
    ) -> T:
        """Waits for the result, and calls `progress`, on this thread, with each value that is put into `steps`.

        Anything that ends the wait early, such as Ctrl-C or an exception in `progress`, cancels the call.
        """
        events = steps or queue.SimpleQueue[Progress | None]()
        with self._ending:
            if self.closed:
                coroutine.close()
                raise ConnectionLost("the client is closed")
            future = asyncio.run_coroutine_threadsafe(coroutine, self._loop)
        future.add_done_callback(lambda _: events.put(None))
        try:
            while (event := events.get()) is not None:
                if progress:
                    progress(event)
            return future.result()
        except concurrent.futures.CancelledError:
            raise ConnectionLost("the client was closed") from None
        except BaseException:
            future.cancel()
            raise

    def close(self) -> None:
        """Stops the event loop; calls in progress fail."""
        with self._ending:
            if self.closed:
                return
            self.closed = True
        asyncio.run_coroutine_threadsafe(self._cancel_others(), self._loop).result()
        self._loop.call_soon_threadsafe(self._loop.stop)
        self._thread.join()
        self._loop.close()

    @staticmethod
    async def _cancel_others() -> None:
        others = asyncio.all_tasks() - {asyncio.current_task()}
        for task in others:
            task.cancel()
        await asyncio.gather(*others, return_exceptions=True)


class Blocking:
    """The base of classes with blocking methods: the object's asynchronous twin, and the portal to its loop."""

    _portal: Portal
    _twin: Any


def blocking(method: Callable[Concatenate[Any, P], Coroutine[Any, Any, T]]) -> Callable[Concatenate[Any, P], T]:
    """The twin's method as one that blocks, with the same parameters and result."""

    @functools.wraps(method)
    def wait(self: Blocking, /, *args: P.args, **kwargs: P.kwargs) -> T:
        steps: queue.SimpleQueue[Progress | None] = queue.SimpleQueue()
        wanted: Any = kwargs.get("progress")
        with progress_callback(wanted) as progress:
            if "progress" in kwargs:
                kwargs["progress"] = steps.put if progress else None
            return self._portal.run(method(self._twin, *args, **kwargs), steps, progress)

    return wait
