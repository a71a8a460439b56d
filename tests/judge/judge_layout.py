#!/usr/bin/env python3
"""Checks layouts exactly: no piece may leave the strip and no two may overlap.  Shares no code with Selvage.

usage: judge_layout.py FILE...

FILE: placed outlines, as `selvage compact --outlines FILE` and `selvage convert --format outlines` write them:
{"strip_height": H, "strip_length": L, "below": B, "above": A, "tube": true, "shade": S, "repeat": {"along": X, "across": Y, "phase": [x, y]},
 "pieces": [{"id": ID, "outline": [[x, y], ...], "overlap": A, "rules": {"below": ..., "shade": NAME}}, ...]}.
Numbers are read as exact decimals and all tests use integers and fractions, so there is no tolerance.
Pieces may touch each other and the strip's edges.  Two pieces with an `overlap` may overlap when a translation of one of
them, no longer than the smaller of their two, separates them; it is looked for among fractions, too.  Prints each violation; exit status 1 if there is any.

Pieces keep cloth's rules: the distances `below` and `above` from the long edges, the piece's own or else the strip's; `from`
and `to`, between which a piece lies along the strip; `match`, a point that lies where a repeat of the cloth begins or,
with the same `matchSet`, whole repeats from that of the other pieces; `fold`, on which its lowest side lies, or its highest one on the upper edge of a tube; and all pieces of one shade
lie within the length `shade`.  A piece with the rule `zone` is a part of the cloth: it may lie anywhere and over other
zones, but no piece may overlap it, unless the zone has a `quality` that is at most the piece's; its own allowance is 0.  A `part` of a piece, an outline of
its own, has a quality of its own: it may not overlap zones that are worse.

Two pieces overlap when some vertical line intersects both in intervals that share more than a point.  Between the
abscissas of two neighbouring vertices, a piece is a stack of trapezoids, so it suffices to compare trapezoids: two
trapezoids between the same two vertical lines share no interior point exactly when one lies below the other.

The translations that part two pieces are the outside of the Minkowski sum of one with the reflection of the other.  The
shortest one leads to its boundary, which is part of the lines along which a vertex of one piece slides on an edge of the
other: to the foot of the perpendicular on such a line, or to where two of them cross.  All of these points are tried.
"""
import argparse
import json
import math
import sys
from fractions import Fraction
from itertools import pairwise
from typing import NamedTuple


class Edge(NamedTuple):
    left: tuple
    right: tuple

    def height_at(self, x):
        (x0, y0), (x1, y1) = self
        if x == x0:
            return y0
        if x == x1:
            return y1
        return Fraction(y0 * (x1 - x) + y1 * (x - x0), x1 - x0)


class Piece:
    def __init__(self, name, outline, allowance=0, zone=False, quality=None, part=None):
        self.name = name
        self.zone = zone
        self.quality = quality
        self.part = part  # a Piece, or None
        self.outline = outline
        self.allowance = allowance
        self.abscissas = sorted({x for x, _ in outline})
        self.low_y, self.high_y = min(y for _, y in outline), max(y for _, y in outline)
        ends = (sorted(pair) for pair in zip(outline, outline[1:] + outline[:1]))
        self.edges = sorted(Edge(a, b) for a, b in ends if a[0] < b[0])

    @property
    def low_x(self):
        return self.abscissas[0]

    @property
    def high_x(self):
        return self.abscissas[-1]

    def lies_on(self, height):
        """True when a side of the outline lies at this y and no part of it beyond."""
        sides = zip(self.outline, self.outline[1:] + self.outline[:1])
        return height in (self.low_y, self.high_y) and any(a[1] == b[1] == height for a, b in sides)

    def stacks(self, cuts):
        """Yields, for every two neighbouring `cuts`, the piece's edges from the lowest up, as their heights at both cuts.

        REQUIRES: no vertex lies strictly between two neighbouring cuts.  Edges 0 and 1, 2 and 3, ... enclose the piece.
        """
        reached, coming = [], 0  # (height at the current cut, edge)
        for x0, x1 in pairwise(cuts):
            while coming < len(self.edges) and self.edges[coming].left[0] <= x0:
                reached.append((self.edges[coming].height_at(x0), self.edges[coming]))
                coming += 1
            reached = [(height, edge) for height, edge in reached if edge.right[0] > x0]
            stack = sorted((height, edge.height_at(x1), edge) for height, edge in reached)
            yield [ends for *ends, _ in stack]
            reached = [(height, edge) for _, height, edge in stack]


def below(one, other):
    """True when one edge lies nowhere above the other between two cuts (each given by its heights at the cuts)."""
    return one[0] <= other[0] and one[1] <= other[1]


def trapezoids(stack):
    return [(low, high) for low, high in zip(stack[::2], stack[1::2]) if low != high]


def fault_of_outline(piece):
    """Why the outline is not a simple polygon; None when it is one."""
    has_interior = False
    for stack in piece.stacks(piece.abscissas):
        if not all(below(low, high) for low, high in pairwise(stack)):
            return "crosses itself"
        has_interior = has_interior or bool(trapezoids(stack))
    return None if has_interior else "has no interior"


def overlap(one, other):
    """Two abscissas between which the pieces overlap, or None.  REQUIRES: both outlines are simple polygons."""
    left, right = max(one.low_x, other.low_x), min(one.high_x, other.high_x)
    if left >= right or max(one.low_y, other.low_y) >= min(one.high_y, other.high_y):
        return None
    cuts = sorted({x for piece in (one, other) for x in piece.abscissas if left <= x <= right})
    for slab, *stacks in zip(pairwise(cuts), one.stacks(cuts), other.stacks(cuts)):
        ours, theirs = map(trapezoids, stacks)
        while ours and theirs:
            if below(ours[-1][1], theirs[-1][0]):
                theirs.pop()
            elif below(theirs[-1][1], ours[-1][0]):
                ours.pop()
            else:
                return slab
    return None


def contact_lines(one, other, reach):
    """The segments of translations of `other` along which a vertex of one piece slides on an edge of the other, as far
    as they may come within `reach` of 0."""
    for p, sign in ((one, 1), (other, -1)):
        q = other if p is one else one
        for vx, vy in p.outline:
            for (ax, ay), (bx, by) in zip(q.outline, q.outline[1:] + q.outline[:1]):
                start, end = (sign * (vx - ax), sign * (vy - ay)), (sign * (vx - bx), sign * (vy - by))
                if all(min(s, e) <= reach and max(s, e) >= -reach for s, e in zip(start, end)):
                    yield start, end


def foot(line):
    """The point of a segment nearest to 0."""
    (ax, ay), (bx, by) = line
    dx, dy = bx - ax, by - ay
    part = min(max(Fraction(-(ax * dx + ay * dy), dx * dx + dy * dy), 0), 1)
    return ax + part * dx, ay + part * dy


def crossing(one, other):
    """The point where two segments cross; None if they do not cross or are parallel."""
    (ax, ay), (bx, by) = one
    (cx, cy), (dx, dy) = other
    turn = (bx - ax) * (dy - cy) - (by - ay) * (dx - cx)
    if turn == 0:
        return None
    part = Fraction((cx - ax) * (dy - cy) - (cy - ay) * (dx - cx), turn)
    along = Fraction((cx - ax) * (by - ay) - (cy - ay) * (bx - ax), turn)
    if not (0 <= part <= 1 and 0 <= along <= 1):
        return None
    return ax + part * (bx - ax), ay + part * (by - ay)


def parts(one, other, by):
    """True when the pieces do not overlap with `other` moved by a vector of fractions."""
    x, y = map(Fraction, by)
    unit = math.lcm(x.denominator, y.denominator)
    still = Piece("", [(a * unit, b * unit) for a, b in one.outline])
    moved = Piece("", [(a * unit + int(x * unit), b * unit + int(y * unit)) for a, b in other.outline])
    return overlap(still, moved) is None


def may_overlap(one, other):
    """True when a translation of one piece, no longer than what the two are allowed, separates them."""
    reach = min(one.allowance, other.allowance)
    if reach == 0:
        return False
    square = lambda point: point[0] ** 2 + point[1] ** 2
    lines = [line for line in contact_lines(one, other, reach) if square(foot(line)) <= reach**2]
    feet = {foot(line) for line in lines}
    if any(parts(one, other, by) for by in sorted(feet, key=square)):
        return True
    crossings = {crossing(a, b) for k, a in enumerate(lines) for b in lines[:k]} - {None} - feet
    return any(parts(one, other, by) for by in sorted(crossings, key=square) if square(by) <= reach**2)


def may_share_cloth(one, other):
    """True for two zones, and for a zone and a piece that accepts the quality of its cloth."""
    if one.zone == other.zone:
        return one.zone
    zone, piece = (one, other) if one.zone else (other, one)
    return zone.quality is not None and zone.quality <= (piece.quality or 0)


def meeting(one, other):
    """The two outlines that may not overlap: the pieces, or the part of a piece and a zone that is good enough for the
    rest of it; None when the pieces may lie over each other."""
    if not may_share_cloth(one, other):
        return one, other
    for piece, zone in ((one, other), (other, one)):
        if zone.zone and piece.part and not may_share_cloth(piece.part, zone):
            return piece.part, zone
    return None


def overlaps(pieces):
    """Yields (one, other, abscissas) for every pair with a forbidden overlap."""
    near = []
    for piece in sorted(pieces, key=lambda p: p.low_x):
        near = [other for other in near if other.high_x > piece.low_x]
        for other in near:
            met = meeting(other, piece)
            where = overlap(*met) if met else None
            if where and not may_overlap(other, piece):
                yield other, piece, where
        near.append(piece)


def broken_rules(piece, rules, strip):
    """Yields the violated rules for one piece's position; all numbers are in the same unit."""
    own = {**strip, **rules}
    on_lower = rules.get("fold") and piece.lies_on(0)
    on_upper = rules.get("fold") and strip.get("tube") and piece.lies_on(strip["height"])
    if rules.get("fold") and not on_lower and not on_upper:
        yield "does not lie on the fold"
    elif not on_lower and piece.low_y < own.get("below", piece.low_y):
        yield "is too near the lower edge"
    if "above" in own and not on_upper and strip["height"] - piece.high_y < own["above"]:
        yield "is too near the upper edge"
    quarters = abs((rules.get("rotation", 0) + 180) % 360 - 180)  # degrees from the strip's direction
    if (rules.get("nap") == "up" and quarters >= 90) or (rules.get("nap") == "down" and quarters <= 90):
        yield "lies against its nap"
    if piece.low_x < rules.get("from", piece.low_x) or piece.high_x > rules.get("to", piece.high_x):
        yield "leaves its band"


def off_repeat(point, repeat):
    """Yields the axes on which a match point lies where no repeat of the cloth begins; all numbers in the same unit."""
    for axis, length, at, phase in zip("xy", (repeat.get("along", 0), repeat.get("across", 0)), point, repeat.get("phase", (0, 0))):
        if length and (at - phase) % length:
            yield axis


def long_shades(pieces, longest):
    """Yields the names of the shades whose pieces take more of the length than `longest`; `pieces`: (name, piece)."""
    for name in sorted({name for name, _ in pieces}):
        of_it = [piece for other, piece in pieces if other == name]
        if max(p.high_x for p in of_it) - min(p.low_x for p in of_it) > longest:
            yield name


def violations(layout):
    """Yields a sentence for every violation in a layout, which is given as `read` returns it."""
    numbers = [layout["strip_height"], layout["strip_length"]]
    numbers += [c for piece in layout["pieces"] for point in piece["outline"] for c in point]
    numbers += [c for piece in layout["pieces"] for point in piece.get("rules", {}).get("part", {}).get("outline", []) for c in point]
    numbers += [piece.get("overlap", 0) for piece in layout["pieces"]]
    repeat = layout.get("repeat", {})
    numbers += [value for key, value in repeat.items() if key != "phase"] + list(repeat.get("phase", []))
    numbers += [c for piece in layout["pieces"] for c in piece.get("rules", {}).get("match", [])]
    lengths = [{key: value for key, value in rules.items() if key in ("below", "above", "from", "to", "shade")}
               for rules in [layout] + [piece.get("rules", {}) for piece in layout["pieces"]]]
    numbers += [value for rules in lengths for value in rules.values() if not isinstance(value, str)]
    unit = math.lcm(*(Fraction(number).denominator for number in numbers))  # all numbers are whole multiples of 1 / unit
    whole = lambda number: int(number * unit)
    decimal = lambda number: number / unit

    height, length = whole(layout["strip_height"]), whole(layout["strip_length"])
    scaled = lambda rules: {k: v if isinstance(v, (bool, str)) or k in ("rotation", "quality") else [whole(c) for c in v] if isinstance(v, list) else whole(v)
                            for k, v in rules.items() if k != "part"}
    strip = {"height": height, "tube": layout.get("tube", False), **{key: whole(layout[key]) for key in ("below", "above") if key in layout}}
    sound, shaded, sets = [], [], {}
    for written in layout["pieces"]:
        outline = [(whole(x), whole(y)) for x, y in written["outline"]]
        own = written.get("rules", {})
        piece = Piece(f'"{written["id"]}"', outline, whole(written.get("overlap", 0)), own.get("zone", False), own.get("quality"))
        if "part" in own:
            corners = [(whole(x), whole(y)) for x, y in own["part"]["outline"]]
            piece.part = Piece(f"the part of {piece.name}", corners, 0, False, own["part"].get("quality", 0))
            fault = fault_of_outline(piece.part)
            if fault:
                yield f"piece {piece.name}: its part {fault}"
                piece.part = None
        fault = fault_of_outline(piece)
        if fault:
            yield f"piece {piece.name}: its outline {fault}"
        else:
            sound.append(piece)
        if piece.zone:
            continue
        for end, limit in ((piece.high_x, length), (piece.high_y, height)):
            if end > limit:
                yield f"piece {piece.name} leaves the strip: {decimal(end)} is beyond {decimal(limit)}"
        for end in (piece.low_x, piece.low_y):
            if end < 0:
                yield f"piece {piece.name} leaves the strip: {decimal(end)} is below 0"
        rules = scaled(written.get("rules", {}))
        for broken in broken_rules(piece, rules, strip):
            yield f"piece {piece.name} {broken}"
        if "match" in rules:
            name = rules.get("matchSet")
            origin = {"phase": sets.setdefault(name, rules["match"])} if name else {}  # of a set: its first match point
            to_what = f'its match set "{name}"' if name else "the cloth"
            for axis in off_repeat(rules["match"], {**scaled(repeat), **origin}):
                yield f"piece {piece.name} is not matched to {to_what} along {axis}"
        if "shade" in rules:
            shaded.append((rules["shade"], piece))
    if "shade" in layout:
        for name in long_shades(shaded, whole(layout["shade"])):
            yield f'the pieces of shade "{name}" are too far from each other'
    for one, other, (x0, x1) in overlaps(sound):
        yield f"pieces {one.name} and {other.name} overlap between x = {decimal(x0)} and x = {decimal(x1)}"


def not_a_number(word):
    raise ValueError(f"{word} is not a number")


def read(path):
    with open(path, encoding="utf-8") as text:
        return json.load(text, parse_float=Fraction, parse_constant=not_a_number)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("files", nargs="+", metavar="FILE")
    good = True
    for path in parser.parse_args().files:
        layout = read(path)
        found = list(violations(layout))
        good = good and not found
        for violation in found:
            print(f"{path}: {violation}")
        print(f"{path}: {len(layout['pieces'])} pieces, {len(found)} violations")
    sys.exit(0 if good else 1)


if __name__ == "__main__":
    main()
