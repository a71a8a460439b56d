"""Nesting in one call, which takes pieces and the width of the cloth and returns positions.

A running selvaged does the work, or this process with the address `engine:`.  A marker is opened for it and closed
afterwards.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from typing import Any, Literal

from .client import Client, Marker
from .messages.results import Point
from .wire.address import DEFAULT
from .wire.progress import ProgressOption

Outline = Sequence[tuple[float, float]]


@dataclass(frozen=True, kw_only=True)
class Pattern:
    """A shape to be nested and the number of copies.

    `outline`: at least three points, in either direction, in any length unit that all patterns share; the first point may
    be repeated at the end.  `quantity`: the number of copies; a pattern with 0 is kept, but none of it is nested.
    `rotations`: the allowed rotations in degrees, or "any".  `flip`: whether copies may be mirrored.  Raises ValueError
    for a negative quantity.
    """

    outline: Outline
    name: str = ""
    quantity: int = 1
    rotations: Sequence[float] | Literal["any"] = (0.0,)
    flip: bool = False

    def __post_init__(self) -> None:
        if self.quantity < 0:
            raise ValueError(f"quantity of pattern {self.name!r} is {self.quantity}; 0 or a larger whole number is allowed")


@dataclass(frozen=True, kw_only=True)
class NestedPiece:
    """A placed copy of a pattern: mirrored about the x axis when flipped, rotated about the pattern's origin by
    `rotation` degrees counter-clockwise, then translated by `at`."""

    pattern: int
    """The index of the copied pattern."""
    at: Point
    rotation: float
    flip: bool


@dataclass(frozen=True, kw_only=True)
class NestedMarker:
    """`length` is along x, in the patterns' unit; `utilisation` is the fraction of the cloth up to that length that the
    pieces cover, 0 to 1.  `left_over` holds the index of a pattern once for each copy that did not fit on the cloth.
    `document` is the whole marker in the native format, `svg` a drawing of it."""

    length: float
    utilisation: float
    pieces: tuple[NestedPiece, ...]
    left_over: tuple[int, ...]
    document: dict[str, Any] = field(repr=False)
    svg: str = field(repr=False)

    def _repr_svg_(self) -> str:
        return self.svg


def nest(
    pieces: Iterable[Pattern | Outline],
    width: float,
    *,
    seconds: float | None = None,
    moves: int | None = None,
    seed: int | None = None,
    searches: int | None = None,
    longest: float | None = None,
    spacing: float = 0.0,
    margin: float = 0.0,
    address: str = DEFAULT,
    token: str | None = None,
    progress: ProgressOption = None,
) -> NestedMarker:
    """Places the pieces on cloth of this width, and makes the marker as short as it can within the budget.

    A bare outline stands for one copy that may not be rotated.  `seconds` and `moves` limit each of the `searches`; with
    neither, the daemon's standard number of moves does.  Unless you say how many searches there are, it is one or, with
    `seconds`, as many as the daemon has threads to spare.  `longest` is the length of the cloth, unlimited when absent.
    `spacing` is the least distance between pieces, `margin` the least distance from the edges of the cloth.  Bad values
    raise the daemon's errors.
    """
    patterns = [each if isinstance(each, Pattern) else Pattern(outline=each) for each in pieces]
    marker: dict[str, Any] = {
        "format": "selvage-marker",
        "version": 1,
        "strip": {"width": width, "margin": margin} | ({} if longest is None else {"longest": longest}),
        "spacing": spacing,
        "shapes": [_shape(index, pattern) for index, pattern in enumerate(patterns)],
        "pieces": [],
        "unplaced": [
            {"id": f"{index}/{copy}", "shape": str(index)}
            for index, pattern in enumerate(patterns)
            for copy in range(pattern.quantity)
        ],
    }
    with Client(address, token=token) as client, client.open(marker) as open_marker:
        open_marker.nest(seconds=seconds, moves=moves, seed=seed, searches=searches, progress=progress)
        return _read(open_marker, patterns, width)


def _shape(index: int, pattern: Pattern) -> dict[str, Any]:
    rotations = pattern.rotations if pattern.rotations == "any" else list(pattern.rotations)
    return {"id": str(index), "outline": opened(pattern.outline), "rotations": rotations, "flip": pattern.flip}


def opened(outline: Outline) -> list[list[float]]:
    """The points of the outline, without a repetition of the first one at the end."""
    points = [list(point) for point in outline]
    return points[:-1] if len(points) > 1 and points[0] == points[-1] else points


def area(outline: Outline) -> float:
    """The area of the polygon, positive in either orientation."""
    ends = [*outline[1:], outline[0]]
    return abs(sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(outline, ends, strict=True))) / 2


def _read(marker: Marker, patterns: Sequence[Pattern], width: float) -> NestedMarker:
    document, length = marker.get(format="native").marker, marker.outlines().strip_length
    pieces = tuple(
        NestedPiece(
            pattern=int(piece["shape"]),
            at=(float(piece["at"][0]), float(piece["at"][1])),
            rotation=float(piece.get("rotation", 0)) + float(piece.get("tilt", 0)),
            flip=bool(piece.get("flip", False)),
        )
        for piece in document["pieces"]
    )
    used = sum(area(patterns[piece.pattern].outline) for piece in pieces)
    return NestedMarker(
        length=length,
        utilisation=used / (length * width) if length > 0 else 0.0,
        pieces=pieces,
        left_over=tuple(int(piece["shape"]) for piece in document.get("unplaced", [])),
        document=document,
        svg=marker.svg(),
    )
