"""A replacement for spyrrow, the Python package of the nesting program sparrow.

A program that uses spyrrow only has to replace `import spyrrow` with

    from selvage_client import spyrrow

because items, instances, configurations and solutions have the same names, fields and units.  A running selvaged at
`address` does the work.

There are four differences.  `num_workers` is the number of searches, the best of which is returned; without it
there are as many as the daemon has threads to spare.  `quadtree_depth` and `early_termination` are accepted and ignored.
Exploration and compression share one budget, so only their sum matters.  There are no progress queues.

`marker` turns a solution, also one of spyrrow itself, into a marker that any motion accepts; `solution` turns it back:

    document = spyrrow.marker(instance, instance.solve(config))
    shorter = spyrrow.solution(selvage_engine.compact(document).document)
"""

from __future__ import annotations

import json
import math
import random
from collections.abc import Sequence
from dataclasses import asdict, dataclass, field
from datetime import timedelta
from typing import Any, Literal, Protocol

from .nesting import Pattern, area, nest, opened
from .wire.address import DEFAULT

Point = tuple[float, float]

_ANGLE_SLACK = 1e-3
"""Degrees; a quarter turn in single precision is far closer than this.  Sparrow files are read with the same."""

address: str = DEFAULT
"""Where the daemon listens: HOST:PORT, tls://HOST:PORT or unix:PATH."""


@dataclass
class Item:
    """A shape, the number of copies, and the allowed rotations in degrees: empty for 0 only, None for any.

    Raises ValueError for a negative demand.
    """

    id: str
    shape: Sequence[Point]
    demand: int
    allowed_orientations: Sequence[float] | None

    def __post_init__(self) -> None:
        if self.demand < 0:
            raise ValueError(f"demand of item {self.id!r} is {self.demand}; 0 or a larger whole number is allowed")

    def to_json_str(self) -> str:
        return json.dumps(asdict(self))


@dataclass(frozen=True)
class PlacedItem:
    """A copy of an item: rotated about the origin by `rotation` degrees, then translated."""

    id: str
    translation: Point
    rotation: float


@dataclass(frozen=True)
class StripPackingSolution:
    """`width` is the length of strip that is used, `density` the fraction of it that items cover, 0 to 1."""

    width: float
    density: float
    placed_items: list[PlacedItem] = field(default_factory=list)


class StripPackingConfig:
    """Times in seconds: either the total, or the times of both exploration and compression."""

    def __init__(
        self,
        early_termination: bool = True,
        quadtree_depth: int = 4,
        min_items_separation: float | None = None,
        total_computation_time: int | None = 600,
        exploration_time: int | None = None,
        compression_time: int | None = None,
        num_workers: int | None = None,
        seed: int | None = None,
    ) -> None:
        parts = (exploration_time, compression_time)
        if parts != (None, None) if total_computation_time is not None else None in parts:
            raise ValueError("give either total_computation_time, or both exploration_time and compression_time")
        total = total_computation_time
        self.exploration_time = timedelta(seconds=total * 0.8 if total is not None else exploration_time or 0)
        self.compression_time = timedelta(seconds=total * 0.2 if total is not None else compression_time or 0)
        self.early_termination = early_termination
        self.quadtree_depth = quadtree_depth
        self.min_items_separation = min_items_separation
        self.num_workers = num_workers
        self.seed = random.getrandbits(32) if seed is None else seed


class StripPackingInstance:
    """Items to be placed on a strip of fixed height so that they take as little width as possible; their ids are unique."""

    def __init__(self, name: str, strip_height: float, items: Sequence[Item]) -> None:
        if len({item.id for item in items}) != len(items):
            raise ValueError("every item needs an id of its own")
        self.name = name
        self.strip_height = strip_height
        self.items = list(items)

    def to_json_str(self) -> str:
        return json.dumps({"name": self.name, "strip_height": self.strip_height, "items": list(map(asdict, self.items))})

    def solve(self, config: StripPackingConfig) -> StripPackingSolution:
        """Raises selvage_client.CallError if an item does not fit in any allowed rotation, and for other bad values."""
        found = nest(
            [
                Pattern(
                    outline=item.shape,
                    quantity=item.demand,
                    rotations="any" if item.allowed_orientations is None else list(item.allowed_orientations) or [0.0],
                )
                for item in self.items
            ],
            self.strip_height,
            seconds=(config.exploration_time + config.compression_time).total_seconds(),
            searches=config.num_workers,
            seed=config.seed,
            spacing=config.min_items_separation or 0.0,
            address=address,
        )
        placed = [PlacedItem(self.items[piece.pattern].id, piece.at, piece.rotation) for piece in found.pieces]
        return StripPackingSolution(found.length, found.utilisation, placed)


class AnyItem(Protocol):
    """An item of spyrrow or of this module."""

    id: str
    shape: Sequence[Point]
    allowed_orientations: Sequence[float] | None


class AnyInstance(Protocol):
    name: str
    strip_height: float

    @property
    def items(self) -> Sequence[AnyItem]: ...


class AnyPlacedItem(Protocol):
    @property
    def id(self) -> str: ...
    @property
    def translation(self) -> Point: ...
    @property
    def rotation(self) -> float: ...


class AnySolution(Protocol):
    @property
    def placed_items(self) -> Sequence[AnyPlacedItem]: ...


def marker(instance: AnyInstance, solution: AnySolution, *, separation: float = 0.0) -> dict[str, Any]:
    """The solution as a marker in the native format; `separation` is the least distance between two items.

    A rotation within 0.001 degrees of an allowed one becomes that one, because nesting programs compute in single
    precision.  The first motion repairs small overlaps, which they leave for the same reason.
    """
    allowed = {item.id: _rotations(item) for item in instance.items}
    copies: dict[str, int] = {}
    pieces: list[dict[str, Any]] = []
    for placed in solution.placed_items:
        copies[placed.id] = copies.get(placed.id, 0) + 1
        pieces.append(
            {
                "id": f"{placed.id}/{copies[placed.id]}",
                "shape": placed.id,
                "at": list(placed.translation),
                "rotation": _nearest(placed.rotation, allowed.get(placed.id, "any")),
            }
        )
    return {
        "format": "selvage-marker",
        "version": 1,
        "name": instance.name,
        "strip": {"width": instance.strip_height},
        "spacing": separation,
        "shapes": [_shape(item) for item in instance.items],
        "pieces": pieces,
    }


def solution(document: dict[str, Any]) -> StripPackingSolution:
    """A marker in the native format as a solution; tilts are part of the rotation, and zones of the cloth are left out.

    Raises ValueError for a flipped piece, which a solution of spyrrow cannot express.
    """
    outlines = {shape["id"]: shape["outline"] for shape in document["shapes"]}
    placed: list[PlacedItem] = []
    used, width = 0.0, 0.0
    for piece in document["pieces"]:
        if piece.get("rules", {}).get("zone"):
            continue
        if piece.get("flip"):
            raise ValueError(f"piece {piece['id']!r} is flipped, which a solution of spyrrow cannot express")
        rotation = float(piece.get("rotation", 0)) + float(piece.get("tilt", 0))
        x, y = piece["at"]
        placed.append(PlacedItem(piece["shape"], (float(x), float(y)), rotation))
        outline = outlines[piece["shape"]]
        used += area(outline)
        cosine, sine = math.cos(math.radians(rotation)), math.sin(math.radians(rotation))
        width = max(width, x + max(cosine * px - sine * py for px, py in outline))
    return StripPackingSolution(width, used / (width * document["strip"]["width"]) if width else 0.0, placed)


def _shape(item: AnyItem) -> dict[str, Any]:
    return {"id": item.id, "outline": opened(item.shape), "rotations": _rotations(item)}


def _rotations(item: AnyItem) -> list[float] | Literal["any"]:
    allowed = item.allowed_orientations
    return "any" if allowed is None else list(allowed) or [0.0]


def _nearest(rotation: float, allowed: list[float] | Literal["any"]) -> float:
    """The allowed rotation within 0.001 degrees, up to whole turns; `rotation` itself if there is none."""
    if allowed == "any":
        return rotation
    distances = [(abs(math.remainder(rotation - angle, 360.0)), angle) for angle in allowed]
    distance, nearest = min(distances)
    return nearest if distance <= _ANGLE_SLACK else rotation
