"""The exceptions: one class per error code of protocol/README.md, and errors of the connection."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, ClassVar


class SelvageError(Exception):
    """The base class of all exceptions of this package."""


class ConnectionLost(SelvageError, ConnectionError):
    """The daemon cannot be reached, or the connection ended before it answered."""


class HandshakeFailed(SelvageError, ConnectionError):
    """The daemon's certificate is not trusted, or the daemon does not use TLS: retrying would not help."""


class MissingExtra(SelvageError, ImportError):
    """An optional package that this method needs is not installed."""

    def __init__(self, what: str, extra: str, module: str) -> None:
        self.extra = extra
        super().__init__(f"{what} needs the package {module}: pip install 'selvage-client[{extra}]'", name=module)


class UnexpectedAnswer(SelvageError):
    """The daemon's answer does not conform to the protocol."""


class CallError(SelvageError):
    """The daemon answered a call with an error.

    `code` and `data` are fields of the JSON-RPC error.  `detail` and `name` are the exact code and its name, such as
    1206 and "marker.overlaps"; `field` is a JSON pointer to the wrong parameter.
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
    """The message is not JSON, or exceeds the limits of what the daemon reads."""

    code = -32700


class InvalidRequest(CallError):
    """The message is not a JSON-RPC request."""

    code = -32600


class MethodNotFound(CallError):
    """There is no such method."""

    code = -32601


class InvalidParams(CallError):
    """A parameter is wrong: `field` says which."""

    code = -32602


class InternalError(CallError):
    """An internal error of the daemon."""

    code = -32603


class MotionRefused(CallError):
    """The motion cannot be carried out on this marker: `name` says why."""

    code = -32000


class Busy(CallError):
    """The queue is full."""

    code = -32010

    @property
    def retry_after(self) -> float:
        """The number of seconds to wait before the next attempt."""
        return float(self.data.get("retryAfterMs", 0)) / 1000


class TooLarge(CallError):
    """The request is longer than the daemon accepts: `data["limit"]` bytes."""

    code = -32011


class UnknownMarker(CallError):
    """No marker with this id is open."""

    code = -32012


class LimitReached(CallError):
    """A limit of this daemon is reached: `data["limit"]`."""

    code = -32013


class Draining(CallError):
    """The daemon is shutting down and accepts no new calls."""

    code = -32014


class Unauthorised(CallError):
    """The client has not authenticated with the right token."""

    code = -32015


class Cancelled(CallError):
    """The call was cancelled."""

    code = -32800


class RevisionMismatch(CallError):
    """The marker is at another revision than `base_rev`."""

    code = -32801

    @property
    def revision(self) -> int:
        """The marker's current revision."""
        return int(self.data["revision"])


class Superseded(CallError):
    """A newer call of the same kind replaced this one, such as a later move of the same drag session."""

    code = -32802


def call_error(error: Mapping[str, Any]) -> CallError:
    """The exception for the `error` of an answer; for an unknown code it is a plain CallError."""
    code = int(error["code"])
    kind = CallError.by_code.get(code, CallError)
    return kind(str(error["message"]), error.get("data"), code)
