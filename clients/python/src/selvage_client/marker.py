"""A marker that is open in the daemon."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from types import TracebackType
from typing import Any

from .drag import AsyncDrag
from .messages.choices import DragMode, Format
from .messages.errors import UnknownMarker
from .wire.home import Home
from .wire.link import Link
from .motions import AsyncMotions
from .messages.ops import Op
from .outlines import Outline, Outlines
from .messages.results import Checked, Closed, Edited, Got, Hold, NestedSheets, Opened, Regions
from .watch import AsyncWatch
from .messages.conversion import named, read


class AsyncMarker(AsyncMotions):
    """A handle of a marker in the daemon.  As an asynchronous context manager it closes the marker at the end.

    If the daemon is started again without a store, its markers are lost: every call then raises UnknownMarker, even if another
    marker has the same id.
    """

    def __init__(self, link: Link, marker_id: str, opened: Opened | None = None, home: Home | None = None) -> None:
        self._link, self._home = link, home or Home()
        self.id = marker_id
        self.opened = opened  # the result of opening the marker; None when it was open already
        self.revision = opened.revision if opened else None  # the latest that a call through this handle returned

    def __repr__(self) -> str:
        return f"<{type(self).__name__} {self.id} at revision {self.revision or 'unknown'}, {self._link.address}>"

    async def get(self, *, format: Format | None = None, since: int | None = None) -> Got:
        """The document in `format`.  With `since` it may be only the placements that changed after that revision."""
        return read(Got, await self._call("marker.get", format=format, since=since))

    async def outlines(self) -> Outlines:
        """The outlines of all pieces where they lie."""
        document = (await self.get(format="outlines")).marker  # field names in this format are in snake_case
        pieces = tuple(read(Outline, piece) for piece in document["pieces"])
        return Outlines(document["strip_height"], document["strip_length"], pieces)

    async def svg(self) -> str:
        """A drawing of the marker as an SVG document."""
        return str((await self.get(format="svg")).marker)

    async def check(self) -> Checked:
        """Says whether the marker is valid, and lists the overlaps and the pieces that protrude from the strip."""
        return read(Checked, await self._call("marker.check"))

    async def hold(self) -> Hold:
        """Finds the contacts and rules that determine the marker's length, and what each of them costs."""
        return read(Hold, await self._call("marker.hold"))

    async def regions(self, *, least_area: float | None = None, clearance: float | None = None) -> Regions:
        """The regions of the cloth that no piece covers."""
        return read(Regions, await self._call("marker.regions", least_area=least_area, clearance=clearance))

    async def nest_sheets(
        self,
        sheets: Iterable[Mapping[str, Any]] | None = None,
        *,
        accuracy: str | None = None,
        moves: int | None = None,
        seconds: float | None = None,
        seed: int | None = None,
        values: Mapping[str, float] | None = None,
        deadline_ms: float | None = None,
    ) -> NestedSheets:
        """Nests all pieces on as few of the sheets as the search manages to.  The marker itself does not change.

        A sheet is {"width": W, "length": L, "count": N} or {"outline": [[x, y], ...], "holes": [...], "zones": [...]}.
        Without sheets, the bins of the opened instance are used.
        """
        answer = await self._call(
            "marker.nestSheets",
            sheets=None if sheets is None else [dict(sheet) for sheet in sheets],
            accuracy=accuracy,
            moves=moves,
            seconds=seconds,
            seed=seed,
            values=None if values is None else [{"piece": piece, "value": value} for piece, value in values.items()],
            deadline_ms=deadline_ms,
        )
        return read(NestedSheets, answer)

    async def plan_cut(
        self,
        quantities: Iterable[Mapping[str, Any]],
        *,
        limits: Mapping[str, Any] | None = None,
        deadline_ms: float | None = None,
    ) -> dict[str, Any]:
        """Plans which markers to make for an order of this style, and how many plies of which colour to cut with each.

        A quantity is {"colour": C, "size": S, "garments": N}; `limits` are the other parameters of plan.cut.
        """
        plan: dict[str, Any] = await self._call(
            "plan.cut", quantities=[dict(each) for each in quantities], deadline_ms=deadline_ms, **(limits or {})
        )
        return plan

    async def apply(self, ops: Iterable[Op], *, base_rev: int | None = None, op_id: str | None = None) -> Edited:
        """Applies all of the operations, or none if one of them fails.  selvage_client.ops makes operations."""
        return await self._edit("marker.apply", ops=list(ops), base_rev=base_rev, op_id=op_id)

    async def undo(self, *, base_rev: int | None = None, op_id: str | None = None) -> Edited:
        return await self._edit("marker.undo", base_rev=base_rev, op_id=op_id)

    async def redo(self, *, base_rev: int | None = None, op_id: str | None = None) -> Edited:
        return await self._edit("marker.redo", base_rev=base_rev, op_id=op_id)

    def watch(self) -> AsyncWatch:
        """Watches the marker for changes by any client: a context manager and an iterator."""
        return AsyncWatch(self._link, self.id, self._home)

    def drag(self, piece: str, *, mode: DragMode | None = None, base_rev: int | None = None) -> AsyncDrag:
        """A drag session: a context manager."""
        return AsyncDrag(self._link, self.id, self._home, piece, mode, base_rev, self._edited)

    async def close(self, *, op_id: str | None = None) -> Closed:
        return read(Closed, await self._call("marker.close", op_id=op_id))

    async def __aenter__(self) -> AsyncMarker:
        return self

    async def __aexit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        try:
            await self.close()
        except UnknownMarker:
            pass  # closed already

    async def _call(self, method: str, **params: Any) -> Any:
        return await self._link.call(method, named(marker_id=self.id, **params), None, self._home)

    async def _edit(self, method: str, **params: Any) -> Edited:
        edited = read(Edited, await self._call(method, **params))
        self._edited(edited)
        return edited

    def _edited(self, edited: Edited) -> None:
        self.revision = edited.revision
