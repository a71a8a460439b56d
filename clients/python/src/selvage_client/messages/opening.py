"""What a marker may be opened from."""

from __future__ import annotations

import codecs
import json
import os
import pathlib
from collections.abc import Mapping
from typing import Any

Document = Mapping[str, Any] | str | os.PathLike[str]


def source_of(marker: Document) -> Any:
    """The parameter `marker` of marker.open: the document itself, the text of a file, or the content of the file at a path.

    A str is a text if it has several lines or begins like JSON or XML; otherwise it is a path.
    """
    if isinstance(marker, Mapping):
        return marker
    if isinstance(marker, str) and _is_text(marker):
        return _parsed(marker)
    return _parsed(_decoded(pathlib.Path(marker).read_bytes()))


def _is_text(text: str) -> bool:
    return "\n" in text or "\r" in text or text.lstrip()[:1] in ("{", "[", "<")


def _decoded(content: bytes) -> str:
    if content.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)):
        return content.decode("utf-16")
    return content.decode("utf-8-sig")


def _parsed(text: str) -> Any:
    """JSON as its value, so that the daemon does not parse a text within a text."""
    return json.loads(text) if text.lstrip()[:1] in ("{", "[") else text
