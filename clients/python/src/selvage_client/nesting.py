"""Nesting in one call: pieces and the width of the cloth go in, positions come out.

The work is done by a running selvaged, which opens a marker for it and closes the marker afterwards, or in this process with
the address `engine:`.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from typing import Any, Literal

from .client import Client, Marker
from .messages.results import Point
from .wire.address import DEFAULT
from .wire.progress import Shown

Outline = Sequence[tuple[float, float]]


@dataclass(frozen=True, kw_only=True)
class Pattern:
    """What is to be nested, and how often.

    `outline`: at least three points, in either direction, in any length unit that all patterns share; the first point may
    be repeated at the end.  `rotations`: the allowed ones in degrees, or "any".  `flip`: copies may be mirrored.
    """

    outline: Outline
    name: str = ""
    quantity: int = 1
    rotations: Sequence[float] | Literal["any"] = (0.0,)
    flip: bool = False


@dataclass(frozen=True, kw_only=True)
class NestedPiece:
    """One copy of a pattern where it lies: mirrored about the x axis when flipped, rotated about the pattern's origin by
    `rotation` degrees counter-clockwise, then translated by `at`."""

    pattern: int
    """The index of the pattern that it is a copy of."""
    at: Point
    rotation: float
    flip: bool


@dataclass(frozen=True, kw_only=True)
class NestedMarker:
    """`length` is along x, in the patterns' unit; `utilisation` is the pieces' part of the cloth up to there, 0 to 1.
    `left_over` holds the indices of patterns whose copies did not fit the cloth, once for each copy.  `document` is the
    whole marker in the native format, `svg` a drawing of it."""

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
    progress: Shown = None,
) -> NestedMarker:
    """Places the pieces on cloth of this width, on as little length as the budget allows.

    A bare outline counts as one copy that may not turn.  `seconds` and `moves` are the budget of each of the `searches`;
    with neither, the daemon's standard number of moves.  `longest` is where the cloth ends.  `spacing` is the least
    distance between pieces, `margin` that from the edges of the cloth.  Bad values raise the daemon's errors.
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
    """Its points, the first not repeated at the end."""
    points = [list(point) for point in outline]
    return points[:-1] if len(points) > 1 and points[0] == points[-1] else points


def area(outline: Outline) -> float:
    """Of the polygon, whichever way it runs."""
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
