"""Client of selvaged, the daemon that compacts garment markers.

`Client` waits, `AsyncClient` is for asyncio; both have the same methods.  What the calls mean: protocol/README.md.
"""

from .messages import choices, errors, motion_results, ops, results
from .async_client import AsyncClient
from .client import Client, Drag, Marker, Watch
from .drag import AsyncDrag
from .drawing import draw
from .library import AsyncLibrary, Library
from .messages.errors import CallError, ConnectionLost, HandshakeFailed, MissingExtra, SelvageError
from .marker import AsyncMarker
from .nesting import NestedMarker, NestedPiece, Pattern, nest
from .outlines import Outline, Outlines
from .watch import AsyncWatch

__version__ = "0.1.0"

__all__ = [
    "AsyncClient",
    "AsyncDrag",
    "AsyncLibrary",
    "AsyncMarker",
    "AsyncWatch",
    "CallError",
    "Client",
    "ConnectionLost",
    "Drag",
    "HandshakeFailed",
    "Library",
    "Marker",
    "MissingExtra",
    "NestedMarker",
    "NestedPiece",
    "Outline",
    "Outlines",
    "Pattern",
    "SelvageError",
    "Watch",
    "__version__",
    "choices",
    "draw",
    "errors",
    "motion_results",
    "nest",
    "ops",
    "results",
]
