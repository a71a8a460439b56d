#!/usr/bin/env python3
"""Includes follow the arrows clients -> server -> protocol -> core, and the order of the core's own layers; motions of
one piece reach no solver.

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
    "Clp": "core/lp/solver/clp.cpp",
    ("clipper", "polyclipping/"): "core/outline/set_operations.cpp",
    "boost/asio": ("server/", "clients/cpp/"),
    "boost/beast": ("server/transport/connections/http_connection.cpp", "server/transport/websocket_connection."),
    "openssl/": "server/transport/",
    "nlohmann/": ("protocol/", "clients/cpp/"),
    "sqlite3": "server/store/journal_database.cpp",
    "spdlog/": "server/",
    "CLI/": ("server/", "clients/cli/"),
    "CGAL/": (),
}
# Motions that solve no linear program: neither they nor the sources of what they include know more of one than what it
# looks like.  Healing, which comes before them where pieces overlap, is a motion of its own.
WITHOUT_PROGRAMS = ["bump", "gap", "leap", "place", "relax", "slide"]
MAY_KNOW = "core/lp/linear_program.h"
HEALING = "core/motion/repair/repair.cpp"
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


def reached(root, source):
    """All that a source includes, and their sources, with what led to each."""
    led = {source: None}
    ahead = [source]
    while ahead:
        name = ahead.pop()
        path = root / name
        if name == HEALING or not path.is_file():
            continue
        for included in INCLUDE.findall(path.read_text(encoding="utf-8")):
            for found in (included, str(pathlib.PurePosixPath(included).with_suffix(".cpp"))):
                if found not in led:
                    led[found] = name
                    ahead.append(found)
    return led


def programs_reached(root):
    found = []
    for motion in WITHOUT_PROGRAMS:
        source = f"core/motion/{motion}.cpp"
        if not (root / source).is_file():
            found.append(f"{source}: is not where it was")
        for name, by in sorted(reached(root, source).items()):
            inside = by is not None and by.startswith("core/lp/")
            if re.fullmatch(r"core/lp/.*\.h", name) and name != MAY_KNOW and not inside:
                found.append(f"{source}: solves no program, but reaches {name} through {by}")
    return found


def self_test():
    """A planted fault of each kind is found."""
    planted = {
        "core/geometry/a.h": '#include "core/marker/marker.h"\n',
        "core/motion/b.cpp": '#include "protocol/calls/codec.h"\n',
        "core/lp/c.cpp": "#include <ClpSimplex.hpp>\n",
        "core/marker/d.cpp": "#include <polyclipping/clipper.hpp>\n",
        "protocol/d.cpp": '#include "server/ops/log.h"\n',
        "server/e.cpp": '#include "clients/cli/f.h"\n',
        "server/crew/e.cpp": '#include "server/jobs/job_queue.h"\n',
        "clients/cli/e.cpp": '#include "server/ops/log.h"\n',
        "clients/cpp/f.cpp": '#include "protocol/json/json_text.h"\n',
        "core/base/g.h": "#include <nlohmann/json.hpp>\n",
        "server/store/journal.cpp": "#include <sqlite3.h>\n",
        "elsewhere/h.h": "",
    }
    reaching = {f"core/motion/{motion}.cpp": "" for motion in WITHOUT_PROGRAMS if motion != "slide"} | {
        "core/motion/piece/bump.cpp": '#include "core/scene/scene.h"\n#include "core/motion/repair/repair.h"\n',
        "core/motion/repair/repair.cpp": '#include "core/lp/interior_point/interior_point.h"\n',
        "core/motion/placing/place.cpp": '#include "core/motion/repair/repair.h"\n#include "core/lp/linear_program.h"\n',
        "core/scene/scene.h": "",
        "core/scene/scene.cpp": '#include "core/lp/solver/solve.h"\n',
    }
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        for name, text in (planted | reaching).items():
            path = root / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
        found = faults(root)
        for name in planted:
            expected = 0 if name.startswith("elsewhere") else 1
            assert sum(f.startswith(name + ":") for f in found) == expected, (name, found)
        assert programs_reached(root) == [
            "core/motion/piece/bump.cpp: solves no program, but reaches core/lp/solver/solve.h through core/scene/scene.cpp",
            "core/motion/piece/slide.cpp: is not where it was",
        ], programs_reached(root)


if __name__ == "__main__":
    if sys.argv[1:] == ["--self-test"]:
        self_test()
        sys.exit(0)
    list_of_faults = faults(pathlib.Path(sys.argv[1])) + programs_reached(pathlib.Path(sys.argv[1]))
    print("\n".join(list_of_faults) or "all includes follow the layers")
    sys.exit(1 if list_of_faults else 0)
