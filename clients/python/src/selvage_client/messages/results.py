"""The results of calls as typed values.  protocol/README.md explains the fields, whose names are in snake_case here.

Lengths are in the marker's unit, angles in degrees counter-clockwise, areas in the square of the unit.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

Point = tuple[float, float]


@dataclass(frozen=True)
class Note:
    field: str
    text: str


@dataclass(frozen=True)
class Cache:
    hits: int
    misses: int
    entries: int
    bytes: int
    limit: int


@dataclass(frozen=True)
class Info:
    name: str
    version: str
    protocol_version: str
    methods: tuple[str, ...]
    reads: tuple[str, ...]
    writes: tuple[str, ...]
    accuracies: tuple[str, ...]
    workers: int
    markers: int
    durable: bool
    limits: dict[str, int]
    cache: Cache
    instance: str = ""


@dataclass(frozen=True)
class Opened:
    marker_id: str
    revision: int
    pieces: int
    length: float
    utilisation: float
    valid: bool
    notes: tuple[Note, ...]
    unplaced: int | None = None


@dataclass(frozen=True)
class Listed:
    marker_id: str
    revision: int
    name: str
    pieces: int
    length: float
    utilisation: float
    unplaced: int | None = None


@dataclass(frozen=True)
class Placement:
    """The placement of a piece.

    Results of motions leave out `shape`, `locked`, `group`, `buffer`, `overlap` and `rules`, which no motion changes.
    """

    id: str
    at: Point
    rotation: float
    flip: bool
    tilt: float
    shape: str | None = None
    locked: bool | tuple[str, ...] | None = None
    group: str | None = None
    buffer: float | None = None
    overlap: float | None = None
    rules: dict[str, object] | None = None


@dataclass(frozen=True)
class Got:
    """The result of marker.get.

    `marker` is the whole document (a string for svg).  It is None when the `placements` that changed after revision
    `since` are the only differences.
    """

    marker_id: str
    revision: int
    format: str | None = None
    marker: Any = None
    since: int | None = None
    placements: tuple[Placement, ...] | None = None


@dataclass(frozen=True)
class Overlap:
    first: str
    second: str
    witness: Point
    depth: float


@dataclass(frozen=True)
class Protrusion:
    piece: str
    by: float


@dataclass(frozen=True)
class ShadeFault:
    """Pieces of the same shade that are too far apart."""

    shade: str
    leftmost: str
    rightmost: str
    by: float


@dataclass(frozen=True)
class Checked:
    marker_id: str
    revision: int
    valid: bool
    overlaps: tuple[Overlap, ...]
    protrusions: tuple[Protrusion, ...]
    shades: tuple[ShadeFault, ...] = ()


@dataclass(frozen=True)
class Contact:
    piece: str
    worth: float
    at: Point
    other: str | None = None
    edge: str | None = None


@dataclass(frozen=True)
class TiltWorth:
    piece: str
    per_degree: float


@dataclass(frozen=True)
class RulePrice:
    """What a rule costs, be it of a piece, of a shade or of the strip."""

    rule: str
    worth: float
    piece: str | None = None
    shade: str | None = None


@dataclass(frozen=True)
class Hold:
    marker_id: str
    revision: int
    length: float
    contacts: tuple[Contact, ...]
    tilts: tuple[TiltWorth, ...]
    per_spacing: float
    rules: tuple[RulePrice, ...] = ()


@dataclass(frozen=True)
class Region:
    outline: tuple[Point, ...]
    holes: tuple[tuple[Point, ...], ...]
    area: float
    around: tuple[str, ...]


@dataclass(frozen=True)
class Regions:
    marker_id: str
    revision: int
    regions: tuple[Region, ...]


@dataclass(frozen=True)
class NestedSheet:
    """A sheet that is used; `marker` is a native document."""

    sheet: int
    pieces: int
    utilisation: float
    marker: dict[str, Any]


@dataclass(frozen=True)
class NestedSheets:
    marker_id: str
    revision: int
    sheets: tuple[NestedSheet, ...]
    left_over: tuple[str, ...]
    cost: float
    moves: int
    stop: str


@dataclass(frozen=True)
class Closed:
    marker_id: str
    closed: bool


@dataclass(frozen=True)
class Edited:
    """The result of a change by hand: apply, undo, redo, or the end of a drag session."""

    marker_id: str
    revision: int
    placements: tuple[Placement, ...]
    removed: tuple[str, ...]
    name: str
    pieces: int
    length: float
    utilisation: float
    valid: bool
    whole: bool = False
    notes: tuple[Note, ...] = ()


@dataclass(frozen=True)
class Changed(Edited):
    """The watched marker has a new revision, made by the method `by`."""

    by: str = ""


@dataclass(frozen=True)
class Missed:
    """Changes up to `revision` were missed while the connection was lost; marker.get returns the current state."""

    marker_id: str
    revision: int


@dataclass(frozen=True)
class Watching:
    marker_id: str
    revision: int
    watching: bool


@dataclass(frozen=True)
class DragStarted:
    """The result of drag.begin: a drag session that has picked up `piece`."""

    drag_id: str
    marker_id: str
    revision: int
    piece: str
    at: Point


@dataclass(frozen=True)
class Dragged:
    drag_id: str
    at: Point
    reached: bool
    pushed: bool
    placements: tuple[Placement, ...]
    length: float
    utilisation: float
    valid: bool


@dataclass(frozen=True)
class Progress:
    """A round of a motion in progress.

    `bound`, only from pack, is a proved lower bound on the length; `nodes`, only from exact searches, is the number of
    nodes searched so far.
    """

    round: int
    length: float
    bound: float | None = None
    nodes: int | None = None
