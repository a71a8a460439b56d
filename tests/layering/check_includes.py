#!/usr/bin/env python3
"""Includes follow the arrows clients -> server -> protocol -> core, and inside them the links of the build: a header uses
what its folder's library links publicly, a source also what it links privately.  No folders depend on each other in a
circle, at any level.  Each third-party library is used only by its adapter.  Motions of one piece use no solver.

usage: check_includes.py ROOT        exit 0: all includes follow; 1: some do not, each named
       check_includes.py --self-test
"""
import pathlib
import re
import sys
import tempfile

from sources import INCLUDE, TOPS, libraries, reachable, sources

# A top folder, and the other top folders that it may use.  The command line runs motions in its own process, so it uses
# the core and the protocol; it talks to a daemon through the C++ client, never through the server's code.
ALLOWED = {
    "core": (),
    "protocol": ("core",),
    "server": ("core", "protocol"),
    "clients/cpp": (),
    "clients/cli": ("core", "protocol", "clients/cpp", "clients/engine"),
    "clients/engine": ("core", "protocol"),
}
# Third-party libraries, and the only folders that may use them.
ONLY_IN = {
    "Cbc": ("core/lp/integer/cbc.cpp",),
    "Clp": ("core/lp/solver/clp.cpp",),
    "Eigen/": ("core/lp/",),
    ("clipper", "polyclipping/"): ("core/outline/set_operations.cpp",),
    "boost/asio": ("server/transport/", "server/app/", "clients/cpp/"),
    "boost/beast": (
        "server/transport/connections/http_answers.",
        "server/transport/connections/http_connection.cpp",
        "server/transport/connections/websocket_connection.",
    ),
    "openssl/": ("server/transport/", "clients/cpp/"),
    "pugixml": ("protocol/trade/svg/", "protocol/trade/esicup/"),
    "nlohmann/": ("protocol/", "clients/cpp/"),
    "sqlite3": ("server/store/disk/database.cpp",),
    "zlib": ("server/store/disk/row_checksum.cpp",),
    "spdlog/": ("server/",),
    "CLI/": ("server/app/options.cpp", "clients/cli/command_line/parse.cpp"),
    "pybind11/": ("clients/engine/module.cpp",),
    "CGAL/": (),
}
# Motions that solve no linear program: neither they nor the sources of what they include may use more than the data
# types of linear programs.  The repair of overlaps, which runs first if pieces overlap, is a separate motion.
WITHOUT_PROGRAMS = [
    "core/motion/piece/bump",
    "core/motion/piece/relax",
    "core/motion/piece/slide",
    "core/motion/placing/place",
    "core/motion/floating/gap",
    "core/motion/separation/leap",
]
MAY_KNOW = "core/lp/linear_program.h"
REPAIR = "core/motion/repair/repair.cpp"


def top_of(name):
    return next((top for top in ALLOWED if name.startswith(top + "/")), None)


def include_faults(root):
    built = libraries(root)
    by_folder = {library.folder: (name, library) for name, library in built.items()}
    found = []
    for name, text in sources(root):
        top = top_of(name)
        if top is None:
            found.append(f"{name}: in no known layer")
            continue
        folder = name.rsplit("/", 1)[0]
        own, library = by_folder.get(folder, (None, None))
        for included in INCLUDE.findall(text):
            if included.startswith(("tests/", "bench/")):
                found.append(f"{name}: includes {included}")
                continue
            target = top_of(included)
            if target and target != top and target not in ALLOWED[top]:
                found.append(f"{name}: {top} may not include {included}")
                continue
            used = by_folder.get(included.rsplit("/", 1)[0], (None, None))[0] if target else None
            if used and library and used != own:
                links = library.public if name.endswith(".h") else library.public + library.private
                if used not in reachable(built, links):
                    kind = "publicly" if name.endswith(".h") else "at all"
                    found.append(f"{name}: includes {included}, but {own} does not link {used} {kind}")
            for prefix, places in ONLY_IN.items():
                if included.startswith(prefix) and not name.startswith(places or ("-",)):
                    found.append(f"{name}: may not see {included}")
    return found


def folder_arrows(root):
    """The includes between folders."""
    arrows = set()
    for name, text in sources(root):
        for included in INCLUDE.findall(text):
            if included.startswith(tuple(top + "/" for top in TOPS)):
                arrows.add((name.rsplit("/", 1)[0], included.rsplit("/", 1)[0]))
    return {(a, b) for a, b in arrows if a != b}


def circles(arrows):
    """Circles among the folders that share a parent, each with its subfolders; the parent's own files count as one folder."""
    levels = {}
    for a, b in arrows:
        first, second = a.split("/"), b.split("/")
        common = 0
        while common < min(len(first), len(second)) and first[common] == second[common]:
            common += 1
        parent = "/".join(first[:common])

        def child(parts, at=common):
            return parts[at] if len(parts) > at else "(its own files)"

        levels.setdefault(parent, set()).add((child(first), child(second)))
    found = []
    for parent, pairs in sorted(levels.items()):
        ahead = {}
        for a, b in pairs:
            ahead.setdefault(a, set()).add(b)

        def leads_back(start, ahead=ahead):
            seen, stack = set(), list(ahead.get(start, ()))
            while stack:
                node = stack.pop()
                if node == start:
                    return True
                if node not in seen:
                    seen.add(node)
                    stack += ahead.get(node, ())
            return False

        inside = sorted(node for node in ahead if leads_back(node))
        if inside:
            found.append(f"{parent or '.'}: folders depend on each other in a circle: {', '.join(inside)}")
    return found


def reached(root, source):
    """All headers that a source includes, and their sources, each with the file that led to it."""
    led = {source: None}
    ahead = [source]
    while ahead:
        name = ahead.pop()
        path = root / name
        if name == REPAIR or not path.is_file():
            continue
        for included in INCLUDE.findall(path.read_text(encoding="utf-8")):
            for found in (included, str(pathlib.PurePosixPath(included).with_suffix(".cpp"))):
                if found not in led:
                    led[found] = name
                    ahead.append(found)
    return led


def program_faults(root):
    found = []
    for motion in WITHOUT_PROGRAMS:
        source = f"{motion}.cpp"
        if not (root / source).is_file():
            found.append(f"{source}: no such file; has the motion moved?")
        for name, by in sorted(reached(root, source).items()):
            inside = by is not None and by.startswith("core/lp/")
            if re.fullmatch(r"core/lp/.*\.h", name) and name != MAY_KNOW and not inside:
                found.append(f"{source}: solves no program, but reaches {name} through {by}")
    return found


def faults(root):
    return include_faults(root) + circles(folder_arrows(root)) + program_faults(root)


def write(root, files):
    for name, text in files.items():
        path = root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")


def self_test():
    """Tests that a planted fault of each kind is found."""
    cmake = {
        "core/base/CMakeLists.txt": "selvage_library(core_base SOURCES a.cpp)\n",
        "core/geometry/CMakeLists.txt": "selvage_library(core_geometry PUBLIC core_base)\n",
        "core/marker/CMakeLists.txt": "selvage_library(core_marker PUBLIC core_geometry PRIVATE core_lp)\n",
        "core/lp/CMakeLists.txt": "selvage_library(core_lp SOURCES a.cpp)\n",
    }
    allowed = {
        "core/marker/good.h": '#include "core/base/id.h"\n#include "core/geometry/a.h"\n',
        "core/marker/good.cpp": '#include "core/lp/a.h"\n',
        "clients/cli/good.cpp": '#include "protocol/a.h"\n#include "core/base/id.h"\n',
    }
    planted = {
        "core/geometry/a.h": '#include "core/marker/marker.h"\n',
        "core/marker/private.h": '#include "core/lp/a.h"\n',
        "core/geometry/b.cpp": '#include "protocol/codec.h"\n',
        "core/lp/c.cpp": "#include <ClpSimplex.hpp>\n",
        "core/marker/d.cpp": "#include <polyclipping/clipper.hpp>\n",
        "protocol/d.cpp": '#include "server/log.h"\n',
        "server/e.cpp": '#include "clients/cli/f.h"\n',
        "clients/cli/e.cpp": '#include "server/log.h"\n',
        "clients/cpp/f.cpp": '#include "protocol/json_text.h"\n',
        "core/base/g.h": "#include <nlohmann/json.hpp>\n",
        "server/journal.cpp": "#include <sqlite3.h>\n",
        "server/t.cpp": '#include "tests/a.h"\n',
    }
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        write(root, cmake | allowed | planted)
        found = include_faults(root)
        for name in planted:
            assert sum(f.startswith(name + ":") for f in found) == 1, (name, found)
        assert len(found) == len(planted), found

    circle = {
        "core/a/x/one.h": '#include "core/b/two.h"\n',
        "core/b/two.h": '#include "core/a/y/three.h"\n',
        "core/a/y/three.h": "",
        "core/c/own.h": '#include "core/c/inner/part.h"\n',
        "core/c/inner/part.h": "",
    }
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        write(root, circle)
        assert circles(folder_arrows(root)) == ["core: folders depend on each other in a circle: a, b"]

    reaching = {f"{motion}.cpp": "" for motion in WITHOUT_PROGRAMS if not motion.endswith("slide")} | {
        "core/motion/piece/bump.cpp": '#include "core/scene/scene.h"\n#include "core/motion/repair/repair.h"\n',
        REPAIR: '#include "core/lp/interior_point/interior_point.h"\n',
        "core/motion/placing/place.cpp": '#include "core/motion/repair/repair.h"\n#include "core/lp/linear_program.h"\n',
        "core/scene/scene.h": "",
        "core/scene/scene.cpp": '#include "core/lp/solver/solve.h"\n',
    }
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        write(root, reaching)
        assert program_faults(root) == [
            "core/motion/piece/bump.cpp: solves no program, but reaches core/lp/solver/solve.h through "
            "core/scene/scene.cpp",
            "core/motion/piece/slide.cpp: no such file; has the motion moved?",
        ], program_faults(root)


if __name__ == "__main__":
    if sys.argv[1:] == ["--self-test"]:
        self_test()
        sys.exit(0)
    list_of_faults = faults(pathlib.Path(sys.argv[1]))
    print("\n".join(list_of_faults) or "all includes follow the layers")
    sys.exit(1 if list_of_faults else 0)
