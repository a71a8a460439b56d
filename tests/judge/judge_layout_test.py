#!/usr/bin/env python3
"""Tests the judge: on layouts whose violations are obvious, and on random ones checked by another method."""
import pathlib
import random
import subprocess
import sys
import tempfile
import unittest
from fractions import Fraction

import judge_layout
from judge_layout import violations

LEAST = Fraction(1, 10**12)


def layout(*outlines, height=10, length=10):
    pieces = [{"id": f"p{k}", "outline": outline} for k, outline in enumerate(outlines)]
    return {"strip_height": height, "strip_length": length, "pieces": pieces}


def box(x, y, width, height):
    return [(x, y), (x + width, y), (x + width, y + height), (x, y + height)]


def moved(outline, dx, dy):
    return [(x + dx, y + dy) for x, y in outline]


class Judged(unittest.TestCase):
    def valid(self, *outlines, **strip):
        self.assertEqual(list(violations(layout(*outlines, **strip))), [])

    def violates(self, word, *outlines, count=1, **strip):
        for order in (outlines, outlines[::-1]):
            found = list(violations(layout(*order, **strip)))
            self.assertEqual(len(found), count, found)
            self.assertTrue(all(word in violation for violation in found), found)


class OverlapsUpToTheAllowance(Judged):
    def judged(self, one, other, *allowances, valid):
        document = layout(one, other, height=40, length=40)
        for piece, allowance in zip(document["pieces"], allowances):
            piece["overlap"] = allowance
        self.assertEqual(not list(violations(document)), valid)

    def test_squares(self):
        squares = box(3, 3, 10, 10), box(11, 5, 10, 10)  # overlap by 2 along x
        self.judged(*squares, 2, 2, valid=True)
        self.judged(*squares, 2 - LEAST, 2, valid=False)
        self.judged(*squares, 2, 5, valid=True)
        self.judged(*squares, 2, valid=False)
        self.judged(*squares, valid=False)

    def test_along_a_slanted_edge(self):
        below = moved([(0, 0), (20, 0), (20, 15)], 5, 5)
        above = moved([(0, 0), (20, 15), (0, 15)], 5 + Fraction(3, 10), 5 - Fraction(4, 10))  # half a unit across the edge
        self.judged(below, above, Fraction(1, 2), 1, valid=True)
        self.judged(below, above, Fraction(1, 2) - LEAST, 1, valid=False)

    def test_whose_least_translation_is_no_decimal(self):
        below = moved([(0, 0), (20, 0), (20, 10)], 5, 5)
        above = moved([(0, 0), (20, 10), (0, 10)], 5, 5 - Fraction(1, 4))  # by 1 / sqrt(20) = 0.22360679...
        self.judged(below, above, Fraction("0.2236068"), 1, valid=True)
        self.judged(below, above, Fraction("0.2236067"), 1, valid=False)

    def test_in_a_notch_the_least_translation_leads_to_its_foot(self):
        notched = [(0, 0), (30, 0), (30, 10), (10, 10), (10, 30), (0, 30)]
        block = box(10 - 3, 10 - 4, 8, 8)  # 3, 4, 5
        self.judged(notched, block, 5, 5, valid=True)
        self.judged(notched, block, 5 - LEAST, 5, valid=False)

    def test_a_strap_thinner_than_the_allowance_may_lie_inside(self):
        self.judged(box(0, 0, 20, 20), box(5, 0, 10, 1), 1, 1, valid=True)
        self.judged(box(0, 0, 20, 20), box(5, 1, 10, 1), 1, 1, valid=False)


class ClothsRules(Judged):
    def judged(self, *outlines, rules=(), **strip):
        document = {**layout(*outlines, height=40, length=100), **strip}
        for piece, own in zip(document["pieces"], rules):
            piece["rules"] = own
        return list(violations(document))

    def keeps(self, *outlines, **rest):
        self.assertEqual(self.judged(*outlines, **rest), [])

    def breaks(self, word, *outlines, **rest):
        found = self.judged(*outlines, **rest)
        self.assertEqual(len(found), 1, found)
        self.assertIn(word, found[0])

    def test_selvedges_of_the_strip_and_of_a_piece(self):
        square = box(10, 3, 10, 30)
        self.keeps(square, below=3, above=7)
        self.breaks("lower edge", square, below=3 + LEAST)
        self.breaks("upper edge", square, above=7 + LEAST)
        self.keeps(square, below=5, rules=[{"below": 3}])
        self.breaks("upper edge", square, above=1, rules=[{"above": 7 + LEAST}])

    def test_bands(self):
        square = box(10, 3, 10, 30)
        self.keeps(square, rules=[{"from": 10, "to": 20}])
        self.breaks("band", square, rules=[{"from": 10 + LEAST}])
        self.breaks("band", square, rules=[{"to": 20 - LEAST}])

    def test_the_fold_is_the_lower_edge(self):
        self.keeps(box(10, 0, 10, 10), below=5, rules=[{"fold": True}])
        self.breaks("fold", box(10, LEAST, 10, 10), rules=[{"fold": True}])

    def test_both_edges_of_a_tube_are_folds(self):
        upper = box(10, 30, 10, 10)
        self.keeps(upper, above=5, tube=True, rules=[{"fold": True}])
        self.breaks("fold", upper, rules=[{"fold": True}])
        self.breaks("fold", box(10, 30 - LEAST, 10, 10), tube=True, rules=[{"fold": True}])
        self.breaks("fold", [(0, 0), (20, 40), (0, 40 - LEAST)], tube=True, rules=[{"fold": True}])
        self.breaks("upper edge", upper, above=5, tube=True)

    def test_pieces_lie_on_zones_whose_quality_they_accept(self):
        square, zone = box(10, 10, 10, 10), box(15, -5, 60, 200)
        self.keeps(square, zone, rules=[{"quality": 2}, {"zone": True, "quality": 2}])
        self.breaks("overlap", square, zone, rules=[{"quality": 1}, {"zone": True, "quality": 2}])
        self.breaks("overlap", square, zone, rules=[{}, {"zone": True, "quality": 1}])
        self.breaks("overlap", square, zone, rules=[{"quality": 99}, {"zone": True}])

    def test_parts_of_pieces_lie_on_no_zone_that_is_too_bad_for_them(self):
        square, zone = box(10, 10, 10, 10), {"zone": True, "quality": 2}
        seen = lambda quality: {"quality": 2, "part": {"outline": box(16, 10, 4, 10), "quality": quality}}
        self.keeps(square, box(5, 0, 11, 30), rules=[seen(0), zone])
        self.breaks("overlap", square, box(5, 0, 11 + LEAST, 30), rules=[seen(0), zone])
        self.breaks("overlap", square, box(5, 0, 11 + LEAST, 30), rules=[seen(1), zone])
        self.keeps(square, box(5, 0, 11 + LEAST, 30), rules=[seen(2), zone])
        self.keeps(square, box(5, 0, 11 + LEAST, 30), rules=[seen(1), {"zone": True, "quality": 1}])
        self.breaks("overlap", square, box(5, 0, 11, 30), rules=[{**seen(0), "quality": 1}, zone])
        bow_tie = {"quality": 2, "part": {"outline": [(10, 10), (20, 20), (20, 10), (10, 20)]}}
        self.breaks("its part crosses itself", square, rules=[bow_tie])

    def test_pieces_lie_with_their_nap(self):
        square = box(10, 10, 10, 10)
        for rotation in (0, 89, -89, 360, -360):
            self.keeps(square, rules=[{"nap": "up", "rotation": rotation}])
            self.breaks("nap", square, rules=[{"nap": "down", "rotation": rotation}])
        for rotation in (90, -90, 270, Fraction("180.5")):
            self.breaks("nap", square, rules=[{"nap": "up", "rotation": rotation}])
        self.keeps(square, rules=[{"nap": "down", "rotation": 180}])

    def test_zones_lie_anywhere_except_under_pieces(self):
        zone = {"zone": True}
        square, flaw = box(10, 10, 10, 10), box(20, -5, 60, 200)
        self.keeps(square, flaw, box(30, 0, 100, 10), below=5, rules=[{}, zone, zone])
        self.breaks("overlap", square, box(20 - LEAST, -5, 60, 200), rules=[{}, zone])
        self.assertTrue(self.judged(square, flaw))

    def test_match_points_lie_where_repeats_begin(self):
        square = box(10, 3, 10, 30)
        repeat = {"along": 7, "across": 10, "phase": [3, 5]}
        self.keeps(square, repeat=repeat, rules=[{"match": [17, 15]}])
        self.breaks("along x", square, repeat=repeat, rules=[{"match": [17 + LEAST, 15]}])
        self.breaks("along y", square, repeat=repeat, rules=[{"match": [17, 16]}])
        self.keeps(square, repeat={"across": 10}, rules=[{"match": [17 + LEAST, 10]}])

    def test_match_points_of_a_set_lie_whole_repeats_apart(self):
        squares = box(0, 0, 20, 20), box(40, 0, 20, 20)
        repeat = {"along": 10, "phase": [7, 0]}
        rules = lambda x: [{"match": [5, 5], "matchSet": "A"}, {"match": [x, 5], "matchSet": "A"}]
        self.keeps(*squares, repeat=repeat, rules=rules(45))
        self.breaks('match set "A" along x', *squares, repeat=repeat, rules=rules(45 + LEAST))

    def test_shades_may_have_the_full_allowed_length(self):
        squares = box(10, 0, 10, 10), box(60, 0, 10, 10), box(90, 0, 10, 10)
        rules = [{"shade": "A"}, {"shade": "A"}, {"shade": "B"}]
        self.keeps(*squares, rules=rules)
        self.keeps(*squares, rules=rules, shade=60)
        self.breaks("shade", *squares, rules=rules, shade=60 - LEAST)
        self.breaks('"A"', *squares, rules=[{"shade": "A"}] * 3, shade=60)


class TouchingIsAllowed(Judged):
    def test_squares_along_a_whole_edge_and_part_of_one(self):
        for dx, dy in ((2, 0), (2, 1), (0, 2), (1, 2), (-1, 2)):
            self.valid(box(3, 3, 2, 2), box(3 + dx, 3 + dy, 2, 2))

    def test_squares_at_a_corner(self):
        for dx, dy in ((2, 2), (-2, 2), (2, -2), (-2, -2)):
            self.valid(box(3, 3, 2, 2), box(3 + dx, 3 + dy, 2, 2))

    def test_along_a_slanted_edge_whose_heights_are_not_decimals(self):
        self.valid([(0, 0), (7, 0), (7, 3)], [(0, 0), (7, 3), (0, 3)])

    def test_stars_at_a_point(self):
        star = [(0, 3), (2, 2), (3, 0), (4, 2), (6, 3), (4, 4), (3, 6), (2, 4)]
        for dx, dy in ((6, 0), (0, 6), (-6, 0), (4, 4)):  # tip to tip; side by side, interlocked
            self.valid(moved(star, 7, 7), moved(star, 7 + dx, 7 + dy), height=20, length=20)

    def test_a_piece_in_a_hole_that_it_fills(self):
        ring = [(0, 0), (6, 0), (6, 6), (4, 6), (4, 2), (2, 2), (2, 6), (0, 6)]
        self.valid(ring, box(2, 2, 2, 4))

    def test_touching_the_edges_of_the_strip(self):
        self.valid(box(0, 0, 4, 3), height=3, length=4)


class OverlappingIsAViolation(Judged):
    def test_by_a_tiny_amount(self):
        for dx, dy in ((2 - LEAST, 0), (0, 2 - LEAST), (2 - LEAST, 2 - LEAST), (LEAST - 2, 1), (1, LEAST - 2)):
            self.violates("overlap", box(3, 3, 2, 2), box(3 + dx, 3 + dy, 2, 2))

    def test_one_inside_the_other(self):
        self.violates("overlap", box(0, 0, 9, 9), box(4, 4, 1, 1))
        self.violates("overlap", box(0, 0, 9, 9), box(0, 0, 1, 1))  # touching its edges from inside

    def test_equal_pieces(self):
        slanted = [(0, 0), (5, 1), (6, 4), (1, 3)]
        self.violates("overlap", slanted, slanted)
        self.violates("overlap", slanted, slanted[2:] + slanted[:2])
        self.violates("overlap", slanted, slanted[::-1])

    def test_a_cross_where_no_vertex_is_inside_the_other(self):
        self.violates("overlap", box(0, 4, 9, 1), box(4, 0, 1, 9))
        self.violates("overlap", [(0, 0), (1, 0), (9, 8), (9, 9)], [(0, 8), (8, 0), (9, 0), (0, 9)])

    def test_a_tip_that_enters_by_a_tiny_amount(self):
        wedge = [(5, 5), (9, 4), (9, 6)]
        self.valid(box(0, 0, 5, 9), wedge)
        self.violates("overlap", box(0, 0, 5, 9), moved(wedge, -LEAST, 0))

    def test_a_piece_in_a_hole_a_little_too_small(self):
        ring = [(0, 0), (6, 0), (6, 6), (4, 6), (4, 2 - LEAST), (2, 2), (2, 6), (0, 6)]
        self.valid(ring, box(2, 2, 2, 4))
        self.violates("overlap", [(x, y if (x, y) != (4, 2 - LEAST) else 2 + LEAST) for x, y in ring], box(2, 2, 2, 4))

    def test_every_pair_is_reported(self):
        self.violates("overlap", *(box(k, 0, 3, 3) for k in range(4)), count=5)


class LeavingTheStrip(Judged):
    def test_by_a_tiny_amount(self):
        for dx, dy in ((-LEAST, 0), (LEAST, 0), (0, -LEAST), (0, LEAST)):
            self.violates("leaves the strip", moved(box(0, 0, 4, 3), dx, dy), height=3, length=4)


class InvalidOutlines(Judged):
    def test_an_outline_that_crosses_itself(self):
        self.violates("crosses itself", [(0, 0), (4, 4), (4, 0), (0, 4)])

    def test_outlines_without_an_interior(self):
        for flat in ([(0, 0), (4, 4), (2, 2)], [(1, 1)], [(3, 0), (3, 4)], box(0, 0, 2, 2) + box(0, 0, 2, 2)[::-1]):
            self.violates("no interior", flat)


def area_shared(one, other):
    """Twice the area of the intersection of two convex counter-clockwise polygons: one, clipped by the other's edges."""
    for (ax, ay), (bx, by) in zip(other, other[1:] + other[:1]):
        side = [(bx - ax) * (y - ay) - (by - ay) * (x - ax) for x, y in one]
        kept = []
        for k, (x, y) in enumerate(one):
            (px, py), before, here = one[k - 1], side[k - 1], side[k]
            if before * here < 0:
                part = Fraction(before, before - here)
                kept.append((px + part * (x - px), py + part * (y - py)))
            if here >= 0:
                kept.append((x, y))
        one = kept
    return sum(x0 * y1 - x1 * y0 for (x0, y0), (x1, y1) in zip(one, one[1:] + one[:1]))


class ComparedWithAnotherMethod(unittest.TestCase):
    def test_random_triangles(self):
        chance = random.Random(7)
        seen = {False: 0, True: 0}
        while sum(seen.values()) < 3000:
            ours, theirs = ([(chance.randrange(7), chance.randrange(7)) for _ in range(3)] for _ in range(2))
            if area_shared(ours, ours) <= 0 or area_shared(theirs, theirs) <= 0:
                continue
            shared = area_shared(ours, theirs) > 0
            found = list(violations(layout(ours, theirs)))
            self.assertEqual(bool(found), shared, (ours, theirs, found))
            seen[shared] += 1
        self.assertGreater(min(seen.values()), 500)


class Files(unittest.TestCase):
    def judged(self, text):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "layout.json"
            path.write_text(text, encoding="utf-8")
            return subprocess.run([sys.executable, judge_layout.__file__, path], capture_output=True, text=True, check=False)

    def two_boxes(self, end, start):
        outline = '[[{0}, 0], [{1}, 0], [{1}, 1], [{0}, 1]]'
        pieces = ", ".join('{"id": "%s", "outline": %s}' % (name, outline.format(low, high))
                           for name, low, high in (("a", "0", end), ("b", start, "1e1")))
        return self.judged('{"strip_height": 1, "strip_length": 10.0, "pieces": [%s]}' % pieces)

    def test_numbers_are_exact_decimals(self):
        for end, start in (("0.3", "0.3"), ("0.3", "3e-1"), ("0.1000000000000000055", "0.1000000000000000056"), ("1", "1.0")):
            judged = self.two_boxes(end, start)
            self.assertEqual(judged.returncode, 0, judged.stdout + judged.stderr)
            self.assertIn("2 pieces, 0 violations", judged.stdout)
        # These decimals differ, although they are the same double.
        judged = self.two_boxes("0.1000000000000000056", "0.1000000000000000055")
        self.assertEqual(judged.returncode, 1, judged.stderr)
        self.assertIn('pieces "a" and "b" overlap', judged.stdout)

    def test_malformed_layouts_are_rejected(self):
        for text in ("", "{}", '{"strip_height": NaN, "strip_length": 1, "pieces": []}'):
            self.assertEqual(self.judged(text).returncode, 1, text)


if __name__ == "__main__":
    unittest.main()
