// Lists of vertices made from a fuzzer's bytes.
#pragma once

#include <vector>

#include "core/geometry/polygon.h"
#include "tests/support/random.h"

namespace selvage::test {

// The vertices of a closed outline: at most `most` points on a lattice of random size, in which coordinates often
// coincide if it is small.
[[nodiscard]] std::vector<Vec> any_vertices(Random& random, std::size_t most, Coord largest_extent);

}  // namespace selvage::test
