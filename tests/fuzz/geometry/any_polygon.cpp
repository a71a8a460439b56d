#include "tests/fuzz/geometry/any_polygon.h"

#include <algorithm>

namespace selvage::test {

std::vector<Vec> any_vertices(Random& random, std::size_t most, Coord largest_extent) {
  const Coord extent = std::min(largest_extent, Coord{1} << random.between(1, 40));
  std::vector<Vec> vertices(random.below(most + 1));
  for (Vec& v : vertices) {
    v = random.point(0, extent);
    // Often next to or equal to another vertex, to produce repeated vertices, straight runs and spikes.
    const Vec other = vertices[random.below(vertices.size())];
    if (random.chance(20)) v.x = other.x;
    if (random.chance(20)) v.y = other.y;
  }
  return vertices;
}

}  // namespace selvage::test
