"""The motions of a marker, one method each.  Parameters, units and results: protocol/README.md, Motions.

Every motion takes `commit` (False: a dry run), `base_rev`, `op_id`, `deadline_ms`, `timing` and `progress`, which is called
with every round; an exception in it cancels the motion.  None leaves a choice to the daemon.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, TypeVar

from .link import Link, OnProgress
from .motion_results import (
    Bumped,
    Floated,
    GapOpened,
    Moved,
    MovedInRounds,
    Placed,
    Pushed,
    Relaxed,
    Separated,
    Tilted,
)
from .results import Point
from .words import named, read

M = TypeVar("M", bound=Moved)


class AsyncMotions:
    id: str
    revision: int | None
    _link: Link

    async def _move(self, kind: type[M], motion: str, progress: OnProgress | None, **params: Any) -> M:
        answer = await self._link.call(motion, named(marker_id=self.id, **params), progress)
        moved = read(kind, answer)
        self.revision = moved.revision
        return moved

    async def compact(
        self, *, accuracy: str | None = None, rounds: int | None = None,
        simplification: float | None = None, commit: bool | None = None,
        base_rev: int | None = None, op_id: str | None = None, deadline_ms: int | None = None,
        timing: bool | None = None, progress: OnProgress | None = None,
    ) -> MovedInRounds:
        """The marker made shorter, all pieces moving at once [Li94 4.1]."""
        return await self._move(
            MovedInRounds, "motion.compact", progress, accuracy=accuracy, rounds=rounds,
            simplification=simplification, commit=commit,
            base_rev=base_rev, op_id=op_id, deadline_ms=deadline_ms, timing=timing,
        )

    async def push(
        self, forces: Mapping[str, Point], *, accuracy: str | None = None, rounds: int | None = None,
        simplification: float | None = None,
        commit: bool | None = None, base_rev: int | None = None, op_id: str | None = None,
        deadline_ms: int | None = None, timing: bool | None = None, progress: OnProgress | None = None,
    ) -> Pushed:
        """Pieces follow forces, by piece, the length held [Li94 4.2.2]."""
        return await self._move(
            Pushed, "motion.push", progress, forces=[{"piece": piece, "force": force} for piece, force in
            forces.items()], accuracy=accuracy, rounds=rounds,
            simplification=simplification, commit=commit, base_rev=base_rev, op_id=op_id,
            deadline_ms=deadline_ms, timing=timing,
        )

    async def gravity(
        self, force: Point, *, accuracy: str | None = None, rounds: int | None = None,
        simplification: float | None = None,
        commit: bool | None = None, base_rev: int | None = None, op_id: str | None = None,
        deadline_ms: int | None = None, timing: bool | None = None, progress: OnProgress | None = None,
    ) -> Pushed:
        """Every piece follows one force, the length held [Li94 4.2.4]."""
        return await self._move(
            Pushed, "motion.gravity", progress, force=force, accuracy=accuracy, rounds=rounds,
            simplification=simplification, commit=commit,
            base_rev=base_rev, op_id=op_id, deadline_ms=deadline_ms, timing=timing,
        )

    async def bump(
        self, piece: str, direction: Point, *, commit: bool | None = None, base_rev: int | None = None,
        op_id: str | None = None, deadline_ms: int | None = None, timing: bool | None = None,
        progress: OnProgress | None = None,
    ) -> Bumped:
        """One piece slides as far as it can, all others still [Li94 4.2.3]."""
        return await self._move(
            Bumped, "motion.bump", progress, piece=piece, direction=direction, commit=commit, base_rev=base_rev,
            op_id=op_id, deadline_ms=deadline_ms, timing=timing,
        )

    async def separate(
        self, *, grow: float | None = None, pop_out: bool | None = None, partial: bool | None = None,
        target: str | None = None, rounds: int | None = None, commit: bool | None = None,
        base_rev: int | None = None, op_id: str | None = None, deadline_ms: int | None = None,
        timing: bool | None = None, progress: OnProgress | None = None,
    ) -> Separated:
        """Overlapping pieces parted with little motion [Li94 5.2]."""
        return await self._move(
            Separated, "motion.separate", progress, grow=grow, pop_out=pop_out, partial=partial, target=target,
            rounds=rounds, commit=commit, base_rev=base_rev, op_id=op_id, deadline_ms=deadline_ms, timing=timing,
        )

    async def float_apart(
        self, distance: float, *, mode: str | None = None, edges: bool | None = None, rounds: int | None = None,
        commit: bool | None = None, base_rev: int | None = None, op_id: str | None = None,
        deadline_ms: int | None = None, timing: bool | None = None, progress: OnProgress | None = None,
    ) -> Floated:
        """Free space shared out among the gaps between pieces [Li94 7]."""
        return await self._move(
            Floated, "motion.float", progress, distance=distance, mode=mode, edges=edges, rounds=rounds,
            commit=commit, base_rev=base_rev, op_id=op_id, deadline_ms=deadline_ms, timing=timing,
        )

    async def place(
        self, piece: str, to: Point, *, may_grow: bool | None = None, commit: bool | None = None,
        base_rev: int | None = None, op_id: str | None = None, deadline_ms: int | None = None,
        timing: bool | None = None, progress: OnProgress | None = None,
    ) -> Placed:
        """A piece dropped anywhere goes to the nearest free position."""
        return await self._move(
            Placed, "motion.place", progress, piece=piece, to=to, may_grow=may_grow, commit=commit,
            base_rev=base_rev, op_id=op_id, deadline_ms=deadline_ms, timing=timing,
        )

    async def open_gap(
        self, *, point: Point | None = None, region: int | None = None, least_area: float | None = None,
        clearance: float | None = None, accuracy: str | None = None, rounds: int | None = None,
        simplification: float | None = None,
        commit: bool | None = None, base_rev: int | None = None, op_id: str | None = None,
        deadline_ms: int | None = None, timing: bool | None = None, progress: OnProgress | None = None,
    ) -> GapOpened:
        """Pieces move away from a point or an unoccupied region [Li94 4.2.2]."""
        return await self._move(
            GapOpened, "motion.openGap", progress, point=point, region=region, least_area=least_area,
            clearance=clearance, accuracy=accuracy, rounds=rounds,
            simplification=simplification, commit=commit, base_rev=base_rev, op_id=op_id,
            deadline_ms=deadline_ms, timing=timing,
        )

    async def tilt(
        self, *, method: str | None = None, limit: float | None = None, shakes: int | None = None,
        tilts: int | None = None, accuracy: str | None = None, rounds: int | None = None,
        simplification: float | None = None,
        commit: bool | None = None, base_rev: int | None = None, op_id: str | None = None,
        deadline_ms: int | None = None, timing: bool | None = None, progress: OnProgress | None = None,
    ) -> Tilted:
        """The marker made shorter with small tilts [Li94 6]."""
        return await self._move(
            Tilted, "motion.tilt", progress, method=method, limit=limit, shakes=shakes, tilts=tilts,
            accuracy=accuracy, rounds=rounds,
            simplification=simplification, commit=commit, base_rev=base_rev, op_id=op_id,
            deadline_ms=deadline_ms, timing=timing,
        )

    async def relax(
        self, piece: str, *, tilts: int | None = None, commit: bool | None = None, base_rev: int | None = None,
        op_id: str | None = None, deadline_ms: int | None = None, timing: bool | None = None,
        progress: OnProgress | None = None,
    ) -> Relaxed:
        """One piece goes to where it has most room [Li94 6.1]."""
        return await self._move(
            Relaxed, "motion.relax", progress, piece=piece, tilts=tilts, commit=commit, base_rev=base_rev,
            op_id=op_id, deadline_ms=deadline_ms, timing=timing,
        )

    async def one_at_a_time(
        self, *, rounds: int | None = None, commit: bool | None = None, base_rev: int | None = None,
        op_id: str | None = None, deadline_ms: int | None = None, timing: bool | None = None,
        progress: OnProgress | None = None,
    ) -> MovedInRounds:
        """A baseline: every piece bumped to the left, one after another [Li94 4.2.3]."""
        return await self._move(
            MovedInRounds, "motion.oneAtATime", progress, rounds=rounds, commit=commit, base_rev=base_rev,
            op_id=op_id, deadline_ms=deadline_ms, timing=timing,
        )

    async def velocity(
        self, *, rounds: int | None = None, commit: bool | None = None, base_rev: int | None = None,
        op_id: str | None = None, deadline_ms: int | None = None, timing: bool | None = None,
        progress: OnProgress | None = None,
    ) -> MovedInRounds:
        """A baseline: pieces pushed by a piston, time step by time step [Li94 2]."""
        return await self._move(
            MovedInRounds, "motion.velocity", progress, rounds=rounds, commit=commit, base_rev=base_rev,
            op_id=op_id, deadline_ms=deadline_ms, timing=timing,
        )
