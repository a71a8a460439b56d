#!/usr/bin/env python3
"""Regenerates what follows from the table of methods: generate.py SELVAGED [--check].

The daemon describes itself (rpc.discover).  This description determines the motions and enumerations of the Python client,
the functions of the engine in Python, the types of the TypeScript client (clients/typescript/scripts/generate.mjs, if node
is installed), the table of calls in protocol/README.md, and protocol/openrpc.json, which is the description with an example
of each method.  With --check nothing is written; the names of stale files are printed, and the exit code is 1 if there are
any.  Examples are not compared then, because another exchange may be shorter now.
"""
from __future__ import annotations

import json
import pathlib
import shutil
import subprocess
import sys
import tempfile

import calls_table
import examples
import python_client
import python_motions

ROOT = pathlib.Path(__file__).resolve().parents[2]
PYTHON = ROOT / "clients" / "python" / "src" / "selvage_client"
TYPESCRIPT = ROOT / "clients" / "typescript"
OPENRPC = ROOT / "protocol" / "openrpc.json"
GOLDEN = ROOT / "tests" / "golden" / "rpc"


def discover(selvaged: str) -> dict:
    with tempfile.NamedTemporaryFile("w", suffix=".json") as file:
        json.dump({"jsonrpc": "2.0", "id": 1, "method": "rpc.discover"}, file)
        file.flush()
        answer = subprocess.run([selvaged, "--check", file.name, "--log-level", "off"], capture_output=True, text=True,
                                check=True)
    return json.loads(answer.stdout)["result"]


def typescript(document: dict) -> dict[pathlib.Path, str]:
    """The generated sources of the TypeScript client; none if node is not installed."""
    node = shutil.which("node")
    if not node:
        return {}
    script = 'import("./scripts/generate.mjs").then(({ generate }) => process.stdout.write(JSON.stringify(' \
             'generate(JSON.parse(require("fs").readFileSync(0, "utf8"))))));'
    made = subprocess.run([node, "-e", script], input=json.dumps(document), capture_output=True, text=True, check=True,
                          cwd=TYPESCRIPT)
    return {TYPESCRIPT / "src" / path: text for path, text in json.loads(made.stdout).items()}


def generated(document: dict, selvaged: str) -> dict[pathlib.Path, str]:
    page = ROOT / "protocol" / "README.md"
    files = {
        **{PYTHON / "motions" / name: text for name, text in python_motions.files(document).items()},
        PYTHON / "messages/choices.py": python_client.choices(document),
        ROOT / "clients/engine/selvage_engine/motions.py": python_client.engine_motions(document),
        PYTHON / "messages/motion_results.py": python_client.motion_results(document),
        OPENRPC: json.dumps(examples.with_examples(document, selvaged, GOLDEN), indent=1) + "\n",
        page: calls_table.with_table(page.read_text("utf-8"), document),
    }
    files.update(typescript(document))
    return files


def is_fresh(path: pathlib.Path, text: str, checking: bool) -> bool:
    if not path.exists():
        return False
    if checking and path == OPENRPC:
        return examples.without_examples(json.loads(path.read_text("utf-8"))) == examples.without_examples(json.loads(text))
    return path.read_text("utf-8") == text


def main(selvaged: str, *options: str) -> int:
    checking = "--check" in options
    stale = {path: text for path, text in generated(discover(selvaged), selvaged).items()
             if not is_fresh(path, text, checking)}
    for path, text in stale.items():
        if checking:
            print(f"{path.relative_to(ROOT)} is stale: run ./dev generate")
        else:
            path.parent.mkdir(exist_ok=True)
            path.write_text(text, "utf-8")
            print(f"wrote {path.relative_to(ROOT)}")
    return 1 if stale and checking else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
