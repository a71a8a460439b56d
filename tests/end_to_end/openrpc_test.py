#!/usr/bin/env python3
"""The golden exchanges against the daemon's own description: python3 openrpc_test.py SELVAGED GOLDEN_FOLDER.

Every parameter of a call that succeeds, and every field of what it answers, is one that rpc.discover tells, of the
schema it tells; a required one is there.  The description itself is what OpenRPC 1.2.6 requires of one.
"""
import json
import pathlib
import subprocess
import sys
import tempfile

import jsonschema


def answers(selvaged, calls):
    with tempfile.NamedTemporaryFile("w", suffix=".json") as file:
        json.dump(calls, file)
        file.flush()
        told = subprocess.run([selvaged, "--check", file.name, "--log-level", "off"], capture_output=True, text=True)
    return [json.loads(line) for line in told.stdout.splitlines()]


def check_value(document, schema, value, where):
    rooted = dict(schema, components=document["components"])
    for mistake in jsonschema.Draft7Validator(rooted).iter_errors(value):
        yield f"{where}{list(mistake.absolute_path)}: {mistake.message}"


def check_params(document, method, params):
    words = {param["name"]: param for param in method["params"]}
    for name, word in words.items():
        if word["required"] and name not in params:
            yield f"{method['name']}: {name} is required, yet the call succeeded without it"
    for name, value in params.items():
        if name in words:
            yield from check_value(document, words[name]["schema"], value, f"{method['name']}/{name}")
        else:
            yield f"{method['name']}: nothing tells of the parameter {name}"


def check_result(document, method, result):
    schema = method["result"]["schema"]
    for name in set(result) - set(schema["properties"]):
        yield f"{method['name']}: nothing tells of the result {name}"
    yield from check_value(document, schema, result, method["name"])


def check_document(document):
    for field in ("openrpc", "info", "methods"):
        if field not in document:
            yield f"the description has no {field}"
    for schema in document["components"]["schemas"].values():
        jsonschema.Draft7Validator.check_schema(schema)
    for method in document["methods"]:
        required = [param["required"] for param in method["params"]]
        if required != sorted(required, reverse=True):
            yield f"{method['name']}: an optional parameter stands before a required one"


def main(selvaged, folder):
    discover = {"jsonrpc": "2.0", "id": 1, "method": "rpc.discover"}
    document = answers(selvaged, [discover])[0]["result"]
    methods = {method["name"]: method for method in document["methods"]}
    mistakes = list(check_document(document))
    seen = set()
    for path in sorted(pathlib.Path(folder).glob("*.json")):
        requests = [exchange["request"] for exchange in json.loads(path.read_text())]
        named = [request for request in requests if isinstance(request, dict) and "id" in request]
        told = {json.dumps(answer.get("id")): answer for answer in answers(selvaged, named)}
        for request in named:
            answer = told.get(json.dumps(request["id"]), {})
            if "result" not in answer:
                continue
            method = methods[request["method"]]
            seen.add(request["method"])
            mistakes += check_params(document, method, request.get("params", {}))
            mistakes += check_result(document, method, answer["result"])
    for mistake in mistakes:
        print(mistake)
    print(f"{len(seen)} of {len(methods)} methods seen in the exchanges; not: {sorted(set(methods) - seen)}")
    return 1 if mistakes or len(seen) < 20 else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
