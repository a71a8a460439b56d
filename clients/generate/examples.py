"""An example of each method for protocol/openrpc.json: requests of the golden exchanges (tests/golden/rpc), as this daemon
answers them, or as the exchange has it where only a connection that stays open is answered.  The same request gives the same
answer, so the file changes only when the daemon does."""
from __future__ import annotations

import json
import pathlib
import subprocess
import tempfile


def answers(selvaged: str, calls: list[dict]) -> dict[str, dict]:
    """What a fresh daemon answers to the calls, by their ids."""
    with tempfile.NamedTemporaryFile("w", suffix=".json") as file:
        json.dump(calls, file)
        file.flush()
        ran = subprocess.run([selvaged, "--check", file.name, "--log-level", "off"], capture_output=True, text=True)
    return {json.dumps(answer.get("id")): answer for answer in map(json.loads, ran.stdout.splitlines())}


def exchanges(selvaged: str, folder: pathlib.Path) -> list[tuple[dict, dict]]:
    """The requests that succeed, and their results."""
    pairs = []
    for path in sorted(folder.glob("*.json")):
        held = [exchange for exchange in json.loads(path.read_text("utf-8"))
                if isinstance(exchange.get("request"), dict) and "id" in exchange["request"]]
        known = answers(selvaged, [exchange["request"] for exchange in held])
        for exchange in held:
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


def length(example: dict) -> tuple[bool, int]:
    """The shorter the better; but first those in which something moves."""
    return example["result"]["value"].get("placements") == [], len(json.dumps(example))


def with_examples(document: dict, selvaged: str, folder: pathlib.Path) -> dict:
    """The document with the shortest exchange of each method.  What describes the daemon itself has none."""
    known = exchanges(selvaged, folder)
    methods = []
    for method in document["methods"]:
        of_method = [pairing(request, result) for request, result in known if request["method"] == method["name"]
                     and not method["name"].startswith(("engine.", "rpc."))]
        shortest = sorted(of_method, key=length)[:1]
        methods.append(method | ({"examples": shortest} if shortest else {}))
    return document | {"methods": methods}


def without_examples(document: dict) -> dict:
    methods = [{name: value for name, value in method.items() if name != "examples"} for method in document["methods"]]
    return document | {"methods": methods}
