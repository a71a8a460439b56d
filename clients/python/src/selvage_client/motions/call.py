"""The call that all motions of a marker share."""

from __future__ import annotations

from typing import Any, TypeVar

from ..messages.motion_results import Moved
from ..messages.conversion import named, read
from ..wire.home import Home
from ..wire.link import Link
from ..wire.progress import ProgressOption, progress_callback

M = TypeVar("M", bound=Moved)


class AsyncMotion:
    id: str
    revision: int | None
    _link: Link
    _home: Home

    async def _move(self, kind: type[M], motion: str, progress: ProgressOption, **params: Any) -> M:
        with progress_callback(progress) as on_progress:
            answer = await self._link.call(motion, named(marker_id=self.id, **params), on_progress, self._home)
        moved = read(kind, answer)
        self.revision = moved.revision
        return moved
