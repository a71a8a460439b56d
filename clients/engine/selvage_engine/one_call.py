"""Turns motions into single calls, which open a document, run the motion and close the marker."""

from __future__ import annotations

import functools
import os
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, Concatenate, Generic, ParamSpec, TypeVar

from selvage_client import Client, Marker

P = ParamSpec("P")
R = TypeVar("R")
Document = Mapping[str, Any] | str | os.PathLike[str]


@dataclass(frozen=True)
class After(Generic[R]):
    """The outcome of a motion: its result, and the marker after it as a document in the native format."""

    result: R
    document: dict[str, Any]

    def svg(self) -> str:
        """A drawing of the marker as an SVG document."""
        with Client("engine:") as client, client.open(self.document) as marker:
            return marker.svg()

    def _repr_svg_(self) -> str:
        return self.svg()


def in_one_call(motion: Callable[Concatenate[Marker, P], R]) -> Callable[Concatenate[Document, P], After[R]]:
    """The motion as a function that takes a document, or its path, instead of an open marker."""

    @functools.wraps(motion)
    def run(document: Document, /, *args: P.args, **kwargs: P.kwargs) -> After[R]:
        with Client("engine:") as client, client.open(document) as marker:
            result = motion(marker, *args, **kwargs)
            return After(result, marker.get(format="native").marker)

    return run
