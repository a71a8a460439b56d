#!/usr/bin/env python3
"""The golden exchanges against the daemon's own description: python3 openrpc_test.py SELVAGED GOLDEN_FOLDER.

rpc.discover must describe every parameter of each call that succeeds, and every field of its answer, with its schema;
required ones must be present.  The description itself must be valid OpenRPC 1.2.6, and the examples of
protocol/openrpc.json must be of the types that it describes.
"""
import json
import pathlib
import subprocess
import sys
import tempfile

import jsonschema

ROOT = pathlib.Path(__file__).resolve().parents[2]

def answers(selvaged, calls):
    with tempfile.NamedTemporaryFile("w", suffix=".json") as file:
        json.dump(calls, file)
        file.flush()
        finished = subprocess.run([selvaged, "--check", file.name, "--log-level", "off"], capture_output=True, text=True)
    return [json.loads(line) for line in finished.stdout.splitlines()]


def check_value(document, schema, value, where):
    rooted = dict(schema, components=document["components"])
    for error in jsonschema.Draft7Validator(rooted).iter_errors(value):
        yield f"{where}{list(error.absolute_path)}: {error.message}"


def check_params(document, method, params):
    described = {param["name"]: param for param in method["params"]}
    for name, param in described.items():
        if param["required"] and name not in params:
            yield f"{method['name']}: {name} is required, yet the call succeeded without it"
    for name, value in params.items():
        if name in described:
            yield from check_value(document, described[name]["schema"], value, f"{method['name']}/{name}")
        else:
            yield f"{method['name']}: the description lacks the parameter {name}"


def check_result(document, method, result):
    schema = method["result"]["schema"]
    for name in set(result) - set(schema["properties"]):
        yield f"{method['name']}: the description lacks the result {name}"
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
            yield f"{method['name']}: an optional parameter comes before a required one"


def check_examples(document):
    for method in document["methods"]:
        for example in method.get("examples", []):
            yield from check_params(document, method, {param["name"]: param["value"] for param in example["params"]})
            yield from check_result(document, method, example["result"]["value"])


def main(selvaged, folder):
    discover = {"jsonrpc": "2.0", "id": 1, "method": "rpc.discover"}
    document = answers(selvaged, [discover])[0]["result"]
    methods = {method["name"]: method for method in document["methods"]}
    errors = list(check_document(document))
    errors += check_examples(json.loads((ROOT / "protocol" / "openrpc.json").read_text()))
    seen = set()
    for path in sorted(pathlib.Path(folder).glob("*.json")):
        requests = [exchange["request"] for exchange in json.loads(path.read_text())]
        named = [request for request in requests if isinstance(request, dict) and "id" in request]
        finished = {json.dumps(answer.get("id")): answer for answer in answers(selvaged, named)}
        for request in named:
            answer = finished.get(json.dumps(request["id"]), {})
            if "result" not in answer:
                continue
            method = methods[request["method"]]
            seen.add(request["method"])
            errors += check_params(document, method, request.get("params", {}))
            errors += check_result(document, method, answer["result"])
    for error in errors:
        print(error)
    print(f"{len(seen)} of {len(methods)} methods seen in the exchanges; not: {sorted(set(methods) - seen)}")
    return 1 if errors or len(seen) < 20 else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
