"""Draws markers with matplotlib: `pip install selvage-client[drawing]`."""

from __future__ import annotations

from typing import Any

from .extras import imported
from .outlines import Outlines


def draw(outlines: Outlines, axes: Any = None, *, labels: bool = False, colours: str = "tab20") -> Any:
    """Draws the strip and its pieces into matplotlib's `axes`, or into new axes, and returns the axes.

    `colours` names a colour map of matplotlib; its colours are assigned to the pieces in order.
    """
    colormaps = imported("matplotlib", "drawing", "drawing").colormaps
    patches = imported("matplotlib.patches", "drawing", "drawing")
    if axes is None:
        axes = imported("matplotlib.pyplot", "drawing", "drawing").subplots(figsize=(12, 12 * outlines.strip_height / outlines.strip_length + 1))[1]
    cloth = patches.Rectangle((0, 0), outlines.strip_length, outlines.strip_height, facecolor="#f7f5f0", edgecolor="#555555")
    axes.add_patch(cloth)
    palette = colormaps[colours]
    for place, piece in enumerate(outlines.pieces):
        colour = palette(place % palette.N)
        axes.add_patch(patches.Polygon(piece.outline, closed=True, facecolor=colour, edgecolor="black", linewidth=0.4))
        if labels:
            middle = [sum(coordinates) / len(piece.outline) for coordinates in zip(*piece.outline)]
            axes.annotate(piece.id, middle, ha="center", va="center", fontsize=6)
    axes.set_aspect("equal")
    axes.set_xlim(0, outlines.strip_length)
    axes.set_ylim(0, outlines.strip_height)
    return axes
