"""The engine of Selvage in this process: the motions of garment markers, without a daemon.

    from selvage_engine import compact
    after = compact("marker.json")
    after.result.length_after, after.document

Each motion is a function.  It takes a marker, which is a native or sparrow document or the path of one, and the
parameters of the method of the same name of selvage_client.Marker.  To make several calls on one marker, or to nest
patterns, use selvage_client with the address "engine:", such as `selvage_client.Client("engine:")`.
"""

from ._engine import Engine, Stop, __version__
from .motions import *
from .motions import __all__ as _motions
from .one_call import After

__all__ = ["After", "Engine", "Stop", "__version__", *_motions]
