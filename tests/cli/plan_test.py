#!/usr/bin/env python3
"""selvage plan: orders to plans, as text, JSON and a page; and the messages for orders that cannot be cut."""
import json
import unittest

from command import BAD_INPUT, BAD_USAGE, OK, CliTest, run

RECTANGLES = {
    "format": "selvage-marker", "version": 1, "name": "rectangles", "strip": {"width": 1000},
    "shapes": [{"id": size, "outline": [[0, 0], [length, 0], [length, 490], [0, 490]], "attributes": {"size": size}}
               for size, length in (("S", 400), ("M", 450))],
    "pieces": [], "unplaced": [{"id": f"{size} {k}", "shape": size} for size in ("S", "M") for k in (1, 2)]}
ORDER = "colour,S,M\nred,4,8\nblue,2,3\n"


class Plan(CliTest):
    def plan(self, order=ORDER, style=RECTANGLES, *options):
        out = self.path("plan.json")
        ran = run("plan", self.write(order, "order.csv"), "--style", self.write(style, "style.json"), "-o", out,
                  "--bundles", 2, "--moves-per-piece", 5, *options)
        return ran, json.loads(out.read_text()) if ran.returncode == OK else None

    def test_a_plan_delivers_the_order_with_markers_that_are_valid(self):
        ran, plan = self.plan()
        self.assertEqual(ran.returncode, OK, ran.stderr)
        self.assertTrue(plan["complete"])
        cut = {}
        for lay in plan["lays"]:
            for plies in lay["plies"]:
                for bundles in plan["markers"][lay["marker"]]["ratio"]:
                    key = plies["colour"], bundles["size"]
                    cut[key] = cut.get(key, 0) + plies["plies"] * bundles["bundles"]
        self.assertEqual(cut, {("red", "S"): 4, ("red", "M"): 8, ("blue", "S"): 2, ("blue", "M"): 3})
        self.assertEqual(cut, {(d["colour"], d["size"]): d["cut"] for d in plan["delivered"]})
        for marker in plan["markers"]:
            self.assertEqual(run("check", self.write(marker["marker"], "marker.json")).returncode, OK)
            self.assertEqual(len(marker["marker"]["pieces"]), 2 * sum(b["bundles"] for b in marker["ratio"]))
        self.assertAlmostEqual(sum(plan["cost"].values()), 2 * plan["cost"]["total"], places=6)
        self.assertLessEqual(plan["bound"], plan["cost"]["total"])

    def test_the_page_has_a_picture_of_every_marker(self):
        page = self.path("plan.html")
        ran, plan = self.plan(ORDER, RECTANGLES, "--html", page)
        self.assertEqual(ran.returncode, OK, ran.stderr)
        self.assertEqual(page.read_text().count("<svg"), len(plan["markers"]))

    def test_remnants_hold_whole_plies_and_save_cloth(self):
        page = self.path("plan.html")
        without = self.plan()[1]
        ran, plan = self.plan(ORDER, RECTANGLES, "--remnants", "red=2100,blue=500", "--html", page)
        self.assertEqual(ran.returncode, OK, ran.stderr)
        self.assertLess(plan["cost"]["total"], without["cost"]["total"])
        self.assertAlmostEqual(sum(plan["cost"].values()), 2 * plan["cost"]["total"], places=6)
        self.assertLessEqual(plan["bound"], plan["cost"]["total"])
        self.assertEqual([(one["colour"], one["length"]) for one in plan["remnants"]], [("red", 2100), ("blue", 500)])
        used, plies = [0, 0], [0, 0]
        for lay in plan["lays"]:
            for one in lay["plies"]:
                if "remnant" in one:
                    self.assertEqual(one["colour"], plan["remnants"][one["remnant"]]["colour"])
                    plies[one["remnant"]] += one["plies"]
                    used[one["remnant"]] += one["plies"] * (plan["markers"][lay["marker"]]["length"] + 40)
        for k, remnant in enumerate(plan["remnants"]):
            self.assertEqual(remnant["plies"], plies[k])
            self.assertAlmostEqual(remnant["used"], used[k], places=6)
            self.assertAlmostEqual(remnant["used"] + remnant["left"], remnant["length"], places=6)
        self.assertGreater(plies[0], 0)
        self.assertEqual(sum(d["cut"] for d in plan["delivered"]), 17)
        self.assertIn("from remnant 1", page.read_text())
        self.assertIn("remnant 1, red, 2.10 m: ", ran.stdout)

    def test_rolls_are_counted_with_their_splices(self):
        ran, plan = self.plan(ORDER, RECTANGLES, "--table", 1500, "--roll-length", 2500, "--splice-loss", 300)
        self.assertEqual(ran.returncode, OK, ran.stderr)
        self.assertGreater(plan["cost"]["splices"], 0)
        for rolls in plan["rolls"]:
            self.assertAlmostEqual(2500 * rolls["rolls"], rolls["cloth"] + rolls["lost"] + rolls["left"], places=6)
        self.assertAlmostEqual(sum(rolls["cloth"] for rolls in plan["rolls"]), plan["cloth"], places=6)
        self.assertGreater(max(rolls["splices"] for rolls in plan["rolls"]), 0)
        self.assertIn("splice", ran.stdout)

    def test_stored_markers_teach_lengths(self):
        library = self.path("library")
        ran, first = self.plan()
        for k, marker in enumerate(first["markers"]):
            stored = self.write(marker["marker"], f"stored{k}.json")
            self.assertEqual(run("library", "add", library, stored).returncode, OK)
        ran, plan = self.plan(ORDER, RECTANGLES, "--library", library)
        self.assertEqual(ran.returncode, OK, ran.stderr)
        self.assertEqual((first["stored"], plan["stored"]), (0, len(first["markers"])))
        error = [abs(one["rounds"][0]["estimated"] / one["rounds"][0]["real"] - 1) for one in (first, plan)]
        self.assertLess(error[1], error[0])

    def test_notes_of_the_order_are_printed(self):
        ran, plan = self.plan("colour;size;quantity;price\nred;S;4;9\nred;M;8;9\n")
        self.assertEqual(ran.returncode, OK, ran.stderr)
        self.assertIn('note: /order/line/1: the column "price" is left out', ran.stderr)
        self.assertNotIn("the order gives no ratio", ran.stderr)  # which the plan does not use

    def test_the_plan_does_not_depend_on_threads(self):
        self.assertEqual(self.plan()[1], self.plan(ORDER, RECTANGLES, "--threads", 3)[1])

    def test_a_json_order_gives_the_same_plan_as_a_table(self):
        order = {"quantities": {"red": {"S": 4, "M": 8}, "blue": {"S": 2, "M": 3}}}
        self.assertEqual(self.plan()[1], self.plan(json.dumps(order))[1])

    def test_errors_name_the_cause(self):
        for order, style, options, message in (
                ("colour,S\nred,x\n", RECTANGLES, (), "a number of garments is required"),
                ("colour,XS\nred,3\n", RECTANGLES, (), 'size "XS" is not in the style; its sizes are M, S'),
                ('{"ratio": {"S": 1}}', RECTANGLES, (), "the order has no quantities"),
                ('{"quantities": {"red": {"S": 1}}, "mode": "upDown"}', RECTANGLES, (), "in a plan, one or either is allowed"),
                (ORDER, dict(RECTANGLES, unit="in"), (), "plans are made of styles in mm"),
                (ORDER, RECTANGLES, ("--table", 300), "the table has room for 260 mm"),
                (ORDER, RECTANGLES, ("--remnants", "red"), '"red" is not a remnant; COLOUR=LENGTH is allowed'),
                (ORDER, RECTANGLES, ("--remnants", "green=500"), 'nothing is ordered in "green"'),
                (ORDER, RECTANGLES, ("--roll-length", 5000), "no roll is shorter than the table"),
                (ORDER, RECTANGLES, ("--spread", "face_to_face", "--plies", 1), "a lay has at least 2 plies")):
            with self.subTest(message=message):
                ran, _ = self.plan(order, style, *options)
                self.assertEqual(ran.returncode, BAD_INPUT, ran.stderr)
                self.assertIn(message, ran.stderr)
        self.assertEqual(run("plan", self.write(ORDER, "order.csv")).returncode, BAD_USAGE)


if __name__ == "__main__":
    unittest.main()
