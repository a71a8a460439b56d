"""The blocking client: the methods of the asynchronous one, which may be called from any thread.

Watching, dragging and progress work in the same way; `progress` is called on the thread that made the call.
"""

from __future__ import annotations

import ssl
from types import TracebackType
from typing import Any

from .wire.address import DEFAULT
from .async_client import AsyncClient
from .motions.blocking import BlockingMotions
from .drag import AsyncDrag
from .library import Library
from .marker import AsyncMarker
from .wire.portal import Blocking, Portal, blocking
from .messages.choices import DragMode
from .messages.errors import CallError, ConnectionLost
from .messages.opening import Document
from .messages.results import Changed, DragStarted, Edited, Missed, Opened
from .watch import AsyncWatch

Error = BaseException


class Watch(Blocking):
    """with marker.watch() as changes: for change in changes: ...   See AsyncWatch."""

    def __init__(self, portal: Portal, twin: AsyncWatch) -> None:
        self._portal, self._twin = portal, twin

    @property
    def revision(self) -> int:
        return int(self._twin.revision)

    def __enter__(self) -> Watch:
        self._portal.run(self._twin.__aenter__())
        return self

    def __exit__(self, kind: type[Error] | None, error: Error | None, trace: TracebackType | None) -> None:
        self._portal.run(self._twin.__aexit__(kind, error, trace))

    def __iter__(self) -> Watch:
        return self

    def __next__(self) -> Changed | Missed:
        try:
            return self._next()
        except StopAsyncIteration:
            raise StopIteration from None

    _next = blocking(AsyncWatch.__anext__)


class Drag(Blocking):
    """with marker.drag("sleeve") as drag: drag.move((x, y))   See AsyncDrag."""

    def __init__(self, portal: Portal, twin: AsyncDrag) -> None:
        self._portal, self._twin = portal, twin

    @property
    def started(self) -> DragStarted | None:
        started: DragStarted | None = self._twin.started
        return started

    @property
    def ended(self) -> Edited | None:
        ended: Edited | None = self._twin.ended
        return ended

    begin = blocking(AsyncDrag.begin)
    move = blocking(AsyncDrag.move)
    end = blocking(AsyncDrag.end)

    def __enter__(self) -> Drag:
        self.begin()
        return self

    def __exit__(self, kind: type[Error] | None, error: Error | None, trace: TracebackType | None) -> None:
        self._portal.run(self._twin.__aexit__(kind, error, trace))


class Marker(BlockingMotions):
    """A handle of a marker in the daemon.  As a context manager it closes the marker at the end.  See AsyncMarker."""

    def __init__(self, portal: Portal, twin: AsyncMarker) -> None:
        self._portal, self._twin = portal, twin

    @property
    def id(self) -> str:
        return str(self._twin.id)

    @property
    def opened(self) -> Opened | None:
        opened: Opened | None = self._twin.opened
        return opened

    @property
    def revision(self) -> int | None:
        revision: int | None = self._twin.revision
        return revision

    def __repr__(self) -> str:
        return repr(self._twin).replace("<Async", "<", 1)

    def _repr_svg_(self) -> str | None:
        """The drawing that a notebook shows; None when the marker is closed or the daemon cannot be reached."""
        try:
            return self.svg()
        except (CallError, ConnectionLost):
            return None

    get = blocking(AsyncMarker.get)
    outlines = blocking(AsyncMarker.outlines)
    svg = blocking(AsyncMarker.svg)
    check = blocking(AsyncMarker.check)
    hold = blocking(AsyncMarker.hold)
    regions = blocking(AsyncMarker.regions)
    nest_sheets = blocking(AsyncMarker.nest_sheets)
    plan_cut = blocking(AsyncMarker.plan_cut)
    apply = blocking(AsyncMarker.apply)
    undo = blocking(AsyncMarker.undo)
    redo = blocking(AsyncMarker.redo)
    close = blocking(AsyncMarker.close)

    def watch(self) -> Watch:
        """Watches the marker for changes by any client: a context manager and an iterator."""
        return Watch(self._portal, self._twin.watch())

    def drag(self, piece: str, *, mode: DragMode | None = None, base_rev: int | None = None) -> Drag:
        """A drag session: a context manager."""
        return Drag(self._portal, self._twin.drag(piece, mode=mode, base_rev=base_rev))

    def __enter__(self) -> Marker:
        return self

    def __exit__(self, kind: type[Error] | None, error: Error | None, trace: TracebackType | None) -> None:
        self._portal.run(self._twin.__aexit__(kind, error, trace))


class Client(Blocking):
    """with Client() as client: marker = client.open("marker.json")

    The parameters are those of AsyncClient.
    """

    def __init__(
        self,
        address: str = DEFAULT,
        *,
        token: str | None = None,
        tls: ssl.SSLContext | None = None,
        patience: float = 30.0,
    ) -> None:
        self._twin = AsyncClient(address, token=token, tls=tls, patience=patience)
        self._portal = Portal()
        self.library = Library(self._portal, self._twin.library)

    def __repr__(self) -> str:
        return repr(self._twin).replace("<Async", "<", 1)

    call = blocking(AsyncClient.call)
    info = blocking(AsyncClient.info)
    list = blocking(AsyncClient.list)

    def open(
        self,
        marker: Document,
        *,
        spacing: float | None = None,
        overlap: float | None = None,
        op_id: str | None = None,
        **options: Any,
    ) -> Marker:
        """Opens a document, the text of a file, or the file at this path.  See AsyncClient.open."""
        opening = self._twin.open(marker, spacing=spacing, overlap=overlap, op_id=op_id, **options)
        return Marker(self._portal, self._portal.run(opening))

    def marker(self, marker_id: str) -> Marker:
        """A marker that is open already.  This sends nothing; the first call on the marker fails if it is not open."""
        return Marker(self._portal, self._twin.marker(marker_id))

    def close(self) -> None:
        """Closes the client.  Calls in progress on other threads raise ConnectionLost."""
        if not self._portal.closed:
            self._portal.run(self._twin.close())
            self._portal.close()

    def __enter__(self) -> Client:
        return self

    def __exit__(self, kind: type[Error] | None, error: Error | None, trace: TracebackType | None) -> None:
        self.close()
