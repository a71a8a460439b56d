"""Generates the motions of the Python client from the OpenRPC document: a method for each, in a file for each family."""
from __future__ import annotations

from python_client import HEADER, Types, common_fields, motions_of, python_name, result_name, snake

BY_PIECE = {"Force": ("force", "Point"), "PieceValue": ("value", "float")}  # lists that are mappings in Python
CALL_PARAMS = ("commit", "baseRev", "opId", "deadlineMs", "timing")  # of every motion; they follow its own parameters
FAMILIES = {
    "searches": "Methods that search for a better layout; they take long, and stop when their time is up.",
    "markers": "Motions of all pieces of a marker.",
    "pieces": "Motions of single pieces.",
}


def family(method: dict) -> str:
    if method["name"].startswith("marker."):
        return "searches"
    required = {param["name"] for param in method["params"] if param["required"]}
    return "pieces" if required & {"piece", "pieces"} else "markers"


def class_name(family_name: str) -> str:
    return "Async" + family_name.capitalize()


def by_piece(schema: dict) -> tuple[str, str] | None:
    """For a list with an entry for each piece: the name and the type of the other field of an entry."""
    return BY_PIECE.get(schema.get("items", {}).get("$ref", "").rsplit("/", 1)[-1])


def parameter(types: Types, param: dict) -> str:
    name, schema = snake(param["name"]), param["schema"]
    entry = by_piece(schema)
    kind = f"Mapping[str, {entry[1]}]" if entry else types.of(schema)
    if param["name"] == "deadlineMs":
        kind = "float"
    return f"{name}: {kind}" if param["required"] else f"{name}: {kind} | None = None"


def argument(param: dict) -> str:
    name = snake(param["name"])
    if entry := by_piece(param["schema"]):
        listed = f'[{{"piece": piece, "{entry[0]}": {entry[0]}}} for piece, {entry[0]} in {name}.items()]'
        return f"{name}={listed}" if param["required"] else f"{name}=None if {name} is None else {listed}"
    return f"{name}={name}"


def motion(types: Types, method: dict, common: list[str]) -> str:
    params = [param for param in method["params"] if param["name"] not in ("markerId", "progressToken")]
    own = [param for param in params if param["name"] not in CALL_PARAMS]
    call = sorted((param for param in params if param["name"] in CALL_PARAMS),
                  key=lambda param: CALL_PARAMS.index(param["name"]))
    signature = ["self", *[parameter(types, param) for param in own if param["required"]], "*",
                 *[parameter(types, param) for param in [*own, *call] if not param["required"]],
                 "progress: ProgressOption = None"]
    arguments = [f'"{method["name"]}"', "progress", *[argument(param) for param in [*own, *call]]]
    result = result_name(method, common)
    lines = [f"    async def {python_name(method)}("]
    lines += [f"        {each}," for each in signature]
    lines += [f"    ) -> {result}:", f'        """{method["summary"]}"""', "        return await self._move("]
    lines += [f"            {each}," for each in [result, *arguments]]
    return "\n".join([*lines, "        )"])


def family_file(name: str, document: dict) -> str:
    types = Types(document)
    common = common_fields(document)
    of_family = [method for method in motions_of(document) if family(method) == name]
    methods = "\n\n".join(motion(types, method, common) for method in of_family)
    results = "".join(f"    {each},\n" for each in sorted({result_name(method, common) for method in of_family}))
    words = f"from ..messages.choices import {', '.join(sorted(types.choices))}\n" if types.choices else ""
    abstract = "from collections.abc import Mapping\n\n" if "Mapping[" in methods else ""
    point = "from ..messages.results import Point\n" if "Point" in methods else ""
    return f'''"""{FAMILIES[name]}  protocol/README.md, Motions, explains the parameters and results.

{HEADER}
"""

from __future__ import annotations

{abstract}{words}from ..messages.motion_results import (
{results})
{point}from ..wire.progress import ProgressOption
from .call import AsyncMotion


class {class_name(name)}(AsyncMotion):
{methods}
'''


def package_file() -> str:
    imports = "".join(f"from .{name} import {class_name(name)}\n" for name in sorted(FAMILIES))
    return f'''"""The motions of a marker, one method each: AsyncMotions, and BlockingMotions for blocking calls.

Every motion takes `commit` (False returns the result but leaves the marker unchanged), `base_rev`, `op_id`, `deadline_ms`,
`timing` and `progress`, which is called after each round; an exception in it cancels the motion.  `progress=True` shows a
progress bar of the package tqdm.

{HEADER}
"""

from __future__ import annotations

{imports}

class AsyncMotions({", ".join(class_name(name) for name in FAMILIES)}):
    """All motions."""
'''


def blocking_file(document: dict) -> str:
    lines = "".join(f"    {name} = blocking(AsyncMotions.{name})\n" for name in map(python_name, motions_of(document)))
    return f'''"""The motions of a marker as blocking calls.  See AsyncMotions.

{HEADER}
"""

from __future__ import annotations

from ..wire.portal import Blocking, blocking
from . import AsyncMotions


class BlockingMotions(Blocking):
{lines}'''


def files(document: dict) -> dict[str, str]:
    """The contents of all generated files, by their names in selvage_client/motions."""
    return {"__init__.py": package_file(), "blocking.py": blocking_file(document),
            **{f"{name}.py": family_file(name, document) for name in FAMILIES}}
