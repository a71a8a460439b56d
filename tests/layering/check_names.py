#!/usr/bin/env python3
"""No two types of one qualified name: two definitions in one binary would be undefined behaviour that no compiler
reports.  Types in unnamed namespaces and inside functions do not count.  A type of the product is unique in the whole
tree; one of a test or benchmark also, because tests of several folders are linked into one program.  Namespaces are
named after folders, and no folder has more than MOST_FILES files.

usage: check_names.py ROOT        exit 0: all names are unique; 1: some are not, each named
       check_names.py --self-test
"""
import pathlib
import re
import sys
import tempfile

from sources import TOPS, code_of, sources

MOST_FILES = 15
COUNTED = (".h", ".cpp", ".py", ".ts", ".txt", ".mjs", ".md")
# Folders whose namespace differs from their path: the folders that all others use unqualified, and the C++ client,
# whose users write selvage::client.
NAMESPACE_OF = {"core/base": "selvage", "clients/cpp": "selvage::client"}
# Namespaces whose templates other folders specialise for their own types.
SPECIALISED = {"selvage::protocol::schema"}
TOKEN = re.compile(r"[A-Za-z_]\w*|::|[{};<>()=:,]")
KINDS = ("struct", "class", "union", "enum")


def types_of(code):
    """(qualified name, line) of every type that the code defines at namespace or class scope."""
    tokens = [(match.group(), code.count("\n", 0, match.start()) + 1) for match in TOKEN.finditer(code)]
    scopes = []  # a name, or None for a scope that hides names from other files
    opening = None  # what the next brace opens
    at = 0
    while at < len(tokens):
        word, line = tokens[at]
        if word == "namespace":
            names, ahead = [], at + 1
            while tokens[ahead][0] not in ("{", ";", "="):
                if tokens[ahead][0] != "::":
                    names.append(tokens[ahead][0])
                ahead += 1
            opening = "::".join(names) or None
            at = ahead
            if tokens[at][0] == "{":
                scopes.append(opening)
            opening = None
        elif word in KINDS and not (at and tokens[at - 1][0] in ("<", ",", "enum")):
            ahead = at + 1
            if tokens[ahead][0] in ("class", "struct"):  # enum class
                ahead += 1
            name, ahead = tokens[ahead][0], ahead + 1
            while tokens[ahead][0] == "::":  # a nested type, defined outside its class
                name, ahead = f"{name}::{tokens[ahead + 1][0]}", ahead + 2
            while ahead < len(tokens) and tokens[ahead][0] not in ("{", ";", "(", ")", "=", ">", "}"):
                if tokens[ahead][0] == "<" and tokens[ahead - 1][0] == name:
                    name = None  # a specialisation
                    break
                if tokens[ahead][0] in ("<",):  # template arguments of a base class
                    depth = 1
                    while depth:
                        ahead += 1
                        depth += {"<": 1, ">": -1}.get(tokens[ahead][0], 0)
                ahead += 1
            if name and tokens[ahead][0] == "{" and re.match(r"[A-Za-z_]", name):
                if None not in scopes:
                    yield "::".join([*scopes, name]), line
                scopes.append(name)
                at = ahead
        elif word == "{":
            scopes.append(None)
        elif word == "}" and scopes:
            scopes.pop()
        at += 1


def name_faults(root):
    where = {}
    for name, text in sources(root, (*TOPS, "tests", "bench")):
        for qualified, line in types_of(code_of(text)):
            where.setdefault(qualified, []).append(f"{name}:{line}")
    return [f"{name} is defined {len(places)} times: {', '.join(places)}"
            for name, places in sorted(where.items()) if len(places) > 1]


def namespace_faults(root):
    found = []
    for name, text in sources(root):
        folder = name.rsplit("/", 1)[0]
        path = folder.removeprefix("core/").removeprefix("clients/")
        expected = NAMESPACE_OF.get(folder, "selvage::" + path.replace("/", "::"))
        opened = re.findall(r"^namespace ((?:\w+::)*\w+) \{", code_of(text), re.MULTILINE)
        if opened and expected not in opened and not set(opened) <= SPECIALISED:
            found.append(f"{name}: its folder's namespace is {expected}, but it opens {', '.join(opened)}")
    return found


def size_faults(root):
    found = []
    for top in (*TOPS, "tests", "bench", "docs"):
        for folder in [root / top, *sorted((root / top).rglob("*"))]:
            if not folder.is_dir() or any(part in ("node_modules", "dist", "__pycache__") for part in folder.parts):
                continue
            count = sum(1 for path in folder.iterdir() if path.suffix in COUNTED and path.name != "README.md")
            if count > MOST_FILES:
                found.append(f"{folder.relative_to(root).as_posix()}: {count} files, more than {MOST_FILES}")
    return found


def self_test():
    """Tests that a planted fault of each kind is found, and nothing else."""
    files = {
        "core/motion/place.h": "namespace selvage::motion {\nstruct Place { int x; };\n}\n",
        "server/methods.h": "namespace selvage::motion {\nenum class Place : int { kOne };\n}\n",
        "core/geometry/a.cpp": "namespace selvage::geometry {\nnamespace {\nstruct Local {};\n}\nclass A final : B<C> {\n"
        "  struct Local {};\n};\nvoid f() {\n  struct Local {};\n}\ntemplate <class T>\nstruct A<T*> {};\n}\n",
        "core/geometry/b.cpp": "namespace selvage::geometry {\nnamespace {\nstruct Local {};\n}\nstruct A;\n"
        "void g(struct A* a) {}\n// struct A {};\n}\n",
    }
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        for name, text in files.items():
            path = root / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
        assert name_faults(root) == [
            "selvage::motion::Place is defined 2 times: core/motion/place.h:2, server/methods.h:2"
        ], name_faults(root)
        assert namespace_faults(root) == [
            "server/methods.h: its folder's namespace is selvage::server, but it opens selvage::motion"
        ], namespace_faults(root)
        for k in range(MOST_FILES):
            (root / f"core/geometry/x{k}.h").write_text("", encoding="utf-8")
        assert size_faults(root) == [f"core/geometry: {MOST_FILES + 2} files, more than {MOST_FILES}"]


if __name__ == "__main__":
    if sys.argv[1:] == ["--self-test"]:
        self_test()
        sys.exit(0)
    tree = pathlib.Path(sys.argv[1])
    list_of_faults = name_faults(tree) + namespace_faults(tree) + size_faults(tree)
    print("\n".join(list_of_faults) or "every type has a name of its own, and every folder is small")
    sys.exit(1 if list_of_faults else 0)
