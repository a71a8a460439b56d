#!/usr/bin/env python3
"""selvage_client.nest and the names of spyrrow, with a live daemon.  usage: python_nesting_test.py SELVAGED"""
import json
import math
import pathlib
import subprocess
import sys
import tempfile
import unittest

from live_daemon import LiveDaemon

import selvage_client
from selvage_client import spyrrow

SELVAGED = sys.argv.pop(1) if len(sys.argv) > 1 else "selvaged"
JUDGE = pathlib.Path(__file__).resolve().parents[1] / "judge" / "judge_layout.py"
ELL = [(0, 0), (40, 0), (40, 15), (15, 15), (15, 40), (0, 40)]
SQUARE = [(0, 0), (20, 0), (20, 20), (0, 20)]


def placed(outline, rotation, at, flip=False):
    """Quarter turns only, so that the points are exact."""
    cosine, sine = round(math.cos(math.radians(rotation))), round(math.sin(math.radians(rotation)))
    mirrored = [(x, -y if flip else y) for x, y in outline]
    return [[x * cosine - y * sine + at[0], x * sine + y * cosine + at[1]] for x, y in mirrored]


class Nesting(unittest.TestCase):
    def setUp(self):
        self.daemon = LiveDaemon(SELVAGED)
        self.daemon.__enter__()
        self.addCleanup(self.daemon.__exit__)

    def judge(self, width, length, outlines):
        """Whether the independent judge finds the layout valid."""
        layout = {"strip_height": width, "strip_length": length,
                  "pieces": [{"id": str(k), "outline": outline} for k, outline in enumerate(outlines)]}
        with tempfile.NamedTemporaryFile("w", suffix=".json") as file:
            json.dump(layout, file)
            file.flush()
            return subprocess.run([sys.executable, JUDGE, file.name], capture_output=True).returncode == 0

    def test_pieces_and_a_width_give_a_valid_marker(self):
        patterns = [selvage_client.Pattern(outline=ELL, quantity=4, rotations=(0, 90, 180, 270), flip=True), SQUARE]
        found = selvage_client.nest(patterns, 60, moves=2000, seed=3, address=self.daemon.address)
        self.assertEqual([piece.pattern for piece in found.pieces].count(0), 4)
        self.assertEqual([piece.pattern for piece in found.pieces].count(1), 1)
        self.assertEqual(found.left_over, ())
        outlines = [placed(SQUARE if piece.pattern else ELL, piece.rotation, piece.at, piece.flip)
                    for piece in found.pieces]
        self.assertTrue(self.judge(60, found.length, outlines))
        self.assertAlmostEqual(found.utilisation, (4 * 975 + 400) / (60 * found.length))
        self.assertGreater(found.utilisation, 0.6)

    def test_pieces_are_nested_on_sheets(self):
        marker = {"format": "selvage-marker", "version": 1, "strip": {"width": 40}, "pieces": [],
                  "shapes": [{"id": "square", "outline": SQUARE}],
                  "unplaced": [{"id": str(k), "shape": "square"} for k in range(7)]}
        with selvage_client.Client(self.daemon.address) as client, client.open(marker) as opened:
            found = opened.nest_sheets([{"width": 40, "length": 40}, {"width": 40, "length": 20}], moves=500,
                                       values={"6": 1000})
            self.assertEqual([sheet.pieces for sheet in found.sheets], [4, 2])
            self.assertEqual(len(found.left_over), 1)
            self.assertNotIn("6", found.left_over)
            self.assertEqual(found.sheets[1].marker["strip"], {"width": 40, "longest": 20})
            self.assertEqual(opened.revision, 1)

    def test_the_same_request_gives_the_same_marker(self):
        markers = [selvage_client.nest([selvage_client.Pattern(outline=ELL, quantity=3)], 60, moves=500, seed=1,
                                address=self.daemon.address) for _ in range(2)]
        self.assertEqual(markers[0], markers[1])

    def test_copies_beyond_the_end_of_the_cloth_are_left_over(self):
        found = selvage_client.nest([selvage_client.Pattern(outline=SQUARE, quantity=5)], 40, longest=50, moves=200,
                             address=self.daemon.address)
        self.assertEqual(len(found.pieces), 4)
        self.assertEqual(found.left_over, (0,))

    def test_spacing_and_margin_are_kept(self):
        found = selvage_client.nest([selvage_client.Pattern(outline=SQUARE, quantity=2)], 50, spacing=4, margin=3, moves=200,
                             address=self.daemon.address)
        self.assertEqual(sorted(piece.at for piece in found.pieces), [(3, 3), (3, 27)])

    def test_a_piece_wider_than_the_cloth_is_named(self):
        with self.assertRaises(selvage_client.CallError) as raised:
            selvage_client.nest([SQUARE], 10, address=self.daemon.address)
        self.assertIn("/unplaced/0", str(raised.exception))

    def test_programs_written_for_spyrrow_work(self):
        spyrrow.address = self.daemon.address
        items = [spyrrow.Item("ell", [*ELL, ELL[0]], 3, [0.0, 180.0]), spyrrow.Item("square", SQUARE, 2, [])]
        strip = spyrrow.StripPackingInstance("test", 60.0, items)
        config = spyrrow.StripPackingConfig(total_computation_time=1, num_workers=1, seed=0)
        solution = strip.solve(config)
        self.assertEqual(sorted(item.id for item in solution.placed_items), ["ell"] * 3 + ["square"] * 2)
        outlines = [placed(ELL if item.id == "ell" else SQUARE, item.rotation, item.translation)
                    for item in solution.placed_items]
        self.assertTrue(self.judge(60, solution.width, outlines))
        self.assertAlmostEqual(solution.density, (3 * 975 + 2 * 400) / (60 * solution.width))

    def test_rotations_in_single_precision_are_those_of_the_item(self):
        items = [spyrrow.Item("turned", SQUARE, 4, [0.0, 30.0]), spyrrow.Item("upright", SQUARE, 1, []),
                 spyrrow.Item("free", SQUARE, 1, None)]
        strip = spyrrow.StripPackingInstance("noisy", 100.0, items)

        def opened(*rotations):
            placed_items = [spyrrow.PlacedItem(id, (30.0 * k + 20, 20.0), rotation)
                            for k, (id, rotation) in enumerate(rotations)]
            marker = spyrrow.marker(strip, spyrrow.StripPackingSolution(200, 0.1, placed_items))
            with selvage_client.Client(self.daemon.address) as client, client.open(marker) as opened:
                return [piece.get("rotation", 0) for piece in opened.get(format="native").marker["pieces"]]

        self.assertEqual(
            opened(("turned", 30.000001907348633), ("turned", -330.0005), ("turned", 359.99999), ("turned", 390.0),
                   ("upright", -1e-6), ("free", 29.99999)),
            [30, 30, 0, 30, 0, 29.99999])
        with self.assertRaises(selvage_client.CallError) as raised:
            opened(("turned", 30.002))
        self.assertIn("/pieces/0/rotation", str(raised.exception))

    def test_zones_of_the_cloth_are_no_items(self):
        document = {"format": "selvage-marker", "version": 1, "strip": {"width": 40},
                    "shapes": [{"id": "square", "outline": SQUARE},
                               {"id": "flaw", "outline": [[0, 0], [90, 0], [90, 5], [0, 5]]}],
                    "pieces": [{"id": "1", "shape": "square", "at": [0, 20]},
                               {"id": "2", "shape": "flaw", "at": [0, 0], "rules": {"zone": True, "quality": 2}}]}
        found = spyrrow.solution(document)
        self.assertEqual([item.id for item in found.placed_items], ["square"])
        self.assertEqual((found.width, found.density), (20, 0.5))

    def test_a_negative_number_of_copies_is_refused(self):
        with self.assertRaises(ValueError) as raised:
            selvage_client.nest([selvage_client.Pattern(outline=SQUARE, name="cuff", quantity=-1), ELL], 60,
                                moves=200, address=self.daemon.address)
        self.assertIn("quantity of pattern 'cuff' is -1; 0 or a larger whole number is allowed", str(raised.exception))
        with self.assertRaises(ValueError) as raised:
            spyrrow.Item("cuff", SQUARE, -1, [])
        self.assertIn("demand of item 'cuff' is -1; 0", str(raised.exception))
        found = selvage_client.nest([selvage_client.Pattern(outline=SQUARE, quantity=0), ELL], 60, moves=200,
                                    address=self.daemon.address)
        self.assertEqual([piece.pattern for piece in found.pieces], [1])

    def test_a_configuration_has_one_kind_of_budget(self):
        self.assertEqual(spyrrow.StripPackingConfig().exploration_time.total_seconds(), 480)
        parts = spyrrow.StripPackingConfig(total_computation_time=None, exploration_time=3, compression_time=1)
        self.assertEqual(parts.compression_time.total_seconds(), 1)
        for times in ({"exploration_time": 3}, {"total_computation_time": None, "exploration_time": 3},
                      {"total_computation_time": None}):
            with self.assertRaises(ValueError):
                spyrrow.StripPackingConfig(**times)


if __name__ == "__main__":
    unittest.main()
