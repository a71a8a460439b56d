"""What can go wrong, as exceptions: one class per code of protocol/README.md, and ConnectionLost."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, ClassVar


class SelvageError(Exception):
    """Anything that this package raises of its own."""


class ConnectionLost(SelvageError, ConnectionError):
    """The daemon cannot be reached, or went away before it answered."""


class HandshakeFailed(SelvageError, ConnectionError):
    """The other side's certificate is not trusted, or it does not speak TLS: trying again would not help."""


class MissingExtra(SelvageError, ImportError):
    """A package that only some methods need is not installed."""

    def __init__(self, what: str, extra: str, module: str) -> None:
        self.extra = extra
        super().__init__(f"{what} needs the package {module}: pip install 'selvage-client[{extra}]'", name=module)


class UnexpectedAnswer(SelvageError):
    """The daemon answered, but not in the words of the protocol."""


class CallError(SelvageError):
    """The daemon refused a call.

    `code` is JSON-RPC's, `data` the error's own; `detail` and `name` say what exactly, such as 1206 and
    "marker.overlaps"; `field` says where, a JSON pointer into the parameters.
    """

    code: int = 0
    by_code: ClassVar[dict[int, type[CallError]]] = {}

    def __init_subclass__(cls, **keywords: Any) -> None:
        super().__init_subclass__(**keywords)
        CallError.by_code[cls.code] = cls

    def __init__(self, message: str, data: Mapping[str, Any] | None = None, code: int | None = None) -> None:
        super().__init__(message)
        self.message = message
        self.data: dict[str, Any] = dict(data or {})
        if code is not None:
            self.code = code

    @property
    def detail(self) -> int | None:
        return self.data.get("code")

    @property
    def name(self) -> str | None:
        return self.data.get("name")

    @property
    def field(self) -> str | None:
        return self.data.get("field")


class ParseError(CallError):
    """Not JSON, or beyond the limits of what the daemon reads."""

    code = -32700


class InvalidRequest(CallError):
    """Not a request."""

    code = -32600


class MethodNotFound(CallError):
    """No such method."""

    code = -32601


class InvalidParams(CallError):
    """A parameter is wrong: `field` says which."""

    code = -32602


class InternalError(CallError):
    """A mistake of the daemon's own."""

    code = -32603


class MotionRefused(CallError):
    """The marker does not allow this: `name` says why."""

    code = -32000


class Busy(CallError):
    """The queue is full."""

    code = -32010

    @property
    def retry_after(self) -> float:
        """Seconds until another try is worth while."""
        return float(self.data.get("retryAfterMs", 0)) / 1000


class TooLarge(CallError):
    """The request is longer than the daemon takes: `data["limit"]` bytes."""

    code = -32011


class UnknownMarker(CallError):
    """No marker of this id."""

    code = -32012


class LimitReached(CallError):
    """A limit of this daemon: `data["limit"]`."""

    code = -32013


class Draining(CallError):
    """The daemon is going down and takes no new work."""

    code = -32014


class Unauthorised(CallError):
    """The connection has not shown the token."""

    code = -32015


class Cancelled(CallError):
    """The call was cancelled."""

    code = -32800


class RevisionMismatch(CallError):
    """The marker is at another revision than `base_rev`."""

    code = -32801

    @property
    def revision(self) -> int:
        """The marker's present revision."""
        return int(self.data["revision"])


class Superseded(CallError):
    """A newer call of the same kind took this one's place: the hand has moved on."""

    code = -32802


def call_error(error: Mapping[str, Any]) -> CallError:
    """The exception for an `error` of the wire; codes that are not known yet are plain CallErrors."""
    code = int(error["code"])
    kind = CallError.by_code.get(code, CallError)
    return kind(str(error["message"]), error.get("data"), code)
