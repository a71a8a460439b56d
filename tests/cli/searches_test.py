#!/usr/bin/env python3
"""Nesting, packing and filling.  usage: searches_test.py SELVAGE"""
import json
import re
import signal
import subprocess
import time
import unittest

from command import (BAD_INPUT, BAD_USAGE, CANCELLED, CliTest, HIDES, MARKERS, OK, PACKING, PICTURES, REFUSED, SELVAGE, run,
                     squares)


class Nest(CliTest):
    def instance(self):
        document = json.loads((MARKERS / "jeans_02g.json").read_text())
        del document["solution"]
        return document

    def test_makes_a_marker_of_an_instance_without_a_solution(self):
        ran = run("nest", self.write(self.instance()), "--moves", 500, "-o", self.path("out.json"), "--json")
        self.assertEqual(ran.returncode, OK, ran.stderr)
        line = json.loads(ran.stdout)
        self.assertEqual((line["placed"], line["unplaced"], line["stop"]), (40, 0, "work_limit"))
        self.assertGreater(line["utilisation_after"], 0.7)
        checked = run("check", self.path("out.json"))
        self.assertEqual(checked.returncode, OK)
        self.assertIn("40 pieces, length", checked.stdout)

    def test_the_number_of_threads_does_not_affect_the_result(self):
        results = []
        for threads in (1, 2, 4):
            ran = run("nest", self.write(self.instance()), "--moves", 60, "--searches", 3, "--threads", threads,
                      "-o", self.path("out.json"))
            self.assertEqual(ran.returncode, OK, ran.stderr)
            results.append(self.path("out.json").read_text())
        self.assertEqual(results[1:], results[:1] * 2)

    def test_places_all_pieces_even_without_time(self):
        ran = run("nest", self.write(self.instance()), "--time", 0, "--json")
        self.assertEqual(ran.returncode, OK, ran.stderr)
        self.assertEqual(json.loads(ran.stdout)["stop"], "deadline")
        self.assertEqual(json.loads(ran.stdout)["placed"], 40)

    def test_pieces_lie_in_holes_that_are_open(self):
        def box(low, high):
            return [[low, low], [high, low], [high, high], [low, high]]
        document = squares()
        document["strip"] = {"width": 100}
        document["shapes"] = [{"id": "frame", "outline": box(0, 100), "holes": [box(20, 80)]},
                              {"id": "square", "outline": box(0, 50)}]
        document["unplaced"] = [{"id": name, "shape": shape} for name, shape in (("f", "frame"), ("s", "square"))]
        for options, length in (([], 150), (["--open-holes"], 100)):
            ran = run("nest", self.write(document), "--moves", 200, *options, "-o", self.path("out.json"), "--json")
            self.assertEqual(ran.returncode, OK, ran.stderr)
            self.assertEqual(json.loads(ran.stdout)["length_after"], length)
            self.assertEqual(run("check", self.path("out.json")).returncode, OK)

    def test_ctrl_c_and_sigterm_keep_the_best(self):
        for stop in (signal.SIGINT, signal.SIGTERM):
            out = self.path(f"{stop.name}.json")
            process = subprocess.Popen([SELVAGE, "nest", self.write(self.instance()), "--moves", "1000000000000", "-o", out],
                                       stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
            self.wait_until_sigint_is_handled(process.pid)
            process.send_signal(stop)
            process.communicate(timeout=120)
            self.assertEqual(process.returncode, CANCELLED)
            self.assertEqual(run("check", out).returncode, OK)

    def test_the_drawing_shows_the_best_marker_while_the_search_continues(self):
        drawing = self.path("nested.svg")
        process = subprocess.Popen([SELVAGE, "nest", self.write(self.instance()), "--moves", "1000000000000", "--svg", drawing],
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.addCleanup(process.kill)
        while not drawing.exists():
            self.assertIsNone(process.poll())
            time.sleep(0.01)
        self.assertTrue(drawing.read_text().rstrip().endswith("</svg>"))
        self.assertIsNone(process.poll())
        process.send_signal(signal.SIGINT)
        self.assertEqual(process.wait(), CANCELLED)

    def test_keeps_placed_pieces_if_asked_to(self):
        document = squares((30, 50))
        document["unplaced"] = [{"id": "new", "shape": "square"}]
        for options, length in ((["--keep-placed"], 40), ([], 40)):
            ran = run("nest", self.write(document), "--moves", 50, *options, "-o", self.path("out.json"))
            self.assertEqual(ran.returncode, OK, ran.stderr)
            written = json.loads(self.path("out.json").read_text())
            self.assertEqual([piece["id"] for piece in written["pieces"]], ["p0", "new"])
            self.assertNotIn("unplaced", written)
            self.assertLessEqual(max(piece["at"][0] for piece in written["pieces"]) + 40, 30 + length)

    def test_reports_pieces_without_room_on_the_cloth(self):
        document = squares()
        document["strip"]["longest"] = 50
        document["unplaced"] = [{"id": name, "shape": "square"} for name in "abc"]
        ran = run("nest", self.write(document), "--moves", 50, "-o", self.path("out.json"))
        self.assertEqual(ran.returncode, OK, ran.stderr)
        self.assertIn("left over    1 piece", ran.stdout)
        written = json.loads(self.path("out.json").read_text())
        self.assertEqual((len(written["pieces"]), len(written["unplaced"])), (2, 1))

    def test_writes_every_sheet_to_a_separate_file(self):
        ran = run("nest", self.write(self.instance()), "--moves", 300, "--sheets", "1500x1000*2,1500x1200",
                  "-o", self.path("laid.json"), "--svg", self.path("laid.svg"), "--json")
        self.assertEqual(ran.returncode, OK, ran.stderr)
        line = json.loads(ran.stdout)
        self.assertEqual(len(line["left_over"]), 40 - sum(sheet["pieces"] for sheet in line["sheets"]))
        self.assertEqual(line["sheets"][0]["sheet"], 1)
        for number, sheet in enumerate(line["sheets"], 1):
            checked = run("check", self.path(f"laid-{number}.json"))
            self.assertEqual(checked.returncode, OK, checked.stderr)
            written = json.loads(self.path(f"laid-{number}.json").read_text())
            self.assertEqual(len(written["pieces"]), sheet["pieces"])
            self.assertEqual(written["strip"]["longest"], (1000, 1200)[sheet["sheet"]])
            self.assertTrue(self.path(f"laid-{number}.svg").exists())

    def test_sheets_may_have_outlines(self):
        document = squares()
        document.pop("name", None)
        document["unplaced"] = [{"id": name, "shape": "square"} for name in "abc"]
        hide = '[{"outline": [[0, 0], [100, 0], [50, 100]]}]'
        ran = run("nest", self.write(document), "--moves", 200, "--sheets", hide)
        self.assertEqual(ran.returncode, OK, ran.stderr)
        self.assertIn("marker: 1 sheet\n  sheet 1      kind 1, 1 pieces", ran.stdout)

    def test_sheets_may_have_costs(self):
        document = squares()
        document["unplaced"] = [{"id": name, "shape": "square"} for name in "abc"]
        kinds = [{"width": 50, "length": 50, "count": 3, "cost": 12}, {"width": 40, "length": 45, "count": 2, "cost": 0.5}]
        ran = run("nest", self.write(document), "--moves", 200, "--sheets", json.dumps(kinds))
        self.assertEqual(ran.returncode, OK, ran.stderr)
        self.assertIn(": 3 sheets\n", ran.stdout)
        self.assertIn("\n  cost         13\n", ran.stdout)

    def test_a_sheet_may_lie_far_from_the_origin(self):
        document = squares()
        document["unplaced"] = [{"id": name, "shape": "square"} for name in "abc"]
        laid = []
        for far in (0, 1e9):
            hide = [{"outline": [[far, far], [far + 100, far], [far + 50, far + 100]],
                     "holes": [[[far + 10, far], [far + 20, far], [far + 15, far + 5]]]}]
            ran = run("nest", self.write(document), "--moves", 200, "--sheets", json.dumps(hide),
                      "-o", self.path("laid.json"))
            self.assertEqual(ran.returncode, OK, ran.stderr)
            laid.append(self.path("laid-1.json").read_text())
        self.assertEqual(laid[0], laid[1])

    def test_nests_on_the_bins_of_an_instance(self):
        ran = run("nest", HIDES / "bags.json", "--sheets", "bins", "--moves", 3000, "-o", self.path("laid.json"), "--json")
        self.assertEqual(ran.returncode, OK, ran.stderr)
        line = json.loads(ran.stdout)
        self.assertEqual(sum(sheet["pieces"] for sheet in line["sheets"]), 65)
        self.assertEqual(line["left_over"], [])
        for number, sheet in enumerate(line["sheets"], 1):
            written = json.loads(self.path(f"laid-{number}.json").read_text())
            zones = [piece for piece in written["pieces"] if piece.get("rules", {}).get("zone")]
            self.assertEqual(len(zones), (4 + 3 + 2, 4 + 1 + 1)[sheet["sheet"]])
            self.assertEqual(len(written["pieces"]) - len(zones), sheet["pieces"])
            ran = run("compact", self.path(f"laid-{number}.json"), "-o", self.path("compacted.json"))
            self.assertEqual(ran.returncode, OK, ran.stderr)
            compacted = json.loads(self.path("compacted.json").read_text())
            self.assertEqual([piece for piece in compacted["pieces"] if piece["id"].startswith("sheet ")], zones)
        ran = run("nest", self.write(squares((0, 0))), "--sheets", "bins")
        self.assertEqual(ran.returncode, BAD_INPUT)
        self.assertIn("the opened file has no bins", ran.stderr)

    def test_a_rectangular_bin_is_as_large_as_its_file_says(self):
        shape = {"type": "simple_polygon", "data": [[0, 0], [20.2, 0], [20.2, 0.1], [0, 0.1]]}
        bin_ = {"type": "rectangle", "data": {"x_min": 10.1, "y_min": 0.7, "width": 20.2, "height": 0.1}}
        instance = {"items": [{"id": 0, "demand": 1, "allowed_orientations": [0], "shape": shape}],
                    "bins": [{"id": 0, "stock": 0, "cost": 1, "shape": bin_}, {"id": 1, "stock": 1, "cost": 1, "shape": bin_}]}
        ran = run("nest", self.write(instance), "--sheets", "bins", "--moves", 100, "--json")
        self.assertEqual(ran.returncode, OK, ran.stderr)
        self.assertEqual(json.loads(ran.stdout)["left_over"], [])
        instance["bins"][1]["shape"] = {"type": "simple_polygon", "data": [[0, 0], [30, 0], [0, 30]]}
        ran = run("nest", self.write({**instance, "margin": 1}), "--sheets", "bins")
        self.assertEqual(ran.returncode, BAD_INPUT)
        self.assertIn("/bins/1/shape/data: is given, and the marker has a margin", ran.stderr)

    def test_names_what_no_sheet_takes_not_the_sheet(self):
        document = squares((0, 0))
        document["pieces"][0]["rules"] = {"zone": True}
        document["unplaced"] = []
        document["pieces"].append({"id": "other", "shape": "square", "at": [50, 50]})
        ran = run("nest", self.write(document), "--sheets", "90x80")
        self.assertEqual(ran.returncode, BAD_INPUT)
        self.assertIn("/pieces/0/rules/zone", ran.stderr)

    def test_refuses_sheets_that_it_cannot_read(self):
        document = squares((0, 0))
        for options in (["--sheets", "90"], ["--sheets", "90x"], ["--sheets", "90x80", "--keep-placed"],
                        ["--sheets", "90x80", "-o", "-"], ["--sheets", "90x80", "--svg", self.path("a.svg"), "--chain"]):
            self.assertEqual(run("nest", self.write(document), *options).returncode, BAD_USAGE, options)
        self.assertEqual(run("nest", self.write(document), "--sheets", "0x80").returncode, BAD_INPUT)
        self.assertEqual(run("nest", self.write(document), "--sheets", "[{]").returncode, BAD_INPUT)

    def test_presets_limit_time(self):
        ran = run("nest", self.write(squares((0, 0))), "--accuracy", "draft", "--json")
        self.assertEqual(ran.returncode, OK, ran.stderr)
        self.assertEqual(run("nest", self.write(squares((0, 0))), "--accuracy", "draft", "--time", 3).returncode, BAD_INPUT)

    def test_names_the_piece_that_fits_in_no_orientation(self):
        document = squares((0, 0))
        document["shapes"].append({"id": "board", "outline": [[0, 0], [150, 0], [150, 120], [0, 120]], "rotations": [0, 90]})
        document["unplaced"] = [{"id": "a", "shape": "board"}]
        ran = run("nest", self.write(document))
        self.assertNotEqual(ran.returncode, OK)
        self.assertIn("board", ran.stderr)
        self.assertIn("marker.piece_too_wide", ran.stderr)


class Pack(CliTest):
    def test_proves_the_shortest_marker(self):
        for name, pieces, length in (("partition", 5, 100), ("no_partition", 4, 120), ("bars", 6, 90)):
            with self.subTest(name):
                ran = run("pack", PACKING / f"{name}.json", "-o", self.path("out.json"), "--json")
                self.assertEqual(ran.returncode, OK, ran.stderr)
                line = json.loads(ran.stdout)
                self.assertEqual((line["found"], line["proved"], line["unplaced"]), (True, True, 0))
                self.assertAlmostEqual(line["length_after"], length, places=4)
                self.assertAlmostEqual(line["bound"], length, places=3)
                self.assertEqual(line["placed"], pieces)
                self.assertEqual(run("check", self.path("out.json")).returncode, OK)

    def test_accepts_an_instance_without_a_solution_and_a_node_limit(self):
        document = json.loads((MARKERS / "jeans_02g.json").read_text())
        del document["solution"]
        ran = run("pack", self.write(document), "--nodes", 50, "-o", self.path("out.json"), "--json")
        self.assertEqual(ran.returncode, OK, ran.stderr)
        line = json.loads(ran.stdout)
        self.assertEqual((line["found"], line["proved"], line["stop"]), (True, False, "work_limit"))
        self.assertLess(line["bound"], line["length_after"])
        self.assertEqual(run("check", self.path("out.json")).returncode, OK)

    def test_no_turns_keeps_the_orientations(self):
        bar = {"format": "selvage-marker", "version": 1, "strip": {"width": 40}, "pieces": [],
               "shapes": [{"id": "bar", "outline": [[0, 0], [40, 0], [40, 10], [0, 10]], "rotations": [0, 90]}],
               "unplaced": [{"id": "a", "shape": "bar"}]}
        for options, length in (((), 10), (("--no-turns",), 40)):
            ran = run("pack", self.write(bar), "--json", *options)
            self.assertEqual(ran.returncode, OK, ran.stderr)
            self.assertEqual(json.loads(ran.stdout)["length_after"], length)

    def test_the_summary_states_what_is_proved(self):
        ran = run("pack", PACKING / "partition.json")
        self.assertIn("the shortest, proved", ran.stdout)
        ran = run("pack", PACKING / "seven.json", "--nodes", "20")
        bound, shorter = map(float, re.search(r"bound +([\d.]+) mm, at most ([\d.]+) % shorter", ran.stdout).groups())
        length = float(re.search(r"length .*-> ([\d.]+) mm", ran.stdout).group(1))
        self.assertAlmostEqual(bound / length, 1 - shorter / 100, places=4)
        self.assertNotIn("tilts", ran.stdout)
        ran = run("contain", PACKING / "slot.json")
        self.assertIn("pieces       found", ran.stdout)

    def test_the_summary_says_that_a_proof_is_for_the_present_tilts(self):
        leaning = {"format": "selvage-marker", "version": 1, "strip": {"width": 110},
                   "shapes": [{"id": "leaning", "outline": [[0, 0], [20, 0], [38, 100], [18, 100]], "tilt_limit": 15}],
                   "pieces": [{"id": "a", "shape": "leaning", "at": [0, 0]}]}
        ran = run("pack", self.write(leaning))
        self.assertIn("the shortest, proved (with the present tilts)", ran.stdout)

    def test_the_summary_calls_nothing_the_shortest_that_is_longer_than_its_bound(self):
        coarse = {"format": "selvage-marker", "version": 1, "strip": {"width": 100}, "resolution": 10, "pieces": [],
                  "shapes": [{"id": "s", "outline": [[0, 0], [40, 0], [40, 30], [0, 30]]}],
                  "unplaced": [{"id": f"p{k}", "shape": "s"} for k in range(3)]}
        coarse["shapes"][0]["rotations"] = [0, 45]
        ran = run("pack", self.write(coarse))
        self.assertIn("bound        30 mm, the shortest but for up to 10 mm, proved", ran.stdout)

    def test_the_summary_has_no_bound_where_there_is_no_layout(self):
        wide = {"format": "selvage-marker", "version": 1, "strip": {"width": 100}, "pieces": [],
                "shapes": [{"id": "s", "outline": [[0, 0], [40, 0], [40, 130], [0, 130]]}],
                "unplaced": [{"id": "a", "shape": "s"}]}
        ran = run("pack", self.write(wide))
        self.assertIn("bound        no layout, proved\n", ran.stdout)

    def test_the_summary_says_when_more_nodes_do_not_help(self):
        apart = {"format": "selvage-marker", "version": 1, "strip": {"width": 100}, "spacing": 20, "pieces": [],
                 "shapes": [{"id": "s", "outline": [[0, 0], [41, 0], [41, 41], [0, 41]]}],
                 "unplaced": [{"id": "a", "shape": "s"}, {"id": "b", "shape": "s"}]}
        ran = run("pack", self.write(apart), "--nodes", 1000, "-o", self.path("out.json"))
        self.assertIn("more nodes do not close the gap", ran.stdout)
        self.assertIn("converged", ran.stdout)
        again = json.loads(run("compact", self.path("out.json"), "--json").stdout)
        self.assertAlmostEqual(again["length_after"], again["length_before"], places=4)

    def test_pieces_that_may_overlap_are_packed_and_placed_with_overlaps(self):
        lapping = {"format": "selvage-marker", "version": 1, "strip": {"width": 100}, "overlap": 2, "pieces": [],
                   "shapes": [{"id": "s", "outline": [[0, 0], [51, 0], [51, 51], [0, 51]]}],
                   "unplaced": [{"id": "a", "shape": "s"}, {"id": "b", "shape": "s"}]}
        ran = run("pack", self.write(lapping), "-o", self.path("out.json"))
        self.assertIn("bound        none, because pieces may overlap\n", ran.stdout)
        self.assertIn("length       0 -> 51 mm", ran.stdout)
        self.assertIn("work limit", ran.stdout)
        self.assertEqual(run("check", self.path("out.json")).returncode, OK)
        for end, verdict, stop in ((60, "found", "converged"), (50, "undecided", "work_limit")):
            ran = run("contain", self.write(lapping), "--room", f"[[0,0],[{end},100]]", "--json")
            line = json.loads(ran.stdout)
            self.assertEqual((line["verdict"], line["stop"], line["valid"]), (verdict, stop, True))

    def test_refuses_too_many_pieces(self):
        ran = run("pack", MARKERS / "jeans_06g.json")
        self.assertEqual(ran.returncode, REFUSED)
        self.assertIn("120 pieces are not locked; an exact search takes at most 64", ran.stderr)

    def test_contain_places_pieces_or_proves_that_they_do_not_fit(self):
        ran = run("contain", PACKING / "slot.json", "-o", self.path("out.json"), "--json")
        self.assertEqual(ran.returncode, OK, ran.stderr)
        line = json.loads(ran.stdout)
        self.assertEqual((line["verdict"], line["pieces"], line["length_after"]), ("found", 3, 30))
        self.assertEqual(run("check", self.path("out.json")).returncode, OK)
        ran = run("contain", PACKING / "slot.json", "--room", "[[0,0],[29,30]]", "-o", self.path("none.json"), "--json")
        self.assertEqual(ran.returncode, OK, ran.stderr)
        self.assertEqual(json.loads(ran.stdout)["verdict"], "impossible")
        ran = run("contain", PACKING / "slot.json", "--room", "[[30,0],[30,30]]")
        self.assertEqual(ran.returncode, BAD_INPUT)
        self.assertIn("/room", ran.stderr)

    def test_contain_refuses_a_marker_in_which_other_pieces_overlap(self):
        document = squares((0, 0), (5, 5), (50, 0))
        mover, first, second = document["pieces"][2]["id"], document["pieces"][0]["id"], document["pieces"][1]["id"]
        ran = run("contain", self.write(document), "--pieces", json.dumps([mover]), "-o", self.path("out.json"))
        self.assertEqual(ran.returncode, REFUSED)
        self.assertEqual(ran.stdout, "")
        self.assertIn(f'pieces "{first}" and "{second}" must stay where they are, but overlap', ran.stderr)
        self.assertFalse(self.path("out.json").exists())
        asked = run("call", "motion.contain", "--marker", self.write(document), "--params",
                    json.dumps({"pieces": [mover], "commit": False}))
        self.assertEqual(json.loads(asked.stdout)["verdict"], "found", asked.stderr)


class Figures(CliTest):
    LENGTHS = {"beside": 100, "exchange": 90, "seven": 95.58494}

    def test_the_shortest_layouts_are_proved(self):
        for name, length in self.LENGTHS.items():
            with self.subTest(name):
                line = json.loads(run("pack", PACKING / f"{name}.json", "--json").stdout)
                self.assertAlmostEqual(line["length_after"], length, places=3)
                self.assertTrue(line["proved"])
        self.assertEqual(json.loads(run("compact", PACKING / "exchange.json", "--json").stdout)["length_after"], 120)

    def test_the_pictures_in_the_docs_are_those_that_the_command_draws(self):
        subprocess.run([PACKING / "draw_figures.sh", SELVAGE, self.folder.name], check=True, timeout=300)
        drawn = sorted(self.path("").glob("*.svg"))
        self.assertEqual(len(drawn), 10)
        for picture in drawn:
            kept = PICTURES / picture.name
            self.assertEqual(picture.read_text(), kept.read_text(), f"{kept}: ./dev figures")


class Fill(CliTest):
    def test_is_shorter_than_standard_compaction(self):
        compacted = run("compact", MARKERS / "jeans_02g.json", "--json")
        ran = run("fill", MARKERS / "jeans_02g.json", "--trials", 60, "-o", self.path("out.json"), "--json")
        self.assertEqual(ran.returncode, OK, ran.stderr)
        line = json.loads(ran.stdout)
        self.assertLess(line["length_after"], json.loads(compacted.stdout)["length_after"])
        self.assertEqual((line["rounds"], line["stop"]), (60, "work_limit"))
        self.assertGreater(line["kept"], 0)
        self.assertEqual(run("check", self.path("out.json")).returncode, OK)

    def test_places_unplaced_pieces_in_gaps(self):
        document = squares((0, 0), (50, 0))
        document["shapes"].append({"id": "strip", "outline": [[0, 0], [90, 0], [90, 20], [0, 20]]})
        document["unplaced"] = [{"id": "long", "shape": "strip"}, {"id": "third", "shape": "square"}]
        document["unplaced"].append({"id": "fourth", "shape": "square"})
        ran = run("fill", self.write(document), "--trials", 0, "-o", self.path("out.json"), "--json")
        self.assertEqual(ran.returncode, OK, ran.stderr)
        line = json.loads(ran.stdout)
        # Compacted, the squares leave 80 x 60: room for two more of them, and for no strip of 90.
        self.assertEqual((line["placed"], line["unplaced"], line["length_after"]), (2, 1, 80))
        self.assertEqual([piece["id"] for piece in json.loads(self.path("out.json").read_text())["unplaced"]], ["long"])

    def test_the_number_of_threads_does_not_affect_the_result(self):
        for command, options in (("fill", ["--trials", 30]), ("compact-exactly", ["--windows", 6, "--nodes", 40])):
            results = []
            for threads in (1, 2, 4):
                ran = run(command, MARKERS / "jeans_02g.json", *options, "--threads", threads, "-o", self.path("out.json"))
                self.assertEqual(ran.returncode, OK, ran.stderr)
                results.append(self.path("out.json").read_text())
            self.assertEqual(results[1:], results[:1] * 2, command)


if __name__ == "__main__":
    unittest.main()
