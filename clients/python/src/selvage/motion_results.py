"""What motions answer, typed.  Fields, units and meanings: protocol/README.md, Motions."""

from __future__ import annotations

from dataclasses import dataclass

from .results import Cache, Overlap, Placement, Point, Region


@dataclass(frozen=True)
class Healed:
    pairs: int
    protruding: int
    deepest: float
    farthest_move: float
    lengthened: float


@dataclass(frozen=True)
class Gap:
    piece: str
    other: str | None = None
    edge: str | None = None
    before: float | None = None
    after: float | None = None


@dataclass(frozen=True)
class CriticalSet:
    distance: float
    gaps: tuple[Gap, ...]


@dataclass(frozen=True, kw_only=True)
class Moved:
    """What every motion answers; `ms` and `cache` only when asked for (`timing`)."""

    marker_id: str
    revision: int
    name: str
    pieces: int
    length_before: float
    length_after: float
    utilisation_before: float
    utilisation_after: float
    valid: bool
    stop: str
    healed: Healed
    placements: tuple[Placement, ...]
    ms: dict[str, float] | None = None
    cache: Cache | None = None


@dataclass(frozen=True, kw_only=True)
class MovedInRounds(Moved):
    rounds: int


@dataclass(frozen=True, kw_only=True)
class Pushed(MovedInRounds):
    gain: float


@dataclass(frozen=True, kw_only=True)
class Bumped(Moved):
    at: Point
    gain: float
    touching: tuple[str, ...]
    moved: bool


@dataclass(frozen=True, kw_only=True)
class Separated(MovedInRounds):
    apart: bool
    moved: float
    farthest_move: float
    remaining: tuple[Overlap, ...]
    popped: tuple[str, ...]


@dataclass(frozen=True, kw_only=True)
class Floated(MovedInRounds):
    least_before: float
    least_after: float
    reached: bool
    gaps: tuple[Gap, ...]
    critical: tuple[CriticalSet, ...]


@dataclass(frozen=True, kw_only=True)
class Placed(Moved):
    found: bool
    at: Point
    distance: float | None
    grown: bool


@dataclass(frozen=True, kw_only=True)
class GapOpened(MovedInRounds):
    area_before: float
    area_after: float
    inside: Point
    gap: Region


@dataclass(frozen=True, kw_only=True)
class Tilted(MovedInRounds):
    length_compacted: float
    farthest_tilt: float


@dataclass(frozen=True, kw_only=True)
class Relaxed(Moved):
    at: Point
    tilt: float
    freedom: float
