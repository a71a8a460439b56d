// The edges of a star-shaped part in the order of their directions, and its convex vertices: what the sums of the part
// with any other part need of it, computed once.
#pragma once

#include <cstdint>
#include <vector>

#include "core/outline/star.h"

namespace selvage::minkowski::convolution {

// A direction: its pseudo angle in [0, 4), and the exact vector that decides nearly equal angles.
struct Direction {
  Vec vector;
  double angle{};
};

struct Turns {
  explicit Turns(const Polygon& polygon);

  std::vector<Direction> edge;              // edge i leaves vertex i
  std::vector<char> convex;                 // by vertex: the polygon turns left there
  std::vector<std::uint32_t> by_direction;  // the edges, counter-clockwise from the x axis; ties by number

  // The edge that ends at a vertex.
  [[nodiscard]] std::size_t into(std::size_t vertex) const { return vertex == 0 ? edge.size() - 1 : vertex - 1; }
};

// A part with its turns; both outlive this.
struct TurningPart {
  const outline::StarPart& part;
  const Turns& turns;
};

// For each edge of `of`, the number of edges of `among` whose directions precede its direction counter-clockwise from
// the x axis, parallel ones included when `with_parallel` is true.
[[nodiscard]] std::vector<std::uint32_t> places(const Turns& of, const Turns& among, bool with_parallel);

}  // namespace selvage::minkowski::convolution
