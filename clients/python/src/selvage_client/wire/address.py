"""Addresses: HOST:PORT, tcp://HOST:PORT, tls://HOST:PORT or unix:PATH of a daemon, or `engine:` for this process."""

from __future__ import annotations

from dataclasses import dataclass

DEFAULT = "127.0.0.1:7171"
IN_PROCESS = "engine:"


@dataclass(frozen=True)
class Address:
    """The `path` of a Unix socket, or `host` and `port`, or none of these for the engine `in_process`."""

    host: str = ""
    port: int = 0
    tls: bool = False
    path: str | None = None
    in_process: bool = False


def parse_address(text: str) -> Address:
    """Raises ValueError with a message for the user."""
    if text == IN_PROCESS:
        return Address(in_process=True)
    if text.startswith("unix:"):
        path = text.removeprefix("unix:")
        return Address(path=path.removeprefix("//") if path.startswith("///") else path)
    scheme, found, rest = text.rpartition("://")
    if found and scheme not in ("tcp", "tls"):
        raise ValueError(f"{text!r}: tcp://HOST:PORT, tls://HOST:PORT or unix:PATH is required")
    host, _, port = rest.rpartition(":")
    if not host or not port.isdecimal() or not 0 < int(port) < 65536:
        raise ValueError(f"{text!r}: HOST:PORT is required, the port from 1 to 65535")
    return Address(host.removeprefix("[").removesuffix("]"), int(port), scheme == "tls")
