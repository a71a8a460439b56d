"""Operations for Marker.apply: each function makes one operation of protocol/README.md, "Changes by hand"."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from .choices import NapDirection
from .results import Point
from .conversion import named

Op = dict[str, Any]


def add(piece: Mapping[str, Any], shape: Mapping[str, Any] | None = None) -> Op:
    """Adds a piece, as in a native document.  `shape` is needed only if the marker has no shape with that id."""
    return named(op="add", piece=piece, shape=shape)


def remove(piece: str) -> Op:
    return named(op="remove", piece=piece)


def place(piece: str, at: Point, *, rotation: float | None = None, flip: bool | None = None) -> Op:
    """Lays an unplaced piece on the cloth."""
    return named(op="place", piece=piece, at=at, rotation=rotation, flip=flip)


def take_off(piece: str) -> Op:
    """Takes a piece off the cloth, so that it is unplaced."""
    return named(op="takeOff", piece=piece)


def move(piece: str, *, at: Point | None = None, by: Point | None = None) -> Op:
    return named(op="move", piece=piece, at=at, by=by)


def rotate(piece: str, *, to: float | None = None, by: float | None = None) -> Op:
    return named(op="rotate", piece=piece, to=to, by=by)


def flip(piece: str, flip: bool | None = None) -> Op:
    """Sets whether the piece is flipped; without `flip`, toggles it."""
    return named(op="flip", piece=piece, flip=flip)


def tilt(piece: str, *, to: float | None = None, by: float | None = None) -> Op:
    return named(op="tilt", piece=piece, to=to, by=by)


def lock(piece: str, locked: bool | Sequence[str] = True) -> Op:
    """Locks all of the piece (True), nothing (False), or some of "x", "y" and "tilt"."""
    return named(op="lock", piece=piece, locked=locked)


def group(piece: str, group: str | None = None) -> Op:
    """Sets the group of the piece; without `group`, it belongs to none."""
    return named(op="group", piece=piece, group=group)


def buffer(piece: str, buffer: float) -> Op:
    return named(op="buffer", piece=piece, buffer=buffer)


def overlap(piece: str, overlap: float | None = None) -> Op:
    """Sets the overlap allowance of the piece; without `overlap`, the marker's allowance applies to it."""
    return named(op="overlap", piece=piece, overlap=overlap)


def rules(
    piece: str,
    *,
    below: float | None = None,
    above: float | None = None,
    start: float | None = None,
    end: float | None = None,
    fold: bool | None = None,
    match: Point | None = None,
    match_set: str | None = None,
    shade: str | None = None,
    nap: NapDirection | None = None,
    zone: bool | None = None,
    quality: int | None = None,
) -> Op:
    """Replaces all rules of the piece: those left out are removed.  `start` and `end` are called `from` and `to` in JSON."""
    point = None if match is None else list(match)
    given = named(below=below, above=above, to=end, fold=fold, match=point, matchSet=match_set)
    given |= named(shade=shade, nap=nap, zone=zone, quality=quality)
    return named(op="rules", piece=piece, rules=given if start is None else given | {"from": start})


def set_strip(
    *,
    width: float | None = None,
    longest: float | None = None,
    margin: float | None = None,
    below: float | None = None,
    above: float | None = None,
    repeat: dict[str, Any] | None = None,
    tube: bool | None = None,
    endless: bool = False,
) -> Op:
    """`endless` removes the limit `longest`.  `repeat` is as in a document; {} means that the cloth has no pattern."""
    op = named(op="setStrip", width=width, longest=longest, margin=margin, below=below, above=above, repeat=repeat, tube=tube)
    return op | {"longest": None} if endless else op


def set_spacing(spacing: float) -> Op:
    return named(op="setSpacing", spacing=spacing)


def set_overlap(overlap: float) -> Op:
    return named(op="setOverlap", overlap=overlap)


def set_shade(shade: float | None) -> Op:
    """With None, shades have no effect."""
    return {"op": "setShade", "shade": shade}
