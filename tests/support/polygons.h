// Polygons to test with: random ones of every kind that pieces come in, and the nasty ones that pieces may
// come in. All are Polygons (clean, counter-clockwise); coordinates lie in about [0, extent].
#pragma once

#include <string>

#include "tests/support/random.h"

namespace selvage::test {

// Any simple polygon: a triangle whose edges are replaced by two, again and again, while it stays simple.  On
// a small extent it has few vertices and many parallel edges.
[[nodiscard]] Polygon random_simple(Random& random, std::size_t vertices, Coord extent);
// Vertices at random distances from the middle, in the order of their angles.
[[nodiscard]] Polygon random_star(Random& random, std::size_t vertices, Coord extent);
[[nodiscard]] Polygon random_convex(Random& random, std::size_t vertices, Coord extent);

// A bar with upright teeth; with `slant`, teeth lean and end in points.
[[nodiscard]] Polygon random_comb(Random& random, std::size_t teeth, Coord extent, bool slant);
// A bar with upright sharp teeth, all alike.
[[nodiscard]] Polygon saw(Coord teeth, Coord pitch, Coord height);
// A band that winds inwards `windings` quarter turns, with slots as wide as itself.
[[nodiscard]] Polygon spiral(std::size_t windings, Coord extent);
// Two arms: sums with pieces that fit between them have holes or slots.
[[nodiscard]] Polygon random_u(Random& random, Coord extent);
// A C that all but closes: a ring with a gap of width `gap`.
[[nodiscard]] Polygon broken_ring(Coord extent, Coord thickness, Coord gap);
// As long as the extent and a few units thick.
[[nodiscard]] Polygon random_needle(Random& random, Coord extent);

// One of the above, at most 40 vertices.
[[nodiscard]] Polygon random_polygon(Random& random, Coord extent);

[[nodiscard]] Polygon scaled(Polygon polygon, Coord factor);
[[nodiscard]] Polygon moved(Polygon polygon, Vec by);
// Such as "{0,0}, {4,0}, {0,3}": to be pasted into a test.
[[nodiscard]] std::string text_of(const Polygon& polygon);

}  // namespace selvage::test
