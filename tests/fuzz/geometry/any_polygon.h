// Polygons made from a fuzzer's bytes.
#pragma once

#include <vector>

#include "core/geometry/polygon.h"
#include "tests/support/random.h"

namespace selvage::test {

// A closed list of at most `most` points on a lattice of any size.  On a small lattice, coordinates often coincide.
[[nodiscard]] std::vector<Vec> any_vertices(Random& random, std::size_t most, Coord largest_extent);

}  // namespace selvage::test
