#!/usr/bin/env python3
"""Is the judge itself just?  Layouts of which everyone can see what is wrong, and random ones judged another way too."""
import pathlib
import random
import subprocess
import sys
import tempfile
import unittest
from fractions import Fraction

import judge_layout
from judge_layout import offences

LEAST = Fraction(1, 10**12)


def layout(*outlines, height=10, length=10):
    pieces = [{"id": f"p{k}", "outline": outline} for k, outline in enumerate(outlines)]
    return {"strip_height": height, "strip_length": length, "pieces": pieces}


def box(x, y, width, height):
    return [(x, y), (x + width, y), (x + width, y + height), (x, y + height)]


def moved(outline, dx, dy):
    return [(x + dx, y + dy) for x, y in outline]


class Judged(unittest.TestCase):
    def sound(self, *outlines, **strip):
        self.assertEqual(list(offences(layout(*outlines, **strip))), [])

    def guilty(self, word, *outlines, count=1, **strip):
        for order in (outlines, outlines[::-1]):
            found = list(offences(layout(*order, **strip)))
            self.assertEqual(len(found), count, found)
            self.assertTrue(all(word in offence for offence in found), found)


class TouchingIsAllowed(Judged):
    def test_squares_along_a_whole_edge_and_part_of_one(self):
        for dx, dy in ((2, 0), (2, 1), (0, 2), (1, 2), (-1, 2)):
            self.sound(box(3, 3, 2, 2), box(3 + dx, 3 + dy, 2, 2))

    def test_squares_at_a_corner(self):
        for dx, dy in ((2, 2), (-2, 2), (2, -2), (-2, -2)):
            self.sound(box(3, 3, 2, 2), box(3 + dx, 3 + dy, 2, 2))

    def test_along_a_slanted_edge_whose_heights_no_decimal_holds(self):
        self.sound([(0, 0), (7, 0), (7, 3)], [(0, 0), (7, 3), (0, 3)])

    def test_stars_in_a_point(self):
        star = [(0, 3), (2, 2), (3, 0), (4, 2), (6, 3), (4, 4), (3, 6), (2, 4)]
        for dx, dy in ((6, 0), (0, 6), (-6, 0), (4, 4)):  # tip to tip; beside each other, in each other's hollows
            self.sound(moved(star, 7, 7), moved(star, 7 + dx, 7 + dy), height=20, length=20)

    def test_a_piece_in_a_hole_that_it_fills(self):
        ring = [(0, 0), (6, 0), (6, 6), (4, 6), (4, 2), (2, 2), (2, 6), (0, 6)]
        self.sound(ring, box(2, 2, 2, 4))

    def test_the_strips_edges(self):
        self.sound(box(0, 0, 4, 3), height=3, length=4)


class OverlappingIsNot(Judged):
    def test_by_next_to_nothing(self):
        for dx, dy in ((2 - LEAST, 0), (0, 2 - LEAST), (2 - LEAST, 2 - LEAST), (LEAST - 2, 1), (1, LEAST - 2)):
            self.guilty("overlap", box(3, 3, 2, 2), box(3 + dx, 3 + dy, 2, 2))

    def test_one_inside_the_other(self):
        self.guilty("overlap", box(0, 0, 9, 9), box(4, 4, 1, 1))
        self.guilty("overlap", box(0, 0, 9, 9), box(0, 0, 1, 1))  # and along its edges

    def test_equal_pieces(self):
        slanted = [(0, 0), (5, 1), (6, 4), (1, 3)]
        self.guilty("overlap", slanted, slanted)
        self.guilty("overlap", slanted, slanted[2:] + slanted[:2])
        self.guilty("overlap", slanted, slanted[::-1])

    def test_a_cross_where_no_vertex_is_inside_the_other(self):
        self.guilty("overlap", box(0, 4, 9, 1), box(4, 0, 1, 9))
        self.guilty("overlap", [(0, 0), (1, 0), (9, 8), (9, 9)], [(0, 8), (8, 0), (9, 0), (0, 9)])

    def test_a_tip_that_enters_by_next_to_nothing(self):
        wedge = [(5, 5), (9, 4), (9, 6)]
        self.sound(box(0, 0, 5, 9), wedge)
        self.guilty("overlap", box(0, 0, 5, 9), moved(wedge, -LEAST, 0))

    def test_a_piece_in_a_hole_a_little_too_small(self):
        ring = [(0, 0), (6, 0), (6, 6), (4, 6), (4, 2 - LEAST), (2, 2), (2, 6), (0, 6)]
        self.sound(ring, box(2, 2, 2, 4))
        self.guilty("overlap", [(x, y if (x, y) != (4, 2 - LEAST) else 2 + LEAST) for x, y in ring], box(2, 2, 2, 4))

    def test_every_pair_is_told(self):
        self.guilty("overlap", *(box(k, 0, 3, 3) for k in range(4)), count=5)


class TheStrip(Judged):
    def test_left_by_next_to_nothing(self):
        for dx, dy in ((-LEAST, 0), (LEAST, 0), (0, -LEAST), (0, LEAST)):
            self.guilty("leaves the strip", moved(box(0, 0, 4, 3), dx, dy), height=3, length=4)


class OutlinesThatAreNone(Judged):
    def test_an_outline_that_crosses_itself(self):
        self.guilty("crosses itself", [(0, 0), (4, 4), (4, 0), (0, 4)])

    def test_outlines_without_an_inside(self):
        for flat in ([(0, 0), (4, 4), (2, 2)], [(1, 1)], [(3, 0), (3, 4)], box(0, 0, 2, 2) + box(0, 0, 2, 2)[::-1]):
            self.guilty("no inside", flat)


def area_shared(one, other):
    """Twice the area that two convex counter-clockwise polygons share: one, cut by the other's edges in turn."""
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


class BesideAnotherMethod(unittest.TestCase):
    def test_random_triangles(self):
        chance = random.Random(7)
        seen = {False: 0, True: 0}
        while sum(seen.values()) < 3000:
            ours, theirs = ([(chance.randrange(7), chance.randrange(7)) for _ in range(3)] for _ in range(2))
            if area_shared(ours, ours) <= 0 or area_shared(theirs, theirs) <= 0:
                continue
            shared = area_shared(ours, theirs) > 0
            found = list(offences(layout(ours, theirs)))
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

    def test_numbers_are_the_decimals_that_are_printed(self):
        for end, start in (("0.3", "0.3"), ("0.3", "3e-1"), ("0.1000000000000000055", "0.1000000000000000056"), ("1", "1.0")):
            judged = self.two_boxes(end, start)
            self.assertEqual(judged.returncode, 0, judged.stdout + judged.stderr)
            self.assertIn("2 pieces, 0 offences", judged.stdout)
        # As doubles these are the same number.
        judged = self.two_boxes("0.1000000000000000056", "0.1000000000000000055")
        self.assertEqual(judged.returncode, 1, judged.stderr)
        self.assertIn('pieces "a" and "b" overlap', judged.stdout)

    def test_what_is_no_layout_is_not_valid(self):
        for text in ("", "{}", '{"strip_height": NaN, "strip_length": 1, "pieces": []}'):
            self.assertEqual(self.judged(text).returncode, 1, text)


if __name__ == "__main__":
    unittest.main()
