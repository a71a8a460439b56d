"""Examples of the methods for protocol/openrpc.json.

They are requests of the golden exchanges (tests/golden/rpc) with the answers of this daemon.  Where a call only works on a
connection that stays open, the answer is the recorded one.  The same request always gets the same answer, so the file
changes only when the daemon does.
"""
from __future__ import annotations

import json
import pathlib
import subprocess
import tempfile


def answers(selvaged: str, calls: list[dict]) -> dict[str, dict]:
    """The answers of a fresh daemon to the calls, by call id."""
    with tempfile.NamedTemporaryFile("w", suffix=".json") as file:
        json.dump(calls, file)
        file.flush()
        ran = subprocess.run([selvaged, "--check", file.name, "--log-level", "off"], capture_output=True, text=True)
    return {json.dumps(answer.get("id")): answer for answer in map(json.loads, ran.stdout.splitlines())}


def exchanges(selvaged: str, folder: pathlib.Path) -> list[tuple[dict, dict]]:
    """All requests that succeed, with their results."""
    pairs = []
    for path in sorted(folder.glob("*.json")):
        calls = [exchange for exchange in json.loads(path.read_text("utf-8"))
                 if isinstance(exchange.get("request"), dict) and "id" in exchange["request"]]
        known = answers(selvaged, [exchange["request"] for exchange in calls])
        for exchange in calls:
            request = exchange["request"]
            answer = known.get(json.dumps(request["id"]), {})
            if "result" not in answer and "$any" not in json.dumps(exchange["response"]):
                answer = exchange["response"]
            if "result" in answer:
                pairs.append((request, answer["result"]))
    return pairs


def pairing(request: dict, result: dict) -> dict:
    return {"name": request["method"],
            "params": [{"name": name, "value": value} for name, value in request.get("params", {}).items()],
            "result": {"name": "result", "value": result}}


def preference(example: dict) -> tuple[bool, int]:
    """A sort key that prefers examples in which a piece moves, then short ones."""
    return example["result"]["value"].get("placements") == [], len(json.dumps(example))


def with_examples(document: dict, selvaged: str, folder: pathlib.Path) -> dict:
    """Adds the preferred exchange of each method to the document, except for methods that describe the daemon itself."""
    known = exchanges(selvaged, folder)
    methods = []
    for method in document["methods"]:
        of_method = [pairing(request, result) for request, result in known if request["method"] == method["name"]
                     and not method["name"].startswith(("engine.", "rpc."))]
        chosen = sorted(of_method, key=preference)[:1]
        methods.append(method | ({"examples": chosen} if chosen else {}))
    return document | {"methods": methods}


def without_examples(document: dict) -> dict:
    methods = [{name: value for name, value in method.items() if name != "examples"} for method in document["methods"]]
    return document | {"methods": methods}
