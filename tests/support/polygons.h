// Polygons for tests: random ones of every kind that pieces have in practice, and difficult ones.  All are Polygons
// (clean, counter-clockwise) with coordinates in about [0, extent].
#pragma once

#include <string>

#include "tests/support/random.h"

namespace selvage::test {

// A random simple polygon: starting from a triangle, an edge is repeatedly replaced by two while the polygon stays
// simple.  With a small extent it has few vertices and many parallel edges.
[[nodiscard]] Polygon random_simple(Random& random, std::size_t vertices, Coord extent);
// A star-shaped polygon: vertices at random distances from the centre, ordered by angle.
[[nodiscard]] Polygon random_star(Random& random, std::size_t vertices, Coord extent);
[[nodiscard]] Polygon random_convex(Random& random, std::size_t vertices, Coord extent);

// A bar with upright teeth; with `slant`, the teeth lean and are pointed.
[[nodiscard]] Polygon random_comb(Random& random, std::size_t teeth, Coord extent, bool slant);
// A bar with identical, upright, pointed teeth.
[[nodiscard]] Polygon saw(Coord teeth, Coord pitch, Coord height);
// A band that spirals inwards through `windings` quarter turns, with gaps as wide as the band.
[[nodiscard]] Polygon spiral(std::size_t windings, Coord extent);
// A U shape: its sum with a piece that fits between the arms has holes or slots.
[[nodiscard]] Polygon random_u(Random& random, Coord extent);
// A ring with a gap of width `gap`.
[[nodiscard]] Polygon broken_ring(Coord extent, Coord thickness, Coord gap);
// A needle as long as the extent and a few units thick.
[[nodiscard]] Polygon random_needle(Random& random, Coord extent);

// One of the above, chosen at random, with at most 40 vertices.
[[nodiscard]] Polygon random_polygon(Random& random, Coord extent);

[[nodiscard]] Polygon scaled(Polygon polygon, Coord factor);
// C++ source text such as "{0,0}, {4,0}, {0,3}", which can be pasted into a test.
[[nodiscard]] std::string text_of(const Polygon& polygon);

}  // namespace selvage::test
