#!/usr/bin/env python3
"""Includes follow the arrows clients -> server -> protocol -> core, and the order of the core's own layers.

usage: check_includes.py ROOT        exit 0: all includes follow; 1: some do not, each named
       check_includes.py --self-test
"""
import pathlib
import re
import sys
import tempfile

# A folder, and the folders it may include from besides itself.
CORE = ["core/base", "core/geometry", "core/minkowski", "core/marker", "core/lp", "core/model", "core/motion"]
ALLOWED = {
    "core/base": [],
    "core/geometry": ["core/base"],
    "core/minkowski": ["core/base", "core/geometry"],
    "core/marker": ["core/base", "core/geometry", "core/minkowski"],
    "core/lp": ["core/base"],
    "core/model": ["core/base", "core/geometry", "core/minkowski", "core/marker", "core/lp"],
    "core/motion": CORE,
    "protocol": CORE,
    "server/crew": ["core/base"],
    "server": CORE + ["protocol", "server/crew"],
    "clients/cpp": [],
    "clients/cli": CORE + ["protocol", "server/crew", "clients/cpp"],
}
# Libraries that only one place may see.
ONLY_IN = {
    "Clp": "core/lp/clp.cpp",
    ("clipper", "polyclipping/"): "core/geometry/set_operations.cpp",
    "boost/asio": ("server/", "clients/cpp/"),
    "boost/beast": ("server/transport/http_connection.cpp", "server/transport/websocket_connection."),
    "openssl/": "server/transport/",
    "nlohmann/": ("protocol/", "clients/cpp/"),
    "sqlite3": "server/journal_database.cpp",
    "spdlog/": "server/",
    "CLI/": ("server/", "clients/cli/"),
    "CGAL/": (),
}
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', re.MULTILINE)


def faults(root):
    found = []
    for path in sorted(p for top in ("core", "protocol", "server", "clients") for p in (root / top).rglob("*")):
        if path.suffix not in (".h", ".cpp"):
            continue
        name = path.relative_to(root).as_posix()
        home = next((folder for folder in ALLOWED if name.startswith(folder + "/")), None)
        if home is None:
            found.append(f"{name}: in no known layer")
            continue
        for included in INCLUDE.findall(path.read_text(encoding="utf-8")):
            layer = next((folder for folder in ALLOWED if included.startswith(folder + "/")), None)
            if layer and layer != home and layer not in ALLOWED[home]:
                found.append(f"{name}: {home} may not include {included}")
            if included.startswith(("tests/", "bench/")):
                found.append(f"{name}: includes {included}")
            for library, places in ONLY_IN.items():
                if included.startswith(library) and not name.startswith(places or "-"):
                    found.append(f"{name}: may not see {included}")
    return found


def self_test():
    """A planted fault of each kind is found."""
    planted = {
        "core/geometry/a.h": '#include "core/marker/marker.h"\n',
        "core/motion/b.cpp": '#include "protocol/codec.h"\n',
        "core/lp/c.cpp": "#include <ClpSimplex.hpp>\n",
        "core/marker/d.cpp": "#include <polyclipping/clipper.hpp>\n",
        "protocol/d.cpp": '#include "server/log.h"\n',
        "server/e.cpp": '#include "clients/cli/f.h"\n',
        "server/crew/e.cpp": '#include "server/job_queue.h"\n',
        "clients/cli/e.cpp": '#include "server/log.h"\n',
        "clients/cpp/f.cpp": '#include "protocol/json_text.h"\n',
        "core/base/g.h": "#include <nlohmann/json.hpp>\n",
        "server/journal.cpp": "#include <sqlite3.h>\n",
        "elsewhere/h.h": "",
    }
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        for name, text in planted.items():
            path = root / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
        found = faults(root)
        for name in planted:
            expected = 0 if name.startswith("elsewhere") else 1
            assert sum(f.startswith(name + ":") for f in found) == expected, (name, found)


if __name__ == "__main__":
    if sys.argv[1:] == ["--self-test"]:
        self_test()
        sys.exit(0)
    list_of_faults = faults(pathlib.Path(sys.argv[1]))
    print("\n".join(list_of_faults) or "all includes follow the layers")
    sys.exit(1 if list_of_faults else 0)
