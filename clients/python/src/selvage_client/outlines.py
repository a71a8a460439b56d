"""The outlines of a marker's pieces where they lie: plain points, numpy arrays or shapely polygons.

numpy and shapely are imported only by the methods that give theirs: `pip install selvage-client[outlines]`.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from .extras import imported
from .messages.results import Point

if TYPE_CHECKING:
    import numpy
    from numpy.typing import NDArray


@dataclass(frozen=True)
class Outline:
    """Counter-clockwise, every coordinate exact; the last point is not the first again."""

    id: str
    outline: tuple[Point, ...]

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> NDArray[Any]:
        """numpy.asarray(outline): n rows of x and y.  Every array is a new one, so numpy 2's copy=False is refused."""
        if copy is False:
            raise ValueError("an outline cannot become an array without a copy")
        numpy = imported("numpy", "an array of an outline", "outlines")
        array: NDArray[Any] = numpy.array(self.outline, dtype=dtype if dtype is not None else numpy.float64)
        return array


@dataclass(frozen=True)
class Outlines:
    """`strip_height` is the width of the strip, across along y; `strip_length` the length of the marker, along x."""

    strip_height: float
    strip_length: float
    pieces: tuple[Outline, ...]

    def arrays(self) -> dict[str, NDArray[numpy.float64]]:
        """By piece, n rows of x and y."""
        return {piece.id: piece.__array__() for piece in self.pieces}

    def polygons(self) -> dict[str, Any]:
        """By piece, a shapely.geometry.Polygon."""
        polygon = imported("shapely.geometry", "a polygon of an outline", "outlines").Polygon
        return {piece.id: polygon(piece.outline) for piece in self.pieces}
