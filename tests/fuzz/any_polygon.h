// Polygons out of a fuzzer's bytes.
#pragma once

#include <vector>

#include "core/geometry/polygon.h"
#include "tests/support/random.h"

namespace selvage::test {

// Any closed list of at most `most` points, on a lattice of any size: on a small one, coordinates coincide.
[[nodiscard]] std::vector<Vec> any_vertices(Random& random, std::size_t most, Coord largest_extent);

}  // namespace selvage::test
