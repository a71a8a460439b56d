"""The outlines of a marker's placed pieces as plain points, numpy arrays or shapely polygons.

numpy and shapely are imported only by the methods that return their types: `pip install selvage-client[outlines]`.
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
    """The outline of a piece, counter-clockwise.  Coordinates are exact; the first point is not repeated at the end."""

    id: str
    outline: tuple[Point, ...]

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> NDArray[Any]:
        """Supports numpy.asarray(outline): n rows of x and y.  It always makes a new array, so copy=False is refused."""
        if copy is False:
            raise ValueError("an outline cannot become an array without a copy")
        numpy = imported("numpy", "an array of an outline", "outlines")
        array: NDArray[Any] = numpy.array(self.outline, dtype=dtype if dtype is not None else numpy.float64)
        return array


@dataclass(frozen=True)
class Outlines:
    """`strip_height` is the width of the strip, along y; `strip_length` is the length of the marker, along x."""

    strip_height: float
    strip_length: float
    pieces: tuple[Outline, ...]

    def arrays(self) -> dict[str, NDArray[numpy.float64]]:
        """An array for each piece id, with n rows of x and y."""
        return {piece.id: piece.__array__() for piece in self.pieces}

    def polygons(self) -> dict[str, Any]:
        """A shapely.geometry.Polygon for each piece id."""
        polygon = imported("shapely.geometry", "a polygon of an outline", "outlines").Polygon
        return {piece.id: polygon(piece.outline) for piece in self.pieces}
