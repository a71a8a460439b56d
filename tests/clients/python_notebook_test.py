#!/usr/bin/env python3
"""What a notebook shows for objects of the Python client, and the errors when a package is missing.

usage: python_notebook_test.py SELVAGED
"""
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import types
import unittest
from unittest import mock

from live_daemon import SQUARES, LiveDaemon

import selvage_client
from selvage_client import spyrrow

SELVAGED = sys.argv.pop(1) if len(sys.argv) > 1 else "selvaged"
ROOT = pathlib.Path(__file__).resolve().parents[2]
ELL = [(0.0, 0.0), (40.0, 0.0), (40.0, 15.0), (15.0, 15.0), (15.0, 40.0), (0.0, 40.0)]


def without(*modules):
    """Makes imports fail as if the packages were not installed."""
    return mock.patch.dict(sys.modules, {module: None for module in modules})


class Bar:
    """A stand-in for tqdm.auto.tqdm."""

    made = []

    def __init__(self, **_):
        self.n, self.texts, self.open = 0, [], True
        Bar.made.append(self)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.open = False

    def set_postfix_str(self, text, refresh):
        self.texts.append(text)

    def update(self, count):
        self.n += count


class Shown(unittest.TestCase):
    def setUp(self):
        self.daemon = self.enterContext(LiveDaemon(SELVAGED))
        self.client = self.enterContext(selvage_client.Client(self.daemon.address))
        self.marker = self.client.open(SQUARES)

    def test_representations(self):
        self.assertEqual(repr(self.client), f"<Client of {self.daemon.address}>")
        self.assertEqual(repr(self.marker), f"<Marker m1 at revision 1, {self.daemon.address}>")
        self.assertIn("at revision unknown", repr(self.client.marker("m7")))

    def test_a_marker_is_drawn_until_it_is_closed(self):
        self.assertTrue(self.marker._repr_svg_().startswith("<svg"))
        self.marker.close()
        self.assertIsNone(self.marker._repr_svg_())

    def test_a_result_is_shown_without_its_placements(self):
        moved = self.marker.compact()
        self.assertTrue(moved.placements)
        self.assertNotIn("placements", repr(moved))
        self.assertIn("length_after=80.0", repr(moved))

    def test_a_nested_marker_is_drawn(self):
        found = selvage_client.nest([ELL], 60, moves=50, address=self.daemon.address)
        self.assertTrue(found._repr_svg_().startswith("<svg"))
        self.assertLess(len(repr(found)), 300)

    def test_a_bar_follows_the_rounds_and_ends(self):
        module = types.ModuleType("tqdm.auto")
        module.tqdm = Bar
        with mock.patch.dict(sys.modules, {"tqdm": types.ModuleType("tqdm"), "tqdm.auto": module}):
            moved = self.marker.compact(progress=True)
        self.assertIn(Bar.made[-1].n, range(1, moved.rounds + 1))  # the last rounds may be reported after the answer
        self.assertRegex(Bar.made[-1].texts[-1], r"^length 8\d\.\d\d$")
        self.assertFalse(Bar.made[-1].open)
        self.marker.undo()
        self.assertEqual(self.marker.compact(progress=False).length_after, 80)

    def test_a_missing_package_is_named_with_what_installs_it(self):
        outlines = self.marker.outlines()
        uses = {"tqdm.auto": (lambda: self.marker.compact(progress=True), "progress"),
                "shapely.geometry": (outlines.polygons, "outlines"),
                "numpy": (outlines.arrays, "outlines"),
                "matplotlib": (lambda: selvage_client.draw(outlines), "drawing"),
                "selvage_engine": (lambda: selvage_client.Client("engine:").info(), "engine")}
        for module, (use, extra) in uses.items():
            with without(module), self.assertRaises(selvage_client.MissingExtra) as missing:
                use()
            self.assertIsInstance(missing.exception, ImportError)
            self.assertIn(f"pip install 'selvage-client[{extra}]'", str(missing.exception))
            self.assertIn(module, str(missing.exception))
        self.assertEqual(self.marker.check().revision, 1)  # no motion was started

    def test_a_solution_of_spyrrow_becomes_a_marker_and_back(self):
        instance = spyrrow.StripPackingInstance("ells", 60, [spyrrow.Item("ell", [*ELL, ELL[0]], 2, None)])
        loose = spyrrow.StripPackingSolution(
            160, 0.2, [spyrrow.PlacedItem("ell", (0.0, 0.0), 0), spyrrow.PlacedItem("ell", (150.0, 50.0), 180)])
        with self.client.open(spyrrow.marker(instance, loose, separation=1)) as marker:
            moved = marker.compact()
            shorter = spyrrow.solution(marker.get(format="native").marker)
        self.assertLess(moved.length_after, 160)
        self.assertAlmostEqual(shorter.width, moved.length_after, places=6)
        self.assertAlmostEqual(shorter.density, moved.utilisation_after, places=6)
        self.assertEqual([piece.rotation for piece in shorter.placed_items], [0, 180])
        with self.assertRaisesRegex(ValueError, "flipped"):
            spyrrow.solution(SQUARES | {"pieces": [SQUARES["pieces"][0] | {"flip": True}]})

    def test_a_solution_of_sparrow_is_opened_as_it_is(self):
        sparrow = {"name": "squares", "strip_height": 100.0, "items": [
            {"id": 0, "demand": 2, "dxf": "", "allowed_orientations": [0.0],
             "shape": {"type": "simple_polygon", "data": SQUARES["shapes"][0]["outline"]}}],
            "solution": {"strip_width": 90.0, "density": 0.3, "run_time_sec": 1, "layout": {
                "container_id": 0, "density": 0.3, "placed_items": [
                    {"item_id": 0, "transformation": {"rotation": 0.0, "translation": at}} for at in ([0.0, 0.0], [50.0, 10.0])]}}}
        with self.client.open(sparrow) as marker:
            self.assertEqual(marker.compact().length_after, 80)
            self.assertEqual(len(marker.get(format="sparrow").marker["solution"]["layout"]["placed_items"]), 2)


class Package(unittest.TestCase):
    def test_the_version_is_that_of_the_project(self):
        project = (ROOT / "CMakeLists.txt").read_text("utf-8")
        version = re.search(r"project\(selvage VERSION ([0-9.]+)", project).group(1)
        self.assertEqual(selvage_client.__version__, version)
        for text in ((ROOT / "clients/engine/pyproject.toml").read_text("utf-8"),
                     (ROOT / "clients/typescript/package.json").read_text("utf-8")):
            self.assertIn(version, text)

    def test_arrays_work_with_numpy_1_and_numpy_2(self):
        import numpy

        outline = selvage_client.Outline("a", ((0.0, 0.0), (1.0, 0.0), (0.0, 1.0)))
        self.assertEqual(numpy.asarray(outline).shape, (3, 2))
        self.assertEqual(outline.__array__(copy=True).dtype, numpy.float64)
        with self.assertRaises(ValueError):
            outline.__array__(copy=False)

    @unittest.skipUnless(shutil.which("mypy", path="/usr/bin"), "mypy is not installed")
    def test_an_unknown_choice_is_a_type_error(self):
        with tempfile.TemporaryDirectory() as folder:
            for word, code in (("fine", 0), ("quick", 1)):
                file = pathlib.Path(folder) / f"{word}.py"
                file.write_text("import selvage_client\n\ndef use(marker: selvage_client.Marker) -> None:\n"
                                f"    marker.compact(accuracy={json.dumps(word)})\n")
                done = subprocess.run(["/usr/bin/mypy", "--strict", "--cache-dir", folder, file], capture_output=True,
                                      text=True, env={"MYPYPATH": str(ROOT / "clients/python/src")})
                self.assertEqual(done.returncode, code, done.stdout + done.stderr)


if __name__ == "__main__":
    unittest.main()
