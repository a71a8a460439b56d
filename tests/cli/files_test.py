#!/usr/bin/env python3
"""Drawings, calls, checks and conversions.  usage: files_test.py SELVAGE"""
import json
import re
import resource
import subprocess
import unittest

from command import BAD_INPUT, BAD_USAGE, CliTest, FILE, MARKERS, NOT_VALID, OK, REFUSED, SELVAGE, run, squares


class Drawing(CliTest):
    def test_draws_displacements_and_the_critical_path_on_request(self):
        marker = self.write(squares((10, 0), (55, 20)))
        for flags, shown, hidden in (([], [], ["moved-head", "chain"]), (["--arrows"], ["moved-head"], ["chain"]),
                                     (["--arrows", "--chain"], ["moved-head", "chain"], [])):
            ran = run("compact", marker, "--svg", self.path("out.svg"), *flags)
            self.assertEqual(ran.returncode, OK, ran.stderr)
            body = self.path("out.svg").read_text().split("</style>")[1]
            for word in shown:
                self.assertIn(f'class="{word}"', body)
            for word in hidden:
                self.assertNotIn(f'class="{word}"', body)

    def test_draws_forces(self):
        params = self.write({"force": [0, 1]}, "params.json")
        run("call", "motion.gravity", "--marker", self.write(squares((10, 0))), "--params", params, "--svg",
            self.path("out.svg"), "--arrows")
        self.assertIn('class="force-head"', self.path("out.svg").read_text())


class Call(CliTest):
    def call(self, method, params, *more, marker=None):
        return run("call", method, "--marker", marker or self.marker, "--params", "-", *more,
                   text=params if isinstance(params, str) else json.dumps(params))

    def setUp(self):
        super().setUp()
        self.marker = self.write(squares((0, 0), (50, 10)))

    def test_returns_the_same_results_as_the_daemon(self):
        """Replays the golden exchanges that do not change the marker, on the marker that the first of them opens."""
        exchanges = json.loads((MARKERS.parents[1] / "tests/golden/rpc/motions.json").read_text())
        marker = self.write(exchanges[0]["request"]["params"]["marker"], "golden.json")
        played = 0
        for exchange in exchanges:
            params, answer = exchange["request"]["params"], exchange["response"]
            if params.get("commit") is not False:
                continue
            played += 1
            with self.subTest(exchange["request"]):
                ran = self.call(exchange["request"]["method"], params, marker=marker)
                if "error" in answer:
                    self.assertEqual((ran.returncode, ran.stdout), (BAD_INPUT, ""))
                    self.assertIn(answer["error"]["message"], ran.stderr)
                    continue
                self.assertEqual(ran.returncode, OK, ran.stderr)
                result = json.loads(ran.stdout)
                expected = {k: result.get(k) if v == "$any" else v for k, v in answer["result"].items()}
                self.assertEqual(result, expected)
        self.assertGreaterEqual(played, 7)

    def test_writes_the_moved_pieces(self):
        ran = self.call("motion.gravity", {"force": [0, 1]}, "-o", self.path("out.json"))
        result = json.loads(ran.stdout)
        self.assertEqual((result["markerId"], result["revision"], result["gain"]), ("m1", 2, 110))
        out = json.loads(self.path("out.json").read_text())
        self.assertEqual([p["at"] for p in out["pieces"]], [p["at"] for p in result["placements"]])
        self.assertEqual([p["at"][1] for p in out["pieces"]], [60, 60])

    def test_applies_edits(self):
        ops = [{"op": "add", "piece": {"id": "new", "shape": "square", "at": [0, 50], "attributes": {"size": "L"}}},
               {"op": "remove", "piece": "p1"}]
        result = json.loads(self.call("marker.apply", {"ops": ops}, "-o", self.path("out.json")).stdout)
        self.assertEqual((result["revision"], result["removed"], result["length"]), (2, ["p1"], 40))
        pieces = json.loads(self.path("out.json").read_text())["pieces"]
        self.assertEqual([(p["id"], p.get("attributes")) for p in pieces], [("p0", None), ("new", {"size": "L"})])
        overlapping = self.call("marker.apply", {"ops": [{"op": "move", "piece": "p1", "at": [9, 0]}]}, "-o",
                                self.path("out.json"))
        self.assertEqual(overlapping.returncode, NOT_VALID)
        self.assertEqual(json.loads(self.path("out.json").read_text())["pieces"][1]["at"], [9, 0])

    def test_a_dry_run_writes_the_marker_unchanged(self):
        ran = self.call("motion.compact", {"commit": False, "rounds": 3}, "-o", self.path("out.json"))
        self.assertEqual(json.loads(ran.stdout)["lengthAfter"], 80)
        self.assertEqual(json.loads(self.path("out.json").read_text())["pieces"][1]["at"], [50, 10])

    def test_parameters_may_be_omitted_if_the_method_requires_none(self):
        ran = run("call", "marker.check", "--marker", self.marker)
        self.assertEqual(json.loads(ran.stdout), {"markerId": "m1", "revision": 1, "valid": True, "overlaps": [],
                                                  "protrusions": []})
        compacted = json.loads(run("call", "motion.compact", "--marker", self.marker).stdout)
        self.assertEqual(compacted["lengthAfter"], 80)

    def test_runs_methods_that_only_read(self):
        got = json.loads(self.call("marker.get", {"format": "outlines"}).stdout)
        self.assertEqual(got["marker"]["strip_length"], 90)
        overlapping = self.write(squares((0, 0), (20, 0)), "overlapping.json")
        ran = run("call", "marker.check", "--marker", overlapping)
        self.assertEqual(ran.returncode, NOT_VALID)
        self.assertEqual(len(json.loads(ran.stdout)["overlaps"]), 1)

    def test_reports_times_only_on_request(self):
        timed = json.loads(self.call("motion.compact", {"timing": True}).stdout)
        self.assertEqual(set(timed["ms"]), {"decomposition", "sums", "rows", "solve", "verify", "total"})
        runs = {self.call("motion.push", {"forces": [{"piece": "p0", "force": [1, 1]}]}).stdout for _ in range(3)}
        self.assertEqual(len(runs), 1)
        self.assertNotIn("ms", json.loads(runs.pop()))

    def test_names_mistakes_in_parameters(self):
        for method, params, said in (("motion.compact", "{", "input.syntax"),
                                     ("motion.compact", [], "[] where an object is required"),
                                     ("motion.compact", {"speed": 1}, "/speed: the field is not known"),
                                     ("motion.compact", {"baseRev": 2}, "/baseRev: 2 is not the marker's revision"),
                                     ("motion.bump", {"piece": "p0"}, "/direction: the field is missing")):
            with self.subTest(params):
                ran = self.call(method, params)
                self.assertEqual((ran.returncode, ran.stdout), (BAD_INPUT, ""))
                self.assertIn(said, ran.stderr)
        self.assertEqual(run("call", "motion.compact", "--marker", self.marker, "--params", "nowhere").returncode, FILE)
        self.assertEqual(self.call("motion.compact", {}, marker=self.write(squares((0, 0), (9, 0)))).returncode, REFUSED)


class Check(CliTest):
    def test_a_valid_marker(self):
        ran = run("check", MARKERS / "jeans_06g.json")
        self.assertEqual(ran.returncode, OK)
        self.assertIn("120 pieces, length 7238 mm", ran.stdout)

    def test_lists_overlaps_and_protrusions(self):
        ran = run("check", self.write(squares((0, 0), (30, 0), (0, 70))))
        self.assertEqual(ran.returncode, NOT_VALID)
        self.assertIn("pieces p0 and p1 overlap by 10 mm", ran.stdout)
        self.assertIn("piece p2 leaves the strip by 10 mm", ran.stdout)

    def test_an_overlap_allowance_is_not_counted(self):
        ran = run("check", "--overlap", "4", self.write(squares((0, 0), (30, 0))))
        self.assertEqual(ran.returncode, NOT_VALID)
        self.assertIn("pieces p0 and p1 overlap by 6 mm too much", ran.stdout)

    def test_json_gives_the_same_result(self):
        ran = run("check", "--json", self.write(squares((0, 0), (30, 0))))
        self.assertEqual(ran.returncode, NOT_VALID)
        answer = json.loads(ran.stdout)
        self.assertFalse(answer["valid"])
        self.assertEqual([(o["first"], o["second"], o["depth"]) for o in answer["overlaps"]], [("p0", "p1", 10)])
        x, y = answer["overlaps"][0]["witness"]
        self.assertTrue(30 < x < 40 and 0 < y < 40, (x, y))

    def test_says_where_far_along_the_strip_in_plain_digits(self):
        ran = run("check", self.write(squares((23_450, 0), (23_480, 0), (61_000, 70))))
        place = re.search(r"overlap by 10 mm near \(([\d.]+), ([\d.]+)\)", ran.stdout)
        self.assertTrue(place, ran.stdout)
        self.assertTrue(23_480 < float(place.group(1)) < 23_490, ran.stdout)
        for y, distance in ((10_059.97, "10000"), (12_405.6, "12346")):
            ran = run("check", self.write(squares((0, y))))
            self.assertIn(f"leaves the strip by {distance} mm", ran.stdout)

    def test_checks_the_spacing(self):
        touching = self.write(squares((0, 0), (40, 0)))
        self.assertEqual(run("check", touching).returncode, OK)
        self.assertEqual(run("check", touching, "--spacing", "0.001").returncode, NOT_VALID)


class Writing(CliTest):
    def test_a_file_is_kept_when_its_successor_has_no_room(self):
        drawing = self.path("out.svg")
        drawing.write_text("the earlier one")

        def little_room():
            resource.setrlimit(resource.RLIMIT_FSIZE, (1000, 1000))

        ran = subprocess.run([SELVAGE, "show", MARKERS / "jeans_02g.json", drawing], capture_output=True, text=True,
                             preexec_fn=little_room, restore_signals=False)
        self.assertEqual(ran.returncode, FILE)
        self.assertIn(f"{drawing} cannot be written", ran.stderr)
        self.assertEqual(drawing.read_text(), "the earlier one")
        self.assertEqual([file.name for file in drawing.parent.iterdir()], ["out.svg"])

    def test_a_link_stays_a_link_and_a_file_keeps_its_permissions(self):
        drawing, link = self.path("out.svg"), self.path("link.svg")
        drawing.write_text("")
        drawing.chmod(0o600)
        link.symlink_to(drawing)
        for path in (drawing, link):
            drawing.write_text("")
            self.assertEqual(run("show", MARKERS / "jeans_02g.json", path).returncode, OK)
            self.assertIn("</svg>", drawing.read_text())
        self.assertTrue(link.is_symlink())
        self.assertEqual(drawing.stat().st_mode & 0o777, 0o600)


class NamesOfFiles(CliTest):
    """No result overwrites another one or what the command reads; a marker may replace itself."""

    def setUp(self):
        super().setUp()
        self.marker = self.write(squares((0, 0), (50, 10)), "k.json")
        self.before = self.marker.read_text()
        self.path("link.json").symlink_to(self.marker)
        (self.path("folder")).mkdir()

    def refused(self, said, *arguments):
        with self.subTest(arguments):
            ran = run(*arguments)
            self.assertEqual((ran.returncode, ran.stdout), (BAD_USAGE, ""))
            self.assertIn(said, ran.stderr)
            self.assertEqual(self.marker.read_text(), self.before)

    def test_no_two_results_have_one_name(self):
        new, same = self.path("new.json"), self.path("folder") / ".." / "new.json"
        self.refused(f"--out and --svg name the same file, {new}", "compact", self.marker, "-o", new, "--svg", new)
        self.refused(f"--out and --outlines name the same file, {same}", "compact", self.marker, "-o", new, "--outlines",
                     same)
        self.refused("--svg and --outlines name the same file", "call", "motion.compact", "--marker", self.marker,
                     "--svg", new, "--outlines", new)
        self.path("later.svg").symlink_to(new)
        self.refused("--out and --svg name the same file", "compact", self.marker, "-o", new, "--svg",
                     self.path("later.svg"))
        self.assertFalse(new.exists())

    def test_no_result_replaces_what_is_read(self):
        marker, link = self.marker, self.path("link.json")
        overwrites = f"would overwrite {marker}, which"
        self.refused(f"--svg {overwrites} IN reads", "compact", marker, "-o", self.path("o.json"), "--svg", link)
        self.refused(f"--out {overwrites} IN reads", "compact", marker, "-o", marker, "--format", "pdf")
        self.refused(f"--outlines {overwrites} --marker reads", "call", "motion.compact", "--marker", marker,
                     "--outlines", marker)
        self.refused(f"OUT {overwrites} IN reads", "show", marker, link)
        self.refused(f"--svg {overwrites} IN reads", "show", marker, "--svg", marker)
        self.refused(f"OUT {overwrites} IN reads", "convert", marker, marker, "--format", "cut")
        self.refused(f"--out {overwrites} --order reads", "convert", self.path("x.dxf"), "-o", marker, "--order", marker)
        self.refused(f"--svg {overwrites} ORDER reads", "remake", marker, "--library", self.path("folder"), "--svg",
                     marker)
        self.refused(f"--html {overwrites} --style reads", "plan", self.path("order.csv"), "--style", marker, "--html",
                     marker)
        self.refused(f"--out {overwrites} ORDER reads", "plan", marker, "--style", self.path("s.json"), "-o", marker)
        params = self.write({"rounds": 1}, "params.json")
        self.refused(f"--out would overwrite {params}, which PARAMS reads", "call", "motion.compact", params, "--marker",
                     marker, "-o", params)

    def test_no_sheet_replaces_what_is_read(self):
        laid = self.write(self.before, "laid-2.json")
        self.refused(f"sheet 2 of --out would overwrite {laid}, which IN reads", "nest", laid, "--moves", 10, "--sheets",
                     "100x100*3", "-o", self.path("laid.json"))
        self.assertEqual(laid.read_text(), self.before)

    def test_a_marker_may_replace_the_one_that_was_read(self):
        for arguments in (("compact", self.marker, "-o", self.marker), ("convert", self.marker, self.marker),
                          ("compact", self.marker, "-o", self.path("link.json"), "--format", "native")):
            with self.subTest(arguments):
                self.marker.write_text(self.before)
                self.assertEqual(run(*arguments).returncode, OK)
                self.assertEqual(json.loads(self.marker.read_text())["format"], "selvage-marker")

    def test_results_may_share_a_device(self):
        self.assertEqual(run("compact", self.marker, "-o", "/dev/null", "--svg", "/dev/null").returncode, OK)


class ShowAndConvert(CliTest):
    def test_draws(self):
        ran = run("show", MARKERS / "jeans_02g.json", "--svg", "-")
        self.assertEqual(ran.returncode, OK, ran.stderr)
        self.assertTrue(ran.stdout.startswith("<svg ") and ran.stdout.endswith("</svg>\n"))

    def test_converting_to_another_format_and_back_keeps_the_marker(self):
        native, sparrow, again = self.path("n.json"), self.path("s.json"), self.path("n2.json")
        self.assertEqual(run("convert", MARKERS / "simon_06g.json", "-o", native, "--format", "native").returncode, OK)
        self.assertEqual(run("convert", native, "-o", sparrow, "--format", "sparrow").returncode, OK)
        self.assertEqual(run("convert", sparrow, "-o", again, "--format", "native").returncode, OK)
        self.assertEqual(native.read_text(), again.read_text())


if __name__ == "__main__":
    unittest.main()
