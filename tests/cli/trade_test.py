#!/usr/bin/env python3
"""selvage convert on trade files.  An independent reader, ezdxf, judges the DXF that it writes.

usage: trade_test.py SELVAGE EXAMPLES
"""
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

try:
    import ezdxf
except ImportError:
    ezdxf = None

SELVAGE, EXAMPLES = sys.argv[1], pathlib.Path(sys.argv[2])
JUDGE = EXAMPLES.parents[1] / "tests/judge/judge_layout.py"


def run(*arguments):
    return subprocess.run([SELVAGE, *map(str, arguments)], capture_output=True, text=True)


class Convert(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def path(self, name):
        return pathlib.Path(self.folder.name) / name

    def convert(self, source, target, *options):
        ran = run("convert", source, target, *options)
        self.assertEqual(ran.returncode, 0, ran.stderr)
        return ran

    def test_every_example_is_written_in_every_format(self):
        for source in sorted([*EXAMPLES.glob("*.dxf"), *EXAMPLES.glob("*.cut")]):
            for suffix in ("json", "svg", "dxf", "cut", "plt", "pdf", "xml"):
                self.convert(source, self.path("out." + suffix))
            self.convert(source, self.path("tiles.pdf"), "--format", "pdf_tiles")
            self.convert(source, self.path("report.pdf"), "--format", "report")

    def test_a_nest_of_a_compacted_marker_reads_back_the_same(self):
        marker, nest, back = self.path("m.json"), self.path("m.dxf"), self.path("b.json")
        ran = run("compact", EXAMPLES / "polypattern_like.dxf", "-o", marker)
        self.assertEqual(ran.returncode, 0, ran.stderr)
        self.convert(marker, nest)
        self.convert(nest, back)
        before, after = json.loads(marker.read_text()), json.loads(back.read_text())
        for field in ("strip", "unit", "resolution"):
            self.assertEqual(before[field], after[field])
        for key in ("id", "shape", "at"):
            self.assertEqual([p[key] for p in before["pieces"]], [p[key] for p in after["pieces"]])
        self.assertEqual([s["outline"] for s in before["shapes"]], [s["outline"] for s in after["shapes"]])

    @unittest.skipIf(ezdxf is None, "ezdxf is not installed")
    def test_the_auditor_of_ezdxf_finds_nothing_and_agrees_on_every_outline(self):
        for name in ("accumark_like_nest.dxf", "polypattern_like.dxf", "gemini_like.cut"):
            nest, outlines = self.path("n.dxf"), self.path("o.json")
            self.convert(EXAMPLES / name, nest)
            self.convert(EXAMPLES / name, outlines, "--format", "outlines")
            document = ezdxf.readfile(nest)
            auditor = document.audit()
            # Versions before 1.0 miss the owner that R12 gives to no SEQEND.
            fixes = [fix.message for fix in auditor.fixes if "SEQEND" not in fix.message]
            self.assertEqual((auditor.errors, fixes), ([], []))
            expected = json.loads(outlines.read_text())["pieces"]
            inserts = list(document.modelspace().query("INSERT"))
            self.assertEqual(len(inserts), len(expected))
            for insert, piece in zip(inserts, expected):
                self.assertEqual(insert.get_attrib_text("PIECE"), piece["id"])
                boundary = next(e for e in insert.virtual_entities() if e.dxf.layer == "1" and e.dxftype() == "POLYLINE")
                found = sorted((round(p.x, 4), round(p.y, 4)) for p in boundary.points())
                self.assertEqual(found, sorted((round(x, 4), round(y, 4)) for x, y in piece["outline"]))

    def test_notes_of_the_same_text_are_printed_once_with_their_number(self):
        ran = self.convert(EXAMPLES / "accumark_like_nest.dxf", self.path("o.json"))
        notes = [re.sub(r"/line/\d+: ", "", line) for line in ran.stderr.splitlines()]
        self.assertEqual(len(notes), len(set(notes)), ran.stderr)
        self.assertIn("a half piece, unfolded about its mirror line (3 times)", ran.stderr)

    def test_unplaced_pieces_that_a_format_cannot_list_are_noted(self):
        source = self.path("m.json")
        self.convert(EXAMPLES / "polypattern_like.dxf", source)
        marker = json.loads(source.read_text())
        marker["unplaced"] = [{key: value for key, value in marker["pieces"].pop().items() if key in ("id", "shape")}]
        source.write_text(json.dumps(marker))
        for name, noted in (("o.dxf", True), ("o.cut", True), ("o.json", False), ("o.xml", False)):
            ran = self.convert(source, self.path(name))
            self.assertEqual("1 unplaced piece is left out" in ran.stderr, noted, name)

    def test_valid_markers_stay_valid_in_sparrow_and_esicup_files(self):
        coarse = {"resolution": 0.01, "strip": {"width": 60}, "spacing": 0.5, "shapes": [
            {"id": "a", "outline": [[0, 0], [8.3, 0], [8.3, 10.23], [0, 10.23]]},
            {"id": "b", "rotations": [30, 210], "outline": [[0, 0], [17, 0], [17, 30.11], [11.42, 30.11], [11.42, 15.8],
                                                            [4.98, 15.8], [4.98, 30.11], [0, 30.11]]}],
            "pieces": [{"id": "p", "shape": "a", "at": [72.37, 0]},
                       {"id": "q", "shape": "b", "at": [56.82, 35.51], "rotation": 210}]}
        fine = {"resolution": 1e-9, "strip": {"width": 1}, "shapes": [
            {"id": "a", "outline": [[0, 0], [0.2354, 0], [0.2354, 0.3276], [0.21183, 0.3276], [0.21183, 0.15993],
                                    [0.03577, 0.15993], [0.03577, 0.3276], [0, 0.3276]]},
            {"id": "b", "outline": [[0, 0], [0.2151, 0], [0.18093, 0.33]], "flip": True}],
            "pieces": [{"id": "p", "shape": "a", "at": [0, 0]}, {"id": "q", "shape": "a", "at": [0, 0.332199852]},
                       {"id": "r", "shape": "b", "at": [0.234193883, 0.33]},
                       {"id": "s", "shape": "b", "at": [0.234084147, 0.33], "flip": True}]}
        tilted = {"resolution": 1e-7, "strip": {"width": 150}, "shapes": [
            {"id": "a", "tilt_limit": 0.1, "outline": [[17.363, 4.102], [6.2, 17.857], [-1.742, 40.885], [-2.969, 5.717],
                                                       [-17.363, -4.102], [-5.335, -15.363], [1.742, -40.885],
                                                       [6.12, -11.783]]}],
            "pieces": [{"id": "p", "shape": "a", "at": [95.9868428, 102.7537366], "tilt": 0.1},
                       {"id": "q", "shape": "a", "at": [91.6558142, 40.8818974], "tilt": 0.1},
                       {"id": "r", "shape": "a", "at": [70.3673259, 109.1181026], "tilt": 0.1}]}
        for marker, form in ((coarse, "sparrow"), (tilted, "sparrow"), (fine, "esicup"), (tilted, "esicup")):
            source, target = self.path("m.json"), self.path("o." + ("xml" if form == "esicup" else "json"))
            source.write_text(json.dumps({"format": "selvage-marker", "version": 1, **marker}))
            with self.subTest(form=form, width=marker["strip"]["width"]):
                self.assertEqual(run("check", source).returncode, 0)
                self.convert(source, target, "--format", form)
                checked = run("check", target)
                self.assertEqual(checked.returncode, 0, checked.stdout)

    def test_reading_options(self):
        out = self.path("o.json")
        self.convert(EXAMPLES / "richpeace_like.dxf", out, "--rules", EXAMPLES / "richpeace_like.rul", "--sizes", "M,XL", "--width", 1400,
                     "--nap", "either_way")
        marker = json.loads(out.read_text())
        self.assertEqual(len(marker["shapes"]), 2)
        self.assertEqual(marker["strip"]["width"], 1400)
        self.assertEqual(marker["shapes"][0]["rotations"], [0, 180])
        self.convert(EXAMPLES / "polypattern_like.dxf", out, "--rules", EXAMPLES / "polypattern_like.rul", "--order", EXAMPLES / "order.json")
        self.assertEqual(len(json.loads(out.read_text())["pieces"]), 9)

    def test_an_order_gets_the_rules_of_its_cloth(self):
        out = self.path("o.json")
        ran = self.convert(EXAMPLES / "polypattern_like.dxf", out, "--order", EXAMPLES / "order.json", "--rules", EXAMPLES / "polypattern_like.rul",
                           "--margin-below", 12, "--margin-above", 20, "--repeat-along", 64, "--repeat-phase", "10,0", "--shade", 3000,
                           "--zones", '[{"from": [4000, 0], "to": [4040, 1500]}]', "--blocks", '[{"left": 5, "above": 2.5}]')
        self.assertEqual(ran.stderr.count("error"), 0)
        marker = json.loads(out.read_text())
        strip = marker["strip"]
        self.assertEqual((strip["below"], strip["above"], strip["repeat"]), (12, 20, {"along": 64, "phase": [10, 0]}))
        self.assertEqual(marker["shade"], 3000)
        pieces = [piece for piece in marker["pieces"] if "zone" not in piece["rules"]]
        self.assertEqual(len(pieces), len(marker["pieces"]) - 1)
        self.assertEqual({piece["rules"]["shade"] for piece in pieces}, {piece["attributes"]["bundle"] for piece in pieces})
        plain = self.path("p.json")
        self.convert(EXAMPLES / "polypattern_like.dxf", plain, "--order", EXAMPLES / "order.json", "--rules", EXAMPLES / "polypattern_like.rul")
        for block, shape in zip(marker["shapes"], json.loads(plain.read_text())["shapes"]):
            for axis, by in ((0, (-5, 0)), (1, (0, 2.5))):
                was, now = [p[axis] for p in shape["outline"]], [p[axis] for p in block["outline"]]
                self.assertAlmostEqual(min(now), min(was) + by[0], 4)
                self.assertAlmostEqual(max(now), max(was) + by[1], 4)

    def test_patterns_are_laid_on_a_tube(self):
        out, laid = self.path("o.json"), self.path("laid.json")
        self.convert(EXAMPLES / "accumark_like_nest.dxf", out, "--fold", "lay", "--tube", "--width", 700,
                     "--zones", '[{"from": [100, 250], "to": [160, 420], "quality": 2}]',
                     "--piece-rules", '[{"shape": "FRONT/34", "rules": {"quality": 2}}]')
        marker = json.loads(out.read_text())
        self.assertTrue(marker["strip"]["tube"])
        self.assertEqual(len(marker["pieces"]), 3 + 3 + 1)  # a half band and a pair of fronts in each size, and the zone
        self.assertEqual(run("nest", out, "--from-scratch", "--time", 3, "-o", laid).returncode, 0)
        self.assertEqual(run("check", laid).returncode, 0)
        marker = json.loads(laid.read_text())
        folded = [piece for piece in marker["pieces"] if piece.get("rules", {}).get("fold")]
        self.assertEqual(len(folded), 3)
        outlines = self.path("outlines.json")
        self.convert(laid, outlines, "--format", "outlines")
        self.assertEqual(subprocess.run([sys.executable, "-B", JUDGE, outlines], check=False).returncode, 0)

    def test_only_the_rest_of_a_piece_lies_on_cloth_that_its_part_does_not_accept(self):
        plain, out, laid, nest, outlines = map(self.path, ("plain.json", "o.json", "laid.json", "nest.dxf", "outlines.json"))
        source = EXAMPLES / "accumark_like_nest.dxf"
        self.convert(source, plain, "--width", 700)
        front = next(shape for shape in json.loads(plain.read_text())["shapes"] if shape["id"] == "FRONT/34")
        middle = sum(x for x, _ in front["outline"]) / len(front["outline"])
        seen = [point for point in front["outline"] if point[0] > middle]  # three corners
        self.convert(source, out, "--width", 700, "--zones", '[{"from": [200, 0], "to": [500, 700], "quality": 1}]',
                     "--piece-rules", json.dumps([{"shape": "FRONT/34", "rules": {"quality": 1, "part": {"outline": seen}}}]))
        self.assertEqual(run("nest", out, "--from-scratch", "--time", 3, "-o", laid).returncode, 0)
        self.assertEqual(run("check", laid).returncode, 0)
        self.convert(laid, outlines, "--format", "outlines")
        self.assertEqual(subprocess.run([sys.executable, "-B", JUDGE, outlines], check=False).returncode, 0)
        fronts = [piece for piece in json.loads(outlines.read_text())["pieces"] if "part" in piece.get("rules", {})]
        self.assertEqual(len(fronts), 2)
        self.assertTrue(any(x < 500 for piece in fronts for x, _ in piece["outline"]))
        self.convert(laid, nest)
        self.convert(nest, out)
        parts = [piece["rules"]["part"] for piece in json.loads(out.read_text())["pieces"] if "part" in piece.get("rules", {})]
        self.assertEqual(parts, [{"outline": seen, "quality": 0}] * 2)

    def test_rules_that_cannot_be_read_are_refused(self):
        source = EXAMPLES / "gemini_like.cut"
        for option, value, code, reason in (("--zones", "[[1, 2]]", 3, "/zones/0"), ("--zones", "[", 3, "syntax"), ("--margin-below", "-1", 2, "range"),
                                            ("--piece-rules", '[{"shape": "none", "rules": {}}]', 3, "no piece"), ("--nap-direction", "left", 2, "up_and_down")):
            ran = run("convert", source, self.path("x.json"), option, value)
            self.assertEqual((ran.returncode, reason in ran.stderr), (code, True), ran.stderr)

    def test_the_travel_of_the_knife_is_reported(self):
        self.assertIn("the knife travels", self.convert(EXAMPLES / "gemini_like.cut", self.path("k.cut")).stderr)

    def test_unreadable_files_are_refused_with_a_reason(self):
        self.path("no.dxf").write_text("0\nSECTION\n2\nENTITIES\n0\nENDSEC\n0\nEOF\n")
        ran = run("convert", self.path("no.dxf"), self.path("x.json"))
        self.assertEqual(ran.returncode, 3)
        self.assertIn("no pattern file: it has no block with a boundary", ran.stderr)

    def test_one_output_with_a_known_suffix_is_required(self):
        source = EXAMPLES / "gemini_like.cut"
        for arguments in ([], [self.path("a.json"), "-o", self.path("b.json")], [self.path("a.unknown")]):
            self.assertEqual(run("convert", source, *arguments).returncode, 2)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
