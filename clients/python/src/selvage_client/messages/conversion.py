"""Conversion between Python and the protocol: snake_case and camelCase names, dataclasses and JSON.

Unknown fields of a result are ignored, as the protocol requires; a field without a default must be present.
"""

from __future__ import annotations

import dataclasses
import functools
import re
import types
import typing
from typing import Any, TypeVar

from .errors import UnexpectedAnswer

T = TypeVar("T")


@functools.lru_cache(maxsize=None)
def camel(name: str) -> str:
    """base_rev -> baseRev"""
    head, *tail = name.split("_")
    return head + "".join(word.capitalize() for word in tail)


@functools.lru_cache(maxsize=None)
def snake(name: str) -> str:
    """baseRev -> base_rev"""
    return re.sub("[A-Z]", lambda letter: "_" + letter.group().lower(), name)


def named(**fields: Any) -> dict[str, Any]:
    """Parameters under their names in the protocol, without those that are None."""
    return {camel(name): value for name, value in fields.items() if value is not None}


def read(kind: type[T], value: Any) -> T:
    """Makes a value of a type of results.py from JSON.  Raises UnexpectedAnswer."""
    try:
        return typing.cast(T, _read(kind, value))
    except (KeyError, TypeError, ValueError) as error:
        raise UnexpectedAnswer(f"{kind.__name__}: {error!r} in {str(value)[:200]}") from error


@functools.lru_cache(maxsize=None)
def _fields(kind: type) -> list[tuple[str, str, Any, bool]]:
    hints = typing.get_type_hints(kind)
    return [
        (field.name, camel(field.name), hints[field.name], field.default is dataclasses.MISSING)
        for field in dataclasses.fields(kind)
    ]


def _read(kind: Any, value: Any) -> Any:
    if dataclasses.is_dataclass(kind):
        if not isinstance(value, dict):
            raise TypeError("an object is required")
        made: Any = kind
        present = [field for field in _fields(made) if field[3] or field[1] in value]
        return made(**{name: _read(hint, value[wire]) for name, wire, hint, _ in present})
    origin, parts = typing.get_origin(kind), typing.get_args(kind)
    if origin is types.UnionType:
        return _read_union(parts, value)
    if origin is tuple:
        if parts[-1] is Ellipsis:
            return tuple(_read(parts[0], each) for each in value)
        return tuple(_read(part, each) for part, each in zip(parts, value, strict=True))
    if kind is float:
        return float(value)
    if kind in (int, str, bool) and type(value) is not kind:
        raise TypeError(f"{value!r} where {kind.__name__} is required")
    return value


def _read_union(parts: tuple[Any, ...], value: Any) -> Any:
    if value is None:
        return None
    lists = isinstance(value, list)
    fitting = next(part for part in parts if part is not type(None) and (typing.get_origin(part) is tuple) == lists)
    return _read(fitting, value)
