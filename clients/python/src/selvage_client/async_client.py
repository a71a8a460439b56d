"""The client for asyncio."""

from __future__ import annotations

import ssl
from collections.abc import Mapping
from types import TracebackType
from typing import Any

from .wire.address import DEFAULT
from .wire.home import Home
from .wire.link import Link
from .wire.progress import ProgressOption, progress_callback
from .library import AsyncLibrary
from .marker import AsyncMarker
from .messages.results import Info, Listed, Opened
from .messages.conversion import named, read
from .messages.opening import Document, source_of


class AsyncClient:
    """async with AsyncClient() as client: marker = await client.open("marker.json")

    `address`: HOST:PORT, tls://HOST:PORT or unix:PATH, or `engine:` for the engine of selvage-engine in this process, without
    a daemon.  The client connects when it makes its first call.  `patience`: for how many seconds a call is retried when the
    connection is lost or the daemon is busy; a change is never applied twice.
    """

    def __init__(
        self,
        address: str = DEFAULT,
        *,
        token: str | None = None,
        tls: ssl.SSLContext | None = None,
        patience: float = 30.0,
    ) -> None:
        self._link = Link(address, token, tls, patience)
        self.library = AsyncLibrary(self._link)

    def __repr__(self) -> str:
        return f"<{type(self).__name__} of {self._link.address}>"

    async def call(self, method: str, params: Mapping[str, Any] | None = None, progress: ProgressOption = None) -> Any:
        """Calls any method with the names of the protocol: for methods that this package does not support yet."""
        with progress_callback(progress) as on_progress:
            return await self._link.call(method, dict(params or {}), on_progress)

    async def info(self) -> Info:
        return read(Info, await self.call("engine.info"))

    async def open(
        self,
        marker: Document,
        *,
        spacing: float | None = None,
        overlap: float | None = None,
        op_id: str | None = None,
        **options: Any,
    ) -> AsyncMarker:
        """Opens a document, the text of a file in any format that can be read, or the file at this path.

        `options` are the other parameters of marker.open in snake_case: how to read the file (unit, width, sizes, fold, nap,
        tolerance, rules, order, plain) and the rules of the cloth (margin_below, repeat_along, shade, open_holes, ...).
        """
        params = named(marker=source_of(marker), spacing=spacing, overlap=overlap, op_id=op_id, **options)
        home = Home()
        opened = read(Opened, await self._link.call("marker.open", params, None, home))
        return AsyncMarker(self._link, opened.marker_id, opened, home)

    def marker(self, marker_id: str) -> AsyncMarker:
        """A marker that is open already.  This sends nothing; the first call on the marker fails if it is not open."""
        return AsyncMarker(self._link, marker_id, None, self._link.home())

    async def list(self) -> tuple[Listed, ...]:
        """Lists the open markers."""
        return tuple(read(Listed, each) for each in (await self.call("marker.list"))["markers"])

    async def close(self) -> None:
        await self._link.close()

    async def __aenter__(self) -> AsyncClient:
        return self

    async def __aexit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        await self.close()
